// SPDX-License-Identifier: BSD-3-Clause
// Triangles in the display frame, and their intersections with rays.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hogelscope/plugin.h"
#include "mesh.h"

namespace hogelscope::mesh {

/// The first intersection of a ray with a triangle: the sum of the triangle's corners with these
/// weights, which are not negative and sum to 1.
struct Hit {
  static constexpr std::uint32_t none = UINT32_MAX;
  std::uint32_t triangle = none;
  std::array<double, 3> weights{};
  double z = 0;
};

/// The hits of the rays of a packet.
struct Hits {
  static constexpr std::size_t most = 16;
  template <class T>
  using Row = std::array<T, most>;

  Row<std::uint32_t> triangles;  ///< Hit::none for a ray that meets nothing
  Row<std::uint32_t> materials;  ///< of the triangles
};

/// A scene of triangles. After construction all functions may be called from several threads.
class EmbreeScene {
 public:
  /// Takes x, y, z of each point in metres, three points and a material index for each triangle.
  /// Throws std::runtime_error if memory is insufficient or the listener cancels.
  EmbreeScene(std::vector<float> points, std::vector<Corners> triangles,
              const std::vector<std::uint32_t>& materials, int threads,
              const plugin::Progress& progress);

  /// Calls `take` with the hits of each packet of rays and the index of its first ray. A hit
  /// depends on its ray only, bit for bit, not on the others (README.md, Tracing).
  template <class Take>
  void trace(std::span<const plugin::Ray> rays, const Take& take) const {
    Packet packets[2];
    Hits hits;
    const auto packetAt = [&](std::size_t first) {
      return rays.subspan(first, std::min(Hits::most, rays.size() - first));
    };
    // A packet's triangles are prefetched while the next one is traced.
    for (std::size_t first = 0, n = 0; first < rays.size() + Hits::most; first += Hits::most, ++n) {
      if (first < rays.size()) meet(packetAt(first), packets[n % 2]);
      if (first == 0) continue;
      settle(packetAt(first - Hits::most), packets[(n + 1) % 2], hits);
      take(hits, first - Hits::most);
    }
  }

  /// Returns the intersection of a ray with a triangle that it meets, in double precision.
  [[nodiscard]] Hit hit(const plugin::Ray& ray, std::uint32_t triangle) const;

  /// Whether a triangle lies between a point and the point `way` farther on; with `isDirection`,
  /// along the whole direction.
  [[nodiscard]] bool isBlocked(const Vec3& from, const Vec3& way, bool isDirection) const;

  [[nodiscard]] Vec3 point(std::uint32_t index) const {
    const float* p = &m_points[std::size_t{3} * index];
    return {p[0], p[1], p[2]};
  }
  [[nodiscard]] const Corners& corners(std::uint32_t triangle) const {
    return m_triangles[triangle];
  }
  [[nodiscard]] const std::vector<Corners>& triangles() const { return m_triangles; }
  /// Returns x, y, z of each point.
  [[nodiscard]] std::span<const float> points() const {
    return std::span(m_points).first(m_points.size() - 1);
  }
  /// Returns the largest |x|, |y| or |z| of a point.
  [[nodiscard]] double extent() const { return m_extent; }

 private:
  /// Embree's hits of the rays of a packet.
  struct Packet {
    Hits::Row<std::uint32_t> triangles;
    /// The longest side up to which a triangle's edges are farther from the ray than rounding
    /// errors.
    Hits::Row<float> certain;
    std::uint32_t ties = 0;  ///< a bit for each ray with two triangles at one depth
  };
  struct Traits {
    float longestSide;
    std::uint32_t material;
  };
  struct DeviceRelease {
    void operator()(void* device) const;
  };
  struct SceneRelease {
    void operator()(void* scene) const;
  };

  void build(int threads, const plugin::Progress& progress);
  void meet(std::span<const plugin::Ray> rays, Packet& packet) const;
  void settle(std::span<const plugin::Ray> rays, const Packet& packet, Hits& hits) const;
  [[nodiscard]] std::uint32_t meetAlone(const plugin::Ray& ray) const;

  std::vector<float> m_points;  ///< with an additional float, because Embree reads four at a time
  std::vector<Corners> m_triangles;
  std::vector<Traits> m_traits;
  double m_extent = 0;
  std::unique_ptr<void, DeviceRelease> m_device;
  std::unique_ptr<void, SceneRelease> m_scene;  ///< destroyed first: since 4.4 it uses the device
};

}  // namespace hogelscope::mesh
