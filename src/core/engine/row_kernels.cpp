// SPDX-License-Identifier: BSD-3-Clause
// The loops that take most of the time, compiled once for each kind of processor.
#include "core/engine/row_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>

#include "core/base/multiversioned.h"
#include "core/panel/twin.h"

namespace hogelscope {

namespace {

/// The numbers of a HitMap in the precision of the arithmetic.
template <class Real>
struct RealMap {
  using Number = Real;
  static constexpr bool isAffineTwin = false;
  explicit RealMap(const HitMap& m) {
    for (std::size_t c = 0; c < 3; ++c) {
      right[c] = static_cast<Real>(m.right[c]);
      down[c] = static_cast<Real>(m.down[c]);
      forward[c] = static_cast<Real>(m.forward[c]);
    }
    for (std::size_t axis = 0; axis < 4; ++axis) {
      constant[axis] = static_cast<Real>(m.panel.constant[axis]);
      slope[axis] = static_cast<Real>(m.panel.slope[axis]);
      count[axis] = static_cast<Real>(m.panel.count[axis]);
    }
  }

  std::array<Real, 3> right, down, forward;
  std::array<Real, 4> constant, slope, count;
};

/// The real-valued indices at which the ray through (x, y, 1) meets the display.
template <class Real>
struct RealHit {
  Real i;
  Real j;
  Real u;
  Real v;
  bool isToward;
};

template <class Real>
inline RealHit<Real> hitOf(const RealMap<Real>& m, Real x, Real y) {
  const Real dx = m.right[0] * x + m.down[0] * y + m.forward[0];
  const Real dy = m.right[1] * x + m.down[1] * y + m.forward[1];
  const Real dz = m.right[2] * x + m.down[2] * y + m.forward[2];
  const Real inverse = 1 / dz;
  const Real a = dx * inverse;
  const Real b = dy * inverse;
  return {m.constant[0] + m.slope[0] * a, m.constant[1] + m.slope[1] * b,
          m.constant[2] + m.slope[2] * a, m.constant[3] + m.slope[3] * b, dz < 0};
}

/// The numbers of a twin whose lenses are linear, on a plane.
template <class Real>
struct TwinMap : RealMap<Real> {
  TwinMap(const HitMap& m, std::size_t channel)
      : RealMap<Real>(m),
        twin(*m.panel.twin),
        hogels(twin.hogels().empty() ? nullptr : twin.hogels().data()),
        scale(static_cast<Real>(twin.scaleOf(channel))) {
    const LensArrayMap& array = twin.lensArray();
    const auto pair = [](const std::array<double, 2>& of) {
      return std::array{static_cast<Real>(of[0]), static_cast<Real>(of[1])};
    };
    eye = {static_cast<Real>(m.panel.eye.x), static_cast<Real>(m.panel.eye.y),
           static_cast<Real>(m.panel.eye.z)};
    cell = pair(array.cell);
    cellX = pair(array.cellX);
    cellY = pair(array.cellY);
    middle = pair(array.middle);
    middleI = pair(array.middleI);
    middleJ = pair(array.middleJ);
    off = pair({array.middle[0] - array.design[0], array.middle[1] - array.design[1]});
    offI = pair({array.middleI[0] - array.pitch[0], array.middleI[1]});
    offJ = pair({array.middleJ[0], array.middleJ[1] + array.pitch[1]});
    perPitch = pair({1 / array.pitch[0], 1 / array.pitch[1]});
    perField = pair({1 / array.field[0], 1 / array.field[1]});
    wedge = pair(array.wedge);
    gap = static_cast<Real>(1 + array.gap);
    perFocal = static_cast<Real>(1 / (1 + array.focal));
    convergence = static_cast<Real>(array.convergence);
  }

