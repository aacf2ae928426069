// SPDX-License-Identifier: BSD-3-Clause
// A unit's rays: which directional pixel one meets, and back; written to be read beside
// docs/formulas.md, Twin.
#include "core/panel/twin.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "core/base/error.h"

namespace hogelscope {

namespace {

/// The surface at a place, metres, and its slopes.
struct SurfacePoint {
  double z = 0;
  double slopeX = 0;
  double slopeY = 0;
};

/// Beyond the middles of the outermost cells the surface goes straight on to the panel's borders.
SurfacePoint surfaceAt(const TwinPlane& height, const std::array<double, 2>& size, double x,
                       double y) {
  if (height.isEmpty()) return {};
  const Bilinear at(height, planePlaceOf(std::clamp(x / size[0] + 0.5, 0.0, 1.0), height.width),
                    planePlaceOf(std::clamp(0.5 - y / size[1], 0.0, 1.0), height.height));
  return {at.value, at.across * height.width / size[0], -at.down * height.height / size[1]};
}

bool isOutside(double index, int count) {
  return !(index >= 0 && index < count);
}

}  // namespace

/// The move m of a direction, and how it grows for each direction across and down.
struct Twin::Move {
  Vec2 m;
  Vec2 across;
  Vec2 down;
  [[nodiscard]] double determinant() const {
    return (1 + across.x) * (1 + down.y) - down.x * across.y;
  }
};

Twin::Move Twin::moveAt(double u, double v) const {
  const auto [du, dv] = m_design.directions;
  Move move;
  const auto find = [&, du = du, dv = dv](const TwinPlane& plane, double Vec2::*axis) {
    if (plane.isEmpty()) return;
    const PlanePlace i = planePlaceOf(u / du, plane.width);
    const PlanePlace j = planePlaceOf(v / dv, plane.height);
    const Bilinear at(plane, within(i), within(j));
    move.m.*axis = at.value;
    if (i.share == within(i).share) move.across.*axis = at.across * plane.width / du;
    if (j.share == within(j).share) move.down.*axis = at.down * plane.height / dv;
  };
  find(m_maps.moveU, &Vec2::x);
  find(m_maps.moveV, &Vec2::y);
  return move;
}

/// The determinant of a bilinear map is linear along both axes, so that it is least in a corner.
void Twin::checkDirections() const {
  const TwinPlane& plane = m_maps.moveU.isEmpty() ? m_maps.moveV : m_maps.moveU;
  const auto [du, dv] = m_design.directions;
  constexpr double inside = 1e-9;  // of a cell, from its corners
  for (int row = 0; row < plane.height; ++row)
    for (int column = 0; column < plane.width; ++column)
      for (const double x : {-inside, inside})
        for (const double y : {-inside, inside}) {
          const double u = (column + 0.5 + x) / plane.width * du;
          const double v = (row + 0.5 + y) / plane.height * dv;
          if (!(moveAt(u, v).determinant() > 0))
            throw InputError("twin.maps.directions",
                             "folds near direction (" + std::to_string(int(u)) + ", " +
                                 std::to_string(int(v)) +
                                 "): two pixels would send light into one direction");
        }
}

void Twin::prepareKernels() {
  const auto& [field, pitch] = std::pair(m_array.field, m_array.pitch);
  const auto [du, dv] = m_design.directions;
  m_isAffine = m_array.wedge == std::array<double, 2>{} && m_maps.gap.isEmpty() &&
               m_params.colour.scale == ColourErrors{}.scale;
  if (m_isAffine && field[0] > 0)
    for (const HogelErrors& own : m_hogels) {
      const double scale = 1 + m_array.gap;
      m_hogelMoves.push_back({static_cast<float>(-du * (double(own.shiftX) / pitch[0] +
                                                        scale * double(own.tiltX) / field[0])),
                              static_cast<float>(dv * (double(own.shiftY) / pitch[1] +
                                                       scale * double(own.tiltY) / field[1]))});
    }
  for (const auto& move : m_hogelMoves)
    for (std::size_t axis = 0; axis < 2; ++axis)
      m_largestMoves[axis] = std::max(m_largestMoves[axis], std::abs(double(move[axis])));
  if (m_params.lensArray.outside == OutsideField::dark && movesDirections())
    m_directions = MoveTable(m_maps.moveU, m_maps.moveV, m_design.directions);
}

AffineHits Twin::affineHits(const Vec3& eye) const {
  const auto& [cell, cellX, cellY, middle, middleI, middleJ, design, pitch, wedge, field, gap,
               focal, convergence] = m_array;
  const double g = 1 + gap;
  const double blur = g / (1 + focal) - 1;
  AffineHits hits;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    hits.place[axis] = {cell[axis] + cellX[axis] * eye.x + cellY[axis] * eye.y,
                        -cellX[axis] * eye.z, -cellY[axis] * eye.z};
    const double own = axis == 0 ? eye.x : eye.y;
    const double count = m_design.directions[axis];
    const double cells = axis == 0 ? count : -count;  // v is downwards
    const double step = axis == 0 ? pitch[0] : -pitch[1];
    const double along = axis == 0 ? middleI[0] : middleJ[1];
    const double across = axis == 0 ? middleJ[0] : middleI[1];
    hits.direction[axis] = {
        count / 2 +
            cells * (g * convergence * own / field[axis] +
                     (blur * (own - middle[axis]) - (middle[axis] - design[axis])) / pitch[axis]),
        cells * (g * (1 - convergence * eye.z) / field[axis] - blur * eye.z / pitch[axis]),
        -cells * (blur * along + along - step) / pitch[axis],
        -cells * (blur * across + across) / pitch[axis]};
  }
  return hits;
}

