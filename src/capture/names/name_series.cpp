// SPDX-License-Identifier: BSD-3-Clause
#include "capture/names/name_series.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <string_view>

#include "capture/names/name_pattern.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Splits a name into texts and numbers.
class PartReader {
 public:
  explicit PartReader(const std::string& name) : m_name(name), m_stem(name.rfind('.')) {
    if (m_stem != std::string::npos &&
        m_name.find_first_not_of("0123456789", m_stem + 1) == std::string::npos)
      m_stem = std::string::npos;  // "cam_12.5" has no extension
  }

  NameParts read() {
    NameParts parts{""};
    for (std::size_t at = 0; at < m_name.size();) {
      std::string number;
      std::size_t end = endOfTime(at, number);
      if (end == at) {
        end = endOfNumber(at);
        number = m_name.substr(at, end - at);
      }
      if (end == at) {
        parts.back() += m_name[at++];
        continue;
      }
      parts.push_back(number);
      parts.emplace_back();
      at = end;
    }
    return parts;
  }

 private:
  [[nodiscard]] char at(std::size_t place) const {
    return place < m_name.size() ? m_name[place] : '\0';
  }
  [[nodiscard]] std::size_t endOfDigits(std::size_t begin) const {
    while (isDigit(at(begin))) ++begin;
    return begin;
  }
  [[nodiscard]] static bool isSign(char c) { return c == '+' || c == '-'; }

  /// Whether there is a sign; a hyphen between words, as in view-01, is none.
  [[nodiscard]] bool isSignAt(std::size_t place) const {
    if (!isSign(at(place)) || !isDigit(at(place + 1))) return false;
    if (place == 0) return true;
    const char before = at(place - 1);
    const bool isAxis = std::string_view("xyXY").find(before) != std::string_view::npos &&
                        (place == 1 || !isLetter(at(place - 2)));
    return isAxis || std::string_view("_ ,(=").find(before) != std::string_view::npos;
  }

  [[nodiscard]] std::size_t endOfNumber(std::size_t begin) const {
    const std::size_t digits = begin + (isSignAt(begin) ? 1 : 0);
    std::size_t end = endOfDigits(digits);
    if (end == digits) return begin;
    const bool isAfterPoint =
        begin > 0 && at(begin - 1) == '.';  // "render.3.4.exr" has two numbers
    if (end != m_stem && !isAfterPoint && at(end) == '.' && isDigit(at(end + 1)))
      end = endOfDigits(end + 1);
    if ((at(end) == 'e' || at(end) == 'E') && isSign(at(end + 1)) && isDigit(at(end + 2)))
      end = endOfDigits(end + 2);
    return end;
  }

  /// Returns the end of a date with a time, such as 20240102_101530123 or 2024-01-02 10.15.30, and
  /// its digits; `begin` if there is none.
  [[nodiscard]] std::size_t endOfTime(std::size_t begin, std::string& digits) const {
    constexpr std::array<std::size_t, 6> lengths{4, 2, 2, 2, 2, 2};  // year … second
    constexpr std::array least{1990, 1, 1, 0, 0, 0}, most{2099, 12, 31, 23, 59, 60};
    if (begin > 0 && isDigit(at(begin - 1))) return begin;
    std::string found;
    std::size_t end = begin;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
      if (k > 0 && std::string_view("-_. :T").find(at(end)) != std::string_view::npos) ++end;
      if (endOfDigits(end) < end + lengths[k]) return begin;
      const std::string part = m_name.substr(end, lengths[k]);
      if (const int value = std::atoi(part.c_str()); value < least[k] || value > most[k])
        return begin;
      found += part;
      end += lengths[k];
    }
    constexpr std::size_t ofMilliseconds = 3;
    const std::size_t more = endOfDigits(end) - end;
    if (more != 0 && more != ofMilliseconds) return begin;
    digits = found + m_name.substr(end, more);
    return end + more;
  }

  const std::string& m_name;
  std::size_t m_stem;
};

bool isInteger(const std::string& text) {
  constexpr std::size_t mostDigits =
      18;  // of an int64_t, or 19, as those of nanoseconds since 1970
  return text.size() <= mostDigits + (text.starts_with('1') ? 1 : 0) &&
         std::all_of(text.begin(), text.end(), isDigit);
}

