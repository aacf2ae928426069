// SPDX-License-Identifier: BSD-3-Clause
#include "report/report_moves.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "core/base/text.h"

namespace hogelscope {

namespace {
constexpr const char* meanRms = "mean_move_rms";
constexpr const char* meanRest = "mean_move_rest";
}  // namespace

bool compareWithDesign(ReportRequest& request,
                       const std::vector<std::pair<std::string, Session>>& units) {
  const Session own = request.session;
  request.isAgainstDesign = true;
  request.session.twin = {};
  request.session.twinFile.clear();
  for (const auto& [name, built] : units) request.tests.push_back({name, built, request.file});
  if (!units.empty()) return true;
  const std::string file = std::filesystem::path(own.twinFile).filename().string();
  request.tests.push_back({file.empty() ? "twin" : file, own, request.file});
  return !own.twin.isZero();
}

Metric moveMetric() {
  Metric metric;
  const auto column = [](const char* name, const char* title, const char* help) {
    return MetricColumn{.name = name,
                        .title = title,
                        .unit = "px",
                        .help = help,
                        .decimals = 3,
                        .where = MetricColumn::Where::page};
  };
  metric.columns = {
      column("move_rms", "move",
             "How far rays of green light meet other directional pixels than in the design: root "
             "of the mean of Δu² + Δv²"),
      column("move_rest", "move, rest",
             "The same after the mean move is subtracted, which another place of the eye undoes")};
  const auto mean = [](const char* name, const char* title, std::size_t of) {
    return MetricMean{
        .name = name, .title = title, .column = of, .decimals = 3, .unit = "px", .isSeen = true};
  };
  metric.means = {mean(meanRms, "mean move", 0), mean(meanRest, "mean rest of the move", 1)};
  metric.compare = [](const Image&, const Image&, const ParallelRows&, const Progress&,
                      const Viewing&) {
    return std::vector<double>(2, std::numeric_limits<double>::quiet_NaN());
  };
  return metric;
}

std::vector<double> moveValues(const RayMoves& moves) {
  return {moves.rms, moves.rest};
}

std::vector<std::string> harmlessMoves(const std::vector<TestSummary>& summaries,
                                       const MetricSet& metrics) {
  const auto& means = metrics.means();
  const auto indexOf = [&](const char* name) {
    return std::size_t(std::ranges::find(means, name, &MetricMean::name) - means.begin());
  };
  const std::size_t rms = indexOf(meanRms);
  std::vector<std::string> notes;
  if (rms == means.size()) return notes;
  for (std::size_t test = 0; test + 1 < summaries.size(); ++test) {
    const std::vector<double>& values = summaries[test].summary.means;
    const double moved = values[rms];
    const double rest = values[indexOf(meanRest)];
    if (moved > 0.01 && rest < 0.1 * moved)
      notes.push_back(summaries[test].test + ": all its rays are shifted equally by " +
                      rounded(moved, 3) + " px, as if the eye had moved (" + rounded(rest, 3) +
                      " px remain): its PSNR is no loss of quality");
  }
  return notes;
}

}  // namespace hogelscope
