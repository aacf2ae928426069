// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/lens_sheet.h"

#include <algorithm>
#include <cmath>
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
          "How far beside its place on the panel a lens takes light, along a row: the standard "
          "deviation; 0: none.");
}

std::vector<double> spotWeights(double sigma) {
  constexpr double dropped = 1e-4;
  const double t = sigma * sigma;
  // Beyond some 10 px the Gaussian itself: the Bessel function would overflow.
  const auto weight = [&](int k) {
    return t < 100 ? std::exp(-t) * std::cyl_bessel_i(double(k), t)
                   : std::exp(-k * k / (2 * t)) / std::sqrt(2 * std::numbers::pi * t);
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
  TwinParams other = twin;
  const LensArrayErrors& own = twin.lensArray;
  other.lensArray = {};
  other.lensArray.outside = own.outside;
  LensArrayErrors rest = own;
  rest.offset = rest.pitchError = {};
  rest.rotation = rest.gapError = 0;
  return other.isZero() && rest == LensArrayErrors{};
}

LensSheet::LensSheet(const SheetDisplay& display, const LensArrayErrors& mounted)
    : m_calibration(display.calibration), m_emitter(display.emitter[0]) {
  const SheetParams& params = m_calibration.params;
  check(params);
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
  const auto rest = [](int value, int count) { return (value % count + count) % count; };
  const std::array kinds{0, column + rowUp, column, rowUp + 2 * rest(column, 2), rowUp};
  constexpr std::array counts{1, 2, 2, 4, 2};
  const auto pattern = std::size_t(m_calibration.pattern);
  const auto kind = std::size_t(rest(kinds[pattern], counts[pattern]));
  return m_calibration.cells[kind % m_calibration.cells.size()];
}

int LensSheet::viewOf(int column, int row, std::size_t channel, int views) const {
  const int rowUp = m_calibration.params.panel[1] - 1 - row;
  const auto [right, up] = cellsAt(column, rowUp)[channel];
  const double x = (column + 0.5 + right) * m_pixel - m_size[0] / 2;
  const double y = (rowUp + 0.5 + up) * m_pixel - m_size[1] / 2;
  const double phase = (x + y * m_perSlope) / m_period + m_phase;
  return std::min(static_cast<int>(views * (1 - (phase - std::floor(phase)))), views - 1);
}

/// Across the lenses, h = x + y/slope, light leaves a lens of middle hₙ with the slope
/// (hₙ − h)/g of its pixel's place h; along them, t = y − x/slope, it goes straight.
std::optional<SheetHit> LensSheet::meet(const Vec3& eye, const Vec3& direction,
                                        std::size_t channel) const {
  if (!(eye.z > 0 && direction.z < 0)) return std::nullopt;
  const double a = direction.x / direction.z;
  const double b = direction.y / direction.z;
  const double x = eye.x - eye.z * a;
  const double y = eye.y - eye.z * b;
  const double lens = std::floor((x + y * m_perSeen) / m_lensPeriod + m_seenPhase);
  const double across = (lens + 0.5 - m_seenPhase) * m_lensPeriod - m_seenGap * (a + b * m_perSeen);
  const double along = y - x * m_perSeen - m_seenGap * (b - a * m_perSeen);
  const double square = 1 + m_perSeen * m_perSeen;
  const auto [width, height] = m_calibration.params.panel;
  // In pixels from the panel's lower left corner.
  const double right = (across - along * m_perSeen) / square / m_pixel + width / 2.0;
  const double up = (across * m_perSeen + along) / square / m_pixel + height / 2.0;
  const auto cell = [](double place, int count) {
    return static_cast<int>(std::floor(std::clamp(place, -2.0, count + 2.0)));
  };
  if (!std::isfinite(right) || !std::isfinite(up)) return std::nullopt;
  const SubPixels& near = cellsAt(cell(right, width), cell(up, height));
  const int column = cell(right - near[channel][0], width);
  const double beside = right - near[channel][0] - (column + 0.5);
  const double slid = (m_emitter - 1) * beside;
  // Lenses that are nearly upright meet the emitter too far away.
  constexpr double farthest = 8;
  const double upSlid = up - std::clamp(slid * m_seenSlope, -farthest, farthest);
  const double above = cellsAt(column, cell(upSlid, height))[channel][1];
  return SheetHit{column + 0.5, height - (cell(upSlid - above, height) + 0.5)};
}

}  // namespace hogelscope
