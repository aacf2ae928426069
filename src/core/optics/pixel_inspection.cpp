// SPDX-License-Identifier: BSD-3-Clause
#include "core/optics/pixel_inspection.h"

#include <algorithm>
#include <numeric>

namespace hogelscope {

PixelFate fateOf(const PixelTrace& trace) {
  if (!trace.colour) return trace.end == RayEnd::noRay ? PixelFate::noRay : PixelFate::outside;
  const auto [r, g, b] = *trace.colour;
  const bool isBlack = quantised(r) == 0 && quantised(g) == 0 && quantised(b) == 0;
  return isBlack ? PixelFate::dark : PixelFate::lit;
}

/// Uses the weights of Psf::leaked().
std::vector<double> psfKernelAt(const PsfParams& params, const LightFieldSize& size, int u, int v) {
  const Psf psf(params);
  const int reach = (params.windowSize - 1) / 2;
  const auto side = static_cast<std::size_t>(params.windowSize);
  std::vector<double> weights(side * side);
  double lost = 0;
  auto weight = psf.weights().begin();
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x, ++weight) {
      const int tapU = std::clamp(u + x, 0, size.du - 1);
      const int tapV = std::clamp(v + y, 0, size.dv - 1);
      const bool isInside = tapU == u + x && tapV == v + y;
      if (isInside || params.border == PsfBorder::clamp)
        weights[std::size_t(tapV - v + reach) * side + std::size_t(tapU - u + reach)] += *weight;
      else if (params.border == PsfBorder::black)
        lost += *weight;
    }
  const double total = std::accumulate(weights.begin(), weights.end(), lost);
  for (double& each : weights) each /= total;
  return weights;
}

Image hogelImage(const LightFieldSource& lightField, int i, int j) {
  const auto small = lightField.overview();
  const int smallI = i * small->size().nx / lightField.size().nx;
  const int smallJ = j * small->size().ny / lightField.size().ny;
  return hogelTexels(*small, smallI, smallJ);
}

}  // namespace hogelscope
