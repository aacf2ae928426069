// SPDX-License-Identifier: BSD-3-Clause
#include "python/function_metrics.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <cctype>
#include <mutex>
#include <optional>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/atomic_file.h"
#include "report/view_pairs.h"

namespace hogelscope {

namespace py = pybind11;
namespace fs = std::filesystem;

namespace {

using Figures = std::vector<std::pair<std::string, double>>;

/// A line for each function: its name and its columns.
fs::path fileOf(const fs::path& folder) {
  return folder / "report.columns";
}

bool isColumnName(const std::string& name) {
  return !name.empty() && name.size() <= 60 && std::ranges::all_of(name, [](unsigned char c) {
    return c == '_' || (c < 128 && std::isalnum(c) != 0);
  });
}

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw InputError("metrics", name, why);
}

py::array_t<float> arrayOf(const Image& image) {
  py::array_t<float> array({image.height, image.width, 3});
  std::vector<double> values(image.rgb.size());
  readCodeValues(image, 0, values);
  std::ranges::transform(values, array.mutable_data(),
                         [](double value) { return float(value / 255); });
  return array;
}

py::array_t<bool> seenOf(const Image& reference, const Image& test) {
  py::array_t<bool> array({reference.height, reference.width});
  std::ranges::transform(reference.seen, test.seen, array.mutable_data(),
                         [](auto a, auto b) { return a != 0 && b != 0; });
  return array;
}

double numberOf(const std::string& name, const py::handle& value) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() == nullptr) return number;
  PyErr_Clear();
  refuse(name, "returns " + py::str(py::type::of(value)).cast<std::string>() +
                   ", not a number or a dict of numbers");
}

/// Returns the columns of a result with their values.
Figures figuresOf(const std::string& name, const py::object& result) {
  if (!py::isinstance<py::dict>(result)) return {{name, numberOf(name, result)}};
  Figures figures;
  for (const auto& [key, value] : py::cast<py::dict>(result)) {
    const std::string column = name + "_" + py::str(key).cast<std::string>();
    if (!isColumnName(column))
      refuse(name, "returns the key \"" + printable(py::str(key).cast<std::string>()) +
                       "\", which no column can have: take letters, digits and _");
    figures.emplace_back(column, numberOf(name, value));
  }
  if (figures.empty()) refuse(name, "returns an empty dict");
  std::ranges::sort(figures);
  return figures;
}

}  // namespace

struct FunctionMetrics::One {
  std::string name;
  py::object function;
  std::vector<std::string> columns{};
  /// What was returned for the views by which the columns were found; it is not called for these
  /// again.
  struct Known {
    Image reference;
    Image test;
    std::vector<double> values;
  };
  std::optional<Known> known{};
  std::mutex mutex{};

  /// Calls the function. Python's lock must not be held.
  Figures call(const Image& reference, const Image& test, const Viewing& viewing) {
    const py::gil_scoped_acquire lock;
    try {
      py::dict info;
      info["state"] = viewing.state;
      info["pixels_per_degree"] = viewing.pixelsPerDegree;
      info["distance"] = viewing.distance;
      info["light"] = "encoded";
      return figuresOf(name,
                       function(arrayOf(reference), arrayOf(test), seenOf(reference, test), info));
    } catch (const py::error_already_set& error) {
      const std::string text = error.what();
      refuse(name, "raises " + printable(text.substr(0, text.find('\n'))));
    }
  }

  std::vector<double> compare(const Image& reference, const Image& test, const Viewing& viewing) {
    const std::lock_guard one(mutex);
    if (known && known->reference == reference && known->test == test) {
      std::vector<double> values = std::move(known->values);
      known.reset();
      return values;
    }
    const Figures figures = call(reference, test, viewing);
    std::vector<double> values;
    std::vector<std::string> names;
    for (const auto& [column, value] : figures) {
      names.push_back(column);
      values.push_back(value);
    }
    if (names == columns) return values;
    const auto listed = [](const std::vector<std::string>& all) {
      std::string text;
      for (const std::string& column : all) text += (text.empty() ? "" : ", ") + column;
      return text;
    };
    refuse(name, "returns " + listed(names) + " for " + viewing.state + ", but " + listed(columns) +
                     " before; a changed function needs a new name");
  }
};

