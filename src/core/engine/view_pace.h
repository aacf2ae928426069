// SPDX-License-Identifier: BSD-3-Clause
// Chooses how coarse the first image after an edit is.
#pragma once

#include <algorithm>

namespace hogelscope {

/// Chooses the size of the first image after an edit from the times of the latest images, so that
/// the view follows a dragged value.
class ViewPace {
 public:
  static constexpr double quick = 30;  ///< milliseconds of a full image that is shown directly

  /// Returns the Method::scale of the first image: 1, 2 or 4.
  [[nodiscard]] int firstScale() const { return m_full <= quick ? 1 : m_full <= 4 * quick ? 2 : 4; }

  /// Updates the estimate. A smaller image can only raise it.
  void rendered(int scale, double milliseconds) {
    m_full = scale == 1 ? milliseconds : std::max(m_full, milliseconds * scale * scale);
  }
  /// Raises the estimate after a rendering that was stopped early.
  void stopped(double milliseconds) { m_full = std::max(m_full, milliseconds); }

 private:
  double m_full = 0;  ///< estimated milliseconds of a full image
};

}  // namespace hogelscope
