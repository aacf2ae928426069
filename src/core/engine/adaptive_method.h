// SPDX-License-Identifier: BSD-3-Clause
// Resolves sampling.tolerance: a probe of the image's own pixels finds the cheapest method whose
// error is small enough. The pixels are runs of eight, the independent samples of its 99 % limit.
#pragma once

#include "core/base/progress.h"
#include "core/engine/fast_simulation.h"

namespace hogelscope {

/// The view that is rendered instead of another one, and the results of the probe. Errors are RMS
/// over pixels and channels of 8-bit images, in code values.
struct Choice {
  RenderJob job;     ///< its method and sampling may be cheaper than the original's
  double rmse = 0;   ///< over the probe
  double limit = 0;  ///< upper limit of the whole image's error, with 99 % confidence
  int pixels = 0;    ///< pixels of the probe; 0 without a probe
};

/// Returns the cheapest view within the tolerance, or the view itself if its tolerance is 0, it has
/// a method already, nothing is cheaper, or the probe sees too little of the panel. The tolerance
/// of the result is 0. The choice is deterministic: the probe's pixels depend on the image's size
/// alone. Throws Cancelled.
Choice chooseMethod(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
                    const Progress& progress = {});

/// Describes a choice in one line, for --explain and the window.
std::string choiceText(const Choice& choice);

}  // namespace hogelscope
