// SPDX-License-Identifier: BSD-3-Clause
// Speed against accuracy: every method on the same views, timed and compared with the reference.
#pragma once

#include "core/base/progress.h"
#include "core/lens/lens_table.h"
#include "core/optics/simulate.h"
#include "study/tradeoff_row.h"

namespace hogelscope {

/// A named combination of the engine's own parameters; it takes the place of what a view says.
struct NamedMethod {
  std::string name;
  Reconstruction reconstruction = Reconstruction::nearest;
  int samplesPerPixel = 1;
  LensMapping mapping = LensMapping::exact;
  Method method{};
};

/// All that are compared, the default ("exact") first.
std::vector<NamedMethod> namedMethods();

View applyMethod(const NamedMethod& method, const View& view);

/// What the error is measured against.
enum class Question {
  displayAsBuilt,  ///< the reference engine: exact lens, full window, nearest, one ray a pixel
  idealPicture     ///< the exact fast engine, which is equal: quadrilinear, 8×8 rays a pixel
};

/// Nearest with one ray asks for the display as built.
Question questionOf(const SamplingParams& sampling);
/// "the display as built" or "the ideal picture", and what that means.
std::string questionText(Question question);
std::string details(Question question);

struct Tradeoff {
  std::vector<TradeoffRow> rows;
  std::size_t timedViews = 0;  ///< of the views; errors are over all of them
  int runs = 0;
};

/// Each picture is made from nothing, lens rays too. Times are medians of the mean over the timed
/// views; runs of all methods are interleaved. Errors do not depend on threads or times. Throws
/// InputError, Cancelled.
Tradeoff measureTradeoff(const std::vector<View>& views, const ParallelRows& parallelRows,
                         const Progress& progress);

/// Sets isPareto: no other row is at most as slow and at most as wrong, and less in one of them.
void markPareto(std::vector<TradeoffRow>& rows);

/// tradeoff.csv.
std::string csv(const std::vector<TradeoffRow>& rows);

}  // namespace hogelscope
