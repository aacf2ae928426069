// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/twin_file.h"

#include <utility>

#include "core/base/error.h"
#include "io/documents/session_parts.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Returns the twin of a document that was parsed.
const Json& twinOf(const Json& document) {
  if (!document.is_object()) throw InputError("twin", "is not an object: { \"lensArray\": { … } }");
  const auto twin = document.find("twin");
  if (twin == document.end()) return document;
  for (const auto& [key, value] : document.items())
    if (key != "twin" && key != "hogelscope")
      throw InputError(key, "does not stand beside \"twin\" in a twin's document");
  return *twin;
}

Json parsedTwin(const fs::path& file) {
  Json document = parseJson(readTextFile(file));
  return twinOf(document);
}

}  // namespace

TwinParams loadTwin(const fs::path& file) {
  return inFile(file.string(), [&] {
    TwinParams twin;
    readParts(parsedTwin(file), "twin", twin);
    FileVisitor([&](const std::string& own) {
      return besideDocument(file.parent_path(), own);
    }).parts(twin);
    return twin;
  });
}

std::string textFor(const fs::path& file, const TwinParams& twin) {
  TwinParams moved = twin;
  FileVisitor([&](const std::string& own) { return relativeTo(file, own); }).parts(moved);
  return inFile(file.string(), [&] {
    return formatJson({{"hogelscope", 1}, {"twin", writtenParts(moved)}});
  });
}

void saveTwin(const fs::path& file, const TwinParams& twin) {
  writeTextFile(file, textFor(file, twin));
}

Json twinObject(const std::string& name, const fs::path& folder) {
  const fs::path file = folder / name;
  Json twin = inFile(file.string(), [&] { return parsedTwin(file); });
  if (const auto maps = twin.is_object() ? twin.find("maps") : twin.end();
      maps != twin.end() && maps->is_object())
    for (auto& [key, value] : maps->items())
      if (value.is_string() && !value.get<std::string>().empty())
        value = (fs::path(name).parent_path() / value.get<std::string>()).string();
  return twin;
}

}  // namespace hogelscope
