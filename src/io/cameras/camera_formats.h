// SPDX-License-Identifier: BSD-3-Clause
// The formats of camera files: how each is recognised, and its reader.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "io/cameras/camera_file.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

/// A file that has been parsed: documents of JSON, YAML or XML, or none for COLMAP's own forms.
struct CameraDocument {
  std::filesystem::path file;
  std::vector<Json> documents{};
  std::string_view syntax{};  ///< "YAML", "XML", "JSON", "OpenCV YAML"; "" for COLMAP's
};

struct CameraFormat {
  std::string_view name;
  bool (*recognises)(const CameraDocument& document);
  CameraFile (*read)(const CameraDocument& document, CameraUse use);
};

extern const CameraFormat transformsFormat;
extern const CameraFormat splatsFormat;
extern const CameraFormat gltfFormat;
extern const CameraFormat kalibrFormat;
extern const CameraFormat rosFormat;
extern const CameraFormat listFormat;
extern const CameraFormat matrixFormat;
extern const CameraFormat colmapFormat;

/// The largest number of cameras that are read from a file.
constexpr std::size_t mostCameras = 100000;

// What the readers share.

using KeyNames = std::initializer_list<std::string_view>;

/// Returns a key in small letters, without _, -, . and spaces, as names of fields are compared.
std::string plainKey(std::string_view key);

/// Returns the member of an object whose plain key is one of `names`, the first of them that there
/// is; null if there is none. Sets `key` to its key in the file.
const Json* memberOf(const Json& object, KeyNames names, std::string* key = nullptr);

/// Returns the text of such a member; "" if there is none or it is no text.
std::string textOf(const Json& object, KeyNames names, std::string* key = nullptr);

/// Returns a number of an object, or `otherwise`. Throws InputError for anything but a number.
double numberIn(const Json& object, const std::string& path, const char* key, double otherwise);

/// Returns a matrix row by row: as OpenCV writes it, or as a list (of lists) of numbers. Throws
/// InputError.
std::vector<double> matrixNumbers(const Json& value, const std::string& name);

/// Returns the rigid transform of the 12 or 16 numbers of a matrix, row by row. Throws InputError
/// if its first three columns are not those of a rotation.
RigidTransform transformOf(const std::vector<double>& matrix, const std::string& path);

/// Returns OpenCV's axes, right, down, forward, of a camera whose own are right, up, backward.
RigidTransform fromOpenGl(const RigidTransform& worldFromCamera);

/// Returns the rotation of a quaternion; it need not have the length 1. Throws InputError for 0.
RigidTransform rotationOf(double w, double x, double y, double z, const std::string& path);

/// Returns the parameters, whose ranges are those of their description. Throws InputError that
/// begins with `section`.
IntrinsicsParams checkedIntrinsics(const Json& values, const std::string& section);
std::array<int, 2> checkedSize(const Json& pair, const std::string& section);

/// Returns the last part of a file's name without its ending; the separators may be Windows'.
std::string stemOf(const std::string& path);

}  // namespace hogelscope
