// SPDX-License-Identifier: BSD-3-Clause
// The cameras of glTF documents; the writer is io/documents/gltf_cameras.h.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_formats.h"

namespace hogelscope {

namespace {

bool isGltf(const CameraDocument& document) {
  if (document.documents.size() != 1 || !document.documents.front().is_object()) return false;
  const Json& object = document.documents.front();
  return object.contains("asset") && object.contains("cameras") && object["cameras"].is_array() &&
         !object["cameras"].empty();
}

std::vector<double> nodeNumbers(const Json& node, const std::string& path, const char* key,
                                std::size_t count, std::vector<double> otherwise) {
  const auto found = node.find(key);
  if (found == node.end()) return otherwise;
  std::vector<double> numbers = matrixNumbers(*found, path + key);
  if (numbers.size() != count)
    throw InputError(path + key, "is not of " + std::to_string(count) + " numbers");
  return numbers;
}

/// The nodes of a document, whose scales multiply along the way to the root.
class GltfNodes {
 public:
  explicit GltfNodes(const Json& object) {
    const auto found = object.find("nodes");
    if (found != object.end() && found->is_array()) m_nodes = &*found;
    m_parents.assign(count(), none);
    for (std::size_t k = 0; k < count(); ++k) {
      if (!(*m_nodes)[k].is_object()) throw InputError(pathOf(k), "is not an object");
      const auto children = (*m_nodes)[k].find("children");
      if (children == (*m_nodes)[k].end() || !children->is_array()) continue;
      for (const Json& child : *children)
        if (child.is_number_unsigned() && child.get<std::size_t>() < count())
          m_parents[child.get<std::size_t>()] = k;
    }
  }

  [[nodiscard]] std::size_t count() const { return m_nodes == nullptr ? 0 : m_nodes->size(); }
  [[nodiscard]] const Json& operator[](std::size_t k) const { return (*m_nodes)[k]; }

  /// Returns a node's pose in the world. Scales move the nodes below, but turn no camera.
  [[nodiscard]] RigidTransform worldFromNode(std::size_t k) const {
    std::vector<std::size_t> way;
    for (std::size_t at = k; at != none; at = m_parents[at]) {
      if (way.size() == deepest)
        throw InputError(pathOf(k), "has more than 1000 nodes above it, or is above itself");
      way.push_back(at);
    }
    RigidTransform world;
    double scale = 1;
    for (auto at = way.rbegin(); at != way.rend(); ++at) {
      const auto [own, ownScale] = ownTransform(*at);
      world = world * RigidTransform{own.xAxis, own.yAxis, own.zAxis, scale * own.origin};
      scale *= ownScale;
    }
    return world;
  }

 private:
  static constexpr std::size_t none = std::size_t(-1);
  static constexpr std::size_t deepest = 1000;

  static std::string pathOf(std::size_t k) { return "nodes[" + std::to_string(k) + "]."; }

  /// Returns a node's own transform, without its scale, and the scale.
  [[nodiscard]] std::pair<RigidTransform, double> ownTransform(std::size_t k) const {
    const Json& node = (*m_nodes)[k];
    const std::string path = pathOf(k);
    if (node.contains("matrix")) {
      const auto m = nodeNumbers(node, path, "matrix", 16, {});
      const double scale = std::hypot(m[0], m[1], m[2]);
      if (!(scale > 0)) throw InputError(path + "matrix", "has no axes");
      const auto at = [&](std::size_t column, std::size_t row) {
        return m[4 * column + row] / scale;
      };
      return {transformOf({at(0, 0), at(1, 0), at(2, 0), m[12], at(0, 1), at(1, 1), at(2, 1), m[13],
                           at(0, 2), at(1, 2), at(2, 2), m[14]},
                          path + "matrix"),
              scale};
    }
    const auto t = nodeNumbers(node, path, "translation", 3, {0, 0, 0});
    const auto q = nodeNumbers(node, path, "rotation", 4, {0, 0, 0, 1});
    const auto s = nodeNumbers(node, path, "scale", 3, {1, 1, 1});
    if (!(s[0] > 0) || s[0] != s[1] || s[0] != s[2])
      throw InputError(path + "scale", "is not one number above 0 for all axes");
    RigidTransform own = rotationOf(q[3], q[0], q[1], q[2], path + "rotation");
    own.origin = {t[0], t[1], t[2]};
    return {own, s[0]};
  }

