// SPDX-License-Identifier: BSD-3-Clause
// Cameras of captures as radiance fields are trained with: transforms.json of instant-ngp and
// nerfstudio, and cameras.json of Gaussian splats. Their pixels are counted from the picture's
// corner, half a pixel more than from the first pixel's middle.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_formats.h"

namespace hogelscope {

namespace {

/// Returns the value of a frame, or else of the whole file.
const Json* eitherOf(const Json& frame, const Json& file, const char* key) {
  for (const Json* object : {&frame, &file})
    if (const auto found = object->find(key); found != object->end() && !found->is_null())
      return &*found;
  return nullptr;
}

class CaptureFrame {
 public:
  CaptureFrame(const Json& frame, const Json& file, std::string path)
      : m_frame(frame), m_file(file), m_path(std::move(path)) {}

  [[nodiscard]] double number(const char* key, double otherwise = notGiven) const {
    const Json* const value = eitherOf(m_frame, m_file, key);
    if (value == nullptr) return otherwise;
    if (!value->is_number()) throw InputError(m_path + key, valueText(*value) + " is not a number");
    return value->get<double>();
  }

  [[nodiscard]] Calibration calibration() const {
    Calibration calibration;
    const Json* const w = eitherOf(m_frame, m_file, "w");
    const Json* const h = eitherOf(m_frame, m_file, "h");
    if (w != nullptr && h != nullptr) calibration.res = checkedSize({*w, *h}, m_path + "w, h");
    Json values = Json::object();
    const auto take = [&](const char* name, double value) {
      if (value != notGiven) values[name] = value;
    };
    const double fx = number("fl_x"), fy = number("fl_y"), cx = number("cx"), cy = number("cy");
    take("cx", cx == notGiven ? cx : cx - 0.5);
    take("cy", cy == notGiven ? cy : cy - 0.5);
    take("fx", fx != notGiven ? fx : fy);
    take("fy", fy);
    calibration.intrinsics = checkedIntrinsics(values, m_path + "intrinsics");
    if (calibration.intrinsics.isGiven()) return calibration;
    for (const auto& [axis, key] : {std::pair(0, "camera_angle_x"), {1, "camera_angle_y"}}) {
      const double angle = number(key);
      if (angle == notGiven) continue;
      if (!(angle > 0 && angle < std::numbers::pi))
        throw InputError(m_path + key, "is not an angle between 0 and π");
      calibration.fov[std::size_t(axis)] = angle * 180 / std::numbers::pi;
    }
    if (calibration.fov == std::array{notGiven, notGiven})
      throw InputError(m_path + "fl_x", "is missing, and there is no camera_angle_x either");
    return calibration;
  }

  void takeLens(FileCamera& camera) const {
    const Json* const model = eitherOf(m_frame, m_file, "camera_model");
    camera.modelKey = m_path + "camera_model";
    if (model != nullptr && model->is_string()) camera.model = model->get<std::string>();
    const Json* const fisheye = eitherOf(m_frame, m_file, "is_fisheye");
    if (fisheye != nullptr && (*fisheye == true || *fisheye == 1)) {
      camera.modelKey = m_path + "is_fisheye";
      camera.model = "fisheye";
    }
    camera.lensPath = m_path + "distortion";
    const bool isFisheye = lensModelOf(camera) == "fisheye";
    for (const char* key :
         isFisheye ? std::array{"k1", "k2", "k3", "k4"} : std::array{"k1", "k2", "p1", "p2"})
      camera.coefficients.push_back(number(key, 0));
    if (isFisheye) return;
    camera.coefficients.push_back(number("k3", 0));
    if (number("k4", 0) != 0) camera.coefficients.push_back(number("k4"));
  }

 private:
  const Json& m_frame;
  const Json& m_file;
  std::string m_path;
};

/// Returns the names of pictures without their folders, unless two would then be the same.
std::vector<std::string> namesOf(const std::vector<std::string>& files) {
  std::vector<std::string> names, sorted;
  for (const std::string& file : files) names.push_back(stemOf(file));
  sorted = names;
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) == sorted.end()) return names;
  for (std::size_t k = 0; k < files.size(); ++k) {
    std::string path = files[k].substr(0, files[k].size());
    const std::size_t dot = path.rfind('.');
    if (dot != std::string::npos && path.find_first_of("/\\", dot) == std::string::npos && dot > 1)
      path.resize(dot);
    for (char& c : path)
      if (c == '/' || c == '\\') c = '-';
    const std::size_t begin = path.find_first_not_of(".-");
    names[k] = begin == std::string::npos ? names[k] : path.substr(begin);
  }
  return names;
}

