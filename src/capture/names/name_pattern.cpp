// SPDX-License-Identifier: BSD-3-Clause
#include "capture/names/name_pattern.h"

#include <algorithm>
#include <cctype>

#include "core/base/error.h"
#include "core/light_field/frames.h"

namespace hogelscope {

namespace {

using Token = NameToken;

bool isLetterAt(const std::string& text, std::size_t at) {
  return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
}

bool isDigitAt(const std::string& text, std::size_t at) {
  return at < text.size() && std::isdigit(static_cast<unsigned char>(text[at])) != 0;
}

void checkLength(const std::string& text, const char* field) {
  constexpr std::size_t longest = 255;  // as a file's name
  if (text.size() > longest) throw InputError(field, "is longer than a file's name can be");
}

void checkMeaning(const NamePattern& pattern) {
  std::string sorted = pattern.meaning();
  std::sort(sorted.begin(), sorted.end());
  for (const char* known : {"CR", "N", "xy", "x", "y"})
    if (sorted == known) return;
  throw InputError("lightField.pattern",
                   "\"" + pattern.text +
                       "\" names neither one row (RR) and one column (CC) nor one running number "
                       "(NNN) nor coordinates (x, y)");
}

/// Matches a name with a pattern. No position is tried twice, so that even with many stars the time
/// grows as name times pattern.
class NameMatch {
 public:
  NameMatch(const NamePattern& pattern, const std::string& name)
      : m_tokens(pattern.tokens), m_name(name), m_failed(m_tokens.size() * (name.size() + 1)) {}

  /// Returns the numbers and coordinates by their letters, the first of each; none if the name does
  /// not match.
  std::optional<std::map<char, std::string>> numbers() {
    if (!fits(0, 0)) return std::nullopt;
    return m_numbers;
  }

 private:
  /// Whether the tokens from `token` on match the name from `at` on.
  bool fits(std::size_t token, std::size_t at) {
    if (token == m_tokens.size()) return at == m_name.size();
    const std::size_t state = token * (m_name.size() + 1) + at;
    if (m_failed[state]) return false;
    const auto [least, most] = lengths(m_tokens[token], at);
    // A star matches as little as possible, so that the numbers after it are the first ones.
    const bool isStar = m_tokens[token].kind == Token::Kind::anything;
    for (std::size_t k = least; k <= most; ++k) {
      const std::size_t length = isStar ? k : most + least - k;
      if (!fits(token + 1, at + length)) continue;
      if (m_tokens[token].kind == Token::Kind::number ||
          m_tokens[token].kind == Token::Kind::coordinate)
        m_numbers[m_tokens[token].letter] = m_name.substr(at, length);
      return true;
    }
    m_failed[state] = true;
    return false;
  }

  /// Returns how many letters of the name the token can match: least to most; none if least > most.
  [[nodiscard]] std::pair<std::size_t, std::size_t> lengths(const Token& token,
                                                            std::size_t at) const {
    const auto run = [&](const char* letters) {
      return std::min(m_name.find_first_not_of(letters, at), m_name.size()) - at;
    };
    constexpr std::size_t mostDigits = 18;  // of an int64_t
    switch (token.kind) {
      case Token::Kind::number:
        return {1, std::min(run("0123456789"), mostDigits)};
      case Token::Kind::coordinate:
        return {1, run("-+0123456789.eE")};
      case Token::Kind::anything:
        return {0, m_name.size() - at};
      case Token::Kind::extension:
        return {1, std::min(m_name.find('.', at), m_name.size()) - at};
      default:
        return {1, at < m_name.size() && m_name[at] == token.letter ? 1 : 0};
    }
  }

