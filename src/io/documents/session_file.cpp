// SPDX-License-Identifier: BSD-3-Clause
// Session documents, read and written through the parameter descriptions.
#include "io/documents/session_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/cameras/state_list_edits.h"
#include "io/documents/light_field_params.h"
#include "io/files/atomic_file.h"
#include "io/files/folders.h"
#include "io/images/image_file.h"
#include "io/json/json_parameters.h"
#include "io/layouts/view_layouts.h"
#include "io/opening/capture_geometry.h"
#include "io/opening/hogel_grid.h"
#include "io/opening/tile_grid.h"
#include "io/plugins/display_json.h"
#include "io/plugins/plugin_library.h"
#include "io/scene/fit_mesh.h"
#include "io/scene/live_file.h"
#include "io/scene/scene.h"
#include "io/store/light_field_store.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

constexpr int documentVersion = 1;
constexpr std::array<std::string_view, 3> sharedSections{"display", "lightField", "sampling"};
constexpr std::array<std::string_view, 4> stateSections{"camera", "intrinsics", "distortion",
                                                        "psf"};

CameraState readState(const Json& object, const std::string& path) {
  CameraState state;
  JsonReader reader(object, path);
  describe(reader, state.camera);
  readSection(reader, "intrinsics", state.intrinsics);
  readSection(reader, "distortion", state.distortion);
  readSection(reader, "psf", state.psf);
  reader.refuseUnknown();
  return state;
}

LightFieldParams readLightField(const Json& object) {
  LightFieldParams params;
  JsonReader reader(object, "lightField");
  describe(reader, params);
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
  if (const Json* lightField = reader.section("lightField"); lightField != nullptr)
    session.lightField = readLightField(*lightField);
  readSection(reader, "sampling", session.sampling);
  if (const Json* metrics = reader.section("metrics"); metrics != nullptr)
    session.metrics = readMetrics(*metrics);
  if (const Json* cameras = reader.section("cameras"); cameras != nullptr)
    session.cameras = readStates(*cameras);
  reader.refuseUnknown();
  check(session);
  return session;
}

/// Returns the object that has the field of a path like "mesh.file", made where it is missing; null
/// if something else is there.
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
                         "\": display, lightField, sampling, camera, intrinsics, distortion, psf");
  if (!document.is_object() || !document.contains("cameras")) return;
  for (Json& state : document["cameras"]) {
    if (!state.is_object()) continue;
    Json& target = section == "camera" ? state : state[section];
    if (target.is_object() || target.is_null()) target[change.field] = change.value;
  }
}

Json writtenLightField(const LightFieldParams& params) {
  Json object = written(params);
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

/// Returns a file name in a document that lies in `folder` relative to the current folder.
std::string besideDocument(const fs::path& folder, const std::string& file) {
  std::error_code error;
  const fs::path joined = folder / file;
  fs::path shorter = joined.lexically_normal();
  if (!shorter.has_filename()) shorter = shorter.parent_path();  // "views/" is "views"
  // ".." after a link leads elsewhere than it reads.
  const bool isSame = !fs::exists(joined, error) || fs::equivalent(joined, shorter, error);
  return isSame ? shorter.string() : joined.string();
}

/// Returns `file` relative to the document's folder.
std::string relativeTo(const fs::path& document, const std::string& file) {
  if (file.empty()) return {};
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(document, error).parent_path(), error);
  const fs::path target = fs::weakly_canonical(fs::absolute(file, error), error);
  const fs::path relative = target.lexically_relative(folder);
  return relative.empty() ? target.string() : relative.string();
}

/// What is wrong with a plugin's lens is said when its document is read.
void openLenses(const DisplayParams& display) {
  for (const std::size_t axis : {0, 1}) (void)lensOf(display, axis);
}

std::optional<DisplayParams> displayOfStore(const LightFieldParams& params) {
  if (params.layout != Layout::pack) return std::nullopt;
  return LightFieldStore(params.file).header().display;
}

}  // namespace

