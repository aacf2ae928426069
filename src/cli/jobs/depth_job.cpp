// SPDX-License-Identifier: BSD-3-Clause
// --depth: whether content fits the display in depth, and where it would.
#include <cmath>
#include <filesystem>
#include <iostream>

#include "chart/depth_budget_chart.h"
#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/documents/session_file.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "io/files/system_limits.h"
#include "measure/depth_budget_run.h"
#include "page/figure.h"

namespace hogelscope {

namespace {

namespace fs = std::filesystem;

std::string percent(double share) {
  return numberText(std::round(1000 * share) / 10) + " %";
}

std::string centimetres(double depth) {
  return std::isinf(depth) ? "∞" : rounded(100 * depth, 1) + " cm";
}

void printFigures(const DepthBudget& budget) {
  const DepthFigures& first = budget.now.states.front();
  const DepthRange sharp = first.limits.inMetres(first.limits.display);
  const DepthRange comfortable = first.limits.inMetres(first.limits.comfort);
  std::cout << printable(first.state) << ", " << numberText(first.limits.distance)
            << " m from the panel:\n  sharp from " << centimetres(sharp.behind) << " behind to "
            << centimetres(sharp.front) << " in front of the panel, comfortable from "
            << centimetres(comfortable.behind) << " to " << centimetres(comfortable.front)
            << "\n  inside the display's limits " << percent(first.insideDisplay)
            << ", inside both " << percent(first.inside) << " of the pixels whose depth is known ("
            << percent(first.known) << ")\n";
  if (!budget.proposal) {
    std::cout << "  nothing is proposed: " << budget.obstacle << "\n";
    return;
  }
  const DepthFigures& later = budget.proposal->depths.states.front();
  std::cout << "  proposed: " << placeText(*budget.proposal) << ": inside both "
            << percent(later.inside) << "\n";
}

/// Writes plots/NAME.svg and NAME_page.svg, a histogram of the first state for a column and for a
/// page, and plots/NAME.csv, its bars.
void writePlot(const fs::path& folder, const std::string& name, const DepthFigures& figures,
               double end) {
  const DepthHistogram histogram{figures, depthBars(figures, end)};
  const Paint paint = [&histogram](QPainter& painter, const QSizeF& size) {
    paintDepths(painter, QRectF({12, 8}, size - QSizeF(24, 12)), histogram, printColours());
  };
  Table points{{"dioptres", "z", "share"}};
  const DepthBars& bars = histogram.bars;
  for (std::size_t bar = 0; bar < bars.shares.size(); ++bar)
    points.push_back({numberText(bars.middle(bar)),
                      numberText(depthAt(bars.middle(bar), figures.limits.distance)),
                      numberText(bars.shares[bar])});
  const auto [column, page, csv] = figureEndings;
  const std::string title = "Depth of the content";
  writeTextFile(folder / (name + column), svgOf(paint, {columnPixels, 240}, title, columnWidth));
  writeTextFile(folder / (name + page), svgOf(paint, {pagePixels, 280}, title, pageWidth));
  writeTextFile(folder / (name + csv), csvText(points));
}

int runDepth(const CommandLine& line) {
  const Input input(loadSelected(line, "a depth budget"));
  warnOfFrames(line, input.file->frames());
  const fs::path folder = line.text("output");
  const std::string fit = line.text("fit");
  std::vector<fs::path> outputs{folder / "depth.csv", folder / "depth.json", folder / "depth.png",
                                folder / "depth.svg"};
  if (!fit.empty()) {
    if (!isSessionFile(fit))
      throw InputError("--fit " + fit,
                       "cannot be written: a session's name ends in .hogelscope or .json");
    outputs.emplace_back(fit);
    (void)textFor(fit, input.session);  // the fitted one differs in numbers alone
  }
  checkResults(line, input.session, outputs);
  makeFolder(folder);
  ProgressBar bar("measuring depths", line.has("quiet"));
  const DepthBudget budget = measureDepths(input.session, *input.file, {}, bar.progress());
  if (!fit.empty() && !budget.proposal)
    throw InputError("--fit " + fit, "there is nothing to write: " + budget.obstacle);
  const OffscreenPainting painting;
  writeTextFile(folder / "depth.csv", csv(budget));
  writeTextFile(folder / "depth.json", json(budget));
  const DepthBudgetChart chart(budget, input.session);
  const Paint paint = [&chart](QPainter& painter, const QSizeF& size) {
    chart.paint(painter, size);
  };
  writeTextFile(folder / "depth.png", pngOf(paint, chart.size()));
  writeTextFile(folder / "depth.svg", svgOf(paint, chart.size(), "Depth budget", pageWidth));
  makeFolder(folder / "plots");
  const DepthFigures* const later =
      budget.proposal ? &budget.proposal->depths.states.front() : nullptr;
  const double end = barsEnd(budget.now.states.front(), later);
  writePlot(folder / "plots", "depth_now", budget.now.states.front(), end);
  if (later != nullptr) writePlot(folder / "plots", "depth_proposed", *later, end);
  if (!fit.empty()) {
    makeFolderOf(fit);
    saveSession(fit, budget.proposal->session);
  }
  bar.done();
  if (!finish(line, input.session)) return 0;
  printFigures(budget);
  std::cout << "chart and table in " << printable((folder / "depth.png").string())
            << ", .svg, .csv and .json\n";
  return 0;
}

}  // namespace

Job depthJob() {
  return {
      .name = "depth",
      .help =
          "Says whether the session's content fits its display in depth, and what scale and "
          "place would: DIR/depth.csv, .json, .png, .svg.",
      .details =
          "Limits are what the display can show to the eye of a state, and what is "
          "comfortable for two eyes; proposed is what brings depth.share of the first "
          "state's pixels within both. A live scene tells its depths; those of views come "
          "from the shift of what they show, where that stands out.",
      .examples =
          "  hogelscope --depth --session data/room.json --output depth\n"
          "  hogelscope --depth --session s.json --output depth --fit fitted.json \\\n"
          "             --set depth.comfort=0.5 --states 'front*'\n",
      .needs = {"session", "output"},
      .takes = {"set", "states", "calibration", "plugins-path", "save-session", "memory", "threads",
                "quiet"},
      .own =
          {{.name = "fit",
            .value = "FILE",
            .after = "save-session",
            .help =
                "Also writes the session with its content at the proposed scale and place, or with "
                "its views sheared."}},
      .run = runDepth};
}

}  // namespace hogelscope
