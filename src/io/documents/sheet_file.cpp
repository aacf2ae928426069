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

/// A calibration in a document, and its place there; "" for the whole document.
struct PlacedSheet {
  Json object;
  std::string place;
};

bool hasSheetKeys(const Json& object) {
  constexpr std::array keys{"pitch", "slope", "center", "viewCone", "DPI", "screenW", "screenH"};
  return std::ranges::count_if(keys, [&](const char* key) { return object.contains(key); }) >
         std::ssize(keys) / 2;
}

/// Finds the calibrations in what a service answers about the units that are connected: objects,
/// and texts of JSON as the vendor's newer service has them.
void findSheets(const Json& value, const std::string& place, int depth,
                std::vector<PlacedSheet>& found) {
  constexpr std::size_t most = 64;
  if (depth > deepestDocument || found.size() >= most) return;
  if (value.is_object() && hasSheetKeys(value)) {
    found.push_back({value, place});
  } else if (value.is_object()) {
    for (const auto& [key, member] : value.items()) {
      std::string path = place;
      if (!path.empty()) path += '.';
      findSheets(member, path += key, depth + 1, found);
    }
  } else if (value.is_array()) {
    for (std::size_t k = 0; k < value.size(); ++k)
      findSheets(value[k], place + "[" + std::to_string(k) + "]", depth + 1, found);
  } else if (value.is_string() && value.get_ref<const std::string&>().starts_with("{")) {
    try {
      findSheets(parseJson(value.get_ref<const std::string&>()), place, depth + 1, found);
    } catch (const InputError&) {  // a text, and no document
    }
  }
}

/// Reads a document that is a calibration or has some. Throws InputError.
std::vector<PlacedSheet> sheetsIn(const std::filesystem::path& file) {
  std::error_code none;
  if (std::filesystem::file_size(file, none) > largest && !none)
    throw InputError("is larger than 1 MiB: not a lens sheet's calibration", "");
  const Json document = parseJson(readTextFile(file));
  if (!document.is_object()) throw InputError("is not a JSON object", "");
  std::vector<PlacedSheet> found;
  if (!document.contains("hogelscope")) findSheets(document, "", 0, found);
  if (found.empty()) found.push_back({document, ""});  // whose errors say what is missing
  return found;
}