/// The numbers at one place of a series' names.
struct NumberColumn {
  std::size_t part = 0;
  bool varies = false;
  bool areIntegers = true;
  bool areNumbers = true;  ///< short enough to be read
  std::size_t digits = 0;  ///< of each; 0 if they differ
  char axis = ' ';         ///< C or R if the text before it means column (x) or row (y)
};

/// Returns the axis of a number from the last word of the text before it, such as "…_x", "col-".
char axisOf(std::string text) {
  if (!text.empty() && !isLetter(text.back())) text.pop_back();
  std::size_t begin = text.size();
  while (begin > 0 && isLetter(text[begin - 1])) --begin;
  const std::string word = lowerCase(text.substr(begin));
  for (const char* column : {"x", "c", "u", "s", "col", "column"})
    if (word == column) return 'C';
  for (const char* row : {"y", "r", "v", "t", "row"})
    if (word == row) return 'R';
  return ' ';
}

std::vector<NumberColumn> columnsOf(const NameSeries& series) {
  constexpr std::size_t mostLetters = 32;
  std::vector<NumberColumn> columns;
  const NameParts& first = series.parts.front();
  for (std::size_t part = 1; part < first.size(); part += 2) {
    NumberColumn column{part, false, true, true, first[part].size(), axisOf(first[part - 1])};
    for (const NameParts& parts : series.parts) {
      column.varies = column.varies || parts[part] != first[part];
      column.areIntegers = column.areIntegers && isInteger(parts[part]);
      column.areNumbers = column.areNumbers && parts[part].size() <= mostLetters;
      if (parts[part].size() != first[part].size()) column.digits = 0;
    }
    columns.push_back(column);
  }
  return columns;
}

/// Collects the readings of a series.
class Readings {
 public:
  explicit Readings(const NameSeries& series) : m_series(series), m_columns(columnsOf(series)) {
    constexpr std::size_t most = 6;  // of which all pairs are tried
    for (const NumberColumn& column : m_columns)
      if (column.varies && column.areNumbers && m_varying.size() < most)
        m_varying.push_back(column);
  }

  std::vector<std::vector<SeriesReading>> all() && {
    addPairs(true);
    endKind();
    addRow();
    endKind();
    addPairs(false);
    endKind();
    const auto integers = std::count_if(m_varying.begin(), m_varying.end(),
                                        [](const NumberColumn& c) { return c.areIntegers; });
    for (const NumberColumn& column : m_varying)
      if (column.areIntegers && (integers == 1 || isCounting(column)))
        m_readings.push_back({{'N', column.part}});
    endKind();
    for (const NumberColumn& column : m_varying)
      if (!column.areIntegers)
        m_readings.push_back({{column.axis == 'R' ? 'y' : 'x', column.part}});
    endKind();
    return std::move(m_kinds);
  }

 private:
  void endKind() {
    m_kinds.push_back(std::move(m_readings));
    m_readings.clear();
  }

  static bool isTurned(const NumberColumn& first, const NumberColumn& second, bool isRowFirst) {
    if (first.axis == 'C' && second.axis == 'R') return isRowFirst;
    if (first.axis == 'R' && second.axis == 'C') return !isRowFirst;
    return false;
  }

  /// Whether the numbers are consecutive, each of them once.
  [[nodiscard]] bool isCounting(const NumberColumn& column) const {
    std::set<std::int64_t> numbers;
    for (const NameParts& parts : m_series.parts)
      numbers.insert(viewNamed({}, {{'N', parts[column.part]}}).number.value_or(0));
    return numbers.size() == m_series.parts.size() &&
           *numbers.rbegin() - *numbers.begin() + 1 == std::int64_t(numbers.size());
  }

  /// Adds pairs: rows before columns, as in all known names, or x before y.
  void addPairs(bool areNumbers) {
    for (std::size_t b = 1; b < m_varying.size(); ++b)
      for (std::size_t a = 0; a < b; ++a) {
        const NumberColumn& first = m_varying[a];
        const NumberColumn& second = m_varying[b];
        if ((first.areIntegers && second.areIntegers) != areNumbers) continue;
        SeriesReading reading{{areNumbers ? 'R' : 'x', first.part},
                              {areNumbers ? 'C' : 'y', second.part}};
        if (isTurned(first, second, areNumbers))
          std::swap(reading.begin()->second, reading.rbegin()->second);
        if (areNumbers) addPositions(reading);
        m_readings.push_back(reading);
      }
  }

