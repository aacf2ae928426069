// SPDX-License-Identifier: BSD-3-Clause
// The error of a light field's own views (sub-aperture images), by which codecs are usually judged,
// beside the error that cameras perceive along the same directions.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/light_field/light_field.h"
#include "core/metrics/panel_error.h"

namespace hogelscope {

/// Returns the mean squared error of each view over all hogels and RGB, in code values: dv rows of
/// du, in the order of PanelError::directions(). Both light fields must be whole in memory. The
/// same for any number of threads. Throws std::invalid_argument where a size differs, Cancelled.
std::vector<double> viewErrors(const LightField& reference, const LightField& test,
                               const ParallelRows& parallelRows, const Progress& progress = {});

/// How far the views' own errors agree with the perceived ones, over the directions that were seen.
struct ViewAgreement {
  double meanPsnr = 0;         ///< mean of the views' finite PSNRs, of all views, dB
  double rankCorrelation = 0;  ///< Spearman's, of the two errors of each direction
  int seen = 0;                ///< directions
  /// For each direction the rank of the perceived error less that of the view's own, over the
  /// number of ranks: −1 … 1, NaN where the direction was not seen.
  std::vector<double> rankDifferences;
  /// The view (u, v) whose error is perceived the most beyond its own rank.
  std::array<int, 2> underrated{};
};

/// Throws std::invalid_argument where the sizes differ.
ViewAgreement agreementOf(const std::vector<double>& viewErrors, const PanelError& perceived);

/// One or two sentences.
std::string agreementText(const ViewAgreement& agreement);

}  // namespace hogelscope