  const Twin& twin;
  const HogelErrors* hogels;
  Real scale, gap{}, perFocal{}, convergence{};
  std::array<Real, 3> eye{};
  std::array<Real, 2> cell{}, cellX{}, cellY{}, middle{}, middleI{}, middleJ{}, off{}, offI{},
      offJ{}, perPitch{}, perField{}, wedge{};
};

/// As Twin::meet().
template <bool hasHogels, class Real>
inline __attribute__((always_inline)) RealHit<Real> meet(const TwinMap<Real>& m, Real rayX,
                                                         Real rayY) {
  const Real dx = m.right[0] * rayX + m.down[0] * rayY + m.forward[0];
  const Real dy = m.right[1] * rayX + m.down[1] * rayY + m.forward[1];
  const Real dz = m.right[2] * rayX + m.down[2] * rayY + m.forward[2];
  const Real inverse = 1 / dz;
  const Real a = dx * inverse;
  const Real b = dy * inverse;
  const Real x = m.eye[0] - m.eye[2] * a;
  const Real y = m.eye[1] - m.eye[2] * b;
  RealHit<Real> h;
  h.i = m.cell[0] + m.cellX[0] * x + m.cellY[0] * y;
  h.j = m.cell[1] + m.cellX[1] * x + m.cellY[1] * y;
  const auto inside = [](Real index, Real count) {
    const Real least = index > 0 ? index : 0;
    return static_cast<std::int32_t>(least < count - 1 ? least : count - 1);
  };
  const std::int32_t column = inside(h.i, m.count[0]);
  const std::int32_t row = inside(h.j, m.count[1]);
  const auto i = static_cast<Real>(column);
  const auto j = static_cast<Real>(row);
  Real offX = m.off[0] + i * m.offI[0] + j * m.offJ[0];
  Real offY = m.off[1] + i * m.offI[1] + j * m.offJ[1];
  Real gap = m.gap + m.wedge[0] * x + m.wedge[1] * y;
  Real turnedA = a + m.convergence * x;
  Real turnedB = b + m.convergence * y;
  if constexpr (hasHogels) {
    const HogelErrors& own = m.hogels[row * static_cast<std::int32_t>(m.count[0]) + column];
    offX += static_cast<Real>(own.shiftX);
    offY += static_cast<Real>(own.shiftY);
    gap += static_cast<Real>(own.gap);
    turnedA -= static_cast<Real>(own.tiltX);
    turnedB -= static_cast<Real>(own.tiltY);
  }
  const Real blur = gap * m.perFocal - 1;
  const Real fromX = x - (m.middle[0] + i * m.middleI[0] + j * m.middleJ[0]);
  const Real fromY = y - (m.middle[1] + i * m.middleI[1] + j * m.middleJ[1]);
  constexpr auto half = static_cast<Real>(0.5);
  const Real scale = m.scale * gap;
  h.u =
      m.count[2] * (half + scale * turnedA * m.perField[0] + (blur * fromX - offX) * m.perPitch[0]);
  h.v =
      m.count[3] * (half - scale * turnedB * m.perField[1] - (blur * fromY - offY) * m.perPitch[1]);
  h.isToward = dz < 0;
  return h;
}

/// The same, and whether its hogels differ.
template <class Real, bool hasHogels>
struct RayMap : TwinMap<Real> {
  using TwinMap<Real>::TwinMap;
};

/// A twin whose hits are affine (Twin::isAffine): i and j in both slopes, u and v in one slope and
/// in the hogel; and whether its hogels have moves of their own, and its directions.
template <class Real, bool hasMoves, bool directions>
struct AffineMap : RealMap<Real> {
  explicit AffineMap(const HitMap& map) : RealMap<Real>(map), twin(*map.panel.twin) {
    const AffineHits hits = twin.affineHits(map.panel.eye);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      for (std::size_t k = 0; k < 3; ++k) at[axis][k] = static_cast<Real>(hits.place[axis][k]);
      for (std::size_t k = 0; k < 4; ++k)
        found[axis][k] = static_cast<Real>(hits.direction[axis][k]);
    }
    if constexpr (hasMoves) moves = twin.hogelMoves().data();
  }
  static constexpr bool isAffineTwin = true;
  static constexpr bool hasDirections = directions;

