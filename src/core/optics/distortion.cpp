// SPDX-License-Identifier: BSD-3-Clause
// Lens distortion: the models, their derivatives and bounds of these.
#include "core/optics/distortion.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/base/polynomial.h"
#include "core/optics/lens_branch.h"

namespace hogelscope {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

constexpr std::array<std::string_view, 3> modelNames{"brown", "rational", "fisheye"};

using P = DistortionParams;
/// Those of Brown–Conrady, which the rational model begins with, then those of the latter alone.
constexpr std::array<LensCoefficient, 8> brownAndRational{{{"k1", &P::k1},
                                                           {"k2", &P::k2},
                                                           {"p1", &P::p1},
                                                           {"p2", &P::p2},
                                                           {"k3", &P::k3},
                                                           {"k4", &P::k4},
                                                           {"k5", &P::k5},
                                                           {"k6", &P::k6}}};
constexpr std::array<LensCoefficient, 4> ofFisheye{
    {{"k1", &P::k1}, {"k2", &P::k2}, {"k3", &P::k3}, {"k4", &P::k4}}};
constexpr std::array<LensCoefficient, 4> besideFisheye{
    {{"p1", &P::p1}, {"p2", &P::p2}, {"k5", &P::k5}, {"k6", &P::k6}}};

/// What the models differ in, but for their formulas: a row for each.
struct ModelRow {
  std::span<const LensCoefficient> own;
  std::span<const LensCoefficient> others;
  double mostSize;  ///< of a coefficient
};

const ModelRow& rowOf(DistortionModel model) {
  static const std::span all(brownAndRational);
  static const std::array<ModelRow, 3> rows{
      {{all.first(5), all.subspan(5), 10}, {all, {}, 1000}, {ofFisheye, besideFisheye, 1000}}};
  return rows[std::size_t(model)];
}

bool hasNone(const DistortionParams& p, std::span<const LensCoefficient> coefficients) {
  return std::ranges::all_of(coefficients,
                             [&p](const LensCoefficient& k) { return p.*k.value == 0; });
}

}  // namespace

std::span<const std::string_view> distortionModelNames() {
  return modelNames;
}

std::span<const LensCoefficient> coefficientsOf(DistortionModel model) {
  return rowOf(model).own;
}

std::span<const LensCoefficient> coefficientsBeside(DistortionModel model) {
  return rowOf(model).others;
}

std::vector<double> vectorOf(const DistortionParams& p) {
  std::vector<double> values;
  for (const LensCoefficient& k : coefficientsOf(p.model)) values.push_back(p.*k.value);
  return values;
}

bool DistortionParams::isPinhole() const {
  return model != DistortionModel::fisheye && hasNone(*this, brownAndRational);
}

void describe(ParameterVisitor& v, DistortionParams& p) {
  auto& [k1, k2, p1, p2, k3, k4, k5, k6, model] = p;
  v.group("distortion", "Lens distortion of the camera, by OpenCV's models and coefficients.");
  v.field("model", model, distortionModelNames(),
          "Brown-Conrady (k1, k2, p1, p2, k3), OpenCV's rational model (also k4, k5, k6), or "
          "fisheye (cv::fisheye, ROS equidistant: k1 to k4 of the ray's angle).");
  const double most = rowOf(model).mostSize;
  const auto coefficient = [&](const char* name, double& value, double usual, const char* help) {
    const auto isIt = [name](const LensCoefficient& k) { return name == std::string_view(k.name); };
    v.count(std::ranges::any_of(coefficientsOf(p.model), isIt));
    v.field(name, value, {-most, most, 0.001, false, -usual, usual}, "", help);
  };
  coefficient("k1", k1, 1, "Radial, r²: below 0 barrel, above 0 pincushion.");
  coefficient("k2", k2, 1, "Radial, r⁴.");
  coefficient("p1", p1, 0.2, "Tangential, vertical.");
  coefficient("p2", p2, 0.2, "Tangential, horizontal.");
  coefficient("k3", k3, 1, "Radial, r⁶.");
  coefficient("k4", k4, 1, "Rational: radial, r² of the divisor; fisheye: θ⁸ of the angle θ.");
  coefficient("k5", k5, 1, "Rational: radial, r⁴ of the divisor.");
  coefficient("k6", k6, 1, "Rational: radial, r⁶ of the divisor.");
  v.count(true);
}

DistortionParams ofItsModel(DistortionParams p) {
  const double most = rowOf(p.model).mostSize;
  for (const LensCoefficient& k : coefficientsBeside(p.model)) p.*k.value = 0;
  for (const LensCoefficient& k : coefficientsOf(p.model))
    p.*k.value = std::clamp(p.*k.value, -most, most);
  return p;
}

