// SPDX-License-Identifier: BSD-3-Clause
// Luminance of single directions and of plain fields: crosstalk of directions, angular profile and
// resolution, uniformity, contrast. Lens sheets share the angular profile.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/base/bisect.h"
#include "measure/measurement.h"

namespace hogelscope {

namespace {

constexpr double pi = std::numbers::pi;

/// The middle direction and hogel of an axis, at which single directions are looked at.
struct Middle {
  std::size_t axis;
  int direction;
  double hogel;
};

Middle middleOf(const Bench& bench, std::size_t axis) {
  return {axis, bench.display().directions[axis] / 2, bench.middleHogel(axis)};
}

/// Returns the code value of the middle hogel, seen from a direction.
double valueFrom(Bench& bench, const Middle& middle, const TestLight& light, double direction) {
  const double place = bench.eyePlaceFor(direction, middle.hogel, middle.axis);
  return bench.lookAt(light, movedTo(bench.eye(), place, middle.axis),
                      onAxis(middle.hogel, middle.axis))[0];
}

/// Returns the luminance seen from a direction where only `lit` shines.
double seenFrom(Bench& bench, const Middle& middle, int lit, double direction) {
  const MeterAperture aperture(bench);
  const TestLight one = [&](const plugin::Ray& ray) {
    return std::floor(bench.directionOf(ray, middle.axis)) == lit ? white : grey(0);
  };
  return linearFromEncoded(valueFrom(bench, middle, one, direction));
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
             : linearFromEncoded(whiteCode * weight) / linearFromEncoded(whiteCode * own);
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
      all.push_back(
          {"crosstalkMatrix", "", "lit=" + std::to_string(lit) + " seen=" + std::to_string(seen),
           [=](Bench& b) {
             return seenFrom(b, middle, lit, seen + 0.5) / seenFrom(b, middle, lit, lit + 0.5);
           },
           hasRoom(bench, middle) ? kernelForm(bench, k - i) : noValue, double(seen), double(lit)});
    }
}

/// The light of the middle direction over the eye's angle.
void addMiddleProfile(const Bench& bench, const Middle& middle, std::vector<Measurement>& all) {
  const bool hasForm = hasRoom(bench, middle);
  AngularProfile profile{
      middle.direction,
      bench.psf().windowSize / 2 + 1,
      40,
      [=](const Bench& b, double direction) {
        const double way = b.eyePlaceFor(direction, middle.hogel, middle.axis) - middle.hogel;
        return degrees(std::atan2(way, b.distance()));
      },
      [=](Bench& b, double direction) { return seenFrom(b, middle, middle.direction, direction); },
      [=](const Bench& b, double direction) {
        return hasForm ? kernelForm(b, int(std::floor(direction)) - middle.direction) : noValue;
      },
      noValue};
  if (hasForm && bench.pupil().diameter == 0) {
    int steps = 0;
    while (kernelForm(bench, steps + 1) >= 0.5) ++steps;
    profile.width = std::abs(profile.angleOf(bench, middle.direction + 1 + steps) -
                             profile.angleOf(bench, middle.direction - steps));
  }
  addProfile(bench, profile, all);
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
    sum += bench.waveOf(valueFrom(bench, middle, wave, first + k + 0.5)) *
           std::polar(1.0, 2 * pi * (first + k) / period);
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
  return linearFromEncoded(bench.lookAt([](const plugin::Ray&) { return white; }, eye, point)[0]);
}

/// Returns least / most of what `valueAt` has at 3 × 3 places from −1 to 1, NaN aside.
template <class ValueAt>
double evenness(const ValueAt& valueAt) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const double y : {-1.0, 0.0, 1.0})
    for (const double x : {-1.0, 0.0, 1.0}) {
      const double value = valueAt(x, y);
      if (std::isnan(value)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
  return most > 0 ? least / most : noValue;
}

void addUniformity(const Bench& bench, std::vector<Measurement>& all) {
  const bool isEven = bench.psf().windowSize == 1 || bench.psf().border != PsfBorder::black;
  const double form = isEven ? 1 : noValue;
  all.push_back({"uniformity", "", "least/most of 9 points of the panel",
                 [](Bench& b) {
                   const auto& size = b.display().size;
                   return evenness([&](double x, double y) {
                     return whiteAt(b, b.eye(), {0.4 * x * size[0], 0.4 * y * size[1]});
                   });
                 },
                 form});
  all.push_back({"uniformity", "", "least/most of 9 eyes in the viewing zone",
                 [](Bench& b) {
                   const double distance = b.distance();
                   const double across = std::max(halfZone(b, distance, 0), 0.0);
                   const double down = std::max(halfZone(b, distance, 1), 0.0);
                   return evenness([&](double x, double y) {
                     return whiteAt(b, {0.8 * x * across, 0.8 * y * down, distance}, {0, 0});
                   });
                 },
                 form});
}

void addContrast(const Bench& bench, std::vector<Measurement>& all) {
  const double ambient = bench.law().ambient[0];
  const double form = (1 + ambient) / (bench.law().black + ambient);  // infinite for a design
  all.push_back({"contrast", "", "full screen, white/black",
                 [](Bench& b) {
                   const double black = linearFromEncoded(
                       b.lookAt([](const plugin::Ray&) { return grey(0); }, b.eye(), {0, 0})[0]);
                   return whiteAt(b, b.eye(), {0, 0}) / black;
                 },
                 form});
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
                       const double value = linearFromEncoded(b.lookAt(board, b.eye(), middle)[0]);
                       if (!std::isnan(value)) sums[std::size_t((column + row) % 2)] += value;
                     }
                   return sums[0] / sums[1];
                 },
                 form});
}

}  // namespace

void addProfile(const Bench& bench, const AngularProfile& profile, std::vector<Measurement>& all) {
  constexpr int perDirection = 8;
  const auto relative = [profile](Bench& b, double direction) {
    return profile.light(b, direction) / profile.light(b, profile.lit + 0.5);
  };
  for (int k = -profile.reach * perDirection; k < (profile.reach + 1) * perDirection; ++k) {
    const double direction = profile.lit + (k + 0.5) / perDirection;
    const double angle = profile.angleOf(bench, direction);
    all.push_back({"angularProfile", "", "angle=" + numberText(fourDigits(angle)) + "°",
                   [=](Bench& b) { return relative(b, direction); },
                   profile.closedForm(bench, direction), angle});
  }
  const auto widthOf = [profile](auto& b, const auto& lightAt) {
    const double middle = profile.lit + 0.5;
    const auto edge = [&](double sign) {
      const Bracket ends{middle, middle + sign * (profile.reach + 1)};
      const auto isBright = [&](double direction) { return lightAt(b, direction) >= 0.5; };
      return profile.angleOf(b, bisect(ends, profile.halvings, isBright).inside);
    };
    return std::abs(edge(1) - edge(-1));
  };
  all.push_back({"angularProfile", "°", "full width at half maximum",
                 [=](Bench& b) { return widthOf(b, relative); },
                 profile.width ? *profile.width : widthOf(bench, profile.closedForm)});
}

void addPhotometry(const Bench& bench, std::vector<Measurement>& all) {
  const std::size_t axis = mainAxis(bench);
  if (bench.display().directions[axis] > 1) {
    const Middle middle = middleOf(bench, axis);
    addMatrix(bench, middle, all);
    addMiddleProfile(bench, middle, all);
    addAngularResolution(bench, middle, all);
  }
  addUniformity(bench, all);
  addContrast(bench, all);
}

}  // namespace hogelscope
