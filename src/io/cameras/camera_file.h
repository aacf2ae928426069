// SPDX-License-Identifier: BSD-3-Clause
// Files of cameras as calibration and reconstruction programs write them; they are recognised by
// what is in them, whatever their names are.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/cameras/calibrated_camera.h"

namespace hogelscope {

/// A camera as its file describes it, also one whose lens is not modelled.
struct FileCamera {
  std::string name;
  std::string modelKey = "distortion_model";  ///< what the file calls the field of the model
  std::string model;                          ///< the lens model by the file's name; "": not said
  /// In the order of the model: k1, k2, p1, p2, k3, … (brown, rational), k1 … k4 (fisheye).
  std::vector<double> coefficients;
  std::string lensPath = "distortion";   ///< of them, in errors
  Calibration calibration;               ///< without distortion
  std::optional<RigidTransform> pose{};  ///< worldFromCamera; the axes are right, down, forward
  std::string picture{};                 ///< the path of its picture in the file; "": not said
};

/// The cameras of a file.
struct CameraFile {
  std::string format;  ///< "ROS camera_info" …
  std::vector<FileCamera> cameras;
  bool hasScale = true;              ///< places are in metres; otherwise in a unit of their own
  bool isRig = false;                ///< poses are in the first camera's frame, not in a world's
  std::vector<std::string> notes{};  ///< what was guessed, and what the file has that is not used
};

/// Says what a file of COLMAP's is read for: the cameras themselves, or each image's pose.
enum class CameraUse { lens, poses };

/// Whether a file has cameras in a form that is known. Large files of pictures are not read for it.
bool isCameraFile(const std::filesystem::path& file);

/// Reads the cameras of a file: cv::FileStorage's YAML, XML and JSON; JSON and YAML of matrices by
/// their usual names (K, mtx, camera_matrix; D, dist, dist_coeffs), of one camera, of a stereo pair
/// or of several by name; ROS camera_info, also as topic echo prints it; Kalibr's camchain;
/// transforms.json of instant-ngp and nerfstudio; cameras.json of Gaussian splats; glTF and GLB;
/// COLMAP's cameras and images, text and binary, or the folder of them. Throws InputError, also for
/// a file that has none, but not for a lens that is not modelled.
CameraFile readCameraFile(const std::filesystem::path& file, CameraUse use);

/// Returns the lens model as the program calls it, "Brown–Conrady", "fisheye" or "rational"; ""
/// for others.
std::string lensModelOf(const FileCamera& camera);

/// Returns what the camera gives to states. Throws InputError that names the lens model if it is
/// none of distortionModelNames(), and if a value is out of its range.
Calibration calibrationOf(const FileCamera& camera);

/// Returns the cameras for states, `camera` alone if it is not "". Throws InputError likewise.
CalibratedCameras calibratedCameras(const CameraFile& file, const std::string& camera = "");

/// Returns the names of a file's cameras if they differ in more than their poses; else none.
std::vector<std::string> differingCameras(const CameraFile& file);

/// Reads the one camera of a file, or the one called `camera`; cameras that differ in their poses
/// alone are one. Adds what was guessed or left aside to `notes`. Throws InputError as above, and
/// with the names if there are several.
Calibration loadCalibration(const std::filesystem::path& file, const std::string& camera = "",
                            std::vector<std::string>* notes = nullptr);

struct NamedCalibration {
  std::string name;
  Calibration calibration;
};

/// Reads all cameras of a file with the sizes of their pictures: centred on the principal point
/// where the file has no size. A single camera without a name is named after the file. Throws
/// InputError as above, also for two cameras of one name.
std::vector<NamedCalibration> loadCalibrations(const std::filesystem::path& file);

/// Returns a warning for a state of `res` pixels whose calibration is of pictures of another size,
/// with the overrides that scale it to the state's width, or has no size; else "".
std::string sizeWarning(const Calibration& calibration, const std::array<int, 2>& res);

}  // namespace hogelscope
