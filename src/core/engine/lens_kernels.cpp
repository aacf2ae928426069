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

/// The polynomial q(t) = n(t)/z(t), where n has no constant.
struct Quotient {
  double q1, q2, q3, q4, q5;
  double tail;  ///< how far the polynomial is from the quotient at most
  [[nodiscard]] double around() const {
    return std::abs(q1) + std::abs(q2) + std::abs(q3) + std::abs(q4) + std::abs(q5);
  }
  /// Returns the rounding error in units of float: the term of t^m has 2 m + 1 steps.
  [[nodiscard]] double rounding() const {
    return 3 * std::abs(q1) + 5 * std::abs(q2) + 7 * std::abs(q3) + 9 * std::abs(q4) +
           11 * std::abs(q5);
  }
};

/// Divides power series, written out so that the compiler makes vectors of several strips. What is
/// left, n - z q, begins with t^6; `perNearest` is 1 over the least |z|.
inline __attribute__((always_inline)) Quotient quotient(const Terms& n, const Terms& z, double perZ,
                                                        double perNearest) {
  const auto& [n0, n1, n2, n3, n4, n5] = n;
  const auto& [z0, z1, z2, z3, z4, z5] = z;
  const double q1 = n1 * perZ;
  const double q2 = (n2 - z1 * q1) * perZ;
  const double q3 = (n3 - z1 * q2 - z2 * q1) * perZ;
  const double q4 = (n4 - z1 * q3 - z2 * q2 - z3 * q1) * perZ;
  const double q5 = (n5 - z1 * q4 - z2 * q3 - z3 * q2 - z4 * q1) * perZ;
  const double left6 = z1 * q5 + z2 * q4 + z3 * q3 + z4 * q2 + z5 * q1;
  const double left7 = z2 * q5 + z3 * q4 + z4 * q3 + z5 * q2;
  const double left8 = z3 * q5 + z4 * q4 + z5 * q3;
  const double left9 = z4 * q5 + z5 * q4;
  const double left10 = z5 * q5;
  const double left =
      std::abs(left6) + std::abs(left7) + std::abs(left8) + std::abs(left9) + std::abs(left10);
  return {q1, q2, q3, q4, q5, left * std::abs(perNearest)};
}

/// The slopes a, or b, of a strip's rays.
struct SlopeRange {
  double middle;
  Quotient more;  ///< what is added to it
  double around;  ///< the most that is added
  double wrong;   ///< the sum of all errors
};

/// `wrong` is the error of d.x, d.y and d.z.
inline __attribute__((always_inline)) SlopeRange slopesOf(double middle, const Quotient& more,
                                                          double wrong, double perNearest) {
  constexpr double rounding = 1.01 * 0x1p-24;  // of float, and what is beyond first order
  const double around = more.around();
  const double ofPoints = wrong * (1 + std::abs(middle) + around) * std::abs(perNearest);
  return {middle, more, around, ofPoints + more.tail + rounding * (more.rounding() + 4 * around)};
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
    const double around = std::abs(m.slope[axis]) * (axis % 2 == 0 ? a : b).around;
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
    double aroundZ = 0;
    for (std::size_t power = 1; power < LensStrips::terms; ++power) {
      const double x = lens.x[power][k];
      const double y = lens.y[power][k];
      ofZ[power] = right[2] * x + down[2] * y;
      ofX[power] = right[0] * x + down[0] * y - a * ofZ[power];
      ofY[power] = right[1] * x + down[1] * y - b * ofZ[power];
      aroundZ += std::abs(ofZ[power]);
    }
    // An error (e, e) of a point changes each part of its ray by at most √2 e.
    const double wrong = 1.5 * lens.error[k];
    const double nearest = -dz - aroundZ - wrong;
    const double perNearest = 1 / nearest;
    const bool hasStrip = lens.error[k] < 1;
    keep(m, slopesOf(a, quotient(ofX, ofZ, perZ, perNearest), wrong, perNearest),
         slopesOf(b, quotient(ofY, ofZ, perZ, perNearest), wrong, perNearest),
         hasStrip & (nearest > 0), hasStrip & (dz > aroundZ + wrong), k, strips);
  }
}

/// Finds the cells of a strip's rays. Returns false if one is in doubt.
template <StripHits hits>
inline __attribute__((always_inline)) bool findCertain(const FixedMap& m, const StripMaps& strips,
                                                       std::size_t own, CellStrip& cells) {
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
    std::uint32_t seen = ~0U;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const auto units = static_cast<std::uint32_t>(index[axis][k]);
      past[axis] = units & inCell;
      seen &= units < end[axis] ? ~0U : 0;
      cells.cell[axis][k] = units >> m.shift;
    }
    pastHogel = std::min(pastHogel, std::min(past[0], past[1]));
    pastDirection = std::min(pastDirection, std::min(past[2], past[3]));
    if (hits == StripHits::some) cells.seen[k] = seen;
  }
  return (pastHogel > 2 * strips.doubt[0][own]) & (pastDirection > 2 * strips.doubt[1][own]);
}

}  // namespace

MULTIVERSIONED
void copyLensRays(const FixedMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                  const LensStrips* strips, const double* x, const double* y, int count,
                  std::uint8_t* rgb, std::uint8_t* seen) {
  StripMaps maps;
  const auto find = [&](int first, int many, CellStrip& cells) __attribute__((always_inline)) {
    const int strip = first / stripSize;
    const auto own = std::size_t(strip % LensStrips::count);
    if (own == 0) prepare(map, strips[strip / LensStrips::count], maps);
    if (maps.mayHit[own] == 0) return StripHits::none;
    if (maps.mayMiss[own] == 0 && findCertain<StripHits::all>(map, maps, own, cells))
      return StripHits::all;
    if (maps.mayMiss[own] == 0 || maps.isKnown[own] == 0 ||
        !findCertain<StripHits::some>(map, maps, own, cells))
      findStripCells(map.map, x + first, y + first, many, cells);
    return StripHits::some;
  };
  copyStrips(find, layout, texels, count, rgb, seen);
}

}  // namespace hogelscope