Session parseSession(const std::string& text, const fs::path& folder,
                     const std::vector<std::string>& overrides,
                     const std::optional<Calibration>& calibration) {
  Json document = parseJson(text);
  if (calibration) applyCalibration(document, *calibration);
  for (const std::string& change : overrides) applyOverride(document, change);
  Session session = readSession(document);
  if (!session.lightField.isLive())
    session.lightField.file = besideDocument(folder, session.lightField.file);
  const auto moved = [&](const std::string& own) { return besideDocument(folder, own); };
  for (std::string* const own :
       {&session.lightField.lenslets.white, &session.lightField.lenslets.dark})
    if (!own->empty()) *own = moved(*own);
  session.lightField.content.changeFiles(moved);
  session.display.lensParams.changeFiles(moved);
  openLenses(session.display);
  return session;
}

Session loadSession(const fs::path& file, const std::vector<std::string>& overrides,
                    const std::optional<Calibration>& calibration) {
  try {
    return parseSession(readTextFile(file), file.parent_path(), overrides, calibration);
  } catch (const InputError& error) {
    throw error.in(file.string());
  }
}

std::string textOf(const Session& session) {
  Json document = Json::object();
  document["hogelscope"] = documentVersion;
  document["display"] = writtenDisplay(session.display);
  document["lightField"] = writtenLightField(session.lightField);
  document["sampling"] = written(session.sampling);
  if (!session.metrics.empty()) document["metrics"] = session.metrics;
  document["cameras"] = Json::array();
  for (const CameraState& state : session.cameras)
    document["cameras"].push_back(writtenState(state));
  try {
    return formatJson(document);
  } catch (const Json::exception&) {
    throw InputError("document", "a name in it is not UTF-8");
  }
}

void saveSession(const fs::path& file, const Session& session) {
  Session moved = session;
  moved.lightField.file = relativeTo(file, session.lightField.file);
  const auto move = [&](const std::string& own) { return relativeTo(file, own); };
  moved.lightField.lenslets.white = move(session.lightField.lenslets.white);
  moved.lightField.lenslets.dark = move(session.lightField.lenslets.dark);
  moved.lightField.content.changeFiles(move);
  moved.display.lensParams.changeFiles(move);
  try {
    writeTextFile(file, textOf(moved));
  } catch (const InputError& error) {
    throw error.in(file.string());
  }
}

std::vector<CameraState> loadStates(const fs::path& file) {
  try {
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
  } catch (const InputError& error) {
    throw error.in(file.string());
  }
}

void appendStates(const fs::path& file, const std::vector<CameraState>& states) {
  try {
    Json document = parseJson(readTextFile(file));
    Session session = readSession(document);
    for (const CameraState& state : states) {
      const std::size_t index = addState(session, state);
      document["cameras"].push_back(writtenState(session.cameras[index]));
    }
    check(session);
    writeTextFile(file, formatJson(document));
  } catch (const InputError& error) {
    throw error.in(file.string());
  }
}

bool isSessionFile(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension == ".json" || extension == ".hogelscope";
}

