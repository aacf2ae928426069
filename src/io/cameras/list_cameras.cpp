// SPDX-License-Identifier: BSD-3-Clause
// The program's own list of cameras,
// {"cameras": [{"name": …, "size": [w, h], "K": [fx, fy, cx, cy], "D": [k1, k2, p1, p2, k3]}]}.
#include <algorithm>

#include "core/base/error.h"
#include "io/cameras/camera_formats.h"

namespace hogelscope {

namespace {

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

FileCamera listedCamera(const Json& listed, const std::string& path) {
  if (!listed.is_object()) throw InputError(path, "is not an object with name, size, K and D");
  const auto name = listed.find("name");
  if (name == listed.end() || !name->is_string() || name->get<std::string>().empty())
    throw InputError(path + ".name", "is missing, or not a text that names the camera");
  FileCamera camera;
  camera.name = name->get<std::string>();
  const auto k = numbersAt(listed, path, "K", 4, 4, "fx, fy, cx, cy");
  camera.coefficients = numbersAt(listed, path, "D", 4, 5, "k1, k2, p1, p2, k3");
  camera.lensPath = path + ".D";
  (void)numbersAt(listed, path, "size", 2, 2, "width, height");
  camera.calibration.intrinsics =
      checkedIntrinsics({{"fx", k[0]}, {"fy", k[1]}, {"cx", k[2]}, {"cy", k[3]}}, path + ".K");
  camera.calibration.res = checkedSize(listed["size"], path + ".size");
  return camera;
}

CameraFile readList(const CameraDocument& document, CameraUse /*use*/) {
  const Json& list = document.documents.front()["cameras"];
  if (!list.is_array() || list.empty())
    throw InputError("cameras", "is not a list of at least one camera");
  CameraFile file;
  for (std::size_t k = 0; k < std::min(list.size(), mostCameras); ++k)
    file.cameras.push_back(listedCamera(list[k], "cameras[" + std::to_string(k) + "]"));
  return file;
}

/// Others have lists of this name, too, whose matrices are of 3×3 numbers.
bool isList(const CameraDocument& document) {
  if (document.documents.empty() || !document.documents.front().is_object()) return false;
  const Json& object = document.documents.front();
  const auto found = object.find("cameras");
  if (found == object.end() || found->is_object()) return false;
  if (!found->is_array() || found->empty()) return true;
  const Json& first = found->front();
  const Json* const matrix = memberOf(first, {"k", "cameramatrix", "mtx", "intrinsicmatrix"});
  if (matrix == nullptr || !matrix->is_array() || matrix->empty())
    return matrix == nullptr || !matrix->is_object();
  const bool hasLens = memberOf(first, {"d", "dist", "distcoeffs", "distcoeff",
                                        "distortioncoefficients"}) != nullptr;
  constexpr std::size_t ofMatrix = 9;
  return !matrix->front().is_array() && (matrix->size() != ofMatrix || !hasLens);
}

}  // namespace

const CameraFormat listFormat{"list of cameras", isList, readList};

}  // namespace hogelscope
