// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/twin_kernels.h"

#include <bit>
#include <cmath>
#include <optional>
#include <type_traits>

#include "core/base/multiversioned.h"
#include "core/engine/ray_strips.h"
#include "core/panel/twin.h"

namespace hogelscope {

namespace {

/// The numbers of a twin whose lenses are linear, on a plane.
struct TwinMap : RealMap<double> {
  TwinMap(const HitMap& m, std::size_t channel)
      : RealMap<double>(m),
        array(m.panel.twin->lensArray()),
        hogels(m.panel.twin->hogels().data()),
        scale(m.panel.twin->scaleOf(channel)),
        eye(m.panel.eye),
        off{array.middle[0] - array.design[0], array.middle[1] - array.design[1]},
        offI{array.middleI[0] - array.pitch[0], array.middleI[1]},
        offJ{array.middleJ[0], array.middleJ[1] + array.pitch[1]},
        perPitch{1 / array.pitch[0], 1 / array.pitch[1]},
        perField{1 / array.field[0], 1 / array.field[1]} {}

  LensArrayMap array;
  const HogelErrors* hogels;
  double scale;
  Vec3 eye;
  /// How far a lens is from its tile, and what that grows by for each hogel to the right, and down.
  std::array<double, 2> off, offI, offJ;
  std::array<double, 2> perPitch, perField;
};

/// As Twin::meet().
template <bool hasHogels>
inline __attribute__((always_inline)) RealHit<double> meet(const TwinMap& m, double rayX,
                                                           double rayY) {
  const LensArrayMap& array = m.array;
  const auto [a, b, isToward] = slopesOf(m, rayX, rayY);
  const double x = m.eye.x - m.eye.z * a;
  const double y = m.eye.y - m.eye.z * b;
  RealHit<double> h;
  h.i = array.cell[0] + array.cellX[0] * x + array.cellY[0] * y;
  h.j = array.cell[1] + array.cellX[1] * x + array.cellY[1] * y;
  const auto inside = [](double index, double count) {
    const double least = index > 0 ? index : 0;
    return static_cast<std::int32_t>(least < count - 1 ? least : count - 1);
  };
  const std::int32_t column = inside(h.i, m.count[0]);
  const std::int32_t row = inside(h.j, m.count[1]);
  const double i = column;
  const double j = row;
  double offX = m.off[0] + i * m.offI[0] + j * m.offJ[0];
  double offY = m.off[1] + i * m.offI[1] + j * m.offJ[1];
  double gap = 1 + array.gap + array.wedge[0] * x + array.wedge[1] * y;
  double turnedA = a + array.convergence * x;
  double turnedB = b + array.convergence * y;
  if constexpr (hasHogels) {
    const HogelErrors& own = m.hogels[row * static_cast<std::int32_t>(m.count[0]) + column];
    offX += double(own.shiftX);
    offY += double(own.shiftY);
    gap += double(own.gap);
    turnedA -= double(own.tiltX);
    turnedB -= double(own.tiltY);
  }
  const double blur = gap / (1 + array.focal) - 1;
  const double fromX = x - (array.middle[0] + i * array.middleI[0] + j * array.middleJ[0]);
  const double fromY = y - (array.middle[1] + i * array.middleI[1] + j * array.middleJ[1]);
  const double scale = m.scale * gap;
  h.u =
      m.count[2] * (0.5 + scale * turnedA * m.perField[0] + (blur * fromX - offX) * m.perPitch[0]);
  h.v =
      m.count[3] * (0.5 - scale * turnedB * m.perField[1] - (blur * fromY - offY) * m.perPitch[1]);
  h.isToward = isToward;
  return h;
}

/// A function that is linear over the image plane: for each unit of x, of y, and a constant.
using Linear = std::array<double, 3>;

/// An affine twin (Twin::isAffine). Its indices are quotients of linear functions; u and v also
/// depend on the hogel that is met.
struct AffineMap : RealMap<double> {
  explicit AffineMap(const HitMap& m)
      : RealMap<double>(m),
        moves(m.panel.twin->hogelMoves().data()),
        table(&m.panel.twin->directionTable()),
        back(table->back().data()),
        z{m.right[2], m.down[2], m.forward[2]} {
    const auto over = [&](double start, double ofA, double ofB) {
      const auto along = [&](const std::array<double, 3>& d) {
        return ofA * d[0] + ofB * d[1] + start * d[2];
      };
      return Linear{along(m.right), along(m.down), along(m.forward)};
    };
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto& [startOfPlace, ofA, ofB] = m.panel.affine.place[axis];
      index[axis] = over(startOfPlace, ofA, ofB);
      const auto& [startOf, ofSlope, ofOwn, ofOther] = m.panel.affine.direction[axis];
      index[axis + 2] = axis == 0 ? over(startOf, ofSlope, 0) : over(startOf, 0, ofSlope);
      own[axis] = ofOwn;
      other[axis] = ofOther;
      beyond[axis] = table->largest()[axis];
      error[axis] = table->error()[axis];
    }
    perDirection = table->perDirection();
  }

