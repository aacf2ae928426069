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

/// A lens sheet's place; its size and field are its calibration's.
SheetDisplay sheetOf(const Json& object) {
  for (const char* key : {"size", "fov", "lens"})
    if (object.contains(key))
      throw InputError(std::string("display.") + key,
                       "is for a display of hogels: a lens sheet's calibration says it");
  const auto calibration = object.find("calibration");
  if (calibration == object.end())
    throw InputError("display.calibration", "is missing: name the sheet's visual.json");
  SheetDisplay sheet;
  sheet.calibration = readSheet(*calibration, "display.calibration");
  return sheet;
}

}  // namespace

SheetCalibration readSheet(const Json& object, const std::string& path) {
  SheetCalibration calibration;
  JsonReader reader(object, path);
  describe(reader, calibration.params);
  if (const Json* serial = reader.section("serial"); serial != nullptr && serial->is_string())
    calibration.serial = serial->get<std::string>();
  if (const Json* cells = reader.section("cells"); cells != nullptr)
    calibration.cells = cellsOf(*cells, reader.pathOf("cells"));
  if (const Json* pattern = reader.section("pattern"); pattern != nullptr)
    calibration.pattern = patternOf(*pattern, reader.pathOf("pattern"));
  if (const Json* order = reader.section("invView"); order != nullptr)
    calibration.isInverted = *order == 0;
  reader.refuseUnknown();
  try {
    check(calibration.params);
  } catch (const InputError& error) {
    throw InputError((path.empty() ? "" : path + ".") + error.what(), "");
  }
  return calibration;
}

Json writtenSheet(const SheetCalibration& calibration) {
  Json object = Json::object();
  if (!calibration.serial.empty()) object["serial"] = calibration.serial;
  object.update(written(calibration.params));
  if (calibration.cells != SheetCalibration{}.cells) {
    object["cells"] = calibration.cells;
    object["pattern"] = calibration.pattern;
  }
  if (calibration.isInverted) object["invView"] = 0;
  return object;
}

DisplayParams readDisplay(const Json& object) {
  DisplayParams params;
  JsonReader reader(object, "display");
  const auto given = object.is_object() ? object.find("kind") : object.end();
  const Json kind = given == object.end() ? Json("hogels") : *given;
  if (kind != "hogels" && kind != "sheet")
    throw InputError("display.kind", valueText(kind) + " is not one of \"hogels\", \"sheet\"");
  if (kind == "sheet") {
    params.sheet = sheetOf(object);
    params.size = LensSheet(*params.sheet).size();
    params.fov.fill(params.sheet->calibration.params.cone);
  }
  describe(reader, params);
  (void)reader.section("kind");
  if (params.sheet) (void)reader.section("calibration");
  if (params.lens == HogelLensModel::plugin) {
    if (params.lensSource.empty())
      throw InputError("display.lensSource", "is missing: name the plugin of the lens");
    params.lensParams = lensParamsOf(params.lensSource);
    readSection(reader, params.lensSource.c_str(), params.lensParams);
  }
  reader.refuseUnknown();
  return params;
}

Json writtenDisplay(const DisplayParams& params) {
  Json object = Json::object();
  if (params.sheet) {
    object["kind"] = "sheet";
    if (params.sheet->file.empty())
      object["calibration"] = writtenSheet(params.sheet->calibration);
    else
      object["calibration"] = params.sheet->file;
  }
  object.update(written(params));
  if (params.lensParams.isGiven()) object[params.lensSource] = written(params.lensParams);
  return object;
}

}  // namespace hogelscope
