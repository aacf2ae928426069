// SPDX-License-Identifier: BSD-3-Clause
#include "measure/sweep_solve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/json/json_parameters.h"
#include "measure/measurement.h"
#include "measure/session_numbers.h"

namespace hogelscope {

namespace {

constexpr std::string_view deviationEnd = ".sigma";
constexpr const char* parameterPath = "solve.parameter";

/// Returns the table's normal parameter whose deviation has this name; the end if there is none.
std::size_t deviationOf(const SweepTable& table, const std::string& name) {
  const auto is = [&name](const SweepParameter& one) {
    return one.kind == SweepParameter::Kind::normal && one.name + std::string(deviationEnd) == name;
  };
  return std::size_t(std::ranges::find_if(table.parameters, is) - table.parameters.begin());
}

/// Throws InputError with the nearest of all names that could be solved for.
[[noreturn]] void refuseName(const SweepTable& table, const std::vector<SessionNumber>& numbers) {
  const std::string& name = table.solve->parameter;
  std::vector<std::string> known;
  for (const SessionNumber& number : numbers) known.push_back(number.name);
  for (const SweepParameter& one : table.parameters)
    if (one.kind == SweepParameter::Kind::normal)
      known.push_back(one.name + std::string(deviationEnd));
  const std::vector<std::string_view> names(known.begin(), known.end());
  const std::string_view nearest = nearestName(name, names);
  std::string line = "\"" + name +
                     "\" is neither a number of the session, such as twin.random.shift.sigma, nor "
                     "P.sigma for a parameter P of the table that is normal";
  if (!nearest.empty()) line += "; did you mean \"" + std::string(nearest) + "\"?";
  throw InputError(parameterPath, line);
}

/// Returns the one real number of this name. Throws InputError.
SessionNumber numberNamed(const std::string& name, const SweepTable& table,
                          const std::vector<SessionNumber>& numbers) {
  const auto number = std::ranges::find(numbers, name, &SessionNumber::name);
  if (number == numbers.end()) refuseName(table, numbers);
  if (number->count > 1)
    throw InputError(parameterPath, "\"" + name + "\" has " + std::to_string(number->count) +
                                        " numbers, of which none can be solved for alone");
  if (number->isWhole)
    throw InputError(parameterPath,
                     "\"" + name + "\" is a whole number; sweep it in place of that");
  return *number;
}

/// ln of the probability that k of n independent units have what each has with probability p.
double logBinomial(double n, double k, double p) {
  return std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) + k * std::log(p) +
         (n - k) * std::log1p(-p);
}

/// Returns how many of the n units that fail the earliest may be below the value, at least and at
/// most, with a probability of 95 %: the ranks of the limits that bound it.
std::array<std::size_t, 2> ranksOf(std::size_t n, double failing) {
  constexpr double tail = 0.025;
  std::array<std::size_t, 2> ranks{0, n + 1};
  double below = 0;  // the probability of at most k
  for (std::size_t k = 0; k <= n; ++k) {
    below += std::exp(logBinomial(double(n), double(k), failing));
    if (below <= tail) ranks[0] = k + 1;
    if (below < 1 - tail) continue;
    ranks[1] = k + 1;
    break;
  }
  return ranks;
}

std::string percent(double share) {
  return numberText(fourDigits(100 * share)) + " %";
}

Json numberOrNull(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

}  // namespace

UnitsAtValue::UnitsAtValue(const SweepTable& table, const Session& session)
    : m_table(table), m_parameter(deviationOf(table, table.solve->parameter)) {
  const SweepSolve& solve = *table.solve;
  if (!areUnits(table))
    throw InputError("solve",
                     "needs units that are drawn: a parameter that is normal, or a range of seeds");
  const std::vector<SessionNumber> numbers = numbersOf(session);
  m_isDeviation = m_parameter < table.parameters.size();
  if (!m_isDeviation && std::ranges::find(table.parameters, solve.parameter,
                                          &SweepParameter::name) != table.parameters.end())
    throw InputError(parameterPath, "\"" + solve.parameter +
                                        "\" is one of the parameters; take it out there, or solve "
                                        "for the deviation of a normal one, P.sigma");
  const SessionNumber number = numberNamed(
      m_isDeviation ? table.parameters[m_parameter].name : solve.parameter, table, numbers);
  m_unit = number.unit;
  m_least = solve.from.value_or(m_isDeviation ? 0 : std::max(0.0, number.range.min));
  m_most = solve.to.value_or(m_isDeviation ? std::max(std::abs(number.range.min), number.range.max)
                                           : number.range.max);
  if (!(m_least >= (m_isDeviation ? 0 : number.range.min)))
    throw InputError("solve.from", numberText(m_least) + " is less than the parameter may be");
  if (!m_isDeviation && m_most > number.range.max)
    throw InputError("solve.to", numberText(m_most) + " is more than the parameter may be, " +
                                     numberText(number.range.max));
  if (!(m_least < m_most))
    throw InputError("solve.to", numberText(m_most) + " is not above from, " + numberText(m_least));
  if (!m_isDeviation) {
    m_table.parameters.emplace_back();
    m_table.parameters.back().name = solve.parameter;
  }
  SweepTable drawn = tableAt(m_least);
  if (m_isDeviation) drawn.parameters[m_parameter].from = 0;
  if (m_isDeviation) drawn.parameters[m_parameter].to = 1;
  m_drawn = designsOf(drawn);
}

SweepTable UnitsAtValue::tableAt(double value) const {
  SweepTable table = m_table;
  if (m_isDeviation)
    table.parameters[m_parameter].to = value;
  else
    table.parameters[m_parameter].values = {numberText(value)};
  return table;
}

Design UnitsAtValue::at(std::size_t unit, double value) const {
  Design design = m_drawn[unit];
  std::string& own = design[m_parameter];
  own = numberText(m_isDeviation ? m_table.parameters[m_parameter].from + value * *numberOf(own)
                                 : value);
  return design;
}

SolvedValue solvedValue(std::vector<double> limits, double share, double least, double most) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double rounding = 1e-9;  // 0.95 · 100 is above 95
  for (double& limit : limits)
    if (std::isnan(limit)) limit = -infinity;
  std::ranges::sort(limits);
  SolvedValue found;
  const std::size_t n = found.count = limits.size();
  found.needed = std::clamp<std::size_t>(std::size_t(std::ceil(share * double(n) - rounding)), 1,
                                         std::max<std::size_t>(n, 1));
  const auto atRank = [&](std::size_t rank) {  // from 1 on, of the limits in ascending order
    return rank >= 1 && rank <= n && std::isfinite(limits[rank - 1]) ? limits[rank - 1] : noValue;
  };
  const double limit = n == 0 ? -infinity : limits[n - found.needed];
  found.isMost = limit == infinity;
  found.value = limit == -infinity ? noValue : std::min(limit, most);
  const double counted = std::isnan(found.value) ? least : found.value;
  found.passed =
      std::size_t(std::ranges::count_if(limits, [counted](double one) { return one >= counted; }));
  const auto [low, high] = ranksOf(n, 1 - share);
  found.low = atRank(low);
  found.high = atRank(high);
  return found;
}

