// SPDX-License-Identifier: BSD-3-Clause
// What is known of the directions of distorted points: where their rays end at a fold.
#pragma once

#include <array>
#include <atomic>
#include <limits>

#include "core/base/progress.h"
#include "core/lens/lens_sector.h"
#include "core/optics/distortion.h"

namespace hogelscope {

/// Knows of each of many sectors what certifySector() says, from when it is first asked, and
/// learns, from points without a ray, from where on their directions have none. What it says is
/// certain, and does not depend on what it was taught before, or by which threads.
class LensShadow {
 public:
  explicit LensShadow(const Distortion& distortion);

  /// Returns what is known of the sector of a point, which has to be finite.
  [[nodiscard]] LensSector sector(const Vec2& distorted) const;
  /// True if a point is known to have no ray.
  [[nodiscard]] bool holds(const Vec2& distorted) const;
  /// Tries to certify the sector of a point without a ray, from there outwards. Throws Cancelled.
  void learn(const Vec2& distorted, const Progress& progress);

 private:
  static constexpr int sectorCount = 4096;
  static constexpr int partCount = 8 * sectorCount;

  /// One of `count` equal shares of a turn, or all of it.
  struct Share {
    std::size_t index = 0;
    double middle = 0;     ///< angles
    double halfWidth = 0;  ///< 0: the lens is the same in all directions
  };
  [[nodiscard]] Share shareOf(const Vec2& distorted, int count) const;

  /// What was learnt of a share: distances from the centre, in units of the plane z = 1.
  struct Shade {
    std::atomic<double> dark{std::numeric_limits<double>::infinity()};
    std::atomic<double> failed{0};  ///< up to here nothing could be learnt
  };
  /// Returns whether a share is dark from the distance on.
  bool learn(Shade& shade, const Share& share, double distance, const Progress& progress);

  struct Sector {
    std::atomic<bool> isKnown{false};
    std::atomic<double> ideal{0};  ///< this and the next are LensSector's
    std::atomic<double> distorted{0};
    Shade shade;
  };

  [[nodiscard]] const Sector& certifiedSector(const Vec2& distorted) const;

  Distortion m_distortion;
  bool m_isRound;  ///< the first sector is all of the plane
  mutable std::array<Sector, sectorCount> m_sectors;
  std::array<Shade, partCount> m_parts;  ///< of sectors of which nothing could be learnt as a whole
};

}  // namespace hogelscope