  const std::vector<Token>& m_tokens;
  const std::string& m_name;
  std::vector<bool> m_failed;
  std::map<char, std::string> m_numbers;
};

}  // namespace

std::string NamePattern::meaning() const {
  std::string numbers;
  std::string coordinates;
  for (const Token& token : tokens) {
    if (token.kind == Token::Kind::number && token.letter != 'T') numbers += token.letter;
    if (token.kind == Token::Kind::coordinate) coordinates += token.letter;
  }
  return numbers.empty() ? coordinates : numbers;
}

NamePattern namePattern(const std::string& text) {
  using Kind = Token::Kind;
  checkLength(text, "lightField.pattern");
  NamePattern pattern{{}, text};
  for (std::size_t at = 0; at < text.size();) {
    if (text.compare(at, frameMark.size(), frameMark) == 0) {
      pattern.tokens.push_back({Kind::number, 'T'});
      at += frameMark.size();
      continue;
    }
    const char c = text[at];
    const std::size_t run = std::min(text.find_first_not_of(c, at), text.size()) - at;
    const bool isAlone = (at == 0 || !isLetterAt(text, at - 1)) && !isLetterAt(text, at + run);
    const bool isNumber = (c == 'R' || c == 'C' || c == 'N') && (run > 1 || isAlone);
    // Between digits, as in 1920x1080, no coordinate could be told from them.
    const bool isInNumber = at > 0 && isDigitAt(text, at - 1) && isDigitAt(text, at + 1);
    const bool isCoordinate = (c == 'x' || c == 'y') && run == 1 && isAlone && !isInNumber;
    pattern.tokens.push_back({isNumber       ? Kind::number
                              : isCoordinate ? Kind::coordinate
                              : c == '*'     ? Kind::anything
                                             : Kind::letter,
                              c});
    at += isNumber ? run : 1;
  }
  if (text.find('.') == std::string::npos) {
    pattern.tokens.push_back({Kind::letter, '.'});
    pattern.tokens.push_back({Kind::extension, '.'});
  }
  checkMeaning(pattern);
  return pattern;
}

NamePattern percentPattern(const std::string& text) {
  checkLength(text, "lightField.file");
  NamePattern pattern{{}, text};
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] != '%') {
      pattern.tokens.push_back({Token::Kind::letter, text[at++]});
      continue;
    }
    const std::size_t end = text.find_first_not_of("0123456789", at + 1);
    if (end == std::string::npos || text[end] != 'd')
      throw InputError("lightField.file", "\"" + text + "\": only %d and %02d stand for numbers");
    pattern.tokens.push_back({Token::Kind::number, pattern.meaning().empty() ? 'R' : 'C'});
    at = end + 1;
  }
  if (pattern.meaning() == "R")
    for (Token& token : pattern.tokens)
      if (token.kind == Token::Kind::number) token.letter = 'N';
  checkMeaning(pattern);
  return pattern;
}

std::optional<std::map<char, std::string>> numbersIn(const std::string& name,
                                                     const NamePattern& pattern) {
  return NameMatch(pattern, name).numbers();
}

std::string transposedPattern(const std::string& pattern) {
  if (pattern.empty() || pattern.find('%') != std::string::npos) return {};
  const NamePattern tokens = namePattern(pattern);
  const std::string meaning = tokens.meaning();
  if (meaning.size() < 2) return {};
  const auto exchanged = [](char letter) {
    return letter == 'R' ? 'C' : letter == 'C' ? 'R' : letter == 'x' ? 'y' : 'x';
  };
  std::string text = pattern;
  std::size_t at = 0;
  for (const Token& token : tokens.tokens) {
    if (at >= text.size()) break;  // an extension that the pattern does not name
    const bool isNumber = token.kind == Token::Kind::number;
    const std::size_t begin = at++;
    while (isNumber && at < text.size() && pattern[at] == token.letter) ++at;
    if (isNumber || token.kind == Token::Kind::coordinate)
      if (meaning.find(token.letter) != std::string::npos)
        std::fill(text.begin() + std::ptrdiff_t(begin), text.begin() + std::ptrdiff_t(at),
                  exchanged(token.letter));
  }
  return text;
}

}  // namespace hogelscope
