// SPDX-License-Identifier: BSD-3-Clause
// A unit's light: dead parts, leakage over the field, gains; written to be read beside
// docs/formulas.md, Twin.
#include "core/panel/twin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

void Twin::prepareDead() {
  const auto [nx, ny] = m_design.hogels;
  const auto [du, dv] = m_design.directions;
  const auto cells = [](int hogels, int directions) {
    return std::size_t(hogels) * std::size_t(directions);
  };
  m_deadHogels.resize(cells(nx, ny));
  m_deadColumns.resize(cells(nx, du));
  m_deadRows.resize(cells(ny, dv));
  const auto mark = [](std::vector<std::uint8_t>& marks, int at, const char* name,
                       const char* what) {
    if (std::size_t(at) >= marks.size())
      throw InputError(std::string("twin.dead.") + name,
                       "has " + std::to_string(at) + ", but the hogel image has " + what + " 0 … " +
                           std::to_string(marks.size() - 1));
    marks[std::size_t(at)] = 1;
  };
  for (const int column : m_params.dead.columns) mark(m_deadColumns, column, "columns", "columns");
  for (const int row : m_params.dead.rows) mark(m_deadRows, row, "rows", "rows");
  for (const auto& [i, j] : m_params.dead.hogels) {
    if (i >= nx || j >= ny)
      throw InputError("twin.dead.hogels", "has [" + std::to_string(i) + ", " + std::to_string(j) +
                                               "], but the display has " + std::to_string(nx) +
                                               " × " + std::to_string(ny) + " hogels");
    m_deadHogels[hogelAt(i, j)] = 1;
  }
}

void Twin::checkKernels() const {
  const TwinPlane& image = m_maps.kernels[0];
  if (image.isEmpty()) return;
  const int tiles = m_params.maps.kernelTiles;
  const int side = image.width / tiles;
  const auto [du, dv] = m_design.directions;
  if (image.width != image.height || side * tiles != image.width || side % 2 == 0)
    throw InputError("twin.maps.kernels",
                     "is " + pairText(image.width, image.height) + " pixels, which are not " +
                         pairText(tiles, tiles) +
                         " squares of an odd number of pixels: set twin.maps.kernelTiles");
  for (int v = 0; v < tiles && v < dv; ++v)
    for (int u = 0; u < tiles && u < du; ++u)
      for (std::size_t c = 0; c < 3; ++c) {
        const TapRange all{-kernelReach(), kernelReach()};
        const std::vector<double> kernel = kernelAt(u * du / tiles, v * dv / tiles, c, all, all);
        const double sum = std::accumulate(kernel.begin(), kernel.end(), 0.0);
        if (std::ranges::any_of(kernel, [](double w) { return w < 0; }) || !(sum > 0))
          throw InputError("twin.maps.kernels", "kernel (" + std::to_string(u) + ", " +
                                                    std::to_string(v) +
                                                    ") has weights below 0, or none above");
      }
}

double Twin::leastGain() const {
  float least = std::numeric_limits<float>::infinity();
  for (const auto& gains : m_gains)
    for (const float gain : gains)
      if (gain > 0) least = std::min(least, gain);
  return std::isfinite(least) ? double(least) : 1;
}

double Twin::sigmaAt(int u, int v, double sigma) const {
  const auto [du, dv] = m_design.directions;
  const double x = (u + 0.5) / du;
  const double y = (v + 0.5) / dv;
  if (!m_maps.sigma.isEmpty()) return m_maps.sigma.at(x, y);
  const double square = (2 * x - 1) * (2 * x - 1) + (2 * y - 1) * (2 * y - 1);
  return sigma * (1 + m_params.leakage.sigmaGrowth * square);
}

/// A square lens of the width p sends the wavelength λ into sinc²(p s/λ) of the slope s.
double Twin::diffractionStep(std::size_t axis, std::size_t channel) const {
  const double wavelength = m_params.colour.wavelengths[channel];
  if (!(wavelength > 0)) return 0;
  const double step = m_lenses[axis]->slopeOf(0.5) - m_lenses[axis]->slopeOf(-0.5);
  return m_array.pitch[axis] * step / m_design.directions[axis] / wavelength;
}

std::vector<double> Twin::kernelAt(int u, int v, std::size_t channel, const TapRange& across,
                                   const TapRange& down) const {
  const auto [du, dv] = m_design.directions;
  const TwinPlane& image = m_maps.kernels[channel];
  const int tiles = m_params.maps.kernelTiles;
  const int side = 2 * kernelReach() + 1;
  const int middleX = u * tiles / du * side + kernelReach();
  const int middleY = v * tiles / dv * side + kernelReach();
  std::vector<double> kernel;
  for (int y = middleY + down.first; y <= middleY + down.last; ++y)
    for (int x = middleX + across.first; x <= middleX + across.last; ++x)
      kernel.push_back(
          double(image.values[std::size_t(y) * std::size_t(image.width) + std::size_t(x)]));
  return kernel;
}

Rgb Twin::lit(const std::array<Hit, 3>& hits, const Rgb& content) const {
  const LightErrors& light = m_params.light;
  const auto [nx, ny] = m_design.hogels;
  const auto [du, dv] = m_design.directions;
  const auto of = [&, nx = nx, du = du, dv = dv](std::size_t c, double value) {
    const Hit& hit = hits[c];
    double factor = 1 - light.black;
    if (!m_gains.empty())
      factor *= double(m_gains[std::size_t(hit.j) * std::size_t(nx) + std::size_t(hit.i)][c]);
    if (!m_maps.directionGain[c].isEmpty())
      factor *= m_maps.directionGain[c].at(hit.u / du, hit.v / dv);
    if (light.falloff != 0) {
      const double a = m_lenses[0]->slopeOf(hit.u / du - 0.5);
      const double b = m_lenses[1]->slopeOf(0.5 - hit.v / dv);
      factor *= std::pow(1 + a * a + b * b, -light.falloff / 2);
    }
    const double fromMiddleU = std::abs(hit.u - std::floor(hit.u) - 0.5);
    const double fromMiddleV = std::abs(hit.v - std::floor(hit.v) - 0.5);
    if (2 * fromMiddleU > light.fill[0] || 2 * fromMiddleV > light.fill[1]) factor = 0;
    return light.black + factor * value + light.ambient[c];
  };
  return {of(0, content.r), of(1, content.g), of(2, content.b)};
}

}  // namespace hogelscope
