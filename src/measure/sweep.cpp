// SPDX-License-Identifier: BSD-3-Clause
#include "measure/sweep.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "core/base/bisect.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/metrics/metric.h"
#include "core/optics/eyes.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/files/content_hash.h"
#include "io/files/files_in_use.h"
#include "io/scene/view_source.h"
#include "measure/contrast.h"
#include "measure/design_files.h"
#include "measure/measure_run.h"
#include "runs/file_hashes.h"
#include "runs/long_run.h"

namespace hogelscope {

namespace {

constexpr std::string_view mtfPrefix = "mtf:";
constexpr const char* idealPsnr = "psnr:ideal";
constexpr const char* designPsnr = "psnr:design";

bool needsViews(const std::string& figure) {
  const SweptWith with = figureRow(figure).sweptWith;
  return with == SweptWith::views || with == SweptWith::clock;
}

/// The views of a session's states, both eyes of those that have two.
class Views {
 public:
  Views(const Session& session, const Progress& progress)
      : m_states(withEyes(session).cameras), m_source(loadViewSource(session, progress)) {}
  /// Takes the light field of other views, which outlive these and whose session reads the same.
  Views(const Session& session, const Views& other)
      : m_states(withEyes(session).cameras),
        m_source(viewSourceOf(session, other.m_source.lightField)) {}

  [[nodiscard]] std::size_t count() const { return m_states.size(); }
  [[nodiscard]] Image render(std::size_t state, bool isIdeal, const Progress& progress) {
    RenderJob job = m_source.job(m_states[state]);
    job.isIdeal = isIdeal;
    return m_renderer.render(job, progress);
  }

 private:
  std::vector<CameraState> m_states;
  ViewSource m_source;
  Renderer m_renderer;
};

double psnrOf(Views& test, Views& reference, bool isIdeal, const Progress& progress) {
  const MetricSet metrics;
  double sum = 0;
  int count = 0;
  for (std::size_t state = 0; state < test.count(); ++state) {
    const Image expected = reference.render(state, isIdeal, progress);
    const Image shown = test.render(state, false, progress);
    if (expected.width != shown.width || expected.height != shown.height)
      throw InputError(designPsnr, "the design's pictures have another size");
    const double mse = metrics.compare(expected, shown, parallelRows, progress)[mseSeenColumn];
    if (std::isnan(mse)) continue;
    sum += mse;
    ++count;
  }
  return count == 0 ? noValue : 10 * std::log10(255.0 * 255 * count / sum);
}

double millisecondsOf(Views& views, const Progress& progress) {
  constexpr int runs = 5;
  std::vector<double> times;
  for (int run = 0; run <= runs; ++run) {
    const auto start = std::chrono::steady_clock::now();
    (void)views.render(0, false, progress);
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - start;
    if (run > 0) times.push_back(taken.count());  // the first one fills caches
  }
  std::ranges::sort(times);
  return times[runs / 2];
}

/// Measures the figures of one design.
class DesignFigures {
 public:
  /// `reference` keeps the views that "psnr:design" compares with for all designs; without one it
  /// is made from `base`.
  DesignFigures(const Session& session, const Session& base, std::optional<Views>& reference,
                const Progress& progress)
      : m_session(session),
        m_base(base),
        m_reference(reference),
        m_progress(progress),
        m_bench(benchOf(session, displayToMeasure(session, progress))) {}

  double of(const std::string& figure) {
    throwIfCancelled(m_progress);
    if (figure.starts_with(mtfPrefix)) {
      const std::size_t axis = mainAxis(m_bench);
      const double z = *numberOf(std::string_view(figure).substr(mtfPrefix.size()));
      if (z >= m_bench.distance()) return noValue;
      return contrast(m_bench, {1 / (2 * m_bench.pitch(axis)), z}, axis);
    }
    const FigureRow& row = figureRow(figure);
    if (row.sweptWith == SweptWith::bench) return measured(row);
    if (figure == designPsnr && !m_reference) m_reference.emplace(m_base, m_progress);
    if (!m_views && m_reference && readTheSame(m_session, m_base))
      m_views.emplace(m_session, *m_reference);
    if (!m_views) m_views.emplace(m_session, m_progress);
    if (row.sweptWith == SweptWith::clock) return millisecondsOf(*m_views, m_progress);
    if (figure == idealPsnr) return psnrOf(*m_views, *m_views, true, m_progress);
    return psnrOf(*m_views, *m_reference, false, m_progress);
  }

