// SPDX-License-Identifier: BSD-3-Clause
#include "gltf_motion.h"

namespace hogelscope::mesh {

void place(const Part& part, const std::vector<Skin>& skins, const std::vector<Affine>& frames,
           Posture& posture) {
  const auto& [node, skin, binding, points, normals] = part;
  const bool isBound = binding.each > 0;
  const std::vector<Affine> joints =
      isBound ? jointFrames(skins[skin], frames) : std::vector<Affine>();
  if (!normals.values.empty()) posture.normals.resize(posture.points.size());
  for (std::size_t k = 0; k < points.rows(); ++k) {
    const Affine frame = isBound ? frameOf(binding, k, joints) : frames[node];
    const float* p = &points.values[k * points.components];
    posture.points.push_back(frame.point({p[0], p[1], p[2]}));
    if (normals.values.empty()) continue;
    const float* n = &normals.values[k * normals.components];
    const Vec3 turned = normalise(frame.normal({n[0], n[1], n[2]}));
    posture.normals.push_back({float(turned.x), float(turned.y), float(turned.z)});
  }
  if (!posture.normals.empty()) posture.normals.resize(posture.points.size());
}

void place(const Lamp& lamp, const std::vector<Affine>& frames, Posture& posture) {
  Light light = lamp.light;
  light.position = frames[lamp.node].origin;
  light.direction = normalise(frames[lamp.node].direction({0, 0, -1}));
  posture.lights.push_back(light);
}

Posture GltfMotion::at(double seconds) const {
  std::vector<NodePose> poses = m_nodes.rest();
  m_animation.apply(seconds, poses);
  const std::vector<Affine> frames = m_nodes.frames(poses);
  Posture posture;
  for (const Part& part : m_parts.parts) place(part, m_parts.skins, frames, posture);
  for (const Lamp& lamp : m_parts.lamps) place(lamp, frames, posture);
  return posture;
}

}  // namespace hogelscope::mesh
