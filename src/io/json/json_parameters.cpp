// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/json_parameters.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

std::string valueText(const Json& value) {
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  constexpr std::size_t longest = 60;
  if (text.size() <= longest) return text;
  std::size_t end = longest;  // not within a character
  while ((static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80) --end;
  return text.substr(0, end) + "…";
}

namespace {

std::string rangeText(const Field& field) {
  std::string text = numberText(field.range.min) + " to " + numberText(field.range.max);
  return field.unit.empty() ? text : text + " " + std::string(field.unit);
}

std::string joined(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

std::string suggestion(std::string_view name, std::span<const std::string_view> known) {
  const std::string_view nearest = nearestName(name, known);
  if (nearest.empty()) return "known are " + joined(known);
  return "did you mean \"" + std::string(nearest) + "\"?";
}

void checkNumber(const Json& value, const Field& field, const std::string& path, double) {
  if (!value.is_number()) throw InputError(path, valueText(value) + " is not a number");
  const auto number = value.get<double>();
  if (!(number >= field.range.min && number <= field.range.max))
    throw InputError(path, valueText(value) + " is out of range: " + rangeText(field));
}

void checkNumber(const Json& value, const Field& field, const std::string& path, int) {
  checkNumber(value, field, path, 0.0);
  const auto number = value.get<double>();
  if (number != std::floor(number))
    throw InputError(path, valueText(value) + " is not a whole number");
  if (std::fmod(number - field.range.min, field.range.step) != 0)
    throw InputError(path, valueText(value) + " is not one of " + numberText(field.range.min) +
                               ", " + numberText(field.range.min + field.range.step) + ", … " +
                               numberText(field.range.max));
}

template <class Number>
void write(Json& object, const Field& field, std::span<Number> values, bool isList) {
  for (const Number value : values)
    if (!(value >= field.range.min && value <= field.range.max)) return;
  Json& target = object[std::string(field.name)];
  if (isList)
    target = Json(std::vector<Number>(values.begin(), values.end()));
  else
    target = values[0];
}

/// Checks a document's structure: rejects invalid JSON, a key that occurs twice in an object, and a
/// depth or number of keys beyond all documents of the program. Not a callback of Json::parse(),
/// which would traverse the array read so far at each object's end.
class StructureCheck : public Json::json_sax_t {
 public:
  explicit StructureCheck(const std::string& text) : m_text(text) {}

  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(number_integer_t /*value*/) override { return true; }
  bool number_unsigned(number_unsigned_t /*value*/) override { return true; }
  bool number_float(number_float_t /*value*/, const string_t& /*text*/) override { return true; }
  bool string(string_t& /*value*/) override { return true; }
  bool binary(binary_t& /*value*/) override { return true; }
  bool start_object(std::size_t /*count*/) override {
    m_open.emplace_back();
    return deeper();
  }
  bool key(string_t& name) override {
    m_open.back().latest = name;
    if (m_open.back().keys.size() == mostKeys)
      throw InputError("has more than " + std::to_string(mostKeys) + " keys in one object", "");
    if (m_open.back().keys.insert(name).second) return true;
    std::string path;
    for (const Object& object : m_open) path += (path.empty() ? "" : ".") + object.latest;
    throw InputError(path, "stands twice in one object");
  }
  bool end_object() override {
    m_open.pop_back();
    --m_depth;
    return true;
  }
  bool start_array(std::size_t /*count*/) override { return deeper(); }
  bool end_array() override {
    --m_depth;
    return true;
  }
  /// Throws an error at the last of `read` bytes. Line and column are counted here, because the
  /// library's text varies with its version; the part after them is its reason.
  bool parse_error(std::size_t read, const std::string& /*token*/,
                   const nlohmann::detail::exception& error) override {
    const std::string_view before(m_text.data(), std::min(m_text.size(), read - 1));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;
    std::string why = error.what();
    why.erase(0, std::min(why.size(), why.find("] ") + 2));
    if (const std::size_t place = why.find(", column "); place != std::string::npos)
      why.erase(0, std::min(why.size(), why.find(": ", place) + 2));
    std::replace_if(
        why.begin(), why.end(), [](unsigned char c) { return c < 32; }, ' ');
    throw InputError("is not JSON", "line " + std::to_string(line) + ", column " +
                                        std::to_string(column) + ": " + why);
  }

 private:
  struct Object {
    std::set<std::string> keys;
    std::string latest;
  };

  bool deeper() {
    if (++m_depth > deepestDocument) throw InputError("is nested deeper than any session", "");
    return true;
  }

  const std::string& m_text;
  std::vector<Object> m_open;
  int m_depth = 0;
};

void format(const Json& value, const std::string& indent, std::string& out) {
  const bool isLeaf = !value.is_structured() || value.empty();
  const bool isFlat =
      value.is_array() &&
      std::none_of(value.begin(), value.end(), [](const Json& v) { return v.is_structured(); });
  if (isLeaf || isFlat) {
    out += value.dump();
    return;
  }
  const std::string inner = indent + "  ";
  out += value.is_object() ? "{" : "[";
  const char* separator = "\n";
  for (const auto& item : value.items()) {
    out += separator + inner;
    if (value.is_object()) out += Json(item.key()).dump() + ": ";
    format(item.value(), inner, out);
    separator = ",\n";
  }
  out += "\n" + indent + (value.is_object() ? "}" : "]");
}

}  // namespace

JsonReader::JsonReader(const Json& object, std::string path)
    : m_object(object), m_path(std::move(path)) {
  if (!object.is_object())
    throw InputError(m_path, valueText(object) + " is not an object: { \"name\": value, … }");
}

std::string JsonReader::pathOf(std::string_view name) const {
  return m_path.empty() ? std::string(name) : m_path + "." + std::string(name);
}

bool JsonReader::has(std::string_view name) const {
  return m_object.contains(std::string(name));
}

const Json* JsonReader::section(std::string_view name) {
  if (std::find(m_known.begin(), m_known.end(), name) != m_known.end())
    throw InputError(pathOf(name), "is declared twice: a plugin's parameter needs another name");
  m_known.push_back(name);
  const auto found = m_object.find(std::string(name));
  return found == m_object.end() ? nullptr : &*found;
}

void JsonReader::refuseUnknown() const {
  for (const auto& item : m_object.items())
    if (std::find(m_known.begin(), m_known.end(), item.key()) == m_known.end())
      throw InputError(pathOf(item.key()), "is not known here; " + suggestion(item.key(), m_known));
}

template <class Number>
void JsonReader::list(const Field& field, std::span<Number> values, bool isList) {
  const Json* value = section(field.name);
  if (value == nullptr) return;
  const std::string path = pathOf(field.name);
  if (!isList) {
    checkNumber(*value, field, path, Number{});
    values[0] = value->get<Number>();
    return;
  }
  if (!value->is_array() || value->size() != values.size())
    throw InputError(path, valueText(*value) + " is not a list of " +
                               std::to_string(values.size()) + " numbers");
  for (std::size_t k = 0; k < values.size(); ++k) {
    checkNumber((*value)[k], field, path + "[" + std::to_string(k) + "]", Number{});
    values[k] = (*value)[k].get<Number>();
  }
}

void JsonReader::numbers(const Field& field, std::span<double> values, bool isList) {
  list(field, values, isList);
}

void JsonReader::integers(const Field& field, std::span<int> values, bool isList) {
  list(field, values, isList);
}

void JsonReader::flag(const Field& field, bool& value) {
  const Json* found = section(field.name);
  if (found == nullptr) return;
  if (!found->is_boolean())
    throw InputError(pathOf(field.name), valueText(*found) + " is neither true nor false");
  value = found->get<bool>();
}

void JsonReader::text(const Field& field, std::string& value) {
  const Json* found = section(field.name);
  if (found == nullptr) return;
  if (field.mayBeNumber && found->is_number_unsigned()) {
    value = found->dump();
    return;
  }
  if (!found->is_string())
    throw InputError(pathOf(field.name), valueText(*found) + " is not a text");
  value = found->get<std::string>();
  if (std::any_of(value.begin(), value.end(), [](unsigned char c) { return c < 32 || c == 127; }))
    throw InputError(pathOf(field.name), valueText(*found) + " has a control character");
}

void JsonReader::choice(const Field& field, int& index) {
  const Json* found = section(field.name);
  if (found == nullptr) return;
  const std::string path = pathOf(field.name);
  if (!found->is_string())
    throw InputError(path, valueText(*found) + " is not a text: one of " + joined(field.choices));
  const auto name = found->get<std::string>();
  const auto at = std::find(field.choices.begin(), field.choices.end(), name);
  if (at == field.choices.end())
    throw InputError(path, valueText(*found) + " is not one of " + joined(field.choices));
  index = static_cast<int>(at - field.choices.begin());
}

void JsonWriter::numbers(const Field& field, std::span<double> values, bool isList) {
  write(m_object, field, values, isList);
}

void JsonWriter::integers(const Field& field, std::span<int> values, bool isList) {
  write(m_object, field, values, isList);
}

void JsonWriter::flag(const Field& field, bool& value) {
  m_object[std::string(field.name)] = value;
}

void JsonWriter::text(const Field& field, std::string& value) {
  m_object[std::string(field.name)] = value;
}

void JsonWriter::choice(const Field& field, int& index) {
  m_object[std::string(field.name)] = field.choices[std::size_t(index)];
}

Override parseOverride(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::size_t dot = text.find('.');
  if (equals == std::string::npos || dot == std::string::npos || dot > equals)
    throw InputError("override " + text, "is not of the form section.field=value");
  const std::string written = text.substr(equals + 1);
  try {
    Json value = Json::accept(written) ? parseJson(written) : Json(written);
    return {text.substr(0, dot), text.substr(dot + 1, equals - dot - 1), std::move(value)};
  } catch (const InputError& error) {
    throw InputError("override " + text.substr(0, equals), error.what());
  }
}

Json parseJson(const std::string& text, JsonComments comments) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw InputError("is empty: not a session document", "");
  const bool areIgnored = comments == JsonComments::ignored;
  StructureCheck check(text);
  Json::sax_parse(text, &check, Json::input_format_t::json, true, areIgnored);
  return Json::parse(text, nullptr, true, areIgnored);
}

std::string formatJson(const Json& value) {
  std::string text;
  try {
    format(value, "", text);
  } catch (const Json::exception&) {  // what a library says of it
    throw InputError("document", "a name in it is not UTF-8");
  }
  return text + "\n";
}

}  // namespace hogelscope
