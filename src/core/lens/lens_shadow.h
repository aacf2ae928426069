// SPDX-License-Identifier: BSD-3-Clause
// The distorted points that have no ray because a fold lies between them and the centre.
#pragma once

#include <array>
#include <atomic>

#include "core/base/progress.h"
#include "core/optics/distortion.h"

namespace hogelscope {

/// Learns, from points without a ray, from where on their directions have none. What it says is
/// certain, and does not depend on what it was taught before, or by which threads.
class LensShadow {
 public:
  explicit LensShadow(const Distortion& distortion);

  /// True if a point is known to have no ray.
  [[nodiscard]] bool holds(const Vec2& distorted) const;
  /// Tries to certify the sector of a point without a ray, from there outwards. Throws Cancelled.
  void learn(const Vec2& distorted, const Progress& progress);

 private:
  static constexpr int sectorCount = 4096;

  [[nodiscard]] int sectorOf(const Vec2& distorted) const;

  /// Distances from the centre, in units of the plane z = 1; 0: not yet known.
  struct Sector {
    std::atomic<double> dark{0};    ///< no point from here outwards has a ray
    std::atomic<double> failed{0};  ///< up to here nothing could be certified
  };

  Distortion m_distortion;
  bool m_isRound;  ///< the first sector is all of the plane
  std::array<Sector, sectorCount> m_sectors;
};

}  // namespace hogelscope
