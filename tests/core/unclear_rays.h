// SPDX-License-Identifier: BSD-3-Clause
// Whether rounding decides what a pixel's rays meet, of any display: cells change with a tiny
// change of the ray.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/optics/simulate.h"
#include "core/panel/twin.h"

class UnclearRays {
 public:
  explicit UnclearRays(const hogelscope::RenderJob& job)
      : m_job(job),
        m_display(job.display, job.twin),
        m_camera(job.state.camera, job.state.intrinsics),
        m_distortion(job.state.distortion) {
    for (const auto& point : apertureOf(job.state.pupil, job.state.camera, job.display).points)
      m_from.push_back(m_display.displayFromWorld() * fromPoint(m_camera.worldFromCamera(), point));
    if (job.twin) m_fill = job.twin->params().light.fill;
  }

  [[nodiscard]] bool isUnclear(int x, int y) const {
    for (const auto& sample : hogelscope::samplesOf(m_job.sampling.samplesPerPixel)) {
      const auto onSensor = m_camera.normalised(x + sample.place.x - 0.5, y + sample.place.y - 0.5);
      const auto ideal = idealPoint(m_distortion, m_job.sampling.mapping, onSensor);
      if (!ideal) continue;
      for (const auto& from : m_from)
        for (std::size_t channel = 0; channel < 3; ++channel)
          if (isUnclear(from, *ideal, channel)) return true;
    }
    return false;
  }

 private:
  /// Cells, and whether the place in them gives light; none if the display is not met.
  using Met = std::optional<std::array<double, 6>>;

  [[nodiscard]] bool isUnclear(const hogelscope::RigidTransform& from,
                               const hogelscope::Vec2& ideal, std::size_t channel) const {
    constexpr double tiny = 1e-8;
    const Met own = met(from.origin, from.direction({ideal.x, ideal.y, 1}), channel);
    const double far = 1 + std::hypot(ideal.x, ideal.y);
    const auto& size = m_job.display.size;
    const double place = tiny * (std::min(std::max(size[0], size[1]), 1.0) + hypot(from.origin) +
                                 hypot(m_job.display.position));
    for (int k = 0; k < 16; ++k) {
      const auto sign = [k](int bit) { return (k >> bit & 1) != 0 ? 1.0 : -1.0; };
      const hogelscope::Vec3 eye{from.origin.x + sign(0) * place, from.origin.y + sign(1) * place,
                                 from.origin.z};
      const auto direction =
          from.direction({ideal.x + sign(2) * tiny * far, ideal.y + sign(3) * tiny * far, 1});
      if (met(eye, direction, channel) != own) return true;
    }
    return false;
  }

  static double hypot(const hogelscope::Vec3& v) { return std::hypot(v.x, v.y, v.z); }

  [[nodiscard]] Met met(const hogelscope::Vec3& eye, const hogelscope::Vec3& direction,
                        std::size_t channel) const {
    const auto hit = m_display.hit(eye, direction, channel);
    if (!hit) return std::nullopt;
    const auto gives = [](double index, double part) {
      return 2 * std::abs(index - std::floor(index) - 0.5) <= part ? 1.0 : 0.0;
    };
    return std::array{std::floor(hit->i), std::floor(hit->j),       std::floor(hit->u),
                      std::floor(hit->v), gives(hit->u, m_fill[0]), gives(hit->v, m_fill[1])};
  }

  const hogelscope::RenderJob& m_job;
  hogelscope::Display m_display;
  hogelscope::Camera m_camera;
  hogelscope::Distortion m_distortion;
  std::vector<hogelscope::RigidTransform> m_from;
  std::array<double, 2> m_fill{1, 1};
};
