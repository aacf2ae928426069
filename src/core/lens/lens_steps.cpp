// SPDX-License-Identifier: BSD-3-Clause
// One step towards a lens' inverse for many points: Distortion's formulas, written so that they are
// vectorised.
#include "core/lens/lens_steps.h"

#include <cmath>
#include <limits>

#include "core/base/multiversioned.h"

namespace hogelscope {

namespace {

/// The radial factor of Brown–Conrady or, with a divisor, of the rational model, and its slope
/// over r, at r².
template <bool hasDivisor>
struct RadialFactor {
  double radial;
  double slope;

  __attribute__((always_inline)) RadialFactor(const DistortionParams& lens, double r2) {
    radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
    slope = 2 * lens.k1 + r2 * (4 * lens.k2 + r2 * 6 * lens.k3);
    if constexpr (hasDivisor) {
      const double inverse = 1 / (1 + r2 * (lens.k4 + r2 * (lens.k5 + r2 * lens.k6)));
      radial *= inverse;
      slope = (slope - radial * (2 * lens.k4 + r2 * (4 * lens.k5 + r2 * 6 * lens.k6))) * inverse;
    }
  }
};

template <bool hasDivisor>
inline __attribute__((always_inline)) int newton(const DistortionParams& lens, const double* x,
                                                 const double* y, int count, double* idealX,
                                                 double* idealY, double* move) {
  const DistortionParams own = lens;
  const auto [p1, p2] = std::pair(own.p1, own.p2);
  int moving = 0;
  for (int k = 0; k < count; ++k) {
    const double px = idealX[k];
    const double py = idealY[k];
    const double r2 = px * px + py * py;
    const auto [radial, slope] = RadialFactor<hasDivisor>(own, r2);
    const double errorX = x[k] - (px * radial + 2 * p1 * px * py + p2 * (r2 + 2 * px * px));
    const double errorY = y[k] - (py * radial + p1 * (r2 + 2 * py * py) + 2 * p2 * px * py);
    const double mixed = slope * px * py + 2 * p1 * px + 2 * p2 * py;
    const double xx = radial + slope * px * px + 2 * p1 * py + 6 * p2 * px;
    const double yy = radial + slope * py * py + 6 * p1 * py + 2 * p2 * px;
    const double inverseDet = 1 / (xx * yy - mixed * mixed);
    const double moveX = (yy * errorX - mixed * errorY) * inverseDet;
    const double moveY = (xx * errorY - mixed * errorX) * inverseDet;
    idealX[k] = px + moveX;
    idealY[k] = py + moveY;
    move[k] = moveX * moveX + moveY * moveY;
    moving += move[k] < shortMoveSquared ? 0 : 1;
  }
  return moving;
}

template <bool hasDivisor>
inline __attribute__((always_inline)) void fixedPoint(const DistortionParams& lens, const double* x,
                                                      const double* y, int count, double* idealX,
                                                      double* idealY, double* isOver) {
  const DistortionParams own = lens;
  const auto [p1, p2] = std::pair(own.p1, own.p2);
  for (int k = 0; k < count; ++k) {
    const double px = idealX[k];
    const double py = idealY[k];
    const double r2 = px * px + py * py;
    const double inverse = 1 / RadialFactor<hasDivisor>(own, r2).radial;
    const double nextX = (x[k] - (2 * p1 * px * py + p2 * (r2 + 2 * px * px))) * inverse;
    const double nextY = (y[k] - (p1 * (r2 + 2 * py * py) + 2 * p2 * px * py)) * inverse;
    const bool over = static_cast<bool>((isOver[k] > 0) | (inverse < 0));
    isOver[k] = over ? 1 : 0;
    idealX[k] = over ? x[k] : nextX;
    idealY[k] = over ? y[k] : nextY;
  }
}

MULTIVERSIONED
int brownNewton(const DistortionParams& lens, const double* x, const double* y, int count,
                double* idealX, double* idealY, double* move) {
  return newton<false>(lens, x, y, count, idealX, idealY, move);
}

MULTIVERSIONED
int rationalNewton(const DistortionParams& lens, const double* x, const double* y, int count,
                   double* idealX, double* idealY, double* move) {
  return newton<true>(lens, x, y, count, idealX, idealY, move);
}

MULTIVERSIONED
void brownFixedPoint(const DistortionParams& lens, const double* x, const double* y, int count,
                     double* idealX, double* idealY, double* isOver) {
  fixedPoint<false>(lens, x, y, count, idealX, idealY, isOver);
}

MULTIVERSIONED
void rationalFixedPoint(const DistortionParams& lens, const double* x, const double* y, int count,
                        double* idealX, double* idealY, double* isOver) {
  fixedPoint<true>(lens, x, y, count, idealX, idealY, isOver);
}

/// Steps of the ray's angle, as cv::fisheye::undistortPoints makes them. `next` gives the new angle
/// for the old one and the distance of the distorted point. From 90° on there is no ray.
template <class Next>
int fisheyeStep(const double* x, const double* y, int count, double* idealX, double* idealY,
                double* move, const Next& next) {
  int moving = 0;
  for (int k = 0; k < count; ++k) {
    const double distance = std::hypot(x[k], y[k]);
    const double before = std::hypot(idealX[k], idealY[k]);
    const double angle = next(std::atan(before), distance);
    const double radius =
        angle < Fisheye::rightAngle ? std::tan(angle) : std::numeric_limits<double>::quiet_NaN();
    const double factor = distance > 0 ? radius / distance : 1;
    idealX[k] = x[k] * factor;
    idealY[k] = y[k] * factor;
    move[k] = (radius - before) * (radius - before);
    moving += move[k] < shortMoveSquared ? 0 : 1;
  }
  return moving;
}

bool hasDivisor(const DistortionParams& lens) {
  return lens.k4 != 0 || lens.k5 != 0 || lens.k6 != 0;
}

}  // namespace

int newtonStep(const DistortionParams& lens, const double* x, const double* y, int count,
               double* idealX, double* idealY, double* move) {
  if (lens.model == DistortionModel::fisheye) {
    const Fisheye fisheye({lens.k1, lens.k2, lens.k3, lens.k4});
    return fisheyeStep(x, y, count, idealX, idealY, move, [&](double angle, double distance) {
      return angle + (distance - fisheye.distorted(angle)) / fisheye.slope(angle);
    });
  }
  return (hasDivisor(lens) ? rationalNewton : brownNewton)(lens, x, y, count, idealX, idealY, move);
}

void fixedPointStep(const DistortionParams& lens, const double* x, const double* y, int count,
                    double* idealX, double* idealY, double* isOver) {
  if (lens.model == DistortionModel::fisheye) {
    const Fisheye fisheye({lens.k1, lens.k2, lens.k3, lens.k4});
    fisheyeStep(x, y, count, idealX, idealY, isOver, [&](double angle, double distance) {
      return angle > 0 ? distance * angle / fisheye.distorted(angle) : distance;
    });
    return;
  }
  (hasDivisor(lens) ? rationalFixedPoint : brownFixedPoint)(lens, x, y, count, idealX, idealY,
                                                            isOver);
}

}  // namespace hogelscope
