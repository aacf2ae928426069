// SPDX-License-Identifier: BSD-3-Clause
// Session documents, read and written through the parameter descriptions.
#include "io/documents/session_file.h"

#include <algorithm>
#include <iterator>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/cameras/state_list_edits.h"
#include "io/documents/light_field_params.h"
#include "io/documents/session_parts.h"
#include "io/documents/sheet_file.h"
#include "io/documents/twin_file.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "io/plugins/plugin_library.h"
#include "io/plugins/plugin_list.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// The names of a session's sections, and of those of its states.
class SectionNames : public SectionVisitor {
 public:
  SectionNames() {
    Session session;
    session.cameras.resize(1);
    parts(session);
  }
  std::vector<std::string> shared;
  std::vector<std::string> ofStates{"camera"};

 private:
  ParameterVisitor* fieldVisitor() override { return nullptr; }
  bool begin(std::string_view name, bool /*isWritten*/) override {
    (m_isState ? ofStates : shared).emplace_back(name);
    return false;
  }
  void end() override {}
  void items(std::string_view /*name*/, std::string_view /*what*/, std::size_t /*count*/,
             const std::function<void(std::size_t count)>& /*resize*/,
             const std::function<void(std::size_t index)>& visit) override {
    m_isState = true;
    visit(0);
  }

  bool m_isState = false;
};

const SectionNames& sectionNames() {
  static const SectionNames names;
  return names;
}

/// Returns the object of a document that a session names in its place: a twin's, with its files as
/// from the session's folder, or a lens sheet's calibration.
Json loadNamed(const std::string& path, const std::string& name, const fs::path& folder) {
  return path == "twin" ? twinObject(name, folder) : sheetObject(folder / name);
}

/// Returns the object that has the field of a path like "mesh.file", which is created if it is
/// missing; the document that stands in its place is read. Null if something else is in its place.
Json* objectAt(Json& object, const std::string& around, const std::string& path,
               const fs::path& folder) {
  if (object.is_string() && (around == "twin" || around.ends_with(".calibration")))
    object = loadNamed(around, object.get<std::string>(), folder);
  if (!object.is_object() && !object.is_null()) return nullptr;
  const std::size_t dot = path.find('.');
  if (dot == std::string::npos) return &object;
  const std::string name = path.substr(0, dot);
  return objectAt(object[name], around + "." + name, path.substr(dot + 1), folder);
}

/// Applies an override to the document, so that one reader checks everything.
void applyOverride(Json& document, const std::string& text, const fs::path& folder) {
  if (text.starts_with("metrics=")) {  // a list, not a section
    if (document.is_object()) document["metrics"] = parseOverride("session." + text).value;
    return;
  }
  const Override change = parseOverride(text);
  const std::string& section = change.section;
  const SectionNames& names = sectionNames();
  const auto isOneOf = [&section](const std::vector<std::string>& known) {
    return std::ranges::find(known, section) != known.end();
  };
  if (isOneOf(names.shared)) {
    if (!document.is_object()) return;
    if (Json* target = objectAt(document[section], section, change.field, folder);
        target != nullptr)
      (*target)[change.field.substr(change.field.rfind('.') + 1)] = change.value;
    return;
  }
  if (!isOneOf(names.ofStates)) {
    std::string known;
    for (const auto& list : {names.shared, names.ofStates})
      for (const std::string& name : list) known += (known.empty() ? "" : ", ") + name;
    throw InputError("override " + text, "there is no section \"" + section + "\": " + known);
  }
  if (!document.is_object() || !document.contains("cameras")) return;
  for (Json& state : document["cameras"]) {
    if (!state.is_object()) continue;
    Json& target = section == "camera" ? state : state[section];
    if (target.is_object() || target.is_null()) target[change.field] = change.value;
  }
}

/// Applies a calibration to the document too, so that overrides come after it.
void applyCalibration(Json& document, const Calibration& calibration) {
  if (!document.is_object() || !document.contains("cameras")) return;
  for (Json& state : document["cameras"]) {
    if (!state.is_object()) continue;
    CameraParams shown;
    try {
      if (state.contains("res")) shown.res = state["res"].get<std::array<int, 2>>();
    } catch (const Json::exception&) {  // the state's reader says what is wrong
      continue;
    }
    const Calibration own = completed(calibration, shown.res);
    if (own.intrinsics.isGiven()) state["intrinsics"] = written(own.intrinsics);
    state["distortion"] = written(own.distortion);
    state["res"] = *own.res;
  }
}

/// Applies a change to all file names of a session.
void changeFiles(Session& session, const FileVisitor::Change& change) {
  FileVisitor(change).parts(session);
}

