// SPDX-License-Identifier: BSD-3-Clause
// The finders of units as they were built (Twin), of which Twin::hasKernel() is true.
#pragma once

#include <bit>
#include <cmath>

#include "core/engine/finders.h"
#include "core/panel/twin.h"

namespace hogelscope {

/// A unit whose lenses are linear, on a plane (Twin::isSimple), one colour of it.
template <bool hasHogels>
struct UnitFinder : RealMap<double> {
  UnitFinder(const HitMap& m, std::size_t channel)
      : RealMap<double>(m),
        array(m.panel.display->twin()->lensArray()),
        hogels(m.panel.display->twin()->hogels().data()),
        scale(m.panel.display->twin()->scaleOf(channel)),
        eye(m.panel.eye),
        off{array.middle[0] - array.design[0], array.middle[1] - array.design[1]},
        offI{array.middleI[0] - array.pitch[0], array.middleI[1]},
        offJ{array.middleJ[0], array.middleJ[1] + array.pitch[1]},
        perPitch{1 / array.pitch[0], 1 / array.pitch[1]},
        perField{1 / array.field[0], 1 / array.field[1]} {}

  /// Returns the same as Twin::meet().
  [[nodiscard]] __attribute__((always_inline)) RealHit<double> hit(double rayX, double rayY) const {
    const auto [a, b, isToward] = slopesOf(*this, rayX, rayY);
    const double x = eye.x - eye.z * a;
    const double y = eye.y - eye.z * b;
    RealHit<double> h;
    h.i = array.cell[0] + array.cellX[0] * x + array.cellY[0] * y;
    h.j = array.cell[1] + array.cellX[1] * x + array.cellY[1] * y;
    const auto inside = [](double index, double cells) {
      const double least = index > 0 ? index : 0;
      return static_cast<std::int32_t>(least < cells - 1 ? least : cells - 1);
    };
    const std::int32_t column = inside(h.i, count[0]);
    const std::int32_t row = inside(h.j, count[1]);
    const double i = column;
    const double j = row;
    double offX = off[0] + i * offI[0] + j * offJ[0];
    double offY = off[1] + i * offI[1] + j * offJ[1];
    double gap = 1 + array.gap + array.wedge[0] * x + array.wedge[1] * y;
    double turnedA = a + array.convergence * x;
    double turnedB = b + array.convergence * y;
    if constexpr (hasHogels) {
      const HogelErrors& own = hogels[row * static_cast<std::int32_t>(count[0]) + column];
      offX += double(own.shiftX);
      offY += double(own.shiftY);
      gap += double(own.gap);
      turnedA -= double(own.tiltX);
      turnedB -= double(own.tiltY);
    }
    const double blur = gap / (1 + array.focal) - 1;
    const double fromX = x - (array.middle[0] + i * array.middleI[0] + j * array.middleJ[0]);
    const double fromY = y - (array.middle[1] + i * array.middleI[1] + j * array.middleJ[1]);
    const double gained = scale * gap;
    h.u = count[2] * (0.5 + gained * turnedA * perField[0] + (blur * fromX - offX) * perPitch[0]);
    h.v = count[3] * (0.5 - gained * turnedB * perField[1] - (blur * fromY - offY) * perPitch[1]);
    h.isMet = isToward;
    return h;
  }

  LensArrayMap array;
  const HogelErrors* hogels;
  double scale;
  Vec3 eye;
  /// These tell how far a lens is from its tile, and what that grows by for each hogel to the
  /// right, and down.
  std::array<double, 2> off, offI, offJ;
  std::array<double, 2> perPitch, perField;
};

/// An affine unit (Twin::isAffine). Its indices are quotients of linear functions; u and v also
/// depend on the hogel that is met.
template <bool hasMoves, bool hasDirections>
struct AffineFinder : RealMap<double> {
  static constexpr StripHits rowHits = StripHits::some;

