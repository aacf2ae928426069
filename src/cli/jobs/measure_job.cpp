// SPDX-License-Identifier: BSD-3-Clause
// --measure: the figures of the session's display.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/terminal.h"
#include "core/base/text.h"
#include "measure/measure_page.h"
#include "measure/measure_run.h"

namespace hogelscope {

namespace {

/// Prints the figures that stand for a display.
void printFigures(const Measured& measured) {
  for (const FigureRow& row : figureRows()) {
    const auto one = std::ranges::find_if(
        measured.figures, [&row](const MeasuredFigure& any) { return row.isOf(any.of); });
    if (!row.isHeadline || one == measured.figures.end()) continue;
    const auto [unit, factor] = readUnitOf(*one);
    std::cout << "  " << row.name << " (" << one->of.where
              << "): " << readValue(factor * one->value) << (unit.empty() ? "" : " ") << unit;
    if (!std::isnan(one->of.closedForm))
      std::cout << ", closed form " << readValue(factor * one->of.closedForm);
    std::cout << "\n";
  }
}

}  // namespace

int runMeasure(const CommandLine& line) {
  const bool isQuiet = line.has("quiet");
  MeasureRequest request;
  request.name = line.text("session");
  request.session = loadSelected(line);
  request.display = displayToMeasure(request.session, {});
  request.output = line.text("output");
  request.shard = shardOf(line);
  const std::filesystem::path folder = request.output;
  const FilesInUse inUse(filesOf(request.session));
  checkResults(line, request.session, {folder / "measure.csv", folder / "measure.html"});
  const auto warn = [&](const std::string& text) {
    if (!isQuiet) printNote(request.name + ": warning: " + text);
  };
  if (request.session.display.sheet && !request.session.twin.isZero())
    warn("a lens sheet is measured as designed, without its twin");
  if (request.session.lightField.calibration)
    warn("the panel is woven for the lens sheet itself, not for lightField.calibration");
  ProgressBar bar("measuring", isQuiet);
  const Measured measured = measure(request, bar.progress());
  bar.done();
  if (!finish(line, request.session)) return 0;
  for (const std::string& left : measured.left) warn("not measured, " + left);
  printFound(folder, measured.replacedAnother, measured.taken, "figures");
  if (printShard(request.shard, "figures", "page")) return 0;
  const auto failed = std::ranges::find_if(
      measured.figures, [](const MeasuredFigure& one) { return !one.problem.empty(); });
  if (failed != measured.figures.end())
    printNote(failed->of.figure + ", " + failed->of.where + ": " + failed->problem +
              "; cells of figures that cannot be measured are empty");
  printFigures(measured);
  std::cout << measured.figures.size() << " figures in "
            << printable((folder / "measure.csv").string()) << " and "
            << printable((folder / "measure.html").string()) << "\n";
  return 0;
}

Job measureJob() {
  return {.name = "measure",
          .help =
              "Measures what the session's display can show to the eye of its first state, beside "
              "closed forms: DIR/measure.csv, measure.html, plots.",
          .details =
              "Resolution over depth, depth of field, viewing zone, crosstalk, angular profile, "
              "uniformity and more, simulated with test light; the light field is not read. "
              "After a stop the same command goes on where it was, and --shard K/N does a part, "
              "as of a report. With a twin the unit as built is measured: the figures that have a "
              "formula for its errors; the others are named.",
          .examples =
              "  hogelscope --measure --session data/table1.json --output measures\n"
              "  hogelscope --measure --session s.json --states 'front' --output measures \\\n"
              "             --set psf.sigma=0.67 --set psf.windowSize=5\n"
              "  hogelscope --measure --session data/table1.json --twin unit.json --output unit\n",
          .needs = {"session", "output"},
          .takes = {"set", "states", "calibration", "twin", "plugins-path", "save-session", "shard",
                    "memory", "threads", "quiet"},
          .run = runMeasure};
}

}  // namespace hogelscope
