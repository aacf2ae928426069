// SPDX-License-Identifier: BSD-3-Clause
// The content of a hogel whose light comes closest to what it should look like, for one colour:
// box-constrained least squares by accelerated projected gradients (Beck and Teboulle, SIAM J.
// Imaging Sci. 2, 2009, with the restart of O'Donoghue and Candès, Found. Comput. Math. 15, 2015),
// with a proven bound (docs/formulas.md, Optimised content).
#pragma once

#include <vector>

#include "optimise/hogel_leakage.h"

namespace hogelscope {

/// Says what texels should look like under one leakage: f = Σ W_k ((L x)_k − t_k)².
struct HogelTerm {
  const HogelLeakage* leakage = nullptr;
  HogelLeakage::Plane weights;  ///< W ≥ 0
  HogelLeakage::Plane targets;  ///< t, usually 0 … 1
};

struct SolverLimits {
  int iterations = 100;
  /// Stops when f falls by less than so many decibels in ten iterations; 0 never stops.
  double tolerance = 0.01;
};

struct HogelSolution {
  double before = 0;  ///< f of the start
  double after = 0;   ///< f of the content
  double bound = 0;   ///< f of no content with values 0 … `most` is less
  double weight = 0;  ///< Σ W of all terms
  int iterations = 0;
};

/// Solves hogels of one size one after the other, with one memory.
class HogelSolver {
 public:
  /// `margin` is at least the reach of all leakages.
  HogelSolver(int du, int dv, int margin);

  /// Minimises the sum of the terms' f over 0 ≤ x ≤ `most`; `x` is the start, and the result. The
  /// result depends on nothing but the arguments.
  HogelSolution solve(const std::vector<HogelTerm>& terms, const HogelLeakage::Plane& most,
                      const SolverLimits& limits, HogelLeakage::Plane& x);

 private:
  void addBack(const HogelTerm& term, HogelLeakage::Plane& sum);
  void setGradient(const std::vector<HogelTerm>& terms, const HogelLeakage::Plane& x);
  double setSteps(const std::vector<HogelTerm>& terms);
  double errorAt(const std::vector<HogelTerm>& terms, const HogelLeakage::Plane& x);
  double boundAt(const std::vector<HogelTerm>& terms, const HogelLeakage::Plane& most,
                 const HogelLeakage::Plane& x);

  HogelLeakage::Plane m_seen, m_residual, m_back, m_gradient, m_step, m_point, m_next, m_work;
};

}  // namespace hogelscope