  explicit AffineFinder(const HitMap& m)
      : RealMap<double>(m),
        moves(m.panel.display->twin()->hogelMoves().data()),
        table(&m.panel.display->twin()->directionTable()),
        back(table->back().data()),
        perDirection(table->perDirection()),
        z(timesZ(m, 1, 0, 0)),
        beyond(table->largest()),
        error(table->error()) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto& [startOfPlace, ofA, ofB] = m.panel.affine.place[axis];
      index[axis] = timesZ(m, startOfPlace, ofA, ofB);
      const auto& [startOf, ofSlope, ofOwn, ofOther] = m.panel.affine.direction[axis];
      index[axis + 2] = axis == 0 ? timesZ(m, startOf, ofSlope, 0) : timesZ(m, startOf, 0, ofSlope);
      own[axis] = ofOwn;
      other[axis] = ofOther;
    }
  }

  /// Tells what a ray meets before its hogel's move and the map of directions; `isMet` is true if
  /// that is the panel, in or out of the field.
  struct Met : RealHit<double> {
    std::int32_t column;
    std::int32_t row;
  };

  template <Rays rays>
  [[nodiscard]] __attribute__((always_inline)) Met met(double x, double y) const {
    const auto at = [&](const PlaneFunction& f) __attribute__((always_inline)) {
      return f[0] * x + (f[1] * y + f[2]);
    };
    const double perZ = 1 / at(z);
    Met h;
    h.i = at(index[0]) * perZ;
    h.j = at(index[1]) * perZ;
    h.isMet = rays == Rays::hits || static_cast<bool>((perZ < 0) & (h.i >= 0) & (h.i < count[0]) &
                                                      (h.j >= 0) & (h.j < count[1]));
    h.column = static_cast<std::int32_t>(h.isMet ? h.i : 0);
    h.row = static_cast<std::int32_t>(h.isMet ? h.j : 0);
    h.u = at(index[2]) * perZ + (own[0] * h.column + other[0] * h.row);
    h.v = at(index[3]) * perZ + (own[1] * h.row + other[1] * h.column);
    return h;
  }

  [[nodiscard]] __attribute__((always_inline)) RealHit<double> hit(double x, double y) const {
    Met h = met<Rays::any>(x, y);
    if constexpr (hasMoves) {
      const MoveTable::Pair& move = moves[h.row * static_cast<std::int32_t>(count[0]) + h.column];
      h.u += double(move[0]);
      h.v += double(move[1]);
    }
    if (hasDirections && h.isMet) {
      const std::array<double, 2> turned = table->solve(h.u, h.v);
      h.u = turned[0];
      h.v = turned[1];
    }
    return h;
  }

  const MoveTable::Pair* moves;
  const MoveTable* table;
  const MoveTable::Pair* back;
  int perDirection;
  PlaneFunction z;
  std::array<PlaneFunction, 4> index{};  ///< i, j, u, v; times z
  std::array<double, 2> own{};           ///< what u and v grow by for each hogel along their axis
  std::array<double, 2> other{};         ///< and across it
  std::array<double, 2> beyond;          ///< how far beyond the field a hit may be moved into it
  std::array<double, 2> error;           ///< of `back`
};

/// The hits of a strip. All bits of `isOn` are set where the panel is met; column and row are 0
/// elsewhere.
struct AffineStrip {
  Strip<double> u, v;
  Strip<std::int32_t> column, row;
  Strip<std::uint32_t> isOn;
};

/// Adds a pair to u and v for each place of a list. Pairs have a loop of their own, because loops
/// of one kind of step are vectorised.
inline __attribute__((always_inline)) void addPairs(const MoveTable::Pair* pairs,
                                                    const Strip<std::int32_t>& at, AffineStrip& s) {
  Strip<std::uint64_t> pair;
#pragma GCC unroll 8
  for (std::size_t k = 0; k < stripSize; ++k) std::memcpy(&pair[k], pairs + at[k], sizeof pair[k]);
  for (std::size_t k = 0; k < stripSize; ++k) {
    s.u[k] += double(std::bit_cast<float>(static_cast<std::uint32_t>(pair[k])));
    s.v[k] += double(std::bit_cast<float>(static_cast<std::uint32_t>(pair[k] >> 32)));
  }
}

