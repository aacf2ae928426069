// SPDX-License-Identifier: BSD-3-Clause
#include "report/report_data.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>

#include "core/base/error.h"
#include "core/optics/eyes.h"
#include "io/files/folders.h"
#include "report/page/test_names.h"
#include "report/report_run.h"

namespace hogelscope {

namespace {

constexpr const char* notYet = "not compared yet";
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Returns the curve of a test's name: its extension, or its name without a number at the end.
std::string curveOf(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot != std::string::npos && dot > 0) return name.substr(dot + 1);
  const auto isLetter = [](unsigned char c) { return c > 127 || std::isalpha(c) != 0; };
  return {name.begin(), std::find_if(name.rbegin(), name.rend(), isLetter).base()};
}

/// Returns the file that a report in `folder` means by a test's name, from the report's folder or,
/// as the command line writes it, from the current one.
std::string fileOfTest(const std::string& folder, const std::string& name) {
  const std::string beside = besideDocument(folder, name);
  std::error_code error;
  const auto exists = [&](const std::string& file) { return std::filesystem::exists(file, error); };
  return exists(name) && !exists(beside) ? name : beside;
}

/// Returns the rate of a test; none if its file is not there any more.
std::optional<double> rateOf(const Session& session, const std::string& test) {
  try {
    return rateOfFiles(openTests(session, {test})[0]);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

void ReportData::begin() {
  plotted.clear();
  for (const std::string& name : shortNames(tests))
    plotted.push_back({name, curveOf(name), unknown});
  rows.clear();
  for (std::size_t k = 0; k < session.cameras.size(); ++k) {
    const CameraParams& camera = session.cameras[k].camera;
    const auto frame = frames.empty() ? std::nullopt : std::optional(frames[k]);
    for (const std::string& test : tests)
      rows.push_back({camera.name, test, metrics.noValues(), camera.eye, 1, notYet, frame});
  }
}

void ReportData::take(const StoredReport& stored) {
  const std::vector<std::string> names = testsOf(stored.rows);
  tests.clear();
  std::vector<std::optional<double>> rates;
  for (const std::string& name : names) {
    tests.push_back(fileOfTest(folder, name));
    rates.push_back(rateOf(session, tests.back()));
  }
  const Session known = session;
  session.cameras.clear();
  for (std::size_t row = 0; row < stored.rows.size(); row += tests.size()) {
    CameraState state;
    for (const CameraState& other : known.cameras)
      if (other.camera.name == stored.rows[row].state) state = other;
    state.camera.name = stored.rows[row].state;
    state.camera.eye = stored.rows[row].eye;
    session.cameras.push_back(state);
  }
  begin();
  rows = stored.rows;
  summaries = summariseTests(rows, metrics);
  setRates(rates);
  for (const TestRate& rate : stored.rates)
    for (std::size_t k = 0; k < names.size(); ++k)
      if (names[k] == rate.test) plotted[k].rate = rate.rate;
}

void ReportData::setRates(const std::vector<std::optional<double>>& rates) {
  for (std::size_t k = 0; k < rates.size(); ++k) plotted[k].rate = rates[k].value_or(unknown);
}

bool ReportData::isAwaited(std::size_t row) const {
  return rows[row].problem == notYet;
}

double ReportData::psnr(std::size_t row) const {
  return rows[row].problem.empty() ? rows[row].values[psnrSeenColumn] : unknown;
}

Axis ReportData::range(std::optional<std::size_t> test) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Axis range{infinite, -infinite, 0, 1};
  for (std::size_t row = test.value_or(0); row < rows.size(); row += test ? tests.size() : 1)
    if (std::isfinite(psnr(row))) {
      range.low = std::min(range.low, psnr(row));
      range.high = std::max(range.high, psnr(row));
    }
  return range;
}

std::optional<std::size_t> ReportData::extreme(std::size_t test, bool isBest) const {
  std::optional<std::size_t> found;
  for (std::size_t row = test; row < rows.size(); row += tests.size()) {
    if (std::isnan(psnr(row))) continue;
    const double least = found ? psnr(order().row(*found, test)) : psnr(row);
    if (!found || (isBest ? psnr(row) > least : psnr(row) < least)) found = order().state(row);
  }
  return found;
}

ReportSummary ReportData::summaryOf(std::size_t test) const {
  std::vector<ReportRow> own;
  for (std::size_t row = test; row < rows.size(); row += tests.size()) own.push_back(rows[row]);
  return summariseRows(own, metrics);
}

std::optional<std::size_t> ReportData::stateIn(const Session& other, std::size_t state) const {
  const std::string& name = session.cameras[state].camera.name;
  const auto hasName = [head = headOf(name)](const CameraState& each) {
    return each.camera.name == head;
  };
  const std::vector<CameraState>& states = other.cameras;
  if (state < states.size() && hasName(states[state])) return state;
  const auto found = std::ranges::find_if(states, hasName);
  if (found == states.end()) return std::nullopt;
  return std::size_t(found - states.begin());
}

}  // namespace hogelscope