void check(const DistortionParams& p) {
  for (const LensCoefficient& k : coefficientsBeside(p.model))
    if (p.*k.value != 0)
      throw InputError(k.name, "is of another model: distortion.model is \"" +
                                   std::string(modelNames[std::size_t(p.model)]) + "\"");
}

Distortion::Distortion(const DistortionParams& params)
    : m_params(params), m_tangential(std::hypot(params.p1, params.p2)) {
  const auto& [k1, k2, p1, p2, k3, k4, k5, k6, model] = params;
  if (model == DistortionModel::fisheye) {
    m_fisheye.emplace(std::array{k1, k2, k3, k4});
  } else if (k4 != 0 || k5 != 0 || k6 != 0) {
    m_fraction = {{k1, k2, k3}, {k4, k5, k6}};
    const std::vector<double> poles = signChanges({1, k4, k5, k6}, 1e12);
    if (!poles.empty()) m_pole = std::sqrt(poles.front());
  }
}

namespace {

/// Returns the factor of a fisheye's image: that by which the point (r, 0) moves, and its slope.
std::pair<double, double> fisheyeFactors(const Fisheye& lens, double r) {
  if (r == 0) return {1, 1};
  const double angle = std::atan(r);
  return {lens.distorted(angle) / r, lens.slope(angle) / (1 + r * r)};
}

}  // namespace

Vec2 Distortion::distort(const Vec2& p) const {
  const auto& [k1, k2, p1, p2, k3, k4, k5, k6, model] = m_params;
  const auto [x, y] = p;
  if (m_fisheye) {
    const double factor = fisheyeFactors(*m_fisheye, std::hypot(x, y)).first;
    return {x * factor, y * factor};
  }
  const double r2 = x * x + y * y;
  double radial = 1 + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2;
  if (m_fraction) radial /= 1 + k4 * r2 + k5 * r2 * r2 + k6 * r2 * r2 * r2;
  return {x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
          y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y};
}

Jacobian Distortion::jacobian(const Vec2& p) const {
  const auto& [k1, k2, p1, p2, k3, k4, k5, k6, model] = m_params;
  const auto [x, y] = p;
  const double r2 = x * x + y * y;
  if (m_fisheye) {
    const auto [across, along] = fisheyeFactors(*m_fisheye, std::sqrt(r2));
    const double more = r2 > 0 ? (along - across) / r2 : 0;
    return {across + more * x * x, more * x * y, more * x * y, across + more * y * y};
  }
  double radial = 1 + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2;
  double slope = 2 * k1 + 4 * k2 * r2 + 6 * k3 * r2 * r2;  // d radial / dr, over r
  if (m_fraction) {
    const auto g = m_fraction->series(r2);
    radial = g[0];
    slope = 2 * g[1];
  }
  const double mixed = slope * x * y + 2 * p1 * x + 2 * p2 * y;
  return {radial + slope * x * x + 2 * p1 * y + 6 * p2 * x, mixed, mixed,
          radial + slope * y * y + 6 * p1 * y + 2 * p2 * x};
}

RadialBends Distortion::bends(double radius) const {
  const double r2 = radius * radius;
  if (m_fraction) {
    const auto g = m_fraction->series(r2);
    return {2 * g[1], 8 * g[2], 48 * g[3]};
  }
  const auto& [k1, k2, k3] = std::tie(m_params.k1, m_params.k2, m_params.k3);
  return {2 * k1 + r2 * (4 * k2 + r2 * 6 * k3), 8 * k2 + r2 * 24 * k3, 48 * k3};
}

RadialTerms Distortion::radial(double r) const {
  const double s = r * r;
  if (m_fraction) {
    const auto g = m_fraction->series(s);
    return {r * g[0], g[0] + 2 * s * g[1], g[0], r * (6 * g[1] + s * 4 * 2 * g[2]), 2 * r * g[1]};
  }
  const auto& [k1, k2, k3] = std::tie(m_params.k1, m_params.k2, m_params.k3);
  const double across = 1 + s * (k1 + s * (k2 + s * k3));
  return {r * across, 1 + s * (3 * k1 + s * (5 * k2 + s * 7 * k3)), across,
          r * (6 * k1 + s * (20 * k2 + s * 42 * k3)), r * (2 * k1 + s * (4 * k2 + s * 6 * k3))};
}

