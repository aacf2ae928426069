// SPDX-License-Identifier: BSD-3-Clause
// Visitors of the parameter descriptions that read and write JSON, with the path of every error.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/base/parameters.h"

namespace hogelscope {

/// A JSON value that keeps the order of the keys, as the documents do.
using Json = nlohmann::ordered_json;

/// Formats a value for an error line: short, and on one line, whatever its bytes are, since those
/// of --set need not be UTF-8.
std::string valueText(const Json& value);

/// Reads the fields that `object` has; the others keep their values. Throws InputError.
class JsonReader : public ParameterVisitor {
 public:
  /// `path` is the path of the object in the document, such as "cameras[2].psf".
  JsonReader(const Json& object, std::string path);

  void group(std::string_view, std::string_view) override {}
  /// Returns the value of a key that is read elsewhere, or null. Throws InputError for a name that
  /// was read before, because a plugin's parameters share an object with those of every live scene.
  const Json* section(std::string_view name);
  /// Throws InputError for a key that was not read, with the nearest known one. Call it last.
  void refuseUnknown() const;
  [[nodiscard]] bool has(std::string_view name) const;
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

/// Adds the fields to `object`; leaves out those that are not given (outside their own range).
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

/// Returns an object with the fields.
template <class Params>
Json written(Params params) {
  Json object = Json::object();
  JsonWriter writer(object);
  describe(writer, params);
  return object;
}

/// Reads the fields of `parent`'s object `name`, if it has one.
template <class Params>
void readSection(JsonReader& parent, const char* name, Params& params) {
  const Json* object = parent.section(name);
  if (object == nullptr) return;
  JsonReader reader(*object, parent.pathOf(name));
  describe(reader, params);
  reader.refuseUnknown();
}

/// A parsed override, section.field=value.
struct Override {
  std::string section;
  std::string field;
  Json value;  ///< a text if it is not valid JSON
};

/// Parses an override. Throws InputError for another form.
Override parseOverride(const std::string& text);

/// The depth limit for untrusted files, beyond all documents of the program.
constexpr int deepestDocument = 32;
constexpr std::size_t mostKeys = 1000;  ///< in one object; keys are searched linearly

enum class JsonComments { refused, ignored };

/// Parses a document. Throws InputError, also for a key that occurs twice in an object.
Json parseJson(const std::string& text, JsonComments comments = JsonComments::refused);

/// Formats with two spaces per level, and lists of numbers on one line.
std::string formatJson(const Json& value);

}  // namespace hogelscope
