// SPDX-License-Identifier: BSD-3-Clause
// An independent simulator for tests, written from docs/formulas.md only and sharing no arithmetic
// with core.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "core/optics/simulate.h"
#include "tests/core/lens_oracle.h"

namespace brute {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;  ///< rows

constexpr double degree = 3.14159265358979323846 / 180;

inline Vector vector(const hogelscope::Vec3& v) {
  return {v.x, v.y, v.z};
}

inline Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Vector crossProduct(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Vector unit(const Vector& a) {
  const double n = std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
  return {a[0] / n, a[1] / n, a[2] / n};
}

inline Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      for (std::size_t k = 0; k < 3; ++k) c[row][column] += a[row][k] * b[k][column];
  return c;
}

inline Vector times(const Matrix& m, const Vector& v) {
  Vector r{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t k = 0; k < 3; ++k) r[row] += m[row][k] * v[k];
  return r;
}

inline Matrix transposed(const Matrix& m) {
  Matrix t{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) t[row][column] = m[column][row];
  return t;
}

/// Returns worldFromDisplay, Rz·Rx·Ry.
inline Matrix rotation(const hogelscope::Vec3& degrees) {
  const auto c = [](double angle) { return std::cos(angle * degree); };
  const auto s = [](double angle) { return std::sin(angle * degree); };
  const auto [x, y, z] = degrees;
  const Matrix rx{{{1, 0, 0}, {0, c(x), -s(x)}, {0, s(x), c(x)}}};
  const Matrix ry{{{c(y), 0, s(y)}, {0, 1, 0}, {-s(y), 0, c(y)}}};
  const Matrix rz{{{c(z), -s(z), 0}, {s(z), c(z), 0}, {0, 0, 1}}};
  return product(rz, product(rx, ry));
}

/// The display's content in code values, texel by texel in the hogel image's raster.
struct Content {
  hogelscope::LightFieldSize size;
  std::vector<double> codes;

  [[nodiscard]] const double* texel(int i, int j, int u, int v) const {
    return &codes[3 * std::size_t((j * size.dv + v) * size.nx * size.du + i * size.du + u)];
  }
};

/// A point of a lens that focuses at the distance `focus`: `right` and `down` of the eye, metres.
struct LensPoint {
  double right = 0;
  double down = 0;
  double focus = 1;
};

/// The result of a ray; `unclear` if rounding decides.
struct Ray {
  enum class Meets { nothing, display, unclear } meets;
  std::array<double, 4> hit{};  ///< i, j, u, v
};

class Simulator {
 public:
  /// `margin` is the distance from a border within which rounding may decide, in cells along i, j,
  /// u, v.
  Simulator(const hogelscope::RenderJob& job, const Content& content,
            const std::array<double, 4>& margin = {1e-4, 1e-4, 1e-4, 1e-4})
      : m_job(job),
        m_content(content),
        m_margin(margin),
        m_displayFromWorld(transposed(rotation(job.display.orientation))) {
    const auto& camera = job.state.camera;
    m_forward = unit(minus(vector(camera.lookat), vector(camera.eye)));
    m_right = unit(crossProduct(m_forward, vector(camera.up)));
    m_down = crossProduct(m_forward, m_right);
  }

  [[nodiscard]] Ray ray(double px, double py, const LensPoint& from = {}) const {
    const auto& [width, height] = m_job.state.camera.res;
    double fx = height / 2.0 / std::tan(m_job.state.camera.fov * degree / 2);
    double fy = fx;
    double cx = (width - 1) / 2.0;
    double cy = (height - 1) / 2.0;
    const auto& given = m_job.state.intrinsics;
    if (given.fx > 0) {
      fx = given.fx;
      fy = given.fy > 0 ? given.fy : fx;
      cx = given.cx > -1e7 ? given.cx : cx;
      cy = given.cy > -1e7 ? given.cy : cy;
    }
    const LensOracle::Point q((px - cx) / fx, (py - cy) / fy);
    const auto [k1, k2, p1, p2, k3, k4, k5, k6, model] = m_job.state.distortion;
    if (model == hogelscope::DistortionModel::fisheye) {
      const FisheyeOracle lens(k1, k2, k3, k4);
      if (m_job.sampling.mapping == hogelscope::LensMapping::direct)
        return along(lens.distort(q), from);
      const LensOracle::Walk walk = lens.walk(q);
      if (walk.end == LensOracle::Walk::End::unclear) return {Ray::Meets::unclear};
      if (walk.end == LensOracle::Walk::End::fold) return {Ray::Meets::nothing};
      return along(walk.point, from);
    }
    const LensOracle lens(k1, k2, p1, p2, k3, k4, k5, k6);
    if (m_job.sampling.mapping == hogelscope::LensMapping::direct)
      return along(lens.distort(q), from);
    const LensOracle::Walk walk = lens.walk(q, 0.05, 0.05);
    if (walk.end == LensOracle::Walk::End::unclear) return {Ray::Meets::unclear};
    if (walk.end == LensOracle::Walk::End::fold) return {Ray::Meets::nothing};
    return along(lens.refined(walk.point, q), from);
  }

