// SPDX-License-Identifier: BSD-3-Clause
// Speed against accuracy: every method on the same views, timed and compared with the reference.
#pragma once

#include "core/base/progress.h"
#include "core/lens/lens_table.h"
#include "core/optics/simulate.h"
#include "study/time_budget.h"
#include "study/tradeoff_row.h"

namespace hogelscope {

/// A named combination of the engine's own parameters, which replaces that of a view.
struct NamedMethod {
  std::string name;
  Reconstruction reconstruction = Reconstruction::nearest;
  int samplesPerPixel = 1;
  LensMapping mapping = LensMapping::exact;
  Method method{};
};

/// Returns all methods that are compared, the default ("exact") first.
std::vector<NamedMethod> namedMethods();

/// Returns those that say something of the views: without a lens in any of them, none that differs
/// from another in the lens alone.
std::vector<NamedMethod> methodsFor(const std::vector<RenderJob>& views);

RenderJob applyMethod(const NamedMethod& method, const RenderJob& job);

/// The reference that the error is measured against.
enum class Question {
  displayAsBuilt,  ///< the reference engine: exact lens, full window, nearest, one ray a pixel
  idealPicture     ///< the exact fast engine, which is equal: quadrilinear, 8×8 rays a pixel
};

/// Returns displayAsBuilt for nearest with one ray, else idealPicture.
Question questionOf(const SamplingParams& sampling);
/// Return "the display as built" or "the ideal image", and an explanation.
std::string questionText(Question question);
std::string details(Question question);

struct Budget {
  double seconds = 60;  ///< of wall time
  Clock clock = steadySeconds;
};

struct Tradeoff {
  std::vector<TradeoffRow> rows;
  std::size_t timedViews = 0;
  std::size_t errorViews = 0;  ///< that errors are over
};

/// Renders each image from scratch, lens rays included. A look at few pixels says what each method
/// costs. Errors take up to 0.4 of the budget: over all pixels of all views, or as many as fit;
/// the rows of the result say how many. The rest goes to interleaved runs, until each
/// method's median is known to two per cent. Slow methods are timed once, on the pixels of their
/// error. All rows have a time and an error however small the budget. Errors over all pixels do
/// not depend on threads or times. Throws InputError, Cancelled.
Tradeoff measureTradeoff(const std::vector<RenderJob>& views, const Budget& budget,
                         const ParallelRows& parallelRows, const Progress& progress);

/// Sets isPareto: no other row is at most as slow and at most as wrong, and less in one of them.
void markPareto(std::vector<TradeoffRow>& rows);

/// Returns tradeoff.csv.
std::string csv(const std::vector<TradeoffRow>& rows);

}  // namespace hogelscope
