// SPDX-License-Identifier: BSD-3-Clause
#include "python/function_metrics.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <cctype>
#include <mutex>
#include <optional>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/atomic_file.h"
#include "report/report_frames.h"
#include "report/view_pairs.h"
#include "runs/journal.h"

namespace hogelscope {

namespace py = pybind11;
namespace fs = std::filesystem;

namespace {

using Figures = std::vector<std::pair<std::string, double>>;

/// Of one function: more make tables that nobody reads, slowly.
constexpr std::size_t mostColumns = 200;

/// The columns of an unfinished report: the head, then a line for each function with its name and
/// its columns.
fs::path fileOf(const fs::path& folder) {
  return folder / "report.columns";
}
constexpr std::string_view fileHead = "hogelscope columns of metrics 1\n";

bool isColumnName(const std::string& name) {
  return !name.empty() && name.size() <= 60 && std::ranges::all_of(name, [](unsigned char c) {
    return c == '_' || (c < 128 && std::isalnum(c) != 0);
  });
}

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw InputError("metrics", name, why);
}

/// What a function is asked. It owns all, since its caller may stop before it returns.
struct Question {
  Question(const Image& first, const Image& second, Viewing conditions)
      : height(first.height),
        width(first.width),
        reference(valuesOf(first)),
        test(valuesOf(second)),
        seen(first.seen.size()),
        viewing(std::move(conditions)) {
    std::ranges::transform(first.seen, second.seen, seen.begin(),
                           [](auto a, auto b) { return a != 0 && b != 0; });
  }

  int height;
  int width;
  std::vector<float> reference;
  std::vector<float> test;
  std::vector<std::uint8_t> seen;
  Viewing viewing;
  Figures answer{};

 private:
  static std::vector<float> valuesOf(const Image& image) {
    std::vector<double> values(image.rgb.size());
    readCodeValues(image, 0, values);
    std::vector<float> shares(values.size());
    std::ranges::transform(values, shares.begin(), [](double value) { return float(value / 255); });
    return shares;
  }
};

/// Returns the arguments of the call.
py::tuple argumentsOf(const Question& asked) {
  const auto picture = [&](const std::vector<float>& values) {
    return py::array_t<float>({asked.height, asked.width, 3}, values.data());
  };
  py::array_t<bool> seen({asked.height, asked.width});
  std::ranges::copy(asked.seen, seen.mutable_data());
  py::dict info;
  info["state"] = asked.viewing.state;
  info["pixels_per_degree"] = asked.viewing.pixelsPerDegree;
  info["distance"] = asked.viewing.distance;
  info["light"] = "encoded";
  if (asked.viewing.frame) info["frame"] = *asked.viewing.frame;
  return py::make_tuple(picture(asked.reference), picture(asked.test), seen, info);
}

double numberOf(const std::string& name, const py::handle& value) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() == nullptr) return number;
  PyErr_Clear();
  refuse(name, "returns " + py::str(py::type::of(value)).cast<std::string>() +
                   ", not a number or a dict of numbers");
}

/// Returns the column of a key.
std::string columnOf(const std::string& name, const py::handle& key) {
  Py_ssize_t size = 0;
  const py::str text(key);
  const char* const letters = PyUnicode_AsUTF8AndSize(text.ptr(), &size);
  if (letters == nullptr) {  // a part of a pair of surrogates
    PyErr_Clear();
    refuse(name, "returns a key that is no text: take letters, digits and _");
  }
  const std::string own(letters, std::size_t(size));
  if (!isColumnName(name + "_" + own))
    refuse(name, "returns the key \"" + printable(own) +
                     "\", which no column can have: take letters, digits and _");
  return name + "_" + own;
}

/// Returns the columns of a result with their values.
Figures figuresOf(const std::string& name, const py::object& result) {
  if (!py::isinstance<py::dict>(result)) return {{name, numberOf(name, result)}};
  const auto numbers = py::cast<py::dict>(result);
  if (numbers.size() > mostColumns)
    refuse(name, "returns " + std::to_string(numbers.size()) + " numbers; a metric has at most " +
                     std::to_string(mostColumns));
  Figures figures;
  for (const auto& [key, value] : numbers)
    figures.emplace_back(columnOf(name, key), numberOf(name, value));
  if (figures.empty()) refuse(name, "returns an empty dict");
  std::ranges::sort(figures);
  const auto twice = std::ranges::adjacent_find(figures, {}, &Figures::value_type::first);
  if (twice != figures.end()) refuse(name, "returns two keys of one column: " + twice->first);
  return figures;
}

