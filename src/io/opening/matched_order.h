// SPDX-License-Identifier: BSD-3-Clause
// Finds the order of views by those of another light field: the views of a codec's test are those
// of the reference, but the frames of its video may run to and fro, or from the bottom. Small grey
// pictures of a few views tell; a test that stands right is never changed.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/light_field/light_field.h"
#include "core/panel/display.h"

namespace hogelscope {

/// A picture in grey of at most 256 px a side, code values.
struct SmallPicture {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

/// The views of a folder or of a video, whose pictures are read when they are needed, each once.
class SmallViews {
 public:
  /// Finds the views. Throws InputError as openLightField().
  SmallViews(const LightFieldParams& params, const DisplayParams& display);

  [[nodiscard]] int columns() const { return m_columns; }
  [[nodiscard]] int rows() const { return m_rows; }
  /// Returns the picture, a number among those of the light field, that is the view (u, v) in the
  /// order of `params`, of any scan; none if it is missing.
  [[nodiscard]] std::optional<std::size_t> pictureOf(const LightFieldParams& params, int u,
                                                     int v) const;
  /// Reads pictures in ascending order, because each frame of a video needs those before it. Throws
  /// InputError, Cancelled.
  void read(const std::set<std::size_t>& pictures, const Progress& progress);
  /// Returns a picture that was read.
  [[nodiscard]] const SmallPicture& at(std::size_t picture) const { return m_read.at(picture); }

 private:
  LightFieldParams m_params;
  int m_columns = 0;
  int m_rows = 0;
  std::map<ViewScan, std::vector<std::size_t>> m_cells;  ///< the pictures of the grid, row by row
  std::vector<std::string> m_files;  ///< of a folder, by the pictures' numbers; "": missing
  std::map<std::size_t, SmallPicture> m_read;
};

/// The reference, whose pictures are read once for all tests.
class OrderMatcher {
 public:
  OrderMatcher(const LightFieldParams& params, const DisplayParams& display)
      : m_params(params), m_display(display) {}

  /// Returns the test's parameters with the order (`scan`, `rows`, `columns`) in which its views
  /// are those of the reference far better than in its own; none if there is no such order, or if
  /// the two are not views of one grid and size. Throws InputError, Cancelled.
  std::optional<LightFieldParams> match(const LightFieldParams& test, const DisplayParams& display,
                                        const Progress& progress);

 private:
  LightFieldParams m_params;
  DisplayParams m_display;
  std::optional<SmallViews> m_views;
};

/// Returns what differs in the order of two light fields, such as "lightField.scan=serpentine".
std::string orderText(const LightFieldParams& from, const LightFieldParams& to);

}  // namespace hogelscope
