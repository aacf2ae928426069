// SPDX-License-Identifier: BSD-3-Clause
// What the figures of a sweep say: the Pareto front, units that pass, parameters without effect.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "core/base/text.h"
#include "measure/measurement.h"
#include "measure/sweep.h"

namespace hogelscope {

namespace {

bool areAlike(const std::vector<std::size_t>& figures, const SweepRow& a, const SweepRow& b) {
  return std::ranges::all_of(figures, [&](std::size_t figure) {
    const double first = a.figures[figure];
    const double second = b.figures[figure];
    return first == second || (std::isnan(first) && std::isnan(second));
  });
}

/// Whether designs that differ in a parameter alone are there, and these figures of them are alike.
bool hasNoEffect(const std::vector<std::size_t>& figures, const std::vector<SweepRow>& rows,
                 std::size_t parameter) {
  std::map<Design, const SweepRow*> known;  // by the other parameters
  bool isVaried = false;
  for (const SweepRow& row : rows) {
    if (!row.problem.empty()) continue;
    Design others = row.design;
    others[parameter].clear();
    const auto& [same, isNew] = known.try_emplace(std::move(others), &row);
    if (isNew || row.design[parameter] == same->second->design[parameter]) continue;
    isVaried = true;
    if (!areAlike(figures, row, *same->second)) return false;
  }
  return isVaried;
}

/// Names the parameters of which `is` is true, and what they do: "a, b change none of the figures".
template <class Is>
std::string namesOf(const SweepTable& table, const Is& is, const std::string& what) {
  std::string names;
  std::size_t count = 0;
  for (std::size_t p = 0; p < table.parameters.size(); ++p) {
    if (!is(p)) continue;
    names += (names.empty() ? "" : ", ") + table.parameters[p].name;
    ++count;
  }
  if (count == 0) return {};
  return names + (count == 1 ? " changes" : " change") + " none of the " + what;
}

}  // namespace

void markPareto(const SweepTable& table, std::vector<SweepRow>& rows) {
  std::vector<std::pair<std::size_t, int>> goals;
  for (const auto& [figure, goal] : table.pareto)
    goals.emplace_back(
        std::size_t(std::ranges::find(table.figures, figure) - table.figures.begin()), goal);
  const auto isBeaten = [&](const SweepRow& a, const SweepRow& by) {
    bool isBetter = false;
    for (const auto& [figure, goal] : goals) {
      const double own = goal * a.figures[figure];
      const double other = goal * by.figures[figure];
      if (std::isnan(other) || other < own) return false;
      isBetter = isBetter || other > own;
    }
    return isBetter;
  };
  for (SweepRow& row : rows) {
    const bool isKnown = std::ranges::none_of(
        goals, [&row](const auto& goal) { return std::isnan(row.figures[goal.first]); });
    row.isPareto = !goals.empty() && isKnown && std::ranges::none_of(rows, [&](const SweepRow& by) {
      return isBeaten(row, by);
    });
  }
}

void markPassing(const SweepTable& table, std::vector<SweepRow>& rows) {
  for (SweepRow& row : rows)
    row.passes = std::ranges::all_of(table.pass, [&](const SweepLimit& limit) {
      const auto figure = std::ranges::find(table.figures, limit.figure) - table.figures.begin();
      return limit.allows(row.figures[std::size_t(figure)]);
    });
}

SweepYield yieldOf(const std::vector<SweepRow>& rows) {
  const auto passed = std::size_t(std::ranges::count_if(rows, &SweepRow::passes));
  return {passed, rows.size(), shareInterval(passed, rows.size())};
}

std::string yieldText(const SweepTable& table, const std::vector<SweepRow>& rows) {
  if (table.pass.empty()) return {};
  std::string limits;
  for (const auto& [figure, least, most] : table.pass) {
    limits += (limits.empty() ? "" : ", ") + figure;
    if (std::isfinite(least)) limits += " at least " + numberText(least);
    if (std::isfinite(most)) limits += " at most " + numberText(most);
  }
  const SweepYield yield = yieldOf(rows);
  const std::string passed = std::to_string(yield.passed) + " of " + std::to_string(yield.count);
  if (!areUnits(table)) return passed + " designs pass (" + limits + ")";
  const auto percent = [](double share) { return rounded(100 * share, 1); };
  return passed + " units pass (" + limits + "): yield " +
         percent(yield.count == 0 ? 0 : double(yield.passed) / double(yield.count)) + " % (" +
         percent(yield.interval.low) + " … " + percent(yield.interval.high) + " %)";
}

std::string effectText(const SweepTable& table, const std::vector<SweepRow>& rows) {
  std::vector<std::size_t> figures, goals;
  for (std::size_t k = 0; k < table.figures.size(); ++k) {
    if (figureRow(table.figures[k]).sweptWith == SweptWith::clock) continue;  // never alike
    figures.push_back(k);
    if (std::ranges::find(table.pareto, table.figures[k], &SweepGoal::figure) != table.pareto.end())
      goals.push_back(k);
  }
  const auto isWithout = [&](std::size_t p) { return hasNoEffect(figures, rows, p); };
  const std::string text = namesOf(table, isWithout, "figures");
  if (goals.empty()) return text;
  const std::string ofGoals = namesOf(
      table, [&](std::size_t p) { return !isWithout(p) && hasNoEffect(goals, rows, p); },
      "goals of the Pareto front");
  return text + (text.empty() || ofGoals.empty() ? "" : "; ") + ofGoals;
}

std::string csv(const SweepTable& table, const std::vector<SweepRow>& rows) {
  Table lines{{"design"}};
  for (const SweepParameter& parameter : table.parameters) lines[0].push_back(parameter.name);
  lines[0].insert(lines[0].end(), table.figures.begin(), table.figures.end());
  lines[0].emplace_back("pareto");
  if (!table.pass.empty()) lines[0].emplace_back("pass");
  if (table.solve) lines[0].emplace_back("limit");
  lines[0].emplace_back("problem");
  for (const SweepRow& row : rows) {
    std::vector<std::string> cells{std::to_string(lines.size())};
    cells.insert(cells.end(), row.design.begin(), row.design.end());
    std::ranges::transform(row.figures, std::back_inserter(cells), numberCell);
    cells.emplace_back(row.isPareto ? "1" : "0");
    if (!table.pass.empty()) cells.emplace_back(row.passes ? "1" : "0");
    if (table.solve) cells.push_back(numberCell(row.limit));
    cells.push_back(row.problem);
    lines.push_back(std::move(cells));
  }
  return csvText(lines);
}

}  // namespace hogelscope
