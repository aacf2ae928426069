// SPDX-License-Identifier: BSD-3-Clause
// Session documents, read and written through the parameter descriptions.
#include "io/documents/session_file.h"

#include <algorithm>
#include <iterator>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/cameras/state_list_edits.h"
#include "io/documents/light_field_params.h"
#include "io/documents/sheet_file.h"
#include "io/documents/twin_file.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "io/json/json_parameters.h"
#include "io/plugins/display_json.h"
#include "io/plugins/plugin_library.h"
#include "io/plugins/plugin_list.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

constexpr int documentVersion = 1;
constexpr std::array<std::string_view, 5> sharedSections{"display", "twin", "lightField",
                                                         "sampling", "depth"};
constexpr std::array<std::string_view, 6> stateSections{"camera", "intrinsics", "pupil",
                                                        "stereo", "distortion", "psf"};

CameraState readState(const Json& object, const std::string& path) {
  CameraState state;
  JsonReader reader(object, path);
  describe(reader, state.camera);
  readSection(reader, "intrinsics", state.intrinsics);
  readSection(reader, "pupil", state.pupil);
  readSection(reader, "stereo", state.stereo);
  readSection(reader, "distortion", state.distortion);
  readSection(reader, "psf", state.psf);
  reader.refuseUnknown();
  return state;
}

LightFieldParams readLightField(const Json& object) {
  LightFieldParams params;
  JsonReader reader(object, "lightField");
  describe(reader, params);
  if (object.contains("calibration"))
    params.calibration = readSheet(*reader.section("calibration"), reader.pathOf("calibration"));
  if (params.isLive() && !params.source.empty()) {
    params.content = contentParamsOf(params.source);
    if (const Json* own = reader.section(params.source); own != nullptr) {
      JsonReader ownReader(*own, reader.pathOf(params.source));
      describe(ownReader, params.content);
      describe(ownReader, params.live);
      ownReader.refuseUnknown();
    }
  }
  reader.refuseUnknown();
  return params;
}

void checkVersion(const Json* version) {
  const std::string wanted = "\"hogelscope\": " + std::to_string(documentVersion);
  if (version == nullptr) throw InputError("hogelscope", "is missing: a session says " + wanted);
  if (*version != documentVersion)
    throw InputError("hogelscope",
                     version->dump() + " is not a version that this program reads: " + wanted);
}

std::vector<CameraState> readStates(const Json& cameras) {
  if (!cameras.is_array())
    throw InputError("cameras", "is not a list of camera states: [ { … }, … ]");
  std::vector<CameraState> states;
  for (std::size_t k = 0; k < cameras.size(); ++k)
    states.push_back(readState(cameras[k], "cameras[" + std::to_string(k) + "]"));
  return states;
}

std::vector<std::string> readMetrics(const Json& list) {
  const char* const wanted = "is not a list of plugins' names: [\"ms-ssim\"]";
  if (!list.is_array()) throw InputError("metrics", wanted);
  std::vector<std::string> names;
  for (const Json& name : list) {
    if (!name.is_string()) throw InputError("metrics", wanted);
    names.push_back(name.get<std::string>());
  }
  return names;
}

Session readSession(const Json& document) {
  Session session;
  JsonReader reader(document, "");
  checkVersion(reader.section("hogelscope"));
  if (const Json* display = reader.section("display"); display != nullptr)
    session.display = readDisplay(*display);
  if (const Json* twin = reader.section("twin"); twin != nullptr) session.twin = readTwin(*twin);
  if (const Json* lightField = reader.section("lightField"); lightField != nullptr)
    session.lightField = readLightField(*lightField);
  readSection(reader, "sampling", session.sampling);
  readSection(reader, "depth", session.depth);
  if (const Json* metrics = reader.section("metrics"); metrics != nullptr)
    session.metrics = readMetrics(*metrics);
  if (const Json* cameras = reader.section("cameras"); cameras != nullptr)
    session.cameras = readStates(*cameras);
  reader.refuseUnknown();
  check(session);
  return session;
}

/// Returns the object that has the field of a path like "mesh.file", which is created if it is
/// missing; null if something else is in its place.
Json* objectAt(Json& object, const std::string& path) {
  if (!object.is_object() && !object.is_null()) return nullptr;
  const std::size_t dot = path.find('.');
  return dot == std::string::npos ? &object
                                  : objectAt(object[path.substr(0, dot)], path.substr(dot + 1));
}

/// Applies an override to the document, so that one reader checks everything.
void applyOverride(Json& document, const std::string& text) {
  if (text.starts_with("metrics=")) {  // a list, not a section
    if (document.is_object()) document["metrics"] = parseOverride("session." + text).value;
    return;
  }
  const Override change = parseOverride(text);
  const std::string& section = change.section;
  const auto isOneOf = [&section](const auto& names) {
    return std::find(names.begin(), names.end(), section) != names.end();
  };
  if (isOneOf(sharedSections)) {
    if (!document.is_object()) return;
    if (Json* target = objectAt(document[section], change.field); target != nullptr)
      (*target)[change.field.substr(change.field.rfind('.') + 1)] = change.value;
    return;
  }
  if (!isOneOf(stateSections))
    throw InputError("override " + text,
                     "there is no section \"" + section +
                         "\": display, twin, lightField, sampling, depth, camera, intrinsics, "
                         "pupil, stereo, distortion, psf");
  if (!document.is_object() || !document.contains("cameras")) return;
  for (Json& state : document["cameras"]) {
    if (!state.is_object()) continue;
    Json& target = section == "camera" ? state : state[section];
    if (target.is_object() || target.is_null()) target[change.field] = change.value;
  }
}