  const Twin& twin;
  std::array<std::array<Real, 3>, 2> at{};  ///< i, j: constant, of a, of b
  std::array<std::array<Real, 4>, 2>
      found{};  ///< u, v: constant, of the slope, of i or j, of j or i
  const std::array<float, 2>* moves = nullptr;
};

template <class Real>
inline __attribute__((always_inline)) RealHit<Real> hitAt(const RealMap<Real>& m, Real x, Real y) {
  return hitOf(m, x, y);
}

template <class Real, bool hasHogels>
inline __attribute__((always_inline)) RealHit<Real> hitAt(const RayMap<Real, hasHogels>& m, Real x,
                                                          Real y) {
  return meet<hasHogels>(m, x, y);
}

/// Calls `use` with the map that a twin needs (Twin::hasKernel), in double arithmetic.
template <class Use>
inline __attribute__((always_inline)) void withTwinMap(const HitMap& map, std::size_t channel,
                                                       Use use) {
  const Twin& twin = *map.panel.twin;
  const bool hasHogels = !twin.hogels().empty();
  if (!twin.isAffine())
    hasHogels ? use(RayMap<double, true>(map, channel)) : use(RayMap<double, false>(map, channel));
  else if (twin.movesHits())
    hasHogels ? use(AffineMap<double, true, true>(map)) : use(AffineMap<double, false, true>(map));
  else
    hasHogels ? use(AffineMap<double, true, false>(map))
              : use(AffineMap<double, false, false>(map));
}

/// Whether all indices are in range. It is bitwise on purpose, without branches. Returns false for
/// NaN.
template <class Real>
inline bool isSeen(const RealMap<Real>& m, const RealHit<Real>& h) {
  return static_cast<bool>(h.isToward & (h.i >= 0) & (h.i < m.count[0]) & (h.j >= 0) &
                           (h.j < m.count[1]) & (h.u >= 0) & (h.u < m.count[2]) & (h.v >= 0) &
                           (h.v < m.count[3]));
}

template <class Real>
inline std::uint32_t cellOf(Real index) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(index));
}

/// Writes three bytes for each address.
inline void packRgb(const Texel<std::uint8_t>* texels, const std::uint32_t* address, int count,
                    std::uint8_t* rgb) {
  // Whole texels are copied, each over the previous one's unused byte; the last has no room for its
  // own.
#pragma GCC unroll 8
  for (int k = 0; k + 1 < count; ++k)
    std::memcpy(rgb + std::ptrdiff_t(3) * k, texels + address[k], 4);
  if (count > 0) std::memcpy(rgb + std::ptrdiff_t(3) * (count - 1), texels + address[count - 1], 3);
}

/// The number of rays in a strip: so few that a processor works on one strip while the next one's
/// texels come from memory, and so many that their steps fill its units.
constexpr int stripSize = 32;
template <class T>
using Strip = std::array<T, stripSize>;

/// The cells of a strip; all bits of `seen` are set where the ray sees the display, none elsewhere.
struct CellStrip {
  std::array<Strip<std::uint32_t>, 4> cell;
  Strip<std::uint32_t> seen;
};

enum class Rays { any, hits };

/// Without the moves of hogels and the map of directions; `hogel` is the one that is met.
template <Rays rays, class Real, bool hasMoves, bool directions>
inline __attribute__((always_inline)) RealHit<Real> hitAt(
    const AffineMap<Real, hasMoves, directions>& m, Real x, Real y, std::int32_t& hogel) {
  const Real dx = m.right[0] * x + m.down[0] * y + m.forward[0];
  const Real dy = m.right[1] * x + m.down[1] * y + m.forward[1];
  const Real dz = m.right[2] * x + m.down[2] * y + m.forward[2];
  const Real inverse = 1 / dz;
  const Real a = dx * inverse;
  const Real b = dy * inverse;
  RealHit<Real> h;
  h.i = m.at[0][0] + m.at[0][1] * a + m.at[0][2] * b;
  h.j = m.at[1][0] + m.at[1][1] * a + m.at[1][2] * b;
  h.isToward = dz < 0;
  const auto inside = [](Real index, Real count) {
    if constexpr (rays == Rays::hits) return static_cast<std::int32_t>(index);
    const Real least = index > 0 ? index : 0;
    return static_cast<std::int32_t>(least < count - 1 ? least : count - 1);
  };
  const std::int32_t column = inside(h.i, m.count[0]);
  const std::int32_t row = inside(h.j, m.count[1]);
  const auto i = static_cast<Real>(column);
  const auto j = static_cast<Real>(row);
  h.u = m.found[0][0] + m.found[0][1] * a + m.found[0][2] * i + m.found[0][3] * j;
  h.v = m.found[1][0] + m.found[1][1] * b + m.found[1][2] * j + m.found[1][3] * i;
  hogel = row * static_cast<std::int32_t>(m.count[0]) + column;
  return h;
}