namespace {

Session overridden(const Session& session, const std::vector<std::string>& overrides) {
  if (overrides.empty()) return session;
  try {
    Json document = parseJson(textOf(session));
    for (const std::string& text : overrides) applyOverride(document, text);
    Session changed = readSession(document);
    openLenses(changed.display);
    return changed;
  } catch (const InputError& error) {
    throw error.in(session.lightField.file);
  }
}

/// 0.5 m is its longer side.
std::array<double, 2> sizeOfShape(double width, double height) {
  const double longest = std::max(width, height) / 0.5;
  return {width / longest, height / longest};
}

/// Whether it is known how many hogels and directions there are, in the file or in the session.
bool canBeOpened(const Session& session) {
  const LightFieldParams& lightField = session.lightField;
  if (lightField.layout == Layout::quilt)
    return lightField.quiltColumns > 0 || quiltTilesFromName(lightField.file)[0] > 0;
  if (lightField.layout == Layout::mosaic) return session.display.directions[0] > 0;
  return lightField.layout != Layout::hogels ||
         (session.display.hogels[0] > 0 && session.display.directions[0] > 0);
}

std::string pairText(const std::array<int, 2>& numbers) {
  return std::to_string(numbers[0]) + "×" + std::to_string(numbers[1]);
}

/// A quilt has a few large views, a hogel image many small hogels.
bool isLikeQuilt(const HogelGrid& grid) {
  constexpr int mostViews = 20, leastPixels = 100;  // of each axis
  return std::ranges::max(grid.hogels) <= mostViews &&
         std::ranges::min(grid.directions) >= leastPixels;
}

/// Puts a quilt's or a mosaic's number of views into the session.
void takeTiles(OrderedSession& result, const std::array<int, 2>& tiles, const std::string& how) {
  const bool isMosaic = result.session.lightField.layout == Layout::mosaic;
  if (isMosaic) {
    result.session.display.directions = tiles;
  } else {
    result.session.lightField.layout = Layout::quilt;
    result.session.lightField.quiltColumns = tiles[0];
    result.session.lightField.quiltRows = tiles[1];
  }
  result.hogels = Sureness::likely;
  result.assumed =
      (isMosaic ? "a mosaic of " : "a quilt of ") + pairText(tiles) + " views, found by " + how;
}

/// Puts what a picture shows of its hogels, or of tiles of views, into the session; says so. The
/// layout may be another one unless it is given.
void findHogels(OrderedSession& result, bool isLayoutGiven, const Progress& progress) {
  const LightFieldParams& lightField = result.session.lightField;
  const bool isTiled = lightField.layout == Layout::quilt || lightField.layout == Layout::mosaic;
  ImageFile image{fs::path(lightField.file), lightField.yuv};
  const std::optional<HogelGrid> grid = findHogelGrid(image, part(progress, 0, 0.5));
  constexpr double clear = 8;  // standard errors
  const bool isClear = grid && grid->standOut >= clear;
  result.hogels = Sureness::unknown;
  if (!isClear && (isTiled || !isLayoutGiven))
    if (const auto tiles = findTileGrid(image, part(progress, 0.5, 1)))
      return takeTiles(result, *tiles, "how alike they are");
  if (!grid) return;
  const std::string how = "their borders in the picture";
  if (isTiled || (!isLayoutGiven && isLikeQuilt(*grid)))
    return takeTiles(result, grid->hogels, how);
  result.hogels = isClear ? Sureness::sure : Sureness::likely;
  result.session.display.hogels = grid->hogels;
  result.session.display.directions = grid->directions;
  result.assumed = pairText(grid->hogels) + " hogels of " + pairText(grid->directions) +
                   " directions, found by " + how;
}

/// Tiles that were taken for a quilt's, but show vertical parallax.
void takeForMosaic(OrderedSession& result, Session& said, const Progress& progress) {
  LightFieldParams& lightField = result.session.lightField;
  const std::array tiles{std::exchange(lightField.quiltColumns, 0),
                         std::exchange(lightField.quiltRows, 0)};
  lightField.layout = Layout::mosaic;
  takeTiles(result, tiles, "parallax along both axes");
  said.lightField = lightField;
  said.display.directions = tiles;
  result.order = findLightFieldOrder(lightField, said.display, progress);
}

bool isLayoutGiven(const std::vector<std::string>& overrides) {
  return std::ranges::any_of(
      overrides, [](const std::string& text) { return text.starts_with("lightField.layout="); });
}

/// `given` may say how many directions the views of one running number have.
DisplayParams displayAround(const LightFieldParams& lightField, const DisplayParams& given) {
  DisplayParams display;
  if (lightField.layout == Layout::hogels) {
    const ImageFile image{fs::path(lightField.file), lightField.yuv};
    display.size = sizeOfShape(double(image.width()), double(image.height()));
  } else if (const auto known = displayOfStore(lightField)) {
    display = *known;
  } else {
    const LightFieldSize size = openLightField(lightField, given)->size();
    const double aspect =
        lightField.layout == Layout::quilt ? quiltAspectFromName(lightField.file) : 0;
    display.size = aspect > 0 ? sizeOfShape(aspect, 1) : sizeOfShape(size.nx, size.ny);
  }
  return display;
}

/// Views whose capture says where its cameras stood are put on a panel where they were in focus.
/// Returns whether it says so.
bool takeGeometry(Session& session, const DisplayParams& given) {
  LightFieldParams& lightField = session.lightField;
  if (lightField.layout != Layout::views || !isFolder(lightField.file)) return false;
  const ViewFiles views = findViews(lightField, given.directions);
  const ImageFile first(views.found().front(), lightField.yuv);
  const auto [width, height] = std::pair(int(first.width()), int(first.height()));
  const auto geometry = captureGeometry(lightField.file, views, width, height);
  if (!geometry) return false;
  const auto rounded = [](std::array<double, 2> pair) {  // for readers of the session
    for (double& value : pair) value = std::round(value * 1e6) / 1e6;
    return pair;
  };
  session.display.size = rounded(geometry->panel);
  session.display.fov = rounded(geometry->fovOf(views.columns, views.rows));
  lightField.viewingDistance = geometry->distance;
  lightField.shear = rounded(geometry->shearOf(width, height));
  return true;
}

}  // namespace

