// SPDX-License-Identifier: BSD-3-Clause
// Sessions and camera sets for Python, as JSON texts.
#include <pybind11/stl.h>

#include "core/base/error.h"
#include "io/cameras/camera_file.h"
#include "io/documents/camera_set_file.h"
#include "io/documents/session_file.h"
#include "io/files/files_in_use.h"
#include "io/opening/session_around.h"
#include "io/plugins/plugin_list.h"
#include "io/scene/view_source.h"
#include "python/bindings.h"
#include "python/stoppable.h"

namespace hogelscope {

namespace py = pybind11;

namespace {

void checkDocument(const Document& document) {
  runStoppable(py::none(), [&](const Progress&) { (void)sessionOf(document); });
}

std::string normal(const Document& document) {
  return stoppable(py::none(), [&](const Progress&) { return textOf(sessionOf(document)); });
}

void save(const Document& document, const std::string& file) {
  runStoppable(py::none(), [&](const Progress&) {
    const Session session = sessionOf(document);
    if (!isSessionFile(file))
      throw InputError(file, "cannot be written", "a session's name ends in .hogelscope or .json");
    const FilesInUse inUse(filesOf(session));
    saveSession(file, session);
  });
}

py::tuple load(const std::string& file, const std::vector<std::string>& overrides,
               const std::string& calibration, const std::string& camera) {
  std::vector<std::string> warnings;
  std::string text = stoppable(py::none(), [&](const Progress&) {
    std::optional<Calibration> read;
    if (!calibration.empty()) read = loadCalibration(calibration, camera, &warnings);
    const Session session = loadSession(file, overrides, read);
    if (read && !session.cameras.empty())
      warnings.push_back(sizeWarning(*read, session.cameras.front().camera.res));
    return textOf(session);
  });
  std::erase(warnings, "");
  for (std::string& warning : warnings) warning = calibration + ": " + warning;
  return py::make_tuple(text, warnings);
}

py::tuple around(const std::string& file, const std::vector<std::string>& overrides,
                 const py::object& progress) {
  const OrderedSession found = stoppable(
      progress, [&](const Progress& hear) { return orderedSessionAround(file, overrides, hear); });
  return py::make_tuple(textOf(found.session), warningsOf(found.session.lightField, found.order));
}

/// Returns what --info --json prints.
std::string info(const std::string& file, const std::vector<std::string>& overrides,
                 const py::object& progress) {
  return stoppable(progress, [&](const Progress& hear) {
    try {
      OrderedSession subject;
      if (isSessionDocument(file)) {
        subject.session = loadSession(file, overrides);
        subject.order =
            findLightFieldOrder(subject.session.lightField, subject.session.display, hear);
      } else {
        subject = orderedSessionAround(file, overrides, hear);
      }
      return orderDocument(orderOf(subject));
    } catch (const InputError& error) {
      throw error.in(file);
    }
  });
}

/// Returns a session that contains only the new states.
std::string cameras(const Document& document, const std::string& what,
                    const std::vector<std::string>& overrides) {
  return stoppable(py::none(), [&](const Progress&) {
    Session session = sessionOf(document);
    const std::size_t before = session.cameras.size();
    CameraSet set = loadCameraSet(what, overrides);
    set.keepsTimes = std::holds_alternative<Trace>(set.source) && isInTime(session);
    session = withCameras(session, set);
    const std::size_t first = before - (set.params.keepTemplate ? 0 : 1);
    session.cameras.erase(session.cameras.begin(), session.cameras.begin() + std::ptrdiff_t(first));
    return textOf(session);
  });
}

}  // namespace

Session sessionOf(const Document& document) {
  try {
    return parseSession(document.text, document.folder);
  } catch (const InputError& error) {
    throw document.name.empty() ? error : error.in(document.name);
  }
}

void addDocuments(py::module_& module) {
  py::class_<Document>(module, "Document", "A session's text, its folder and its name.")
      .def(py::init<std::string, std::string, std::string>(), py::arg("text"), py::arg("folder"),
           py::arg("name"));
  module.def("check", &checkDocument, py::arg("document"),
             "Raises InputError if it is not a session.");
  module.def("normal", &normal, py::arg("document"),
             "The session as the program writes it: all fields, files relative to the current "
             "folder.");
  module.def("load", &load, py::arg("file"), py::arg("overrides"), py::arg("calibration"),
             py::arg("camera"),
             "A session file as normal() gives it, with overrides and a camera of a file, and "
             "warnings.");
  module.def("around", &around, py::arg("file"), py::arg("overrides"), py::arg("progress"),
             "A new session around a folder, a picture or a mesh, and warnings.");
  module.def("info", &info, py::arg("file"), py::arg("overrides"), py::arg("progress"),
             "What --info --json prints of a light field or a session.");
  module.def("cameras", &cameras, py::arg("document"), py::arg("what"), py::arg("overrides"),
             "The session with the states of a camera set instead of its own.");
  module.def("save", &save, py::arg("document"), py::arg("file"), "Writes a session file.");
  module.def(
      "add_plugin_folder", [](const std::string& folder) { addPluginFolder(folder); },
      py::arg("folder"),
      "Look for plugins in this folder, too: each is a folder in it. Raises InputError.");
}

}  // namespace hogelscope
