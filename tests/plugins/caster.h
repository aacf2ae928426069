// SPDX-License-Identifier: BSD-3-Clause
// The oracle of the mesh plugin's tracing: all triangles against all rays, in double precision.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "hogelscope/plugin.h"
#include "tests/plugins/mesh_scene.h"

namespace hogelscope::test {

struct Met {
  std::size_t triangle = 0;
  double z = 0;
  double gap = 0;  ///< the distance to the next triangle behind it
};

/// Returns Möller and Trumbore's intersection of a ray with one triangle.
inline std::optional<Met> meet(const plugin::Triangles& mesh, std::size_t triangle,
                               const plugin::Ray& ray) {
  const auto corner = [&](std::size_t k) {
    const float* p = &mesh.points[3 * std::size_t(mesh.corners[3 * triangle + k])];
    return Vec3{p[0], p[1], p[2]};
  };
  const Vec3 origin{ray.x, ray.y, ray.z};
  const Vec3 way{-ray.a, -ray.b, -1};
  const Vec3 e1 = corner(1) - corner(0);
  const Vec3 e2 = corner(2) - corner(0);
  const Vec3 p = cross(way, e2);
  const double determinant = dot(e1, p);
  if (determinant == 0) return std::nullopt;
  const Vec3 s = origin - corner(0);
  const double u = dot(s, p) / determinant;
  const double v = dot(way, cross(s, e1)) / determinant;
  const double t = dot(e2, cross(s, e1)) / determinant;
  if (u < 0 || v < 0 || u + v > 1 || t < 0 || t > ray.reach) return std::nullopt;
  return Met{triangle, ray.z - t, 0};
}

/// Returns the first hit of the ray.
inline std::optional<Met> cast(const plugin::Triangles& mesh, const plugin::Ray& ray) {
  std::optional<Met> first;
  double second = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < mesh.corners.size() / 3; ++k) {
    const auto met = meet(mesh, k, ray);
    if (!met) continue;
    const bool isFirst = !first || met->z > first->z;
    second = std::max(second, !isFirst ? met->z : first ? first->z : second);
    if (isFirst) first = met;
  }
  if (first) first->gap = first->z - second;
  return first;
}

/// Whether the ray, moved by a distance, would meet another triangle, which can then happen in
/// single precision.
inline bool passesEdge(const plugin::Triangles& mesh, const plugin::Ray& ray, double distance) {
  const auto moved = [&](double dx, double dy) {
    plugin::Ray other = ray;
    other.x += dx;
    other.y += dy;
    const auto met = cast(mesh, other);
    return met ? double(met->triangle) : -1;
  };
  const double here = moved(0, 0);
  return moved(distance, 0) != here || moved(-distance, 0) != here || moved(0, distance) != here ||
         moved(0, -distance) != here;
}

}  // namespace hogelscope::test