Json writtenLightField(const LightFieldParams& params) {
  Json object = written(params);
  if (params.calibration)
    object["calibration"] = params.calibrationFile.empty() ? writtenSheet(*params.calibration)
                                                           : Json(params.calibrationFile);
  if (params.content.isGiven()) {
    Json own = written(params.content);
    own.update(written(params.live));
    object[params.source] = std::move(own);
  }
  return object;
}

Json writtenState(const CameraState& state) {
  Json object = written(state.camera);
  if (state.intrinsics.isGiven()) {
    object["intrinsics"] = written(state.intrinsics);
    object.erase("fov");
  }
  // A pinhole and one eye are left out, so documents without them stay as they were.
  if (state.pupil != PupilParams{}) object["pupil"] = written(state.pupil);
  if (state.stereo != StereoParams{}) object["stereo"] = written(state.stereo);
  object["distortion"] = written(state.distortion);
  object["psf"] = written(state.psf);
  return object;
}

/// Applies a calibration to the document too, so that overrides come after it.
void applyCalibration(Json& document, const Calibration& calibration) {
  if (!document.is_object() || !document.contains("cameras")) return;
  for (Json& state : document["cameras"]) {
    if (!state.is_object()) continue;
    state["intrinsics"] = written(calibration.intrinsics);
    state["distortion"] = written(calibration.distortion);
    if (calibration.res) state["res"] = *calibration.res;
  }
}

/// Applies a change to all file names of a session.
template <class Change>
void changeFiles(Session& session, const Change& change) {
  LightFieldParams& lightField = session.lightField;
  for (std::string* const own :
       {&lightField.file, &lightField.lenslets.white, &lightField.lenslets.dark})
    if (!own->empty()) *own = change(*own);
  lightField.content.changeFiles(change);
  for (std::string* const own : session.twin.maps.files()) *own = change(*own);
  if (!session.twinFile.empty()) session.twinFile = change(session.twinFile);
  session.display.lensParams.changeFiles(change);
  if (session.display.sheet && !session.display.sheet->file.empty())
    session.display.sheet->file = change(session.display.sheet->file);
  if (!lightField.calibrationFile.empty())
    lightField.calibrationFile = change(lightField.calibrationFile);
}

/// Reads a document with overrides. The documents of a twin and of lens sheets are kept unless they
/// are overridden.
Session readOverridden(Json& document, const std::vector<std::string>& overrides,
                       const fs::path& folder) {
  const std::string twinFile = embedTwin(document, folder);
  const std::string sheetFile = embedSheet(document, "display", folder);
  const std::string weaveFile = embedSheet(document, "lightField", folder);
  for (const std::string& change : overrides) applyOverride(document, change);
  completeWeave(document);
  Session session = readSession(document);
  const auto isSame = [&](const char* section) {
    return std::ranges::none_of(
        overrides, [&](const std::string& change) { return change.starts_with(section); });
  };
  if (isSame("twin.")) session.twinFile = twinFile;
  if (session.display.sheet && isSame("display.calibration"))
    session.display.sheet->file = sheetFile;
  if (session.lightField.calibration && isSame("lightField.calibration"))
    session.lightField.calibrationFile = weaveFile;
  return session;
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
  Json document = Json::object();
  document["hogelscope"] = documentVersion;
  document["display"] = writtenDisplay(session.display);
  if (!session.twinFile.empty())
    document["twin"] = session.twinFile;
  else if (session.twin != TwinParams{})
    document["twin"] = writtenTwin(session.twin);
  document["lightField"] = writtenLightField(session.lightField);
  document["sampling"] = written(session.sampling);
  if (session.depth != DepthParams{}) document["depth"] = written(session.depth);
  if (!session.metrics.empty()) document["metrics"] = session.metrics;
  document["cameras"] = Json::array();
  for (const CameraState& state : session.cameras)
    document["cameras"].push_back(writtenState(state));
  return formatJson(document);
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
    const Json document = parseJson(readTextFile(file));
    JsonReader reader(document, "");
    checkVersion(reader.section("hogelscope"));
    for (const std::string_view section : sharedSections) (void)reader.section(section);
    (void)reader.section("metrics");
    const Json* cameras = reader.section("cameras");
    reader.refuseUnknown();
    if (cameras == nullptr || cameras->empty())
      throw InputError("cameras", "is missing or empty: there is no camera state to load");
    std::vector<CameraState> states = readStates(*cameras);
    for (std::size_t k = 0; k < states.size(); ++k)
      check(states[k], "cameras[" + std::to_string(k) + "]");
    return states;
  });
}

void appendStates(const fs::path& file, const std::vector<CameraState>& states) {
  inFile(file.string(), [&] {
    Json document = parseJson(readTextFile(file));
    Json whole = document;
    Session session = readOverridden(whole, {}, file.parent_path());
    for (const CameraState& state : states) {
      const std::size_t index = addState(session, state);
      document["cameras"].push_back(writtenState(session.cameras[index]));
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
    Json document = parseJson(textOf(session));
    Session changed = readOverridden(document, overrides, {});
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
  const std::vector<std::string> lens = session.display.lensParams.files();
  std::vector<fs::path> files(lens.begin(), lens.end());
  if (!session.twinFile.empty()) files.emplace_back(session.twinFile);
  if (session.display.sheet && !session.display.sheet->file.empty())
    files.emplace_back(session.display.sheet->file);
  if (!session.lightField.calibrationFile.empty())
    files.emplace_back(session.lightField.calibrationFile);
  TwinMapFiles maps = session.twin.maps;
  for (const std::string* const file : maps.files()) files.emplace_back(*file);
  std::vector<std::string> plugins = session.metrics;
  plugins.push_back(session.display.lensSource);
  plugins.push_back(session.lightField.source);
  std::ranges::copy(pluginFiles(plugins), std::back_inserter(files));
  return files;
}

}  // namespace hogelscope
