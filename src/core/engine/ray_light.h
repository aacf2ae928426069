// SPDX-License-Identifier: BSD-3-Clause
// The light of a batch of rays from one point of an aperture: their cells, the texels there, and
// what a twin makes of their light.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/engine/texel_filter.h"
#include "core/engine/view_rays.h"
#include "core/optics/field_leakage.h"

namespace hogelscope {

class RayLight {
 public:
  /// Working memory of one thread.
  struct Scratch {
    std::array<CellBatch, 3>
        cells{};  ///< of red, green, blue; the first alone if all have the same
    TexelFilter::Scratch taps;
    LightBatch channel{};
    CellBatch beside{};
    LightBatch tap{};
    /// Returns 255 for rays that see the display, 0 for others.
    [[nodiscard]] const std::array<std::uint8_t, batchSize>& seen() const { return cells[0].seen; }
  };

  /// Refers to its parameters, which must outlive this object.
  RayLight(const ViewRays& rays, const TexelFilter& filter);

  /// Finds the light of `count` rays, as TexelFilter::sum() does; undefined where `scratch.seen()`
  /// is 0. Returns false if no ray sees the display.
  bool find(const IdealBatch& ideals, int count, std::size_t point, Scratch& scratch,
            LightBatch& light) const;

 private:
  void dropDead(int count, const CellBatch& cells, LightBatch& light) const;
  void change(int count, const Scratch& scratch, LightBatch& light) const;

  void sum(int count, const CellBatch& cells, Scratch& scratch, LightBatch& light) const;
  void sumSpot(int count, const CellBatch& cells, Scratch& scratch, LightBatch& light) const;
  void sumField(int count, const CellBatch& cells, LightBatch& light) const;

  const ViewRays& m_rays;
  std::optional<FieldLeakage> m_leakage;  ///< if it differs over the field
  const TexelFilter& m_filter;
  std::span<const double> m_spot;  ///< LensSheet::spot
};

}  // namespace hogelscope
