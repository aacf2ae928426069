// SPDX-License-Identifier: BSD-3-Clause
// The Python extension module _hogelscope.
#include "core/base/error.h"
#include "core/base/version.h"
#include "python/bindings.h"
#include "python/stoppable.h"
#include "sdk/hogelscope/plugin.h"

namespace py = pybind11;

PYBIND11_MODULE(_hogelscope, module) {
  using namespace hogelscope;
  module.doc() = "What the package hogelscope is made of; use that.";
  // Work is stopped by a signal or a listener's exception, which is raised itself; this exception
  // never is.
  py::register_exception<Cancelled>(module, "Stopped", PyExc_KeyboardInterrupt);
  auto& error = py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
  error.attr("__module__") = "hogelscope";
  error.attr("__doc__") =
      "Input that can be put right. The message is \"FILE: WHAT: WHY\", in the program's words.";
  module.attr("version") = programVersion();
  module.attr("plugin_abi") = plugin::abi;
  waitAtExit();
  addDocuments(module);
  addLightFields(module);
  addViews(module);
  addFigures(module);
  addMeasures(module);
  addOptimised(module);
  addReports(module);
  addCampaigns(module);
  addPages(module);
  module.attr("LightField").attr("__module__") = "hogelscope";
}
