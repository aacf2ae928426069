// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/sheet_kernels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/base/multiversioned.h"
#include "core/engine/ray_strips.h"
#include "core/panel/lens_sheet.h"

namespace hogelscope {

namespace {

/// A function that is linear over the image plane: for each unit of x, of y, and a constant.
using PlaneFunction = std::array<double, 3>;

/// A sheet's map from the image plane. Columns, and rows from the bottom, are `apart` larger than
/// they are, so that truncation is floor on the panel. Any lens may be met, since rays come from
/// far beside the panel if the gap is wide.
struct SheetMap {
  /// A multiple of all kinds of pixels, and more than an end moves along a lens.
  static constexpr std::uint32_t apart = 12;

  explicit SheetMap(const HitMap& m)
      : z{m.right[2], m.down[2], m.forward[2]},
        pattern(m.panel.sheet->pattern()),
        slide(m.panel.sheet->slide()),
        width(static_cast<std::uint32_t>(m.panel.count[0])),
        height(static_cast<std::uint32_t>(m.panel.count[1])) {
    const SheetHits hits = m.panel.sheet->hitsFrom(m.panel.eye);
    const auto over = [&](const SheetHits::Linear& f, double more) {
      const auto along = [&](const std::array<double, 3>& d) {
        return f[1] * d[0] + f[2] * d[1] + (f[0] + more) * d[2];
      };
      return PlaneFunction{along(m.right), along(m.down), along(m.forward)};
    };
    lens = over(hits.lens, 0);
    right = over(hits.right, apart);
    up = over(hits.up, apart);
    rightOfLens = hits.rightOfLens;
    upOfLens = hits.upOfLens;
  }