  const MoveTable::Pair* moves;
  const MoveTable* table;
  const MoveTable::Pair* back;
  int perDirection = 1;
  Linear z;
  std::array<Linear, 4> index{};   ///< i, j, u, v; times z
  std::array<double, 2> own{};     ///< what u and v grow by for each hogel along their axis
  std::array<double, 2> other{};   ///< and across it
  std::array<double, 2> beyond{};  ///< how far beyond the field a hit may be moved into it
  std::array<double, 2> error{};   ///< of `back`
};

/// What one ray meets, before its hogel's move and the map of directions. The indices are of no use
/// if the panel is not met.
struct AffineHit {
  double i;
  double j;
  double u;
  double v;
  std::int32_t column;
  std::int32_t row;
  bool isOn;  ///< the panel is met, in or out of the field
};

template <Rays rays>
inline __attribute__((always_inline)) AffineHit hitOf(const AffineMap& m, double x, double y) {
  const auto at = [&](const Linear& f) __attribute__((always_inline)) {
    return f[0] * x + (f[1] * y + f[2]);
  };
  const double perZ = 1 / at(m.z);
  AffineHit h;
  h.i = at(m.index[0]) * perZ;
  h.j = at(m.index[1]) * perZ;
  h.isOn = rays == Rays::hits || static_cast<bool>((perZ < 0) & (h.i >= 0) & (h.i < m.count[0]) &
                                                   (h.j >= 0) & (h.j < m.count[1]));
  h.column = static_cast<std::int32_t>(h.isOn ? h.i : 0);
  h.row = static_cast<std::int32_t>(h.isOn ? h.j : 0);
  h.u = at(m.index[2]) * perZ + (m.own[0] * h.column + m.other[0] * h.row);
  h.v = at(m.index[3]) * perZ + (m.own[1] * h.row + m.other[1] * h.column);
  return h;
}

/// All that one ray meets.
template <bool hasMoves, bool hasDirections>
inline __attribute__((always_inline)) RealHit<double> wholeHit(const AffineMap& m, double x,
                                                               double y) {
  const AffineHit h = hitOf<Rays::any>(m, x, y);
  RealHit<double> whole{h.i, h.j, h.u, h.v, h.isOn};
  if constexpr (hasMoves) {
    const MoveTable::Pair& move = m.moves[h.row * static_cast<std::int32_t>(m.count[0]) + h.column];
    whole.u += double(move[0]);
    whole.v += double(move[1]);
  }
  if (hasDirections && h.isOn) {
    const std::array<double, 2> turned = m.table->solve(whole.u, whole.v);
    whole.u = turned[0];
    whole.v = turned[1];
  }
  return whole;
}

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

/// Finds the indices of a strip before the map of directions.
template <Rays rays, bool hasMoves>
inline __attribute__((always_inline)) void meetStrip(const AffineMap& m, const double* x,
                                                     const double* y, AffineStrip& s) {
  Strip<std::int32_t> hogel;
  const auto columns = static_cast<std::int32_t>(m.count[0]);
  for (std::size_t k = 0; k < stripSize; ++k) {
    const AffineHit h = hitOf<rays>(m, x[k], y[rays == Rays::any ? k : 0]);
    s.u[k] = h.u;
    s.v[k] = h.v;
    s.column[k] = h.column;
    s.row[k] = h.row;
    s.isOn[k] = h.isOn ? ~0U : 0;
    hogel[k] = h.row * columns + h.column;
  }
  if constexpr (hasMoves) addPairs(m.moves, hogel, s);
}

/// Inverts the map of directions, so that u and v are in their cells: by the table, and where that
/// may err, by Newton's steps.
template <Rays rays>
inline __attribute__((always_inline)) void turnBack(const AffineMap& m, AffineStrip& s) {
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
    const bool isNear =
        rays == Rays::hits ||
        static_cast<bool>((s.isOn[k] != 0) & (u >= -m.beyond[0]) & (u < m.count[2] + m.beyond[0]) &
                          (v >= -m.beyond[1]) & (v < m.count[3] + m.beyond[1]));
    const double insideU = rays == Rays::hits ? u : std::min(std::max(0.0, u), lastU);
    const double insideV = rays == Rays::hits ? v : std::min(std::max(0.0, v), lastV);
    designU[k] = u;
    designV[k] = v;
    isUnsure[k] = isNear & ((insideU != u) | (insideV != v)) ? 1 : 0;
    s.isOn[k] = isNear ? s.isOn[k] : 0;
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
      const std::array<double, 2> found = m.table->solve(designU[k], designV[k]);
      s.u[k] = found[0];
      s.v[k] = found[1];
    }
  }
}

