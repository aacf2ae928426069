// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/lens_sheet.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace hogelscope {

void describe(ParameterVisitor& v, SheetDisplay& p) {
  auto& [calibration, file, viewingDistance, emitter, spot] = p;
  v.field("viewingDistance", viewingDistance, {1e-3, 1e6, 0.01}, "m",
          "Where all lenses of the sheet show the same view.");
  v.field("emitter", emitter, {0.01, 1, 0.01}, "px",
          "Width and height of a sub-pixel that gives light; only the width has an effect.");
  v.field("spot", spot, {0, 1e-3, 1e-5}, "m",
          "Blur of the lenses: the standard deviation on the panel along a row; 0: none.");
}

std::vector<double> spotWeights(double sigma) {
  constexpr double dropped = 1e-4;
  const double t = sigma * sigma;
  // Beyond some 10 px the Gaussian itself: the Bessel function would overflow.
  const auto weight = [&](int k) {
    return t < 100 ? std::exp(-t) * std::cyl_bessel_i(double(k), t)
                   : std::exp(-double(k) * k / (2 * t)) / std::sqrt(2 * std::numbers::pi * t);
  };
  std::vector<double> half{weight(0)};
  double sum = half[0];
  for (int k = 1; 1 - sum > dropped; ++k) {
    half.push_back(weight(k));
    sum += 2 * half.back();
  }
  std::vector<double> weights(half.rbegin(), half.rend());
  weights.insert(weights.end(), half.begin() + 1, half.end());
  for (double& each : weights) each /= sum;
  return weights;
}

bool isOfSheet(const TwinParams& twin) {
  TwinParams rest = twin;
  rest.lensArray.offset = rest.lensArray.pitchError = {};
  rest.lensArray.rotation = rest.lensArray.gapError = 0;
  return rest.isZero();
}

LensSheet::LensSheet(const SheetDisplay& display, const LensArrayErrors& mounted)
    : m_calibration(display.calibration), m_emitter(display.emitter[0]) {
  const SheetParams& params = m_calibration.params;
  check(params);
  // Column from the left, row from the bottom: CellPatternMode 0 … 4.
  constexpr std::array<std::array<int, 3>, 5> patterns{
      {{0, 0, 0}, {1, 1, 1}, {1, 0, 1}, {2, 1, 3}, {0, 1, 1}}};
  const auto& [ofColumn, ofRow, mask] = patterns[std::size_t(m_calibration.pattern)];
  m_pattern = {ofColumn, ofRow, mask, {}};
  for (std::size_t kind = 0; kind < m_pattern.kinds.size(); ++kind)
    m_pattern.kinds[kind] = m_calibration.cells[kind % m_calibration.cells.size()];
  m_pixel = 0.0254 / params.dpi;
  m_size = {params.panel[0] * m_pixel, params.panel[1] * m_pixel};
  m_perSlope = 1 / params.slope;
  m_period = 0.0254 / params.pitch / std::cos(std::atan(m_perSlope));
  m_gap = m_period / (2 * std::tan(radians(params.cone) / 2));
  const double tilt = m_size[1] / m_size[0] * m_perSlope;
  m_phase = lenses() * (1 + tilt) / 2 - params.center;
  // The sheet is stretched about the panel's middle, then turned, then moved.
  const auto [wider, higher] = mounted.pitchError;
  const double stretched = m_perSlope * (1 + wider) / (1 + higher);
  m_perSeen = std::tan(std::atan(stretched) + radians(mounted.rotation));
  m_seenSlope = std::clamp(1 / m_perSeen, -1e9, 1e9);
  const double upright = m_period / (1 + m_gap / display.viewingDistance) * (1 + wider) *
                         std::cos(std::atan(stretched));
  m_lensPeriod = upright / std::cos(std::atan(m_perSeen));
  m_seenPhase = m_phase - (mounted.offset[0] + mounted.offset[1] * m_perSeen) / m_lensPeriod;
  if (display.spot > 0) m_spot = spotWeights(display.spot / m_pixel);
  m_seenGap = m_gap * (1 + mounted.gapError);
}

double LensSheet::slant() const {
  return -std::atan(m_perSlope) * 180 / std::numbers::pi;
}

const SubPixels& LensSheet::cellsAt(int column, int rowUp) const {
  const int kind = (column * m_pattern.ofColumn + rowUp * m_pattern.ofRow) & m_pattern.mask;
  return m_pattern.kinds[std::size_t(kind)];
}

