// SPDX-License-Identifier: BSD-3-Clause
// Camera sets from documents (JSON) and viewers' traces (CSV).
#include "io/camera_set_file.h"

#include <charconv>
#include <optional>

#include "core/error.h"
#include "io/atomic_file.h"
#include "io/json_parameters.h"

namespace hogelscope {

namespace {

constexpr const char* versionKey = "hogelscopeCameras";
constexpr std::size_t mostPoses = 100000;

/// Also to each part of a mixture that has a region of its own.
void applyOverride(Json& document, const std::string& text) {
  const Override change = parseOverride(text);
  if (change.section != "cameraSet" && change.section != "cameraRegion")
    throw InputError("--set " + text, "there is no section \"" + change.section +
                                          "\" in a camera set: cameraSet, cameraRegion");
  const auto apply = [&change](Json& section) {
    if (section.is_object() || section.is_null()) section[change.field] = change.value;
  };
  if (!document.is_object()) return;
  apply(document[change.section]);
  if (change.section != "cameraRegion" || !document.contains("mixture")) return;
  for (Json& part : document["mixture"])
    if (part.is_object() && part.contains("cameraRegion")) apply(part["cameraRegion"]);
}

void checkVersion(const Json* version) {
  if (version == nullptr)
    throw InputError(versionKey, "is missing: a camera set says \"hogelscopeCameras\": 1");
  if (*version != 1)
    throw InputError(versionKey, version->dump(-1, ' ', true, Json::error_handler_t::replace) +
                                     " is not a version that this program reads: 1");
}

std::string pathOf(const char* list, std::size_t index) {
  return std::string(list) + "[" + std::to_string(index) + "]";
}

/// A list of `least` elements at least, each read by `readElement(element, path)`.
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
  KeyPose weighed;  // the weight's range is a pose's
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

CameraSet readDocument(const Json& document) {
  CameraSet set;
  JsonReader reader(document, "");
  checkVersion(reader.section(versionKey));
  readSection(reader, "cameraSet", set.params);
  readSection(reader, "cameraRegion", set.region);
  check(set.region, "cameraRegion");
  const Json* mixture = reader.section("mixture");
  const Json* poses = reader.section("poses");
  const Json* path = reader.section("path");
  reader.refuseUnknown();
  if ((mixture != nullptr) + (poses != nullptr) + (path != nullptr) > 1)
    throw InputError(path != nullptr ? "path" : "poses",
                     "is the second source of states: give one of mixture, poses, path");
  if (mixture != nullptr) set.source = readMixture(*mixture, set.region);
  if (poses != nullptr) set.source = PoseList{listOf(*poses, "poses", 1, readPose, set.region)};
  if (path != nullptr) set.source = readPath(*path, set.region);
  return set;
}

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<std::string_view> cellsOf(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t comma = 0; comma != std::string_view::npos;) {
    comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    line.remove_prefix(comma == std::string_view::npos ? line.size() : comma + 1);
  }
  return cells;
}

std::optional<double> numberOf(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// As an error line shows it: short, and without what would garble a terminal.
std::string shown(std::string_view cell) {
  constexpr std::size_t longest = 40;
  std::string text(cell.substr(0, longest));
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '?';
  return "\"" + text + (cell.size() > longest ? "…\"" : "\"");
}

/// The lines of a trace, one after the other.
class TraceReader {
 public:
  explicit TraceReader(double distance) : m_distance(distance) {}

  void read(std::string_view line) {
    ++m_line;
    line = trimmed(line);
    if (line.empty()) return;
    const std::vector<std::string_view> cells = cellsOf(line);
    if (m_columns == 0) {
      m_columns = cells.size();
      if (m_columns < 3 || m_columns > 4)
        refuse(shown(line) + " is not time, x, y or time, x, y, z");
      if (!numberOf(cells[0])) return checkNames(cells, line);
    }
    if (cells.size() != m_columns)
      refuse("has " + std::to_string(cells.size()) + " cells, the first line has " +
             std::to_string(m_columns));
    add(cells);
  }

  Trace result() {
    if (m_trace.points.size() < 2)
      throw InputError("has " + std::to_string(m_trace.points.size()) +
                           " point(s): a trace has two at least, lines of time, x, y[, z]",
                       "");
    return std::move(m_trace);
  }

 private:
  static constexpr std::array<const char*, 4> names{"time", "x", "y", "z"};

  void checkNames(const std::vector<std::string_view>& cells, std::string_view line) const {
    for (std::size_t k = 0; k < cells.size(); ++k)
      if (cells[k] != names[k]) refuse(shown(line) + " is not time, x, y or time, x, y, z");
  }

  void add(const std::vector<std::string_view>& cells) {
    std::array<double, 4> values{0, 0, 0, m_distance};
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const double farthest = k == 0 ? 1e12 : 1e4;
      const std::optional<double> value = numberOf(cells[k]);
      if (!value || !(*value >= -farthest && *value <= farthest))
        refuse(std::string(names[k]) + " " + shown(cells[k]) + " is not a number from " +
               (k == 0 ? "-1e12 to 1e12 s" : "-10000 to 10000 m"));
      values[k] = *value;
    }
    if (!(values[3] > 0)) refuse("z " + shown(cells[3]) + " is not above 0, in front of the panel");
    if (!m_trace.points.empty() && !(values[0] > m_trace.points.back().time))
      refuse("time " + shown(cells[0]) + " is not after that of the line before");
    m_trace.points.push_back({values[0], {values[1], values[2], values[3]}});
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError("line " + std::to_string(m_line), why);
  }

  double m_distance;
  std::size_t m_line = 0;
  std::size_t m_columns = 0;
  Trace m_trace;
};

Trace readTrace(std::string_view text, double distance) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // as spreadsheets begin a file
  TraceReader reader(distance);
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    reader.read(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return reader.result();
}

bool isCsv(const std::string& file) {
  return file.ends_with(".csv") || file.ends_with(".CSV");
}

bool isJson(const std::string& file) {
  return file.ends_with(".json") || file.ends_with(".JSON");
}

Json documentOf(const std::string& what) {
  if (isJson(what)) {
    const std::string text = readTextFile(what);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
      throw InputError("is empty: not a camera set", "");
    return parseJson(text);
  }
  Json document{{versionKey, 1}};
  if (isCsv(what)) return document;
  if (what != "uniform" && what != "random" && what != "normal")
    throw InputError("\"" + what +
                         "\" is not one of uniform, random, normal, nor a FILE.json or "
                         "FILE.csv",
                     "");
  document["cameraRegion"]["distribution"] = what;
  return document;
}

}  // namespace

CameraSet loadCameraSet(const std::string& what, const std::vector<std::string>& overrides) {
  const bool isFile = isJson(what) || isCsv(what);
  try {
    Json document = documentOf(what);
    for (const std::string& text : overrides) applyOverride(document, text);
    CameraSet set = readDocument(document);
    if (isCsv(what)) set.source = readTrace(readTextFile(what), set.region.centre.z);
    return set;
  } catch (const InputError& error) {
    throw error.in(isFile ? what : "--make-cameras");
  }
}

}  // namespace hogelscope
