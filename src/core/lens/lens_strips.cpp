// SPDX-License-Identifier: BSD-3-Clause
#include "core/lens/lens_strips.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/multiversioned.h"

namespace hogelscope {

namespace {

constexpr std::size_t terms = LensStrips::terms;

constexpr double placeInStrip(int pixel) {
  return (pixel - (LensStrips::pixels - 1) / 2.0) / (LensStrips::pixels / 2.0);
}

/// Returns the largest distance of the points from a polynomial; infinite or NaN if one has no ray.
MULTIVERSIONED
double distance(const std::array<double, terms>& polynomial, const double* points, int count) {
  constexpr int lanes = 8;
  std::array<double, lanes> largest{};
  std::array<double, lanes> sum{};  // NaN if one is
  const std::array<double, terms> p = polynomial;
  const auto here = [&](int k) {
    const double t = placeInStrip(k);
    return std::abs(((((p[5] * t + p[4]) * t + p[3]) * t + p[2]) * t + p[1]) * t + p[0] -
                    points[k]);
  };
  const auto note = [&](std::size_t lane, double value) {
    largest[lane] = value > largest[lane] ? value : largest[lane];
    sum[lane] += value;
  };
  int first = 0;
  for (; first + lanes <= count; first += lanes)
    for (int lane = 0; lane < lanes; ++lane) note(std::size_t(lane), here(first + lane));
  for (; first < count; ++first) note(0, here(first));
  double total = 0;
  for (const double one : sum) total += one;
  return total < std::numeric_limits<double>::infinity() ? *std::ranges::max_element(largest)
                                                         : total;
}

}  // namespace

StripFit::Nodes::Nodes(int count) : pixels(count) {
  for (std::size_t n = 0; n < terms; ++n) {
    const double angle = (2 * double(n) + 1) * std::numbers::pi / (2 * terms);
    at[n] = static_cast<int>(std::lround((count - 1) / 2.0 * (1 - std::cos(angle))));
  }
  for (std::size_t n = 0; n < terms; ++n) {
    shapes[n] = {1};
    for (const int other : at) {
      if (other == at[n]) continue;
      // Times (t - root)/(node - root), the highest power first.
      const double root = placeInStrip(other);
      const double scale = 1 / (placeInStrip(at[n]) - root);
      for (std::size_t power = terms - 1; power > 0; --power)
        shapes[n][power] = scale * (shapes[n][power - 1] - root * shapes[n][power]);
      shapes[n][0] *= -scale * root;
    }
  }
}

StripFit::Polynomial StripFit::Nodes::through(const double* points) const {
  Polynomial sum{};
  for (std::size_t n = 0; n < terms; ++n)
    for (std::size_t power = 0; power < terms; ++power)
      sum[power] += points[at[n]] * shapes[n][power];
  return sum;
}

StripFit::StripFit(int width)
    : m_strips((width + LensStrips::pixels - 1) / LensStrips::pixels),
      m_whole(LensStrips::pixels),
      m_last(width - (m_strips - 1) * LensStrips::pixels) {}

void StripFit::row(const double* x, const double* y, int row, LensStrips* strips) const {
  for (int k = 0; k < m_strips; ++k) {
    const Nodes& nodes = k + 1 < m_strips ? m_whole : m_last;
    const double* stripX = x + k * LensStrips::pixels;
    const double* stripY = y + k * LensStrips::pixels;
    const std::size_t strip = std::size_t(row) * std::size_t(m_strips) + std::size_t(k);
    LensStrips& group = strips[strip / LensStrips::count];
    const std::size_t own = strip % LensStrips::count;
    group.error[own] = std::numeric_limits<double>::infinity();
    if (nodes.pixels < int(terms)) continue;
    const Polynomial ofX = nodes.through(stripX);
    const Polynomial ofY = nodes.through(stripY);
    const double error =
        std::max(distance(ofX, stripX, nodes.pixels), distance(ofY, stripY, nodes.pixels));
    if (!(error < std::numeric_limits<double>::infinity())) continue;
    group.error[own] = error;
    for (std::size_t power = 0; power < terms; ++power) {
      group.x[power][own] = ofX[power];
      group.y[power][own] = ofY[power];
    }
  }
}

}  // namespace hogelscope
