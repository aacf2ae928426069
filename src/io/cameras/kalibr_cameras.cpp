// SPDX-License-Identifier: BSD-3-Clause
// Kalibr's camchain, several cameras of a rig, and a sensor of EuRoC's data sets.
#include <algorithm>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_formats.h"

namespace hogelscope {

namespace {

bool isKalibrCamera(const Json& camera) {
  return camera.is_object() && camera.contains("intrinsics") && camera["intrinsics"].is_array() &&
         (camera.contains("camera_model") || camera.contains("distortion_model"));
}

bool isKalibr(const CameraDocument& document) {
  if (document.documents.size() != 1 || !document.documents.front().is_object()) return false;
  const Json& object = document.documents.front();
  return isKalibrCamera(object) || std::any_of(object.begin(), object.end(), isKalibrCamera);
}

FileCamera kalibrCamera(const Json& object, const std::string& name) {
  const std::string path = printable(name) + ".";
  FileCamera camera;
  camera.name = name;
  const std::string whole = textOf(object, {"cameramodel"});
  camera.model = textOf(object, {"distortionmodel"});
  camera.modelKey = path + "distortion_model";
  if (!whole.empty() && plainKey(whole) != "pinhole") {
    camera.model = whole;
    camera.modelKey = path + "camera_model";
  }
  const std::vector<double> k = matrixNumbers(object["intrinsics"], path + "intrinsics");
  if (k.size() < 4) throw InputError(path + "intrinsics", "are fewer than fu, fv, pu, pv");
  const double* const last = &k[k.size() - 4];  // other models have parameters before them
  camera.calibration.intrinsics = checkedIntrinsics(
      {{"fx", last[0]}, {"fy", last[1]}, {"cx", last[2]}, {"cy", last[3]}}, path + "intrinsics");
  std::string key = "distortion_coeffs";
  const Json* const d = memberOf(object, {"distortioncoeffs", "distortioncoefficients"}, &key);
  camera.lensPath = path + key;
  if (d != nullptr) camera.coefficients = matrixNumbers(*d, camera.lensPath);
  if (plainKey(camera.model) == "none") camera.coefficients.clear();
  if (const Json* const size = memberOf(object, {"resolution"}))
    camera.calibration.res = checkedSize(*size, path + "resolution");
  return camera;
}

/// Returns the pose of a camera in the frame of the first one, from the camera before it in the
/// chain; or from the inertial sensor, if all have their pose to it.
std::optional<RigidTransform> poseOf(const Json& object, const std::string& name,
                                     const RigidTransform& firstFromBefore,
                                     const std::optional<RigidTransform>& firstFromImu) {
  if (const auto before = object.find("T_cn_cnm1"); before != object.end())
    return firstFromBefore *
           transformOf(matrixNumbers(*before, name + ".T_cn_cnm1"), name + ".T_cn_cnm1").inverse();
  const auto imu = object.find("T_cam_imu");
  if (imu == object.end() || !firstFromImu) return std::nullopt;
  return *firstFromImu *
         transformOf(matrixNumbers(*imu, name + ".T_cam_imu"), name + ".T_cam_imu").inverse();
}

/// Cameras of which none has a pose to another stand anywhere.
void withoutLonePoses(CameraFile& file) {
  const auto hasPose = [](const FileCamera& camera) { return camera.pose.has_value(); };
  if (std::ranges::count_if(file.cameras, hasPose) > 1) return;
  for (FileCamera& camera : file.cameras) camera.pose.reset();
  file.notes.clear();
}

CameraFile readKalibr(const CameraDocument& document, CameraUse use) {
  const Json& object = document.documents.front();
  CameraFile file;
  if (isKalibrCamera(object)) {
    file.cameras.push_back(kalibrCamera(object, printable(document.file.stem().string())));
    return file;
  }
  file.isRig = true;
  RigidTransform firstFromBefore;
  std::optional<RigidTransform> firstFromImu;
  bool isKnown = true;  // the pose of the camera before
  for (const auto& [name, camera] : object.items()) {
    if (!isKalibrCamera(camera) || file.cameras.size() >= mostCameras) continue;
    file.cameras.push_back(kalibrCamera(camera, name));
    FileCamera& own = file.cameras.back();
    if (file.cameras.size() == 1) {
      own.pose = RigidTransform();
      if (camera.contains("T_cam_imu"))
        firstFromImu = transformOf(matrixNumbers(camera["T_cam_imu"], "T_cam_imu"), "T_cam_imu");
      continue;
    }
    if (isKnown) own.pose = poseOf(camera, name, firstFromBefore, firstFromImu);
    isKnown = own.pose.has_value();
    if (isKnown) firstFromBefore = *own.pose;
    if (!isKnown && use == CameraUse::poses)
      file.notes.push_back(printable(name) + " has no pose to the camera before it (T_cn_cnm1)");
  }
  withoutLonePoses(file);
  return file;
}

}  // namespace

const CameraFormat kalibrFormat{"Kalibr camchain", isKalibr, readKalibr};

}  // namespace hogelscope
