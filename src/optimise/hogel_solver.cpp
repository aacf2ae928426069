// SPDX-License-Identifier: BSD-3-Clause
#include "optimise/hogel_solver.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

namespace {

using Plane = HogelLeakage::Plane;

constexpr double leastStep = 1e-9;  // of texels that no weight asks for
constexpr int between = 10;         // iterations between two looks at f

/// Calls a function with the values of rows of planes at the same texel.
template <class Function, class... Planes>
void forEach(Function function, Plane& first, Planes&... others) {
  for (int v = 0; v < first.dv; ++v)
    [&](double* a, auto*... rest) {
      for (int u = 0; u < first.du; ++u) function(a[u], rest[u]...);
    }(first.row(v), others.row(v)...);
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
    forEach([&](double seen, double weight,
                double target) { error += weight * (seen - target) * (seen - target); },
            m_seen, term.weights, term.targets);
  }
  return error;
}

double HogelSolver::boundAt(const std::vector<HogelTerm>& terms, const Plane& most,
                            const Plane& x) {
  // f* ≥ (⟨r, b⟩ − Σ most · max(0, h))² / |r|², r = √W (t − L x), h = Lᵀ √W r, b = √W t.
  double product = 0, squares = 0, reach = 0;
  std::ranges::fill(m_gradient.values, 0);
  for (const HogelTerm& term : terms) {
    term.leakage->apply(x, m_seen, m_work);
    forEach(
        [&](double& residual, double seen, double weight, double target) {
          residual = weight * (target - seen);
          product += residual * target;
          squares += residual * (target - seen);
        },
        m_residual, m_seen, term.weights, term.targets);
    term.leakage->applyTransposed(m_residual, m_back, m_work);
    forEach([](double& sum, double back) { sum += back; }, m_gradient, m_back);
  }
  forEach([&](double h, double limit) { reach += limit * std::max(0.0, h); }, m_gradient, most);
  const double excess = std::max(0.0, product - reach);
  return squares > 0 ? excess * excess / squares : 0;
}

HogelSolution HogelSolver::solve(const std::vector<HogelTerm>& terms, const Plane& most,
                                 const SolverLimits& limits, Plane& x) {
  // A step of its own for each texel, 1/(Lᵀ W L 1): no entry is negative, so that
  // diag(Lᵀ W L 1) − Lᵀ W L is positive semidefinite.
  std::ranges::fill(m_step.values, 0);
  double weightSum = 0;
  for (const HogelTerm& term : terms) {
    forEach([](double& one) { one = 1; }, m_point);
    term.leakage->apply(m_point, m_seen, m_work);
    forEach(
        [&](double& residual, double seen, double weight) {
          residual = weight * seen;
          weightSum += weight;
        },
        m_residual, m_seen, term.weights);
    term.leakage->applyTransposed(m_residual, m_back, m_work);
    forEach([](double& sum, double back) { sum += back; }, m_step, m_back);
  }
  forEach([](double& step) { step = 1 / std::max(step, leastStep); }, m_step);
  forEach([](double& value, double limit) { value = std::clamp(value, 0.0, limit); }, x, most);

  HogelSolution solution;
  solution.before = errorAt(terms, x);
  // Differences below a tenth of a code value are none.
  constexpr double noticed = 0.1 / 255;
  const double floor = weightSum * noticed * noticed;
  const double fall = std::pow(10, -limits.tolerance / 10);
  double error = solution.before;
  m_point = x;
  double momentum = 1;
  while (solution.iterations < limits.iterations) {
    std::ranges::fill(m_gradient.values, 0);
    for (const HogelTerm& term : terms) {
      term.leakage->apply(m_point, m_seen, m_work);
      forEach([](double& residual, double seen, double weight,
                 double target) { residual = weight * (seen - target); },
              m_residual, m_seen, term.weights, term.targets);
      term.leakage->applyTransposed(m_residual, m_back, m_work);
      forEach([](double& sum, double back) { sum += back; }, m_gradient, m_back);
    }
    double uphill = 0;
    forEach(
        [&](double& next, double point, double gradient, double step, double limit, double now) {
          next = std::clamp(point - step * gradient, 0.0, limit);
          uphill += (point - next) * (next - now) / step;
        },
        m_next, m_point, m_gradient, m_step, most, x);
    const double nextMomentum = uphill > 0 ? 1 : (1 + std::sqrt(1 + 4 * momentum * momentum)) / 2;
    const double beyond = uphill > 0 ? 0 : (momentum - 1) / nextMomentum;
    forEach(
        [&](double& now, double& point, double next) {
          point = next + beyond * (next - now);
          now = next;
        },
        x, m_point, m_next);
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
