// SPDX-License-Identifier: BSD-3-Clause
// Reports for Python.
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/cameras/frame_states.h"
#include "core/metrics/flicker.h"
#include "core/optics/eyes.h"
#include "io/files/content_hash.h"
#include "io/plugins/metric_plugins.h"
#include "python/array_light_field.h"
#include "python/bindings.h"
#include "python/content.h"
#include "python/function_metrics.h"
#include "python/stoppable.h"
#include "report/report_facts.h"
#include "report/report_frames.h"
#include "report/report_moves.h"
#include "report/report_run.h"
#include "report/test_orders.h"

namespace hogelscope {

namespace py = pybind11;

namespace {

using Tests = std::vector<std::pair<std::string, LightChoice>>;
/// Twins by name, each as the session with it.
using Units = std::vector<std::pair<std::string, Document>>;
/// Tests with their rates; none: that of the test's files.
using Rates = std::vector<std::pair<std::string, std::optional<double>>>;
using Groups = std::vector<std::pair<std::string, Rates>>;

/// A report's request from Python.
struct ReportArguments {
  const Document& document;
  const LightChoice& reference;
  const Tests& tests;
  const Groups& groups;
  std::string output;
  std::string against;  ///< "", "ideal" or "design"
  const Units& units;
  bool images = false;
  std::string frames;  ///< as framesFrom() has it; "": all
  std::shared_ptr<FunctionMetrics> functions{};
};

/// Returns a name that identifies an array by its content, for unfinished reports.
std::string nameOfArray(LightFieldFile& file, const Progress& progress) {
  ContentHash hash;
  const std::size_t row = 3 * file.size().width();
  const FrameNumbers frames = file.frames();
  for (std::size_t k = 0; k < frames.count(); ++k) {
    const auto count = double(frames.count());
    file.select(frames.number(k));
    file.stream(
        [&](int, int, const StoredRows& values) {
          std::visit([&](const auto* rgb) { hash.add(std::as_bytes(std::span(rgb, row))); },
                     values);
        },
        part(progress, double(k) / count, double(k + 1) / count));
  }
  return "array, XXH3-128 of its rows " + hash.hex();
}

/// Returns the session itself if there is no other light field.
ReportTest testWith(const Session& session, const std::string& name, const LightChoice& light,
                    const Progress& progress) {
  if (std::holds_alternative<std::monostate>(light))
    return {name, session, openLightField(session.lightField, session.display, progress)};
  if (const auto* file = std::get_if<std::string>(&light)) {
    const Session other = sessionWith(session, *file);
    return {name, other, openLightField(other.lightField, other.display, progress)};
  }
  const auto& content = std::get<std::shared_ptr<Content>>(light);
  Session other = content->in(session);
  if (content->lightField().isLive())  // along this display's own rays
    return {name, other, openLightField(other.lightField, other.display, progress)};
  if (content->file()->files().empty())
    other.lightField.file = nameOfArray(*content->file(), progress);
  (void)resolved(displayOf(other), content->file()->size());
  return {name, other, content->file()};
}

RateGroup groupOf(const std::string& name, const Rates& rates,
                  const std::vector<ReportTest>& tests) {
  RateGroup group{name, {}};
  for (const auto& [test, given] : rates) {
    const auto known = std::ranges::find(tests, test, &ReportTest::name);
    if (known == tests.end())
      throw InputError("groups", name, "\"" + test + "\" is none of the tests");
    const std::optional<double> rate = given ? given : rateOfFiles(*known);
    if (!rate)
      throw InputError("groups", name, "\"" + test + "\" has no size of its own; give its rate");
    if (!(*rate > 0) || !std::isfinite(*rate))
      throw InputError("groups", name, "the rate of \"" + test + "\" is not a number above 0");
    group.tests.push_back({test, *rate});
  }
  if (group.tests.size() < 4)
    throw InputError("groups", name,
                     "has " + std::to_string(group.tests.size()) +
                         " tests, but a rate-distortion curve needs four or more");
  return group;
}

std::vector<std::pair<std::string, Session>> unitsOf(const ReportArguments& wishes,
                                                     const Session& session) {
  std::vector<std::pair<std::string, Session>> units;
  for (const auto& [name, document] : wishes.units) {
    Session built = sessionOf(document);
    Session& unit = units.emplace_back(name, session).second;
    unit.twin = std::move(built.twin);
    unit.twinFile = std::move(built.twinFile);
  }
  return units;
}

ReportRequest requestOf(const ReportArguments& wishes, const InPython& inPython,
                        const Progress& progress) {
  ReportRequest request;
  const Session session = sessionOf(wishes.document);
  request.name = wishes.document.name.empty() ? "a session of Python" : wishes.document.name;
  ReportTest reference = testWith(session, "", wishes.reference, progress);
  request.session = withEyes(std::move(reference.session));
  request.file = std::move(reference.file);
  request.isAgainstIdeal = wishes.against == "ideal";
  if (request.isAgainstIdeal) {
    requireLive(request.session);
    request.tests.push_back({"display", request.session, request.file});
  }
  if (wishes.against == "design" && !compareWithDesign(request, unitsOf(wishes, request.session)))
    throw InputError("against", "design",
                     "needs a unit to compare: twins=[FILE], or a session with a twin");
  for (const auto& [name, light] : wishes.tests)
    request.tests.push_back(testWith(request.session, name, light, progress));
  orderTests(request, part(progress, 0, 0.5));
  if (request.tests.empty()) throw InputError("tests", "is empty: there is nothing to compare");
  for (const auto& [name, rates] : wishes.groups)
    request.groups.push_back(groupOf(name, rates, request.tests));
  request.output = wishes.output;
  request.command = "hogelscope.report() of Python";
  request.images = wishes.images;
  std::optional<FrameNumbers> frames;
  if (!wishes.frames.empty()) frames = framesFrom("frames", wishes.frames, request.file->frames());
  takeFrames(request, frames);
  wishes.functions->findColumns(request, inPython, part(progress, 0.5, 1));
  std::vector<Metric> more = FunctionMetrics::metricsOf(wishes.functions);
  if (!request.frames.empty()) more.push_back(flickerMetric());
  if (request.isAgainstDesign) more.push_back(moveMetric());  // the last one
  request.metrics = metricsOf(request.session.metrics, std::move(more));
  return request;
}

py::dict dictOf(const ReportRow& row, const MetricSet& metrics) {
  py::dict result;
  result["state"] = row.state;
  result["test"] = row.test;
  for (std::size_t k = 0; k < metrics.columns().size(); ++k)
    result[py::str(metrics.columns()[k].name)] = row.values[k];
  result["eye_x"] = row.eye.x;
  result["eye_y"] = row.eye.y;
  result["eye_z"] = row.eye.z;
  result["weight"] = row.weight;
  result["problem"] = row.problem;
  if (row.frame) result["frame"] = *row.frame;
  return result;
}

py::dict dictOf(const BdRow& row) {
  const auto& [anchor, group, quality, delta, isWeighted, rate, gain] = row;
  py::dict result;
  result["anchor"] = anchor;
  result["group"] = group;
  result["quality"] = quality.name;
  result["over"] = quality.isSeen ? "seen" : "frame";
  result["means"] = isWeighted ? "weighted" : "plain";
  result["rate"] = delta.rate;
  result["rate_interval"] = py::make_tuple(rate.low, rate.high);
  result["gain"] = delta.quality;
  result["gain_interval"] = py::make_tuple(gain.low, gain.high);
  result["from"] = delta.from;
  result["to"] = delta.to;
  result["problem"] = delta.problem;
  return result;
}

/// Returns each test's means and their intervals, by name; weighted ones after "weighted_" where
/// states have weights.
std::pair<py::dict, py::dict> meansOf(const std::vector<TestSummary>& summaries,
                                      const MetricSet& metrics) {
  py::dict means, intervals;
  for (const TestSummary& test : summaries) {
    if (&test == &summaries.back()) break;  // of all tests
    py::dict values, ranges;
    const auto add = [&](const std::string& begin, const MeansOfTest& of) {
      for (std::size_t k = 0; k < of.values.size(); ++k) {
        const py::str name(begin + metrics.means()[k].name);
        values[name] = of.values[k];
        ranges[name] = py::make_tuple(of.intervals[k].low, of.intervals[k].high);
      }
    };
    add("", test.means(false));
    if (test.hasWeights()) add("weighted_", test.means(true));
    means[py::str(test.test)] = values;
    intervals[py::str(test.test)] = ranges;
  }
  return {means, intervals};
}

py::tuple report(const Document& document, const LightChoice& lightField, const Tests& tests,
                 const Groups& groups, const FunctionMetrics::Functions& functions,
                 const std::string& output, const std::string& against, const Units& units,
                 bool images, const std::string& frames, int threads, const py::object& progress) {
  const ThreadsOfCall limit(threads);
  const auto called = std::make_shared<FunctionMetrics>(functions);
  struct Made {
    Report report;
    MetricSet metrics;
    std::vector<std::string> warnings;
  };
  std::optional<Made> result;
  runStoppable(progress, [&](const Progress& hear, const InPython& inPython) {
    const ReportRequest request = requestOf(
        {document, lightField, tests, groups, output, against, units, images, frames, called},
        inPython, part(hear, 0, 0.05));
    ReportListener listener;
    listener.progress = part(hear, 0.05, 1);
    result.emplace(makeReport(request, listener), request.metrics, warningsOf(request));
    FunctionMetrics::forget(output);
  });
  const auto& [made, metrics, warnings] = *result;
  py::list rows, bd;
  for (const ReportRow& row : made.rows) rows.append(dictOf(row, metrics));
  for (const BdRow& row : made.comparisons) bd.append(dictOf(row));
  const auto [means, intervals] = meansOf(made.summaries, metrics);
  return py::make_tuple(rows, means, intervals, bd, warnings);
}

}  // namespace

void addReports(py::module_& module) {
  module.def("report", &report, py::arg("document"), py::arg("light_field"), py::arg("tests"),
             py::arg("groups"), py::arg("metrics"), py::arg("output"), py::arg("against"),
             py::arg("units"), py::arg("images"), py::arg("frames"), py::arg("threads"),
             py::arg("progress"),
             "Writes a report: its rows, means, intervals, BD-rates and warnings.");
}

}  // namespace hogelscope
