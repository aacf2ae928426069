// SPDX-License-Identifier: BSD-3-Clause
// One step towards a lens' inverse for many points: Distortion's formulas, written so that they are
// vectorised.
#include "core/lens/lens_steps.h"

#include "core/base/multiversioned.h"

namespace hogelscope {

MULTIVERSIONED
int newtonStep(const DistortionParams& lens, const double* x, const double* y, int count,
               double* idealX, double* idealY, double* move) {
  const auto [k1, k2, p1, p2, k3] = lens;
  int moving = 0;
  for (int k = 0; k < count; ++k) {
    const double px = idealX[k];
    const double py = idealY[k];
    const double r2 = px * px + py * py;
    const double radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    const double slope = 2 * k1 + r2 * (4 * k2 + r2 * 6 * k3);
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

MULTIVERSIONED
void fixedPointStep(const DistortionParams& lens, const double* x, const double* y, int count,
                    double* idealX, double* idealY, double* isOver) {
  const auto [k1, k2, p1, p2, k3] = lens;
  for (int k = 0; k < count; ++k) {
    const double px = idealX[k];
    const double py = idealY[k];
    const double r2 = px * px + py * py;
    const double inverse = 1 / (1 + r2 * (k1 + r2 * (k2 + r2 * k3)));
    const double nextX = (x[k] - (2 * p1 * px * py + p2 * (r2 + 2 * px * px))) * inverse;
    const double nextY = (y[k] - (p1 * (r2 + 2 * py * py) + 2 * p2 * px * py)) * inverse;
    const bool over = static_cast<bool>((isOver[k] > 0) | (inverse < 0));
    isOver[k] = over ? 1 : 0;
    idealX[k] = over ? x[k] : nextX;
    idealY[k] = over ? y[k] : nextY;
  }
}

}  // namespace hogelscope
