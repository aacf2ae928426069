// SPDX-License-Identifier: BSD-3-Clause
// Finds a folder's views and reads their row and column from the file names.
#include "io/layouts/view_files.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/base/error.h"
#include "io/files/folders.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// A pattern, token by token.
struct Token {
  enum class Kind { letter, number, coordinate, anything, extension } kind;
  char letter;  ///< itself, or R, C, N for what a number means
};

struct NamePattern {
  std::vector<Token> tokens;
  std::string text;  ///< the text of the user

  [[nodiscard]] std::string meaning() const {
    std::string letters;
    for (const Token& token : tokens)
      if (token.kind == Token::Kind::number) letters += token.letter;
    return letters;
  }
};

bool isLetter(const std::string& text, std::size_t at) {
  return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
}

void checkLength(const std::string& text, const char* field) {
  constexpr std::size_t longest = 255;  // as a file's name
  if (text.size() > longest) throw InputError(field, "is longer than a file's name can be");
}

/// RR, CC, NNN (or one such letter alone) are numbers, x and y alone are coordinates, * anything.
NamePattern fromTokens(const std::string& text) {
  using Kind = Token::Kind;
  checkLength(text, "lightField.pattern");
  NamePattern pattern{{}, text};
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    const std::size_t run = std::min(text.find_first_not_of(c, at), text.size()) - at;
    const bool isAlone = (at == 0 || !isLetter(text, at - 1)) && !isLetter(text, at + run);
    const bool isNumber = (c == 'R' || c == 'C' || c == 'N') && (run > 1 || isAlone);
    const bool isCoordinate = (c == 'x' || c == 'y') && run == 1 && isAlone;
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
  return pattern;
}

/// printf's %d, %02d: row and column, or one running number.
NamePattern fromPercent(const std::string& text) {
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
  return pattern;
}

/// Matches a name with a pattern. No position is tried twice, so that many stars cost no more than
/// name times pattern.
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
    // A star takes as little as it can, so that the numbers after it are the first ones.
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
    constexpr std::size_t mostDigits = 9;
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

void checkMeaning(const NamePattern& pattern) {
  std::string sorted = pattern.meaning();
  std::sort(sorted.begin(), sorted.end());
  if (sorted != "CR" && sorted != "N")
    throw InputError("lightField.pattern", "\"" + pattern.text +
                                               "\" names neither one row (RR) and one column (CC) "
                                               "nor one running number (NNN)");
}

/// A view's file, and the coordinates in its name.
struct FoundView {
  fs::path file;
  std::optional<double> x;
  std::optional<double> y;
};

using Found = std::map<std::pair<int, int>, FoundView>;  // (row, column), running number as (0, n)

