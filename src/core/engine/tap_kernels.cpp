// SPDX-License-Identifier: BSD-3-Clause
// The loops over the taps of rays, compiled once for each kind of processor.
#include "core/engine/tap_kernels.h"

#include <algorithm>
#include <cmath>

#include "core/base/multiversioned.h"
#include "core/optics/psf.h"

namespace hogelscope {

namespace {

/// A texel of 8-bit values as one word, red in the lowest byte.
#if defined(__GNUC__)
using Word = std::uint32_t __attribute__((may_alias));
#else
using Word = std::uint32_t;
#endif

/// The code values of a stored texel.
struct Light {
  float r;
  float g;
  float b;
};

inline Light encodedLight(const Texel<std::uint8_t>* texels, std::uint32_t at) {
  const std::uint32_t word = reinterpret_cast<const Word*>(texels)[at];
  return {static_cast<float>(std::int32_t(word & 255U)),
          static_cast<float>(std::int32_t(word >> 8U & 255U)),
          static_cast<float>(std::int32_t(word >> 16U & 255U))};
}

inline Light encodedLight(const Texel<std::uint16_t>* texels, std::uint32_t at) {
  constexpr float scale = 1 / 257.0F;
  const Texel<std::uint16_t>& t = texels[at];
  return {scale * t.r, scale * t.g, scale * t.b};
}

inline Light encodedLight(const Texel<float>* texels, std::uint32_t at) {
  const Texel<float>& t = texels[at];
  return {255 * t.r, 255 * t.g, 255 * t.b};
}

/// Sums the taps one after the other over all rays; `light(at)` is the light of texel `at`.
template <class T, class LightAt>
inline __attribute__((always_inline)) void sumTaps(const Texel<T>* texels, const TapBatch& taps,
                                                   int count, LightBatch& sum, LightAt light) {
  const std::uint32_t* base = taps.base;
  float* r = sum.r.data();
  float* g = sum.g.data();
  float* b = sum.b.data();
  std::array<std::uint32_t, batchSize> at;
  for (int t = 0; t < taps.taps; ++t) {
    const std::uint32_t* offset = taps.offset[t].data();
    // Addresses are summed in a separate loop, since those in memory are loaded one by one, and
    // those in vectors would have to be extracted.
    for (int k = 0; k < count; ++k) at[std::size_t(k)] = base[k] + offset[k];
    if (taps.ahead != nullptr && (t == 0 || t == taps.taps - 1)) {
#pragma GCC unroll 8
      for (int k = 0; k < count; ++k) __builtin_prefetch(texels + (taps.ahead[k] + offset[k]));
    }
    const auto add = [&](int k, float weight) {
      const Light c = light(at[std::size_t(k)]);
      r[k] += weight * c.r;
      g[k] += weight * c.g;
      b[k] += weight * c.b;
    };
    if (taps.share != nullptr && taps.scale == nullptr) {
      const float share = taps.share[t];
#pragma GCC ivdep
      for (int k = 0; k < count; ++k) add(k, share);
    } else if (taps.share != nullptr) {
      const float share = taps.share[t];
      const float* scale = taps.scale;
#pragma GCC ivdep
      for (int k = 0; k < count; ++k) add(k, share * scale[k]);
    } else {
      const float* weight = taps.weight[t].data();
      const float* scale = taps.scale;
#pragma GCC ivdep
      for (int k = 0; k < count; ++k) add(k, weight[k] * scale[k]);
    }
  }
}

/// A function of 0 … 1 at equally spaced places, linear between them.
class LinearTable {
 public:
  template <class Function>
  explicit LinearTable(Function function) {
    for (std::size_t k = 0; k < m_values.size(); ++k)
      m_values[k] = static_cast<float>(function(double(k) / steps));
  }
  [[nodiscard]] float operator()(float x) const {
    const float place = x * float(steps);
    const auto left = static_cast<std::int32_t>(place);
    const float share = place - static_cast<float>(left);
    return (1 - share) * m_values[std::size_t(left)] + share * m_values[std::size_t(left) + 1];
  }

