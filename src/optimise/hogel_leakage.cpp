// SPDX-License-Identifier: BSD-3-Clause
#include "optimise/hogel_leakage.h"

#include <algorithm>
#include <numeric>

#include "core/base/multiversioned.h"

namespace hogelscope {

namespace {

/// Adds the rows of a plane times the weights of an axis, row by row.
MULTIVERSIONED void addRow(double* __restrict to, const double* __restrict from, double weight,
                           int count) {
  for (int u = 0; u < count; ++u) to[u] += weight * from[u];
}

MULTIVERSIONED void addWeighted(double* __restrict to, const double* __restrict from,
                                const double* __restrict weights, int count) {
  for (int u = 0; u < count; ++u) to[u] += weights[u] * from[u];
}

using Weights = std::span<const double> (AxisLeakage::*)(int tap) const;

void applyBoth(const AxisLeakage& down, const AxisLeakage& across, Weights of,
               const HogelLeakage::Plane& x, HogelLeakage::Plane& result,
               HogelLeakage::Plane& work) {
  for (int v = 0; v < x.dv; ++v) {
    double* const to = work.row(v);
    std::fill_n(to, x.du, 0.0);
    for (int tap = -down.reach(); tap <= down.reach(); ++tap)
      if (v + tap >= 0 && v + tap < x.dv)
        addRow(to, x.row(v + tap), (down.*of)(tap)[std::size_t(v)], x.du);
  }
  for (int v = 0; v < x.dv; ++v) {
    double* const to = result.row(v);
    std::fill_n(to, x.du, 0.0);
    for (int tap = -across.reach(); tap <= across.reach(); ++tap)
      addWeighted(to, work.row(v) + tap, (across.*of)(tap).data(), x.du);
  }
}

}  // namespace

AxisLeakage::AxisLeakage(const PsfParams& psf, int directions)
    : m_directions(directions), m_reach(psf.windowSize / 2) {
  const std::vector<double> gauss =
      m_reach > 0 ? gaussianWeights(psf.sigma, m_reach) : std::vector<double>{1};
  const double whole = std::accumulate(gauss.begin(), gauss.end(), 0.0);
  const std::size_t taps = gauss.size();
  m_weights.assign(taps * std::size_t(directions), 0);
  m_transposed = m_weights;
  const auto at = [&](std::vector<double>& all, int tap, int k) -> double& {
    return all[std::size_t(tap + m_reach) * std::size_t(directions) + std::size_t(k)];
  };
  for (int k = 0; k < directions; ++k) {
    double inside = 0;
    for (int tap = -m_reach; tap <= m_reach; ++tap) {
      const double weight = gauss[std::size_t(tap + m_reach)];
      const int lit = std::clamp(k + tap, 0, directions - 1);
      if (lit != k + tap && psf.border != PsfBorder::clamp) continue;
      inside += weight;
      at(m_weights, lit - k, k) += weight;
    }
    const double sum = psf.border == PsfBorder::renormalise ? inside : whole;
    for (int tap = -m_reach; tap <= m_reach; ++tap) {
      double& weight = at(m_weights, tap, k);
      weight /= sum;
      if (k + tap >= 0 && k + tap < directions) at(m_transposed, -tap, k + tap) = weight;
    }
  }
}

void HogelLeakage::apply(const Plane& x, Plane& result, Plane& work) const {
  applyBoth(m_v, m_u, &AxisLeakage::weights, x, result, work);
}

void HogelLeakage::applyTransposed(const Plane& x, Plane& result, Plane& work) const {
  applyBoth(m_v, m_u, &AxisLeakage::transposed, x, result, work);
}

}  // namespace hogelscope
