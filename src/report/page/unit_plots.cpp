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

/// Returns the share of units that have at least each unit's mean, or at most that of one which is
/// better if it is less, in percent with its interval.
Figure yieldFigure(const std::vector<UnitMean>& units, const MetricMean& mean) {
  const std::string title = mean.title + (mean.unit.empty() ? "" : " in " + mean.unit);
  const std::string limit = mean.isQuality ? "at least" : "at most";
  Plot plot{limit + " this " + title, "yield in %", {1e-3, 5}, true, false, {}};
  plot.series.push_back({"units", {}, 3});
  Table table{{"limit", "yield_percent", "low", "high"}};
  for (const UnitMean& unit : units) {
    if (!std::isfinite(unit.value)) continue;
    const auto passed = std::size_t(std::ranges::count_if(units, [&](const UnitMean& other) {
      return mean.isQuality ? other.value >= unit.value : other.value <= unit.value;
    }));
    const double share = double(passed) / double(units.size());
    const auto [low, high] = shareInterval(passed, units.size());
    plot.series[0].points.push_back({unit.value,
                                     100 * share,
                                     std::to_string(passed) + " of " +
                                         std::to_string(units.size()) + " units have " + limit +
                                         " " + rounded(unit.value, mean.decimals),
                                     0,
                                     {100 * low, 100 * high}});
    table.push_back({numberText(unit.value), numberText(100 * share), numberText(100 * low),
                     numberText(100 * high)});
  }
  return figureOf(plot, "yield_" + mean.name, "Yield over the limit of the " + title,
                  csvText(table));
}

/// Returns a sentence on what half and 95 % of the units have, and on the worst one.
std::string sentenceOf(const std::vector<UnitMean>& units, const MetricMean& mean) {
  const auto n = units.size();
  const auto text = [&](double value) {
    return std::isfinite(value)
               ? rounded(value, mean.decimals) + (mean.unit.empty() ? "" : " " + mean.unit)
               : std::string("identical views");
  };
  // The value that at least a share of the units reaches: the k-th from the good end.
  const auto reached = [&](double share) {
    const auto k = std::size_t(std::ceil(share * double(n))) - 1;
    return text(units[mean.isQuality ? n - 1 - k : k].value);
  };
  const UnitMean& worst = mean.isQuality ? units.front() : units.back();
  const std::string limit = mean.isQuality ? "at least " : "at most ";
  return "Of " + std::to_string(n) + " units half have a " + mean.title + " of " + limit +
         reached(0.5) + ", 95 % of " + limit + reached(0.95) + "; the worst, " + worst.unit + ", " +
         text(worst.value) + ".";
}

/// The means that are shown, and the units that have them.
struct ShownMean {
  const MetricMean& mean;
  std::vector<UnitMean> units;
};

std::vector<ShownMean> shownMeans(const std::vector<TestSummary>& summaries,
                                  const MetricSet& metrics) {
  std::vector<ShownMean> shown;
  for (std::size_t mean = 0; mean < metrics.means().size(); ++mean) {
    const MetricMean& of = metrics.means()[mean];
    if (mean != meanPsnrSeen && of.name != "mean_move_rest") continue;
    std::vector<UnitMean> units = sorted(summaries, mean);
    if (units.size() > 1) shown.push_back({of, std::move(units)});
  }
  return shown;
}

}  // namespace

std::vector<Figure> unitFigures(const std::vector<TestSummary>& summaries,
                                const MetricSet& metrics) {
  std::vector<Figure> figures;
  for (const auto& [mean, units] : shownMeans(summaries, metrics)) {
    figures.push_back(unitFigure(units, mean));
    figures.push_back(yieldFigure(units, mean));
  }
  return figures;
}

std::vector<std::string> unitSentences(const std::vector<TestSummary>& summaries,
                                       const MetricSet& metrics) {
  std::vector<std::string> sentences;
  for (const auto& [mean, units] : shownMeans(summaries, metrics))
    sentences.push_back(sentenceOf(units, mean));
  return sentences;
}

}  // namespace hogelscope
