// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/twin_file.h"

#include <utility>

#include "core/base/error.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

constexpr int mostDead = 1 << 24;

int readIndex(const Json& value, const std::string& path) {
  if (!value.is_number_integer() || value < 0 || value >= mostDead)
    throw InputError(path, valueText(value) + " is not a number from 0 on");
  return value.get<int>();
}

const Json& list(const Json& value, const std::string& path, const char* wanted) {
  if (!value.is_array()) throw InputError(path, std::string("is not a list ") + wanted);
  return value;
}

std::vector<int> readIndices(JsonReader& reader, const char* name) {
  std::vector<int> indices;
  const Json* given = reader.section(name);
  if (given == nullptr) return indices;
  const std::string path = reader.pathOf(name);
  for (const Json& value : list(*given, path, "of numbers: [3, 17]"))
    indices.push_back(readIndex(value, path));
  return indices;
}

DeadParts readDead(const Json& object, const std::string& path) {
  JsonReader reader(object, path);
  DeadParts dead{readIndices(reader, "rows"), readIndices(reader, "columns"), {}};
  if (const Json* hogels = reader.section("hogels"); hogels != nullptr) {
    const std::string own = reader.pathOf("hogels");
    for (const Json& pair : list(*hogels, own, "of hogels: [[3, 17]]")) {
      if (!pair.is_array() || pair.size() != 2)
        throw InputError(own, valueText(pair) + " is not a hogel: [column, row]");
      dead.hogels.push_back({readIndex(pair[0], own), readIndex(pair[1], own)});
    }
  }
  reader.refuseUnknown();
  return dead;
}

TwinRandom readRandom(const Json& object, const std::string& path) {
  TwinRandom random;
  JsonReader reader(object, path);
  describe(reader, random);
  readSection(reader, "shift", random.shift);
  readSection(reader, "gain", random.gain);
  reader.refuseUnknown();
  return random;
}

Json writtenDead(const DeadParts& dead) {
  Json object = Json::object();
  if (!dead.rows.empty()) object["rows"] = dead.rows;
  if (!dead.columns.empty()) object["columns"] = dead.columns;
  if (!dead.hogels.empty()) object["hogels"] = dead.hogels;
  return object;
}

Json writtenRandom(const TwinRandom& random) {
  Json object = written(random);
  if (random.shift != RandomShift{}) object["shift"] = written(random.shift);
  if (random.gain != RandomGain{}) object["gain"] = written(random.gain);
  return object;
}

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

TwinParams readTwin(const Json& object, const std::string& path) {
  TwinParams twin;
  JsonReader reader(object, path);
  readSection(reader, "lensArray", twin.lensArray);
  readSection(reader, "colour", twin.colour);
  readSection(reader, "leakage", twin.leakage);
  readSection(reader, "light", twin.light);
  if (const Json* dead = reader.section("dead"); dead != nullptr)
    twin.dead = readDead(*dead, reader.pathOf("dead"));
  if (const Json* random = reader.section("random"); random != nullptr)
    twin.random = readRandom(*random, reader.pathOf("random"));
  readSection(reader, "maps", twin.maps);
  reader.refuseUnknown();
  return twin;
}

Json writtenTwin(const TwinParams& twin) {
  const TwinParams design;
  Json object = Json::object();
  if (twin.lensArray != design.lensArray) object["lensArray"] = written(twin.lensArray);
  if (twin.colour != design.colour) object["colour"] = written(twin.colour);
  if (twin.leakage != design.leakage) object["leakage"] = written(twin.leakage);
  if (twin.light != design.light) object["light"] = written(twin.light);
  if (twin.dead != design.dead) object["dead"] = writtenDead(twin.dead);
  if (twin.random != design.random) object["random"] = writtenRandom(twin.random);
  if (twin.maps != design.maps) object["maps"] = written(twin.maps);
  return object;
}

TwinParams loadTwin(const fs::path& file) {
  return inFile(file.string(), [&] {
    TwinParams twin = readTwin(parsedTwin(file));
    for (std::string* const own : twin.maps.files())
      *own = besideDocument(file.parent_path(), *own);
    return twin;
  });
}

std::string textFor(const fs::path& file, const TwinParams& twin) {
  TwinParams moved = twin;
  for (std::string* const own : moved.maps.files()) *own = relativeTo(file, *own);
  return inFile(file.string(), [&] {
    return formatJson({{"hogelscope", 1}, {"twin", writtenTwin(moved)}});
  });
}

void saveTwin(const fs::path& file, const TwinParams& twin) {
  writeTextFile(file, textFor(file, twin));
}

std::string embedTwin(Json& session, const fs::path& folder) {
  if (!session.is_object()) return {};
  const auto given = session.find("twin");
  if (given == session.end() || !given->is_string()) return {};
  std::string name = given->get<std::string>();
  const fs::path file = folder / name;
  *given = inFile(file.string(), [&] { return parsedTwin(file); });
  if (const auto maps = given->is_object() ? given->find("maps") : given->end();
      maps != given->end() && maps->is_object())
    for (auto& [key, value] : maps->items())
      if (value.is_string() && !value.get<std::string>().empty())
        value = (fs::path(name).parent_path() / value.get<std::string>()).string();
  return name;
}

}  // namespace hogelscope
