// SPDX-License-Identifier: BSD-3-Clause
// The results of --optimise as a table and as a page.
#pragma once

#include <string>

#include "optimise/optimise_run.h"

namespace hogelscope {

/// Returns F.csv: a row for each view and reference, with PSNR and SSIM over the seen pixels
/// before, prefiltered and after; then the means over the states and over the held-out eyes, which
/// also have the solver's figures: iterations, the decibels that the best content could at most
/// have more, and the shares of values at 0 and at full scale.
std::string csv(const Optimised& result, const OptimisedContent& content);

/// Returns F.html.
std::string optimisePage(const OptimiseRequest& request, const Optimised& result,
                         const OptimisedContent& content);

/// Returns the means in a line or two, for a terminal: "states, against the display without
/// leakage: 29.41 dB before, 42.38 dB after".
std::string meansText(const Optimised& result);

/// Returns the decibels by which the error of the best content could at most be less.
double openDecibels(const OptimiseFigures& figures);

}  // namespace hogelscope