std::optional<Hit> Twin::meet(const Vec3& eye, const Vec3& direction, std::size_t channel) const {
  if (!(eye.z > 0 && direction.z < 0)) return std::nullopt;
  double a = direction.x / direction.z;
  double b = direction.y / direction.z;
  double x = eye.x - eye.z * a;
  double y = eye.y - eye.z * b;
  if (!std::isfinite(x) || !std::isfinite(y)) return std::nullopt;  // along the panel
  if (!m_maps.height.isEmpty()) {
    SurfacePoint surface;
    for (int step = 0; step < 100; ++step) {
      surface = surfaceAt(m_maps.height, m_design.size, x, y);
      const double nextX = eye.x - (eye.z - surface.z) * a;
      const double nextY = eye.y - (eye.z - surface.z) * b;
      const double moved = std::max(std::abs(nextX - x), std::abs(nextY - y));
      std::tie(x, y) = std::pair(nextX, nextY);
      if (moved < 1e-12) break;
    }
    if (!(eye.z > surface.z)) return std::nullopt;
    a += surface.slopeX;
    b += surface.slopeY;
  }
  const auto& [cell, cellX, cellY, middle, middleI, middleJ, design, pitch, wedge, field, gap0,
               focal, convergence] = m_array;
  const auto [du, dv] = m_design.directions;
  Hit hit;
  hit.i = cell[0] + cellX[0] * x + cellY[0] * y;
  hit.j = cell[1] + cellX[1] * x + cellY[1] * y;
  const double i = std::floor(hit.i);
  const double j = std::floor(hit.j);
  const Vec2 lens{middle[0] + i * middleI[0] + j * middleJ[0],
                  middle[1] + i * middleI[1] + j * middleJ[1]};
  const auto [nx, ny] = m_design.hogels;
  const HogelErrors own = errorsOf(static_cast<int>(std::clamp(i, 0.0, double(nx))),
                                   static_cast<int>(std::clamp(j, 0.0, double(ny))));
  const Vec2 off{lens.x - (design[0] + i * pitch[0]) + double(own.shiftX),
                 lens.y - (design[1] - j * pitch[1]) + double(own.shiftY)};
  const double gap = gap0 + wedge[0] * x + wedge[1] * y + double(own.gap);
  const double blur = (1 + gap) / (1 + focal) - 1;
  const double scale = scaleOf(channel) * (1 + gap);
  const double turnedA = a - double(own.tiltX) + convergence * x;
  const double turnedB = b - double(own.tiltY) + convergence * y;
  hit.u = du * (0.5 + scale * m_lenses[0]->directionOf(turnedA) +
                (blur * (x - lens.x) - off.x) / pitch[0]);
  hit.v = dv * (0.5 - scale * m_lenses[1]->directionOf(turnedB) -
                (blur * (y - lens.y) - off.y) / pitch[1]);
  return moved(hit);
}