Session newSession() {
  Session session;
  session.display.hogels = {256, 256};
  session.display.directions = {100, 100};
  session.lightField.layout = Layout::live;
  session.lightField.source = "scene";
  session.lightField.content = contentParamsOf(session.lightField.source);
  session.cameras = {inFrontOf(session.display)};
  return session;
}

OrderedSession orderedSessionAround(const std::string& file,
                                    const std::vector<std::string>& overrides,
                                    const Progress& progress) {
  OrderedSession result;
  Session& session = result.session;
  session.lightField = lightFieldOf(file);
  addState(session, inFrontOf(session.display));
  if (session.lightField.isLive()) {
    fitMesh(session.lightField, session.display, progress);
  } else {
    Session said = overridden(session, overrides);  // which may say how to read it
    session.lightField = said.lightField;
    const bool isGuessed = !canBeOpened(said) && !isLayoutGiven(overrides);
    if (!canBeOpened(said)) {
      findHogels(result, !isGuessed, part(progress, 0, 0.5));
      said.lightField = session.lightField;
      said.display.hogels = session.display.hogels;
      said.display.directions = session.display.directions;
    }
    if (canBeOpened(said)) {
      result.order = findLightFieldOrder(said.lightField, said.display, part(progress, 0.5, 0.8));
      if (result.order.isLikeMosaic && isGuessed)
        takeForMosaic(result, said, part(progress, 0.8, 1));
      session.lightField = result.order.found;
    }
    session.display = displayAround(session.lightField, said.display);
    const Layout layout = session.lightField.layout;
    if (layout == Layout::hogels || layout == Layout::mosaic) {
      session.display.hogels = said.display.hogels;
      session.display.directions = said.display.directions;
    }
    if (const double distance = std::exchange(session.display.viewingDistance, notGiven);
        distance > 0)
      session.lightField.viewingDistance = distance;
    if (takeGeometry(session, said.display)) {
      result.order.found.viewingDistance = session.lightField.viewingDistance;
      result.order.found.shear = session.lightField.shear;
    }
  }
  session.cameras = {inFrontOf(displayOf(session))};
  session = overridden(session, overrides);
  const bool isOrderGiven = session.lightField.rows != result.order.found.rows ||
                            session.lightField.columns != result.order.found.columns;
  if (isGridOfViews(session.lightField.layout) && isOrderGiven) {
    session.lightField = withOrderOf(session.lightField, result.order);
    session = overridden(session, overrides);
  }
  return result;
}

Session sessionAround(const std::string& file, const std::vector<std::string>& overrides,
                      const Progress& progress) {
  return orderedSessionAround(file, overrides, progress).session;
}

Session withLightField(const Session& session, const std::string& file) {
  Session result = session;
  if (isSessionFile(file)) {
    const Session other = loadSession(file);
    result.display = other.display;
    result.lightField = other.lightField;
  } else {
    result.lightField = withFile(session.lightField, file);
    check(result);
  }
  return result;
}

}  // namespace hogelscope
