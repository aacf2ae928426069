// SPDX-License-Identifier: BSD-3-Clause
#include "io/twin/direction_fit.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace hogelscope {

namespace {

constexpr std::size_t fewestDirections = 3;

/// The exponents of u and v.
using Term = std::pair<int, int>;

/// Returns the terms of a degree that differ on so many columns and rows: the square of an index
/// that has two values is linear.
std::vector<Term> termsOf(int degree, const std::array<int, 2>& size) {
  std::vector<Term> terms;
  for (int a = 0; a <= std::min(degree, size[0] - 1); ++a)
    for (int b = 0; b <= std::min(degree - a, size[1] - 1); ++b) terms.emplace_back(a, b);
  return terms;
}

/// Returns an index as -1 … 1, which keeps the powers apart.
double scaledIndex(int index, int count) {
  return count > 1 ? 2.0 * index / (count - 1) - 1 : 0;
}

/// Calls visit(u, v) for the directions that the table has, or for the others.
template <class Visit>
void eachDirection(const MeasuredDirections& table, bool isGiven, const Visit& visit) {
  for (int v = 0; v < table.size[1]; ++v)
    for (int u = 0; u < table.size[0]; ++u)
      if (table.isGiven[table.at(u, v)] == isGiven) visit(u, v);
}

class Polynomial {
 public:
  /// Fits one to each list of the table's values. None if the given ones do not determine it.
  static std::optional<Polynomial> fitted(const MeasuredDirections& table, int degree, int given) {
    Polynomial polynomial(table, degree);
    const int count = int(polynomial.m_terms.size());
    if (given < count) return std::nullopt;
    cv::Mat_<double> powers(given, count);
    cv::Mat_<double> values(given, int(table.values.size()));
    int row = 0;
    eachDirection(table, true, [&](int u, int v) {
      polynomial.setPowers(u, v, powers[row]);
      for (int k = 0; k < values.cols; ++k)
        values(row, k) = table.values[std::size_t(k)][table.at(u, v)];
      ++row;
    });
    const cv::SVD solver(powers);
    constexpr double least = 1e-6;  // of the largest: else errors of the values become enormous
    const auto* strengths = solver.w.ptr<double>();
    if (!(strengths[count - 1] > least * strengths[0])) return std::nullopt;
    solver.backSubst(values, polynomial.m_factors);
    polynomial.m_error = cv::norm(cv::Mat(powers * polynomial.m_factors - values).colRange(0, 2)) /
                         std::sqrt(double(given));
    return polynomial;
  }

  [[nodiscard]] double error() const { return m_error; }

  /// Returns the values of a direction, one for each list.
  [[nodiscard]] std::vector<double> at(int u, int v) const {
    std::vector<double> powers(m_terms.size());
    setPowers(u, v, powers.data());
    std::vector<double> sums(std::size_t(m_factors.cols));
    for (std::size_t k = 0; k < sums.size(); ++k)
      for (std::size_t term = 0; term < m_terms.size(); ++term)
        sums[k] += powers[term] * m_factors(int(term), int(k));
    return sums;
  }

 private:
  Polynomial(const MeasuredDirections& table, int degree)
      : m_size(table.size), m_terms(termsOf(degree, table.size)) {}

  void setPowers(int u, int v, double* powers) const {
    for (const auto& [a, b] : m_terms)
      *powers++ = std::pow(scaledIndex(u, m_size[0]), a) * std::pow(scaledIndex(v, m_size[1]), b);
  }

  std::array<int, 2> m_size;
  std::vector<Term> m_terms;
  cv::Mat_<double> m_factors;  ///< a row for each term, a column for each list of values
  double m_error = 0;
};

[[noreturn]] void refuse(const DirectionFit& fit) {
  const std::string has = "has " + std::to_string(fit.given) + " of " +
                          std::to_string(fit.given + fit.fitted) + " directions, ";
  if (fit.given < fewestDirections)
    throw InputError("", has + "from which the others cannot be found; it needs 3 at least");
  throw InputError("", has + "which are too much in line for the others to be found");
}

}  // namespace

DirectionFit fitDirections(MeasuredDirections& table) {
  DirectionFit fit;
  fit.given = std::size_t(std::ranges::count(table.isGiven, true));
  fit.fitted = table.isGiven.size() - fit.given;
  if (fit.fitted == 0) return fit;
  std::optional<Polynomial> polynomial;
  for (fit.degree = 3; fit.degree > 0 && fit.given >= fewestDirections; --fit.degree) {
    polynomial = Polynomial::fitted(table, fit.degree, int(fit.given));
    if (polynomial) break;
  }
  if (!polynomial) refuse(fit);
  fit.error = polynomial->error();
  eachDirection(table, false, [&](int u, int v) {
    const std::vector<double> values = polynomial->at(u, v);
    for (std::size_t k = 0; k < values.size(); ++k)
      table.values[k][table.at(u, v)] = k < 2 ? values[k] : std::max(0.0, values[k]);
  });
  return fit;
}

}  // namespace hogelscope
