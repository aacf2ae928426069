// SPDX-License-Identifier: BSD-3-Clause
// Leakage within a hogel as a linear map, and its transpose. A window cut by the hogel's border is
// still a rectangle, so that the map is a product of one over v and one over u for all borders
// (docs/formulas.md, Optimised content).
#pragma once

#include <span>
#include <vector>

#include "core/optics/psf.h"

namespace hogelscope {

/// The leakage along one axis: row k says how much of the light seen in direction k is that of each
/// other direction.
class AxisLeakage {
 public:
  AxisLeakage(const PsfParams& psf, int directions);

  [[nodiscard]] int directions() const { return m_directions; }
  [[nodiscard]] int reach() const { return m_reach; }
  /// Returns for each k = 0 … directions − 1 the weight of direction k + tap, |tap| ≤ reach; 0 for
  /// those outside.
  [[nodiscard]] std::span<const double> weights(int tap) const { return row(m_weights, tap); }
  /// Returns the same of the transpose: the weight of direction k in that of k + tap.
  [[nodiscard]] std::span<const double> transposed(int tap) const { return row(m_transposed, tap); }

 private:
  [[nodiscard]] std::span<const double> row(const std::vector<double>& all, int tap) const {
    return std::span(all).subspan(std::size_t(tap + m_reach) * std::size_t(m_directions),
                                  std::size_t(m_directions));
  }

  int m_directions;
  int m_reach;
  std::vector<double> m_weights, m_transposed;  ///< for each tap, one for each direction
};

/// The map L of a hogel's directional pixels, dv rows of du values. Rows in memory have a margin of
/// zeros on both sides, which apply() reads.
class HogelLeakage {
 public:
  HogelLeakage(const PsfParams& psf, int du, int dv) : m_u(psf, du), m_v(psf, dv) {}

  [[nodiscard]] const AxisLeakage& across() const { return m_u; }
  [[nodiscard]] const AxisLeakage& down() const { return m_v; }

  /// A hogel's values for one colour; `margin` zeros on both sides of each row.
  struct Plane {
    Plane(int columns, int rows, int marginOfRows)
        : du(columns), dv(rows), margin(marginOfRows), values(std::size_t(rows) * stride(), 0) {}
    [[nodiscard]] std::size_t stride() const { return std::size_t(du + 2 * margin); }
    [[nodiscard]] double* row(int v) { return &values[std::size_t(v) * stride()] + margin; }
    [[nodiscard]] const double* row(int v) const {
      return &values[std::size_t(v) * stride()] + margin;
    }

    int du;
    int dv;
    int margin;
    std::vector<double> values;
  };

  /// Write L x, and Lᵀ x. All planes have du × dv values and a margin of at least the reach; `work`
  /// is neither of the others.
  void apply(const Plane& x, Plane& result, Plane& work) const;
  void applyTransposed(const Plane& x, Plane& result, Plane& work) const;

 private:
  AxisLeakage m_u;
  AxisLeakage m_v;
};

}  // namespace hogelscope