 private:
  static constexpr std::size_t steps = 4096;
  std::array<float, steps + 2> m_values{};
};

/// Whether all values of a batch lie in 0 … most, where tables know the functions.
bool areWithin(const std::array<float, batchSize>& values, float most) {
  bool result = true;
  for (const float value : values) result &= value >= 0 && value <= most;
  return result;
}

/// Replaces all values: by a table if they are in its range, otherwise by the function itself.
template <class Table, class Function>
inline __attribute__((always_inline)) void convert(LightBatch& light, float most, Table table,
                                                   Function function) {
  for (auto* const channel : {&light.r, &light.g, &light.b}) {
    if (areWithin(*channel, most))
      for (float& value : *channel) value = table(value);
    else
      for (float& value : *channel) value = static_cast<float>(function(double(value)));
  }
}

}  // namespace

MULTIVERSIONED
void bracketingCells(const AxisLayout& layout, int cells, const std::uint32_t* cell,
                     const float* place, std::uint32_t* offset, float* weight) {
  const AxisLayout l = layout;
  for (int k = 0; k < batchSize; ++k) {
    const int before = place[k] < 0.5F ? 1 : 0;
    const int left = static_cast<int>(cell[k]) - before;
    const float share = place[k] - 0.5F + static_cast<float>(before);
    offset[k] = l(static_cast<std::uint32_t>(std::max(left, 0)));
    offset[batchSize + k] = l(static_cast<std::uint32_t>(std::min(left + 1, cells - 1)));
    weight[k] = 1 - share;
    weight[batchSize + k] = share;
  }
}

MULTIVERSIONED
void quantise(const float* codeValues, int count, std::uint8_t* bytes) {
  for (int k = 0; k < count; ++k) {
    const float positive = codeValues[k] > 0 ? codeValues[k] : 0;
    const float value = positive < 255 ? positive : 255;
    const auto whole = static_cast<std::int32_t>(value);
    // The fraction is exact; the sum of the value and a half may not be.
    const std::int32_t up = value - static_cast<float>(whole) >= 0.5F ? 1 : 0;
    bytes[k] = static_cast<std::uint8_t>(whole + up);
  }
}

MULTIVERSIONED
void decode(LightBatch& light) {
  static const LinearTable table([](double x) { return linearFromEncoded(255 * x); });
  const LinearTable* const known = &table;
  convert(
      light, 255, [known](float code) { return (*known)(code / 255); }, linearFromEncoded);
}

MULTIVERSIONED
void encodeMean(LightBatch& sum, int count) {
  // The encoding is nearly linear in the square root.
  static const LinearTable table([](double root) { return encodedFromLinear(root * root); });
  const LinearTable* const known = &table;
  const float share = 1 / static_cast<float>(count);
  for (auto* const channel : {&sum.r, &sum.g, &sum.b})
    for (float& value : *channel) value *= share;
  convert(
      sum, 1, [known](float light) { return (*known)(std::sqrt(light)); }, encodedFromLinear);
}

MULTIVERSIONED
void accumulate(const Texel<std::uint8_t>* texels, const TapBatch& taps, int count,
                LightBatch& sum) {
  sumTaps(texels, taps, count, sum,
          [texels](std::uint32_t at) { return encodedLight(texels, at); });
}

MULTIVERSIONED
void accumulate(const Texel<std::uint16_t>* texels, const TapBatch& taps, int count,
                LightBatch& sum) {
  sumTaps(texels, taps, count, sum,
          [texels](std::uint32_t at) { return encodedLight(texels, at); });
}

MULTIVERSIONED
void accumulate(const Texel<float>* texels, const TapBatch& taps, int count, LightBatch& sum) {
  sumTaps(texels, taps, count, sum,
          [texels](std::uint32_t at) { return encodedLight(texels, at); });
}

template <class T>
void accumulateLinear(const Texel<T>* texels, const TapBatch& taps, int count, LightBatch& sum) {
  sumTaps(texels, taps, count, sum, [texels](std::uint32_t at) {
    const Light c = encodedLight(texels, at);
    return Light{static_cast<float>(linearFromEncoded(c.r)),
                 static_cast<float>(linearFromEncoded(c.g)),
                 static_cast<float>(linearFromEncoded(c.b))};
  });
}

template <class T>
void accumulateDriven(const Texel<T>* texels, const TapBatch& taps, int count,
                      const LightErrors& panel, LightBatch& sum) {
  sumTaps(texels, taps, count, sum, [texels, &panel](std::uint32_t at) {
    const Light c = encodedLight(texels, at);
    return Light{static_cast<float>(panelLight(panel, double(c.r))),
                 static_cast<float>(panelLight(panel, double(c.g))),
                 static_cast<float>(panelLight(panel, double(c.b)))};
  });
}

template void accumulateDriven(const Texel<std::uint8_t>*, const TapBatch&, int, const LightErrors&,
                               LightBatch&);
template void accumulateDriven(const Texel<std::uint16_t>*, const TapBatch&, int,
                               const LightErrors&, LightBatch&);
template void accumulateDriven(const Texel<float>*, const TapBatch&, int, const LightErrors&,
                               LightBatch&);
template void accumulateLinear(const Texel<std::uint8_t>*, const TapBatch&, int, LightBatch&);
template void accumulateLinear(const Texel<std::uint16_t>*, const TapBatch&, int, LightBatch&);
template void accumulateLinear(const Texel<float>*, const TapBatch&, int, LightBatch&);

}  // namespace hogelscope