std::string solveText(const UnitsAtValue& units, const SweepSolve& solve,
                      const SolvedValue& found) {
  const auto text = [&units](double value) {
    const std::string number = numberText(fourDigits(value));
    const bool isClose = units.unitOfValue() == "°";
    return units.unitOfValue().empty() ? number
                                       : number + (isClose ? "" : " ") + units.unitOfValue();
  };
  const auto end = [](double value) {
    return std::isnan(value) ? std::string("?") : numberText(fourDigits(value));
  };
  const std::string share = percent(solve.yield);
  const std::string passed =
      std::to_string(found.passed) + " of " + std::to_string(found.count) + " units pass";
  if (std::isnan(found.value))
    return "no " + solve.parameter + " has a yield of " + share + ": at the least, " +
           text(units.least()) + ", " + passed;
  if (found.isMost)
    return "even the largest " + solve.parameter + ", " + text(units.most()) + ", has a yield of " +
           share + ": " + passed;
  std::string line = "largest " + solve.parameter + " for a yield of " + share + ": " +
                     text(found.value) + " (" + end(found.low) + " … " + end(found.high) + ")";
  if (found.passed < found.needed)
    line += ", where only " + passed + ": some pass again beyond a value at which they fail";
  return line;
}

std::string solveJson(const UnitsAtValue& units, const SweepSolve& solve,
                      const SolvedValue& found) {
  Json json;
  json["parameter"] = solve.parameter;
  json["yield"] = solve.yield;
  json["unit"] = units.unitOfValue();
  json["from"] = units.least();
  json["to"] = units.most();
  json["value"] = found.isMost ? Json() : numberOrNull(found.value);
  json["low"] = numberOrNull(found.low);
  json["high"] = numberOrNull(found.high);
  json["passed"] = found.passed;
  json["units"] = found.count;
  json["text"] = solveText(units, solve, found);
  return Json{{"solve", json}}.dump(2) + "\n";
}

}  // namespace hogelscope
