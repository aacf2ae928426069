// SPDX-License-Identifier: BSD-3-Clause
// Computes how far a twin moves what an eye sees, from geometry alone: the pixels that rays meet.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/lens/lens_table.h"
#include "core/optics/simulate.h"

namespace hogelscope {

/// Moves of (u, v) in directional pixels, or of a lens sheet's (i, j) in the panel's pixels, over
/// the middle rays of a view that see both the design and the twin; NaN if there are none.
struct RayMoves {
  double rms = 0;   ///< root of the mean of Δu² + Δv²
  double rest = 0;  ///< the same after the means of Δu and Δv are subtracted
};

/// Returns the moves of green light from the design to `job.twin`, which is not null, as the eye
/// (not its pupil) sees it. Throws InputError as Simulation does, and Cancelled.
RayMoves movesOf(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
                 const Progress& progress = {});

}  // namespace hogelscope
