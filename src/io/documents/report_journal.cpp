// SPDX-License-Identifier: BSD-3-Clause
// A report's journal: appended with one write per row, read up to the first line that is not
// complete.
#include "io/documents/report_journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "io/files/atomic_file.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view headOfAny = R"({"hogelscope report":1,)";

std::string headOf(const std::string& key) {
  return Json{{"hogelscope report", 1}, {"key", key}}.dump() + "\n";
}

/// A number, as the shortest digits that read back as it; JSON has no infinite numbers and no NaN.
Json jsonNumber(double value) {
  return std::isinf(value) ? Json("inf") : Json(value);  // nlohmann writes null for NaN
}

double number(const Json& value) {
  if (value.is_null()) return std::numeric_limits<double>::quiet_NaN();
  if (value == "inf") return std::numeric_limits<double>::infinity();
  return value.get<double>();
}

std::string lineOf(std::size_t row, const std::vector<double>& values, const std::string& problem) {
  Json list = Json::array();
  for (const double value : values) list.push_back(jsonNumber(value));
  return Json{{"row", row}, {"values", list}, {"problem", problem}}.dump(
             -1, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

ReportJournal::Entry entryOf(const Json& line) {
  ReportJournal::Entry entry;
  for (const Json& value : line.at("values")) entry.values.push_back(number(value));
  entry.problem = line.at("problem").get<std::string>();
  return entry;
}

}  // namespace

ReportJournal::ReportJournal(const fs::path& folder, const std::string& key)
    : m_file(folder / "report.journal") {
  requireOurs(m_file, headOfAny);
  auto descriptor = openLocked(m_file, O_APPEND);
  if (!descriptor)
    throw InputError(m_file.string(), "is in use",
                     "another hogelscope makes this report; wait, or choose another folder");
  m_descriptor = std::move(*descriptor);
  const std::uintmax_t used = read(headOf(key));
  if (::ftruncate(m_descriptor.get(), static_cast<off_t>(used)) != 0)
    throw InputError(m_file.string(), "cannot be written", std::strerror(errno));
  if (used == 0) writeAll(m_descriptor.get(), headOf(key), m_file);
}

/// Reads the rows. Returns the number of bytes up to the first line that is not a complete row.
std::uintmax_t ReportJournal::read(const std::string& head) {
  std::ifstream in(m_file, std::ios::binary);
  if (!in) throw InputError(m_file.string(), "cannot be read", std::strerror(errno));
  std::string text;
  if (!std::getline(in, text) || in.eof()) return 0;
  m_replacedAnother = text + "\n" != head;
  if (m_replacedAnother) return 0;
  std::uintmax_t used = head.size();
  while (std::getline(in, text) && !in.eof()) {
    const Json line = Json::parse(text, nullptr, false);
    try {
      m_entries[line.at("row").get<std::size_t>()] = entryOf(line);
    } catch (const Json::exception&) {
      break;
    }
    used += text.size() + 1;
  }
  return used;
}

void ReportJournal::add(std::size_t row, const std::vector<double>& values,
                        const std::string& problem) {
  writeAll(m_descriptor.get(), lineOf(row, values, problem), m_file);
}

void ReportJournal::remove() {
  std::error_code ignored;
  fs::remove(m_file, ignored);
}

}  // namespace hogelscope
