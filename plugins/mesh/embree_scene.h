// SPDX-License-Identifier: BSD-3-Clause
// Triangles in the display frame, and what rays meet of them.
#pragma once

#include <algorithm>
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

/// What the rays of one packet meet.
struct Hits {
  static constexpr std::size_t most = 16;
  template <class T>
  using Row = std::array<T, most>;

  Row<std::uint32_t> triangles;  ///< Hit::none where a ray meets nothing
  Row<std::uint32_t> materials;  ///< of the triangles
};

/// All but building may be called from several threads.
class EmbreeScene {
 public:
  /// Takes x, y, z of each point in metres, three points and a material's number for each triangle.
  /// Throws std::runtime_error when there is not enough memory or the listener stops.
  EmbreeScene(std::vector<float> points, std::vector<Corners> triangles,
              const std::vector<std::uint32_t>& materials, int threads,
              const plugin::Progress& progress);

  /// Calls `take` with the hits of each packet of rays and the number of its first ray. To the last
  /// bit a hit depends on its ray alone, not on the others (README.md, Tracing).
  template <class Take>
  void trace(std::span<const plugin::Ray> rays, const Take& take) const {
    Packet packets[2];
    Hits hits;
    const auto packetAt = [&](std::size_t first) {
      return rays.subspan(first, std::min(Hits::most, rays.size() - first));
    };
    // A packet's triangles come from memory while the next one is on its way.
    for (std::size_t first = 0, n = 0; first < rays.size() + Hits::most; first += Hits::most, ++n) {
      if (first < rays.size()) meet(packetAt(first), packets[n % 2]);
      if (first == 0) continue;
      settle(packetAt(first - Hits::most), packets[(n + 1) % 2], hits);
      take(hits, first - Hits::most);
    }
  }

  /// Where a ray meets a triangle that it does meet, in double precision.
  [[nodiscard]] Hit hit(const plugin::Ray& ray, std::uint32_t triangle) const;

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
  /// What the rays of a packet meet in Embree's opinion.
  struct Packet {
    Hits::Row<std::uint32_t> triangles;
    /// A triangle whose longest side is shorter than this is passed farther from its edges than
    /// rounding goes.
    Hits::Row<float> certain;
    std::uint32_t ties = 0;  ///< a bit for each ray that met two triangles at one depth
  };
  struct Traits {
    float longestSide;
    std::uint32_t material;
  };
  struct Release {
    void operator()(void* scene) const;
  };

  void build(int threads, const plugin::Progress& progress);
  void meet(std::span<const plugin::Ray> rays, Packet& packet) const;
  void settle(std::span<const plugin::Ray> rays, const Packet& packet, Hits& hits) const;
  [[nodiscard]] std::uint32_t meetAlone(const plugin::Ray& ray) const;

  std::vector<float> m_points;  ///< and one float more: Embree reads four at a time
  std::vector<Corners> m_triangles;
  std::vector<Traits> m_traits;
  double m_extent = 0;
  std::unique_ptr<void, Release> m_scene;
};

}  // namespace hogelscope::mesh
