// SPDX-License-Identifier: BSD-3-Clause
#include "measure/sweep.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

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
#include "page/figure.h"
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

/// Measures all designs that `designOf` makes, on `base` where figures need another one.
LongRun measureDesigns(const LongRunRequest& request, const Session& base,
                       const std::vector<std::string>& figures,
                       const std::function<Session(std::size_t)>& designOf,
                       const Progress& progress) {
  // Views use all threads themselves; a time is that of a view alone.
  const bool hasViews = std::ranges::any_of(figures, needsViews);
  std::optional<Views> reference;
  return longRun(
      request, hasViews ? 1 : threadCount(),
      [&](std::size_t item, std::size_t, const Progress& hear) {
        const Session design = designOf(item);
        DesignFigures of(design, base, reference, hear);
        std::vector<double> values;
        for (const std::string& figure : figures) values.push_back(of.of(figure));
        return values;
      },
      progress);
}

std::string keyOf(const SweepRequest& request, const std::vector<Design>& designs,
                  const std::vector<std::filesystem::path>& files, const Progress& progress) {
  std::string text = textOf(request.session);
  for (const Design& design : designs)
    for (const std::string& one : overridesOf(request.table, design)) text += "\n" + one;
  for (const std::string& figure : request.table.figures) text += "\n" + figure;
  std::string hash;
  if (!files.empty() && !request.output.empty()) {
    makeFolder(request.output);
    hash = FileHashes(request.output).of(files, progress);
  }
  return "sweep " + std::string(programVersion()) + " " + contentHash(text) + " " + hash;
}

/// Returns the session without its twin, which is no part of a design.
Session asDesigned(Session session) {
  session.twin = {};
  session.twinFile.clear();
  return session;
}

/// Throws InputError if the parameters are not those of a session, before any work.
void checkParameters(const SweepRequest& request, const Design& design) {
  try {
    (void)overridden(request.session, overridesOf(request.table, design));
  } catch (const InputError& error) {
    throw InputError("parameters", error.what());
  }
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
  const std::vector<Design> designs = designsOf(request.table);
  checkParameters(request, designs.front());
  const std::vector<std::filesystem::path> files = inputsOf(request, progress);
  const FilesInUse inUse(files);
  const LongRun run = measureDesigns(
      {request.output, keyOf(request, designs, files, part(progress, 0, 0.02)), designs.size(),
       request.table.figures.size(), request.shard},
      asDesigned(request.session), request.table.figures,
      [&](std::size_t item) {
        return overridden(request.session, overridesOf(request.table, designs[item]));
      },
      part(progress, 0.02, 1));
  Sweep result{{}, run.taken, run.replacedAnother};
  if (request.shard) return result;
  for (std::size_t item = 0; item < designs.size(); ++item)
    result.rows.push_back(
        {designs[item], run.rows[item].values, false, run.rows[item].problem, false});
  markPareto(request.table, result.rows);
  markPassing(request.table, result.rows);
  if (request.output.empty()) return result;
  const std::string points = csv(request.table, result.rows);
  std::vector<Figure> figures;
  for (const auto& [name, svg] : sweepPlots(request.table, result.rows))
    figures.push_back({name, "", "", svg, points, twoColumns});
  writeFigures(request.output, figures);
  writeTextFile(request.output / "sweep.html", sweepPage(request, result.rows));
  writeTextFile(request.output / "sweep.csv", points);
  run.journal->remove();
  FileHashes(request.output).remove();
  return result;
}

std::vector<SweepRow> measureDesigns(const std::vector<Session>& designs,
                                     const std::vector<std::string>& figures,
                                     const Progress& progress) {
  requireHogels(designs.front().display, "a sweep");
  const LongRun run = measureDesigns(
      {"", "", designs.size(), figures.size(), {}}, designs.front(), figures,
      [&](std::size_t item) { return designs[item]; }, progress);
  std::vector<SweepRow> rows;
  for (const JournalEntry& row : run.rows)
    rows.push_back({{}, row.values, false, row.problem, false});
  return rows;
}

}  // namespace hogelscope
