// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/sheet_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "io/files/atomic_file.h"
#include "io/plugins/display_json.h"

namespace hogelscope {

namespace {

constexpr std::uintmax_t largest = std::uintmax_t{1} << 20;

Json sheetDocument(const std::filesystem::path& file) {
  std::error_code none;
  if (std::filesystem::file_size(file, none) > largest && !none)
    throw InputError("is larger than 1 MiB: not a lens sheet's calibration", "");
  Json document = parseJson(readTextFile(file));
  if (!document.is_object()) throw InputError("is not a JSON object", "");
  return document;
}

/// Returns x or {"value": x}; none if the key is missing.
std::optional<Json> sheetValue(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) return std::nullopt;
  if (!found->is_object()) return *found;
  const auto value = found->find("value");
  if (value == found->end()) throw InputError(key, "has no \"value\"");
  return *value;
}

std::optional<double> sheetNumber(const Json& object, const char* key) {
  const std::optional<Json> value = sheetValue(object, key);
  if (!value) return std::nullopt;
  if (!value->is_number()) throw InputError(key, value->dump() + " is not a number");
  return value->get<double>();
}

double neededNumber(const Json& object, const char* key) {
  const std::optional<double> number = sheetNumber(object, key);
  if (!number) throw InputError(key, "is missing");
  return *number;
}

/// Vendors write whole numbers with a fraction, 3840.0.
int wholeNumber(double number, const char* key) {
  if (number != std::floor(number) || std::abs(number) > 1e6)
    throw InputError(key, Json(number).dump() + " is not a whole number");
  return static_cast<int>(number);
}

/// Returns [[x, y], [x, y], [x, y]] of a vendor's kind of pixel.
Json subPixelsOf(const Json& cell, const std::string& path) {
  if (!cell.is_object()) throw InputError(path, "is not an object with ROffsetX and five others");
  Json places = Json::array();
  for (const auto& [x, y] : {std::pair("ROffsetX", "ROffsetY"), std::pair("GOffsetX", "GOffsetY"),
                             std::pair("BOffsetX", "BOffsetY")}) {
    for (const char* key : {x, y})
      if (!cell.contains(key)) throw InputError(path + "." + key, "is missing");
    places.push_back({cell[x], cell[y]});
  }
  return places;
}

/// Returns a vendor's figures as a session's `calibration` has them.
Json figuresOf(const Json& document) {
  const auto panelOf = [&](const char* key) {
    return wholeNumber(neededNumber(document, key), key);
  };
  Json figures{{"pitch", neededNumber(document, "pitch")},
               {"slope", neededNumber(document, "slope")},
               {"center", neededNumber(document, "center")},
               {"dpi", neededNumber(document, "DPI")},
               {"panel", {panelOf("screenW"), panelOf("screenH")}},
               {"cone", neededNumber(document, "viewCone")}};
  if (const auto serial = document.find("serial"); serial != document.end())
    figures["serial"] = *serial;
  if (sheetNumber(document, "invView").value_or(1) == 0) figures["invView"] = 0;
  const auto cells = document.find("subpixelCells");
  if (cells == document.end() || (cells->is_array() && cells->empty())) return figures;
  if (!cells->is_array()) throw InputError("subpixelCells", "is not a list of kinds of pixels");
  for (std::size_t k = 0; k < cells->size(); ++k)
    figures["cells"].push_back(
        subPixelsOf((*cells)[k], "subpixelCells[" + std::to_string(k) + "]"));
  figures["pattern"] =
      wholeNumber(sheetNumber(document, "CellPatternMode").value_or(0), "CellPatternMode");
  return figures;
}

SheetCalibration calibrationOf(const Json& document, std::vector<std::string>* warnings) {
  if (sheetNumber(document, "flipImageX").value_or(0) != 0)
    throw InputError("flipImageX", "is not 0: mirrored panels are not modelled");
  SheetCalibration calibration;
  readParts(figuresOf(document), "", calibration);
  if (warnings != nullptr && calibration.isInverted)
    warnings->push_back("invView is 0, which is ignored: views go from left to right");
  return calibration;
}

}  // namespace

bool isSheetCalibration(const std::filesystem::path& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none) ||
      std::filesystem::file_size(file, none) > largest)
    return false;
  Json document;
  try {
    document = parseJson(readTextFile(file));
  } catch (const InputError&) {
    return false;  // another reader says what is wrong
  }
  constexpr std::array keys{"pitch", "slope", "center", "viewCone", "DPI", "screenW", "screenH"};
  return document.is_object() && std::ranges::count_if(keys, [&](const char* key) {
                                   return document.contains(key);
                                 }) > std::ssize(keys) / 2;
}

SheetCalibration loadSheetCalibration(const std::filesystem::path& file,
                                      std::vector<std::string>* warnings) {
  return inFile(file.string(), [&] { return calibrationOf(sheetDocument(file), warnings); });
}

Json sheetObject(const std::filesystem::path& file) {
  return inFile(file.string(), [&] {
    const Json document = sheetDocument(file);
    (void)calibrationOf(document, nullptr);  // says what is wrong with the file itself
    return figuresOf(document);
  });
}

}  // namespace hogelscope
