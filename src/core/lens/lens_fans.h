// SPDX-License-Identifier: BSD-3-Clause
// The certified parts of the directions of distorted points: where their rays are, and where these
// end at a fold.
#pragma once

#include <array>
#include <atomic>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include "core/base/progress.h"
#include "core/lens/lens_sector.h"
#include "core/optics/distortion.h"
#include "core/optics/lens_branch.h"

namespace hogelscope {

/// Divides the distorted points into narrow sectors around the centre, and these into parts where
/// that is needed. Each is certified when it is first asked for, from its directions alone: the
/// result does not depend on earlier requests or on the threads.
class LensFans {
 public:
  explicit LensFans(const Distortion& distortion);

  /// Returns the result of certifySector() for the sector of a point, which must be finite.
  [[nodiscard]] const LensSector& sector(const Vec2& distorted) const;

  struct Place {
    enum class Kind {
      ray,     ///< plain Newton finds it from the line's ideal point
      none,    ///< the point has no ray
      unclear  ///< the point is near a fold; its segment is certain as far as the line
    } kind;
    BranchLine line;
  };
  /// Finds a point among the segments that are followed together: those of its sector, of a part
  /// of it, and so on. Throws Cancelled.
  [[nodiscard]] Place find(const Vec2& distorted, const Progress& progress) const;

 private:
  static constexpr int sectorCount = 4096;
  static constexpr int fanCount = 256;
  static constexpr int partCount = 4;  ///< parts of a fan
  static constexpr int mostParts = 65536;

  struct Sector {
    std::once_flag isCertified;
    LensSector certain;
  };
  /// The segments of a range of directions, as far as they can be followed together. Distances
  /// from the centre, in units of the plane z = 1.
  struct Fan {
    std::atomic<bool> isFollowed = false;
    std::mutex following;
    std::vector<BranchLine> lines;
    double reached = 0;
    double dark = std::numeric_limits<double>::infinity();  ///< from here on no point has a ray
    std::unique_ptr<std::array<Fan, partCount>> parts;      ///< some of them get farther
  };

  void follow(Fan& fan, const Disc& disc, const BranchLine& start, bool hasParts,
              const Progress& progress) const;

  Distortion m_distortion;
  bool
      m_isRound;  ///< the lens is the same in all directions, and the first sector all of the plane
  mutable std::array<Sector, sectorCount> m_sectors;
  mutable std::array<Fan, fanCount> m_fans;
};

}  // namespace hogelscope
