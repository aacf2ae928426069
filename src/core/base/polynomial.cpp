// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/polynomial.h"

#include "core/base/bisect.h"

namespace hogelscope {

namespace {

double valueOf(const std::vector<double>& polynomial, double x) {
  double value = 0;
  for (std::size_t k = polynomial.size(); k > 0; --k) value = value * x + polynomial[k - 1];
  return value;
}

}  // namespace

/// Between two neighbouring places where the derivative changes its sign there is one at most.
std::vector<double> signChanges(const std::vector<double>& polynomial, double end) {
  constexpr int untilRounding = 200;
  if (polynomial.size() < 2) return {};
  std::vector<double> slope;
  for (std::size_t k = 1; k < polynomial.size(); ++k) slope.push_back(double(k) * polynomial[k]);
  std::vector<double> ends = signChanges(slope, end);
  ends.push_back(end);
  std::vector<double> changes;
  double from = 0;
  for (const double to : ends) {
    const bool isPositive = valueOf(polynomial, from) > 0;
    const auto isBefore = [&](double x) { return (valueOf(polynomial, x) > 0) == isPositive; };
    if (!isBefore(to)) changes.push_back(bisect({from, to}, untilRounding, isBefore).inside);
    from = to;
  }
  return changes;
}

}  // namespace hogelscope
