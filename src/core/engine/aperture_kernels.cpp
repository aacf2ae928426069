// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/aperture_kernels.h"

#include <cmath>

#include "core/base/multiversioned.h"

namespace hogelscope {

namespace {

/// No cell has all bits set, since it is at most 127 away.
constexpr std::uint32_t counted = ~0U;

template <bool isFlat>
inline __attribute__((always_inline)) void findKeys(const ApertureOffsets& offsets,
                                                    const PixelSpread& spread,
                                                    std::uint32_t* keys) {
  const PixelSpread s = spread;
  const float* x = offsets.x.data();
  const float* y = offsets.y.data();
  const float* z = offsets.z.data();
  const auto away = [](float place) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(place)) + 128);
  };
  const auto points = static_cast<int>(offsets.x.size());
  for (int k = 0; k < points; ++k) {
    const float q = isFlat ? 1 : 1 / (1 - z[k] * s.h);
    const float across = isFlat ? x[k] : (x[k] - z[k] * s.a) * q;
    const float down = isFlat ? y[k] : (y[k] - z[k] * s.b) * q;
    keys[k] = away(s.place[0] + across * s.gain[0]) | away(s.place[1] + down * s.gain[1]) << 8U |
              away(s.place[2] + across * s.gain[2]) << 16U |
              away(s.place[3] + down * s.gain[3]) << 24U;
  }
}

}  // namespace

MULTIVERSIONED
void findMiddles(const HitMap& map, const double* x, const double* y, int count,
                 MiddleBatch& batch) {
  const HitMap m = map;
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    const double dx = m.right[0] * x[k] + m.down[0] * y[k] + m.forward[0];
    const double dy = m.right[1] * x[k] + m.down[1] * y[k] + m.forward[1];
    const double dz = m.right[2] * x[k] + m.down[2] * y[k] + m.forward[2];
    const double inverse = 1 / dz;
    batch.a[k] = dx * inverse;
    batch.b[k] = dy * inverse;
    batch.d[k] = dz;
    for (std::size_t axis = 0; axis < 4; ++axis)
      batch.index[axis][k] =
          m.panel.constant[axis] + m.panel.slope[axis] * (axis % 2 == 0 ? batch.a[k] : batch.b[k]);
  }
}

MULTIVERSIONED
int uniqueCells(const ApertureOffsets& offsets, const PixelSpread& spread, std::uint32_t* keys,
                std::uint32_t* cells, std::int32_t* counts) {
  if (offsets.isFlat)
    findKeys<true>(offsets, spread, keys);
  else
    findKeys<false>(offsets, spread, keys);
  const auto points = static_cast<int>(offsets.x.size());
  int found = 0;
  int left = points;
  for (int next = 0; left > 0; ++found) {
    while (keys[next] == counted) ++next;
    const std::uint32_t key = keys[next];
    std::int32_t count = 0;
    for (int k = 0; k < points; ++k) {
      const bool isSame = keys[k] == key;
      count += isSame ? 1 : 0;
      keys[k] = isSame ? counted : keys[k];
    }
    cells[found] = key;
    counts[found] = count;
    left -= count;
  }
  return found;
}

}  // namespace hogelscope
