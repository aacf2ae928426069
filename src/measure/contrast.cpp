// SPDX-License-Identifier: BSD-3-Clause
#include "measure/contrast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "core/base/bisect.h"

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

/// Where the eye's ray through a point of a lens sheet ends on the pixels, and where it crosses the
/// cameras' plane across the lenses.
struct SheetRay {
  Vec2 end;
  double crossing;
};

SheetRay sheetRay(const Bench& bench, const Vec3& eye, const Vec2& point) {
  const SheetDisplay& display = *bench.display().sheet;
  const double a = (eye.x - point.x) / eye.z;
  const double b = (eye.y - point.y) / eye.z;
  const double perSlope = 1 / display.calibration.params.slope;
  const double gap = bench.sheet()->gap();
  return {{point.x - gap * a, point.y - gap * b},
          point.x + point.y * perSlope + display.viewingDistance * (a + b * perSlope)};
}

/// Returns the mean over a line of what an eye sees of a grating, as a complex wave, less the
/// phases that `phaseAt` expects of a ray; with `count` the points of it that are in the cone.
template <class PhaseAt>
std::complex<double> meanWave(Bench& bench, const Grating& grating, std::size_t axis,
                              const Vec3& eye, double across, const PhaseAt& phaseAt) {
  constexpr std::size_t green = 1;
  constexpr int most = 1024;
  const double pitch = bench.pitch(0);
  const double panel = bench.display().size[axis];
  const int count = std::clamp(int(panel / (std::numbers::phi - 1.48) / pitch), 1, most);
  const double distance = bench.display().sheet->viewingDistance;
  // All that a place shows is of the cone's own views.
  const double reach = distance * (pitch / (2 * bench.sheet()->gap()) - bench.step(0));
  std::complex<double> sum;
  double seen = 0;
  for (const std::complex<double> turn : {std::complex(1.0, 0.0), std::complex(0.0, 1.0)}) {
    const TestLight light = [&](const plugin::Ray& ray) {
      const Vec2 point = pointOf(ray, grating.z);
      const double angle = 2 * pi * grating.frequency * (axis == 0 ? point.x : point.y);
      return grey(bench.codeOf(turn.imag() == 0 ? std::cos(angle) : std::sin(angle)));
    };
    for (const BenchPoint& one :
         bench.look(light, eye, axis, -panel / 2, panel / 2, count, across)) {
      const SheetRay ray =
          sheetRay(bench, eye, axis == 0 ? Vec2{one.place, across} : Vec2{across, one.place});
      if (std::abs(ray.crossing) > reach) continue;
      sum += turn * bench.waveOf(one.values[green]) * std::polar(1.0, -phaseAt(ray));
      seen += 0.5;
    }
  }
  return seen == 0 ? std::numeric_limits<double>::quiet_NaN() : sum / seen;
}

/// The contrast that a lens sheet leaves.
double sheetContrastSeen(Bench& bench, const Grating& grating, std::size_t axis) {
  const double part = grating.z / bench.display().sheet->viewingDistance;
  const auto phaseAt = [&](const SheetRay& ray) {
    const double place =
        axis == 0 ? ray.end.x * (1 - part) + ray.crossing * part : ray.end.y * (1 - part);
    return 2 * pi * grating.frequency * place;
  };
  constexpr int lines = 8;
  const double viewsPerMetre = bench.numbersOfSheet().viewsPerMetre;
  std::complex<double> sum;
  for (int line = 0; line < lines; ++line) {
    const double share = (line + 0.5) / lines - 0.5;
    Vec3 eye = bench.eye();
    eye.x += share / viewsPerMetre;
    // On as many places of the panel, in no step with lenses and pixels.
    const double across = share * 0.61 * bench.display().size[1 - axis];
    sum += meanWave(bench, grating, axis, eye, across, phaseAt);
  }
  return std::abs(sum) / lines;
}

/// The place on a grating's plane that the eye sees: perPlace · the ray's place on the panel +
/// perEye · the eye's place, but for a constant; perLens · its place in the lens is added by
/// hogels.
struct SeenPlace {
  double perPlace;
  double perEye;
  double perLens;
};

/// Of one colour of a unit; of a design 1 − z/D, z/D and −(1 − z/V).
SeenPlace seenPlace(const Bench& bench, double z, std::size_t axis, std::size_t channel) {
  const UnitLaw& law = bench.law();
  const double distance = bench.distance();
  const double pitchError = law.pitchError[axis] / (1 + law.pitchError[axis]);
  const double perShift = bench.step(axis) * bench.display().directions[axis] / bench.pitch(axis);
  const double viewing = bench.display().viewingDistance;
  const double turn = viewing == notGiven ? 0 : z / viewing;
  const double perEye = law.scale[channel] * z / distance;
  const double ofTile = (1 - pitchError) * (1 - turn);
  return {ofTile - perEye + law.scale[channel] * turn - z * perShift * pitchError, perEye,
          z * perShift * (law.defocus + pitchError) - ofTile};
}

