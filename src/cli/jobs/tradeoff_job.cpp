// SPDX-License-Identifier: BSD-3-Clause
// --tradeoff: speed against accuracy of every method on the session's own states.
#include <filesystem>
#include <iostream>

#include "chart/painting.h"
#include "chart/recommendations.h"
#include "chart/tradeoff_chart.h"
#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/terminal.h"
#include "core/base/parallel.h"
#include "core/base/text.h"
#include "io/files/atomic_file.h"
#include "study/tradeoff.h"

namespace hogelscope {

namespace {

/// Prints the rows measured once or on part of the pixels, because their figures are less reliable.
void printLimits(const std::vector<TradeoffRow>& rows) {
  const auto print = [&rows](const char* what, auto isOne) {
    std::string names;
    for (const TradeoffRow& row : rows)
      if (isOne(row)) names += (names.empty() ? "" : "; ") + row.method;
    if (!names.empty()) std::cout << what << names << "\n";
  };
  print("timed once: ", [](const TradeoffRow& row) { return row.runs == 1; });
  print("on part of the pixels (see the table): ",
        [](const TradeoffRow& row) { return row.isSampled; });
}

int runTradeoff(const CommandLine& line) {
  const double start = steadySeconds();
  const Input input(loadSelected(line, "a trade-off"));
  warnOfFrames(line, input.file->frames());
  const std::filesystem::path folder = line.text("output");
  checkResults(line, input.session,
               {folder / "tradeoff.csv", folder / "tradeoff.png", folder / "tradeoff.svg"});
  makeFolder(folder);
  ProgressBar bar("measuring", line.has("quiet"));
  const ViewSource source =
      loadViewSource(input.session, *input.file, part(bar.progress(), 0, 0.05));
  std::vector<RenderJob> views;
  for (const CameraState& state : input.session.cameras) views.push_back(source.job(state));
  Budget budget;
  budget.seconds = line.number("budget").value_or(budget.seconds) - (steadySeconds() - start);
  const Tradeoff result =
      measureTradeoff(views, budget, parallelRows, part(bar.progress(), 0.05, 1));
  const Question question = questionOf(input.session.sampling);
  const OffscreenPainting painting;
  const TradeoffChart chart(result.rows, "Error against " + questionText(question));
  const Paint paint = [&chart](QPainter& painter, const QSizeF& size) {
    chart.paintFile(painter, size);
  };
  const QSize size(720, 520);
  writeTextFile(folder / "tradeoff.csv", csv(result.rows));
  writeTextFile(folder / "tradeoff.png", pngOf(paint, size));
  writeTextFile(folder / "tradeoff.svg", svgOf(paint, size, "Speed against accuracy"));
  bar.done();
  if (!finish(line, input.session)) return 0;
  std::cout << "error against " << questionText(question) << " (" << details(question) << "), over "
            << result.errorViews << " of " << views.size()
            << " state(s)\ntime per picture, lens rays included: median of up to " << mostRuns
            << " interleaved runs on " << result.timedViews << " state(s)\n";
  printLimits(result.rows);
  if (havePupil(views))
    std::cout << "the reference has " << Aperture::mostSamples << " samples of the pupil\n";
  if (!haveLens(views)) std::cout << "no state has a lens: ways to invert one are left out\n";
  const auto print = [&](const char* what, std::optional<std::size_t> row) {
    if (row) std::cout << what << result.rows[*row].method << "\n";
  };
  print("for a moving view: ", forMovingView(result.rows));
  print("for a paper: ", forPaper(result.rows));
  std::cout << "chart and table in " << printable((folder / "tradeoff.png").string())
            << ", .svg and .csv\n";
  return 0;
}

}  // namespace

Job tradeoffJob() {
  return {
      .name = "tradeoff",
      .help =
          "Measures speed against accuracy of every method on the session's own states: "
          "DIR/tradeoff.csv, .png, .svg.",
      .details =
          "With sampling.reconstruction nearest and one ray a pixel the reference is the "
          "display's exact pixels, with any other sampling the smooth ideal. The table says on "
          "how many pixels each figure was measured, and how well a time is known.",
      .examples =
          "  hogelscope --tradeoff --session data/table1.json --output tradeoff --budget 20\n"
          "  hogelscope --tradeoff --session data/table1.json --output ideal \\\n"
          "             --set sampling.reconstruction=quadrilinear\n",
      .needs = {"session", "output"},
      .takes = {"set", "states", "calibration", "plugins-path", "save-session", "memory", "threads",
                "quiet"},
      .own = {{.name = "budget",
               .value = "SECONDS",
               .after = "threads",
               .range = NumberRange{.min = 0.001, .max = 1e6},
               .help =
                   "How long the job may take, 60 by default: what is slow is measured once and "
                   "on fewer pixels, what is fast until its time is known to two per cent."}},
      .run = runTradeoff};
}

}  // namespace hogelscope
