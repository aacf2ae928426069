// SPDX-License-Identifier: BSD-3-Clause
// Luminance of single directions and of plain fields: crosstalk of directions, angular profile and
// resolution, uniformity, contrast.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/base/bisect.h"
#include "core/base/text.h"
#include "measure/measurement.h"

namespace hogelscope {

namespace {

constexpr double pi = std::numbers::pi;

double degrees(double radians) {
  return radians * 180 / pi;
}

double luminanceOf(double codeValue) {
  return linearFromEncoded(codeValue);
}

Vec2 onAxis(double place, std::size_t axis) {
  return axis == 0 ? Vec2{place, 0} : Vec2{0, place};
}

/// The middle direction and hogel of an axis, at which single directions are looked at.
struct Middle {
  std::size_t axis;
  int direction;
  double hogel;
};

Middle middleOf(const Bench& bench, std::size_t axis) {
  return {axis, bench.display().directions[axis] / 2, bench.middleHogel(axis)};
}

/// Returns the luminance seen from a direction's middle where only `lit` shines.
double seenFrom(Bench& bench, const Middle& middle, int lit, double direction) {
  const MeterAperture aperture(bench);
  const TestLight one = [&](const plugin::Ray& ray) {
    return std::floor(bench.directionOf(ray, middle.axis)) == lit ? white : grey(0);
  };
  const double place = bench.eyePlaceFor(direction, middle.hogel, middle.axis);
  return luminanceOf(bench.lookAt(one, movedTo(bench.eye(), place, middle.axis),
                                  onAxis(middle.hogel, middle.axis))[0]);
}

/// Returns the closed form: the weight of a direction so many steps away, as a part of its own.
double kernelForm(const Bench& bench, int steps) {
  if (bench.pupil().diameter > 0) return noValue;
  const std::vector<double> weights = bench.weights();
  const int reach = int(weights.size()) / 2;
  const double weight = std::abs(steps) > reach ? 0 : weights[std::size_t(steps + reach)];
  const double own = weights[std::size_t(reach)];
  return bench.psf().light == LightModel::linear
             ? weight / own
             : luminanceOf(whiteCode * weight) / luminanceOf(whiteCode * own);
}

/// Whether the window about the middle direction stays in the field.
bool hasRoom(const Bench& bench, const Middle& middle) {
  const int reach = bench.psf().windowSize / 2 + 2;
  return middle.direction >= 2 * reach &&
         middle.direction + 2 * reach < bench.display().directions[middle.axis];
}

void addMatrix(const Bench& bench, const Middle& middle, std::vector<Measurement>& all) {
  const int reach = bench.psf().windowSize / 2 + 1;
  for (int i = -reach; i <= reach; ++i)
    for (int k = -reach; k <= reach; ++k) {
      const int lit = middle.direction + i;
      const int seen = middle.direction + k;
      Measurement one{"crosstalkMatrix",
                      "",
                      "lit=" + std::to_string(lit) + " seen=" + std::to_string(seen),
                      {},
                      hasRoom(bench, middle) ? kernelForm(bench, k - i) : noValue,
                      double(seen),
                      double(lit)};
      one.simulate = [=](Bench& b) {
        return seenFrom(b, middle, lit, seen + 0.5) / seenFrom(b, middle, lit, lit + 0.5);
      };
      all.push_back(std::move(one));
    }
}

/// The light of the middle direction over the eye's angle.
void addProfile(const Bench& bench, const Middle& middle, std::vector<Measurement>& all) {
  constexpr int perDirection = 8;
  const int reach = bench.psf().windowSize / 2 + 1;
  const auto angleOf = [middle](const Bench& b, double direction) {
    const double way = b.eyePlaceFor(direction, middle.hogel, middle.axis) - middle.hogel;
    return degrees(std::atan2(way, b.distance()));
  };
  const auto relative = [middle](Bench& b, double direction) {
    return seenFrom(b, middle, middle.direction, direction) /
           seenFrom(b, middle, middle.direction, middle.direction + 0.5);
  };
  const bool hasForm = hasRoom(bench, middle);
  for (int k = -reach * perDirection; k < (reach + 1) * perDirection; ++k) {
    const double direction = middle.direction + (k + 0.5) / perDirection;
    const double angle = angleOf(bench, direction);
    const int steps = int(std::floor(direction)) - middle.direction;
    all.push_back({"angularProfile", "", "angle=" + numberText(fourDigits(angle)) + "°",
                   [=](Bench& b) { return relative(b, direction); },
                   hasForm ? kernelForm(bench, steps) : noValue, angle});
  }
  double form = noValue;
  if (hasForm && bench.pupil().diameter == 0) {
    int steps = 0;
    while (kernelForm(bench, steps + 1) >= 0.5) ++steps;
    form = std::abs(angleOf(bench, middle.direction + 1 + steps) -
                    angleOf(bench, middle.direction - steps));
  }
  all.push_back({"angularProfile", "°", "full width at half maximum",
                 [=](Bench& b) {
                   const auto edge = [&](double sign) {
                     const double inside = middle.direction + 0.5;
                     const Bracket ends{inside, inside + sign * (reach + 1)};
                     const auto isBright = [&](double at) { return relative(b, at) >= 0.5; };
                     return angleOf(b, bisect(ends, 40, isBright).inside);
                   };
                   return std::abs(edge(1) - edge(-1));
                 },
                 form});
}

/// Returns the contrast of a wave over directions of so many a period, seen by an eye that moves
/// from direction to direction.
double waveContrast(Bench& bench, const Middle& middle, int period) {
  const TestLight wave = [&](const plugin::Ray& ray) {
    const double direction = std::floor(bench.directionOf(ray, middle.axis));
    return grey(bench.codeOf(std::cos(2 * pi * direction / period)));
  };
  const int first = middle.direction - period / 2;
  std::complex<double> sum;
  for (int k = 0; k < period; ++k) {
    const double place = bench.eyePlaceFor(first + k + 0.5, middle.hogel, middle.axis);
    const double value = bench.lookAt(wave, movedTo(bench.eye(), place, middle.axis),
                                      onAxis(middle.hogel, middle.axis))[0];
    sum += bench.waveOf(value) * std::polar(1.0, 2 * pi * (first + k) / period);
  }
  return std::abs(sum) / period * (period == 2 ? 1 : 2);
}

double waveForm(const Bench& bench, int period) {
  const std::vector<double> weights = bench.weights();
  const int reach = int(weights.size()) / 2;
  double sum = 0;
  for (int k = -reach; k <= reach; ++k)
    sum += weights[std::size_t(k + reach)] * std::cos(2 * pi * k / period);
  return std::abs(sum);
}

void addAngularResolution(const Bench& bench, const Middle& middle, std::vector<Measurement>& all) {
  constexpr double threshold = 0.5;
  const int most = std::min(16, bench.display().directions[middle.axis] / 2);
  const bool hasForm = hasRoom(bench, middle) && bench.pupil().diameter == 0;
  const auto finest = [most](const auto& contrastOf) {
    for (int period = 2; period <= most; ++period)
      if (contrastOf(period) >= threshold) return double(period);
    return noValue;
  };
  const double degreesEach = degrees(std::atan(bench.step(middle.axis)));
  if (most >= 2)
    all.push_back(
        {"angularResolution", "°", "period of contrast 0.5",
         [=](Bench& b) {
           return degreesEach * finest([&](int p) { return waveContrast(b, middle, p); });
         },
         hasForm ? degreesEach * finest([&](int p) { return waveForm(bench, p); }) : noValue});
  for (int period = 2; period <= most; ++period)
    all.push_back({"angularResolution", "",
                   "contrast period=" + std::to_string(period) + " directions",
                   [=](Bench& b) { return waveContrast(b, middle, period); },
                   hasForm ? waveForm(bench, period) : noValue, double(period)});
}

double whiteAt(Bench& bench, const Vec3& eye, const Vec2& point) {
  return luminanceOf(bench.lookAt([](const plugin::Ray&) { return white; }, eye, point)[0]);
}

/// Returns least / most of the values that are numbers.
double evenness(const std::vector<double>& values) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return most > 0 ? least / most : noValue;
}

void addUniformity(const Bench& bench, std::vector<Measurement>& all) {
  const bool isEven = bench.psf().windowSize == 1 || bench.psf().border != PsfBorder::black;
  all.push_back({"uniformity", "", "least/most of 9 points of the panel",
                 [](Bench& b) {
                   const auto [width, height] = b.display().size;
                   std::vector<double> values;
                   for (const double y : {-0.4, 0.0, 0.4})
                     for (const double x : {-0.4, 0.0, 0.4})
                       values.push_back(whiteAt(b, b.eye(), {x * width, y * height}));
                   return evenness(values);
                 },
                 isEven ? 1 : noValue});
  all.push_back({"uniformity", "", "least/most of 9 eyes in the viewing zone",
                 [](Bench& b) {
                   const double distance = b.distance();
                   const double across = std::max(halfZone(b, distance, 0), 0.0);
                   const double down = std::max(halfZone(b, distance, 1), 0.0);
                   std::vector<double> values;
                   for (const double y : {-0.8, 0.0, 0.8})
                     for (const double x : {-0.8, 0.0, 0.8})
                       values.push_back(whiteAt(b, {x * across, y * down, distance}, {0, 0}));
                   return evenness(values);
                 },
                 isEven ? 1 : noValue});
}

void addContrast(std::vector<Measurement>& all) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  all.push_back({"contrast", "", "full screen, white/black",
                 [](Bench& b) {
                   const double black = luminanceOf(
                       b.lookAt([](const plugin::Ray&) { return grey(0); }, b.eye(), {0, 0})[0]);
                   return whiteAt(b, b.eye(), {0, 0}) / black;
                 },
                 infinite});
  all.push_back({"contrast", "", "4×4 checkerboard on the panel",
                 [](Bench& b) {
                   const auto [width, height] = b.display().size;
                   const TestLight board = [width = width,
                                            height = height](const plugin::Ray& ray) {
                     const Vec2 point = pointOf(ray, 0);
                     const double column = std::floor(4 * (point.x / width + 0.5));
                     const double row = std::floor(4 * (point.y / height + 0.5));
                     return std::fmod(column + row + 8, 2) == 0 ? white : grey(0);
                   };
                   std::array<double, 2> sums{};
                   for (int row = 0; row < 4; ++row)
                     for (int column = 0; column < 4; ++column) {
                       const Vec2 middle{width * ((column + 0.5) / 4 - 0.5),
                                         height * ((row + 0.5) / 4 - 0.5)};
                       const double value = luminanceOf(b.lookAt(board, b.eye(), middle)[0]);
                       if (!std::isnan(value)) sums[std::size_t((column + row) % 2)] += value;
                     }
                   return sums[0] / sums[1];
                 },
                 infinite});
}

}  // namespace

void addPhotometry(const Bench& bench, std::vector<Measurement>& all) {
  const std::size_t axis = mainAxis(bench);
  if (bench.display().directions[axis] > 1) {
    const Middle middle = middleOf(bench, axis);
    addMatrix(bench, middle, all);
    addProfile(bench, middle, all);
    addAngularResolution(bench, middle, all);
  }
  addUniformity(bench, all);
  addContrast(all);
}

}  // namespace hogelscope
