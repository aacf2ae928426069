// SPDX-License-Identifier: BSD-3-Clause
// A report's journal: appended with one write a row, read again up to the first line that is not
// whole.
#include "io/report_journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/atomic_file.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

std::string headOf(const std::string& key) {
  return Json{{"hogelscope report", 1}, {"key", key}}.dump() + "\n";
}

/// nlohmann writes the shortest digits that read back as the same number, and null for NaN.
std::string lineOf(std::size_t row, const Metrics& m, const std::string& problem) {
  return Json{{"row", row},     {"mse", m.mse},       {"mseSeen", m.mseSeen}, {"ssim", m.ssim},
              {"seen", m.seen}, {"mseYuv", m.mseYuv}, {"problem", problem}}
             .dump(-1, ' ', false, Json::error_handler_t::replace) +
         "\n";
}

double number(const Json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

ReportJournal::Entry entryOf(const Json& line) {
  ReportJournal::Entry entry;
  entry.metrics = {number(line.at("mse")),
                   number(line.at("mseSeen")),
                   number(line.at("ssim")),
                   number(line.at("seen")),
                   {}};
  for (std::size_t k = 0; k < 3; ++k) entry.metrics.mseYuv[k] = number(line.at("mseYuv").at(k));
  entry.problem = line.at("problem").get<std::string>();
  return entry;
}

}  // namespace

ReportJournal::ReportJournal(const fs::path& folder, const std::string& key)
    : m_file(folder / "report.journal") {
  m_descriptor = ::open(m_file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (m_descriptor < 0)
    throw InputError(m_file.string(), "cannot be written", std::strerror(errno));
  if (::flock(m_descriptor, LOCK_EX | LOCK_NB) != 0) {
    ::close(m_descriptor);
    throw InputError(m_file.string(), "is in use",
                     "another hogelscope makes this report; wait, or give another --output");
  }
  try {
    read(readTextFile(m_file), headOf(key));
  } catch (...) {
    ::close(m_descriptor);
    if (m_entries.empty()) remove();
    throw;
  }
}

ReportJournal::~ReportJournal() {
  if (m_descriptor >= 0) ::close(m_descriptor);
}

/// What cannot be used is cut off the file.
void ReportJournal::read(const std::string& text, const std::string& head) {
  std::size_t used = 0;
  if (text.starts_with(head)) {
    used = head.size();
    for (std::size_t end = text.find('\n', used); end != std::string::npos;
         end = text.find('\n', used)) {
      const Json line = Json::parse(text.substr(used, end - used), nullptr, false);
      try {
        m_entries[line.at("row").get<std::size_t>()] = entryOf(line);
      } catch (const Json::exception&) {
        break;
      }
      used = end + 1;
    }
  } else {
    m_replacedAnother = text.find('\n') != std::string::npos;
  }
  if (::ftruncate(m_descriptor, static_cast<off_t>(used)) != 0)
    throw InputError(m_file.string(), "cannot be written", std::strerror(errno));
  if (used == 0) append(head);
}

void ReportJournal::add(std::size_t row, const Metrics& metrics, const std::string& problem) {
  append(lineOf(row, metrics, problem));
}

void ReportJournal::append(const std::string& line) {
  std::string_view rest = line;
  while (!rest.empty()) {
    const ssize_t written = ::write(m_descriptor, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw InputError(m_file.string(), "cannot be written", std::strerror(errno));
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

void ReportJournal::remove() {
  std::error_code ignored;
  fs::remove(m_file, ignored);
}

}  // namespace hogelscope
