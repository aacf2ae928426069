// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/camera_set_file.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_file.h"
#include "io/documents/trace_file.h"
#include "io/documents/votes_file.h"
#include "io/files/atomic_file.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

namespace {

constexpr const char* setVersion = "hogelscopeCameras";
constexpr std::size_t mostPoses = 100000;

constexpr std::array<std::string_view, 3> distributions{"uniform", "random", "normal"};

bool isJson(const std::string& file) {
  return file.ends_with(".json") || file.ends_with(".JSON");
}

/// Whether the name is that of a file: its kind is told by what is in it.
bool isFile(const std::string& what) {
  if (std::ranges::find(distributions, what) != distributions.end()) return false;
  std::error_code none;
  return isJson(what) || what.ends_with(".csv") || what.ends_with(".CSV") ||
         std::filesystem::exists(what, none);
}

/// Applies an override, also to each part of a mixture that has a region of its own.
void overrideSet(Json& document, const std::string& text) {
  const Override change = parseOverride(text);
  if (change.section != "cameraSet" && change.section != "cameraRegion" &&
      change.section != "trace")
    throw InputError("override " + text, "there is no section \"" + change.section +
                                             "\" in a camera set: cameraSet, cameraRegion, trace");
  const auto apply = [&change](Json& section) {
    if (section.is_object() || section.is_null()) section[change.field] = change.value;
  };
  if (!document.is_object()) return;
  apply(document[change.section]);
  if (change.section != "cameraRegion" || !document.contains("mixture")) return;
  for (Json& part : document["mixture"])
    if (part.is_object() && part.contains("cameraRegion")) apply(part["cameraRegion"]);
}

void checkSetVersion(const Json* version) {
  if (version == nullptr)
    throw InputError(setVersion, "is missing: a camera set says \"hogelscopeCameras\": 1");
  if (*version != 1)
    throw InputError(setVersion, version->dump(-1, ' ', true, Json::error_handler_t::replace) +
                                     " is not a version that this program reads: 1");
}

std::string pathOf(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

/// Reads a list of at least `least` elements by `readElement(element, path)`.
template <class Element>
std::vector<Element> listOf(const Json& list, const char* name, std::size_t least,
                            Element (*readElement)(const Json&, const std::string&,
                                                   const CameraRegionParams&),
                            const CameraRegionParams& region) {
  if (!list.is_array()) throw InputError(name, "is not a list: [ { … }, … ]");
  if (list.size() < least || list.size() > mostPoses)
    throw InputError(name, "has " + std::to_string(list.size()) + " elements; allowed are " +
                               std::to_string(least) + " to " + std::to_string(mostPoses));
  std::vector<Element> elements;
  for (std::size_t k = 0; k < list.size(); ++k)
    elements.push_back(readElement(list[k], pathOf(name, k), region));
  return elements;
}

KeyPose readPose(const Json& object, const std::string& path, const CameraRegionParams&) {
  KeyPose pose;
  JsonReader reader(object, path);
  describe(reader, pose);
  reader.refuseUnknown();
  if (pose.eye.x == notGiven) throw InputError(path + ".eye", "is missing: [x, y, z] in metres");
  if (!(pose.eye.z > 0))
    throw InputError(path + ".eye[2]", "is not in front of the panel: z is above 0");
  return pose;
}

Mixture::Part readPart(const Json& object, const std::string& path,
                       const CameraRegionParams& region) {
  Mixture::Part part{1, region};
  JsonReader reader(object, path);
  KeyPose weighed;  // a part's weight has the range of a pose's
  if (const Json* weight = reader.section("weight"); weight != nullptr) {
    const Json alone{{"weight", *weight}};
    JsonReader weightReader(alone, path);
    describe(weightReader, weighed);
  }
  part.weight = weighed.weight;
  readSection(reader, "cameraRegion", part.region);
  reader.refuseUnknown();
  check(part.region, path + ".cameraRegion");
  return part;
}

Mixture readMixture(const Json& list, const CameraRegionParams& region) {
  Mixture mixture{listOf(list, "mixture", 1, readPart, region)};
  double total = 0;
  for (const Mixture::Part& part : mixture.parts) total += part.weight;
  if (!(total > 0)) throw InputError("mixture", "has no part with a weight above 0");
  return mixture;
}

PosePath readPath(const Json& list, const CameraRegionParams& region) {
  PosePath path{listOf(list, "path", 2, readPose, region)};
  for (std::size_t k = 1; k < path.poses.size(); ++k)
    if (path.poses[k].hasLookat() != path.poses[0].hasLookat())
      throw InputError(
          pathOf("path", k) + ".lookat",
          path.poses[0].hasLookat()
              ? "is missing: path[0] has one; either all key poses have it or none"
              : "is given, but path[0] has none; either all key poses have it or none");
  return path;
}

/// Reads the trace's file, whose name is relative to `folder`, into `set`.
void loadTrace(const Json& object, const std::filesystem::path& folder, CameraSet& set) {
  TraceParams params;
  JsonReader reader(object, "trace");
  describe(reader, params);
  reader.refuseUnknown();
  if (params.file.empty()) throw InputError("trace.file", "is missing: the CSV file's name");
  if (params.recording.empty() && !params.only.empty())
    throw InputError("trace.only", "needs trace.recording, the column that says which one it is");
  set.traceFile = (folder / params.file).string();
  set.source = inFile(set.traceFile, [&] {
    const std::string text = readTextFile(set.traceFile);
    if (isVotes(text)) return traceOf(parseVotes(text));
    if (isJson(params.file))
      throw InputError("trace.file", "\"" + params.file + "\" is a document, not a CSV file");
    return readTrace(text, set.region.centre.z, params, &set.notes);
  });
}

/// Reads a document that lies in `folder`.
CameraSet readDocument(const Json& document, const std::filesystem::path& folder) {
  CameraSet set;
  JsonReader reader(document, "");
  checkSetVersion(reader.section(setVersion));
  readSection(reader, "cameraSet", set.params);
  readSection(reader, "cameraRegion", set.region);
  check(set.region, "cameraRegion");
  const Json* mixture = reader.section("mixture");
  const Json* poses = reader.section("poses");
  const Json* path = reader.section("path");
  const Json* trace = reader.section("trace");
  reader.refuseUnknown();
  if ((mixture != nullptr) + (poses != nullptr) + (path != nullptr) + (trace != nullptr) > 1)
    throw InputError(trace != nullptr  ? "trace"
                     : path != nullptr ? "path"
                                       : "poses",
                     "is the second source of states: give one of mixture, poses, path, trace");
  if (mixture != nullptr) set.source = readMixture(*mixture, set.region);
  if (poses != nullptr) set.source = PoseList{listOf(*poses, "poses", 1, readPose, set.region)};
  if (path != nullptr) set.source = readPath(*path, set.region);
  if (trace != nullptr) loadTrace(*trace, folder, set);
  return set;
}

/// Reads the cameras of a file, all or one, and says what is assumed of their places.
void loadCameras(const std::string& file, const std::string& camera, CameraSet& set) {
  const CameraFile cameras = readCameraFile(file, CameraUse::poses);
  CalibratedCameras wanted = calibratedCameras(cameras, camera);
  set.traceFile = file;
  set.notes = cameras.notes;
  const auto hasPose = [](const CalibratedCamera& one) { return one.pose.has_value(); };
  if (std::ranges::none_of(wanted.cameras, hasPose))
    set.notes.emplace_back("says no places of cameras: they stand where the template does");
  else if (cameras.isRig)
    set.notes.push_back(printable(cameras.cameras.front().name) +
                        " stands where the template does, and the others about it");
  else if (!cameras.hasScale && set.params.scale == notGiven)
    set.notes.emplace_back(
        "says no unit of its places: one is taken for a metre; cameraSet.scale "
        "says another");
  set.source = std::move(wanted);
}

/// The document of a trace alone.
Json traceDocument(const std::string& file) {
  return {{setVersion, 1}, {"trace", {{"file", std::filesystem::path(file).filename().string()}}}};
}

Json documentOfSet(const std::string& what) {
  if (isFile(what)) {
    const std::string text = readTextFile(what);
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (isJson(what) && begin == std::string::npos)
      throw InputError("is empty: not a camera set", "");
    if (isVotes(text)) return traceDocument(what);
    if (isJson(what) || (begin != std::string::npos && text[begin] == '{')) return parseJson(text);
  }
  if (isFile(what)) return traceDocument(what);
  if (std::ranges::find(distributions, what) == distributions.end())
    throw InputError("\"" + what + "\" is not one of uniform, random, normal, nor a file", "");
  return {{setVersion, 1}, {"cameraRegion", {{"distribution", what}}}};
}

}  // namespace

CameraSet loadCameraSet(const std::string& what, const std::vector<std::string>& overrides,
                        const std::string& camera) {
  return inFile(isFile(what) ? what : "camera set", [&] {
    const bool isOfCameras = isFile(what) && isCameraFile(what);
    Json document = isOfCameras ? Json{{setVersion, 1}} : documentOfSet(what);
    for (const std::string& text : overrides) overrideSet(document, text);
    CameraSet set = readDocument(document, std::filesystem::path(what).parent_path());
    if (isOfCameras) loadCameras(what, camera, set);
    return set;
  });
}

}  // namespace hogelscope
