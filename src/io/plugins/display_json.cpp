// SPDX-License-Identifier: BSD-3-Clause
#include "io/plugins/display_json.h"

#include <cmath>

#include "core/base/error.h"
#include "io/plugins/plugin_library.h"

namespace hogelscope {

LensParams lensParamsOf(const std::string& source) {
  const PluginLibrary library = loadPlugin(source, PluginKind::lens);
  return LensParams([library] { return library.makeLens(); });
}

DisplayParams withLensParams(const DisplayParams& before, DisplayParams after) {
  if (after.lens != HogelLensModel::plugin) {
    after.lensSource.clear();
    after.lensParams = {};
    return after;
  }
  if (after.lens != before.lens) after.lensSource = "measured-lens";
  if (after.lensSource != before.lensSource) after.lensParams = lensParamsOf(after.lensSource);
  for (const std::size_t axis : {0, 1}) (void)lensOf(after, axis);
  return after;
}

namespace {

constexpr std::size_t mostCells = 64;

std::vector<SubPixels> cellsOf(const Json& cells, const std::string& path) {
  const char* const wanted = "is not a list of 1 … 64 kinds of pixels: [[[x, y], [x, y], [x, y]]]";
  if (!cells.is_array() || cells.empty() || cells.size() > mostCells)
    throw InputError(path, wanted);
  std::vector<SubPixels> kinds;
  for (const Json& cell : cells) {
    SubPixels places{};
    if (!cell.is_array() || cell.size() != 3) throw InputError(path, wanted);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const Json& place = cell[channel];
      if (!place.is_array() || place.size() != 2) throw InputError(path, wanted);
      for (std::size_t axis = 0; axis < 2; ++axis) {
        if (!place[axis].is_number() || !(std::abs(place[axis].get<double>()) <= 1))
          throw InputError(path, "has a place that is not −1 … 1 px");
        places[channel][axis] = place[axis].get<double>();
      }
    }
    kinds.push_back(places);
  }
  return kinds;
}

int patternOf(const Json& value, const std::string& path) {
  if (!value.is_number_integer() || value < 0 || value > 4)
    throw InputError(path, valueText(value) + " is not one of 0, 1, 2, 3, 4");
  return value.get<int>();
}

}  // namespace

void describeParts(SectionVisitor& v, SheetCalibration& calibration) {
  v.value(
      "serial", !calibration.serial.empty(),
      [&](const Json& serial, const std::string&) {
        if (serial.is_string()) calibration.serial = serial.get<std::string>();
      },
      [&] { return Json(calibration.serial); });
  v.fields(calibration.params);
  const bool hasCells = calibration.cells != SheetCalibration{}.cells;
  v.value(
      "cells", hasCells,
      [&](const Json& cells, const std::string& path) { calibration.cells = cellsOf(cells, path); },
      [&] { return Json(calibration.cells); });
  v.value(
      "pattern", hasCells,
      [&](const Json& pattern, const std::string& path) {
        calibration.pattern = patternOf(pattern, path);
      },
      [&] { return Json(calibration.pattern); });
  v.value(
      "invView", calibration.isInverted,
      [&](const Json& order, const std::string&) { calibration.isInverted = order == 0; },
      [] { return Json(0); });
  v.verify([&] { check(calibration.params); });
}

void describeParts(SectionVisitor& v, DisplayParams& params) {
  bool isSheet = params.sheet.has_value();
  v.value(
      "kind", isSheet,
      [&](const Json& kind, const std::string& path) {
        if (kind != "hogels" && kind != "sheet")
          throw InputError(path, valueText(kind) + " is not one of \"hogels\", \"sheet\"");
        isSheet = kind == "sheet";
      },
      [] { return Json("sheet"); });
  if (isSheet) {
    if (!params.sheet) params.sheet.emplace();
    SheetDisplay& sheet = *params.sheet;
    for (const char* key : {"size", "fov", "lens"})
      v.refuse(key, "is for a display of hogels: a lens sheet's calibration says it");
    if (!v.document("calibration", sheet.file, true, [&] { v.parts(sheet.calibration); }))
      throw InputError("display.calibration", "is missing: name the sheet's visual.json");
    v.verify([&params] {
      params.size = LensSheet(*params.sheet).size();
      params.fov.fill(params.sheet->calibration.params.cone);
    });
  }
  v.fields(params);
  if (params.lens != HogelLensModel::plugin) return;
  if (params.lensSource.empty())
    throw InputError("display.lensSource", "is missing: name the plugin of the lens");
  if (!params.lensParams.isGiven()) params.lensParams = lensParamsOf(params.lensSource);
  v.section(params.lensSource, params.lensParams);
  v.files(params.lensParams);
}

}  // namespace hogelscope