/// Finds the indices of a strip, in range or not, before the map of directions. `toward` is not 0
/// where the ray points to the panel.
template <Rays rays, class Real, bool hasMoves, bool directions>
inline __attribute__((always_inline)) void findHits(const AffineMap<Real, hasMoves, directions>& m,
                                                    const double* x, const double* y,
                                                    std::array<Strip<Real>, 4>& index,
                                                    Strip<std::uint32_t>& toward) {
  Strip<std::int32_t> hogel;
  for (std::size_t k = 0; k < stripSize; ++k) {
    std::int32_t own = 0;
    const RealHit<Real> h = hitAt<rays>(m, static_cast<Real>(x[k]),
                                        static_cast<Real>(y[rays == Rays::hits ? 0 : k]), own);
    index[0][k] = h.i;
    index[1][k] = h.j;
    index[2][k] = h.u;
    index[3][k] = h.v;
    toward[k] = h.isToward ? ~0U : 0;
    hogel[k] = own;
  }
  if constexpr (hasMoves) {
    const float* const moves = m.moves->data();
    Strip<float> moveU, moveV;
    for (std::size_t k = 0; k < stripSize; ++k) moveU[k] = moves[2 * hogel[k]];
    for (std::size_t k = 0; k < stripSize; ++k) moveV[k] = moves[2 * hogel[k] + 1];
    for (std::size_t k = 0; k < stripSize; ++k) {
      index[2][k] += static_cast<Real>(moveU[k]);
      index[3][k] += static_cast<Real>(moveV[k]);
    }
  }
}

/// The bilinear function of a direction table around the places of a strip, and how it grows for
/// each direction.
template <class Real>
struct TableStrip {
  Strip<Real> u, v, uAcross, vAcross, uDown, vDown;
};

/// The places' parts have loops of their own, because a loop of one kind of step is vectorised.
template <class Real>
inline __attribute__((always_inline)) void readTable(const float* table, const MoveTable& of,
                                                     Real perU, Real perV, const Strip<Real>& u,
                                                     const Strip<Real>& v, TableStrip<Real>& at) {
  const std::int32_t width = of.width;
  const std::int32_t lastX = of.width - 2;
  const std::int32_t lastY = of.height - 2;
  const auto across = static_cast<Real>(of.width - 1);
  const auto down = static_cast<Real>(of.height - 1);
  constexpr auto half = static_cast<Real>(0.5);
  Strip<std::int32_t> top;
  Strip<Real> fx, fy, insideX, insideY;
  for (std::size_t k = 0; k < stripSize; ++k) {
    const Real x = u[k] * perU - half;
    const Real y = v[k] * perV - half;
    const Real boundX = x > 0 ? (x < across ? x : across) : 0;
    const Real boundY = y > 0 ? (y < down ? y : down) : 0;
    const std::int32_t i = std::min(static_cast<std::int32_t>(boundX), lastX);
    const std::int32_t j = std::min(static_cast<std::int32_t>(boundY), lastY);
    fx[k] = boundX - static_cast<Real>(i);
    fy[k] = boundY - static_cast<Real>(j);
    insideX[k] = boundX == x ? perU : 0;
    insideY[k] = boundY == y ? perV : 0;
    top[k] = 2 * (j * width + i);
  }
  // Of the upper left, upper right, lower left and lower right node.
  std::array<Strip<float>, 4> nodeU, nodeV;
  const std::array<std::int32_t, 4> offset{0, 2, 2 * width, 2 * width + 2};
  for (std::size_t n = 0; n < 4; ++n) {
    const float* const from = table + offset[n];
    for (std::size_t k = 0; k < stripSize; ++k) nodeU[n][k] = from[top[k]];
    for (std::size_t k = 0; k < stripSize; ++k) nodeV[n][k] = from[top[k] + 1];
  }
  const auto blend = [&](const std::array<Strip<float>, 4>& node, Strip<Real>& value,
                         Strip<Real>& growsAcross, Strip<Real>& growsDown)
      __attribute__((always_inline)) {
    for (std::size_t k = 0; k < stripSize; ++k) {
      const auto upper = static_cast<Real>(node[0][k]);
      const auto lower = static_cast<Real>(node[2][k]);
      const Real along = static_cast<Real>(node[1][k]) - upper;
      const Real alongLower = static_cast<Real>(node[3][k]) - lower;
      const Real onUpper = upper + fx[k] * along;
      const Real onLower = lower + fx[k] * alongLower;
      value[k] = onUpper + fy[k] * (onLower - onUpper);
      growsAcross[k] = insideX[k] * (along + fy[k] * (alongLower - along));
      growsDown[k] = insideY[k] * (onLower - onUpper);
    }
  };
  blend(nodeU, at.u, at.uAcross, at.uDown);
  blend(nodeV, at.v, at.vAcross, at.vDown);
}

