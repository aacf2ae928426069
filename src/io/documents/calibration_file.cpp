// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/calibration_file.h"

#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/atomic_file.h"
#include "io/json/json_parameters.h"
#include "io/json/yaml_reader.h"

namespace hogelscope {

namespace {

using Names = std::initializer_list<const char*>;

/// Reads the names and values of a YAML or JSON file.
Json documentOf(const std::filesystem::path& file) {
  constexpr std::size_t largest = std::size_t{1} << 20;
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  std::string text = readTextFile(file);
  if (text.size() > largest)
    throw InputError("is larger than 1 MiB: not a camera's calibration", "");
  if (text.starts_with(byteOrderMark)) text.erase(0, byteOrderMark.size());
  if (text.starts_with("{")) return parseJson(text, JsonComments::ignored);
  if (text.starts_with("%YAML")) return parseOpenCvYaml(text);
  throw InputError("is not an OpenCV calibration",
                   "a YAML file begins with %YAML:1.0, a JSON file with {");
}

/// Returns a matrix row by row: as OpenCV writes it, or as a list (of lists) of numbers.
std::vector<double> numbersOf(const Json& value, const std::string& name) {
  if (value.is_object() && value.contains("data")) return numbersOf(value["data"], name);
  if (value.is_string())
    throw InputError(name, "is a text; write matrices as numbers, without cv::FileStorage::BASE64");
  if (!value.is_array()) throw InputError(name, "is not a matrix");
  std::vector<double> values;
  for (const Json& item : value) {
    if (item.is_array()) {
      for (const double number : numbersOf(item, name)) values.push_back(number);
      continue;
    }
    if (!item.is_number()) throw InputError(name, "has a value that is not a number");
    values.push_back(item.get<double>());
  }
  return values;
}

std::vector<double> matrix(const Json& document, Names names) {
  for (const char* name : names)
    if (const auto found = document.find(name); found != document.end())
      return numbersOf(*found, name);
  std::string others;
  for (const char* name : names) others += name == *names.begin() ? "" : std::string(" ") + name;
  throw InputError(*names.begin(), "is missing; it may also be called:" + others);
}

/// Returns the parameters, whose ranges are those of their description.
template <class Params>
Params checked(const Json& object, const std::string& section) {
  Params params;
  JsonReader reader(object, section);
  describe(reader, params);
  return params;
}

/// Returns the distortion of k1, k2, p1, p2 and, unless it is 0, k3.
DistortionParams checkedDistortion(const std::vector<double>& d, const std::string& section) {
  return checked<DistortionParams>(
      {{"k1", d[0]}, {"k2", d[1]}, {"p1", d[2]}, {"p2", d[3]}, {"k3", d.size() > 4 ? d[4] : 0.0}},
      section);
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
  return checkedDistortion(d, "distortion");
}

std::optional<std::array<int, 2>> resolutionOf(const Json& document) {
  const Json width = document.value("image_width", Json());
  const Json height = document.value("image_height", Json());
  if (width.is_null() && height.is_null()) return std::nullopt;
  if (!width.is_number_integer() || !height.is_number_integer())
    throw InputError("image_width", "and image_height are not two whole numbers");
  return checked<CameraParams>({{"res", {width, height}}}, "image size").res;
}

/// Reads a list of `least` to `most` numbers; `parts` names them in errors.
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
           checkedDistortion(d, path + ".D"),
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

/// Returns the image size for a file without one: the principal point is the middle.
std::array<int, 2> centredOn(const IntrinsicsParams& k) {
  const auto side = [](double centre) { return static_cast<int>(std::lround(2 * centre)) + 1; };
  const bool isWithin = k.cx >= 0 && k.cy >= 0 && k.cx < 8192 && k.cy < 8192;
  if (!isWithin)
    throw InputError("image_width", "is missing, and the principal point is not in a picture");
  return {side(k.cx), side(k.cy)};
}

Calibration calibrationOf(const Json& document) {
  return {intrinsicsOf(matrix(document, {"camera_matrix", "cameraMatrix", "K", "M1"})),
          distortionOf(matrix(document,
                              {"distortion_coefficients", "dist_coeffs", "distCoeffs", "D", "D1"})),
          resolutionOf(document)};
}

}  // namespace

std::vector<NamedCalibration> loadCalibrations(const std::filesystem::path& file) {
  return inFile(file.string(), [&]() -> std::vector<NamedCalibration> {
    const Json document = documentOf(file);
    if (document.contains("cameras")) return camerasOf(document);
    NamedCalibration one{printable(file.stem().string()), calibrationOf(document)};
    if (!one.calibration.res) one.calibration.res = centredOn(one.calibration.intrinsics);
    return {one};
  });
}

Calibration loadCalibration(const std::filesystem::path& file) {
  return inFile(file.string(), [&] { return calibrationOf(documentOf(file)); });
}

void apply(const Calibration& calibration, CameraState& state) {
  state.intrinsics = calibration.intrinsics;
  state.distortion = calibration.distortion;
  if (calibration.res) state.camera.res = *calibration.res;
}

}  // namespace hogelscope
