// SPDX-License-Identifier: BSD-3-Clause
// Finds the cells that the rays of a pixel meet from all points of an aperture, relative to that of
// the ray from its middle. The compiler vectorises the loops over points for AVX-512, AVX2 and the
// baseline.
//
// Let a, b be the slopes of the ray from the eye through a pixel, and d its z per unit of depth. A
// point at o from the eye (display frame) sees the same point of the plane in focus, at the depth
// Φ. With h = 1/(Φ d), w = (o.x - o.z a, o.y - o.z b) and q = 1/(1 - o.z h) its slopes differ by
// -w h q, and each index c + s a of the panel's map, with c growing by γ per metre of the eye, by
//
//     w q (γ - s h)
//
// which is small, so that single precision is enough.
#pragma once

#include <vector>

#include "core/engine/row_kernels.h"

namespace hogelscope {

/// The points of an aperture in the display frame, from the eye, metres.
struct ApertureOffsets {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> z;
  bool isFlat = true;  ///< all z are 0: the aperture is parallel to the panel
};

/// The real-valued indices of the rays of a batch from the middle of the aperture, also beyond the
/// panel, with their slopes and d.
struct MiddleBatch {
  std::array<std::array<double, batchSize>, 4> index;
  std::array<double, batchSize> a;
  std::array<double, batchSize> b;
  std::array<double, batchSize> d;
};
/// `map` has linear hogel lenses.
void findMiddles(const HitMap& map, const double* x, const double* y, int count,
                 MiddleBatch& batch);

/// Holds what the points' cells of one pixel depend on.
struct PixelSpread {
  float a = 0;
  float b = 0;
  float h = 0;
  std::array<float, 4> place{};  ///< of the middle ray in its cell, 0 … 1
  std::array<float, 4> gain{};   ///< γ - s h
};

/// The distances of cells from the middle's along each axis; they are -127 … 127.
constexpr int mostCellsAway = 127;
constexpr std::array<int, 4> cellsAway(std::uint32_t key) {
  const auto at = [key](unsigned shift) { return int(key >> shift & 255U) - 128; };
  return {at(0), at(8), at(16), at(24)};
}

/// Finds the different cells and the number of points that see each. Returns how many there are.
/// All arrays have room for all points; `keys` is working memory. No cell may be more than
/// mostCellsAway from the middle's.
int uniqueCells(const ApertureOffsets& offsets, const PixelSpread& spread, std::uint32_t* keys,
                std::uint32_t* cells, std::int32_t* counts);

}  // namespace hogelscope
