// SPDX-License-Identifier: BSD-3-Clause
// The innermost loops over taps, from cells to texels and their weighted sums. The compiler
// vectorises these plain loops for AVX-512, AVX2 and the baseline.
#pragma once

#include <array>
#include <cstdint>

#include "core/engine/row_kernels.h"
#include "core/panel/twin_params.h"

namespace hogelscope {

/// Finds the addresses and weights of the two cells of an axis whose centres lie around each
/// position of a whole batch, the first cells in [0, batchSize), the second ones after them.
void bracketingCells(const AxisLayout& layout, int cells, const std::uint32_t* cell,
                     const float* place, std::uint32_t* offset, float* weight);

/// Rounds code values as quantised() does.
void quantise(const float* codeValues, int count, std::uint8_t* bytes);

/// The sums of a batch, by channel.
struct LightBatch {
  alignas(64) std::array<float, batchSize> r;
  alignas(64) std::array<float, batchSize> g;
  alignas(64) std::array<float, batchSize> b;
};

/// `taps` texels of each ray of a batch: tap t of ray k is at base[k] + offset[t][k], its weight is
/// share[t] or weight[t][k], times scale[k] where there is one.
struct TapBatch {
  int taps = 0;
  const std::uint32_t* base = nullptr;
  const std::array<std::uint32_t, batchSize>* offset = nullptr;
  const float* share = nullptr;
  const std::array<float, batchSize>* weight = nullptr;
  const float* scale = nullptr;
  /// The base of a later call, whose cache lines are prefetched.
  const std::uint32_t* ahead = nullptr;
};

/// Converts code values to linear light, and the mean of `count` sums of linear light to code
/// values, of all lanes. A result differs from linearFromEncoded() or encodedFromLinear() by less
/// than 1e-4 of its range of code values.
void decode(LightBatch& light);
void encodeMean(LightBatch& sum, int count);

/// Adds the weighted code values of the taps (encoded light).
void accumulate(const Texel<std::uint8_t>* texels, const TapBatch& taps, int count,
                LightBatch& sum);
void accumulate(const Texel<std::uint16_t>* texels, const TapBatch& taps, int count,
                LightBatch& sum);
void accumulate(const Texel<float>* texels, const TapBatch& taps, int count, LightBatch& sum);

/// Adds the weighted linear light of the taps.
template <class T>
void accumulateLinear(const Texel<T>* texels, const TapBatch& taps, int count, LightBatch& sum);
/// Adds the weighted light of the taps on a panel with its own bits and transfer function.
template <class T>
void accumulateDriven(const Texel<T>* texels, const TapBatch& taps, int count,
                      const LightErrors& panel, LightBatch& sum);

}  // namespace hogelscope
