// SPDX-License-Identifier: BSD-3-Clause
// Speed against accuracy: every method on the same views, timed and compared with the reference.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/lens/lens_table.h"
#include "core/optics/simulate.h"
#include "study/time_budget.h"

namespace hogelscope {

/// A named combination of the engine's parameters, which replaces that of a view.
struct NamedMethod {
  std::string name;
  Reconstruction reconstruction = Reconstruction::nearest;
  int samplesPerPixel = 1;
  LensMapping mapping = LensMapping::exact;
  Method method{};
  std::optional<int> pupilSamples = {};  ///< in place of the state's; 0: a pinhole
};

/// Returns all compared methods, the default ("exact") first.
std::vector<NamedMethod> namedMethods();

/// Returns the numbers and patterns of a pupil's samples that are compared, the pinhole first.
std::vector<NamedMethod> pupilMethods();

/// Whether one of the views is through a distorted lens.
bool haveLens(const std::vector<RenderJob>& views);
/// Whether one of the views is through a pupil that is not a pinhole.
bool havePupil(const std::vector<RenderJob>& views);

/// Returns the methods that are relevant to the views: if no view has a lens, none that differs
/// from another in the lens only, and if one has a pupil, pupilMethods() too.
std::vector<NamedMethod> methodsFor(const std::vector<RenderJob>& views);

RenderJob applyMethod(const NamedMethod& method, const RenderJob& job);

/// The reference of the error; with a pupil by the fast engine and the most samples.
enum class Question {
  displayAsBuilt,  ///< the reference engine: exact lens, full window, nearest, one ray per pixel
  idealPicture     ///< the exact fast engine, which is equal: quadrilinear, 8×8 rays per pixel
};

/// Returns displayAsBuilt for nearest with one ray, else idealPicture.
Question questionOf(const SamplingParams& sampling);
/// Changes the views' sampling, so that errors are measured for `question`.
void ask(Question question, std::vector<RenderJob>& views);
/// Returns "the exact pixels" or "the smooth ideal"; the next function explains it.
std::string questionText(Question question);
std::string details(Question question);

/// The time and error of a method: a row of tradeoff.csv, a point of the chart.
struct TradeoffRow {
  std::string method;          ///< short and unique
  std::string lens;            ///< such as "exact", "direct", "fixed point 5", "table 8 px"
  std::string reconstruction;  ///< "nearest", "bilinear" or "quadrilinear"
  std::string psf;             ///< "full", "truncated" or "off"
  int samples = 1;             ///< per pixel, along each side
  int scale = 1;               ///< 2: half resolution, scaled up
  std::string precision;       ///< "double" or "float"
  double milliseconds = 0;     ///< per image, median of the runs
  double fastest = 0;          ///< milliseconds of the fastest run
  double upperQuartile = 0;    ///< upper quartile, milliseconds
  double lowerQuartile = 0;    ///< lower quartile, milliseconds
  int runs = 0;
  double timedPixels = 0;  ///< pixels rendered by a run, over the timed states
  double mraysPerSecond = 0;
  double rmse = 0;     ///< code values of 8-bit images, over all states, pixels and channels
  double psnr = 0;     ///< dB; infinite if rmse is 0
  double psnrLow = 0;  ///< its 95 % interval, which is the PSNR itself over all pixels
  double psnrHigh = 0;
  double maxError = 0;      ///< code values
  double seenMismatch = 0;  ///< share of the pixels that are seen in only one of the images
  double errorPixels = 0;   ///< pixels compared, over the states
  bool isSampled = false;   ///< its time or its error was measured on part of the pixels
  bool isPareto = false;    ///< no other row is as fast and as accurate, and better in one of them
  bool isOfPupil = false;   ///< it has its own samples of the pupil
  bool isDefault = false;   ///< the program's default
};

/// Sets the times from `runs` (at least one) in milliseconds per image.
void setTimes(TradeoffRow& row, std::vector<double> runs);

/// Returns the half width of the median's 95 % interval relative to the median: 1.57 times the
/// interquartile range over the root of the number of runs (McGill, Tukey and Larsen 1978). NaN for
/// one run.
double spreadOf(const TradeoffRow& row);

/// Returns the least and the largest RMSE that the row's PSNRs allow, code values.
std::pair<double, double> errorRangeOf(const TradeoffRow& row);

struct Budget {
  double seconds = 60;  ///< of wall time
  Clock clock = steadySeconds;
  std::uint64_t seed = 1;  ///< of the pixels whose errors are measured
};

struct Tradeoff {
  std::vector<TradeoffRow> rows;
  std::vector<TradeoffRow> otherRows;  ///< the same times with the other question's errors
  std::size_t timedViews = 0;
  std::size_t errorViews = 0;  ///< the number of views for errors
};

/// Measures all methods. Renders each image from scratch, lens rays included. A trial on few pixels
/// gives the cost of each method. Errors take up to 0.4 of the budget, the reference's cost
/// included, on blocks of pixels of all views or as many as fit (see sampled_errors.h): until each
/// method's 95 % interval is below 0.3 dB, or over all pixels; the rows contain their number. The
/// rest goes to interleaved runs, until each method's median is known to two per cent. Slow methods
/// are timed once, on part of their pixels if necessary. All rows have a time and an error with any
/// budget. Errors over all pixels do not depend on threads or times. `hasBoth`: the errors for the
/// other question are measured too, in the same pictures. Throws InputError, Cancelled.
Tradeoff measureTradeoff(const std::vector<RenderJob>& views, const Budget& budget,
                         const ParallelRows& parallelRows, const Progress& progress,
                         bool hasBoth = false);

/// Sets isPareto: no other row is at most as slow and at most as inaccurate, and better in one of
/// them.
void markPareto(std::vector<TradeoffRow>& rows);

/// Returns tradeoff.csv.
std::string csv(const std::vector<TradeoffRow>& rows);

}  // namespace hogelscope