inline __attribute__((always_inline)) bool isInField(const AffineMap& m, const AffineStrip& s,
                                                     std::size_t k) {
  return static_cast<bool>((s.isOn[k] != 0) & (s.u[k] >= 0) & (s.u[k] < m.count[2]) &
                           (s.v[k] >= 0) & (s.v[k] < m.count[3]));
}

/// Finds the cells of a strip of rays of an affine twin.
template <Rays rays, bool hasMoves, bool hasDirections>
struct FindAffine {
  AffineMap m;
  __attribute__((always_inline)) void operator()(const double* x, const double* y,
                                                 CellStrip& strip) const {
    AffineStrip s;
    meetStrip<rays, hasMoves>(m, x, y, s);
    if constexpr (hasDirections) turnBack<rays>(m, s);
    for (std::size_t k = 0; k < stripSize; ++k) {
      const bool isSeen = rays == Rays::hits || isInField(m, s, k);
      strip.cell[0][k] = static_cast<std::uint32_t>(s.column[k]);
      strip.cell[1][k] = static_cast<std::uint32_t>(s.row[k]);
      strip.cell[2][k] = cellOf(isSeen ? s.u[k] : 0);
      strip.cell[3][k] = cellOf(isSeen ? s.v[k] : 0);
      strip.seen[k] = isSeen ? ~0U : 0;
    }
  }
};

/// The same for a twin that is not affine.
template <bool hasHogels>
struct FindMet {
  TwinMap m;
  __attribute__((always_inline)) void operator()(const double* x, const double* y,
                                                 CellStrip& strip) const {
    for (std::size_t k = 0; k < stripSize; ++k) {
      const RealHit<double> h = meet<hasHogels>(m, x[k], y[k]);
      const bool seen = isSeen(m, h);
      strip.cell[0][k] = cellOf(seen ? h.i : 0);
      strip.cell[1][k] = cellOf(seen ? h.j : 0);
      strip.cell[2][k] = cellOf(seen ? h.u : 0);
      strip.cell[3][k] = cellOf(seen ? h.v : 0);
      strip.seen[k] = seen ? ~0U : 0;
    }
  }
};

/// Calls `use` with whether an affine twin's hogels have moves, and whether it has a map of
/// directions.
template <class Use>
inline __attribute__((always_inline)) void withAffine(const Twin& twin, Use use) {
  using Yes = std::true_type;
  using No = std::false_type;
  const bool hasMoves = !twin.hogelMoves().empty();
  if (twin.movesHits())
    hasMoves ? use(Yes{}, Yes{}) : use(No{}, Yes{});
  else
    hasMoves ? use(Yes{}, No{}) : use(No{}, No{});
}

/// Copies the texels of columns [first, last) one by one; of few, since a strip takes longer.
template <bool hasMoves, bool hasDirections>
inline __attribute__((always_inline)) void copyOneByOne(
    const AffineMap& m, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
    const double* x, double y, int first, int last, std::uint8_t* rgb, std::uint8_t* seen) {
  for (int k = first; k < last; ++k) {
    const RealHit<double> h = wholeHit<hasMoves, hasDirections>(m, x[k], y);
    if (!isSeen(m, h)) continue;
    const std::uint32_t address = layout.i.inBlocks(cellOf(h.i)) + layout.j.inBlocks(cellOf(h.j)) +
                                  layout.u.inBlocks(cellOf(h.u)) + layout.v.inBlocks(cellOf(h.v));
    std::memcpy(rgb + std::ptrdiff_t(3) * k, texels + address, 3);
    seen[k] = 255;
  }
}

template <bool hasHogels>
inline __attribute__((always_inline)) void metCells(const HitMap& map, const double* x,
                                                    const double* y, int count, std::size_t channel,
                                                    IndexBatch<double>& found) {
  const TwinMap m(map, channel);
  for (std::size_t k = 0; k < std::size_t(count); ++k)
    keep(m, meet<hasHogels>(m, x[k], y[k]), k, found);
}

