// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/votes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/text.h"

namespace hogelscope {

namespace {

/// The probability that |t| is below `t`, Abramowitz and Stegun 26.7.3 and 26.7.4.
double studentWithin(double t, int degrees) {
  const double angle = std::atan(t / std::sqrt(degrees));
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const bool isOdd = degrees % 2 == 1;
  double term = isOdd ? c : 1;
  double sum = degrees == 1 ? 0 : term;
  for (int k = isOdd ? 3 : 2; k <= degrees - 2; k += 2) {
    term *= c * c * (k - 1) / k;
    sum += term;
  }
  return isOdd ? 2 / std::numbers::pi * (angle + s * sum) : s * sum;
}

struct Sample {
  std::vector<double> values;

  [[nodiscard]] double moment(int power, double about) const {
    double sum = 0;
    for (const double value : values) sum += std::pow(value - about, power);
    return sum / double(values.size());
  }
  [[nodiscard]] double mean() const { return moment(1, 0); }
  /// The standard deviation with n − 1.
  [[nodiscard]] double deviation() const {
    const auto n = double(values.size());
    return std::sqrt(moment(2, mean()) * n / (n - 1));  // of one value NaN
  }
  [[nodiscard]] Interval interval() const {
    if (values.size() < 2) return {unknownFigure, unknownFigure};
    const double half =
        studentQuantile(int(values.size()) - 1) * deviation() / std::sqrt(double(values.size()));
    return {mean() - half, mean() + half};
  }
};

std::vector<VoteRow> impairmentRows(const Votes& all, const std::vector<std::size_t>& without) {
  std::map<std::pair<std::size_t, std::size_t>, Sample> ofState;
  std::map<std::size_t, std::map<std::size_t, Sample>> ofTest;  // by viewer
  for (const auto& [viewer, state, reference, test, vote] : all.votes) {
    if (std::ranges::binary_search(without, viewer)) continue;
    ofState[{state, test}].values.push_back(vote);
    ofTest[test][viewer].values.push_back(vote);
  }
  std::vector<VoteRow> rows;
  const auto add = [&](const std::string& state, std::size_t test, const Sample& sample) {
    rows.push_back({state, all.contents[test], sample.values.size(), sample.mean(),
                    sample.interval(), unknownFigure});
  };
  for (const auto& [at, sample] : ofState) add(all.states[at.first], at.second, sample);
  for (const auto& [test, viewers] : ofTest) {
    Sample means;
    for (const auto& [viewer, sample] : viewers) means.values.push_back(sample.mean());
    add("all states", test, means);
  }
  return rows;
}

/// Adds a state's rows, or those over all states if there is none.
void addPairs(const Votes& all, const std::size_t* state, std::vector<VoteRow>& rows) {
  const std::size_t n = all.contents.size();
  std::vector<std::vector<double>> wins(all.viewers.size(), std::vector<double>(n * n));
  std::vector<double> sums(n * n);
  std::vector<std::size_t> counts(n);
  for (const auto& [viewer, of, first, second, vote] : all.votes) {
    if (state != nullptr && of != *state) continue;
    const double share = vote == 1 ? 1 : vote == 2 ? 0 : 0.5;
    for (std::vector<double>* to : {&wins[viewer], &sums}) {
      (*to)[first * n + second] += share;
      (*to)[second * n + first] += 1 - share;
    }
    ++counts[first];
    ++counts[second];
  }
  std::erase_if(wins, [](const auto& one) {
    return std::ranges::all_of(one, [](double value) { return value == 0; });
  });
  const auto strengths = [n](const std::vector<double>& of) { return bradleyTerry(of, n); };
  const std::vector<double> found = strengths(sums);
  const std::vector<Interval> intervals =
      wins.size() < 2 ? std::vector<Interval>(n, {unknownFigure, unknownFigure})
                      : bootstrap(wins, strengths, {.resamples = 2000});
  for (std::size_t k = 0; k < n; ++k)
    if (counts[k] > 0)
      rows.push_back({state != nullptr ? all.states[*state] : "all states", all.contents[k],
                      counts[k], unknownFigure, intervals[k], found[k]});
}

/// Solves a system of a positive definite matrix by elimination.
std::vector<double> solved(std::vector<double> matrix, std::vector<double> right) {
  const std::size_t n = right.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = matrix[i * n + k] / matrix[k * n + k];
      for (std::size_t j = k; j < n; ++j) matrix[i * n + j] -= factor * matrix[k * n + j];
      right[i] -= factor * right[k];
    }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) right[k] -= matrix[k * n + j] * right[j];
    right[k] /= matrix[k * n + k];
  }
  return right;
}

}  // namespace

