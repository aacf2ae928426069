// SPDX-License-Identifier: BSD-3-Clause
#include "measure/measure_run.h"

#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/files/content_hash.h"
#include "io/files/files_in_use.h"
#include "io/scene/view_source.h"
#include "measure/measure_page.h"
#include "runs/long_run.h"

namespace hogelscope {

namespace {

/// Returns a lens sheet's display with the pixels of its panel and its views as directions.
PanelParams withViews(PanelParams display, const Session& session) {
  const int views = viewsOnSheet(session);
  if (views < 2)
    throw InputError(
        "lightField.columns",
        "and rows are missing: what a lens sheet shows depends on its number of views");
  display.hogels = display.sheet->calibration.params.panel;
  display.directions = {views, 1};
  return display;
}

/// Returns the twin that is measured: no formula is of a lens sheet's.
TwinParams unitToMeasure(const Session& session) {
  return session.display.sheet ? TwinParams{} : session.twin;
}

/// The text that identifies a run: what its figures depend on.
std::string keyOf(const MeasureRequest& request, const std::vector<std::filesystem::path>& files,
                  const Progress& progress) {
  Session shown;
  shown.display = request.display;
  shown.lightField.viewingDistance = request.display.viewingDistance;
  shown.depth = request.session.depth;
  shown.cameras = {request.session.cameras.front()};
  shown.twin = unitToMeasure(request.session);
  return "measure " + std::string(programVersion()) + " " + contentHash(textOf(shown)) +
         (files.empty() ? "" : " " + contentHash(files, progress));
}

}  // namespace

double MeasuredFigure::difference() const {
  return value == of.closedForm ? 0 : value - of.closedForm;
}

PanelParams displayToMeasure(const Session& session, const Progress& progress) {
  const PanelParams display = displayOf(session);
  if (display.sheet) return withViews(display, session);
  if (display.hogels[0] > 0 && display.directions[0] > 0) return display;
  const auto file = openLightField(session.lightField, session.display, progress);
  return resolved(display, file->size());
}

Bench benchOf(const Session& session, const PanelParams& display,
              std::shared_ptr<const Twin> twin) {
  return {display, session.cameras.front(), std::move(twin)};
}

std::vector<Measurement> measurementsOf(const Session& session, const Bench& bench) {
  const StereoParams& stereo = session.cameras.front().stereo;
  const double pupil = bench.pupil().diameter;
  return allMeasurements(bench, stereo.ipd > 0 ? stereo.ipd : session.depth.ipd,
                         pupil > 0 ? pupil : session.depth.pupil);
}

Measured measure(const MeasureRequest& request, const Progress& progress) {
  const TwinParams unit = unitToMeasure(request.session);
  const Bench bench =
      benchOf(request.session, request.display, twinOf(unit, request.display, nullptr, progress));
  const std::vector<std::filesystem::path> files = sessionFiles(request.session);
  const FilesInUse inUse(files);
  std::vector<Measurement> all = measurementsOf(request.session, bench);
  std::vector<std::string> left;
  if (bench.twin() != nullptr) left = keepThoseOfUnit(all, bench.twin()->params());
  std::vector<Bench> benches(std::size_t(threadCount()), bench);
  LongRun run = longRun(
      {request.output, keyOf(request, files, progress), all.size(), 1, request.shard},
      threadCount(),
      [&](std::size_t item, std::size_t worker, const Progress& hear) -> std::vector<double> {
        throwIfCancelled(hear);
        if (!all[item].simulate) return {std::numeric_limits<double>::quiet_NaN()};
        return {all[item].simulate(benches[worker])};
      },
      progress);
  Measured result{{}, run.taken, run.replacedAnother, std::move(left)};
  if (request.shard) return result;
  for (std::size_t item = 0; item < all.size(); ++item)
    result.figures.push_back({all[item], run.rows[item].values.front(), run.rows[item].problem});
  if (request.output.empty()) return result;
  writeFigures(request.output, plotsOf(bench, result.figures));
  writeTextFile(request.output / "measure.html", measurePage(request, bench, result));
  writeTextFile(request.output / "measure.csv", csv(result.figures));
  run.journal->remove();
  return result;
}

std::string csv(const std::vector<MeasuredFigure>& figures) {
  Table table{{"figure", "value", "unit", "where", "closed_form", "difference"}};
  for (const MeasuredFigure& one : figures)
    table.push_back({one.of.figure, numberCell(one.value), one.of.unit, one.of.where,
                     numberCell(one.of.closedForm), numberCell(one.difference())});
  return csvText(table);
}

}  // namespace hogelscope