/// Finds the indices of a strip of a twin with a map of directions: from the table of its inverse
/// by two of Newton's steps, and by Twin::moved() where these do not suffice.
template <class Map, class Real>
inline __attribute__((always_inline)) void findMoved(const Map& m, const double* x, const double* y,
                                                     std::array<Strip<Real>, 4>& index,
                                                     Strip<std::uint32_t>& seen) {
  const MoveTable& table = m.twin.directionTable();
  const Real perU = static_cast<Real>(table.width) / m.count[2];
  const Real perV = static_cast<Real>(table.height) / m.count[3];
  Strip<Real> designU, designV;
  findHits<Rays::any>(m, x, y, index, seen);
  for (std::size_t k = 0; k < stripSize; ++k) {
    const bool isOnPanel =
        static_cast<bool>((seen[k] != 0) & (index[0][k] >= 0) & (index[0][k] < m.count[0]) &
                          (index[1][k] >= 0) & (index[1][k] < m.count[1]));
    index[0][k] = isOnPanel ? index[0][k] : -1;
    designU[k] = isOnPanel ? index[2][k] : 0;
    designV[k] = isOnPanel ? index[3][k] : 0;
  }
  TableStrip<Real> at;
  readTable(table.back.data(), table, perU, perV, designU, designV, at);
  auto& foundU = index[2];
  auto& foundV = index[3];
  for (std::size_t k = 0; k < stripSize; ++k) {
    foundU[k] = designU[k] + at.u[k];
    foundV[k] = designV[k] + at.v[k];
  }
  Strip<Real> rest;
  for (int step = 0; step < 2; ++step) {
    readTable(table.moves.data(), table, perU, perV, foundU, foundV, at);
    for (std::size_t k = 0; k < stripSize; ++k) {
      const Real restU = designU[k] - foundU[k] - at.u[k];
      const Real restV = designV[k] - foundV[k] - at.v[k];
      rest[k] = std::max(std::abs(restU), std::abs(restV));
      const Real acrossU = 1 + at.uAcross[k];
      const Real downV = 1 + at.vDown[k];
      const Real perDeterminant = 1 / (acrossU * downV - at.uDown[k] * at.vAcross[k]);
      foundU[k] += (restU * downV - restV * at.uDown[k]) * perDeterminant;
      foundV[k] += (restV * acrossU - restU * at.vAcross[k]) * perDeterminant;
    }
  }
  // Before the last step; a cell of the map that was left meanwhile makes it no better than this.
  constexpr auto enough = static_cast<Real>(1e-6);
  for (std::size_t k = 0; k < stripSize; ++k) {
    if (rest[k] <= enough || index[0][k] < 0) continue;
    const Hit moved = m.twin.moved(
        {double(index[0][k]), double(index[1][k]), double(designU[k]), double(designV[k])});
    foundU[k] = static_cast<Real>(moved.u);
    foundV[k] = static_cast<Real>(moved.v);
  }
  for (std::size_t k = 0; k < stripSize; ++k) {
    const RealHit<Real> h{index[0][k], index[1][k], foundU[k], foundV[k], true};
    const bool isHit = isSeen(m, h);
    for (auto& axis : index) axis[k] = isHit ? axis[k] : 0;
    seen[k] = isHit ? ~0U : 0;
  }
}

/// Finds the indices of a strip of an affine twin, 0 where nothing is seen.
template <Rays rays, class Map, class Real>
inline __attribute__((always_inline)) void findAffine(const Map& m, const double* x,
                                                      const double* y,
                                                      std::array<Strip<Real>, 4>& index,
                                                      Strip<std::uint32_t>& seen) {
  if constexpr (Map::hasDirections) {
    findMoved(m, x, y, index, seen);
  } else {
    findHits<rays>(m, x, y, index, seen);
    if constexpr (rays == Rays::hits) return;
    for (std::size_t k = 0; k < stripSize; ++k) {
      const RealHit<Real> h{index[0][k], index[1][k], index[2][k], index[3][k], seen[k] != 0};
      const bool isHit = isSeen(m, h);
      for (auto& axis : index) axis[k] = isHit ? axis[k] : 0;
      seen[k] = isHit ? ~0U : 0;
    }
  }
}