LensSheet::RowPhases LensSheet::phasesOf(int row, std::size_t channel) const {
  const int rowUp = m_calibration.params.panel[1] - 1 - row;
  RowPhases phases{
      {}, m_pixel / m_period, m_pattern.ofColumn, rowUp * m_pattern.ofRow, m_pattern.mask};
  for (std::size_t kind = 0; kind < phases.first.size(); ++kind) {
    const auto& [right, up] = m_pattern.kinds[kind][channel];
    const double x = (0.5 + right) * m_pixel - m_size[0] / 2;
    const double y = (rowUp + 0.5 + up) * m_pixel - m_size[1] / 2;
    phases.first[kind] = (x + y * m_perSlope) / m_period + m_phase;
  }
  const double more =
      1 - std::floor(std::ranges::min(phases.first));  // so that truncation is floor
  for (double& phase : phases.first) phase += more;
  return phases;
}

inline int LensSheet::RowPhases::viewOf(int column, int views) const {
  const int kind = (column * ofColumn + ofRow) & mask;
  const double phase = first[std::size_t(kind)] + column * perColumn;
  return std::min(
      static_cast<int>(views * (1 - (phase - double(static_cast<std::int64_t>(phase))))),
      views - 1);
}

int LensSheet::viewOf(int column, int row, std::size_t channel, int views) const {
  return phasesOf(row, channel).viewOf(column, views);
}

void LensSheet::viewsOf(int row, std::size_t channel, int views, std::span<int> shown) const {
  const RowPhases phases = phasesOf(row, channel);
  for (std::size_t column = 0; column < shown.size(); ++column)
    shown[column] = phases.viewOf(int(column), views);
}

/// Across the lenses, h = x + y/slope, light leaves a lens of middle hₙ with the slope
/// (hₙ − h)/g of its pixel's place h; along them, t = y − x/slope, it goes straight.
SheetHits LensSheet::hitsFrom(const Vec3& eye) const {
  using Linear = SheetHits::Linear;
  // A ray meets the sheet at x = eye.x − eye.z a, y = eye.y − eye.z b.
  const Linear h{eye.x + eye.y * m_perSeen, -eye.z, -eye.z * m_perSeen};
  const Linear t{eye.y - eye.x * m_perSeen, (eye.z + m_seenGap) * m_perSeen, -eye.z - m_seenGap};
  constexpr double beyond = 16;
  const double reach = (m_size[0] + m_size[1] * std::abs(m_perSeen)) / 2 / m_lensPeriod;
  const double toFirst = m_seenPhase - (std::floor(m_seenPhase) - std::ceil(reach) - beyond);
  const Linear across{(0.5 - toFirst) * m_lensPeriod, -m_seenGap, -m_seenGap * m_perSeen};
  const double perPixel = 1 / ((1 + m_perSeen * m_perSeen) * m_pixel);
  const auto [width, height] = m_calibration.params.panel;
  SheetHits hits;
  for (std::size_t k = 0; k < 3; ++k) {
    hits.lens[k] = h[k] / m_lensPeriod;
    hits.right[k] = (across[k] - t[k] * m_perSeen) * perPixel;
    hits.up[k] = (across[k] * m_perSeen + t[k]) * perPixel;
  }
  hits.lens[0] += toFirst;
  hits.right[0] += width / 2.0;
  hits.up[0] += height / 2.0;
  hits.rightOfLens = m_lensPeriod * perPixel;
  hits.upOfLens = hits.rightOfLens * m_perSeen;
  return hits;
}

std::optional<SheetHit> LensSheet::meet(const Vec3& eye, const Vec3& direction,
                                        std::size_t channel) const {
  if (!(eye.z > 0 && direction.z < 0)) return std::nullopt;
  const SheetHits hits = hitsFrom(eye);
  const auto at = [&, a = direction.x / direction.z, b = direction.y / direction.z](
                      const SheetHits::Linear& f) { return f[0] + f[1] * a + f[2] * b; };
  const double lens = std::floor(at(hits.lens));
  const double right = at(hits.right) + hits.rightOfLens * lens;
  const double up = at(hits.up) + hits.upOfLens * lens;
  if (!std::isfinite(right) || !std::isfinite(up)) return std::nullopt;
  const auto [width, height] = m_calibration.params.panel;
  // So far beside the panel no kind of pixel matters, since nothing moves an end back onto it.
  constexpr double beside = 2 * farthestUp;
  const auto cell = [](double place, int count) {
    return static_cast<int>(std::floor(std::clamp(place, -beside, count + beside)));
  };
  const double fromRight = right - cellsAt(cell(right, width), cell(up, height))[channel][0];
  const int column = cell(fromRight, width);
  // Lenses that are nearly upright meet the emitter too far away.
  const double above =
      up + std::clamp(slide() * (fromRight - (column + 0.5)), -farthestUp, farthestUp);
  const double fromAbove = above - cellsAt(column, cell(above, height))[channel][1];
  return SheetHit{column + 0.5, height - (cell(fromAbove, height) + 0.5)};
}

}  // namespace hogelscope