 private:
  double measured(const FigureRow& row) {
    if (m_all.empty()) m_all = measurementsOf(m_session, m_bench);
    const auto one =
        std::ranges::find_if(m_all, [&row](const Measurement& any) { return row.isOf(any); });
    if (one == m_all.end()) return noValue;
    return one->simulate ? one->simulate(m_bench) : one->closedForm;
  }

  const Session& m_session;
  const Session& m_base;
  std::optional<Views>& m_reference;
  const Progress& m_progress;
  Bench m_bench;
  std::vector<Measurement> m_all;
  std::optional<Views> m_views;
};

/// Returns the session without its twin, which is no part of a design.
Session asDesigned(Session session) {
  session.twin = {};
  session.twinFile.clear();
  return session;
}

/// The designs of a run, and what their figures are measured with. Views use all threads
/// themselves, and a time is that of a view alone, so these are measured one after the other.
struct DesignBench {
  const Session& base;  ///< where figures need another design
  const std::vector<std::string>& figures;
  std::optional<Views> reference{};

  [[nodiscard]] int workers() const {
    return std::ranges::any_of(figures, needsViews) ? 1 : threadCount();
  }
  std::vector<double> measure(const Session& design, const Progress& progress) {
    DesignFigures of(design, base, reference, progress);
    std::vector<double> values;
    for (const std::string& figure : figures) values.push_back(of.of(figure));
    return values;
  }
};

/// Measures all designs that `designOf` makes, on `base` where figures need another one.
LongRun measureDesigns(const LongRunRequest& request, const Session& base,
                       const std::vector<std::string>& figures,
                       const std::function<Session(std::size_t)>& designOf,
                       const Progress& progress) {
  DesignBench bench{base, figures};
  return longRun(
      request, bench.workers(),
      [&](std::size_t item, std::size_t, const Progress& hear) {
        return bench.measure(designOf(item), hear);
      },
      progress);
}

/// Returns values around the end of those with which a unit passes, by doubling or halving `near`.
Bracket bracketAt(double near, const UnitsAtValue& units,
                  const std::function<bool(double)>& isGood) {
  constexpr double farthest = 1024;
  Bracket ends{near, near};
  if (isGood(near)) {
    ends.outside = std::min(2 * near, units.most());
    while (ends.outside < units.most() && isGood(ends.outside)) {
      ends.inside = ends.outside;
      ends.outside = std::min(2 * ends.outside, units.most());
    }
    return ends;
  }
  const double last = std::max(units.least(), near / farthest);
  ends.inside = near / 2;
  while (ends.inside > last && !isGood(ends.inside)) {
    ends.outside = ends.inside;
    ends.inside /= 2;
  }
  if (ends.inside <= last) ends.inside = units.least();
  return ends;
}

/// Returns the largest value with which a unit passes, as SweepRow::limit says; `near` is that of
/// another unit. What cannot be measured at a value is no good unit there, but at the least value
/// all can.
double limitOf(const UnitsAtValue& units, std::optional<double> near,
               const std::function<bool(double)>& passes) {
  constexpr int halvings = 60;
  constexpr double tolerance = 1e-3;
  const auto isGood = [&passes](double value) {
    try {
      return passes(value);
    } catch (const InputError&) {
      return false;
    }
  };
  const Bracket ends =
      near ? bracketAt(*near, units, isGood) : Bracket{units.least(), units.most()};
  if (ends.inside == units.least() && !passes(units.least())) return noValue;
  if (ends.outside == units.most() && isGood(units.most()))
    return std::numeric_limits<double>::infinity();
  return bisect(ends, halvings, isGood, tolerance).inside;
}

/// Returns a value near which the units' limits may be: that of the first unit, in every shard.
std::optional<double> usualLimit(const UnitsAtValue& units,
                                 const std::function<bool(double)>& passes) {
  try {
    const double limit = limitOf(units, {}, passes);
    return std::isfinite(limit) && limit > std::max(0.0, units.least()) ? std::optional(limit)
                                                                        : std::nullopt;
  } catch (const InputError&) {  // its row will say so
    return {};
  }
}

/// Finds the largest value with which each unit passes, or what SweepRow::limit says.
LongRun findLimits(const LongRunRequest& request, const SweepRequest& sweep,
                   const UnitsAtValue& units, const Progress& progress) {
  const std::vector<SweepLimit>& limits = sweep.table.pass;
  const SweepTable table = units.tableAt(units.least());
  const Session base = asDesigned(sweep.session);
  std::vector<std::string> figures;
  for (const SweepLimit& limit : limits) figures.push_back(limit.figure);
  DesignBench bench{base, figures};
  const auto passes = [&](std::size_t unit, double value, const Progress& hear) {
    const std::vector<double> values =
        bench.measure(overridden(sweep.session, overridesOf(table, units.at(unit, value))), hear);
    for (std::size_t k = 0; k < limits.size(); ++k)
      if (!limits[k].allows(values[k])) return false;
    return true;
  };
  const auto near =
      usualLimit(units, [&](double value) { return passes(0, value, part(progress, 0, 0)); });
  return longRun(
      request, bench.workers(),
      [&](std::size_t unit, std::size_t, const Progress& hear) -> std::vector<double> {
        return {limitOf(units, near, [&](double value) { return passes(unit, value, hear); })};
      },
      progress);
}

/// Says what the limits of units depend on beside designs; the yield is no part of it.
std::string solveKey(const SweepTable& table) {
  const auto text = [](const std::optional<double>& end) { return end ? numberText(*end) : ""; };
  std::string key = "\nsolve " + table.solve->parameter + " " + text(table.solve->from) + " " +
                    text(table.solve->to);
  for (const auto& [figure, least, most] : table.pass)
    key += "\n" + figure + " " + numberText(least) + " " + numberText(most);
  return key;
}

std::string keyOf(const SweepRequest& request, const std::vector<std::filesystem::path>& files,
                  const Progress& progress) {
  std::string text = textOf(request.session);
  for (const Design& design : designsOf(request.table))
    for (const std::string& one : overridesOf(request.table, design)) text += "\n" + one;
  for (const std::string& figure : request.table.figures) text += "\n" + figure;
  if (request.table.solve) text += solveKey(request.table);
  std::string hash;
  if (!files.empty() && !request.output.empty()) {
    makeFolder(request.output);
    hash = FileHashes(request.output).of(files, progress);
  }
  return "sweep " + std::string(programVersion()) + " " + contentHash(text) + " " + hash;
}

/// Throws InputError if the parameters are not those of a session, before any work.
void checkParameters(const SweepRequest& request, const Design& design) {
  try {
    (void)overridden(request.session, overridesOf(request.table, design));
  } catch (const InputError& error) {
    throw InputError("parameters", error.what());
  }
}

/// Measures the designs of the request's table.
LongRun measureTable(const LongRunRequest& run, const SweepRequest& request,
                     const Progress& progress) {
  const std::vector<Design> designs = designsOf(request.table);
  return measureDesigns(
      run, asDesigned(request.session), request.table.figures,
      [&](std::size_t item) {
        return overridden(request.session, overridesOf(request.table, designs[item]));
      },
      progress);
}

std::vector<SweepRow> rowsOf(const SweepTable& table, const std::vector<JournalEntry>& measured) {
  const std::vector<Design> designs = designsOf(table);
  std::vector<SweepRow> rows;
  for (std::size_t item = 0; item < designs.size(); ++item)
    rows.push_back({designs[item], measured[item].values, false, measured[item].problem, false});
  markPareto(table, rows);
  markPassing(table, rows);
  return rows;
}

/// Measures all units at the value that their limits give.
void measureAtValue(SweepRequest request, const UnitsAtValue& units,
                    const std::vector<JournalEntry>& limits, Sweep& result,
                    const Progress& progress) {
  std::vector<double> values;
  for (const JournalEntry& unit : limits) values.push_back(unit.values.front());
  SolvedValue found = solvedValue(values, request.table.solve->yield, units.least(), units.most());
  request.table = units.tableAt(std::isnan(found.value) ? units.least() : found.value);
  const LongRun run =
      measureTable({"", "", units.count(), request.table.figures.size(), {}}, request, progress);
  result.rows = rowsOf(request.table, run.rows);
  for (std::size_t unit = 0; unit < values.size(); ++unit) result.rows[unit].limit = values[unit];
  found.passed = yieldOf(result.rows).passed;
  result.solvedText = solveText(units, *request.table.solve, found);
  result.solved = found;
  result.table = std::move(request.table);
}

void writeSweep(const SweepRequest& request, const Sweep& result) {
  const std::string points = csv(request.table, result.rows);
  writeFigures(request.output, sweepPlots(request.table, result.rows));
  writeTextFile(request.output / "sweep.html", sweepPage(request, result.rows, result.solvedText));
  writeTextFile(request.output / "sweep.csv", points);
}

}  // namespace

void checkFigures(const SweepTable& table, const Session& session) {
  std::vector<std::string_view> names{"mtf:0"}, ofMeasure;
  for (const FigureRow& row : figureRows())
    if (row.sweptWith != SweptWith::nothing)
      (row.sweptWith == SweptWith::bench ? ofMeasure : names).push_back(row.name);
  std::ranges::sort(ofMeasure);
  names.insert(names.end(), ofMeasure.begin(), ofMeasure.end());
  for (const std::string& figure : table.figures) {
    if (figure == idealPsnr) requireLive(session);
    const bool isMtf = figure.starts_with(mtfPrefix) &&
                       numberOf(std::string_view(figure).substr(mtfPrefix.size())).has_value();
    if (isMtf || std::ranges::find(names, figure) != names.end()) continue;
    const std::string_view nearest = nearestName(figure, names);
    std::string known = "mtf:Z (on the plane Z in metres)";
    for (const std::string_view name : names)
      if (!name.starts_with(mtfPrefix)) known += ", " + std::string(name);
    throw InputError(
        "figures",
        "\"" + figure + "\" is none of " + known +
            (nearest.empty() ? std::string() : "; did you mean \"" + std::string(nearest) + "\"?"));
  }
}

std::vector<std::filesystem::path> inputsOf(const SweepRequest& request, const Progress& progress) {
  const bool hasViews = std::ranges::any_of(request.table.figures, needsViews);
  return filesOfDesigns(request.session, request.table, designsOf(request.table), hasViews,
                        progress);
}

Sweep sweep(const SweepRequest& request, const Progress& progress) {
  requireHogels(request.session.display, "a sweep");
  checkFigures(request.table, request.session);
  std::optional<UnitsAtValue> units;
  if (request.table.solve) units.emplace(request.table, request.session);
  SweepRequest own = request;
  if (units) own.table = units->tableAt(units->least());
  const std::vector<Design> designs = designsOf(own.table);
  checkParameters(own, designs.front());
  if (units) own.table = units->tableAt(units->most());  // where draws show, in the run's key
  const std::vector<std::filesystem::path> files = inputsOf(own, progress);
  const FilesInUse inUse(files);
  const LongRunRequest journaled{request.output, keyOf(own, files, part(progress, 0, 0.02)),
                                 designs.size(), units ? 1 : own.table.figures.size(),
                                 request.shard};
  const LongRun run = units ? findLimits(journaled, own, *units, part(progress, 0.02, 0.95))
                            : measureTable(journaled, own, part(progress, 0.02, 1));
  Sweep result{own.table, {}, run.taken, run.replacedAnother};
  if (request.shard) return result;
  if (units)
    measureAtValue(own, *units, run.rows, result, part(progress, 0.95, 1));
  else
    result.rows = rowsOf(own.table, run.rows);
  if (request.output.empty()) return result;
  own.table = result.table;
  writeSweep(own, result);
  if (units)
    writeTextFile(request.output / "sweep.json",
                  solveJson(*units, *own.table.solve, *result.solved));
  run.journal->remove();
  FileHashes(request.output).remove();
  return result;
}

std::vector<SweepRow> measureDesigns(const std::vector<Session>& designs, const Session& base,
                                     const std::vector<std::string>& figures,
                                     const Progress& progress) {
  requireHogels(designs.front().display, "a sweep");
  const LongRun run = measureDesigns(
      {"", "", designs.size(), figures.size(), {}}, base, figures,
      [&](std::size_t item) { return designs[item]; }, progress);
  std::vector<SweepRow> rows;
  for (const JournalEntry& row : run.rows)
    rows.push_back({{}, row.values, false, row.problem, false});
  return rows;
}

}  // namespace hogelscope
