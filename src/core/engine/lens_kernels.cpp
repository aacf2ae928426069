// SPDX-License-Identifier: BSD-3-Clause
// Where the polynomials decide a cell, the points that they stand for have the same one: so sums
// may be contracted to fused steps here.
#include "core/engine/lens_kernels.h"

#include <algorithm>
#include <cmath>

#include "core/base/multiversioned.h"
#include "core/engine/ray_strips.h"
#include "core/engine/row_kernels.h"

namespace hogelscope {

static_assert(stripSize == LensStrips::pixels);

std::optional<FixedMap> FixedMap::of(const HitMap& map) {
  FixedMap fixed;
  fixed.map = map;
  const auto [nx, ny, du, dv] = map.panel.count;
  const double most = std::max({nx, ny, du, dv});
  if (!(most >= 1 && most < 1 << 20)) return std::nullopt;
  // So that sums of indices below 2^30 and of what a strip adds, below 2^29, are whole numbers of
  // 32 bits, and a strip whose middle is beyond 2^30 has no ray within the display.
  fixed.shift = std::min(20, 28 - std::ilogb(most));
  fixed.mostDoubt = std::ldexp(1, fixed.shift - 13);
  const double units = std::ldexp(1, fixed.shift);
  for (std::size_t axis = 0; axis < 4; ++axis) {
    fixed.constant[axis] = units * map.panel.constant[axis];
    fixed.slope[axis] = units * map.panel.slope[axis];
    fixed.end[axis] = units * map.panel.count[axis];
  }
  for (std::size_t c = 0; c < 2; ++c)
    fixed.perHogel[c] = static_cast<float>(fixed.slope[c + 2] / fixed.slope[c]);
  return fixed;
}

namespace {

template <class T>
using OfStrips = std::array<T, LensStrips::count>;

using Terms = std::array<double, LensStrips::terms>;
using FloatTerms = std::array<OfStrips<float>, LensStrips::terms>;

/// The indices of strips' rays: those of a strip's middle, to which float polynomials add hogels,
/// and directions in proportion. Sums are `doubt` units too large: a ray that is more than 2 doubt
/// units past its cell's border is in that cell for certain.
struct StripMaps {
  std::array<OfStrips<std::int32_t>, 4> middle;
  FloatTerms i;  ///< the constant is 0
  FloatTerms j;
  std::array<OfStrips<std::uint32_t>, 2> doubt;  ///< of hogels, of directions
  OfStrips<std::uint32_t> isKnown;  ///< 0: too many rays of the strip would be in doubt
  OfStrips<std::uint32_t> mayHit;
  OfStrips<std::uint32_t> mayMiss;
};

inline __attribute__((always_inline)) double within(double value, double limit) {
  const double raised = value > -limit ? value : -limit;
  return raised < limit ? raised : limit;
}

/// The polynomial q(t) = n(t)/z(t), where n has no constant, for |t| ≤ 1.
struct Quotient {
  double q1, q2, q3, q4, q5;
  double around;    ///< the most that it is
  double rounding;  ///< its error in units of float: the term of t^m has 2 m + 1 steps
  double tail;      ///< how far it is from the quotient at most
};

/// Divides power series, written out so that the compiler makes vectors of several strips. What is
/// left, n - z q, begins with t^6: products of z's and q's terms whose powers are 6 or more.
/// `sizeZ` has |z|'s terms, and `perNearest` is 1 over the least |z|.
inline __attribute__((always_inline)) Quotient quotient(const Terms& n, const Terms& z,
                                                        const Terms& sizeZ, double perZ,
                                                        double perNearest) {
  const auto& [n0, n1, n2, n3, n4, n5] = n;
  const auto& [z0, z1, z2, z3, z4, z5] = z;
  const double q1 = n1 * perZ;
  const double q2 = (n2 - z1 * q1) * perZ;
  const double q3 = (n3 - z1 * q2 - z2 * q1) * perZ;
  const double q4 = (n4 - z1 * q3 - z2 * q2 - z3 * q1) * perZ;
  const double q5 = (n5 - z1 * q4 - z2 * q3 - z3 * q2 - z4 * q1) * perZ;
  const double from5 = std::abs(q5);
  const double from4 = std::abs(q4) + from5;
  const double from3 = std::abs(q3) + from4;
  const double from2 = std::abs(q2) + from3;
  const double from1 = std::abs(q1) + from2;
  const double left =
      sizeZ[1] * from5 + sizeZ[2] * from4 + sizeZ[3] * from3 + sizeZ[4] * from2 + sizeZ[5] * from1;
  const double rounding = 3 * from1 + 2 * (from2 + from3 + from4 + from5);
  return {q1, q2, q3, q4, q5, from1, rounding, left * std::abs(perNearest)};
}

/// The slopes a, or b, of a strip's rays.
struct SlopeRange {
  double middle;
  Quotient more;  ///< what is added to it
  double wrong;   ///< the sum of all errors
};

/// `wrong` is the error of d.x, d.y and d.z.
inline __attribute__((always_inline)) SlopeRange slopesOf(double middle, const Quotient& more,
                                                          double wrong, double perNearest) {
  constexpr double rounding = 1.01 * 0x1p-24;  // of float, and what is beyond first order
  const double ofPoints = wrong * (1 + std::abs(middle) + more.around) * std::abs(perNearest);
  return {middle, more, ofPoints + more.tail + rounding * (more.rounding + 4 * more.around)};
}

/// Keeps what is known of strip k. `isAway`: all its rays point away from the panel.
inline __attribute__((always_inline)) void keep(const FixedMap& m, const SlopeRange& a,
                                                const SlopeRange& b, bool isFacing, bool isAway,
                                                std::size_t k, StripMaps& strips) {
  std::array<double, 2> doubt;
  for (std::size_t pair = 0; pair < 2; ++pair) {
    const double ofA = std::abs(m.slope[2 * pair]) * a.wrong;
    const double ofB = std::abs(m.slope[2 * pair + 1]) * b.wrong;
    doubt[pair] = within(3 + (ofA > ofB ? ofA : ofB), 0x1p29);  // two numbers are truncated
    strips.doubt[pair][k] = static_cast<std::uint32_t>(static_cast<std::int32_t>(doubt[pair]) + 1);
  }
  const bool isKnown = isFacing & (doubt[0] < m.mostDoubt) & (doubt[1] < m.mostDoubt);
  bool isOut = false;
  bool isIn = true;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const double index = m.constant[axis] + m.slope[axis] * (axis % 2 == 0 ? a : b).middle;
    const double around = std::abs(m.slope[axis]) * (axis % 2 == 0 ? a : b).more.around;
    const double margin = around + doubt[axis / 2];
    isOut |= (index + margin < 0) | (index - margin > m.end[axis]);
    isIn &= (index - margin > 0) & (index + margin < m.end[axis]);
    strips.middle[axis][k] = static_cast<std::int32_t>(within(index, 0x1p30) + doubt[axis / 2]);
  }
  strips.isKnown[k] = isKnown ? 1 : 0;
  strips.mayHit[k] = isAway | (isKnown & isOut) ? 0 : 1;
  strips.mayMiss[k] = isKnown & isIn ? 0 : 1;
  const auto inUnits = [k](const Quotient& q, double slope, FloatTerms& terms) {
    terms[1][k] = static_cast<float>(slope * q.q1);
    terms[2][k] = static_cast<float>(slope * q.q2);
    terms[3][k] = static_cast<float>(slope * q.q3);
    terms[4][k] = static_cast<float>(slope * q.q4);
    terms[5][k] = static_cast<float>(slope * q.q5);
  };
  inUnits(a.more, m.slope[0], strips.i);
  inUnits(b.more, m.slope[1], strips.j);
}

/// Works on all strips at once, without branches.
inline __attribute__((always_inline)) void prepare(const FixedMap& map, const LensStrips& lens,
                                                   StripMaps& strips) {
  const FixedMap m = map;
  const std::array<double, 3> right = m.map.right;
  const std::array<double, 3> down = m.map.down;
  const std::array<double, 3> forward = m.map.forward;
  for (std::size_t k = 0; k < LensStrips::count; ++k) {
    const double dx = right[0] * lens.x[0][k] + down[0] * lens.y[0][k] + forward[0];
    const double dy = right[1] * lens.x[0][k] + down[1] * lens.y[0][k] + forward[1];
    const double dz = right[2] * lens.x[0][k] + down[2] * lens.y[0][k] + forward[2];
    const double perZ = 1 / dz;
    const double a = dx * perZ;
    const double b = dy * perZ;
    Terms ofX{};
    Terms ofY{};
    Terms ofZ{};
    Terms sizeZ{};
    double aroundZ = 0;
    for (std::size_t power = 1; power < LensStrips::terms; ++power) {
      const double x = lens.x[power][k];
      const double y = lens.y[power][k];
      ofZ[power] = right[2] * x + down[2] * y;
      ofX[power] = right[0] * x + down[0] * y - a * ofZ[power];
      ofY[power] = right[1] * x + down[1] * y - b * ofZ[power];
      sizeZ[power] = std::abs(ofZ[power]);
      aroundZ += sizeZ[power];
    }
    // An error (e, e) of a point changes each part of its ray by at most √2 e.
    const double wrong = 1.5 * lens.error[k];
    const double nearest = -dz - aroundZ - wrong;
    const double perNearest = 1 / nearest;
    const bool hasStrip = lens.error[k] < 1;
    keep(m, slopesOf(a, quotient(ofX, ofZ, sizeZ, perZ, perNearest), wrong, perNearest),
         slopesOf(b, quotient(ofY, ofZ, sizeZ, perZ, perNearest), wrong, perNearest),
         hasStrip & (nearest > 0), hasStrip & (dz > aroundZ + wrong), k, strips);
  }
}

/// Finds the addresses of `count` rays of a strip, from the one numbered `first` on, from their
/// points themselves, which begin at (x, y) for the strip.
void findByPoints(const FixedMap& m, const BlockLayout& l, const double* x, const double* y,
                  int first, int count, AddressStrip<1>& strip) {
  CellBatch exact;
  findCells(m.map, x + first, y + first, count, exact);
  const auto& [i, j, u, v] = exact.cell;
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    const std::size_t to = std::size_t(first) + k;
    strip.address[0][to] =
        l.i.inBlocks(i[k]) + l.j.inBlocks(j[k]) + l.u.inBlocks(u[k]) + l.v.inBlocks(v[k]);
    strip.seen[to] = exact.seen[k] != 0 ? ~0U : 0;
  }
}

