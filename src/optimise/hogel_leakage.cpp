// SPDX-License-Identifier: BSD-3-Clause
#include "optimise/hogel_leakage.h"

#include <algorithm>
#include <numeric>
#include <type_traits>

#include "core/base/multiversioned.h"

namespace hogelscope {

namespace {

/// Sums 2·Reach + 1 rows, each times a number, or a row's neighbours, each times a row of numbers:
/// the order of the sum is that of the taps. With a reach known in advance GCC keeps the sum in a
/// register.
template <int Reach>
MULTIVERSIONED void sumRows(double* __restrict to, const double* const* rows, const double* weights,
                            int count) {
  for (int u = 0; u < count; ++u) {
    double sum = 0;
    for (int tap = 0; tap <= 2 * Reach; ++tap) sum += weights[tap] * rows[tap][u];
    to[u] = sum;
  }
}
template <int Reach>
MULTIVERSIONED void sumNeighbours(double* __restrict to, const double* __restrict from,
                                  const double* __restrict weights, int count) {
  for (int u = 0; u < count; ++u) {
    double sum = 0;
    for (int tap = 0; tap <= 2 * Reach; ++tap)
      sum += weights[tap * count + u] * from[u + tap - Reach];
    to[u] = sum;
  }
}

/// The same for any reach.
MULTIVERSIONED void addRow(double* __restrict to, const double* __restrict from, double weight,
                           int count) {
  for (int u = 0; u < count; ++u) to[u] += weight * from[u];
}
MULTIVERSIONED void addWeighted(double* __restrict to, const double* __restrict from,
                                const double* __restrict weights, int count) {
  for (int u = 0; u < count; ++u) to[u] += weights[u] * from[u];
}
void sumRowsOfAny(int reach, double* to, const double* const* rows, const double* weights,
                  int count) {
  std::fill_n(to, count, 0.0);
  for (int tap = 0; tap <= 2 * reach; ++tap) addRow(to, rows[tap], weights[tap], count);
}
void sumNeighboursOfAny(int reach, double* to, const double* from, const double* weights,
                        int count) {
  std::fill_n(to, count, 0.0);
  for (int tap = 0; tap <= 2 * reach; ++tap)
    addWeighted(to, from + tap - reach, weights + std::ptrdiff_t(tap) * count, count);
}

/// Calls a function with the reach as a constant, if it is a usual one; else with 0.
template <class Use>
void withReach(int reach, const Use& use) {
  switch (reach) {
    case 1:
      return use(std::integral_constant<int, 1>());
    case 2:
      return use(std::integral_constant<int, 2>());
    case 3:
      return use(std::integral_constant<int, 3>());
    case 4:
      return use(std::integral_constant<int, 4>());
    default:
      return use(std::integral_constant<int, 0>());
  }
}

using Weights = std::span<const double> (AxisLeakage::*)(int tap) const;

void applyDown(const AxisLeakage& down, Weights of, const HogelLeakage::Plane& x,
               HogelLeakage::Plane& result) {
  const int reach = down.reach();
  std::vector<const double*> rows(std::size_t(2 * reach) + 1);
  std::vector<double> weights(rows.size());
  withReach(reach, [&](auto known) {
    for (int v = 0; v < x.dv; ++v) {
      for (int tap = -reach; tap <= reach; ++tap) {  // a row outside has no weight
        rows[std::size_t(tap + reach)] = x.row(std::clamp(v + tap, 0, x.dv - 1));
        weights[std::size_t(tap + reach)] = (down.*of)(tap)[std::size_t(v)];
      }
      if constexpr (known.value > 0)
        sumRows<known.value>(result.row(v), rows.data(), weights.data(), x.du);
      else
        sumRowsOfAny(reach, result.row(v), rows.data(), weights.data(), x.du);
    }
  });
}

void applyAcross(const AxisLeakage& across, Weights of, const HogelLeakage::Plane& x,
                 HogelLeakage::Plane& result) {
  const int reach = across.reach();
  const double* const weights = (across.*of)(-reach).data();
  withReach(reach, [&](auto known) {
    for (int v = 0; v < x.dv; ++v)
      if constexpr (known.value > 0)
        sumNeighbours<known.value>(result.row(v), x.row(v), weights, x.du);
      else
        sumNeighboursOfAny(reach, result.row(v), x.row(v), weights, x.du);
  });
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
  applyDown(m_v, &AxisLeakage::weights, x, work);
  applyAcross(m_u, &AxisLeakage::weights, work, result);
}

void HogelLeakage::applyTransposed(const Plane& x, Plane& result, Plane& work) const {
  applyDown(m_v, &AxisLeakage::transposed, x, work);
  applyAcross(m_u, &AxisLeakage::transposed, work, result);
}

}  // namespace hogelscope
