// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/lens_sheet.h"

#include <cmath>
#include <numbers>

#include "core/base/error.h"

namespace hogelscope {

void describe(ParameterVisitor& v, SheetParams& p) {
  auto& [pitch, slope, center, dpi, panel, cone] = p;
  v.group("sheet", "A sheet of slanted lenses over the panel's sub-pixels.");
  v.field("pitch", pitch, {1e-3, 1e5, 1}, "1/in", "Lenses for each inch across them.");
  v.field("slope", slope, {-1e6, 1e6, 0.1}, "",
          "How far a lens goes up for each unit to the right; not 0.");
  v.field("center", center, {-1e6, 1e6, 0.01}, "",
          "Which part of a lens's period the panel's middle is at.");
  v.field("dpi", dpi, {1e-3, 1e6, 1}, "1/in", "Pixels for each inch of the panel.");
  v.field("panel", panel, {1, 65536, 1}, "px", "Columns and rows of the panel's pixels.");
  v.field("cone", cone, {0.01, 179.9, 1}, "°",
          "The angle into which a lens spreads what is behind it.");
}

void check(const SheetParams& params) {
  if (params.slope == 0)
    throw InputError("slope", "is 0: lenses along the rows; turn the panel by 90°");
}

LensSheet::LensSheet(const SheetParams& params)
    : pixel(0.0254 / params.dpi),
      size{params.panel[0] * pixel, params.panel[1] * pixel},
      period(0.0254 / params.pitch / std::cos(std::atan(1 / params.slope))),
      lenses(size[0] / period),
      slant(std::atan(1 / params.slope) * 180 / std::numbers::pi),
      gap(period / (2 * std::tan(params.cone / 2 * std::numbers::pi / 180))) {}

}  // namespace hogelscope