  /// Adds y and x, in the order of Stanford's names, if exactly two more numbers vary.
  void addPositions(SeriesReading& reading) const {
    std::vector<NumberColumn> others;
    for (const NumberColumn& column : m_varying)
      if (column.part != reading['R'] && column.part != reading['C']) others.push_back(column);
    if (others.size() != 2) return;
    const bool isXFirst = isTurned(others[0], others[1], true);
    reading['y'] = others[isXFirst ? 1 : 0].part;
    reading['x'] = others[isXFirst ? 0 : 1].part;
  }

  /// Adds a single row or column, whose other number is constant: 004_000, 004_001, …
  void addRow() {
    for (std::size_t k = 1; k < m_columns.size(); ++k) {
      const NumberColumn& first = m_columns[k - 1];
      const NumberColumn& second = m_columns[k];
      const std::string& between = m_series.parts.front()[second.part - 1];
      const bool areAlike = first.areIntegers && second.areIntegers && first.digits > 1 &&
                            first.digits == second.digits && first.varies != second.varies;
      if (areAlike && std::none_of(between.begin(), between.end(), isLetter))
        m_readings.push_back({{'R', first.part}, {'C', second.part}});
    }
  }

  const NameSeries& m_series;
  std::vector<NumberColumn> m_columns;
  std::vector<NumberColumn> m_varying;
  std::vector<SeriesReading> m_readings;
  std::vector<std::vector<SeriesReading>> m_kinds;
};

/// Whether the pattern finds the reading's numbers in a name.
bool isRead(const NamePattern& pattern, const std::string& name, const NameParts& parts,
            const SeriesReading& reading) {
  const auto numbers = numbersIn(name, pattern);
  return numbers && std::all_of(reading.begin(), reading.end(), [&](const auto& meaning) {
           const auto found = numbers->find(meaning.first);
           return found != numbers->end() && found->second == parts[meaning.second];
         });
}

/// Whether a pattern can contain the text unchanged, between the letters before and after it.
bool isPlain(const std::string& text, char before, char after) {
  if (text.empty()) return true;
  const auto touches = [](char letter, char meaning) {
    return meaning == 'x' || meaning == 'y' ? isLetter(letter) : letter == meaning;
  };
  if (touches(text.front(), before) || touches(text.back(), after)) return false;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '*') return false;
    if (c != 'R' && c != 'C' && c != 'N' && c != 'x' && c != 'y') continue;
    const bool isAlone =
        (at == 0 || !isLetter(text[at - 1])) && (at + 1 == text.size() || !isLetter(text[at + 1]));
    const bool isAxis = c == 'x' || c == 'y';
    const bool isRun = at + 1 < text.size() && text[at + 1] == c && !isAxis;
    const bool isInNumber =
        isAxis && at > 0 && at + 1 < text.size() && isDigit(text[at - 1]) && isDigit(text[at + 1]);
    if ((isAlone && !isInNumber) || isRun) return false;
  }
  return true;
}

/// Returns the letter that stands alone before the first number of a series' names, such as the A
/// of "view_A1.png"; 0 if there is none.
char letterOf(const NameSeries& series) {
  const NameParts& parts = series.parts.front();
  if (parts.size() < 3 || parts.front().empty()) return 0;
  const std::string& text = parts.front();
  const bool isAlone =
      isLetter(text.back()) && (text.size() < 2 || !isLetter(text[text.size() - 2]));
  return isAlone ? text.back() : char(0);
}

/// Whether series have the letters from A on, without a gap, and as many files each; "c1" and "d1"
/// are rather colours and depths.
bool areLines(const std::vector<NameSeries*>& group) {
  for (std::size_t k = 0; k < group.size(); ++k)
    if ((letterOf(*group[k]) | 0x20) != int('a' + k) ||
        group[k]->files.size() != group.front()->files.size())
      return false;
  return group.size() > 1;
}

