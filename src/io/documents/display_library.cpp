// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/display_library.h"

#include "core/base/error.h"
#include "io/files/atomic_file.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

namespace {

std::string textOf(JsonReader& reader, const char* name) {
  const Json* value = reader.section(name);
  if (value == nullptr || !value->is_string())
    throw InputError(reader.pathOf(name), "is not a text");
  return value->get<std::string>();
}

std::vector<LibraryDisplay> readLibrary(const Json& document) {
  JsonReader reader(document, "");
  const Json* version = reader.section("hogelscopeDisplays");
  if (version == nullptr || *version != 1)
    throw InputError("hogelscopeDisplays", "is not 1, the version that this program reads");
  const Json* displays = reader.section("displays");
  reader.refuseUnknown();
  if (displays == nullptr || !displays->is_array())
    throw InputError("displays", "is not a list of {file, name, source, assumed}");
  std::vector<LibraryDisplay> library;
  for (const Json& each : *displays) {
    JsonReader display(each, "displays[" + std::to_string(library.size()) + "]");
    library.push_back({textOf(display, "file"), textOf(display, "name"), textOf(display, "source"),
                       textOf(display, "assumed")});
    display.refuseUnknown();
  }
  return library;
}

}  // namespace

std::vector<LibraryDisplay> loadDisplayLibrary(const std::filesystem::path& file) {
  return inFile(file.string(), [&] { return readLibrary(parseJson(readTextFile(file))); });
}

}  // namespace hogelscope
