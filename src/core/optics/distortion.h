// SPDX-License-Identifier: BSD-3-Clause
// Lens distortion: Brown–Conrady with OpenCV's five coefficients, and its inverse.
#pragma once

#include <cmath>
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

/// Norms of the model's derivatives over a region.
struct DerivativeBounds {
  double second = 0;
  double third = 0;
  double change =
      0;  ///< change of the second derivative from its value in the middle of the region
};

/// Maps points of the plane z = 1 of the camera frame. All lengths are in units of that plane.
class Distortion {
 public:
  explicit Distortion(const DistortionParams& params)
      : m_params(params), m_tangential(std::hypot(params.p1, params.p2)) {}

  [[nodiscard]] const DistortionParams& params() const { return m_params; }
  [[nodiscard]] bool isIdentity() const { return m_params == DistortionParams{}; }

  /// Maps ideal to distorted (docs/formulas.md, Distortion): returns where a lens images the point
  /// that a pinhole images at `ideal`.
  [[nodiscard]] Vec2 distort(const Vec2& ideal) const;
  [[nodiscard]] Jacobian jacobian(const Vec2& ideal) const;

  /// Returns the inverse on the branch that grows from the centre: it follows the preimage of the
  /// straight segment from the centre to `distorted` (followBranch). None if it meets a fold
  /// (det J = 0). The residual is a few units of rounding of `distorted`.
  [[nodiscard]] std::optional<Vec2> undistort(const Vec2& distorted) const;

  /// Bounds the derivatives over all ideal points that are at most `within` nearer to the centre or
  /// farther from it than `radius`.
  [[nodiscard]] DerivativeBounds derivativeBounds(double radius, double within) const;
  /// Returns a distance, at most `longest`, over which no eigenvalue of the Jacobian falls by
  /// `margin`, starting at a point at `radius` from the centre.
  [[nodiscard]] double safeStep(double radius, double margin, double longest) const;

 private:
  DistortionParams m_params;
  double m_tangential;  ///< |(p1, p2)|
};

}  // namespace hogelscope
