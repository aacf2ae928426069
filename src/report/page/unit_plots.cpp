// SPDX-License-Identifier: BSD-3-Clause
#include "report/page/unit_plots.h"

#include <algorithm>
#include <cmath>

#include "core/base/text.h"

namespace hogelscope {

namespace {

/// A unit's mean.
struct UnitMean {
  std::string unit;
  double value = 0;
  Interval interval;
  double share = 0;  ///< of the units up to this one, in percent
};

/// Returns the units that have this mean, the lowest first. Identical ones have an infinite PSNR.
std::vector<UnitMean> sorted(const std::vector<TestSummary>& summaries, std::size_t mean) {
  std::vector<UnitMean> units;
  for (std::size_t k = 0; k + 1 < summaries.size(); ++k) {  // the last one is of all tests
    const TestSummary& unit = summaries[k];
    const auto& [values, intervals] = unit.means(unit.hasWeights());
    if (mean == meanPsnrSeen && unit.summary.identical == unit.rows.size())
      units.push_back({unit.test, INFINITY, {NAN, NAN}});
    else if (!std::isnan(values[mean]))
      units.push_back({unit.test, values[mean], intervals[mean]});
  }
  std::ranges::stable_sort(units, {}, &UnitMean::value);
  for (std::size_t k = 0; k < units.size(); ++k)
    units[k].share = 100 * double(k + 1) / double(units.size());
  return units;
}

Figure unitFigure(const std::vector<UnitMean>& units, const MetricMean& mean) {
  const std::string title = mean.title + (mean.unit.empty() ? "" : " in " + mean.unit);
  Plot plot{"units up to this value, in %", title, {1, 1e-3}, true, false, {}};
  plot.series.push_back({"units", {}, 3});
  Table table{{"unit", "percent_of_units", mean.name, "low", "high"}};
  for (const UnitMean& unit : units) {
    plot.series[0].points.push_back({unit.share, unit.value,
                                     unit.unit + ": " + rounded(unit.value, mean.decimals), 0,
                                     unit.interval});
    table.push_back({unit.unit, numberText(unit.share), numberCell(unit.value),
                     numberCell(unit.interval.low), numberCell(unit.interval.high)});
  }
  return figureOf(plot, "units_" + mean.name, title + " over the units", csvText(table));
}

}  // namespace

std::vector<Figure> unitFigures(const std::vector<TestSummary>& summaries,
                                const MetricSet& metrics) {
  std::vector<Figure> figures;
  for (std::size_t mean = 0; mean < metrics.means().size(); ++mean) {
    const MetricMean& of = metrics.means()[mean];
    if (mean != meanPsnrSeen && of.name != "mean_move_rest") continue;
    const std::vector<UnitMean> units = sorted(summaries, mean);
    if (units.size() > 1) figures.push_back(unitFigure(units, of));
  }
  return figures;
}

}  // namespace hogelscope
