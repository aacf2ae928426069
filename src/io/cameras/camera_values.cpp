// SPDX-License-Identifier: BSD-3-Clause
// What the readers of camera files share.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_formats.h"

namespace hogelscope {

std::string plainKey(std::string_view key) {
  std::string plain;
  for (const char c : key)
    if (c != '_' && c != '-' && c != '.' && c != ' ')
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return plain;
}

const Json* memberOf(const Json& object, KeyNames names, std::string* key) {
  if (!object.is_object()) return nullptr;
  for (const std::string_view name : names)
    for (const auto& [own, value] : object.items())
      if (plainKey(own) == name) {
        if (key != nullptr) *key = own;
        return &value;
      }
  return nullptr;
}

std::string textOf(const Json& object, KeyNames names, std::string* key) {
  const Json* const value = memberOf(object, names, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : "";
}

double numberIn(const Json& object, const std::string& path, const char* key, double otherwise) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  if (!found->is_number()) throw InputError(path + key, valueText(*found) + " is not a number");
  return found->get<double>();
}

std::vector<double> matrixNumbers(const Json& value, const std::string& name) {
  if (value.is_object() && value.contains("data")) return matrixNumbers(value["data"], name);
  if (value.is_string())
    throw InputError(name, "is a text; write matrices as numbers, without cv::FileStorage::BASE64");
  if (!value.is_array()) throw InputError(name, "is not a matrix");
  std::vector<double> values;
  for (const Json& item : value) {
    if (item.is_array()) {
      for (const double number : matrixNumbers(item, name)) values.push_back(number);
      continue;
    }
    if (!item.is_number()) throw InputError(name, "has a value that is not a number");
    values.push_back(item.get<double>());
  }
  return values;
}

RigidTransform transformOf(const std::vector<double>& matrix, const std::string& path) {
  if (matrix.size() != 12 && matrix.size() != 16)
    throw InputError(path, "is not a matrix of 4×4 or 3×4 numbers");
  if (matrix.size() == 16 &&
      (matrix[12] != 0 || matrix[13] != 0 || matrix[14] != 0 || matrix[15] != 1))
    throw InputError(path, "is not of the form [R t; 0 0 0 1]");
  const auto column = [&](std::size_t k) { return Vec3{matrix[k], matrix[4 + k], matrix[8 + k]}; };
  const RigidTransform transform{column(0), column(1), column(2), column(3)};
  constexpr double tolerance = 1e-3;  // of files with few digits
  const Vec3 third = cross(transform.xAxis, transform.yAxis);
  const bool isRotation = std::abs(length(transform.xAxis) - 1) < tolerance &&
                          std::abs(length(transform.yAxis) - 1) < tolerance &&
                          std::abs(dot(transform.xAxis, transform.yAxis)) < tolerance &&
                          length(third - transform.zAxis) < 2 * tolerance;
  constexpr double farthest = 1e9;
  if (!isRotation || !(length(transform.origin) < farthest))
    throw InputError(path, "is not a rotation and a place: it scales, skews or mirrors");
  return transform;
}

RigidTransform fromOpenGl(const RigidTransform& worldFromCamera) {
  return {worldFromCamera.xAxis, -1.0 * worldFromCamera.yAxis, -1.0 * worldFromCamera.zAxis,
          worldFromCamera.origin};
}

RigidTransform rotationOf(double w, double x, double y, double z, const std::string& path) {
  const double n = std::hypot(std::hypot(w, x), std::hypot(y, z));
  if (!(n > 1e-9) || !std::isfinite(n)) throw InputError(path, "is not a quaternion");
  w /= n, x /= n, y /= n, z /= n;
  return {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
          {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
          {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)},
          {}};
}

IntrinsicsParams checkedIntrinsics(const Json& values, const std::string& section) {
  IntrinsicsParams intrinsics;
  JsonReader reader(values, section);
  describe(reader, intrinsics);
  return intrinsics;
}

std::array<int, 2> checkedSize(const Json& pair, const std::string& section) {
  CameraParams camera;
  const Json values{{"res", pair}};
  JsonReader reader(values, section);
  describe(reader, camera);
  return camera.res;
}

std::string stemOf(const std::string& path) {
  const std::size_t begin = path.find_last_of("/\\");
  const std::string name = begin == std::string::npos ? path : path.substr(begin + 1);
  const std::size_t dot = name.rfind('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

}  // namespace hogelscope
