// SPDX-License-Identifier: BSD-3-Clause
// Content that makes up for a display's leakage, for Python.
#include <pybind11/stl.h>

#include <tuple>

#include "core/optics/eyes.h"
#include "io/files/files_in_use.h"
#include "optimise/optimise_page.h"
#include "optimise/optimise_run.h"
#include "python/bindings.h"
#include "python/stoppable.h"

namespace hogelscope {

namespace py = pybind11;

namespace {

/// Writes the content, its table and its page. Returns the table and the warnings.
std::tuple<std::string, std::vector<std::string>> optimiseSession(const Document& document,
                                                                  const std::string& layout,
                                                                  const std::string& output,
                                                                  int threads,
                                                                  const py::object& progress) {
  const ThreadsOfCall limit(threads);
  return stoppable(progress, [&](const Progress& hear) {
    const std::string name = document.name.empty() ? "a session of Python" : document.name;
    const OptimiseRequest request{
        name, withEyes(sessionOf(document)), optimiseLayout(layout, output), output, {}};
    const auto content = optimisedContent(request.session, part(hear, 0, 0.1));
    const FilesInUse inUse(filesOf(request.session, *content));
    const FilesInUse pictures(picturesOf(request.session));
    checkOutputs({request.output, tableOf(request), pageOf(request)});
    const Optimised result = *optimise(request, *content, part(hear, 0.1, 1));
    return std::tuple(csv(result, *content), result.warnings);
  });
}

}  // namespace

void addOptimised(py::module_& module) {
  module.def("optimise", &optimiseSession, py::arg("document"), py::arg("layout"),
             py::arg("output"), py::arg("threads"), py::arg("progress"),
             "Content that makes up for leakage: FILE.csv and warnings.");
}

}  // namespace hogelscope
