// SPDX-License-Identifier: BSD-3-Clause
// The finder of a lens sheet (LensSheet), whose colours have sub-pixels of their own.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/engine/finders.h"
#include "core/panel/lens_sheet.h"

namespace hogelscope {

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

/// A sheet's map from the image plane. Columns, and rows from the bottom, are offset by `apart`, so
/// that they stay positive and truncation is floor. Any lens may be met, since rays come from far
/// beside the panel if the gap is wide.
template <int kinds>
struct SheetFinder {
  using Number = double;
  static constexpr std::size_t colours = 3;
  static constexpr StripHits rowHits = StripHits::none;
  /// A multiple of all kinds of pixels, and more than an end moves along a lens.
  static constexpr std::uint32_t apart = 12;

  SheetFinder(const HitMap& m, std::size_t ofChannel)
      : channel(ofChannel),
        pattern(m.panel.display->sheet()->pattern()),
        slide(m.panel.display->sheet()->slide()),
        z(timesZ(m, 1, 0, 0)),
        width(static_cast<std::uint32_t>(m.panel.count[0])),
        height(static_cast<std::uint32_t>(m.panel.count[1])) {
    const SheetHits hits = m.panel.display->sheet()->hitsFrom(m.panel.eye);
    const auto over = [&](const SheetHits::Linear& f, double more) {
      return timesZ(m, f[0] + more, f[1], f[2]);
    };
    lens = over(hits.lens, 0);
    right = over(hits.right, apart);
    up = over(hits.up, apart);
    rightOfLens = hits.rightOfLens;
    upOfLens = hits.upOfLens;
    std::copy(m.panel.count.begin(), m.panel.count.end(), count.begin());
  }

  /// Tells what a ray would meet through real-valued lenses: the lens, and where it ends behind
  /// lens 0, px; `isOn` is true if it can end on the panel.
  struct Met {
    double lens, right, up;
    bool isOn;
  };

  [[nodiscard]] __attribute__((always_inline)) Met met(double x, double y) const {
    constexpr double mostLenses = 1e15;
    const auto at = [&](const PlaneFunction& f) __attribute__((always_inline)) {
      return f[0] * x + (f[1] * y + f[2]);
    };
    const double perZ = 1 / at(z);
    const double real = at(lens) * perZ;
    const bool isOn = static_cast<bool>((perZ < 0) & (std::abs(real) < mostLenses));
    return {isOn ? real : 0, at(right) * perZ, at(up) * perZ, isOn};
  }

  /// Returns where a ray ends, px. Farther ends, and none, are beside the panel too, and all have a
  /// column and a row.
  [[nodiscard]] __attribute__((always_inline)) Vec2 endOf(double atLens, double atRight,
                                                          double atUp) const {
    constexpr double rounding = 0x1.8p52;  // floor without an integer, which may be too small
    const auto limited = [](double place) __attribute__((always_inline)) {
      constexpr double farthest = 5e8;
      return std::min(std::max(-farthest, place), farthest);
    };
    const double nearest = atLens + rounding - rounding;
    const double whole = nearest > atLens ? nearest - 1 : nearest;
    return {limited(atRight + rightOfLens * whole), limited(atUp + upOfLens * whole)};
  }

  /// The sub-pixel of one colour: column from the left, row from the top, both maybe beside the
  /// panel.
  struct Pixel {
    std::uint32_t column, row;
    std::uint32_t seen;  ///< all bits are set if it is on the panel
  };

  [[nodiscard]] __attribute__((always_inline)) Pixel pixelOf(const Offsets<kinds>& toRight,
                                                             const Offsets<kinds>& upwards,
                                                             double endRight, double endUp) const {
    const auto cell = [](double place) __attribute__((always_inline)) {
      return static_cast<std::int32_t>(place);
    };
    const double fromRight = endRight - toRight(cell(endRight), cell(endUp));
    const std::int32_t i = cell(fromRight);
    const double slid = slide * (fromRight - (i + 0.5));
    const double above =
        endUp + std::min(std::max(slid, -LensSheet::farthestUp), LensSheet::farthestUp);
    const std::int32_t j = cell(above - upwards(i, cell(above)));
    const std::uint32_t column = static_cast<std::uint32_t>(i) - apart;
    const std::uint32_t row = height - 1 - (static_cast<std::uint32_t>(j) - apart);
    return {column, row, static_cast<bool>((column < width) & (row < height)) ? ~0U : 0};
  }

  [[nodiscard]] __attribute__((always_inline)) RealHit<double> hit(double x, double y) const {
    const Met ray = met(x, y);
    const Vec2 end = endOf(ray.lens, ray.right, ray.up);
    const Pixel pixel = pixelOf({pattern, channel, 0}, {pattern, channel, 1}, end.x, end.y);
    return {static_cast<std::int32_t>(pixel.column) + 0.5,
            static_cast<std::int32_t>(pixel.row) + 0.5, 0.5, 0.5,
            static_cast<bool>(ray.isOn & (pixel.seen != 0))};
  }

  std::size_t channel;
  CellPattern pattern;
  double slide;
  PlaneFunction z;
  PlaneFunction lens{}, right{}, up{};  ///< times z
  double rightOfLens = 0, upOfLens = 0;
  std::uint32_t width, height;
  std::array<double, 4> count{};
};

template <Rays rays, int kinds>
inline __attribute__((always_inline)) void findAddresses(const SheetFinder<kinds>& m,
                                                         const BlockLayout& l, const double* x,
                                                         const double* y, AddressStrip<3>& strip) {
  Strip<double> lens, right, up;
  Strip<std::uint32_t> column, row, seen;
  for (std::size_t k = 0; k < stripSize; ++k) {
    const auto ray = m.met(x[k], y[rays == Rays::any ? k : 0]);
    lens[k] = ray.lens;
    right[k] = ray.right;
    up[k] = ray.up;
    seen[k] = ray.isOn ? ~0U : 0;
  }
  for (std::size_t k = 0; k < stripSize; ++k) {
    const Vec2 end = m.endOf(lens[k], right[k], up[k]);
    right[k] = end.x;
    up[k] = end.y;
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const Offsets<kinds> toRight(m.pattern, c, 0);
    const Offsets<kinds> upwards(m.pattern, c, 1);
    for (std::size_t k = 0; k < stripSize; ++k) {
      const auto pixel = m.pixelOf(toRight, upwards, right[k], up[k]);
      column[k] = pixel.column;
      row[k] = pixel.row;
      seen[k] &= pixel.seen;
    }
    for (std::size_t k = 0; k < stripSize; ++k)
      strip.address[c][k] = l.i.inBlocks(column[k]) + l.j.inBlocks(row[k]);
  }
  strip.seen = seen;
}

}  // namespace hogelscope
