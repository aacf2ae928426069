// SPDX-License-Identifier: BSD-3-Clause
// Pages with the engine in them, for Python.
#include <pybind11/stl.h>

#include <filesystem>
#include <tuple>

#include "io/files/atomic_file.h"
#include "io/files/files_in_use.h"
#include "io/files/folders.h"
#include "io/scene/view_source.h"
#include "python/bindings.h"
#include "python/stoppable.h"
#include "web/view_page.h"

namespace hogelscope {

namespace py = pybind11;

namespace {

/// Returns the page's text and its notes; writes it if `output` is given.
std::tuple<std::string, std::vector<std::string>> page(const Document& document,
                                                       const std::string& title,
                                                       const std::string& output,
                                                       const std::optional<bool>& isExact,
                                                       int threads, const py::object& progress) {
  const ThreadsOfCall limit(threads);
  return stoppable(progress, [&](const Progress& hear) {
    const Session session = sessionOf(document);
    requirePage(session);
    const std::shared_ptr<LightFieldFile> file =
        openLightField(session.lightField, session.display, part(hear, 0, 0.1));
    const FilesInUse inUse(filesOf(session, *file));
    if (!output.empty()) checkOutputs({output});
    std::optional<PageQuality> quality;
    if (isExact) quality = *isExact ? PageQuality::exact : PageQuality::small;
    ViewPage made = viewPage(session, {{title, file}}, {title, quality}, part(hear, 0.1, 1));
    if (!output.empty()) {
      makeFolderOf(output);
      writeTextFile(output, made.html);
    }
    return std::tuple(std::move(made.html), std::move(made.notes));
  });
}

}  // namespace

void addPages(py::module_& module) {
  module.def("page", &page, py::arg("document"), py::arg("title"), py::arg("output"),
             py::arg("is_exact"), py::arg("threads"), py::arg("progress"),
             "A page with the engine in it: its text and its notes.");
}

}  // namespace hogelscope
