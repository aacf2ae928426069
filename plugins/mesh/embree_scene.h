// SPDX-License-Identifier: BSD-3-Clause
// Triangles in the display frame, and what rays meet of them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hogelscope/plugin.h"
#include "mesh.h"

namespace hogelscope::mesh {

/// The point where a ray first meets a triangle: the sum of its corners with these weights, which
/// are not negative and add up to 1.
struct Hit {
  static constexpr std::uint32_t none = UINT32_MAX;
  std::uint32_t triangle = none;
  std::array<double, 3> weights{};
  double z = 0;
};

/// All but building may be called from several threads.
class EmbreeScene {
 public:
  static constexpr std::size_t packet = 16;

  /// Takes x, y, z of each point in metres, and three points for each triangle. Throws
  /// std::runtime_error when there is not enough memory or the listener stops.
  EmbreeScene(std::vector<float> points, std::vector<Corners> triangles, int threads,
              const plugin::Progress& progress);

  /// Sets what each of up to 16 rays meets. To the last bit a hit depends on its ray alone, not on
  /// the others (README.md, Tracing).
  void intersect(std::span<const plugin::Ray> rays, std::span<Hit, packet> hits) const;

  /// True if a triangle lies between a point and the point `way` farther on; `way` may be a
  /// direction, for all of it.
  [[nodiscard]] bool isBlocked(const Vec3& from, const Vec3& way, bool isDirection) const;

  [[nodiscard]] Vec3 point(std::uint32_t index) const {
    const float* p = &m_points[std::size_t{3} * index];
    return {p[0], p[1], p[2]};
  }
  [[nodiscard]] const Corners& corners(std::uint32_t triangle) const {
    return m_triangles[triangle];
  }
  [[nodiscard]] const std::vector<Corners>& triangles() const { return m_triangles; }
  /// x, y, z of each point.
  [[nodiscard]] std::span<const float> points() const {
    return std::span(m_points).first(m_points.size() - 1);
  }
  /// The greatest |x|, |y| or |z| of a point.
  [[nodiscard]] double extent() const { return m_extent; }

 private:
  struct Lanes;
  struct Release {
    void operator()(void* scene) const;
  };

  void build(int threads, const plugin::Progress& progress);
  void traceAgain(std::span<const plugin::Ray> rays, Lanes& lanes) const;
  void gather(Lanes& lanes, std::size_t lane) const;

  std::vector<float> m_points;  ///< and one float more: Embree reads four at a time
  std::vector<Corners> m_triangles;
  double m_extent = 0;
  std::unique_ptr<void, Release> m_scene;
};

}  // namespace hogelscope::mesh