int number(const std::string& digits) {
  int value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

std::optional<double> coordinate(const std::map<char, std::string>& numbers, char letter) {
  const auto found = numbers.find(letter);
  if (found == numbers.end()) return std::nullopt;
  const std::string& text = found->second;
  const char* const begin = text.data() + (text.front() == '+' ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  const bool isNumber = error == std::errc() && end == text.data() + text.size();
  return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

Found matches(const fs::path& folder, const NamePattern& pattern) {
  Found found;
  for (const fs::path& file : entriesOf(folder)) {
    const std::string name = file.filename().string();
    const auto numbers = NameMatch(pattern, name).numbers();
    if (!numbers) continue;
    std::pair<int, int> key{0, 0};
    for (const auto& [letter, digits] : *numbers)
      if (letter == 'R' || letter == 'C' || letter == 'N')
        (letter == 'R' ? key.first : key.second) = number(digits);
    const FoundView view{file, coordinate(*numbers, 'x'), coordinate(*numbers, 'y')};
    const auto [first, isNew] = found.emplace(key, view);
    if (!isNew)
      throw InputError(
          folder.string(), "views",
          name + " and " + first->second.file.filename().string() + " are the same view");
  }
  return found;
}

ViewFiles gridOf(const Found& found, const fs::path& folder) {
  std::set<int> rows;
  std::set<int> columns;
  for (const auto& [key, file] : found) {
    rows.insert(key.first);
    columns.insert(key.second);
  }
  ViewFiles grid{int(rows.size()), int(columns.size()), {}, {}, {}, {}};
  for (const int row : rows) {
    for (const int column : columns) {
      const auto at = found.find({row, column});
      if (at == found.end())
        throw InputError(folder.string(), "views",
                         "row " + std::to_string(row) + ", column " + std::to_string(column) +
                             " is missing (" + std::to_string(rows.size()) + " rows and " +
                             std::to_string(columns.size()) + " columns were found)");
      grid.files.push_back(at->second.file);
    }
  }
  return grid;
}

/// The mean coordinate of the first and of the last column (or row) of several.
std::optional<std::array<double, 2>> fromTo(const Found& found, int std::pair<int, int>::*number,
                                            std::optional<double> FoundView::*coordinate) {
  const auto less = [number](const auto& a, const auto& b) {
    return a.first.*number < b.first.*number;
  };
  const auto [least, most] = std::minmax_element(found.begin(), found.end(), less);
  if (least->first.*number == most->first.*number) return std::nullopt;
  const auto meanOf = [&](int which) -> std::optional<double> {
    double sum = 0;
    int count = 0;
    for (const auto& [key, view] : found) {
      if (key.*number != which) continue;
      if (!(view.*coordinate)) return std::nullopt;
      sum += *(view.*coordinate);
      ++count;
    }
    return sum / count;
  };
  const auto first = meanOf(least->first.*number);
  const auto last = meanOf(most->first.*number);
  if (!first || !last) return std::nullopt;
  return std::array{*first, *last};
}

/// One running number: row by row, a square grid unless the display says otherwise.
ViewFiles runningGrid(const Found& found, std::array<int, 2> directions, const fs::path& folder) {
  const auto count = int(found.size());
  const int first = found.begin()->first.second;
  const int last = found.rbegin()->first.second;
  for (int n = first; n <= last; ++n)
    if (!found.contains({0, n}))
      throw InputError(folder.string(), "views", "number " + std::to_string(n) + " is missing");
  const int side = int(std::lround(std::sqrt(double(count))));
  const auto [columns, rows] = directions[0] > 0 ? directions : std::array<int, 2>{side, side};
  if (columns * rows != count)
    throw InputError(
        folder.string(), "views",
        std::to_string(count) + " views do not make a grid of " + std::to_string(columns) + "×" +
            std::to_string(rows) +
            (directions[0] > 0 ? "; mend display.directions" : "; give display.directions"));
  ViewFiles grid{rows, columns, {}, {}, {}, {}};
  for (const auto& [key, view] : found) grid.files.push_back(view.file);
  return grid;
}

}  // namespace

std::string transposedPattern(const std::string& pattern) {
  if (pattern.find('%') != std::string::npos) return {};
  const NamePattern tokens = fromTokens(pattern);
  std::string text = pattern;
  std::size_t at = 0;
  for (const Token& token : tokens.tokens) {
    if (at >= text.size()) break;  // an extension that the pattern does not name
    if (token.kind != Token::Kind::number) {
      ++at;
      continue;
    }
    if (token.letter == 'N') return {};
    for (; at < text.size() && pattern[at] == token.letter; ++at)
      text[at] = token.letter == 'R' ? 'C' : 'R';
  }
  return text;
}

ViewFiles findViews(const LightFieldParams& params, std::array<int, 2> directions) {
  fs::path folder = params.file;
  std::error_code error;
  std::vector<NamePattern> patterns;
  const std::string last = folder.filename().string();
  if (last.find('%') != std::string::npos && !fs::exists(folder, error)) {
    patterns.push_back(fromPercent(last));
    folder = folder.parent_path().empty() ? "." : folder.parent_path();
  } else if (!params.pattern.empty()) {
    patterns.push_back(fromTokens(params.pattern));
  } else {
    // Stanford with and without the last stroke, HCI, JPEG Pleno, light-field-renderer.
    for (const char* known :
         {"out_RR_CC_y_x", "out_RR_CC_y_x_", "input_CamNNN", "RRR_CCC", "*_RR_CC_y_x_*"})
      patterns.push_back(fromTokens(known));
  }
  const fs::file_type type = fs::status(folder, error).type();
  if (type == fs::file_type::none)
    throw InputError(folder.string(), "cannot be read", error.message());
  if (type != fs::file_type::directory)
    throw InputError(folder.string(), "",
                     type == fs::file_type::not_found
                         ? "there is no such folder"
                         : "is a file; layout \"views\" reads a folder");
  for (const NamePattern& pattern : patterns) {
    checkMeaning(pattern);
    const Found found = matches(folder, pattern);
    if (found.empty()) continue;
    const bool isRunning = pattern.meaning() == "N";
    ViewFiles views = isRunning ? runningGrid(found, directions, folder) : gridOf(found, folder);
    views.pattern = pattern.text;
    if (isRunning) return views;
    views.columnsFromTo = fromTo(found, &std::pair<int, int>::second, &FoundView::x);
    views.rowsFromTo = fromTo(found, &std::pair<int, int>::first, &FoundView::y);
    return views;
  }
  if (const fs::path red = folder / "0"; folder == params.file && fs::is_directory(red, error)) {
    LightFieldParams components = params;  // PgxRows finds the others
    components.file = red.string();
    return findViews(components, directions);
  }
  std::string tried;
  for (const NamePattern& pattern : patterns) tried += (tried.empty() ? "" : ", ") + pattern.text;
  throw InputError(folder.string(), "views",
                   "no file name fits " + tried + "; give lightField.pattern");
}

}  // namespace hogelscope
