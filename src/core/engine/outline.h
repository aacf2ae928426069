// SPDX-License-Identifier: BSD-3-Clause
// The part of an image's rows whose rays may meet the display.
#pragma once

#include <array>
#include <vector>

#include "core/engine/hit_map.h"

namespace hogelscope {

/// A part of a row of the image plane; there is none unless first <= last.
using RowPart = std::array<double, 2>;

class Outline {
 public:
  explicit Outline(const HitMap& map);

  /// Whether parts are known: not of all finders' maps.
  [[nodiscard]] bool isKnown() const { return !m_indices.empty(); }
  /// Returns the part of `row`, at y, beside which no ray hits, but for rounding.
  [[nodiscard]] RowPart mayHit(double y, const RowPart& row) const { return partOf(y, row, 1); }
  /// Returns the part in which all do, again but for rounding; none if that is not known.
  [[nodiscard]] RowPart hits(double y, const RowPart& row) const {
    return m_knowsHits ? partOf(y, row, -1) : RowPart{1, 0};
  }

 private:
  /// An index of a hit, times d.z, which is below 0. It is 0 … count where hits do not depend on
  /// whole hogels or lenses; else rays may hit, or miss, that are within a margin of these ends.
  struct Index {
    PlaneFunction timesZ;
    double count;
    double margin;
  };

  [[nodiscard]] RowPart partOf(double y, RowPart row, double side) const;
  void add(const PlaneFunction& timesZ, int count, double margin);
  void addDesign(const HitMap& map);
  void addAffine(const HitMap& map);
  void addSheet(const HitMap& map);

  PlaneFunction m_z;
  bool m_knowsHits;
  std::vector<Index> m_indices;
};

}  // namespace hogelscope
