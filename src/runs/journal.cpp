// SPDX-License-Identifier: BSD-3-Clause
// A report's journal: appended with one write per row, read up to the first incomplete line.
#include "runs/journal.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
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

std::string textOf(const JournalHead& head) {
  return Json{{"hogelscope report", 1},
              {"key", head.key},
              {"states", head.states},
              {"tests", head.tests}}
             .dump() +
         "\n";
}

/// Writes a number with the shortest digits that read back as it. JSON has neither infinity nor
/// NaN.
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

JournalEntry entryOf(const Json& line) {
  JournalEntry entry;
  for (const Json& value : line.at("values")) entry.values.push_back(number(value));
  entry.problem = line.at("problem").get<std::string>();
  return entry;
}

struct Lines {
  std::string head;  ///< with its end of line; "" if missing
  JournalEntries entries;
  std::uintmax_t bytes = 0;  ///< up to the first incomplete row
};

Lines readLines(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string(), "cannot be read", std::strerror(errno));
  Lines lines;
  std::string text;
  if (!std::getline(in, text) || in.eof()) return lines;
  lines.head = text + "\n";
  lines.bytes = lines.head.size();
  while (std::getline(in, text) && !in.eof()) {
    const Json line = Json::parse(text, nullptr, false);
    try {
      lines.entries[line.at("row").get<std::size_t>()] = entryOf(line);
    } catch (const Json::exception&) {
      break;
    }
    lines.bytes += text.size() + 1;
  }
  return lines;
}

constexpr std::string_view fileName = "report.journal";

/// Parses "" or ".K-N".
std::optional<std::optional<Shard>> shardOf(std::string_view ending) {
  if (ending.empty()) return std::optional<Shard>();
  Shard shard;
  const char* const end = ending.data() + ending.size();
  if (ending.front() != '.') return std::nullopt;
  const auto [dash, error] = std::from_chars(ending.data() + 1, end, shard.number);
  if (error != std::errc() || dash == end || *dash != '-') return std::nullopt;
  const auto [last, wrong] = std::from_chars(dash + 1, end, shard.count);
  if (wrong != std::errc() || last != end) return std::nullopt;
  return endingOf(shard) == ending ? std::optional(std::optional(shard)) : std::nullopt;
}

/// Returns the journal, or none if the file is not one.
std::optional<FoundJournal> foundJournal(const fs::path& file) {
  const std::string name = file.filename().string();
  if (!name.starts_with(fileName)) return std::nullopt;
  const auto shard = shardOf(std::string_view(name).substr(fileName.size()));
  if (!shard || !fs::is_regular_file(fs::symlink_status(file))) return std::nullopt;
  FoundJournal found;
  found.file = file;
  found.shard = *shard;
  found.isInUse = isLocked(file);
  Lines lines = readLines(file);
  const Json head = Json::parse(lines.head, nullptr, false);
  try {
    found.head = {head.at("key").get<std::string>(), head.at("states").get<std::size_t>(),
                  head.at("tests").get<std::size_t>()};
  } catch (const Json::exception&) {
    return std::nullopt;
  }
  constexpr std::size_t most = 100'000'000;  // states or tests, beyond any real report
  if (found.head.states > most || found.head.tests > most) return std::nullopt;
  found.entries = std::move(lines.entries);
  return found;
}

}  // namespace

std::string endingOf(const std::optional<Shard>& shard) {
  return shard ? "." + std::to_string(shard->number) + "-" + std::to_string(shard->count) : "";
}

fs::path journalIn(const fs::path& folder, const std::optional<Shard>& shard) {
  return folder / (std::string(fileName) + endingOf(shard));
}

Journal::Journal(const fs::path& folder, const JournalHead& head, const std::optional<Shard>& shard)
    : m_file(journalIn(folder, shard)) {
  requireOwnFile(m_file, headOfAny);
  auto descriptor = openLocked(m_file, O_APPEND);
  if (!descriptor)
    throw InputError(m_file.string(), "is in use",
                     "another hogelscope makes this report; wait, or choose another folder");
  m_descriptor = std::move(*descriptor);
  Lines lines = readLines(m_file);
  const std::string own = textOf(head);
  m_replacedAnother = !lines.head.empty() && lines.head != own;
  const bool isOwn = lines.head == own;
  if (isOwn) m_entries = std::move(lines.entries);
  if (::ftruncate(m_descriptor.get(), static_cast<off_t>(isOwn ? lines.bytes : 0)) != 0)
    throw InputError(m_file.string(), "cannot be written", std::strerror(errno));
  if (!isOwn) writeAll(m_descriptor.get(), own, m_file);
}

void Journal::add(std::size_t row, const std::vector<double>& values, const std::string& problem) {
  writeAll(m_descriptor.get(), lineOf(row, values, problem), m_file);
}

void Journal::remove() {
  std::error_code ignored;
  fs::remove(m_file, ignored);
}

std::vector<FoundJournal> findJournals(const fs::path& folder) {
  std::vector<FoundJournal> journals;
  try {
    for (const auto& entry : fs::directory_iterator(folder))
      if (auto found = foundJournal(entry.path())) journals.push_back(std::move(*found));
  } catch (const fs::filesystem_error& error) {
    throw InputError(folder.string(), "cannot be read", error.code().message());
  }
  std::ranges::sort(journals, {}, [](const FoundJournal& found) {
    return found.shard ? std::pair(found.shard->count, found.shard->number)
                       : std::pair<std::size_t, std::size_t>();
  });
  return journals;
}

RunRows::RunRows(const fs::path& folder, const JournalHead& head, const std::optional<Shard>& shard,
                 std::size_t values)
    : m_journal(folder, head, shard), m_has(head.states * head.tests) {
  take(m_journal.entries(), values);
  if (shard) return;
  for (const FoundJournal& found : findJournals(folder)) {
    if (!found.shard || found.head.key != head.key) continue;
    if (found.isInUse)
      throw InputError(found.file.string(), "is in use",
                       "shard " + textOf(*found.shard) + " of this report is still at work; wait");
    take(found.entries, values);
    m_shards.push_back(*found.shard);
    m_shardFiles.push_back(found.file);
  }
}

void RunRows::take(const JournalEntries& entries, std::size_t values) {
  for (const auto& [row, entry] : entries)
    if (row < m_has.size() && m_has[row] == 0 && entry.values.size() == values) {
      m_has[row] = 1;
      m_taken[row] = entry;
    }
}

void RunRows::remove() {
  m_journal.remove();
  std::error_code ignored;
  for (const fs::path& file : m_shardFiles) fs::remove(file, ignored);
}

}  // namespace hogelscope
