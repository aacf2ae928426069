// SPDX-License-Identifier: BSD-3-Clause
// Lens distortion by OpenCV's models, and its inverse: Brown–Conrady with five coefficients, the
// rational one with eight, and cv::fisheye's with four.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parameters.h"
#include "core/optics/fisheye.h"
#include "core/optics/radial_series.h"

namespace hogelscope {

enum class DistortionModel { brown, rational, fisheye };

/// Returns their names in documents.
std::span<const std::string_view> distortionModelNames();

/// A state's `distortion`, in OpenCV's order. Coefficients that a model does not have are 0.
struct DistortionParams {
  double k1 = 0;
  double k2 = 0;
  double p1 = 0;
  double p2 = 0;
  double k3 = 0;
  double k4 = 0;
  double k5 = 0;
  double k6 = 0;
  DistortionModel model = DistortionModel::brown;

  /// Whether a pinhole images alike. A fisheye without coefficients does not.
  [[nodiscard]] bool isPinhole() const;
  bool operator==(const DistortionParams&) const = default;
};

struct LensCoefficient {
  const char* name;
  double DistortionParams::*value;
};

/// Returns the coefficients of a model, in the order of OpenCV's vectors.
std::span<const LensCoefficient> coefficientsOf(DistortionModel model);
/// Returns those that other models have.
std::span<const LensCoefficient> coefficientsBeside(DistortionModel model);

/// Returns the values of coefficientsOf(), the vector that OpenCV's functions take.
std::vector<double> vectorOf(const DistortionParams& p);

void describe(ParameterVisitor& v, DistortionParams& p);

/// Returns the lens as its model can have it: without the others' coefficients, and the rest within
/// the model's range.
DistortionParams ofItsModel(DistortionParams p);

/// Throws InputError for a coefficient that is not 0 and that the model does not have.
void check(const DistortionParams& p);

/// Visits what a document has: the model's own coefficients, and its name unless it is "brown".
template <class Visitor>
void describeParts(Visitor& v, DistortionParams& p) {
  v.fields(p);
  if (p.model == DistortionModel::brown) v.leaveOut("model");
  for (const LensCoefficient& k : coefficientsBeside(p.model)) v.leaveOut(k.name);
  v.verify([&p] { check(p); });
}

/// Rows of the 2×2 Jacobian of the model, which is symmetric.
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

/// The radial part f(r) of a model at a radius.
struct RadialTerms {
  double value = 0;         ///< f
  double slope = 1;         ///< f'
  double across = 1;        ///< f / r
  double slopeChange = 0;   ///< f''
  double acrossChange = 0;  ///< (f / r)'
};

/// Bounds over a ring.
struct RadialBounds {
  double rounding = 0;    ///< the error of f' and f / r by rounding
  double slopeBend = 0;   ///< |f'''|
  double acrossBend = 0;  ///< |(f / r)''|
};

/// Derivatives of the radial factor f / r = h' as a function of r²/2.
struct RadialBends {
  double h2 = 0;
  double h3 = 0;
  double h4 = 0;
};

/// Maps points of the plane z = 1 of the camera frame. All lengths are in units of that plane.
/// The functions from bends() on are for models with a Cartesian inverse: not for fisheyes, whose
/// inverse is that of one number.
class Distortion {
 public:
  explicit Distortion(const DistortionParams& params);

  [[nodiscard]] const DistortionParams& params() const { return m_params; }
  [[nodiscard]] bool isIdentity() const { return m_params.isPinhole(); }
  /// Whether the lens is the same in all directions.
  [[nodiscard]] bool isRound() const { return m_params.p1 == 0 && m_params.p2 == 0; }
  /// The lens if it is a fisheye, otherwise null.
  [[nodiscard]] const Fisheye* fisheye() const { return m_fisheye ? &*m_fisheye : nullptr; }

  /// Returns the radius of the first pole of the radial factor, within 1e6; infinite if there is
  /// none. There is no ray from it on.
  [[nodiscard]] double pole() const { return m_pole; }
  /// Returns the radius to which safeStep() leads in few steps: 100, beyond any image but those of
  /// nearly 180°, or shortly before a pole, where steps get ever shorter.
  [[nodiscard]] double marchEnd() const { return std::min(100.0, 0.99 * m_pole); }

  /// Maps ideal to distorted (docs/formulas.md, Distortion): returns where a lens images the point
  /// that a pinhole images at `ideal`.
  [[nodiscard]] Vec2 distort(const Vec2& ideal) const;
  [[nodiscard]] Jacobian jacobian(const Vec2& ideal) const;

  /// The distance from the axis, in focal lengths, beyond which no point has a ray: near a pole of
  /// a rational lens a walk takes as many steps as the root of the distance says.
  static constexpr double farthest = 1e4;

  /// Returns the inverse on the branch that grows from the centre: it follows the preimage of the
  /// straight segment from the centre to `distorted` (followBranch). None if it meets a fold
  /// (det J = 0), beyond `farthest` or, of a fisheye, if the ray is at 90° to the axis or more. The
  /// residual is a few units of rounding of `distorted`.
  [[nodiscard]] std::optional<Vec2> undistort(const Vec2& distorted) const;

  [[nodiscard]] RadialBends bends(double radius) const;
  [[nodiscard]] RadialTerms radial(double radius) const;
  /// Bounds over the ring of width `step` that begins at the radius `from`. Infinite or NaN if it
  /// may contain a pole.
  [[nodiscard]] RadialBounds radialBounds(double from, double step) const;
  /// Bounds the derivatives over all ideal points that are at most `within` nearer to the centre or
  /// farther from it than `radius`.
  [[nodiscard]] DerivativeBounds derivativeBounds(double radius, double within) const;
  /// Returns a distance, at most `longest`, over which no eigenvalue of the Jacobian falls by
  /// `margin`, starting at a point at `radius` from the centre.
  [[nodiscard]] double safeStep(double radius, double margin, double longest) const;

 private:
  /// Bounds the norm of the fifth derivative of the model's potential over a ring.
  [[nodiscard]] double fifthDerivative(double radius, double within) const;

  DistortionParams m_params;
  double m_tangential;                       ///< |(p1, p2)|
  std::optional<RadialFraction> m_fraction;  ///< of a lens with k4, k5 or k6
  double m_pole = std::numeric_limits<double>::infinity();
  std::optional<Fisheye> m_fisheye;
};

}  // namespace hogelscope