double studentQuantile(int degrees) {
  double low = 0;
  double high = 13;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (studentWithin(middle, degrees) < 0.95 ? low : high) = middle;
  }
  return (low + high) / 2;
}

std::vector<std::size_t> screenedViewers(const Votes& votes) {
  if (votes.arePairs) return {};
  std::map<std::pair<std::size_t, std::size_t>, Sample> questions;
  for (const Vote& one : votes.votes) questions[{one.state, one.second}].values.push_back(one.vote);
  std::map<std::pair<std::size_t, std::size_t>, Interval> usual;
  for (const auto& [question, sample] : questions) {
    const double mean = sample.mean();
    const double spread = sample.moment(2, mean);
    const double kurtosis = sample.moment(4, mean) / (spread * spread);
    const bool isNormal = kurtosis >= 2 && kurtosis <= 4;
    const double most = (isNormal ? 2 : std::sqrt(20.0)) * sample.deviation();
    if (spread > 0) usual[question] = {mean - most, mean + most};
  }
  std::vector<std::size_t> above(votes.viewers.size());
  std::vector<std::size_t> below(votes.viewers.size());
  std::vector<std::size_t> all(votes.viewers.size());
  for (const Vote& one : votes.votes) {
    ++all[one.viewer];
    const auto limits = usual.find({one.state, one.second});
    if (limits == usual.end()) continue;
    if (one.vote >= limits->second.high) ++above[one.viewer];
    if (one.vote <= limits->second.low) ++below[one.viewer];
  }
  std::vector<std::size_t> screened;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto [p, q] = std::pair(double(above[k]), double(below[k]));
    if (p + q > 0.05 * double(all[k]) && std::abs(p - q) < 0.3 * (p + q)) screened.push_back(k);
  }
  return screened;
}

std::vector<double> bradleyTerry(const std::vector<double>& wins, std::size_t contents) {
  const auto at = [contents](std::size_t a, std::size_t b) { return a * contents + b; };
  const auto compared = [&](std::size_t a, std::size_t b) {
    const double both = a == b ? 0 : wins[at(a, b)] + wins[at(b, a)];
    return both > 0 ? both + 1 : 0;
  };
  std::vector<std::size_t> known{0};
  for (std::size_t k = 0; k < known.size(); ++k)
    for (std::size_t b = 0; b < contents; ++b)
      if (compared(known[k], b) > 0 && std::ranges::find(known, b) == known.end())
        known.push_back(b);
  const std::size_t n = known.size();
  std::vector<double> strengths(n);
  double change = 1;
  for (int k = 0; k < 200 && change > 1e-10; ++k) {
    // The slope of the likelihood, and its curvature plus one everywhere, which fixes the mean.
    std::vector<double> slope(n);
    std::vector<double> curvature(n * n, 1);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        const double count = compared(known[i], known[j]);
        if (!(count > 0)) continue;
        const double share = 1 / (1 + std::exp(strengths[j] - strengths[i]));
        slope[i] += wins[at(known[i], known[j])] + 0.5 - count * share;
        curvature[i * n + i] += count * share * (1 - share);
        curvature[i * n + j] -= count * share * (1 - share);
      }
    const std::vector<double> step = solved(std::move(curvature), std::move(slope));
    change = std::abs(*std::ranges::max_element(step, {}, [](double s) { return std::abs(s); }));
    // Far from the greatest likelihood the curvature is low, and a whole step is too long.
    const double part = std::min(1.0, 1 / change);
    for (std::size_t i = 0; i < n; ++i) strengths[i] += part * step[i];
  }
  std::vector<double> result(contents, unknownFigure);
  for (std::size_t i = 0; i < n; ++i) result[known[i]] = strengths[i];
  return result;
}

std::vector<VoteRow> voteRows(const Votes& votes) {
  if (!votes.arePairs) return impairmentRows(votes, screenedViewers(votes));
  std::vector<VoteRow> rows;
  for (std::size_t state = 0; state < votes.states.size(); ++state) addPairs(votes, &state, rows);
  addPairs(votes, nullptr, rows);
  return rows;
}

std::string votesCsv(const std::vector<VoteRow>& rows) {
  Table table{{"state", "test", "n", "mos", "low", "high", "bt"}};
  for (const VoteRow& row : rows)
    table.push_back({row.state, row.test, std::to_string(row.n), numberCell(row.mos),
                     numberCell(row.interval.low), numberCell(row.interval.high),
                     numberCell(row.strength)});
  return csvText(table);
}

}  // namespace hogelscope