  /// Whether one of a pixel's rays is so near to a border, or to a fold, that rounding decides.
  [[nodiscard]] bool isUnclear(int x, int y, const LensPoint& from = {}) const {
    const int n = m_job.sampling.samplesPerPixel;
    for (int s = 0; s < n * n; ++s)
      if (ray(x + (s % n + 0.5) / n - 0.5, y + (s / n + 0.5) / n - 0.5, from).meets ==
          Ray::Meets::unclear)
        return true;
    return false;
  }

  /// Returns P'(u, v) of a directional pixel, in the light that is summed.
  [[nodiscard]] Vector leaked(int i, int j, int u, int v) const {
    const auto& psf = m_job.state.psf;
    const int n = psf.windowSize / 2;
    Vector sum{};
    double weights = 0;
    for (int y = -n; y <= n; ++y) {
      for (int x = -n; x <= n; ++x) {
        const double w = n == 0 ? 1 : std::exp(-(x * x + y * y) / (2 * psf.sigma * psf.sigma));
        const bool inU = 0 <= u + x && u + x <= m_content.size.du - 1;
        const bool inV = 0 <= v + y && v + y <= m_content.size.dv - 1;
        const bool inside = inU && inV;
        if (inside || psf.border != hogelscope::PsfBorder::renormalise) weights += w;
        if (!inside && psf.border != hogelscope::PsfBorder::clamp) continue;
        const double* tap =
            m_content.texel(i, j, std::min(std::max(u + x, 0), m_content.size.du - 1),
                            std::min(std::max(v + y, 0), m_content.size.dv - 1));
        for (std::size_t c = 0; c < 3; ++c) sum[c] += w * decoded(tap[c]);
      }
    }
    for (double& channel : sum) channel /= weights;
    return sum;
  }

  /// Converts summed light to code values.
  [[nodiscard]] double encoded(double light) const {
    if (m_job.state.psf.light == hogelscope::LightModel::encoded) return light;
    return 255 * (light > 0.0031308 ? 1.055 * std::pow(light, 1 / 2.4) - 0.055 : 12.92 * light);
  }

 private:
  [[nodiscard]] double decoded(double code) const {
    if (m_job.state.psf.light == hogelscope::LightModel::encoded) return code;
    return code / 255 > 0.04045 ? std::pow((code / 255 + 0.055) / 1.055, 2.4) : code / 255 / 12.92;
  }

  /// Returns the position, 0 … 1, in the angular field for light of `slope` that leaves the panel
  /// at `place`. With a viewing distance, the field is that of the centre's rays to the points of a
  /// second plane.
  [[nodiscard]] double acrossField(double slope, double place, double fov) const {
    if (const double distance = m_job.display.viewingDistance; distance > 0)
      slope = (place + distance * slope) / distance;
    if (m_job.display.lens == hogelscope::HogelLensModel::equiangular)
      return 0.5 + std::atan(slope) / (fov * degree);
    return 0.5 + slope / (2 * std::tan(fov * degree / 2));
  }

  /// Returns the ray from a point of the lens to where the ray from its middle through (x, y, 1) of
  /// the camera frame meets the plane in focus.
  [[nodiscard]] Ray along(LensOracle::Point p, const LensPoint& from) const {
    Vector start{};
    Vector way{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double offset = from.right * m_right[k] + from.down * m_down[k];
      const double sharp =
          from.focus * (p.real() * m_right[k] + p.imag() * m_down[k] + m_forward[k]);
      start[k] = vector(m_job.state.camera.eye)[k] + offset;
      way[k] = (sharp - offset) / from.focus;
    }
    const auto& display = m_job.display;
    const Vector d = times(m_displayFromWorld, way);
    const Vector o = times(m_displayFromWorld, minus(start, vector(display.position)));
    if (o[2] <= 0 || d[2] >= 1e-9) return {Ray::Meets::nothing};
    if (d[2] > -1e-9) return {Ray::Meets::unclear};
    const double t = -o[2] / d[2];
    const double x = o[0] + t * d[0];
    const double y = o[1] + t * d[1];
    return met({(x + display.size[0] / 2) / display.size[0] * m_content.size.nx,
                (display.size[1] / 2 - y) / display.size[1] * m_content.size.ny,
                acrossField(d[0] / d[2], x, display.fov[0]) * m_content.size.du,
                acrossField(-d[1] / d[2], -y, display.fov[1]) * m_content.size.dv});
  }

  [[nodiscard]] Ray met(const std::array<double, 4>& hit) const {
    const auto& [nx, ny, du, dv] = m_content.size;
    const std::array<int, 4> counts{nx, ny, du, dv};
    bool clear = true;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const double margin = m_margin[axis];
      if (hit[axis] < -margin || hit[axis] > counts[axis] + margin) return {Ray::Meets::nothing};
      clear = clear && std::abs(hit[axis] - std::round(hit[axis])) > margin;
    }
    return {clear ? Ray::Meets::display : Ray::Meets::unclear, hit};
  }

  const hogelscope::RenderJob& m_job;
  const Content& m_content;
  std::array<double, 4> m_margin;
  Matrix m_displayFromWorld;
  Vector m_forward{}, m_right{}, m_down{};
};

}  // namespace brute
