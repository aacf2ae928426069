// SPDX-License-Identifier: BSD-3-Clause
// The branch of a lens' inverse that grows from the centre, followed with a certificate
// (docs/formulas.md, Distortion). Each step along the segment from the image centre to the pixel is
// as long as the Newton–Kantorovich theorem certifies, in a norm that depends on the direction in
// which the lens folds. A fold ahead is proved, not approached; there is then no ray.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/optics/distortion.h"

namespace hogelscope {

/// The distorted points within `radius` of `centre`.
struct Disc {
  Vec2 centre;
  double radius = 0;
};

/// A line across the segments to the points of a disc, none of which meets a fold before the next
/// line, or, if this is the last one, before Branch::reached. Plain Newton steps from `ideal` find
/// the preimages of the segments' points between this line and that place.
struct BranchLine {
  Vec2 normal;          ///< has length 1
  double distance = 0;  ///< from the centre
  Vec2 ideal;
};

/// Returns the last line before a point of the segments; null if there is none.
const BranchLine* lineBefore(const Vec2& distorted, const std::vector<BranchLine>& lines);

struct Branch {
  enum class Kind {
    ray,     ///< every point of the disc has a ray
    none,    ///< no point of the disc has one
    unclear  ///< some may have one; a single point is so near a fold that rounding decides
  } kind = Kind::unclear;
  Vec2 ideal;  ///< that of the disc's centre; plain Newton from it finds the ray of each point
  double reached = 0;  ///< along the last line's normal: no segment meets a fold before it
  double end = 1;  ///< the part of the segments to the disc's points before which all meet a fold
};

/// Follows the preimages of the segments from the centre of the image to all points of a disc, from
/// `start` on if that is a line across them. Adds the lines on the way to `lines`. `progress` is
/// called before each step, which takes less than a microsecond. Throws Cancelled.
Branch followBranch(const Distortion& lens, const Disc& disc, const Progress& progress,
                    const BranchLine& start = {}, std::vector<BranchLine>* lines = nullptr);

}  // namespace hogelscope
