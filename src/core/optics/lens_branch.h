// SPDX-License-Identifier: BSD-3-Clause
// The branch of a lens' inverse that grows from the centre, followed with a certificate
// (docs/formulas.md, Distortion).
#pragma once

#include "core/base/progress.h"
#include "core/optics/distortion.h"

namespace hogelscope {

/// The distorted points within `radius` of `centre`.
struct Disc {
  Vec2 centre;
  double radius = 0;
};

/// What is known of the segments to a disc: up to a line across them none meets a fold, and from
/// this ideal point plain Newton finds the preimages of their points on the line.
struct BranchStart {
  Vec2 normal;          ///< of the line, of length 1
  double distance = 0;  ///< of the line from the centre; 0: nothing is known
  Vec2 ideal;
};

struct Branch {
  enum class Kind {
    ray,     ///< every point of the disc has a ray
    none,    ///< no point of the disc has one
    unclear  ///< some may have one; of a single point: so near a fold that rounding decides
  } kind = Kind::unclear;
  Vec2 ideal;         ///< of the disc's centre; plain Newton from it finds the ray of each point
  BranchStart known;  ///< of the disc, and so of each disc within it
  double end = 1;  ///< the part of the segments to the disc's points before which all meet a fold
};

/// Follows the preimages of the segments from the centre of the image to all points of a disc.
/// `progress` is asked before each step, which takes less than a microsecond. Throws Cancelled.
Branch followBranch(const Distortion& lens, const Disc& disc, const Progress& progress,
                    const BranchStart& start = {});

}  // namespace hogelscope
