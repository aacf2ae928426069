// SPDX-License-Identifier: BSD-3-Clause
#include "core/light_field/sheet_calibration.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

void describe(ParameterVisitor& v, SheetParams& p) {
  auto& [pitch, slope, center, dpi, panel, cone] = p;
  v.group("sheet", "A sheet of slanted lenses over the panel's sub-pixels.");
  v.field("pitch", pitch, {1e-3, 1e5, 1}, "1/in", "Lenses for each inch across them.");
  v.field("slope", slope, {-1e6, 1e6, 0.1}, "",
          "A lens goes up by −slope for each unit to the right; not 0.");
  v.field("center", center, {-1e6, 1e6, 0.01}, "",
          "Phase of the lenses at the panel's middle, as a part of their period.");
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
  constexpr double flattest = 1e-3;
  if (std::abs(params.slope) < flattest)
    throw InputError("slope", "is " + numberText(params.slope) +
                                  ": lenses along the rows; turn the panel by 90°");
}

}  // namespace hogelscope