RadialBounds Distortion::radialBounds(double from, double step) const {
  const auto& [k1, k2, k3] = std::tie(m_params.k1, m_params.k2, m_params.k3);
  const double r = from + step;
  const double s = r * r;
  const double above = 1 + s * (3 * std::abs(k1) + s * (5 * std::abs(k2) + s * 7 * std::abs(k3)));
  const double tangential = 6 * r * m_tangential;
  if (m_fraction) {
    const Enclosure ring(from * from, s);
    const double divisor = m_fraction->leastDivisor(ring);
    if (!(divisor > 0)) return {unbounded, unbounded, unbounded};
    const auto g = m_fraction->series(ring);
    const auto [k4, k5, k6] = m_fraction->below;
    const double below =
        (1 + s * (3 * std::abs(k4) + s * (5 * std::abs(k5) + s * 7 * std::abs(k6)))) / divisor;
    const Enclosure bend = 6 * g[1] + 48 * ring * (g[2] + ring * g[3]);
    return {1e-14 * ((above / divisor + below * g[0].size()) * (1 + below) + tangential),
            bend.size(), (2 * g[1] + 8 * ring * g[2]).size()};
  }
  const double bend = std::abs(6 * k1 + from * from * (60 * k2 + from * from * 210 * k3)) +
                      step * r * (120 * std::abs(k2) + 840 * std::abs(k3) * s);
  return {1e-14 * (above + tangential), bend,
          2 * std::abs(k1) + s * (12 * std::abs(k2) + s * 30 * std::abs(k3))};
}

double Distortion::fifthDerivative(double radius, double within) const {
  const double largest = radius + within;
  const double s = largest * largest;
  if (!m_fraction)
    return largest *
           (120 * std::abs(m_params.k2) + 840 * std::abs(m_params.k3) * largest * largest);
  const double least = std::max(0.0, radius - within);
  const Enclosure ring(least * least, s);
  if (!(m_fraction->leastDivisor(ring) > 0)) return unbounded;
  const auto g = m_fraction->series(ring);
  return largest * (15 * 8 * g[2].size() + s * (10 * 48 * g[3].size() + s * 384 * g[4].size()));
}

/// With P = (p2, p1) and h' the radial factor as a function of r²/2, the model is the gradient of
/// h + r² P·x. Along a unit vector at an angle of cosine c to the radius the third, fourth and
/// fifth derivatives of that are h''' r³ c³ + 3 h'' r c and at most 6 |P|; h'''' r⁴ c⁴ + 6 h''' r²
/// c² + 3 h''; h''''' r⁵ c⁵ + 10 h'''' r³ c³ + 15 h''' r c. These are also the derivatives' norms,
/// as they are symmetric.
DerivativeBounds Distortion::derivativeBounds(double radius, double within) const {
  const auto [h2, h3, h4] = bends(radius);
  const double r2 = radius * radius;
  const double fourth = fifthDerivative(radius, within);
  const double third = std::max({std::abs(3 * h2), std::abs(3 * h2 + 6 * h3 * r2),
                                 std::abs(3 * h2 + r2 * (6 * h3 + r2 * h4))});
  const double second =
      radius * std::max(std::abs(3 * h2), std::abs(3 * h2 + h3 * r2)) + 6 * m_tangential;
  const double change = within * (third + within / 2 * fourth);
  return {second + change, third + within * fourth, change};
}

double Distortion::safeStep(double radius, double margin, double longest) const {
  const DerivativeBounds here = derivativeBounds(radius, 0);
  const double guess =
      std::min({margin / here.second, std::sqrt(std::max(0.0, margin) / here.third), longest});
  double step = margin / derivativeBounds(radius, guess).second;
  // Bounds over a ring with a divisor are poor if it is wide.
  for (double ring = guess / 2; m_fraction && step < ring / 2 && ring > guess / 1e4; ring /= 2)
    step = std::max(step, std::min(ring, margin / derivativeBounds(radius, ring).second));
  return std::min(guess, step);
}

std::optional<Vec2> Distortion::undistort(const Vec2& distorted) const {
  if (isIdentity()) return distorted;
  if (m_fisheye) {
    const double distance = std::hypot(distorted.x, distorted.y);
    const double angle = m_fisheye->angle(distance);
    if (std::isnan(angle)) return std::nullopt;
    const double factor = distance > 0 ? std::tan(angle) / distance : 1;
    return Vec2{distorted.x * factor, distorted.y * factor};
  }
  if (!(std::hypot(distorted.x, distorted.y) <= farthest)) return std::nullopt;
  const Branch branch = followBranch(*this, {distorted, 0}, {});
  if (branch.kind != Branch::Kind::ray) return std::nullopt;
  return branch.ideal;
}

}  // namespace hogelscope
