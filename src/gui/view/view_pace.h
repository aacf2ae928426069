// SPDX-License-Identifier: BSD-3-Clause
// How large the first image of an edit may be, so that the view follows a moving slider: judged
// by what the latest images took.
#pragma once

#include <algorithm>

namespace hogelscope {

class ViewPace {
 public:
  static constexpr double quick = 30;  ///< milliseconds within which a full image comes at once

  /// 1, 2 or 4: Method::scale.
  [[nodiscard]] int firstScale() const { return m_full <= quick ? 1 : m_full <= 4 * quick ? 2 : 4; }

  /// A smaller image tells only where the full one has become slower.
  void rendered(int scale, double milliseconds) {
    m_full = scale == 1 ? milliseconds : std::max(m_full, milliseconds * scale * scale);
  }
  /// It would have taken longer.
  void stopped(double milliseconds) { m_full = std::max(m_full, milliseconds); }

 private:
  double m_full = 0;  ///< milliseconds that a full image takes
};

}  // namespace hogelscope
