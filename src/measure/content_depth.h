// SPDX-License-Identifier: BSD-3-Clause
// The depth of what each pixel of a state's view shows, and how much of it fits the display.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/engine/renderer.h"
#include "core/panel/depth_budget.h"
#include "measure/disparity.h"

namespace hogelscope {

/// The depths of a view's pixels, row by row.
struct PixelDepths {
  std::vector<double> z;           ///< display frame, metres; NaN if it is not known
  std::vector<std::uint8_t> seen;  ///< 1 where the pixel sees the display, else 0
};

/// Returns the depth of the first content that the eye's ray through each pixel's middle meets,
/// lens included; NaN where it meets none, or where views do not tell. For stored views it is the
/// depth at the pixel's hogel, in the direction from which the eye sees the panel's centre. Throws
/// InputError as Renderer::render() and depthsByDisparity(), Cancelled.
PixelDepths depthsOf(const RenderJob& job, LensTables& tables, const Progress& progress);

/// The figures of a state's content. Shares are of the pixels whose depth is known.
struct DepthFigures {
  std::string state;
  DepthLimits limits;
  std::vector<double> dioptres;      ///< of those pixels, ascending; all figures are 0 if empty
  std::array<double, 2> interval{};  ///< the shortest that holds DepthParams::share, dioptres
  double known = 0;                  ///< the share of the pixels that see the display
  double insideDisplay = 0;          ///< share within the display's limit
  double inside = 0;                 ///< share within both limits
  double ghosts = 0;  ///< share that shifts by more than 2 hogels from one view to the next
};

/// Returns the figures of a view. Content at the eye or behind it is left out.
DepthFigures depthFigures(const std::string& state, const PixelDepths& depths,
                          const DepthLimits& limits, double share);

/// Returns the largest |dioptres| of the content.
double farthestOf(const DepthFigures& figures);

/// Returns an end of depthBars() that shows a state's content, before and after (or null), and the
/// display's limit, unless that is farther than what is infinitely far behind the panel.
double barsEnd(const DepthFigures& now, const DepthFigures* proposed);

/// 160 bars over dioptres, from the first one's `low` on, with their shares of the pixels.
struct DepthBars {
  double low = 0;
  double width = 0;
  std::vector<double> shares;

  [[nodiscard]] double middle(std::size_t bar) const { return low + (double(bar) + 0.5) * width; }
};

/// Returns bars over −end … end; what is beyond is in the outer ones.
DepthBars depthBars(const DepthFigures& figures, double end);

}  // namespace hogelscope