/// Newton's steps. The map is bilinear between the middles of its cells and does not fold, so that
/// few are needed; a step after which more is left, beyond a steep cell, is halved.
Vec2 Twin::solved(const Vec2& designed) const {
  Vec2 found = designed;
  Vec2 step;
  double left = std::numeric_limits<double>::infinity();
  for (int count = 0; count < 100; ++count) {
    const Move move = moveAt(found.x, found.y);
    const Vec2 rest{designed.x - found.x - move.m.x, designed.y - found.y - move.m.y};
    const double size = std::max(std::abs(rest.x), std::abs(rest.y));
    if (size >= left) {
      step = {step.x / 2, step.y / 2};
      found = {found.x - step.x, found.y - step.y};
      continue;
    }
    left = size;
    const double determinant = move.determinant();
    step = {(rest.x * (1 + move.down.y) - rest.y * move.down.x) / determinant,
            (rest.y * (1 + move.across.x) - rest.x * move.across.y) / determinant};
    found = {found.x + step.x, found.y + step.y};
    if (std::max(std::abs(step.x), std::abs(step.y)) < 1e-9) break;
  }
  return found;
}

Hit Twin::moved(Hit hit) const {
  const auto [nx, ny] = m_design.hogels;
  const auto [du, dv] = m_design.directions;
  if (isOutside(hit.i, nx) || isOutside(hit.j, ny)) return hit;
  if (movesDirections()) {
    const Vec2 found = solved({hit.u, hit.v});
    hit.u = found.x;
    hit.v = found.y;
  }
  if (m_params.lensArray.outside == OutsideField::dark) return hit;
  const double aside = std::floor(hit.u / du);
  const double below = std::floor(hit.v / dv);
  hit.i -= aside;
  hit.u -= aside * du;
  hit.j -= below;
  hit.v -= below * dv;
  return hit;
}

std::optional<PanelRay> Twin::rayOf(const TexelIndex& at) const {
  if (!m_traits.movesRays) return std::nullopt;
  return rayOf(at.i, at.j, at.u + 0.5, at.v + 0.5, greenChannel);
}

PanelRay Twin::rayOf(int i, int j, double u, double v, std::size_t channel) const {
  const auto& array = m_array;
  const auto [du, dv] = m_design.directions;
  const Vec2 lens{array.middle[0] + i * array.middleI[0] + j * array.middleJ[0],
                  array.middle[1] + i * array.middleI[1] + j * array.middleJ[1]};
  const HogelErrors own = errorsOf(i, j);
  const Vec2 off{lens.x - (array.design[0] + i * array.pitch[0]) + double(own.shiftX),
                 lens.y - (array.design[1] - j * array.pitch[1]) + double(own.shiftY)};
  const double gap =
      array.gap + array.wedge[0] * lens.x + array.wedge[1] * lens.y + double(own.gap);
  const double scale = scaleOf(channel) * (1 + gap);
  const Vec2 move = moveAt(u, v).m;
  const double acrossField = (u + move.x) / du - 0.5 + off.x / array.pitch[0];
  const double upField = 0.5 - (v + move.y) / dv + off.y / array.pitch[1];
  const SurfacePoint surface = surfaceAt(m_maps.height, m_design.size, lens.x, lens.y);
  const double a = m_lenses[0]->slopeOf(acrossField / scale) + double(own.tiltX) -
                   array.convergence * lens.x - surface.slopeX;
  const double b = m_lenses[1]->slopeOf(upField / scale) + double(own.tiltY) -
                   array.convergence * lens.y - surface.slopeY;
  return {{lens.x - surface.z * a, lens.y - surface.z * b}, {a, b}};
}

}  // namespace hogelscope
