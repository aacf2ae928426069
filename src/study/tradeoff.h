// SPDX-License-Identifier: BSD-3-Clause
// Speed against accuracy: every method on the same views, timed and compared with the reference.
#pragma once

#include "core/base/progress.h"
#include "core/lens/lens_table.h"
#include "core/optics/simulate.h"
#include "study/time_budget.h"
#include "study/tradeoff_row.h"

namespace hogelscope {

/// A named combination of the engine's parameters, which replaces that of a view.
struct NamedMethod {
  std::string name;
  Reconstruction reconstruction = Reconstruction::nearest;
  int samplesPerPixel = 1;
  LensMapping mapping = LensMapping::exact;
  Method method{};
};

/// Returns all compared methods, the default ("exact") first.
std::vector<NamedMethod> namedMethods();

/// Returns the methods that are relevant to the views: if no view has a lens, none that differs
/// from another in the lens only.
std::vector<NamedMethod> methodsFor(const std::vector<RenderJob>& views);

RenderJob applyMethod(const NamedMethod& method, const RenderJob& job);

/// The reference of the error.
enum class Question {
  displayAsBuilt,  ///< the reference engine: exact lens, full window, nearest, one ray per pixel
  idealPicture     ///< the exact fast engine, which is equal: quadrilinear, 8×8 rays per pixel
};

/// Returns displayAsBuilt for nearest with one ray, else idealPicture.
Question questionOf(const SamplingParams& sampling);
/// Returns "the display as built" or "the ideal image"; the next function explains it.
std::string questionText(Question question);
std::string details(Question question);

struct Budget {
  double seconds = 60;  ///< of wall time
  Clock clock = steadySeconds;
};

struct Tradeoff {
  std::vector<TradeoffRow> rows;
  std::size_t timedViews = 0;
  std::size_t errorViews = 0;  ///< the number of views for errors
};

/// Measures all methods. Renders each image from scratch, lens rays included. A trial on few pixels
/// gives the cost of each method. Errors take up to 0.4 of the budget, over all pixels of all views
/// or as many as fit; the rows contain their number. The rest goes to interleaved runs, until each
/// method's median is known to two per cent. Slow methods are timed once, on the pixels of their
/// error. All rows have a time and an error with any budget. Errors over all pixels do not depend
/// on threads or times. Throws InputError, Cancelled.
Tradeoff measureTradeoff(const std::vector<RenderJob>& views, const Budget& budget,
                         const ParallelRows& parallelRows, const Progress& progress);

/// Sets isPareto: no other row is at most as slow and at most as inaccurate, and better in one of
/// them.
void markPareto(std::vector<TradeoffRow>& rows);

/// Returns tradeoff.csv.
std::string csv(const std::vector<TradeoffRow>& rows);

}  // namespace hogelscope