FunctionMetrics::FunctionMetrics(const Functions& functions) {
  for (const auto& [name, function] : functions) {
    if (!isColumnName(name))
      refuse(printable(name), "is no column's name: letters, digits and _ are");
    m_all.push_back(std::make_unique<One>(name, function));
  }
}

FunctionMetrics::~FunctionMetrics() {
  const py::gil_scoped_acquire lock;
  m_all.clear();
}

void FunctionMetrics::keep(const fs::path& folder) const {
  std::string text;
  for (const auto& one : m_all) {
    text += one->name;
    for (const std::string& column : one->columns) text += "," + column;
    text += "\n";
  }
  makeFolder(folder);
  writeTextFile(fileOf(folder), text);
}

bool FunctionMetrics::recall(const fs::path& folder) {
  if (!fs::is_regular_file(fileOf(folder)) || !fs::is_regular_file(folder / "report.journal"))
    return false;
  const std::vector<std::vector<std::string>> lines = csvRows(readTextFile(fileOf(folder)));
  if (lines.size() != m_all.size()) return false;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (lines[k].size() < 2 || lines[k][0] != m_all[k]->name) return false;
  for (std::size_t k = 0; k < lines.size(); ++k)
    m_all[k]->columns.assign(lines[k].begin() + 1, lines[k].end());
  return true;
}

void FunctionMetrics::findColumns(const ReportRequest& request, const Progress& progress) {
  if (m_all.empty() || recall(request.output)) return;
  ViewPairs pairs(request, 1, parallelRows);
  pairs.read(request.tests.front(), part(progress, 0, 0.8));
  for (std::size_t state = 0; state < request.session.cameras.size(); ++state) {
    const ViewPair pair = pairs.render(state, 0, part(progress, 0.8, 1));
    if (!pair.problem.empty() ||
        std::ranges::count(pair.reference.seen, 0) == std::ptrdiff_t(pair.reference.seen.size()))
      continue;
    for (const auto& one : m_all) {
      one->known.emplace(pair.reference, pair.test, std::vector<double>());
      for (const auto& [column, value] :
           one->call(pair.reference, pair.test, pairs.viewing(state))) {
        one->columns.push_back(column);
        one->known->values.push_back(value);
      }
    }
    return keep(request.output);
  }
  for (const auto& one : m_all) one->columns = {one->name};  // it is never called
}

std::vector<Metric> FunctionMetrics::metricsOf(const std::shared_ptr<FunctionMetrics>& self) {
  std::vector<Metric> metrics;
  for (const auto& function : self->m_all) {
    One* const one = function.get();
    Metric& metric = metrics.emplace_back();
    for (const std::string& column : one->columns) {
      metric.means.push_back({.name = "mean_" + column,
                              .title = "mean " + column,
                              .column = metric.columns.size(),
                              .decimals = 4,
                              .isQuality = true,
                              .mayFall = true});
      metric.columns.push_back({.name = column,
                                .title = column,
                                .help = "Of a function of Python",
                                .decimals = 4,
                                .where = MetricColumn::Where::window});
    }
    metric.compare = [self, one](const Image& reference, const Image& test, const ParallelRows&,
                                 const Progress& progress, const Viewing& viewing) {
      throwIfCancelled(progress);
      return one->compare(reference, test, viewing);
    };
  }
  return metrics;
}

void FunctionMetrics::forget(const fs::path& folder) {
  std::error_code none;
  fs::remove(fileOf(folder), none);
}

}  // namespace hogelscope
