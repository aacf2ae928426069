// SPDX-License-Identifier: BSD-3-Clause
// A report as the window shows it, while it is made and after.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/axis.h"
#include "report/page/window_plots.h"
#include "report/report_reader.h"
#include "report/report_request.h"

namespace hogelscope {

/// A report that is being made, was made, or was read from its folder.
struct ReportData {
  Session session;      ///< its states are those of the rows
  std::string folder;   ///< of its files
  bool isRead = false;  ///< from its folder; the session's states may be others
  MetricSet metrics{};
  std::vector<std::string> tests{};         ///< files
  std::vector<int> frames{};                ///< of each state; empty for a still
  std::vector<PlottedTest> plotted{};       ///< of each test
  std::vector<ReportRow> rows{};            ///< in ReportOrder
  std::vector<TestSummary> summaries{};     ///< empty until the report is finished
  std::vector<PanelErrorFigures> panels{};  ///< of each test; empty if unknown

  /// Adds rows that say that nothing is compared yet, and the names of the tests.
  void begin();
  /// Takes the rows, states and rates of the report in the folder. States that the session does not
  /// have are there with their name and eye. The tests may not be there any more.
  void take(const StoredReport& stored);
  /// Sets the rates of the tests, where they are known.
  void setRates(const std::vector<std::optional<double>>& rates);
  [[nodiscard]] ReportOrder order() const { return {tests.size()}; }
  /// Whether a row is to be compared yet.
  [[nodiscard]] bool isAwaited(std::size_t row) const;
  /// Returns the PSNR over what is seen; NaN for rows with a problem.
  [[nodiscard]] double psnr(std::size_t row) const;
  /// Returns the range of the finite PSNRs of a test, or of all tests, as an axis from 0 to 1. It
  /// is infinite and empty if there is none.
  [[nodiscard]] Axis range(std::optional<std::size_t> test = {}) const;
  /// Returns the state with the least or the largest PSNR of a test.
  [[nodiscard]] std::optional<std::size_t> extreme(std::size_t test, bool isBest) const;
  [[nodiscard]] ReportSummary summaryOf(std::size_t test) const;
  /// Returns the index of a row's state in another session, by its name; none if it is not there.
  [[nodiscard]] std::optional<std::size_t> stateIn(const Session& other, std::size_t state) const;
};

}  // namespace hogelscope
