// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/sheet_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/bisect.h"
#include "core/panel/depth_budget.h"

namespace hogelscope {

namespace {

/// The formulas' letters.
struct SheetLetters {
  explicit SheetLetters(const SheetDisplay& display)
      : sheet(display),
        p(sheet.period()),
        q(sheet.pixel()),
        g(sheet.gap()),
        m(1 / display.calibration.params.slope),
        w(display.emitter[0]),
        spot(display.spot),
        distance(display.viewingDistance) {}
  LensSheet sheet;
  double p, q, g, m, w, spot, distance;
};

double sinc(double x) {
  return x == 0 ? 1 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x);
}

/// A ray meets a lens u beside its middle, a pixel d beside the pixel's, and a row e beside the
/// row's, each even over the width of a lens, a pixel, a row; the sub-pixel's place is then w d +
/// m e from the ray's end across the lenses, and shows a view r of a view beside the ray's own.
/// What is seen on the plane z lies aside by
///     x:  u (1/(1 + m²))(1 − z/D) + u z/D  −  d (1 − z/D) + d w z/g  +  e m z/g  +  r z p/(N g)
///     y:  (u m/(1 + m²) + d (1 − w)/m − e)(1 − z/D)
double contrastOf(const SheetLetters& of, int views, double f, double z, std::size_t axis) {
  const double nearer = 1 - z / of.distance;
  const double square = 1 + of.m * of.m;
  if (axis == 1) {
    const double seen = f * nearer;
    return std::abs(sinc(seen * of.p * of.m / square) * sinc(seen * of.q * (1 - of.w) / of.m) *
                    sinc(seen * of.q));
  }
  double inSpot = of.sheet.spot().empty() ? 1 : 0;
  double place = -double(of.sheet.spot().size() / 2);
  for (const double weight : of.sheet.spot()) {
    inSpot += weight * std::cos(2 * std::numbers::pi * f * place * of.q * (nearer - z / of.g));
    ++place;
  }
  return std::abs(inSpot * sinc(f * of.p * (nearer / square + z / of.distance)) *
                  sinc(f * of.q * (nearer - of.w * z / of.g)) * sinc(f * of.q * of.m * z / of.g) *
                  sinc(f * z * of.p / (views * of.g)));
}

/// Returns the depth at which the gratings that an eye at `distance` sees as 1/(2p) on the panel
/// have sinc(1/2) of the contrast that they have there; in front (`side` 1) or behind (−1), ≥ 0.
double sharpDepth(const SheetLetters& of, int views, double distance, double spread, double side) {
  constexpr double left = 2 / std::numbers::pi;  // sinc(1/2)
  constexpr int steps = 200;
  const double frequency = 1 / (2 * of.p);
  const double onPanel = contrastOf(of, views, frequency, 0, 0);
  const auto isSharp = [&](double dioptres) {
    const double z = std::max(depthAt(side * dioptres, distance), -1e4 * distance);
    const double f = frequency * distance / (distance - z);
    return contrastOf(of, views, f, z, 0) > left * onPanel;
  };
  if (side < 0 && isSharp(1 / distance)) return std::numeric_limits<double>::infinity();
  const double step = of.p / (spread * distance * distance) / 10;
  double low = 0;
  double high = step;
  for (int k = 0; k < steps && isSharp(high); ++k) {
    low = high;
    high += step;
  }
  return side * depthAt(side * bisect({low, high}, 30, isSharp).inside, distance);
}

}  // namespace

double SheetNumbers::pseudoscopic(double ipd) const {
  return width() > 0 ? std::min(ipd / width(), 1.0) : 0;
}

SheetNumbers sheetNumbers(const SheetDisplay& display, int views, const Vec3& eye) {
  const SheetLetters of(display);
  SheetNumbers numbers;
  numbers.views = views;
  numbers.period = of.p;
  numbers.cone = display.calibration.params.cone;
  const double mixed = of.q * std::hypot(of.w, of.m) / std::sqrt(12);
  numbers.lobe = views / of.p * std::hypot(mixed, of.spot);
  numbers.viewSlope = of.p / (views * of.g);
  numbers.slopeSpread =
      std::hypot(numbers.viewSlope, std::sqrt(12) * std::hypot(mixed, of.spot) / of.g);
  if (!(eye.z > 0)) return numbers;
  numbers.distance = eye.z;
  numbers.viewsPerMetre = 1 / (numbers.viewSlope * eye.z);
  numbers.viewsPerPanelMetre = (1 / of.distance - 1 / eye.z) / numbers.viewSlope;
  const double half = eye.z * of.p / (2 * of.g);
  numbers.flips = {-half - of.m * eye.y, half - of.m * eye.y};
  numbers.depthFront = sharpDepth(of, views, eye.z, numbers.slopeSpread, 1);
  numbers.depthBehind = sharpDepth(of, views, eye.z, numbers.slopeSpread, -1);
  // |z| s D/(D − z) = p with the s of one view
  const double shift = numbers.viewSlope * eye.z;
  numbers.viewsFront = of.p * eye.z / (shift + of.p);
  numbers.viewsBehind =
      shift > of.p ? of.p * eye.z / (shift - of.p) : std::numeric_limits<double>::infinity();
  return numbers;
}

double sheetContrast(const SheetDisplay& display, int views, double frequency, double z,
                     std::size_t axis) {
  return contrastOf(SheetLetters(display), views, frequency, z, axis);
}

double shareOfSums(double low, double high, double a, double b) {
  const auto below = [a, b](double sum) {
    if (std::abs(sum) >= (a + b) / 2) return sum > 0 ? 1.0 : 0.0;
    const auto half = [](double x) { return x > 0 ? x * x / 2 : 0; };
    return (half(sum + (a + b) / 2) - half(sum + (a - b) / 2) - half(sum - (a - b) / 2) +
            half(sum - (a + b) / 2)) /
           (a * b);
  };
  return std::clamp(below(high) - below(low), 0.0, 1.0);
}

double lobeShare(const SheetDisplay& display, int views, double low, double high) {
  const SheetLetters of(display);
  const double perPixel = views * of.q / of.p;
  const auto shareOf = [&](double place) {
    return shareOfSums(low + place * perPixel, high + place * perPixel, perPixel * of.w,
                       perPixel * std::abs(of.m));
  };
  if (of.sheet.spot().empty()) return shareOf(0);
  double share = 0;
  double place = -double(of.sheet.spot().size() / 2);
  for (const double weight : of.sheet.spot()) share += weight * shareOf(place++);
  return share;
}

/// The places h across the lenses with |H/z + h (1/D − 1/z)| ≤ p/(2 g), the eye's own being H.
double shareInCone(const SheetDisplay& display, const Vec3& eye) {
  if (!(eye.z > 0)) return 0;
  const SheetLetters of(display);
  const double turn = 1 / of.distance - 1 / eye.z;
  const double at = (eye.x + of.m * eye.y) / eye.z;
  const double reach = of.p / (2 * of.g);
  if (std::abs(turn) < 1e-12) return std::abs(at) <= reach ? 1 : 0;
  const double middle = -at / turn;
  const double half = reach / std::abs(turn);
  const auto [width, height] = of.sheet.size();
  return shareOfSums(middle - half, middle + half, width, std::abs(of.m) * height);
}

}  // namespace hogelscope
