// SPDX-License-Identifier: BSD-3-Clause
// Finds a folder's views and reads their row and column from the file names.
#include "io/view_files.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <regex>
#include <set>

#include "core/error.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// A pattern as a regular expression, and what each of its groups means.
struct NamePattern {
  std::regex expression;
  std::string meaning;  ///< a letter for each group: R, C or N
  std::string text;     ///< as the user knows it
};

bool isLetter(const std::string& text, std::size_t at) {
  return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
}

std::string escaped(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 ? std::string(1, c)
                                                          : std::string("\\") + c;
}

/// RR, CC, NNN (or one such letter alone) are numbers, x and y alone are coordinates, * anything.
NamePattern fromTokens(const std::string& text) {
  std::string expression;
  std::string meaning;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    const std::size_t run = std::min(text.find_first_not_of(c, at), text.size()) - at;
    const bool isAlone = (at == 0 || !isLetter(text, at - 1)) && !isLetter(text, at + run);
    if ((c == 'R' || c == 'C' || c == 'N') && (run > 1 || isAlone)) {
      expression += "(\\d{1,9})";
      meaning += c;
      at += run;
    } else if ((c == 'x' || c == 'y') && run == 1 && isAlone) {
      expression += "[-+0-9.eE]+";
      ++at;
    } else {
      expression += c == '*' ? ".*" : escaped(c);
      ++at;
    }
  }
  if (text.find('.') == std::string::npos) expression += "\\.[^.]+";
  return {std::regex(expression), meaning, text};
}

/// printf's %d, %02d: row and column, or one running number.
NamePattern fromPercent(const std::string& text) {
  std::string expression;
  std::size_t numbers = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] != '%') {
      expression += escaped(text[at++]);
      continue;
    }
    const std::size_t end = text.find_first_not_of("0123456789", at + 1);
    if (end == std::string::npos || text[end] != 'd')
      throw InputError("lightField.file", "\"" + text + "\": only %d and %02d stand for numbers");
    expression += "(\\d{1,9})";
    ++numbers;
    at = end + 1;
  }
  return {std::regex(expression), numbers == 1 ? "N" : "RC", text};
}

void checkMeaning(const NamePattern& pattern) {
  std::string sorted = pattern.meaning;
  std::sort(sorted.begin(), sorted.end());
  if (sorted != "CR" && sorted != "N")
    throw InputError("lightField.pattern", "\"" + pattern.text +
                                               "\" names neither one row (RR) and one column (CC) "
                                               "nor one running number (NNN)");
}

using Found = std::map<std::pair<int, int>, fs::path>;  // (row, column), running number as (0, n)

int number(const std::string& digits) {
  int value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

Found matches(const fs::path& folder, const NamePattern& pattern) {
  Found found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    std::smatch groups;
    if (!std::regex_match(name, groups, pattern.expression)) continue;
    std::pair<int, int> key{0, 0};
    for (std::size_t g = 0; g < pattern.meaning.size(); ++g)
      (pattern.meaning[g] == 'R' ? key.first : key.second) = number(groups[g + 1].str());
    const auto [first, isNew] = found.emplace(key, entry.path());
    if (!isNew)
      throw InputError(folder.string(), "views",
                       name + " and " + first->second.filename().string() + " are the same view");
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
  ViewFiles grid{int(rows.size()), int(columns.size()), {}};
  for (const int row : rows) {
    for (const int column : columns) {
      const auto at = found.find({row, column});
      if (at == found.end())
        throw InputError(folder.string(), "views",
                         "row " + std::to_string(row) + ", column " + std::to_string(column) +
                             " is missing (" + std::to_string(rows.size()) + " rows and " +
                             std::to_string(columns.size()) + " columns were found)");
      grid.files.push_back(at->second);
    }
  }
  return grid;
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
    throw InputError(folder.string(), "views",
                     std::to_string(count) + " views do not make a grid of " +
                         std::to_string(columns) + "×" + std::to_string(rows) +
                         "; give display.directions");
  ViewFiles grid{rows, columns, {}};
  for (const auto& [key, file] : found) grid.files.push_back(file);
  return grid;
}

}  // namespace

ViewFiles findViews(const LightFieldParams& params, std::array<int, 2> directions) {
  fs::path folder = params.file;
  std::vector<NamePattern> patterns;
  const std::string last = folder.filename().string();
  if (last.find('%') != std::string::npos && !fs::exists(folder)) {
    patterns.push_back(fromPercent(last));
    folder = folder.parent_path().empty() ? "." : folder.parent_path();
  } else if (!params.pattern.empty()) {
    patterns.push_back(fromTokens(params.pattern));
  } else {
    for (const char* known :
         {"out_RR_CC_y_x", "input_CamNNN", "RRR_CCC"})  // Stanford, HCI, JPEG Pleno
      patterns.push_back(fromTokens(known));
  }
  if (!fs::is_directory(folder)) throw InputError(folder.string(), "", "there is no such folder");
  for (const NamePattern& pattern : patterns) {
    checkMeaning(pattern);
    const Found found = matches(folder, pattern);
    if (found.empty()) continue;
    return pattern.meaning == "N" ? runningGrid(found, directions, folder) : gridOf(found, folder);
  }
  std::string tried;
  for (const NamePattern& pattern : patterns) tried += (tried.empty() ? "" : ", ") + pattern.text;
  throw InputError(folder.string(), "views",
                   "no file name fits " + tried + "; give lightField.pattern");
}

}  // namespace hogelscope
