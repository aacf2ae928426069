// SPDX-License-Identifier: BSD-3-Clause
// The branch of a lens' inverse that grows from the centre, followed with a certificate
// (docs/formulas.md, Distortion).
// Each step along the segment from the image centre to the pixel is as long as the
// Newton–Kantorovich theorem certifies, in a norm that knows which way the lens folds. A fold ahead
// is proved, not approached: there is no ray.
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
/// line, or, if this is the last one, before Branch::reached. From `ideal` plain Newton finds the
/// preimages of their points from this line to there.
struct BranchLine {
  Vec2 normal;          ///< of length 1
  double distance = 0;  ///< from the centre
  Vec2 ideal;
};

/// Returns the last line before a point of the segments; none if there is none.
const BranchLine* lineBefore(const Vec2& distorted, const std::vector<BranchLine>& lines);

struct Branch {
  enum class Kind {
    ray,     ///< every point of the disc has a ray
    none,    ///< no point of the disc has one
    unclear  ///< some may have one; of a single point: so near a fold that rounding decides
  } kind = Kind::unclear;
  Vec2 ideal;          ///< of the disc's centre; plain Newton from it finds the ray of each point
  double reached = 0;  ///< before here, along the last line's normal, no segment meets a fold
  double end = 1;  ///< the part of the segments to the disc's points before which all meet a fold
};

/// Follows the preimages of the segments from the centre of the image to all points of a disc, from
/// `start` on if that is a line across them. Adds the lines on the way to `lines`. `progress` is
/// asked before each step, which takes less than a microsecond. Throws Cancelled.
Branch followBranch(const Distortion& lens, const Disc& disc, const Progress& progress,
                    const BranchLine& start = {}, std::vector<BranchLine>* lines = nullptr);

}  // namespace hogelscope
