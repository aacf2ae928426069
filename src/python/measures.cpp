// SPDX-License-Identifier: BSD-3-Clause
// Measures of a display and its content for Python.
#include <pybind11/stl.h>

#include <tuple>

#include "io/documents/session_file.h"
#include "io/files/files_in_use.h"
#include "io/scene/view_source.h"
#include "measure/depth_budget_run.h"
#include "measure/measure_run.h"
#include "measure/sweep.h"
#include "python/bindings.h"
#include "python/stoppable.h"

namespace hogelscope {

namespace py = pybind11;

namespace {

/// Returns depth.json, depth.csv and the proposed session, "" if there is none.
std::tuple<std::string, std::string, std::string> depth(const Document& document, int threads,
                                                        const py::object& progress) {
  const ThreadsOfCall limit(threads);
  return stoppable(progress, [&](const Progress& hear) {
    const Session session = sessionOf(document);
    const auto file = openLightField(session.lightField, session.display, part(hear, 0, 0.1));
    const DepthBudget budget = measureDepths(session, *file, {}, part(hear, 0.1, 1));
    return std::tuple(json(budget), csv(budget),
                      budget.proposal ? textOf(budget.proposal->session) : std::string());
  });
}

/// Returns measure.csv; writes it, the page and the plots if `output` is given.
std::string measureSession(const Document& document, const std::string& output, int threads,
                           const py::object& progress) {
  const ThreadsOfCall limit(threads);
  return stoppable(progress, [&](const Progress& hear) {
    MeasureRequest request;
    request.name = document.name.empty() ? "a session of Python" : document.name;
    request.session = sessionOf(document);
    const FilesInUse inUse(filesOf(request.session));
    request.display = displayToMeasure(request.session, hear);
    request.output = output;
    return csv(measure(request, hear).figures);
  });
}

/// Returns sweep.csv; writes it, the page and the plots if `output` is given.
std::string sweepSession(const Document& document, const std::string& table,
                         const std::string& output, int threads, const py::object& progress) {
  const ThreadsOfCall limit(threads);
  return stoppable(progress, [&](const Progress& hear) {
    SweepRequest request;
    request.name = document.name.empty() ? "a session of Python" : document.name;
    request.session = sessionOf(document);
    const FilesInUse inUse(filesOf(request.session));
    request.table = parseSweepTable(table);
    request.output = output;
    const Sweep swept = sweep(request, hear);
    return csv(swept.table, swept.rows);
  });
}

}  // namespace

void addMeasures(py::module_& module) {
  module.def("depth", &depth, py::arg("document"), py::arg("threads"), py::arg("progress"),
             "Whether content fits its display: depth.json, depth.csv, the proposed session.");
  module.def("measure", &measureSession, py::arg("document"), py::arg("output"), py::arg("threads"),
             py::arg("progress"), "The figures of a display: measure.csv.");
  module.def("sweep", &sweepSession, py::arg("document"), py::arg("table"), py::arg("output"),
             py::arg("threads"), py::arg("progress"), "Figures of many designs: sweep.csv.");
}

}  // namespace hogelscope