  const Json* m_nodes = nullptr;
  std::vector<std::size_t> m_parents;
};

/// Returns the intrinsics that this program's own files have in `extras`; none in others.
bool takeExtras(const Json& object, const std::string& path, Calibration& calibration) {
  const auto extras = object.find("extras");
  if (extras == object.end() || !extras->is_object() || !extras->contains("fx") ||
      !extras->contains("res"))
    return false;
  Json values = Json::object();
  for (const char* key : {"fx", "fy", "cx", "cy"})
    if (extras->contains(key)) values[key] = (*extras)[key];
  calibration.intrinsics = checkedIntrinsics(values, path + "extras");
  calibration.res = checkedSize((*extras)["res"], path + "extras");
  return true;
}

FileCamera gltfCamera(const Json& object, const std::string& path) {
  FileCamera camera;
  camera.modelKey = path + "type";
  if (!object.is_object()) throw InputError(path, "is not an object");
  camera.model = object.value("type", Json()) == "perspective" ? "" : textOf(object, {"type"});
  camera.name = textOf(object, {"name"});
  const auto found = object.find("perspective");
  if (!camera.model.empty() || takeExtras(object, path, camera.calibration)) return camera;
  if (found == object.end() || !found->is_object())
    throw InputError(path + "perspective", "is missing");
  const double angle = numberIn(*found, path + "perspective.", "yfov", notGiven);
  const double aspect = numberIn(*found, path + "perspective.", "aspectRatio", notGiven);
  if (!(angle > 0 && angle < std::numbers::pi))
    throw InputError(path + "perspective.yfov", "is not an angle between 0 and π");
  constexpr double degrees = 180 / std::numbers::pi;
  camera.calibration.fov[1] = angle * degrees;
  if (aspect != notGiven && !(aspect > 1e-3 && aspect < 1e3))
    throw InputError(path + "perspective.aspectRatio", "is not a ratio of width and height");
  if (aspect != notGiven)
    camera.calibration.fov[0] = 2 * std::atan(aspect * std::tan(angle / 2)) * degrees;
  return camera;
}

CameraFile readGltf(const CameraDocument& document, CameraUse /*use*/) {
  const Json& object = document.documents.front();
  const Json& cameras = object["cameras"];
  const GltfNodes nodes(object);
  CameraFile file;
  const auto add = [&](std::size_t index) -> FileCamera& {
    const std::string path = "cameras[" + std::to_string(index) + "].";
    if (index >= cameras.size()) throw InputError(path, "is not there, but a node names it");
    file.cameras.push_back(gltfCamera(cameras[index], path));
    FileCamera& camera = file.cameras.back();
    if (camera.name.empty()) camera.name = "camera " + std::to_string(index);
    return camera;
  };
  for (std::size_t k = 0; k < nodes.count() && file.cameras.size() < mostCameras; ++k) {
    const auto index = nodes[k].find("camera");
    if (index == nodes[k].end() || !index->is_number_unsigned()) continue;
    FileCamera& camera = add(index->get<std::size_t>());
    camera.pose = fromOpenGl(nodes.worldFromNode(k));
    if (const std::string name = textOf(nodes[k], {"name"}); !name.empty()) camera.name = name;
  }
  if (file.cameras.empty())
    for (std::size_t k = 0; k < std::min(cameras.size(), mostCameras); ++k) (void)add(k);
  return file;
}

}  // namespace

const CameraFormat gltfFormat{"glTF", isGltf, readGltf};

}  // namespace hogelscope
