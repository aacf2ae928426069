// SPDX-License-Identifier: BSD-3-Clause
// The error of a light field's own views (sub-aperture images), by which codecs are usually
// evaluated, compared with the error that cameras perceive along the same directions.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/parallel.h"
#include "core/light_field/light_field.h"
#include "core/metrics/panel_error.h"

namespace hogelscope {

/// Returns the mean squared error of each view over all hogels and RGB, in code values: dv rows of
/// du, in the order of PanelError::directions(). Both light fields must be completely in memory.
/// The result is the same for any number of threads. Throws std::invalid_argument if sizes differ,
/// and Cancelled.
std::vector<double> viewErrors(const LightField& reference, const LightField& test,
                               const ParallelRows& parallelRows, const Progress& progress = {});

/// The agreement of the views' own errors with the perceived ones, over the seen directions.
struct ViewAgreement {
  double meanPsnr = 0;         ///< mean of the finite PSNRs of all views, in dB
  double rankCorrelation = 0;  ///< Spearman's ρ of the two errors of each direction
  int seen = 0;                ///< the number of seen directions
  /// The rank of the perceived error minus that of the view's own for each direction, divided by
  /// the number of ranks: −1 … 1, NaN if the direction was not seen.
  std::vector<double> rankDifferences;
  /// The view (u, v) whose perceived error exceeds its own rank the most.
  std::array<int, 2> underrated{};
};

/// Computes the agreement. Throws std::invalid_argument if the sizes differ.
ViewAgreement agreementOf(const std::vector<double>& viewErrors, const PanelError& perceived);

/// Returns one or two sentences.
std::string agreementText(const ViewAgreement& agreement);

}  // namespace hogelscope
