// SPDX-License-Identifier: BSD-3-Clause
// Rays of an image's rows in strips, whose texels come from memory while others are copied.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "core/light_field/block_layout.h"
#include "core/light_field/light_field.h"

namespace hogelscope {

/// The number of rays in a strip: so few that a processor works on one strip while the next one's
/// texels come from memory, and so many that their steps fill its units.
constexpr int stripSize = 64;
template <class T>
using Strip = std::array<T, stripSize>;

/// Any rays, or those of a row, which have one y; `hits` are a row's that are known to hit.
enum class Rays { any, row, hits };

/// Rays of one row of an image, and where their texels go.
struct RayRow {
  const double* x;  ///< of their points on the plane z = 1
  const double* y;  ///< one value if the row's rays have one y
  int count;
  std::uint8_t* rgb;          ///< three bytes a ray
  std::uint8_t* seen;         ///< 255 or 0 for seen or not
  std::array<int, 2> hits{};  ///< rays [first, last) are known to hit
  std::size_t strip = 0;      ///< of a whole row through a lens, the number of its first LensStrip
};

/// The rays of a strip that see the display.
enum class StripHits { none, some, all };

/// The addresses of a strip's texels: one for each ray, or those of its red, green and blue. All
/// bits of `seen` are set where the ray sees the display, none elsewhere.
template <std::size_t colours>
struct AddressStrip {
  std::array<Strip<std::uint32_t>, colours> address;
  Strip<std::uint32_t> seen;
};

/// Writes three bytes for each ray.
template <std::size_t colours>
inline __attribute__((always_inline)) void packRgb(const Texel<std::uint8_t>* texels,
                                                   const AddressStrip<colours>& strip, int count,
                                                   std::uint8_t* rgb) {
  using Byte = std::uint8_t;
  const auto bits = [](const Texel<Byte>& texel) { return std::bit_cast<std::uint32_t>(texel); };
  const auto write = [&](int ray, std::size_t bytes) __attribute__((always_inline)) {
    const auto k = std::size_t(ray);
    std::uint32_t texel = bits(texels[strip.address[0][k]]);
    if constexpr (colours == 3)
      texel = (texel & bits({255, 0, 0, 0})) |
              (bits(texels[strip.address[1][k]]) & bits({0, 255, 0, 0})) |
              (bits(texels[strip.address[2][k]]) & bits({0, 0, 255, 0}));
    std::memcpy(rgb + 3 * k, &texel, bytes);
  };
    // Whole texels are written, each over the previous one's unused byte; the last has no room for
    // its own.
#pragma GCC unroll 8
  for (int k = 0; k + 1 < count; ++k) write(k, 4);
  write(count - 1, 3);
}

/// Prefetches the texels of the first `count` rays into the second cache, which is faster than into
/// the first one (docs/measurements.md, Views), and writes which of them are seen.
template <std::size_t colours>
inline __attribute__((always_inline)) void fetchStrip(const BlockLayout& l,
                                                      const Texel<std::uint8_t>* texels,
                                                      StripHits hits, int count,
                                                      AddressStrip<colours>& strip,
                                                      std::uint8_t* seen) {
  for (auto& address : strip.address) {
    if (hits == StripHits::some)
      for (std::size_t k = 0; k < stripSize; ++k)
        address[k] = strip.seen[k] != 0 ? address[k] : l.texels;
#pragma GCC unroll 8
    for (int k = 0; k < count; ++k)
      __builtin_prefetch(texels + address[std::size_t(k)], 0, colours == 1 ? 2 : 3);
  }
  if (hits == StripHits::all)
    std::memset(seen, 255, std::size_t(count));
  else
    for (int k = 0; k < count; ++k) seen[k] = static_cast<std::uint8_t>(strip.seen[std::size_t(k)]);
}

/// Copies the light of each ray; find(row, first, count, strip) finds the addresses of a row's rays
/// from `first` on, at most a strip, three strips before they are copied, so that texels have come
/// from memory; rows follow each other without a gap. Rays that see nothing get the black texel
/// behind all others, and strips of which no ray hits are black.
template <std::size_t colours, class Find>
inline __attribute__((always_inline)) void copyStrips(const Find& find, const BlockLayout& layout,
                                                      const Texel<std::uint8_t>* texels,
                                                      std::span<const RayRow> rows) {
  constexpr std::size_t ahead = 3;
  constexpr std::size_t kept = 4;
  struct Waiting {
    AddressStrip<colours> strip;
    std::uint8_t* rgb;
    int count;
  };
  const BlockLayout l = layout;  // a copy, so that the compiler knows that stores do not change it
  std::array<Waiting, kept> waiting;
  std::size_t found = 0;
  const auto copy = [&](std::size_t strip) __attribute__((always_inline)) {
    const Waiting& w = waiting[strip % kept];
    packRgb(texels, w.strip, w.count, w.rgb);
  };
  for (const RayRow& row : rows)
    for (int first = 0; first < row.count; first += stripSize) {
      Waiting& w = waiting[found % kept];
      w.rgb = row.rgb + std::ptrdiff_t(3) * first;
      w.count = std::min(stripSize, row.count - first);
      const StripHits hits = find(row, first, w.count, w.strip);
      if (hits == StripHits::none) {
        std::memset(w.rgb, 0, 3 * std::size_t(w.count));
        std::memset(row.seen + first, 0, std::size_t(w.count));
        continue;
      }
      fetchStrip(l, texels, hits, w.count, w.strip, row.seen + first);
      if (found >= ahead) copy(found - ahead);
      ++found;
    }
  for (std::size_t strip = found > ahead ? found - ahead : 0; strip < found; ++strip) copy(strip);
}

}  // namespace hogelscope