/// Does so for the rays that are in doubt. A ray whose units past its cells' borders are all more
/// than twice the doubt is not.
void findDoubtful(const FixedMap& m, const BlockLayout& l,
                  const std::array<Strip<std::int32_t>, 4>& index,
                  const std::array<std::uint32_t, 2>& doubt, const double* x, const double* y,
                  int count, AddressStrip<1>& strip) {
  const std::uint32_t inCell = (1U << m.shift) - 1;
  for (int ray = 0; ray < count; ++ray) {
    const auto isClear = [&](std::size_t axis) {
      return (static_cast<std::uint32_t>(index[axis][std::size_t(ray)]) & inCell) >
             2 * doubt[axis / 2];
    };
    if (!(isClear(0) && isClear(1) && isClear(2) && isClear(3)))
      findByPoints(m, l, x, y, ray, 1, strip);
  }
}

/// Finds the addresses of a strip's rays, which begin at points (x, y).
template <StripHits hits>
inline __attribute__((always_inline)) void findByPolynomials(
    const FixedMap& m, const BlockLayout& l, const StripMaps& strips, std::size_t own,
    const double* x, const double* y, int count, AddressStrip<1>& strip) {
  std::array<float, LensStrips::terms> ofI;
  std::array<float, LensStrips::terms> ofJ;
  for (std::size_t power = 1; power < LensStrips::terms; ++power) {
    ofI[power] = strips.i[power][own];
    ofJ[power] = strips.j[power][own];
  }
  std::array<std::int32_t, 4> middle;
  for (std::size_t axis = 0; axis < 4; ++axis) middle[axis] = strips.middle[axis][own];
  const std::array<float, 2> perHogel = m.perHogel;
  std::array<Strip<std::int32_t>, 4> index;
  for (std::size_t k = 0; k < stripSize; ++k) {
    const float t =
        (static_cast<float>(static_cast<int>(k)) - (stripSize - 1) / 2.0F) / (stripSize / 2.0F);
    const auto at = [t](const std::array<float, LensStrips::terms>& p) {
      return ((((p[5] * t + p[4]) * t + p[3]) * t + p[2]) * t + p[1]) * t;
    };
    const float i = at(ofI);
    const float j = at(ofJ);
    index[0][k] = middle[0] + static_cast<std::int32_t>(i);
    index[1][k] = middle[1] + static_cast<std::int32_t>(j);
    index[2][k] = middle[2] + static_cast<std::int32_t>(perHogel[0] * i);
    index[3][k] = middle[3] + static_cast<std::int32_t>(perHogel[1] * j);
  }
  const std::uint32_t inCell = (1U << m.shift) - 1;
  std::array<std::uint32_t, 4> end;
  for (std::size_t axis = 0; axis < 4; ++axis) end[axis] = static_cast<std::uint32_t>(m.end[axis]);
  std::uint32_t pastHogel = ~0U;
  std::uint32_t pastDirection = ~0U;
  for (std::size_t k = 0; k < stripSize; ++k) {
    std::array<std::uint32_t, 4> past;
    std::array<std::uint32_t, 4> cell;
    std::uint32_t seen = ~0U;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const auto units = static_cast<std::uint32_t>(index[axis][k]);
      past[axis] = units & inCell;
      seen &= units < end[axis] ? ~0U : 0;
      cell[axis] = units >> m.shift;
    }
    strip.address[0][k] = l.i.inBlocks(cell[0]) + l.j.inBlocks(cell[1]) + l.u.inBlocks(cell[2]) +
                          l.v.inBlocks(cell[3]);
    pastHogel = std::min(pastHogel, std::min(past[0], past[1]));
    pastDirection = std::min(pastDirection, std::min(past[2], past[3]));
    if (hits == StripHits::some) strip.seen[k] = seen;
  }
  const std::array<std::uint32_t, 2> doubt{strips.doubt[0][own], strips.doubt[1][own]};
  if ((pastHogel <= 2 * doubt[0]) | (pastDirection <= 2 * doubt[1]))
    findDoubtful(m, l, index, doubt, x, y, count, strip);
}

}  // namespace

