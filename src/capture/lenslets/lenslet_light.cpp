// SPDX-License-Identifier: BSD-3-Clause
#include "capture/lenslets/lenslet_light.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"

namespace hogelscope {

namespace {

/// Interpolates bilinearly between the middles of pixels: calls `put(pixel, weight)` for up to
/// four. The outer pixels extend half a pixel beyond their middles; there are none farther out.
template <class Put>
void bilinear(int width, int height, const PicturePoint& at, const Put& put) {
  constexpr double edge = 0.5 + 1e-6;
  if (!(at.real() >= -edge && at.real() <= width - 1 + edge && at.imag() >= -edge &&
        at.imag() <= height - 1 + edge))
    return;
  const double x = std::clamp(at.real(), 0.0, width - 1.0);
  const double y = std::clamp(at.imag(), 0.0, height - 1.0);
  const auto x0 = std::size_t(x);
  const auto y0 = std::size_t(y);
  const double right = x - double(x0);
  const double down = y - double(y0);
  const auto pixel = y0 * std::size_t(width) + x0;
  put(pixel, (1 - right) * (1 - down));
  if (right > 0) put(pixel + 1, right * (1 - down));
  if (down > 0) put(pixel + std::size_t(width), (1 - right) * down);
  if (right > 0 && down > 0) put(pixel + std::size_t(width) + 1, right * down);
}

double valueAt(const LensletPlane& plane, const PicturePoint& at) {
  double sum = 0;
  bilinear(plane.width, plane.height, at,
           [&](std::size_t pixel, double weight) { sum += weight * double(plane.values[pixel]); });
  return sum;
}

/// The lenslets of a row that a hogel lies between, and the weight of the second one.
struct Between {
  double first = 0;
  double weight = 0;
};

Between lensletsOfHogel(const LensletLattice& lattice, int i, int j) {
  constexpr double tiny = 1e-6;
  const double at = lattice.lensletOfHogel(i, j);
  const double first = std::floor(at + tiny);
  return {first, at - first > tiny ? at - first : 0};
}

}  // namespace

void subtract(LensletPlane& plane, const LensletPlane& dark) {
  for (std::size_t p = 0; p < dark.values.size(); ++p)
    plane.values[p] = std::max(0.0F, plane.values[p] - dark.values[p]);
}

void normalise(LensletPlane& white, const LensletLattice& lattice, const LightFieldSize& size) {
  double sum = 0;
  for (int j = 0; j < size.ny; ++j)
    for (int i = 0; i < size.nx; ++i)
      sum += valueAt(white, lattice.middle(lensletsOfHogel(lattice, i, j).first, j));
  const double mean = sum / size.nx / size.ny;
  if (!(mean > 0))
    throw InputError("", "lenslets",
                     "are black in their middles: give another white picture, pitch or origin");
  for (float& value : white.values) value = float(double(value) / mean);
}

LensletSampler::LensletSampler(LensletLight light, const LensletPlane& white,
                               const LensletLattice& lattice, const LightFieldSize& size)
    : m_light(std::move(light)), m_lattice(lattice), m_size(size) {
  const PicturePoint turn = lattice.step / lattice.pitch();
  for (int v = 0; v < size.dv; ++v)
    for (int u = 0; u < size.du; ++u) {
      const PicturePoint straight(u - (size.du - 1) / 2.0, v - (size.dv - 1) / 2.0);
      m_offsets.push_back(turn * straight);
      m_isLit.push_back(isOwn(straight));
    }
  if (!white.values.empty()) darken(white);
}

/// Whether an offset along the lattice's rows is nearer to its lenslet than to any other.
bool LensletSampler::isOwn(const PicturePoint& offset) const {
  const bool isSquare = m_lattice.grid == LensletGrid::square;
  const double turn = std::numbers::pi / (isSquare ? 2 : 3);
  for (int k = 0; k < (isSquare ? 2 : 3); ++k)
    if (std::abs((offset * std::polar(1.0, -k * turn)).real()) > m_lattice.pitch() / 2 + 1e-6)
      return false;
  return true;
}

void LensletSampler::darken(const LensletPlane& white) {
  constexpr int most = 64;  // lenslets along a side, evenly spread
  const int strideX = m_size.nx / most + 1;
  const int strideY = m_size.ny / most + 1;
  std::vector<double> sums(m_offsets.size());
  for (int j = 0; j < m_size.ny; j += strideY)
    for (int i = 0; i < m_size.nx; i += strideX) {
      const PicturePoint middle = m_lattice.middle(lensletsOfHogel(m_lattice, i, j).first, j);
      for (std::size_t k = 0; k < sums.size(); ++k)
        if (m_isLit[k]) sums[k] += valueAt(white, middle + m_offsets[k]);
    }
  const double limit = double(leastWhite) * *std::max_element(sums.begin(), sums.end());
  for (std::size_t k = 0; k < sums.size(); ++k) m_isLit[k] = m_isLit[k] && sums[k] >= limit;
}

void LensletSampler::add(const PicturePoint& at, double weight, std::array<double, 3>& rgb) const {
  const std::size_t channels = m_light.channels;
  bilinear(m_light.width, m_light.height, at, [&](std::size_t pixel, double part) {
    for (std::size_t c = 0; c < 3; ++c)
      rgb[c] += weight * part * double(m_light.values[channels * pixel + (channels < 3 ? 0 : c)]);
  });
}

void LensletSampler::sample(const TexelIndex& at, std::array<double, 3>& rgb) const {
  rgb = {};
  const auto direction = std::size_t(at.v) * std::size_t(m_size.du) + std::size_t(at.u);
  if (!m_isLit[direction]) return;
  const auto [first, weight] = lensletsOfHogel(m_lattice, at.i, at.j);
  const PicturePoint point = m_lattice.middle(first, at.j) + m_offsets[direction];
  add(point, 1 - weight, rgb);
  if (weight > 0) add(point + m_lattice.step, weight, rgb);
}

}  // namespace hogelscope