bool isTransforms(const CameraDocument& document) {
  if (document.documents.size() != 1 || !document.documents.front().is_object()) return false;
  const Json& object = document.documents.front();
  const auto frames = object.find("frames");
  if (frames == object.end() || !frames->is_array()) return false;
  constexpr std::array keys{"camera_angle_x", "fl_x", "camera_model"};
  return std::ranges::any_of(keys, [&](const char* key) { return object.contains(key); }) ||
         std::any_of(frames->begin(), frames->end(), [](const Json& frame) {
           return frame.is_object() && frame.contains("transform_matrix");
         });
}

CameraFile readTransforms(const CameraDocument& document, CameraUse /*use*/) {
  const Json& object = document.documents.front();
  const Json& frames = object["frames"];
  CameraFile file;
  file.hasScale = false;
  std::vector<std::string> pictures;
  for (std::size_t k = 0; k < std::min(frames.size(), mostCameras); ++k) {
    const std::string path = "frames[" + std::to_string(k) + "].";
    if (!frames[k].is_object()) throw InputError(path, "is not an object");
    const CaptureFrame frame(frames[k], object, path);
    FileCamera camera;
    camera.calibration = frame.calibration();
    frame.takeLens(camera);
    const auto matrix = frames[k].find("transform_matrix");
    if (matrix == frames[k].end()) throw InputError(path + "transform_matrix", "is missing");
    camera.pose = fromOpenGl(
        transformOf(matrixNumbers(*matrix, path + "transform_matrix"), path + "transform_matrix"));
    const std::string picture = textOf(frames[k], {"filepath"});
    camera.picture = picture;
    pictures.push_back(picture.empty() ? "camera" : picture);
    file.cameras.push_back(std::move(camera));
  }
  if (frames.empty()) {  // a file of intrinsics alone
    const Json none = Json::object();
    FileCamera camera;
    camera.calibration = CaptureFrame(none, object, "").calibration();
    CaptureFrame(none, object, "").takeLens(camera);
    file.cameras.push_back(camera);
    pictures.push_back(document.file.stem().string());
  }
  const std::vector<std::string> names = namesOf(pictures);
  for (std::size_t k = 0; k < names.size(); ++k) file.cameras[k].name = names[k];
  return file;
}

bool isSplat(const Json& camera) {
  constexpr std::array keys{"position", "rotation", "fx", "fy", "width", "height"};
  return camera.is_object() &&
         std::ranges::all_of(keys, [&](const char* key) { return camera.contains(key); });
}

bool areSplats(const CameraDocument& document) {
  return document.documents.size() == 1 && document.documents.front().is_array() &&
         !document.documents.front().empty() && isSplat(document.documents.front().front());
}

/// The rotation's columns are right, down and forward in the world, the axis is in the middle.
CameraFile readSplats(const CameraDocument& document, CameraUse /*use*/) {
  CameraFile file;
  file.hasScale = false;
  const Json& list = document.documents.front();
  std::vector<std::string> pictures;
  for (std::size_t k = 0; k < std::min(list.size(), mostCameras); ++k) {
    const std::string path = "[" + std::to_string(k) + "].";
    if (!isSplat(list[k])) throw InputError(path, "is not a camera of position, rotation, fx, fy");
    FileCamera camera;
    camera.calibration.intrinsics =
        checkedIntrinsics({{"fx", list[k]["fx"]}, {"fy", list[k]["fy"]}}, path);
    camera.calibration.res = checkedSize({list[k]["width"], list[k]["height"]}, path + "size");
    const std::vector<double> r = matrixNumbers(list[k]["rotation"], path + "rotation");
    const std::vector<double> p = matrixNumbers(list[k]["position"], path + "position");
    if (r.size() != 9 || p.size() != 3)
      throw InputError(path + "rotation", "and position are not of 3×3 and 3 numbers");
    camera.pose =
        transformOf({r[0], r[1], r[2], p[0], r[3], r[4], r[5], p[1], r[6], r[7], r[8], p[2]},
                    path + "rotation");
    const std::string picture = textOf(list[k], {"imgname", "imagename"});
    camera.picture = picture;
    pictures.push_back(picture.empty() ? "camera" : picture);
    file.cameras.push_back(std::move(camera));
  }
  const std::vector<std::string> names = namesOf(pictures);
  for (std::size_t k = 0; k < names.size(); ++k) file.cameras[k].name = names[k];
  return file;
}

}  // namespace

const CameraFormat transformsFormat{"transforms.json", isTransforms, readTransforms};
const CameraFormat splatsFormat{"cameras.json of Gaussian splats", areSplats, readSplats};

}  // namespace hogelscope
