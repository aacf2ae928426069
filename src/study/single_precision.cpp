// SPDX-License-Identifier: BSD-3-Clause
// The geometry of docs/formulas.md in float or double, literally.
#include "study/single_precision.h"

#include <cmath>
#include <numbers>

namespace hogelscope {

namespace {

template <class Real>
struct Vector {
  Real x, y, z;
};

template <class Real>
Vector<Real> vector(const Vec3& v) {
  return {Real(v.x), Real(v.y), Real(v.z)};
}

template <class Real>
Vector<Real> minus(const Vector<Real>& a, const Vector<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class Real>
Vector<Real> unitCross(const Vector<Real>& a, const Vector<Real>& b) {
  const Vector<Real> c{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  const Real norm = std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z);
  return {c.x / norm, c.y / norm, c.z / norm};
}

/// Camera and panel in the display frame.
template <class Real>
struct Geometry {
  explicit Geometry(const RenderJob& job)
      : display(job.display),
        panel(job.display),
        eye(minus(vector<Real>(job.state.camera.eye), vector<Real>(job.display.position))) {
    const auto toward =
        minus(vector<Real>(job.state.camera.lookat), vector<Real>(job.state.camera.eye));
    right = unitCross(toward, vector<Real>(job.state.camera.up));
    down = unitCross(toward, right);
    forward = unitCross(right, down);
  }

  /// Returns the directional pixel that a ray meets (docs/formulas.md, Hit); x, y on the plane z =
  /// 1.
  [[nodiscard]] std::optional<TexelIndex> hit(Real x, Real y) const {
    const Real dz = x * right.z + y * down.z + forward.z;
    if (!(eye.z > 0 && dz < 0)) return std::nullopt;
    const Real a = (x * right.x + y * down.x + forward.x) / dz;
    const Real b = (x * right.y + y * down.y + forward.y) / dz;
    const auto [w, h] = display.size;
    const auto [nx, ny] = display.hogels;
    const auto [du, dv] = display.directions;
    const Real i = ((eye.x - eye.z * a) / Real(w) + Real(0.5)) * Real(nx);
    const Real j = (Real(0.5) - (eye.y - eye.z * b) / Real(h)) * Real(ny);
    const Real k = display.viewingDistance > 0 ? 1 / Real(display.viewingDistance) : 0;
    const Real u = Real(du) * (Real(0.5) + part(a + k * (eye.x - eye.z * a), 0));
    const Real v = Real(dv) * (Real(0.5) - part(b + k * (eye.y - eye.z * b), 1));
    const auto isIn = [](Real at, int count) { return at >= 0 && at < Real(count); };
    if (!(isIn(i, nx) && isIn(j, ny) && isIn(u, du) && isIn(v, dv))) return std::nullopt;
    return TexelIndex{int(i), int(j), int(u), int(v)};
  }

  /// Returns the position in the angular field from its middle, -1/2 … 1/2.
  [[nodiscard]] Real part(Real slope, std::size_t axis) const {
    if (display.lens == HogelLensModel::plugin)
      return Real(panel.lens(axis).directionOf(double(slope)));
    const Real field = Real(display.fov[axis]) * (std::numbers::pi_v<Real> / 180);
    if (display.lens == HogelLensModel::equiangular) return std::atan(slope) / field;
    return slope / (2 * std::tan(field / 2));
  }

  PanelParams display;
  Display panel;  ///< for a plugin's lens, which exists in one precision only
  Vector<Real> eye, right{}, down{}, forward{};
};

}  // namespace

template <class Real>
Image pictureIn(const RenderJob& job) {
  const Geometry<Real> geometry(job);
  const auto [width, height] = job.state.camera.res;
  const Real fov = Real(job.state.camera.fov) * (std::numbers::pi_v<Real> / 180);
  const Real focal = Real(height) / 2 / std::tan(fov / 2);
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto at = geometry.hit((Real(x) - Real(width - 1) / 2) / focal,
                                   (Real(y) - Real(height - 1) / 2) / focal);
      if (!at) continue;
      const std::size_t pixel = std::size_t(y) * std::size_t(width) + std::size_t(x);
      const Rgb c = job.lightField->texel(*at);
      image.seen[pixel] = 255;
      image.rgb[3 * pixel] = quantised(c.r);
      image.rgb[3 * pixel + 1] = quantised(c.g);
      image.rgb[3 * pixel + 2] = quantised(c.b);
    }
  }
  return image;
}

template Image pictureIn<float>(const RenderJob& job);
template Image pictureIn<double>(const RenderJob& job);

}  // namespace hogelscope