MULTIVERSIONED
void copyLensRays(const FixedMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                  const LensStrips* strips, std::span<const RayRow> rows) {
  StripMaps maps;
  const LensStrips* prepared = nullptr;
  const BlockLayout l = layout;
  const auto find = [&](const RayRow& row, int first, int many, AddressStrip<1>& addresses)
      __attribute__((always_inline)) {
    const std::size_t strip = row.strip + std::size_t(first / stripSize);
    const std::size_t own = strip % LensStrips::count;
    const LensStrips* const group = strips + strip / LensStrips::count;
    if (group != prepared) prepare(map, *group, maps);
    prepared = group;
    if (maps.mayHit[own] == 0) return StripHits::none;
    const double* const x = row.x + first;
    const double* const y = row.y + first;
    if (maps.mayMiss[own] == 0) {
      findByPolynomials<StripHits::all>(map, l, maps, own, x, y, many, addresses);
      return StripHits::all;
    }
    if (maps.isKnown[own] != 0) {
      findByPolynomials<StripHits::some>(map, l, maps, own, x, y, many, addresses);
    } else {
      addresses.seen.fill(0);
      findByPoints(map, l, x, y, 0, many, addresses);
    }
    return StripHits::some;
  };
  copyStrips<1>(find, layout, texels, rows);
}

}  // namespace hogelscope
