// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/xml_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

constexpr std::string_view xmlBlanks = " \t\r\n";

class XmlReader {
 public:
  explicit XmlReader(std::string_view text) : m_text(text) {}

  Json root() {
    skip();
    if (!takes("<")) refuse("is not XML: an element begins with <");
    (void)name();
    if (takeAttributes()) return Json::object();
    Json document = content(0);
    skip();
    if (m_at != m_text.size()) refuse("is not XML: something follows the last element");
    return document;
  }

 private:
  [[nodiscard]] std::string_view rest() const { return m_text.substr(m_at); }

  bool takes(std::string_view text) {
    if (!rest().starts_with(text)) return false;
    m_at += text.size();
    return true;
  }

  /// Moves behind the next `end`.
  void skipTo(std::string_view end) {
    const std::size_t found = m_text.find(end, m_at);
    if (found == std::string_view::npos)
      refuse("is not XML: \"" + std::string(end) + "\" is missing");
    m_at = found + end.size();
  }

  /// Skips spaces, comments and declarations.
  void skip() {
    for (;;) {
      m_at = std::min(m_text.find_first_not_of(xmlBlanks, m_at), m_text.size());
      if (takes("<!--"))
        skipTo("-->");
      else if (takes("<?"))
        skipTo("?>");
      else if (rest().starts_with("<!"))
        refuse("has a document type or a section of text (<!), which is not read");
      else
        return;
    }
  }

  std::string name() {
    const std::size_t begin = m_at;
    const auto isOfName = [](char c) {
      return c != '>' && c != '/' && c != '<' && c != '=' && xmlBlanks.find(c) == xmlBlanks.npos;
    };
    while (m_at < m_text.size() && isOfName(m_text[m_at])) ++m_at;
    if (m_at == begin) refuse("is not XML: an element has no name");
    return std::string(m_text.substr(begin, m_at - begin));
  }

  /// Skips an element's attributes and its >. Returns whether it ends there, with />.
  bool takeAttributes() {
    while (m_at < m_text.size()) {
      const char c = m_text[m_at++];
      if (c == '>') return false;
      if (c == '/' && takes(">")) return true;
      if (c == '"' || c == '\'') skipTo(std::string_view(&c, 1));
      if (c == '<') break;
    }
    refuse("is not XML: an element has no >");
  }

  /// Reads what is in an element, and its end. Lists have words and items (_) one after the other.
  Json content(int depth) {
    if (depth > deepestDocument) refuse("is nested deeper than any calibration");
    std::string words;
    Json elements;
    for (;;) {
      const std::size_t end = std::min(m_text.find('<', m_at), m_text.size());
      words += m_text.substr(m_at, end - m_at);
      m_at = end;
      skip();
      if (takes("</")) break;
      if (!takes("<")) refuse("is not XML: an element has no end");
      add(elements, words, depth);
    }
    (void)name();
    skip();
    if (!takes(">")) refuse("is not XML: an element has no end");
    if (elements.is_object()) return elements;
    const bool isList = elements.is_array();
    addWords(elements, words);
    if (isList || elements.size() > 1) return elements;
    return elements.is_null() ? Json("") : elements[0];
  }

  /// Reads an element into a list or an object, after the words before it.
  void add(Json& elements, std::string& words, int depth) {
    const std::string key = name();
    const bool isItem = key == "_";
    if (isItem) addWords(elements, words);
    Json value = takeAttributes() ? Json("") : content(depth + 1);
    if (elements.is_null()) elements = isItem ? Json::array() : Json::object();
    if (isItem != elements.is_array()) refuse("has items (_) beside names");
    if (isItem) return elements.push_back(std::move(value));
    if (elements.contains(key)) refuse("\"" + printable(key) + "\" stands twice");
    if (elements.size() == mostKeys) refuse("has more names than any calibration");
    elements[key] = std::move(value);
  }

  /// Adds words, numbers or what stands in quotes, to a list, and takes them away.
  void addWords(Json& list, std::string& text) const {
    std::string_view words = text;
    for (;;) {
      words.remove_prefix(std::min(words.find_first_not_of(xmlBlanks), words.size()));
      if (words.empty()) break;
      const std::size_t quote = words[0] == '"' ? 1 : 0;
      const std::size_t end =
          std::min(quote == 1 ? words.find('"', 1) : words.find_first_of(xmlBlanks), words.size());
      const std::string word = plainText(words.substr(quote, end - quote));
      words.remove_prefix(std::min(end + quote, words.size()));
      list.push_back(quote == 1 ? Json(word) : scalarOf(word));
    }
    text.clear();
  }

  /// Returns a text with the characters that its entities stand for.
  [[nodiscard]] std::string plainText(std::string_view text) const {
    std::string plain;
    while (!text.empty()) {
      if (text[0] == '&') {
        plain += takeEntity(text);
      } else {
        plain += text[0];
        text.remove_prefix(1);
      }
    }
    return plain;
  }

  /// Takes an entity from the front of a text: a character of XML itself, or a control character as
  /// cv::FileStorage writes it.
  char takeEntity(std::string_view& text) const {
    constexpr std::array<std::pair<std::string_view, char>, 5> known{
        {{"&lt;", '<'}, {"&gt;", '>'}, {"&amp;", '&'}, {"&quot;", '"'}, {"&apos;", '\''}}};
    for (const auto& [name, character] : known)
      if (text.starts_with(name)) {
        text.remove_prefix(name.size());
        return character;
      }
    constexpr std::string_view hexadecimal = "&#x";
    const std::size_t semicolon = text.find(';');
    if (text.starts_with(hexadecimal) && semicolon <= hexadecimal.size() + 2) {
      const std::string digits(text.substr(hexadecimal.size(), semicolon - hexadecimal.size()));
      text.remove_prefix(semicolon + 1);
      return static_cast<char>(std::strtol(digits.c_str(), nullptr, 16));
    }
    refuse("has an entity that is not known: " + printable(std::string(text.substr(0, 8))));
  }

  static Json scalarOf(std::string_view word) {
    int whole = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), whole);
    if (error == std::errc() && stop == word.data() + word.size()) return whole;
    const std::optional<double> number = numberOf(word);
    return number && std::isfinite(*number) ? Json(*number) : Json(std::string(word));
  }

  [[noreturn]] void refuse(const std::string& why) const {
    const auto end = m_text.begin() + std::ptrdiff_t(std::min(m_at, m_text.size()));
    throw InputError("line " + std::to_string(1 + std::count(m_text.begin(), end, '\n')), why);
  }

  std::string_view m_text;
  std::size_t m_at = 0;
};

}  // namespace

Json parseOpenCvXml(const std::string& text) {
  return XmlReader(text).root();
}

}  // namespace hogelscope