/// Inverts the map of directions, so that u and v are in their cells: by the table, and where that
/// may err, by Newton's steps.
template <Rays rays, class Affine>
inline __attribute__((always_inline)) void turnBack(const Affine& m, AffineStrip& s) {
  const auto columns = static_cast<std::int32_t>(m.count[2]) * m.perDirection;
  const double perDirection = m.perDirection;
  Strip<double> designU, designV;
  Strip<std::int32_t> at;
  Strip<std::uint8_t> isUnsure;
  const double lastU = m.count[2] - 0.5 / perDirection;
  const double lastV = m.count[3] - 0.5 / perDirection;
  for (std::size_t k = 0; k < stripSize; ++k) {
    const double u = s.u[k];
    const double v = s.v[k];
    const double insideU = rays == Rays::hits ? u : std::min(std::max(0.0, u), lastU);
    const double insideV = rays == Rays::hits ? v : std::min(std::max(0.0, v), lastV);
    designU[k] = u;
    designV[k] = v;
    isUnsure[k] = (insideU != u) | (insideV != v) ? 1 : 0;
    at[k] = static_cast<std::int32_t>(insideV * perDirection) * columns +
            static_cast<std::int32_t>(insideU * perDirection);
  }
  addPairs(m.back, at, s);
  for (std::size_t k = 0; k < stripSize; ++k) {
    const auto isNearBorder = [](double place, double error) {
      const double from = std::abs(place - std::floor(place) - 0.5);
      return from > 0.5 - error;
    };
    const bool isSure = !(isNearBorder(s.u[k], m.error[0]) | isNearBorder(s.v[k], m.error[1]));
    isUnsure[k] = isSure ? isUnsure[k] : std::uint8_t{1};
  }
  for (std::size_t first = 0; first < stripSize; first += sizeof(std::uint64_t)) {
    std::uint64_t some = 0;
    std::memcpy(&some, &isUnsure[first], sizeof some);
    if (some == 0) continue;
    for (std::size_t k = first; k < first + sizeof some; ++k) {
      if (isUnsure[k] == 0 || s.isOn[k] == 0) continue;
      const auto isFar = [&](double place, std::size_t axis) {
        return !(place >= -m.beyond[axis] && place < m.count[axis + 2] + m.beyond[axis]);
      };
      if (isFar(designU[k], 0) || isFar(designV[k], 1)) {
        s.isOn[k] = 0;
        continue;
      }
      const std::array<double, 2> found = m.table->solve(designU[k], designV[k]);
      s.u[k] = found[0];
      s.v[k] = found[1];
    }
  }
}

template <Rays rays, bool hasMoves, bool hasDirections>
inline __attribute__((always_inline)) void findStrip(const AffineFinder<hasMoves, hasDirections>& m,
                                                     const double* x, const double* y,
                                                     CellStrip& strip) {
  AffineStrip s;
  Strip<std::int32_t> hogel;
  const auto columns = static_cast<std::int32_t>(m.count[0]);
  for (std::size_t k = 0; k < stripSize; ++k) {
    const auto h = m.template met<rays>(x[k], y[rays == Rays::any ? k : 0]);
    s.u[k] = h.u;
    s.v[k] = h.v;
    s.column[k] = h.column;
    s.row[k] = h.row;
    s.isOn[k] = h.isMet ? ~0U : 0;
    hogel[k] = h.row * columns + h.column;
  }
  if constexpr (hasMoves) addPairs(m.moves, hogel, s);
  if constexpr (hasDirections) turnBack<rays>(m, s);
  for (std::size_t k = 0; k < stripSize; ++k) {
    const bool isSeen = rays == Rays::hits ||
                        static_cast<bool>((s.isOn[k] != 0) & (s.u[k] >= 0) & (s.u[k] < m.count[2]) &
                                          (s.v[k] >= 0) & (s.v[k] < m.count[3]));
    strip.cell[0][k] = static_cast<std::uint32_t>(s.column[k]);
    strip.cell[1][k] = static_cast<std::uint32_t>(s.row[k]);
    strip.cell[2][k] = cellOf(isSeen ? s.u[k] : 0);
    strip.cell[3][k] = cellOf(isSeen ? s.v[k] : 0);
    strip.seen[k] = isSeen ? ~0U : 0;
  }
}

}  // namespace hogelscope
