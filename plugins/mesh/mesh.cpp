// SPDX-License-Identifier: BSD-3-Clause
#include "mesh.h"

namespace hogelscope::mesh {

Vec3 Affine::normal(const Vec3& n) const {
  // The cofactors: the inverse's transpose times the determinant, whose sign is irrelevant here.
  return n.x * cross(axes[1], axes[2]) + n.y * cross(axes[2], axes[0]) +
         n.z * cross(axes[0], axes[1]);
}

Affine Affine::operator*(const Affine& b) const {
  return {{direction(b.axes[0]), direction(b.axes[1]), direction(b.axes[2])}, point(b.origin)};
}

void Mesh::fillAttributes() {
  if (!normals.empty()) normals.resize(points.size());
  if (!colours.empty()) colours.resize(points.size(), Linear{1, 1, 1});
  if (!uv.empty()) uv.resize(points.size());
}

}  // namespace hogelscope::mesh