/// Finds the cells of a strip; Rays::hits have one y. The indices have a loop, and the cells of
/// each axis have one: a processor overlaps the iterations of short loops better than those of one
/// long loop.
template <Rays rays, class Map>
inline __attribute__((always_inline)) void findStrip(const Map& m, const double* x, const double* y,
                                                     CellStrip& strip) {
  using Real = typename Map::Number;
  std::array<Strip<Real>, 4> index;
  if constexpr (Map::isAffineTwin) {
    findAffine<rays>(m, x, y, index, strip.seen);
  } else
    for (std::size_t k = 0; k < stripSize; ++k) {
      const RealHit<Real> h =
          hitAt(m, static_cast<Real>(x[k]), static_cast<Real>(y[rays == Rays::hits ? 0 : k]));
      const bool seen = rays == Rays::hits || isSeen(m, h);
      index[0][k] = seen ? h.i : 0;
      index[1][k] = seen ? h.j : 0;
      index[2][k] = seen ? h.u : 0;
      index[3][k] = seen ? h.v : 0;
      strip.seen[k] = seen ? ~0U : 0;
    }
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const auto last = static_cast<std::uint32_t>(m.count[axis]) - 1;
    for (std::size_t k = 0; k < stripSize; ++k) {
      const std::uint32_t cell = cellOf(index[axis][k]);
      strip.cell[axis][k] = rays == Rays::hits ? std::min(cell, last) : cell;
    }
  }
}

/// Finds and prefetches the addresses of at most a strip of rays.
template <Rays rays, class Map>
inline __attribute__((always_inline)) void findAddresses(const Map& m, const BlockLayout& l,
                                                         const Texel<std::uint8_t>* texels,
                                                         const double* x, const double* y,
                                                         int count, std::uint32_t* address,
                                                         std::uint8_t* seen) {
  Strip<double> paddedX;
  Strip<double> paddedY;
  if (count < stripSize) {
    paddedX.fill(x[0]);
    paddedY.fill(y[0]);
    std::copy_n(x, count, paddedX.begin());
    if constexpr (rays == Rays::any) std::copy_n(y, count, paddedY.begin());
    x = paddedX.data();
    y = paddedY.data();
  }
  CellStrip strip;
  findStrip<rays>(m, x, y, strip);
  for (std::size_t k = 0; k < stripSize; ++k) {
    const std::uint32_t found = l.i.inBlocks(strip.cell[0][k]) + l.j.inBlocks(strip.cell[1][k]) +
                                l.u.inBlocks(strip.cell[2][k]) + l.v.inBlocks(strip.cell[3][k]);
    address[k] = rays == Rays::hits || strip.seen[k] != 0 ? found : l.texels;
  }
#pragma GCC unroll 8
  for (int k = 0; k < count; ++k) __builtin_prefetch(texels + address[k]);
  if constexpr (rays == Rays::any)
    for (int k = 0; k < count; ++k) seen[k] = static_cast<std::uint8_t>(strip.seen[std::size_t(k)]);
}

/// Copies a texel for each ray, whose address is found `ahead` rays before, so that it has come
/// from memory by then.
template <Rays rays, class Map>
inline __attribute__((always_inline)) void copyTexels(const Map& map, const BlockLayout& layout,
                                                      const Texel<std::uint8_t>* texels,
                                                      const double* x, const double* y, int count,
                                                      std::uint8_t* rgb, std::uint8_t* seen) {
  constexpr int ahead = 128;
  const Map m(map);  // a copy, so that the compiler knows that stores do not change it
  const BlockLayout l = layout;
  std::array<std::uint32_t, 2 * ahead> address;
  const auto strip = [&](int first) { return &address[std::size_t(first % (2 * ahead))]; };
  for (int first = 0; first < count + ahead; first += stripSize) {
    if (first < count)
      findAddresses<rays>(m, l, texels, x + first, rays == Rays::hits ? y : y + first,
                          std::min(stripSize, count - first), strip(first),
                          rays == Rays::hits ? nullptr : seen + first);
    const int done = first - ahead;
    if (done >= 0)
      packRgb(texels, strip(done), std::min(stripSize, count - done),
              rgb + std::ptrdiff_t(3) * done);
  }
}

