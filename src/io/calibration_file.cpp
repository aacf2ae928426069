// SPDX-License-Identifier: BSD-3-Clause
// Camera calibrations as OpenCV writes them.
#include "io/calibration_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <opencv2/core.hpp>
#include <set>
#include <sstream>

#include "core/error.h"
#include "io/atomic_file.h"
#include "io/json_parameters.h"

namespace hogelscope {

namespace {

using Names = std::initializer_list<const char*>;

/// OpenCV prints its errors before it throws them; they come back as InputError.
class QuietOpenCv {
 public:
  QuietOpenCv() {
    m_before =
        cv::redirectError([](int, const char*, const char*, const char*, int, void*) { return 0; });
  }
  ~QuietOpenCv() { cv::redirectError(m_before); }
  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv& operator=(const QuietOpenCv&) = delete;

 private:
  cv::ErrorCallback m_before;
};

/// The part of a line of YAML that says its structure: no comment, nothing in quotes.
std::string structureOf(const std::string& line) {
  std::string structure;
  char quote = 0;
  for (const char c : line) {
    if (quote == 0 && c == '#') break;
    if (quote == 0 && (c == '"' || c == '\''))
      quote = c;
    else if (c == quote)
      quote = 0;
    else if (quote == 0)
      structure += c;
  }
  return structure;
}

/// cv::FileStorage follows what is nested until the stack overflows: brackets, and on one line
/// lists in lists ("- - ") and keys in keys ("a: a: ").
bool isDeeplyNested(const std::string& yaml) {
  constexpr int deepest = 64;
  int open = 0;
  std::istringstream lines(yaml);
  for (std::string line; std::getline(lines, line);) {
    int onLine = 0;
    char before = ' ';
    for (const char c : structureOf(line)) {
      if (c == '[' || c == '{') ++open;
      if (c == ']' || c == '}') open = std::max(0, open - 1);
      if (c == ':' || (c == '-' && before == ' ')) ++onLine;
      if (std::isdigit(static_cast<unsigned char>(c)) != 0 && before == '-') --onLine;
      if (open > deepest || onLine > deepest) return true;
      before = c;
    }
  }
  return false;
}

/// The text of a YAML or JSON file that the parser can be trusted with.
std::string textOf(const std::filesystem::path& file) {
  constexpr std::size_t largest = std::size_t{1} << 20;
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  std::string text = readTextFile(file);
  if (text.size() > largest)
    throw InputError("is larger than 1 MiB: not a camera's calibration", "");
  if (text.starts_with(byteOrderMark)) text.erase(0, byteOrderMark.size());
  const InputError other("is not an OpenCV calibration",
                         "a YAML file begins with %YAML:1.0, a JSON file with {");
  if (text.starts_with("{"))
    (void)parseJson(text);  // our parser knows a deepest depth
  else if (!text.starts_with("%YAML"))
    throw other;
  else if (isDeeplyNested(text))
    throw InputError("is nested deeper than any calibration", "");
  return text;
}

/// A matrix' numbers, row by row: as OpenCV writes it, or as a list (of lists) of numbers.
std::vector<double> numbersOf(const cv::FileNode& node, const std::string& name) {
  std::vector<double> values;
  if (node.isMap()) return numbersOf(node["data"], name);
  if (!node.isSeq()) throw InputError(name, "is not a matrix");
  for (const cv::FileNode& item : node) {
    if (item.isSeq()) {
      for (const double value : numbersOf(item, name)) values.push_back(value);
      continue;
    }
    const double value = item.isReal() || item.isInt() ? item.real() : NAN;
    if (!std::isfinite(value)) throw InputError(name, "has a value that is not a number");
    values.push_back(value);
  }
  return values;
}

std::vector<double> matrix(const cv::FileStorage& storage, Names names) {
  for (const char* name : names)
    if (const cv::FileNode node = storage[name]; !node.empty()) return numbersOf(node, name);
  std::string others;
  for (const char* name : names) others += name == *names.begin() ? "" : std::string(" ") + name;
  throw InputError(*names.begin(), "is missing; it may also be called:" + others);
}

/// Ranges are those of the parameters' description.
template <class Params>
Params checked(const Json& object, const std::string& section) {
  Params params;
  JsonReader reader(object, section);
  describe(reader, params);
  return params;
}

IntrinsicsParams intrinsicsOf(const std::vector<double>& k) {
  if (k.size() != 9) throw InputError("camera_matrix", "is not of 3×3 numbers");
  if (k[1] != 0)
    throw InputError("camera_matrix",
                     "has a skew, " + Json(k[1]).dump() + ", which is not modelled");
  if (k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1)
    throw InputError("camera_matrix", "is not of the form [fx 0 cx; 0 fy cy; 0 0 1]");
  return checked<IntrinsicsParams>({{"fx", k[0]}, {"fy", k[4]}, {"cx", k[2]}, {"cy", k[5]}},
                                   "intrinsics");
}

DistortionParams distortionOf(const std::vector<double>& d) {
  if (d.size() < 4) throw InputError("distortion_coefficients", "are fewer than k1, k2, p1, p2");
  for (std::size_t k = 5; k < d.size(); ++k)
    if (d[k] != 0)
      throw InputError("distortion_coefficients",
                       "are more than k1, k2, p1, p2, k3; calibrate without the rational, thin "
                       "prism and tilted models");
  return checked<DistortionParams>(
      {{"k1", d[0]}, {"k2", d[1]}, {"p1", d[2]}, {"p2", d[3]}, {"k3", d.size() > 4 ? d[4] : 0.0}},
      "distortion");
}

std::optional<std::array<int, 2>> resolutionOf(const cv::FileStorage& storage) {
  const cv::FileNode width = storage["image_width"];
  const cv::FileNode height = storage["image_height"];
  if (width.empty() && height.empty()) return std::nullopt;
  if (!width.isInt() || !height.isInt())
    throw InputError("image_width", "and image_height are not two whole numbers");
  return checked<CameraParams>({{"res", {int(width), int(height)}}}, "image size").res;
}

/// A list of `least` to `most` numbers; `parts` says what they are.
std::vector<double> numbersAt(const Json& camera, const std::string& path, const char* key,
                              std::size_t least, std::size_t most, const char* parts) {
  const std::string what = path + "." + key;
  const auto found = camera.find(key);
  if (found == camera.end()) throw InputError(what, std::string("is missing: [") + parts + "]");
  const bool isList = found->is_array() && found->size() >= least && found->size() <= most;
  std::vector<double> values;
  for (const Json& value : isList ? *found : Json::array())
    if (value.is_number()) values.push_back(value.get<double>());
  if (!isList || values.size() != found->size())
    throw InputError(what, std::string("is not a list of numbers [") + parts + "]");
  return values;
}

NamedCalibration cameraOf(const Json& camera, const std::string& path) {
  if (!camera.is_object()) throw InputError(path, "is not an object with name, size, K and D");
  const auto name = camera.find("name");
  if (name == camera.end() || !name->is_string() || name->get<std::string>().empty())
    throw InputError(path + ".name", "is missing, or not a text that names the camera");
  const auto k = numbersAt(camera, path, "K", 4, 4, "fx, fy, cx, cy");
  const auto d = numbersAt(camera, path, "D", 4, 5, "k1, k2, p1, p2, k3");
  (void)numbersAt(camera, path, "size", 2, 2, "width, height");
  return {name->get<std::string>(),
          {checked<IntrinsicsParams>({{"fx", k[0]}, {"fy", k[1]}, {"cx", k[2]}, {"cy", k[3]}},
                                     path + ".K"),
           checked<DistortionParams>({{"k1", d[0]},
                                      {"k2", d[1]},
                                      {"p1", d[2]},
                                      {"p2", d[3]},
                                      {"k3", d.size() > 4 ? d[4] : 0.0}},
                                     path + ".D"),
           checked<CameraParams>({{"res", camera["size"]}}, path + ".size").res}};
}

std::vector<NamedCalibration> camerasOf(const Json& document) {
  const Json& list = document["cameras"];
  if (!list.is_array() || list.empty())
    throw InputError("cameras", "is not a list of at least one camera");
  std::vector<NamedCalibration> cameras;
  std::set<std::string> names;
  for (const Json& camera : list) {
    const std::string path = "cameras[" + std::to_string(cameras.size()) + "]";
    cameras.push_back(cameraOf(camera, path));
    if (!names.insert(cameras.back().name).second)
      throw InputError(path + ".name",
                       "\"" + cameras.back().name + "\" is another camera's name too");
  }
  return cameras;
}

/// Of a file that says no size: as far to the right of the principal point as to its left.
std::array<int, 2> centredOn(const IntrinsicsParams& k) {
  const auto side = [](double centre) { return static_cast<int>(std::lround(2 * centre)) + 1; };
  const bool isWithin = k.cx >= 0 && k.cy >= 0 && k.cx < 8192 && k.cy < 8192;
  if (!isWithin)
    throw InputError("image_width", "is missing, and the principal point is not in a picture");
  return {side(k.cx), side(k.cy)};
}

bool isCameraList(const std::string& text) {
  const Json document = Json::parse(text, nullptr, false);
  return document.is_object() && document.contains("cameras");
}

}  // namespace

std::vector<NamedCalibration> loadCalibrations(const std::filesystem::path& file) {
  try {
    const std::string text = textOf(file);
    if (isCameraList(text)) return camerasOf(parseJson(text));
    NamedCalibration one{file.stem().string(), loadCalibration(file)};
    if (!one.calibration.res) one.calibration.res = centredOn(one.calibration.intrinsics);
    return {one};
  } catch (const InputError& error) {
    throw error.in(file.string());
  }
}

Calibration loadCalibration(const std::filesystem::path& file) {
  const QuietOpenCv quiet;
  try {
    const cv::FileStorage storage(textOf(file), cv::FileStorage::READ | cv::FileStorage::MEMORY);
    if (!storage.isOpened()) throw InputError("is empty: not an OpenCV calibration", "");
    return {intrinsicsOf(matrix(storage, {"camera_matrix", "cameraMatrix", "K", "M1"})),
            distortionOf(matrix(
                storage, {"distortion_coefficients", "dist_coeffs", "distCoeffs", "D", "D1"})),
            resolutionOf(storage)};
  } catch (const InputError& error) {
    throw error.in(file.string());
  } catch (const cv::Exception&) {
    throw InputError(file.string(), "is not an OpenCV calibration",
                     "a YAML file begins with %YAML:1.0, a JSON file with {");
  }
}

void apply(const Calibration& calibration, CameraState& state) {
  state.intrinsics = calibration.intrinsics;
  state.distortion = calibration.distortion;
  if (calibration.res) state.camera.res = *calibration.res;
}

}  // namespace hogelscope
