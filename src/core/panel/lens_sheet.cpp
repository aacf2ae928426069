// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/lens_sheet.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/error.h"

namespace hogelscope {

void describe(ParameterVisitor& v, SheetParams& p) {
  auto& [pitch, slope, center, dpi, panel, cone] = p;
  v.group("sheet", "A sheet of slanted lenses over the panel's sub-pixels.");
  v.field("pitch", pitch, {1e-3, 1e5, 1}, "1/in", "Lenses for each inch across them.");
  v.field("slope", slope, {-1e6, 1e6, 0.1}, "",
          "A lens goes up by −slope for each unit to the right; not 0.");
  v.field("center", center, {-1e6, 1e6, 0.01}, "",
          "Which part of a lens's period the panel's middle is at.");
  v.field("dpi", dpi, {1e-3, 1e6, 1}, "1/in", "Pixels for each inch of the panel.");
  v.field("panel", panel, {1, 65536, 1}, "px", "Columns and rows of the panel's pixels.");
  v.field("cone", cone, {0.01, 179.9, 1}, "°",
          "The angle into which a lens spreads what is behind it.");
}

void check(const SheetParams& params) {
  const auto need = [](const char* name, double value) {
    if (value == notGiven) throw InputError(name, "is missing");
  };
  need("pitch", params.pitch);
  need("slope", params.slope);
  need("center", params.center);
  need("dpi", params.dpi);
  need("cone", params.cone);
  if (params.panel[0] < 1 || params.panel[1] < 1) throw InputError("panel", "is missing");
  if (params.slope == 0)
    throw InputError("slope", "is 0: lenses along the rows; turn the panel by 90°");
}

void describe(ParameterVisitor& v, SheetDisplay& p) {
  auto& [calibration, file, viewingDistance, emitter] = p;
  v.field("viewingDistance", viewingDistance, {1e-3, 1e6, 0.01}, "m",
          "Where all lenses of the sheet show the same view.");
  v.field("emitter", emitter, {0.01, 1, 0.01}, "px",
          "Width and height of a sub-pixel that gives light; only the width has an effect.");
}

LensSheet::LensSheet(const SheetDisplay& display)
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
  m_lensPeriod = m_period / (1 + m_gap / display.viewingDistance);
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
  const double lens = std::floor((x + y * m_perSlope) / m_lensPeriod + m_phase);
  const double across = (lens + 0.5 - m_phase) * m_lensPeriod - m_gap * (a + b * m_perSlope);
  const double along = y - x * m_perSlope - m_gap * (b - a * m_perSlope);
  const double square = 1 + m_perSlope * m_perSlope;
  const auto [width, height] = m_calibration.params.panel;
  // In pixels from the panel's lower left corner.
  const double right = (across - along * m_perSlope) / square / m_pixel + width / 2.0;
  const double up = (across * m_perSlope + along) / square / m_pixel + height / 2.0;
  const auto cell = [](double place, int count) {
    return static_cast<int>(std::floor(std::clamp(place, -2.0, count + 2.0)));
  };
  if (!std::isfinite(right) || !std::isfinite(up)) return std::nullopt;
  const SubPixels& near = cellsAt(cell(right, width), cell(up, height));
  const int column = cell(right - near[channel][0], width);
  const double beside = right - near[channel][0] - (column + 0.5);
  const double slid = (m_emitter - 1) * beside;
  const double upSlid = up - m_calibration.params.slope * slid;
  const double above = cellsAt(column, cell(upSlid, height))[channel][1];
  return SheetHit{column + 0.5, height - (cell(upSlid - above, height) + 0.5)};
}

}  // namespace hogelscope