  PlaneFunction z;
  PlaneFunction lens{}, right{}, up{};  ///< times z
  double rightOfLens = 0, upOfLens = 0;
  CellPattern pattern;
  double slide;
  std::uint32_t width, height;
};

/// Where the rays of a strip end, px. All bits of `isOn` are set where that can be on the panel.
struct EndStrip {
  Strip<double> right, up;
  Strip<std::uint32_t> isOn;
};

template <Rays rays>
inline __attribute__((always_inline)) void endStrip(const SheetMap& m, const double* x,
                                                    const double* y, EndStrip& end) {
  constexpr double mostLenses = 1e15;
  Strip<double> lens;
  for (std::size_t k = 0; k < stripSize; ++k) {
    const auto at = [&](const PlaneFunction& f) __attribute__((always_inline)) {
      return f[0] * x[k] + (f[1] * y[rays == Rays::any ? k : 0] + f[2]);
    };
    const double perZ = 1 / at(m.z);
    const double met = at(m.lens) * perZ;
    const bool isOn = static_cast<bool>((perZ < 0) & (std::abs(met) < mostLenses));
    lens[k] = isOn ? met : 0;
    end.right[k] = at(m.right) * perZ;
    end.up[k] = at(m.up) * perZ;
    end.isOn[k] = isOn ? ~0U : 0;
  }
  // Farther ends, and none, are beside the panel too, and all have a column and a row.
  const auto limited = [](double place) __attribute__((always_inline)) {
    constexpr double farthest = 5e8;
    return std::min(std::max(-farthest, place), farthest);
  };
  for (std::size_t k = 0; k < stripSize; ++k) {
    constexpr double rounding = 0x1.8p52;  // floor without an integer, which may be too small
    const double nearest = lens[k] + rounding - rounding;
    const double whole = nearest > lens[k] ? nearest - 1 : nearest;
    end.right[k] = limited(end.right[k] + m.rightOfLens * whole);
    end.up[k] = limited(end.up[k] + m.upOfLens * whole);
  }
}

/// The offset of one colour along one axis, in pixels of 1 kind, of 2 that alternate from column to
/// column, or of up to 4.
template <int kinds>
struct Offsets {
  Offsets(const CellPattern& pattern, std::size_t channel, std::size_t axis)
      : ofColumn(pattern.ofColumn), ofRow(pattern.ofRow) {
    for (std::size_t kind = 0; kind < at.size(); ++kind)
      at[kind] = pattern.kinds[kind & std::size_t(pattern.mask)][channel][axis];
  }
  __attribute__((always_inline)) double operator()(std::int32_t column, std::int32_t row) const {
    if constexpr (kinds == 1) return at[0];
    if constexpr (kinds == 2) return (column & 1) != 0 ? at[1] : at[0];
    const std::int32_t kind = column * ofColumn + row * ofRow;
    const double first = (kind & 1) != 0 ? at[1] : at[0];
    const double second = (kind & 1) != 0 ? at[3] : at[2];
    return (kind & 2) != 0 ? second : first;
  }
  std::int32_t ofColumn, ofRow;
  std::array<double, 4> at{};
};

/// The sub-pixels of one colour for a strip: column from the left, row from the top, both maybe
/// beside the panel. All bits of `seen` are set where they are on it.
struct PixelStrip {
  Strip<std::uint32_t> column, row, seen;
};

template <int kinds>
inline __attribute__((always_inline)) void pixelStrip(const SheetMap& m, std::size_t channel,
                                                      const EndStrip& end, PixelStrip& pixels) {
  const Offsets<kinds> toRight(m.pattern, channel, 0);
  const Offsets<kinds> upwards(m.pattern, channel, 1);
  const auto cell = [](double place) __attribute__((always_inline)) {
    return static_cast<std::int32_t>(place);
  };
  const std::uint32_t width = m.width;
  const std::uint32_t height = m.height;
  for (std::size_t k = 0; k < stripSize; ++k) {
    const double fromRight = end.right[k] - toRight(cell(end.right[k]), cell(end.up[k]));
    const std::int32_t i = cell(fromRight);
    const double slid = m.slide * (fromRight - (i + 0.5));
    const double up =
        end.up[k] + std::min(std::max(slid, -LensSheet::farthestUp), LensSheet::farthestUp);
    const std::int32_t j = cell(up - upwards(i, cell(up)));
    const std::uint32_t column = static_cast<std::uint32_t>(i) - SheetMap::apart;
    const std::uint32_t row = height - 1 - (static_cast<std::uint32_t>(j) - SheetMap::apart);
    const bool isSeen = static_cast<bool>((column < width) & (row < height));
    pixels.column[k] = column;
    pixels.row[k] = row;
    pixels.seen[k] = isSeen ? end.isOn[k] : 0;
  }
}

/// Finds and prefetches the addresses of the three sub-pixels of at most a strip of rays.
template <Rays rays, int kinds>
inline __attribute__((always_inline)) void findPixels(const SheetMap& m, const BlockLayout& l,
                                                      const Texel<std::uint8_t>* texels,
                                                      const double* x, const double* y, int count,
                                                      std::array<std::uint32_t*, 3> address,
                                                      std::uint8_t* seen) {
  Strip<double> paddedX;
  Strip<double> paddedY;
  padStrip<rays>(x, y, count, paddedX, paddedY);
  EndStrip end;
  endStrip<rays>(m, x, y, end);
  Strip<std::uint32_t> all = end.isOn;
  for (std::size_t c = 0; c < 3; ++c) {
    PixelStrip pixels;
    pixelStrip<kinds>(m, c, end, pixels);
    for (std::size_t k = 0; k < stripSize; ++k) {
      address[c][k] = l.i.inBlocks(pixels.column[k]) + l.j.inBlocks(pixels.row[k]);
      all[k] &= pixels.seen[k];
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t k = 0; k < stripSize; ++k)
      address[c][k] = all[k] != 0 ? address[c][k] : l.texels;
  for (std::size_t c = 0; c < 3; ++c)
#pragma GCC unroll 8
    for (int k = 0; k < count; ++k) __builtin_prefetch(texels + address[c][k]);
  for (int k = 0; k < count; ++k) seen[k] = static_cast<std::uint8_t>(all[std::size_t(k)]);
}

/// Writes red, green and blue of three texels for each ray.
inline __attribute__((always_inline)) void packPixels(const Texel<std::uint8_t>* texels,
                                                      const std::array<std::uint32_t*, 3>& address,
                                                      int count, std::uint8_t* rgb) {
  const auto texelOf = [&](int k) __attribute__((always_inline)) {
    return Texel<std::uint8_t>{texels[address[0][k]].r, texels[address[1][k]].g,
                               texels[address[2][k]].b, 0};
  };
    // Whole texels are written, each over the previous one's unused byte; the last has no room.
#pragma GCC unroll 8
  for (int k = 0; k + 1 < count; ++k) {
    const Texel<std::uint8_t> texel = texelOf(k);
    std::memcpy(rgb + std::ptrdiff_t(3) * k, &texel, sizeof texel);
  }
  const Texel<std::uint8_t> last = texelOf(count - 1);
  std::memcpy(rgb + std::ptrdiff_t(3) * (count - 1), &last, 3);
}

template <Rays rays, int kinds>
inline __attribute__((always_inline)) void copyPixels(const SheetMap& m, const BlockLayout& layout,
                                                      const Texel<std::uint8_t>* texels,
                                                      const double* x, const double* y, int count,
                                                      std::uint8_t* rgb, std::uint8_t* seen) {
  const BlockLayout l = layout;
  constexpr int ahead = 64;
  std::array<std::array<std::uint32_t, 2 * ahead>, 3> address;
  for (int first = 0; first < count + ahead; first += stripSize) {
    const auto strip = [&](int begin) {
      const auto at = std::size_t(begin % (2 * ahead));
      return std::array{&address[0][at], &address[1][at], &address[2][at]};
    };
    if (first < count)
      findPixels<rays, kinds>(m, l, texels, x + first, rays == Rays::any ? y + first : y,
                              std::min(stripSize, count - first), strip(first), seen + first);
    const int done = first - ahead;
    if (done < 0) continue;
    packPixels(texels, strip(done), std::min(stripSize, count - done),
               rgb + std::ptrdiff_t(3) * done);
  }
}

/// Calls `use` with the number of kinds of pixels.
template <class Use>
inline __attribute__((always_inline)) void withKinds(const HitMap& map, Use use) {
  const CellPattern& pattern = map.panel.sheet->pattern();
  if (pattern.mask == 0)
    use(std::integral_constant<int, 1>());
  else if (pattern.mask == 1 && pattern.ofRow == 0)
    use(std::integral_constant<int, 2>());
  else
    use(std::integral_constant<int, 4>());
}

/// Finds the sub-pixels of one colour for a strip.
MULTIVERSIONED
void sheetStrip(const HitMap& map, const double* x, const double* y, std::size_t channel,
                PixelStrip& pixels) {
  const SheetMap m(map);
  EndStrip end;
  endStrip<Rays::any>(m, x, y, end);
  withKinds(
      map, [&](auto kinds) __attribute__((always_inline)) {
        pixelStrip<kinds.value>(m, channel, end, pixels);
      });
}

/// Returns the part [first, last) of a row's rays, which are evenly spread, beside which no ray can
/// meet the panel.
std::array<int, 2> partOnPanel(const SheetMap& m, const double* x, double y, int count) {
  double least = x[0];
  double most = x[count - 1];
  // Keeps the x at which p x + q ≥ 0.
  const auto keep = [&](double p, double q) {
    if (p > 0)
      least = std::max(least, -q / p);
    else if (p < 0)
      most = std::min(most, -q / p);
    else if (q < 0)
      most = least - 1;
  };
  constexpr double beside = SheetMap::apart + LensSheet::farthestUp;
  const auto within = [&](const PlaneFunction& f, double ofLens, double end) {
    // Of a ray through a real-valued lens; it ends at most one lens farther. z is below 0.
    for (const auto& [sign, limit] : {std::pair(-1.0, -beside - std::abs(ofLens)),
                                      std::pair(1.0, end + beside + std::abs(ofLens))}) {
      const auto at = [&, sign = sign, limit = limit](std::size_t k) {
        return sign * (f[k] + ofLens * m.lens[k] - limit * m.z[k]);
      };
      keep(at(0), at(1) * y + at(2));
    }
  };
  within(m.right, m.rightOfLens, m.width);
  within(m.up, m.upOfLens, m.height);
  keep(-m.z[0], -(m.z[1] * y + m.z[2]));
  const double step = count > 1 ? (x[count - 1] - x[0]) / (count - 1) : 1;
  const auto index = [&](double place) {
    return std::clamp((place - x[0]) / step, -2.0, count + 2.0);
  };
  const int first = std::clamp(static_cast<int>(index(least)) - 1, 0, count);
  return {first, std::clamp(static_cast<int>(index(most)) + 2, first, count)};
}

}  // namespace

MULTIVERSIONED
void copySheetRays(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                   const double* x, const double* y, int count, std::uint8_t* rgb,
                   std::uint8_t* seen) {
  withKinds(
      map, [&](auto kinds) __attribute__((always_inline)) {
        copyPixels<Rays::any, kinds.value>(SheetMap(map), layout, texels, x, y, count, rgb, seen);
      });
}

MULTIVERSIONED
void copySheetRow(const HitMap& map, const BlockLayout& layout, const Texel<std::uint8_t>* texels,
                  const double* x, double y, int count, std::uint8_t* rgb, std::uint8_t* seen) {
  const SheetMap m(map);
  const std::array<int, 2> part = partOnPanel(m, x, y, count);
  const int first = part[0];
  const int rays = part[1] - first;
  if (rays == 0) return;
  withKinds(
      map, [&](auto kinds) __attribute__((always_inline)) {
        copyPixels<Rays::row, kinds.value>(m, layout, texels, x + first, &y, rays,
                                           rgb + std::ptrdiff_t(3) * first, seen + first);
      });
}

void findSheetCells(const HitMap& map, const double* x, const double* y, int count,
                    std::size_t channel, CellBatch& batch) {
  for (int first = 0; first < count; first += stripSize) {
    const int rays = std::min(stripSize, count - first);
    Strip<double> paddedX;
    Strip<double> paddedY;
    const double* stripX = x + first;
    const double* stripY = y + first;
    padStrip<Rays::any>(stripX, stripY, rays, paddedX, paddedY);
    PixelStrip pixels;
    sheetStrip(map, stripX, stripY, channel, pixels);
    for (std::size_t k = 0; k < std::size_t(rays); ++k) {
      const std::size_t to = std::size_t(first) + k;
      batch.seen[to] = static_cast<std::uint8_t>(pixels.seen[k]);
      const std::array cell{pixels.column[k] & pixels.seen[k], pixels.row[k] & pixels.seen[k], 0U,
                            0U};
      for (std::size_t axis = 0; axis < 4; ++axis) {
        batch.cell[axis][to] = cell[axis];
        batch.place[axis][to] = 0.5F;
      }
    }
  }
}

}  // namespace hogelscope