/// Throws the exception of a function as an InputError, of which it is the cause.
[[noreturn]] void refuse(const std::string& name, py::error_already_set& error) {
  const std::string text = error.what();
  const InputError refusal("metrics", name, "raises " + printable(text.substr(0, text.find('\n'))));
  const py::object type = py::module_::import("hogelscope").attr("InputError");
  error.restore();
  py::raise_from(type.ptr(), refusal.what());
  throw py::error_already_set();
}

/// Has a function called. Name and function must outlive the thread that calls it.
Figures answerTo(const std::shared_ptr<Question>& asked, const std::string& name,
                 const py::object& function, const InPython& inPython) {
  inPython([asked, &name, &function] {
    try {
      asked->answer = figuresOf(name, callPython(function, argumentsOf(*asked)));
    } catch (py::error_already_set& error) {
      if (!error.matches(PyExc_Exception)) throw;  // Ctrl-C, an exit
      refuse(name, error);
    }
  });
  return asked->answer;
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

  Figures call(const Image& reference, const Image& test, const Viewing& viewing,
               const InPython& inPython) {
    return answerTo(std::make_shared<Question>(reference, test, viewing), name, function, inPython);
  }

  std::vector<double> compare(const Image& reference, const Image& test, const Viewing& viewing,
                              const InPython& inPython) {
    const std::lock_guard one(mutex);
    if (known && known->reference == reference && known->test == test) {
      std::vector<double> values = std::move(known->values);
      known.reset();
      return values;
    }
    const Figures figures = call(reference, test, viewing, inPython);
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
  std::string text(fileHead);
  for (const auto& one : m_all) {
    Table line{{one->name}};
    line[0].insert(line[0].end(), one->columns.begin(), one->columns.end());
    text += csvText(line);
  }
  makeFolder(folder);
  writeTextFile(fileOf(folder), text);
}

bool FunctionMetrics::recall(const fs::path& folder) {
  requireOwnFile(fileOf(folder), fileHead);
  if (!fs::exists(fileOf(folder)) || !fs::is_regular_file(journalIn(folder))) return false;
  const std::string text = readTextFile(fileOf(folder));
  const Table lines = csvRows(text.substr(std::min(text.size(), fileHead.size())));
  if (lines.size() != m_all.size()) return false;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (lines[k].size() < 2 || lines[k][0] != m_all[k]->name) return false;
  for (std::size_t k = 0; k < lines.size(); ++k)
    m_all[k]->columns.assign(lines[k].begin() + 1, lines[k].end());
  return true;
}

void FunctionMetrics::findColumns(const ReportRequest& request, const InPython& inPython,
                                  const Progress& progress) {
  m_inPython = inPython;
  if (m_all.empty() || recall(request.output)) return;
  ViewPairs pairs(request, 1, parallelRows);
  const FrameViews first = framesOf(request).front();
  pairs.expect({first});
  pairs.read(0, 0, part(progress, 0, 0.8));
  for (std::size_t state = first.begin; state < first.end; ++state) {
    const ViewPair pair = pairs.render(state, 0, part(progress, 0.8, 1));
    if (!pair.problem.empty() ||
        std::ranges::count(pair.reference.seen, 0) == std::ptrdiff_t(pair.reference.seen.size()))
      continue;
    for (const auto& one : m_all) {
      one->known.emplace(pair.reference, pair.test, std::vector<double>());
      for (const auto& [column, value] :
           one->call(pair.reference, pair.test, pairs.viewing(state), m_inPython)) {
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
      return one->compare(reference, test, viewing, self->m_inPython);
    };
  }
  return metrics;
}

void FunctionMetrics::forget(const fs::path& folder) {
  try {
    requireOwnFile(fileOf(folder), fileHead);
  } catch (const InputError&) {
    return;  // a user's
  }
  std::error_code none;
  fs::remove(fileOf(folder), none);
}

}  // namespace hogelscope
