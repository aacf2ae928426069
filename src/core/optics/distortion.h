// SPDX-License-Identifier: BSD-3-Clause
// Lens distortion: Brown–Conrady with OpenCV's five coefficients, and its inverse.
#pragma once

#include <optional>

#include "core/base/geometry.h"
#include "core/base/parameters.h"

namespace hogelscope {

/// A state's `distortion`. A vector of them is always in OpenCV's order k1, k2, p1, p2, k3.
struct DistortionParams {
  double k1 = 0;
  double k2 = 0;
  double p1 = 0;
  double p2 = 0;
  double k3 = 0;
  bool operator==(const DistortionParams&) const = default;
};

void describe(ParameterVisitor& v, DistortionParams& p);

/// Rows of the 2×2 Jacobian of the model.
struct Jacobian {
  double xx = 1;
  double xy = 0;
  double yx = 0;
  double yy = 1;
};

/// Maps points of the plane z = 1 of the camera frame. All lengths are in units of that plane.
class Distortion {
 public:
  explicit Distortion(const DistortionParams& params) : m_params(params) {}

  [[nodiscard]] const DistortionParams& params() const { return m_params; }
  [[nodiscard]] bool isIdentity() const { return m_params == DistortionParams{}; }

  /// Maps ideal to distorted (docs/formulas.md, Distortion): returns where a lens images the point
  /// that a pinhole images at `ideal`.
  [[nodiscard]] Vec2 distort(const Vec2& ideal) const;
  [[nodiscard]] Jacobian jacobian(const Vec2& ideal) const;

  /// Returns the inverse on the branch that grows from the centre: it follows the preimage of the
  /// straight segment from the centre to `distorted`. None if it meets a fold (det J = 0). The
  /// residual is a few units of rounding of `distorted`.
  [[nodiscard]] std::optional<Vec2> undistort(const Vec2& distorted) const;

  /// Returns a bound of the second derivative over all ideal points within `radius` of the centre.
  [[nodiscard]] double secondDerivativeBound(double radius) const;

 private:
  [[nodiscard]] Vec2 polish(Vec2 ideal, const Vec2& distorted) const;

  DistortionParams m_params;
};

}  // namespace hogelscope
