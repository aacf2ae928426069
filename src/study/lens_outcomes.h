// SPDX-License-Identifier: BSD-3-Clause
// Methods of inverting a lens (OpenCV's, the textbook's and this program's), and their outcomes at
// points.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/lens/lens_rays.h"

namespace hogelscope {

struct InverseMethod {
  std::string name;
  bool saysNoRay;  ///< whether NaN means "no ray"; otherwise NaN means divergence
  /// Inverts a lens. Throws Cancelled.
  std::function<std::vector<Vec2>(const Distortion& lens, const std::vector<Vec2>& distorted,
                                  const Progress& progress)>
      undistort;
};

/// Returns the methods: cv::undistortPoints, a fixed-point iteration, with 5 (its default), 20 and
/// 200 iterations; 20 Newton steps from the distorted point; Distortion ("ours").
const std::vector<InverseMethod>& inverseMethods();

/// The outcome at a point, in ascending order of harm. A root is an ideal point whose distorted
/// point is within a thousandth of a pixel of the requested one.
enum class Outcome : std::uint8_t {
  right,     ///< the root on the branch from the centre, within a pixel
  noRay,     ///< there is no ray, and the method reports that
  inexact,   ///< not a root, but nearer to one than the start
  diverged,  ///< not a root and no nearer, NaN, or "no ray" where there is one
  wrongRoot  ///< another root, or a root without a ray, without any warning
};

constexpr std::size_t outcomeCount = 5;
/// Returns the names in CSV files: right, no_ray, inexact, diverged, wrong_root.
const std::array<std::string, outcomeCount>& outcomeNames();

struct LensOutcomes {
  std::array<std::size_t, outcomeCount> count{};
  std::vector<Outcome> each;  ///< of all points, row by row
  double worstResidual = 0;   ///< px, over all returned points; infinite for NaN
  [[nodiscard]] std::size_t operator[](Outcome o) const { return count[std::size_t(o)]; }
  [[nodiscard]] std::size_t points() const;
  /// Returns the most harmful outcome that occurs.
  [[nodiscard]] Outcome worst() const;
};

/// The test points of a lens: the points of the plane z = 1 under a regular grid of its camera's
/// pixels, corners included, and each point's right root by the certified inverse.
class LensTrial {
 public:
  /// Calls `progress` before each point, here and in outcomes(). Throws Cancelled.
  LensTrial(const LensKey& lens, int columns, int rows, Progress progress = {});

  [[nodiscard]] LensOutcomes outcomes(const InverseMethod& method) const;

 private:
  [[nodiscard]] Outcome outcome(std::size_t at, const Vec2& ideal, bool saysNoRay) const;
  [[nodiscard]] double pixels(const Vec2& from, const Vec2& to) const;

  LensKey m_lens;
  Progress m_progress;
  std::vector<Vec2> m_distorted;
  std::vector<std::optional<Vec2>> m_right;
};

}  // namespace hogelscope