/// Reads a document with overrides; an override of what stands in a document of its own ends the
/// session's naming of that document.
Session readOverridden(Json& document, const std::vector<std::string>& overrides,
                       const fs::path& folder) {
  for (const std::string& change : overrides) applyOverride(document, change, folder);
  Session session;
  readParts(document, "", session, [&](const std::string& path, const std::string& name) {
    return loadNamed(path, name, folder);
  });
  check(session);
  return session;
}

/// Gives a session the layout of an override, so that it is written without the fields that mean
/// something else there: "columns" is an order of views, or a quilt's number of them.
void takeLayout(Session& session, const std::vector<std::string>& overrides) {
  for (const std::string& text : overrides) {
    if (!text.starts_with("lightField.layout=")) continue;
    const Json value = parseOverride(text).value;
    for (const Layout layout :
         {Layout::hogels, Layout::views, Layout::quilt, Layout::mosaic, Layout::lenslets})
      if (!session.lightField.isLive() && value == nameOf(layout))
        session.lightField.layout = layout;
  }
}

/// Opens the lenses of plugins, so that their errors are reported when the document is read.
void openLenses(const DisplayParams& display) {
  for (const std::size_t axis : {0, 1}) (void)lensOf(display, axis);
}

}  // namespace

Session parseSession(const std::string& text, const fs::path& folder,
                     const std::vector<std::string>& overrides,
                     const std::optional<Calibration>& calibration) {
  Json document = parseJson(text);
  if (calibration) applyCalibration(document, *calibration);
  Session session = readOverridden(document, overrides, folder);
  changeFiles(session, [&](const std::string& own) { return besideDocument(folder, own); });
  openLenses(session.display);
  return session;
}

Session loadSession(const fs::path& file, const std::vector<std::string>& overrides,
                    const std::optional<Calibration>& calibration) {
  return inFile(file.string(), [&] {
    return parseSession(readTextFile(file), file.parent_path(), overrides, calibration);
  });
}

std::string textOf(const Session& session) {
  return formatJson(writtenParts(session));
}

std::string textFor(const fs::path& file, const Session& session) {
  Session moved = session;
  changeFiles(moved, [&](const std::string& own) { return relativeTo(file, own); });
  return inFile(file.string(), [&] { return textOf(moved); });
}

void saveSession(const fs::path& file, const Session& session) {
  writeTextFile(file, textFor(file, session));
}

std::vector<CameraState> loadStates(const fs::path& file) {
  return inFile(file.string(), [&] {
    Json document = parseJson(readTextFile(file));
    // All else may be wrong.
    for (const std::string& name : sectionNames().shared)
      if (document.is_object()) document.erase(name);
    Session session;
    readParts(document, "", session);
    if (session.cameras.empty())
      throw InputError("cameras", "is missing or empty: there is no camera state to load");
    for (std::size_t k = 0; k < session.cameras.size(); ++k)
      check(session.cameras[k], "cameras[" + std::to_string(k) + "]");
    return session.cameras;
  });
}

void appendStates(const fs::path& file, const std::vector<CameraState>& states) {
  inFile(file.string(), [&] {
    Json document = parseJson(readTextFile(file));
    Json whole = document;
    Session session = readOverridden(whole, {}, file.parent_path());
    for (const CameraState& state : states) {
      const std::size_t index = addState(session, state);
      document["cameras"].push_back(writtenParts(session.cameras[index]));
    }
    check(session);
    writeTextFile(file, formatJson(document));
  });
}

bool isSessionFile(const fs::path& file) {
  const std::string extension = lowerCase(file.extension().string());
  return extension == ".json" || extension == ".hogelscope";
}

bool isSessionDocument(const fs::path& file) {
  return isSessionFile(file) && !isFolder(file);
}

Session overridden(const Session& session, const std::vector<std::string>& overrides) {
  if (overrides.empty()) return session;
  return inFile(session.lightField.file, [&] {
    Session changed = session;
    takeLayout(changed, overrides);
    Json document = parseJson(textOf(changed));
    changed = readOverridden(document, overrides, {});
    openLenses(changed.display);
    return changed;
  });
}

Session newSession() {
  Session session;
  session.display.hogels = {256, 256};
  session.display.directions = {100, 100};
  session.lightField.layout = Layout::live;
  session.lightField.source = "scene";
  session.lightField.content = contentParamsOf(session.lightField.source);
  session.cameras = {inFrontOf(displayOf(session))};
  return session;
}

std::vector<fs::path> sessionFiles(const Session& session) {
  Session own = session;
  own.lightField = {};
  own.lightField.calibrationFile = session.lightField.calibrationFile;
  std::vector<fs::path> files;
  changeFiles(own, [&](const std::string& file) {
    files.emplace_back(file);
    return file;
  });
  std::vector<std::string> plugins = session.metrics;
  plugins.push_back(session.display.lensSource);
  plugins.push_back(session.lightField.source);
  std::ranges::copy(pluginFiles(plugins), std::back_inserter(files));
  return files;
}

}  // namespace hogelscope