std::string serialOf(const Json& document) {
  const auto serial = document.find("serial");
  return serial != document.end() && serial->is_string() ? serial->get<std::string>() : "";
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
  if (value->is_boolean()) return value->get<bool>() ? 1 : 0;
  if (!value->is_number()) throw InputError(key, valueText(*value) + " is not a number");
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

/// The sub-pixels of a panel that is mounted upside down stand blue, green, red: the vendor's
/// shaders take sub-pixel 2 − i for colour i.
Json flipped(Json cells) {
  for (Json& places : cells) std::swap(places[0], places[2]);
  return cells;
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
  const bool isFlipped = sheetNumber(document, "flipSubp").value_or(0) != 0;
  const auto cells = document.find("subpixelCells");
  if (cells == document.end() || (cells->is_array() && cells->empty())) {
    if (isFlipped) figures["cells"] = flipped(SheetCalibration().cells);
    return figures;
  }
  if (!cells->is_array()) throw InputError("subpixelCells", "is not a list of kinds of pixels");
  for (std::size_t k = 0; k < cells->size(); ++k)
    figures["cells"].push_back(
        subPixelsOf((*cells)[k], "subpixelCells[" + std::to_string(k) + "]"));
  if (isFlipped) figures["cells"] = flipped(figures["cells"]);
  figures["pattern"] =
      wholeNumber(sheetNumber(document, "CellPatternMode").value_or(0), "CellPatternMode");
  return figures;
}

/// Whether a value, or the one that it wraps, says that nothing is there: 0, false, "", [] or null.
bool isNeutral(const Json& value) {
  if (value.is_object() && value.contains("value")) return isNeutral(value["value"]);
  if (value.is_number()) return value == 0;
  if (value.is_boolean()) return !value.get<bool>();
  if (value.is_string()) return value.get_ref<const std::string&>().empty();
  return value.empty();
}

/// Returns a line about the keys that the program does not use, though they may change the picture;
/// "" if there are none.
std::string unusedKeys(const Json& document) {
  constexpr std::array<std::string_view, 14> used{
      "configVersion", "serial",     "pitch",    "slope",        "center",
      "viewCone",      "DPI",        "screenW",  "screenH",      "invView",
      "flipImageX",    "flipImageY", "flipSubp", "subpixelCells"};
  constexpr std::size_t most = 8;
  const auto cells = document.find("subpixelCells");
  const bool hasCells = cells != document.end() && !cells->empty();
  std::string line;
  std::size_t count = 0;
  for (const auto& [key, value] : document.items()) {
    if (std::ranges::find(used, key) != used.end() || isNeutral(value)) continue;
    if (key == "CellPatternMode" && hasCells) continue;
    const bool isWrapped = value.is_object() && value.contains("value");
    if (++count <= most)
      line +=
          (count == 1 ? "" : ", ") + key + " is " + valueText(isWrapped ? value["value"] : value);
  }
  if (count > most) line += " and " + std::to_string(count - most) + " more keys";
  return line.empty() ? "" : line + (count == 1 ? ", which is" : ", which are") + " not used";
}

/// Returns a line that says which of several calibrations is read; "" if there is one.
std::string chosenOf(const std::vector<PlacedSheet>& sheets) {
  constexpr std::size_t most = 4;
  if (sheets.size() == 1) return "";
  const auto nameOf = [](const PlacedSheet& sheet) {
    const std::string serial = serialOf(sheet.object);
    return sheet.place + (serial.empty() ? "" : " (" + serial + ")");
  };
  std::string line = "has the calibrations of " + std::to_string(sheets.size()) +
                     " units: that at " + nameOf(sheets[0]) + " is read, not";
  for (std::size_t k = 1; k < std::min(most, sheets.size()); ++k)
    line += (k == 1 ? " " : ", ") + nameOf(sheets[k]);
  return line + (sheets.size() > most ? ", …" : "");
}

constexpr const char* ignoredOrder = "invView is 0, which is ignored: views go from left to right";

SheetCalibration calibrationOf(const std::vector<PlacedSheet>& sheets,
                               std::vector<std::string>* warnings) {
  const Json& document = sheets[0].object;
  for (const char* key : {"flipImageX", "flipImageY"})
    if (sheetNumber(document, key).value_or(0) != 0)
      throw InputError(key, "is not 0: mirrored panels are not modelled");
  SheetCalibration calibration;
  readParts(figuresOf(document), "", calibration);
  if (warnings == nullptr) return calibration;
  for (const std::string& line : {chosenOf(sheets), unusedKeys(document)})
    if (!line.empty()) warnings->push_back(line);
  if (calibration.isInverted) warnings->emplace_back(ignoredOrder);
  return calibration;
}

}  // namespace

bool isSheetCalibration(const std::filesystem::path& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none) ||
      std::filesystem::file_size(file, none) > largest)
    return false;
  try {
    return hasSheetKeys(sheetsIn(file)[0].object);
  } catch (const InputError&) {
    return false;  // another reader says what is wrong
  }
}

SheetCalibration loadSheetCalibration(const std::filesystem::path& file,
                                      std::vector<std::string>* warnings) {
  return inFile(file.string(), [&] { return calibrationOf(sheetsIn(file), warnings); });
}

Json sheetObject(const std::filesystem::path& file) {
  return inFile(file.string(), [&] {
    const std::vector<PlacedSheet> sheets = sheetsIn(file);
    (void)calibrationOf(sheets, nullptr);  // says what is wrong with the file itself
    return figuresOf(sheets[0].object);
  });
}

std::vector<std::string> sheetWarnings(const Session& session) {
  std::vector<std::string> lines;
  const auto add = [&lines](const char* section, const SheetCalibration& calibration,
                            const std::string& file) {
    std::vector<std::string> own;
    if (!file.empty())
      (void)loadSheetCalibration(file, &own);
    else if (calibration.isInverted)
      own = {ignoredOrder};
    for (const std::string& line : own)
      lines.push_back(std::string(section) + ".calibration: " + line);
  };
  if (session.display.sheet)
    add("display", session.display.sheet->calibration, session.display.sheet->file);
  if (session.lightField.calibration)
    add("lightField", *session.lightField.calibration, session.lightField.calibrationFile);
  return lines;
}

}  // namespace hogelscope