/// The indices of a batch; 0 where nothing is seen.
template <class Real>
struct IndexBatch {
  std::array<std::array<Real, batchSize>, 4> index;
  std::array<std::uint32_t, batchSize> seen;
};

template <class Real>
inline void keep(const RealMap<Real>& m, const RealHit<Real>& h, std::size_t k,
                 IndexBatch<Real>& batch) {
  const bool seen = isSeen(m, h);
  batch.index[0][k] = seen ? h.i : 0;
  batch.index[1][k] = seen ? h.j : 0;
  batch.index[2][k] = seen ? h.u : 0;
  batch.index[3][k] = seen ? h.v : 0;
  batch.seen[k] = seen ? 255 : 0;
}

template <class Real>
inline __attribute__((always_inline)) void split(const IndexBatch<Real>& from, int count,
                                                 CellBatch& batch) {
  const auto rays = std::size_t(count);
  for (std::size_t axis = 0; axis < 4; ++axis)
    for (std::size_t k = 0; k < rays; ++k) {
      const Real index = from.index[axis][k];
      const auto cell = static_cast<std::int32_t>(index);
      batch.cell[axis][k] = static_cast<std::uint32_t>(cell);
      batch.place[axis][k] = static_cast<float>(index - static_cast<Real>(cell));
    }
  for (std::size_t k = 0; k < rays; ++k) batch.seen[k] = static_cast<std::uint8_t>(from.seen[k]);
}

template <class Real>
inline __attribute__((always_inline)) void cellsIn(const HitMap& map, const double* x,
                                                   const double* y, int count, CellBatch& batch) {
  const RealMap<Real> m(map);
  IndexBatch<Real> found;
  for (std::size_t k = 0; k < std::size_t(count); ++k)
    keep(m, hitOf(m, static_cast<Real>(x[k]), static_cast<Real>(y[k])), k, found);
  split(found, count, batch);
}

MULTIVERSIONED
void linearCells(const HitMap& map, const double* x, const double* y, int count, CellBatch& batch) {
  if (map.isSingle)
    cellsIn<float>(map, x, y, count, batch);
  else
    cellsIn<double>(map, x, y, count, batch);
}

template <class Real>
void curvedCells(const HitMap& map, const double* x, const double* y, int count, CellBatch& batch) {
  const RealMap<Real> m(map);
  const auto [across, down] = map.panel.lenses;
  const auto directionOf = [](const HogelLens* lens, Real slope) {
    return static_cast<Real>(lens->directionOf(static_cast<double>(slope)));
  };
  constexpr auto half = static_cast<Real>(0.5);
  IndexBatch<Real> found;
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    RealHit<Real> h = hitOf(m, static_cast<Real>(x[k]), static_cast<Real>(y[k]));
    h.u = m.count[2] * (half + directionOf(across, h.u));
    h.v = m.count[3] * (half - directionOf(down, h.v));
    keep(m, h, k, found);
  }
  split(found, count, batch);
}

/// The hits of a twin's surface or lenses, one by one.
void metCells(const HitMap& map, const double* x, const double* y, int count, std::size_t channel,
              CellBatch& batch) {
  const RealMap<double> m(map);
  IndexBatch<double> found;
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    const auto along = [&](std::size_t c) {
      return x[k] * map.right[c] + y[k] * map.down[c] + map.forward[c];
    };
    const std::optional<Hit> hit =
        map.panel.twin->meet(map.panel.eye, {along(0), along(1), along(2)}, channel);
    const Hit met = hit.value_or(Hit{});
    keep(m, RealHit<double>{met.i, met.j, met.u, met.v, hit.has_value()}, k, found);
  }
  split(found, count, batch);
}