/// Joins series that differ in the letter before their first numbers alone.
std::vector<NameSeries> withLetters(std::vector<NameSeries> all) {
  std::map<std::string, std::vector<NameSeries*>> alike;
  for (NameSeries& series : all) {
    const char letter = letterOf(series);
    if (letter == 0 || series.files.size() < 2) continue;
    std::string texts(1, letter < 'a' ? 'A' : 'a');
    const NameParts& parts = series.parts.front();
    texts += parts.front().substr(0, parts.front().size() - 1);
    for (std::size_t k = 2; k < parts.size(); k += 2) texts += '/' + parts[k];
    alike[texts].push_back(&series);
  }
  for (const auto& [texts, group] : alike) {
    if (!areLines(group)) continue;
    NameSeries joined;
    for (NameSeries* const one : group) {
      const int place = (letterOf(*one) | 0x20) - 'a' + 1;
      for (NameParts& parts : one->parts) {
        parts.front().pop_back();
        parts.insert(parts.begin() + 1, {std::to_string(place), ""});
        joined.parts.push_back(std::move(parts));
      }
      joined.files.insert(joined.files.end(), one->files.begin(), one->files.end());
      one->files.clear();
    }
    all.push_back(std::move(joined));
  }
  std::erase_if(all, [](const NameSeries& series) { return series.files.empty(); });
  return all;
}

}  // namespace

std::string nameBelow(const fs::path& folder, const fs::path& file) {
  const std::string& all = file.native();
  const std::size_t begin = all.find_first_not_of('/', folder.native().size());
  const bool isBelow = all.starts_with(folder.native()) && begin != std::string::npos;
  return isBelow ? all.substr(begin) : file.filename().string();
}

std::vector<NameSeries> seriesOf(const fs::path& folder, const std::vector<fs::path>& files) {
  std::map<std::string, NameSeries> series;
  for (const fs::path& file : files) {
    NameParts parts = PartReader(nameBelow(folder, file)).read();
    std::string texts;
    for (std::size_t k = 0; k < parts.size(); k += 2) texts += parts[k] + '/';
    NameSeries& own = series[texts];
    own.files.push_back(file);
    own.parts.push_back(std::move(parts));
  }
  std::vector<NameSeries> result;
  result.reserve(series.size());
  for (auto& [texts, own] : series) result.push_back(std::move(own));
  return withLetters(std::move(result));
}

std::vector<std::vector<SeriesReading>> readingsOf(const NameSeries& series) {
  return Readings(series).all();
}

std::vector<NamedView> viewsOf(const NameSeries& series, const SeriesReading& reading) {
  std::vector<NamedView> views;
  for (std::size_t k = 0; k < series.files.size(); ++k) {
    std::map<char, std::string> numbers;
    for (const auto& [letter, part] : reading) numbers[letter] = series.parts[k][part];
    views.push_back(viewNamed(series.files[k], numbers));
  }
  return views;
}

std::string patternOf(const fs::path& folder, const NameSeries& series,
                      const SeriesReading& reading) {
  const NameParts& first = series.parts.front();
  std::map<std::size_t, char> letters;
  for (const auto& [letter, part] : reading) letters[part] = letter;
  std::string text;
  std::string pending;
  char before = ' ';
  const auto put = [&](char after) {
    text += isPlain(pending, before, after) ? pending : "*";
    pending.clear();
    before = after;
  };
  for (std::size_t part = 0; part < first.size(); ++part) {
    const auto meaning = letters.find(part);
    if (meaning == letters.end()) {
      const bool varies = part % 2 == 1 && std::any_of(series.parts.begin(), series.parts.end(),
                                                       [&](const NameParts& parts) {
                                                         return parts[part] != first[part];
                                                       });
      pending += varies ? "*" : first[part];
      continue;
    }
    const char letter = meaning->second;
    put(letter);
    const bool isCoordinate = letter == 'x' || letter == 'y';
    text += std::string(isCoordinate ? 1 : std::max<std::size_t>(first[part].size(), 2), letter);
  }
  put(' ');
  try {
    const NamePattern pattern = namePattern(text);
    constexpr std::size_t mostTried = 200;
    const std::size_t step = series.files.size() / mostTried + 1;
    for (std::size_t k = 0; k < series.files.size(); k += step)
      if (!isRead(pattern, nameBelow(folder, series.files[k]), series.parts[k], reading)) return {};
  } catch (const InputError&) {
    return {};
  }
  return text;
}

}  // namespace hogelscope
