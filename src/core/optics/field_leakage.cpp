// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/field_leakage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hogelscope {

namespace {

/// Returns sinc²(k step) for k = -reach … reach, as parts of its sum. What is farther than 64 units
/// of the pattern is 0.2 % of the light; farther than `most` directions a hogel has none.
std::vector<double> diffractionPattern(double step, int most) {
  const int reach = std::min(static_cast<int>(std::ceil(std::min(64 / step, 1e6))), most);
  std::vector<double> pattern;
  double sum = 0;
  for (int k = -reach; k <= reach; ++k) {
    const double x = std::numbers::pi * k * step;
    pattern.push_back(k == 0 ? 1 : std::pow(std::sin(x) / x, 2));
    sum += pattern.back();
  }
  for (double& weight : pattern) weight /= sum;
  return pattern;
}

std::vector<double> convolved(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> sums(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k) sums[i + k] += a[i] * b[k];
  return sums;
}

int reachOf(const std::vector<double>& weights) {
  return static_cast<int>(weights.size() / 2);
}

}  // namespace

bool FieldLeakage::isNeeded(const Twin* twin, const PsfParams& psf) {
  return twin != nullptr && (twin->hasKernels() || twin->hasDiffraction() ||
                             (psf.windowSize > 1 && twin->leaksOverField()));
}

FieldLeakage::FieldLeakage(const Twin& twin, const PsfParams& psf)
    : m_twin(twin), m_psf(psf), m_size(twin.size()) {
  if (twin.hasKernels()) {
    m_reach = twin.kernelReach();
    return;
  }
  int widest = 0;
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t c = 0; c < 3; ++c) {
      const double step = twin.diffractionStep(axis, c);
      auto& pattern = m_diffraction[axis][c];
      const int most = (axis == 0 ? m_size.du : m_size.dv) - 1;
      pattern = step > 0 ? diffractionPattern(step, most) : std::vector<double>{1};
      widest = std::max(widest, reachOf(pattern));
    }
  m_reach = (psf.windowSize - 1) / 2 + widest;
}

std::vector<double> FieldLeakage::alongAxis(double sigma, std::size_t axis,
                                            std::size_t channel) const {
  const std::vector<double> own =
      convolved(gaussianWeights(sigma, (m_psf.windowSize - 1) / 2), m_diffraction[axis][channel]);
  std::vector<double> weights(2 * std::size_t(m_reach) + 1);
  std::ranges::copy(own, weights.begin() + (m_reach - reachOf(own)));
  return weights;
}

std::vector<double> FieldLeakage::weights(int u, int v, std::size_t channel, const TapRange& across,
                                          const TapRange& down) const {
  if (m_twin.hasKernels()) return m_twin.kernelAt(u, v, channel, across, down);
  const double sigma = m_twin.sigmaAt(u, v, m_psf.sigma);
  const std::vector<double> ofX = alongAxis(sigma, 0, channel);
  const std::vector<double> ofY = alongAxis(sigma, 1, channel);
  std::vector<double> product;
  for (int y = down.first; y <= down.last; ++y)
    for (int x = across.first; x <= across.last; ++x)
      product.push_back(ofY[std::size_t(y + m_reach)] * ofX[std::size_t(x + m_reach)]);
  return product;
}

}  // namespace hogelscope