/// Fills a batch with strips of an affine twin.
template <class Map, class Real>
inline __attribute__((always_inline)) void affineCells(const Map& m, const double* x,
                                                       const double* y, int count,
                                                       IndexBatch<Real>& found) {
  for (int first = 0; first < count; first += stripSize) {
    const auto rays = std::size_t(std::min(stripSize, count - first));
    Strip<double> stripX, stripY;
    stripX.fill(x[first]);
    stripY.fill(y[first]);
    std::copy_n(x + first, rays, stripX.begin());
    std::copy_n(y + first, rays, stripY.begin());
    std::array<Strip<Real>, 4> index;
    Strip<std::uint32_t> seen;
    findAffine<Rays::any>(m, stripX.data(), stripY.data(), index, seen);
    for (std::size_t axis = 0; axis < 4; ++axis)
      std::copy_n(index[axis].begin(), rays, found.index[axis].begin() + first);
    for (std::size_t k = 0; k < rays; ++k)
      found.seen[std::size_t(first) + k] = seen[k] != 0 ? 255 : 0;
  }
}

MULTIVERSIONED
void kernelCells(const HitMap& map, const double* x, const double* y, int count,
                 std::size_t channel, CellBatch& batch) {
  IndexBatch<double> found;
  withTwinMap(
      map, channel, [&](const auto& m) __attribute__((always_inline)) {
        if constexpr (std::decay_t<decltype(m)>::isAffineTwin)
          return affineCells(m, x, y, count, found);
        else
          for (std::size_t k = 0; k < std::size_t(count); ++k)
            keep(m, hitAt(m, x[k], y[k]), k, found);
      });
  split(found, count, batch);
}

void twinCells(const HitMap& map, const double* x, const double* y, int count, std::size_t channel,
               CellBatch& batch) {
  if (map.panel.twin->hasKernel())
    kernelCells(map, x, y, count, channel, batch);
  else
    metCells(map, x, y, count, channel, batch);
}

}  // namespace

MULTIVERSIONED
void copyHits(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
              const double* x, double y, int count, std::uint8_t* rgb) {
  if (map.isSingle)
    copyTexels<Rays::hits>(RealMap<float>(map), layout, texels, x, &y, count, rgb, nullptr);
  else
    copyTexels<Rays::hits>(RealMap<double>(map), layout, texels, x, &y, count, rgb, nullptr);
}

MULTIVERSIONED
void copyRays(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
              const double* x, const double* y, int count, std::uint8_t* rgb, std::uint8_t* seen) {
  if (map.isSingle)
    copyTexels<Rays::any>(RealMap<float>(map), layout, texels, x, y, count, rgb, seen);
  else
    copyTexels<Rays::any>(RealMap<double>(map), layout, texels, x, y, count, rgb, seen);
}

MULTIVERSIONED
void copyTwinRays(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                  const double* x, const double* y, int count, std::uint8_t* rgb,
                  std::uint8_t* seen) {
  withTwinMap(
      map, greenChannel, [&](const auto& m) __attribute__((always_inline)) {
        copyTexels<Rays::any>(m, layout, texels, x, y, count, rgb, seen);
      });
}

MULTIVERSIONED
void copyTwinHits(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                  const double* x, double y, int count, std::uint8_t* rgb) {
  if (map.panel.twin->hogels().empty())
    copyTexels<Rays::hits>(AffineMap<double, false, false>(map), layout, texels, x, &y, count, rgb,
                           nullptr);
  else
    copyTexels<Rays::hits>(AffineMap<double, true, false>(map), layout, texels, x, &y, count, rgb,
                           nullptr);
}

void findCells(const HitMap& map, const double* x, const double* y, int count, CellBatch& batch,
               std::size_t channel) {
  if (map.panel.twin != nullptr)
    twinCells(map, x, y, count, channel, batch);
  else if (map.panel.lenses[0] == nullptr)
    linearCells(map, x, y, count, batch);
  else if (map.isSingle)
    curvedCells<float>(map, x, y, count, batch);
  else
    curvedCells<double>(map, x, y, count, batch);
}

bool fillUnseen(int count, CellBatch& batch) {
  const auto end = batch.seen.begin() + count;
  if (count == batchSize && std::find(batch.seen.begin(), end, std::uint8_t{0}) == end) return true;
  const auto hit = std::find(batch.seen.begin(), end, std::uint8_t{255});
  if (hit == end) return false;
  std::fill(end, batch.seen.end(), std::uint8_t{0});
  const auto at = std::size_t(hit - batch.seen.begin());
  for (auto& cell : batch.cell)
    for (std::size_t k = 0; k < batchSize; ++k) cell[k] = batch.seen[k] == 0 ? cell[at] : cell[k];
  return true;
}

}  // namespace hogelscope
