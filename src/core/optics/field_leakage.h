// SPDX-License-Identifier: BSD-3-Clause
// Light leakage that differs over the field or between colours: a twin's (docs/formulas.md, Twin).
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/optics/psf.h"
#include "core/panel/twin.h"

namespace hogelscope {

class FieldLeakage {
 public:
  /// Whether a twin's leakage is another than the state's own.
  static bool isNeeded(const Twin* twin, const PsfParams& psf);

  FieldLeakage(const Twin& twin, const PsfParams& psf);

  /// Returns n: (2n + 1)² directional pixels leak into one.
  [[nodiscard]] int reach() const { return m_reach; }
  /// Returns P'(u, v) of a directional pixel, in the light that is summed, as Psf::leaked() does;
  /// `texel(TexelIndex)` is the light of a pixel, decoded.
  template <class TexelLight>
  [[nodiscard]] Rgb leaked(const LightFieldSize& size, const TexelIndex& at,
                           const TexelLight& texel) const;
  /// Returns the weights of a channel's taps at direction (u, v), row by row, not normalised.
  [[nodiscard]] std::vector<double> weights(int u, int v, std::size_t channel,
                                            const TapRange& across, const TapRange& down) const;
  /// Returns those of all taps.
  [[nodiscard]] std::vector<double> weights(int u, int v, std::size_t channel) const {
    return weights(u, v, channel, {-m_reach, m_reach}, {-m_reach, m_reach});
  }

 private:
  [[nodiscard]] std::vector<double> alongAxis(double sigma, std::size_t axis,
                                              std::size_t channel) const;

  const Twin& m_twin;
  PsfParams m_psf;
  LightFieldSize m_size;
  int m_reach = 0;
  /// The diffraction pattern along each axis, of each channel; one weight if there is none.
  std::array<std::array<std::vector<double>, 3>, 2> m_diffraction;
};

template <class TexelLight>
Rgb FieldLeakage::leaked(const LightFieldSize& size, const TexelIndex& at,
                         const TexelLight& texel) const {
  std::array<double, 3> sum{};
  std::array<double, 3> total{};
  const bool hasColours = m_twin.leaksByColour();
  // Taps beside the hogel count where they give light or take it from the mean.
  const auto taps = [this](int own, int count) {
    return m_psf.border == PsfBorder::renormalise
               ? TapRange{std::max(-m_reach, -own), std::min(m_reach, count - 1 - own)}
               : TapRange{-m_reach, m_reach};
  };
  const TapRange across = taps(at.u, size.du);
  const TapRange down = taps(at.v, size.dv);
  std::array<std::vector<double>, 3> weight;
  for (std::size_t c = 0; c < (hasColours ? 3 : 1); ++c)
    weight[c] = weights(at.u, at.v, c, across, down);
  std::size_t k = 0;
  for (int y = down.first; y <= down.last; ++y)
    for (int x = across.first; x <= across.last; ++x, ++k) {
      TexelIndex tap{at.i, at.j, at.u + x, at.v + y};
      if (m_psf.border == PsfBorder::clamp) {
        tap.u = std::clamp(tap.u, 0, size.du - 1);
        tap.v = std::clamp(tap.v, 0, size.dv - 1);
      }
      const bool isInside = tap.u >= 0 && tap.u < size.du && tap.v >= 0 && tap.v < size.dv;
      const Rgb light = isInside ? texel(tap) : Rgb{};
      for (std::size_t c = 0; c < 3; ++c) {
        const double w = weight[hasColours ? c : 0][k];
        sum[c] += w * std::array{light.r, light.g, light.b}[c];
        total[c] += w;
      }
    }
  return {sum[0] / total[0], sum[1] / total[1], sum[2] / total[2]};
}

}  // namespace hogelscope
