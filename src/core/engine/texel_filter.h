// SPDX-License-Identifier: BSD-3-Clause
// Sums the light of a batch of rays over taps along four axes, hogels i, j and directions u, v: one
// tap where nothing is interpolated or leaks, two for interpolation, a window for leakage.
// A texel's address is the sum of four parts, so taps add up axis by axis. The next batch's
// addresses are computed while this batch's texels come from memory.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/engine/plan.h"
#include "core/engine/tap_kernels.h"

namespace hogelscope {

/// The taps of a batch along one axis: tap t of ray k adds offset[t][k] to its address.
struct AxisTaps {
  int taps = 1;
  const float* share = nullptr;  ///< weights common to all rays; null: `weight` is used
  std::vector<std::array<std::uint32_t, batchSize>> offset;
  std::vector<std::array<float, batchSize>> weight;
};

class TexelFilter {
 public:
  /// Working memory of one thread.
  struct Scratch {
    std::array<AxisTaps, 4> axes;
    std::vector<float> share;
  };

  TexelFilter(std::shared_ptr<const LightField> lightField, const RenderJob& job, const Plan& plan);

  /// Sums the light of the batch's first `count` rays: code values, or linear light if the plan
  /// says so. All lanes' cells must lie in the light field.
  void sum(int count, const CellBatch& batch, Scratch& scratch, LightBatch& sum) const;

  [[nodiscard]] const LightField& texels() const { return *m_lightField; }
  /// Returns the light of one texel, in the light that is summed.
  [[nodiscard]] Rgb lightOf(const TexelIndex& at) const;

 private:
  /// The weights along a direction axis, for each cell of it.
  struct AxisWeights {
    int reach = 0;
    int cells = 0;
    int firstInner = 0;  ///< cells [firstInner, lastInner] have all taps inside
    int lastInner = -1;
    std::vector<float> weights;  ///< (2·reach + 1) for each cell, normalised; 0 outside
    [[nodiscard]] const float* of(int cell) const {
      return &weights[std::size_t(cell) * std::size_t(2 * reach + 1)];
    }
  };

  static AxisWeights axisWeights(const PsfParams& psf, int reach, int cells);
  void tapsOf(std::size_t axis, const CellBatch& batch, AxisTaps& taps) const;
  void nearestTap(std::size_t axis, const CellBatch& batch, AxisTaps& taps) const;
  void linearTaps(std::size_t axis, const CellBatch& batch, AxisTaps& taps) const;
  void directionTaps(std::size_t axis, const CellBatch& batch, AxisTaps& taps) const;
  void interpolatedTaps(std::size_t axis, const CellBatch& batch, AxisTaps& taps) const;
  void dropDead(std::size_t axis, const CellBatch& batch, AxisTaps& taps) const;
  void addTaps(int count, const TapBatch& taps, LightBatch& sum) const;
  [[nodiscard]] const AxisLayout& layoutOf(std::size_t axis) const;

  std::shared_ptr<const LightField> m_lightField;
  Reconstruction m_reconstruction;
  bool m_leaks;
  bool m_sumsLinear;
  std::array<int, 4> m_cells;
  std::array<AxisWeights, 2> m_weights;  ///< along u and v
  std::shared_ptr<const Twin> m_twin;    ///< only if it drives texels
};

}  // namespace hogelscope
