// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/key_map_file.h"

#include "core/base/error.h"
#include "io/files/atomic_file.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

namespace {

constexpr const char* keysVersion = "hogelscopeKeys";

std::string shownJson(const Json& value) {
  return value.dump(-1, ' ', true, Json::error_handler_t::replace);
}

KeyTexts readKeys(const Json& document) {
  JsonReader reader(document, "");
  const Json* version = reader.section(keysVersion);
  if (version == nullptr)
    throw InputError(keysVersion, "is missing: a key map says \"hogelscopeKeys\": 1");
  if (*version != 1)
    throw InputError(keysVersion,
                     shownJson(*version) + " is not a version that this program reads: 1");
  const Json* keys = reader.section("keys");
  reader.refuseUnknown();
  if (keys == nullptr || !keys->is_object())
    throw InputError("keys", "is not an object: { \"duplicateAction\": \"Ctrl+D\", … }");
  KeyTexts texts;
  for (const auto& [name, key] : keys->items()) {
    if (!key.is_string())
      throw InputError("keys." + name, shownJson(key) + " is not a text such as \"Ctrl+D\"");
    texts[name] = key.get<std::string>();
  }
  return texts;
}

}  // namespace

KeyTexts loadKeyTexts(const std::filesystem::path& file) {
  return inFile(file.string(), [&] { return readKeys(parseJson(readTextFile(file))); });
}

void saveKeyTexts(const std::filesystem::path& file, const KeyTexts& keys) {
  const Json document{{keysVersion, 1}, {"keys", Json(keys)}};
  inFile(file.string(), [&] {
    makeFolder(std::filesystem::absolute(file).parent_path());
    writeTextFile(file, formatJson(document));
  });
}

}  // namespace hogelscope
