// SPDX-License-Identifier: BSD-3-Clause
#include "optimise/hogel_solver.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/multiversioned.h"

namespace hogelscope {

namespace {

using Plane = HogelLeakage::Plane;

constexpr double leastStep = 1e-9;  // of texels that no weight asks for
constexpr int between = 10;         // iterations between two looks at f

// Planes are visited with their margins, where weights, limits and values are 0. Sums have eight
// parts, so that they are vectorised and the same for vectors of any length.
constexpr std::size_t lanes = 8;
using Lanes = std::array<double, lanes>;

double sumOf(const Lanes& parts) {
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

/// r = W (s − t).
MULTIVERSIONED void weighResiduals(const double* __restrict weights, const double* __restrict seen,
                                   const double* __restrict targets, std::size_t count,
                                   double* __restrict residuals) {
  for (std::size_t k = 0; k < count; ++k) residuals[k] = weights[k] * (seen[k] - targets[k]);
}

MULTIVERSIONED void multiply(const double* __restrict a, const double* __restrict b,
                             std::size_t count, double* __restrict product) {
  for (std::size_t k = 0; k < count; ++k) product[k] = a[k] * b[k];
}

MULTIVERSIONED void add(const double* __restrict values, std::size_t count,
                        double* __restrict sum) {
  for (std::size_t k = 0; k < count; ++k) sum[k] += values[k];
}

/// Adds a piece's products and gives a partial sum of each lane.
template <class Term>
double sumOfTerms(std::size_t count, const Term& term) {
  Lanes sum{};
  std::size_t k = 0;
  for (; k + lanes <= count; k += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) sum[lane] += term(k + lane);
  for (std::size_t lane = 0; k < count; ++k, ++lane) sum[lane] += term(k);
  return sumOf(sum);
}

/// Writes the projected step from `point`, and returns whether it goes uphill from `now`.
MULTIVERSIONED bool stepDown(const double* __restrict point, const double* __restrict gradient,
                             const double* __restrict steps, const double* __restrict most,
                             const double* __restrict now, std::size_t count,
                             double* __restrict next) {
  for (std::size_t k = 0; k < count; ++k)
    next[k] = std::min(std::max(point[k] - steps[k] * gradient[k], 0.0), most[k]);
  return sumOfTerms(count, [&](std::size_t k) {
           return (point[k] - next[k]) * (next[k] - now[k]) / steps[k];
         }) > 0;
}

/// Goes beyond the new values; these become those of now.
MULTIVERSIONED void goBeyond(const double* __restrict next, double beyond, std::size_t count,
                             double* __restrict now, double* __restrict point) {
  for (std::size_t k = 0; k < count; ++k) {
    point[k] = next[k] + beyond * (next[k] - now[k]);
    now[k] = next[k];
  }
}

}  // namespace

HogelSolver::HogelSolver(int du, int dv, int margin)
    : m_seen(du, dv, margin),
      m_residual(m_seen),
      m_back(m_seen),
      m_gradient(m_seen),
      m_step(m_seen),
      m_point(m_seen),
      m_next(m_seen),
      m_work(m_seen) {}

double HogelSolver::errorAt(const std::vector<HogelTerm>& terms, const Plane& x) {
  double error = 0;
  for (const HogelTerm& term : terms) {
    term.leakage->apply(x, m_seen, m_work);
    error += sumOfTerms(x.values.size(), [&](std::size_t k) {
      const double residual = m_seen.values[k] - term.targets.values[k];
      return term.weights.values[k] * residual * residual;
    });
  }
  return error;
}

void HogelSolver::addBack(const HogelTerm& term, Plane& sum) {
  term.leakage->applyTransposed(m_residual, m_back, m_work);
  add(m_back.values.data(), sum.values.size(), sum.values.data());
}

/// Writes half the gradient of f, Σ Lᵀ W (L x − t).
void HogelSolver::setGradient(const std::vector<HogelTerm>& terms, const Plane& x) {
  std::ranges::fill(m_gradient.values, 0);
  for (const HogelTerm& term : terms) {
    term.leakage->apply(x, m_seen, m_work);
    weighResiduals(term.weights.values.data(), m_seen.values.data(), term.targets.values.data(),
                   x.values.size(), m_residual.values.data());
    addBack(term, m_gradient);
  }
}

/// Writes a step of its own for each texel, 1/(Lᵀ W L 1): no entry is negative, so that
/// diag(Lᵀ W L 1) − Lᵀ W L is positive semidefinite. Returns Σ W.
double HogelSolver::setSteps(const std::vector<HogelTerm>& terms) {
  double weight = 0;
  for (int v = 0; v < m_point.dv; ++v) std::fill_n(m_point.row(v), m_point.du, 1.0);
  std::ranges::fill(m_step.values, 0);
  for (const HogelTerm& term : terms) {
    term.leakage->apply(m_point, m_seen, m_work);
    multiply(term.weights.values.data(), m_seen.values.data(), m_seen.values.size(),
             m_residual.values.data());
    addBack(term, m_step);
    weight +=
        sumOfTerms(m_step.values.size(), [&](std::size_t k) { return term.weights.values[k]; });
  }
  for (double& step : m_step.values) step = 1 / std::max(step, leastStep);
  return weight;
}

double HogelSolver::boundAt(const std::vector<HogelTerm>& terms, const Plane& most,
                            const Plane& x) {
  // f* ≥ (⟨r, b⟩ − Σ most · max(0, h))² / |r|², r = √W (t − L x), h = Lᵀ √W r, b = √W t.
  double product = 0, squares = 0;
  std::ranges::fill(m_gradient.values, 0);
  for (const HogelTerm& term : terms) {
    term.leakage->apply(x, m_seen, m_work);
    weighResiduals(term.weights.values.data(), term.targets.values.data(), m_seen.values.data(),
                   x.values.size(), m_residual.values.data());  // √W r
    const std::vector<double>& residuals = m_residual.values;
    product += sumOfTerms(residuals.size(),
                          [&](std::size_t k) { return residuals[k] * term.targets.values[k]; });
    squares += sumOfTerms(residuals.size(), [&](std::size_t k) {
      return residuals[k] * (term.targets.values[k] - m_seen.values[k]);
    });
    addBack(term, m_gradient);
  }
  const double reach = sumOfTerms(most.values.size(), [&](std::size_t k) {
    return most.values[k] * std::max(0.0, m_gradient.values[k]);
  });
  const double excess = std::max(0.0, product - reach);
  return squares > 0 ? excess * excess / squares : 0;
}

HogelSolution HogelSolver::solve(const std::vector<HogelTerm>& terms, const Plane& most,
                                 const SolverLimits& limits, Plane& x) {
  const std::size_t count = x.values.size();
  HogelSolution solution;
  solution.weight = setSteps(terms);
  for (std::size_t k = 0; k < count; ++k)
    x.values[k] = std::clamp(x.values[k], 0.0, most.values[k]);
  solution.before = errorAt(terms, x);
  // Differences below a tenth of a code value are none.
  constexpr double noticed = 0.1 / 255;
  const double floor = solution.weight * noticed * noticed;
  const double fall = std::pow(10, -limits.tolerance / 10);
  double error = solution.before;
  m_point = x;
  double momentum = 1;
  while (solution.iterations < limits.iterations) {
    setGradient(terms, m_point);
    const bool isUphill =
        stepDown(m_point.values.data(), m_gradient.values.data(), m_step.values.data(),
                 most.values.data(), x.values.data(), count, m_next.values.data());
    const double nextMomentum = isUphill ? 1 : (1 + std::sqrt(1 + 4 * momentum * momentum)) / 2;
    const double beyond = isUphill ? 0 : (momentum - 1) / nextMomentum;
    goBeyond(m_next.values.data(), beyond, count, x.values.data(), m_point.values.data());
    momentum = nextMomentum;
    ++solution.iterations;
    if (solution.iterations % between != 0 || limits.tolerance == 0) continue;
    const double now = errorAt(terms, x);
    const bool isDone = now + floor > fall * (error + floor);
    error = now;
    if (isDone) break;
  }
  solution.after = errorAt(terms, x);
  solution.bound = std::min(boundAt(terms, most, x), solution.after);
  return solution;
}

}  // namespace hogelscope
