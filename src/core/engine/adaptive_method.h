// SPDX-License-Identifier: BSD-3-Clause
// sampling.tolerance: the cheapest way to a picture whose error is small enough, found by a probe
// of the picture's own pixels.
#pragma once

#include "core/base/progress.h"
#include "core/engine/fast_simulation.h"

namespace hogelscope {

/// What is rendered in the place of a view, and what the probe measured. Errors are RMS over pixels
/// and channels of 8-bit pictures, in code values.
struct Choice {
  View view;         ///< its method and sampling may take less than the one asked for
  double rmse = 0;   ///< over the probe
  double limit = 0;  ///< the error over the whole picture is not above, with 99 % confidence
  int pixels = 0;    ///< of the probe; 0 where there was none
};

/// The view itself where its tolerance is 0, it has a method already, nothing is cheaper, or the
/// probe sees too little of the panel. The tolerance of the result is 0. Deterministic: the probe's
/// pixels depend on the image's size alone. Throws Cancelled.
Choice chooseMethod(const View& view, LensTables& tables, const ParallelRows& parallelRows,
                    const Progress& progress = {});

/// One line for --explain and the window.
std::string choiceText(const Choice& choice);

}  // namespace hogelscope
