// SPDX-License-Identifier: BSD-3-Clause
// Functions of Python as metrics of a report: function(reference, test, seen, info), which returns
// a number, or a dict of numbers.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/metrics/metric.h"
#include "core/optics/image.h"
#include "python/bindings.h"
#include "python/stoppable.h"
#include "report/report_request.h"

namespace hogelscope {

/// The functions of a call, by their names. Any thread may use and release them.
class FunctionMetrics {
 public:
  using Functions = std::vector<std::pair<std::string, pybind11::object>>;

  /// Called by the thread that has Python's lock. Throws InputError for a name that cannot be a
  /// column's.
  explicit FunctionMetrics(const Functions& functions);
  ~FunctionMetrics();
  FunctionMetrics(const FunctionMetrics&) = delete;
  FunctionMetrics& operator=(const FunctionMetrics&) = delete;

  /// Finds the columns: those of the unfinished report in the request's folder, or what the
  /// functions return for the first views that see anything of the display. Throws InputError,
  /// Cancelled.
  void findColumns(const ReportRequest& request, const InPython& inPython,
                   const Progress& progress);
  /// Returns the metrics, which keep `self`. A function is called without any other at the same
  /// time; what it raises, or returns in place of numbers, is an InputError and stops the work.
  static std::vector<Metric> metricsOf(const std::shared_ptr<FunctionMetrics>& self);
  /// Removes what a report in the folder kept of the columns, once it is finished.
  static void forget(const std::filesystem::path& folder);

 private:
  struct One;
  void keep(const std::filesystem::path& folder) const;
  [[nodiscard]] bool recall(const std::filesystem::path& folder);

  std::vector<std::unique_ptr<One>> m_all;
  InPython m_inPython;  ///< of the running report
};

}  // namespace hogelscope