template <bool hasMoves, bool hasDirections>
inline __attribute__((always_inline)) void affineCells(const AffineMap& m, const double* x,
                                                       const double* y, int count,
                                                       IndexBatch<double>& found) {
  for (std::size_t k = 0; k < std::size_t(count); ++k)
    keep(m, wholeHit<hasMoves, hasDirections>(m, x[k], y[k]), k, found);
}

MULTIVERSIONED
void kernelCells(const HitMap& map, const double* x, const double* y, int count,
                 std::size_t channel, IndexBatch<double>& found) {
  const Twin& twin = *map.panel.twin;
  if (twin.isAffine())
    withAffine(
        twin, [&](auto hasMoves, auto hasDirections) __attribute__((always_inline)) {
          affineCells<hasMoves.value, hasDirections.value>(AffineMap(map), x, y, count, found);
        });
  else if (twin.hogels().empty())
    metCells<false>(map, x, y, count, channel, found);
  else
    metCells<true>(map, x, y, count, channel, found);
}

/// The hits of a twin's surface or lenses, one by one.
void slowCells(const HitMap& map, const double* x, const double* y, int count, std::size_t channel,
               IndexBatch<double>& found) {
  const RealMap<double> m(map);
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    const auto along = [&](std::size_t c) {
      return x[k] * map.right[c] + y[k] * map.down[c] + map.forward[c];
    };
    const std::optional<Hit> hit =
        map.panel.twin->meet(map.panel.eye, {along(0), along(1), along(2)}, channel);
    const Hit met = hit.value_or(Hit{});
    keep(m, RealHit<double>{met.i, met.j, met.u, met.v, hit.has_value()}, k, found);
  }
}

}  // namespace

MULTIVERSIONED
void copyTwinRays(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                  const double* x, const double* y, int count, std::uint8_t* rgb,
                  std::uint8_t* seen) {
  const Twin& twin = *map.panel.twin;
  const RayRow row{x, y, count, rgb, seen};
  const auto copy = [&](const auto& find) __attribute__((always_inline)) {
    copyTexels<Rays::any>(find, layout, texels, std::span(&row, 1));
  };
  if (twin.isAffine())
    withAffine(
        twin, [&](auto hasMoves, auto hasDirections) __attribute__((always_inline)) {
          copy(FindAffine<Rays::any, hasMoves.value, hasDirections.value>{AffineMap(map)});
        });
  else if (twin.hogels().empty())
    copy(FindMet<false>{TwinMap(map, greenChannel)});
  else
    copy(FindMet<true>{TwinMap(map, greenChannel)});
}

MULTIVERSIONED
void copyTwinRow(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                 const double* x, double y, const std::array<int, 4>& parts, std::uint8_t* rgb,
                 std::uint8_t* seen) {
  const int left = parts[1] - parts[0];
  const int begin = parts[2] - parts[0];
  const int end = parts[3] - parts[0];
  const AffineMap m(map);
  withAffine(
      *map.panel.twin, [&](auto hasMoves, auto hasDirections) __attribute__((always_inline)) {
        const RayRow hits{x + left, &y, begin - left, rgb + std::ptrdiff_t(3) * left, nullptr};
        copyTexels<Rays::hits>(FindAffine<Rays::hits, hasMoves.value, hasDirections.value>{m},
                               layout, texels, std::span(&hits, 1));
        std::memset(seen + left, 255, std::size_t(begin - left));
        const auto copyEnd = [&](int first, int last) __attribute__((always_inline)) {
          constexpr int few = 12;
          if (last - first > few) {
            const RayRow rays{x + first, &y, last - first, rgb + std::ptrdiff_t(3) * first,
                              seen + first};
            return copyTexels<Rays::row>(
                FindAffine<Rays::row, hasMoves.value, hasDirections.value>{m}, layout, texels,
                std::span(&rays, 1));
          }
          copyOneByOne<hasMoves.value, hasDirections.value>(m, layout, texels, x, y, first, last,
                                                            rgb, seen);
        };
        copyEnd(0, left);
        copyEnd(begin, end);
      });
}

void findTwinCells(const HitMap& map, const double* x, const double* y, int count,
                   std::size_t channel, CellBatch& batch) {
  IndexBatch<double> found;
  if (map.panel.twin->hasKernel())
    kernelCells(map, x, y, count, channel, found);
  else
    slowCells(map, x, y, count, channel, found);
  split(found, count, batch);
}

}  // namespace hogelscope
