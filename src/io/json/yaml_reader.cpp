// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/yaml_reader.h"

#include <yaml.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <new>

#include "core/base/error.h"

namespace hogelscope {

namespace {

bool isOfName(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

/// Replaces OpenCV's extensions of YAML: the first line, %YAML:1.0; \' within quotes; no space
/// after a name's colon, "{ x:1, at:[ 2, 3 ] }". Line numbers are kept.
std::string standardYaml(const std::string& text) {
  std::string yaml;
  yaml.reserve(text.size());
  bool isQuoted = false;
  bool isName = false;  // so far on this line, after this brace or comma
  const std::size_t begin = std::min(text.starts_with('%') ? text.find('\n') : 0, text.size());
  for (std::size_t at = begin; at < text.size(); ++at) {
    const char c = text[at];
    if (!isQuoted && c == '#' && (yaml.ends_with(' ') || yaml.ends_with('\n'))) {
      at = std::min(text.find('\n', at), text.size()) - 1;  // ignores quotes in comments
      continue;
    }
    if (isQuoted && c == '\\' && at + 1 < text.size()) {
      if (text[++at] != '\'') yaml += c;
      yaml += text[at];
      continue;
    }
    yaml += c;
    if (c == '"') isQuoted = !isQuoted;
    if (!isQuoted && isName && c == ':') yaml += ' ';
    const bool mayBegin = c == '\n' || c == '{' || c == ',';
    isName = !isQuoted && (mayBegin || (isName && (c == ' ' || isOfName(c))));
  }
  return yaml;
}

Json scalarOf(const yaml_event_t& event) {
  const auto& scalar = event.data.scalar;
  const std::string text(reinterpret_cast<const char*>(scalar.value), scalar.length);
  if (scalar.style != YAML_PLAIN_SCALAR_STYLE) return text;
  const auto reads = [begin = text.data(), end = text.data() + text.size()](auto& number) {
    const auto [at, error] = std::from_chars(begin, end, number);
    return error == std::errc() && at == end;
  };
  int integer = 0;
  if (reads(integer)) return integer;
  double real = 0;
  if (reads(real) && std::isfinite(real)) return real;
  return text;
}

/// Reads libyaml's events one by one, so that the parser stops where this reader does. libyaml's
/// loader builds whole documents first, which takes minutes for a megabyte of brackets.
class Events {
 public:
  explicit Events(const std::string& yaml) : m_yaml(yaml) {
    if (yaml_parser_initialize(&m_parser) == 0) throw std::bad_alloc();
    yaml_parser_set_encoding(&m_parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&m_parser, reinterpret_cast<const unsigned char*>(yaml.data()),
                                 yaml.size());
  }
  Events(const Events&) = delete;
  Events& operator=(const Events&) = delete;
  ~Events() {
    yaml_event_delete(&m_event);
    yaml_parser_delete(&m_parser);
  }

  [[nodiscard]] const yaml_event_t& current() const { return m_event; }

  yaml_event_type_t next() {
    yaml_event_delete(&m_event);
    if (yaml_parser_parse(&m_parser, &m_event) != 0) return m_event.type;
    if (m_parser.error == YAML_MEMORY_ERROR) throw std::bad_alloc();
    refuse(m_parser.error == YAML_READER_ERROR ? linesBefore(m_parser.problem_offset)
                                               : m_parser.problem_mark.line,
           std::string("is not YAML: ") + m_parser.problem);
  }

  /// Throws InputError about the last event.
  [[noreturn]] void refuse(const std::string& why) const { refuse(m_event.start_mark.line, why); }

 private:
  [[noreturn]] static void refuse(std::size_t line, const std::string& why) {
    throw InputError("line " + std::to_string(line + 1), why);
  }

  [[nodiscard]] std::size_t linesBefore(std::size_t byte) const {
    const auto end = m_yaml.begin() + std::ptrdiff_t(std::min(byte, m_yaml.size()));
    return std::size_t(std::count(m_yaml.begin(), end, '\n'));
  }

  const std::string& m_yaml;
  yaml_parser_t m_parser{};
  yaml_event_t m_event{};
};

/// Reads the value that the current event is or starts.
Json valueOf(Events& events, int depth);

/// Reads up to the end of the mapping that the current event starts.
void addKeys(Events& events, Json& object, int depth) {
  while (events.next() != YAML_MAPPING_END_EVENT) {
    if (events.current().type != YAML_SCALAR_EVENT) events.refuse("a name is not a text");
    const auto& name = events.current().data.scalar;
    const std::string key(reinterpret_cast<const char*>(name.value), name.length);
    if (object.contains(key)) events.refuse("\"" + key + "\" stands twice");
    if (object.size() == mostKeys) events.refuse("has more names than any calibration");
    events.next();
    object[key] = valueOf(events, depth + 1);
  }
}

Json valueOf(Events& events, int depth) {
  if (depth > deepestDocument) events.refuse("is nested deeper than any calibration");
  switch (events.current().type) {
    case YAML_SCALAR_EVENT:
      return scalarOf(events.current());
    case YAML_MAPPING_START_EVENT: {
      Json object = Json::object();
      addKeys(events, object, depth);
      return object;
    }
    case YAML_SEQUENCE_START_EVENT: {
      Json list = Json::array();
      while (events.next() != YAML_SEQUENCE_END_EVENT) list.push_back(valueOf(events, depth + 1));
      return list;
    }
    default:
      events.refuse("repeats another part of the file (*); write it out");
  }
}

/// Calls `visit` where a document's mapping begins.
template <class Visit>
void visitDocuments(Events& events, const Visit& visit) {
  for (auto type = events.next(); type != YAML_STREAM_END_EVENT; type = events.next()) {
    const bool isEmpty = type == YAML_SCALAR_EVENT && events.current().data.scalar.length == 0;
    if (type == YAML_MAPPING_START_EVENT)
      visit();
    else if (type == YAML_SEQUENCE_START_EVENT || (type == YAML_SCALAR_EVENT && !isEmpty))
      events.refuse("is not of the form NAME: VALUE");
  }
}

}  // namespace

Json parseOpenCvYaml(const std::string& text) {
  const std::string yaml = standardYaml(text);
  Events events(yaml);
  Json document = Json::object();
  visitDocuments(events, [&] { addKeys(events, document, 0); });
  return document;
}

std::vector<Json> parseYaml(const std::string& text) {
  Events events(text);
  std::vector<Json> documents;
  visitDocuments(events, [&] { addKeys(events, documents.emplace_back(Json::object()), 0); });
  return documents;
}

}  // namespace hogelscope
