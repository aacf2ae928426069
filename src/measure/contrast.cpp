// SPDX-License-Identifier: BSD-3-Clause
#include "measure/contrast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace hogelscope {

namespace {

constexpr double pi = std::numbers::pi;

double sinc(double x) {
  return x == 0 ? 1 : std::sin(pi * x) / (pi * x);
}

/// The sums of a least-squares fit of a constant, a cosine and a sine.
class HarmonicFit {
 public:
  void add(double phase, double value) {
    const std::array<double, 3> basis{1, std::cos(phase), std::sin(phase)};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) m_normal[i][k] += basis[i] * basis[k];
      m_right[i] += basis[i] * value;
    }
  }

  /// Returns cosine − i sine of the least squares, by Cramer's rule.
  [[nodiscard]] std::complex<double> harmonic() const {
    const auto determinant = [](const std::array<std::array<double, 3>, 3>& m) {
      return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    const auto solved = [&](std::size_t column) {
      auto replaced = m_normal;
      for (std::size_t i = 0; i < 3; ++i) replaced[i][column] = m_right[i];
      return determinant(replaced) / determinant(m_normal);
    };
    return {solved(1), -solved(2)};
  }

 private:
  std::array<std::array<double, 3>, 3> m_normal{};
  std::array<double, 3> m_right{};
};

}  // namespace

double contrast(Bench& bench, const Grating& grating, std::size_t axis) {
  // No whole number of points lies on a hogel, so that they are even over its phases.
  const double pitch = bench.pitch(axis);
  const double spacing = (std::numbers::phi - 1.48) * pitch;
  const double panel = bench.display().size[axis];
  const int count = std::clamp(int(panel / spacing), 1, 4096);
  const double half = std::min(panel, count * spacing) / 2;
  const int reach = bench.psf().windowSize / 2;
  const double directions = bench.display().directions[axis];
  const double range = directions > 1 ? bench.distance() * bench.step(axis) : pitch;
  // The second of two gratings, a quarter of a period aside in another channel, takes away what
  // hogels sample as the mirrored frequency.
  constexpr std::array shifts{0.0, pi / 2};
  const TestLight light = [&, axis](const plugin::Ray& ray) {
    const Vec2 point = pointOf(ray, grating.z);
    const double angle = 2 * pi * grating.frequency * (axis == 0 ? point.x : point.y);
    return CodeValues{bench.codeOf(std::cos(angle - shifts[0])),
                      bench.codeOf(std::cos(angle - shifts[1])), 0};
  };
  const auto harmonicsOf = [&](const Vec3& eye) {
    const double place = axis == 0 ? eye.x : eye.y;
    const std::vector<BenchPoint> points = bench.look(light, eye, axis, -half, half, count);
    std::complex<double> sum;
    for (std::size_t k = 0; k < shifts.size(); ++k) {
      HarmonicFit whole, inner;
      int inside = 0;
      for (const BenchPoint& point : points) {
        const double atDepth = point.place + (place - point.place) * grating.z / bench.distance();
        const double angle = 2 * pi * grating.frequency * atDepth - shifts[k];
        whole.add(angle, bench.waveOf(point.values[k]));
        if (point.direction < reach || point.direction >= directions - reach) continue;
        inner.add(angle, bench.waveOf(point.values[k]));  // with all of the leakage
        ++inside;
      }
      sum += (inside > 2 ? inner : whole).harmonic();
    }
    return sum;
  };
  const int phases = std::clamp(8192 / count, 8, 32);  // more for small panels
  std::complex<double> sum;
  for (int phase = 0; phase < phases; ++phase) {
    Vec3 eye = bench.eye();
    (axis == 0 ? eye.x : eye.y) += ((phase + 0.5) / phases - 0.5) * range;
    sum += harmonicsOf(eye);
  }
  return std::abs(sum) / (2 * phases);
}

double contrastLaw(const Bench& bench, const Grating& grating, std::size_t axis) {
  const auto [frequency, z] = grating;
  const bool hasDirections = bench.display().directions[axis] > 1;
  const double shift = hasDirections ? frequency * bench.step(axis) * z : 0;
  const std::vector<double> weights = bench.weights();
  const int reach = int(weights.size()) / 2;
  double leaked = 0;
  for (int k = -reach; k <= reach; ++k)
    leaked += weights[std::size_t(k + reach)] * std::cos(2 * pi * shift * k);
  const double distance = bench.distance();
  const PupilParams& pupil = bench.pupil();
  const double focus = pupil.focus > 0 ? pupil.focus : distance;
  // The light of one direction converges from hogel to hogel, so that their pitch shrinks on its
  // way.
  const double viewing = bench.display().viewingDistance;
  const double pitch = bench.pitch(axis) * (viewing == notGiven ? 1 : 1 - z / viewing);
  const double v = pi * frequency * pupil.diameter * std::abs(1 - (distance - z) / focus);
  const double blurred = v > 1e-9 ? 2 * std::cyl_bessel_j(1.0, v) / v : 1;
  return std::abs(sinc(frequency * pitch) * sinc(shift) * leaked * blurred);
}

double depthOfFall(const std::function<double(double depth)>& fall, double level, double first) {
  constexpr int steps = 200;
  constexpr int halvings = 40;
  double low = 0;
  double high = 0;
  for (int step = 1; step <= steps; ++step) {
    high = 0.1 * step * first;
    if (fall(high) <= level) break;
    if (step == steps) return std::numeric_limits<double>::infinity();
    low = high;
  }
  for (int k = 0; k < halvings && high - low > 1e-7 * high; ++k) {
    const double middle = (low + high) / 2;
    (fall(middle) <= level ? high : low) = middle;
  }
  return (low + high) / 2;
}

}  // namespace hogelscope
