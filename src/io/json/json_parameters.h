// SPDX-License-Identifier: BSD-3-Clause
// JSON as a visitor of the parameter descriptions: reading with the place of every mistake, and
// writing.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/parameters.h"

namespace hogelscope {

/// Keeps the order of the keys, as the documents do.
using Json = nlohmann::ordered_json;

/// Reads the fields that `object` has; the others keep their values. Throws InputError.
class JsonReader : public ParameterVisitor {
 public:
  /// `path` is the object's place in the document, such as "cameras[2].psf".
  JsonReader(const Json& object, std::string path);

  void group(std::string_view, std::string_view) override {}
  /// A key that is read elsewhere. Returns its value, or none.
  const Json* section(std::string_view name);
  /// Call it last: throws for a key that nobody asked for, with the nearest one that is known.
  void refuseUnknown() const;
  [[nodiscard]] std::string pathOf(std::string_view name) const;

 protected:
  void numbers(const Field& field, std::span<double> values, bool isList) override;
  void integers(const Field& field, std::span<int> values, bool isList) override;
  void flag(const Field& field, bool& value) override;
  void text(const Field& field, std::string& value) override;
  void choice(const Field& field, int& index) override;

 private:
  template <class Number>
  void list(const Field& field, std::span<Number> values, bool isList);

  const Json& m_object;
  std::string m_path;
  std::vector<std::string_view> m_known;
};

/// Adds the fields to `object`; what is not given (outside its own range) is left out.
class JsonWriter : public ParameterVisitor {
 public:
  explicit JsonWriter(Json& object) : m_object(object) {}
  void group(std::string_view, std::string_view) override {}

 protected:
  void numbers(const Field& field, std::span<double> values, bool isList) override;
  void integers(const Field& field, std::span<int> values, bool isList) override;
  void flag(const Field& field, bool& value) override;
  void text(const Field& field, std::string& value) override;
  void choice(const Field& field, int& index) override;

 private:
  Json& m_object;
};

/// Reads the fields of `parent`'s object `name`, where it has one.
template <class Params>
void readSection(JsonReader& parent, const char* name, Params& params) {
  const Json* object = parent.section(name);
  if (object == nullptr) return;
  JsonReader reader(*object, parent.pathOf(name));
  describe(reader, params);
  reader.refuseUnknown();
}

/// --set section.field=value.
struct Override {
  std::string section;
  std::string field;
  Json value;  ///< what is not JSON is a text
};

/// Throws InputError for another form.
Override parseOverride(const std::string& text);

/// What no document of ours reaches: a reader of files that nobody vouches for stops there.
constexpr int deepestDocument = 32;
constexpr std::size_t mostKeys = 1000;  ///< in one object, whose keys are searched one by one

enum class JsonComments { refused, ignored };

/// Parses a document; refuses a key that stands twice in an object. Throws InputError.
Json parseJson(const std::string& text, JsonComments comments = JsonComments::refused);

/// Two spaces a level, lists of numbers on one line.
std::string formatJson(const Json& value);

}  // namespace hogelscope