/// The share of the contrast that a pupil leaves.
double pupilLaw(const Bench& bench, const Grating& grating, const SeenPlace& seen) {
  const double distance = bench.distance();
  const PupilParams& pupil = bench.pupil();
  const double focus = pupil.focus > 0 ? pupil.focus : distance;
  const double v = pi * grating.frequency * pupil.diameter *
                   std::abs(seen.perPlace * (1 - distance / focus) + seen.perEye);
  return v > 1e-9 ? 2 * std::cyl_bessel_j(1.0, v) / v : 1;
}

/// The contrast that hogels leave.
double hogelContrastSeen(Bench& bench, const Grating& grating, std::size_t axis) {
  // No whole number of points lies on a hogel, so that they are even over its phases.
  const double pitch = bench.pitch(axis);
  const double spacing = (std::numbers::phi - 1.48) * pitch;
  const double panel = bench.display().size[axis];
  const int count = std::clamp(int(panel / spacing), 1, 4096);
  const double half = std::min(panel, count * spacing) / 2;
  const int reach = bench.psf().windowSize / 2;
  const double directions = bench.display().directions[axis];
  const double range = directions > 1
                           ? bench.distance() * bench.step(axis) / bench.law().scale[greenChannel]
                           : pitch;
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
      const SeenPlace seen = seenPlace(bench, grating.z, axis, k);
      HarmonicFit whole, inner;
      int inside = 0;
      for (const BenchPoint& point : points) {
        const double atDepth = seen.perPlace * point.place + seen.perEye * place;
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

}  // namespace

double contrast(Bench& bench, const Grating& grating, std::size_t axis) {
  return bench.sheet() != nullptr ? sheetContrastSeen(bench, grating, axis)
                                  : hogelContrastSeen(bench, grating, axis);
}

double shiftOfViews(Bench& bench, double z) {
  const double views = bench.display().directions[0];
  const double distance = bench.distance();
  const double view = 1 / bench.numbersOfSheet().viewsPerMetre;
  // Its period on the panel is several times what a sharp picture shifts by.
  const double frequency = 1 / (8 * bench.pitch(0));
  const Grating grating{frequency * distance / (distance - z), z};
  constexpr int lines = 8;
  std::array<std::complex<double>, 2> waves;
  const double middle = views / 2 - std::floor(views / 2);  // of two neighbours about the cone's
  for (const double side : {-0.5, 0.5})
    for (int line = 0; line < lines; ++line) {
      const double across = ((line + 0.5) / lines - 0.5) * 0.1 * bench.display().size[1];
      const Vec3 eye{(side + middle) * view, 0, distance};
      waves[side > 0 ? 1 : 0] += meanWave(bench, grating, 0, eye, across, [&](const SheetRay& ray) {
        return 2 * pi * frequency * ray.end.x;
      });
    }
  return -std::arg(waves[1] / waves[0]) / (2 * pi * frequency);
}

double contrastLaw(const Bench& bench, const Grating& grating, std::size_t axis) {
  const auto [frequency, z] = grating;
  if (const auto& sheet = bench.display().sheet)
    return std::abs(sheetContrast(*sheet, bench.display().directions[0], frequency, z, axis) *
                    pupilLaw(bench, grating, seenPlace(bench, z, axis, greenChannel)));
  const bool hasDirections = bench.display().directions[axis] > 1;
  const double shift = hasDirections ? frequency * bench.step(axis) * z : 0;
  const std::vector<double> weights = bench.weights();
  const int reach = int(weights.size()) / 2;
  double leaked = 0;
  for (int k = -reach; k <= reach; ++k)
    leaked += weights[std::size_t(k + reach)] * std::cos(2 * pi * shift * k);
  const UnitLaw& law = bench.law();
  const SeenPlace seen = seenPlace(bench, z, axis, greenChannel);
  const double pitch = bench.pitch(axis) * (1 + law.pitchError[axis]) * seen.perLens;
  const double scatter = pi * shift * bench.display().directions[axis] * (1 + law.defocus) *
                         law.shiftSigma / bench.pitch(axis);
  return std::abs(sinc(frequency * pitch) * sinc(shift) * leaked * pupilLaw(bench, grating, seen) *
                  std::exp(-2 * scatter * scatter) * (1 - law.black));
}

double depthOfFall(const std::function<double(double depth)>& fall, double level, double first) {
  constexpr int steps = 200;
  double low = 0;
  double high = 0;
  for (int step = 1; step <= steps; ++step) {
    high = 0.1 * step * first;
    if (fall(high) <= level) break;
    if (step == steps) return std::numeric_limits<double>::infinity();
    low = high;
  }
  const auto isAbove = [&](double depth) { return !(fall(depth) <= level); };
  return bisect({low, high}, 40, isAbove, 1e-7).middle();
}

}  // namespace hogelscope
