// SPDX-License-Identifier: BSD-3-Clause
// The rays of a lens, one for each (sub-)pixel of a picture: computed once, shared by all states
// that have the lens and the resolution.
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <vector>

#include "core/base/parallel.h"
#include "core/lens/lens_rays.h"

namespace hogelscope {

class LensTable {
 public:
  /// Throws Cancelled.
  LensTable(const LensKey& key, const ParallelRows& parallelRows, const Progress& progress = {});

  /// Ideal points of picture row `y`, sub-pixel (sx, sy): res[0] x and as many y; not numbers
  /// where there is no ray.
  [[nodiscard]] const double* x(int y, int sx, int sy) const { return &m_x[at(y, sx, sy)]; }
  [[nodiscard]] const double* y(int y, int sx, int sy) const { return &m_y[at(y, sx, sy)]; }
  /// Of a table in memory.
  static std::size_t bytes(const std::array<int, 2>& res, int samplesPerPixel);

 private:
  [[nodiscard]] std::size_t at(int y, int sx, int sy) const;

  LensKey m_key;
  std::vector<double> m_x;
  std::vector<double> m_y;
};

/// Keeps the latest tables, up to a size. Not for several threads.
class LensTables {
 public:
  static constexpr std::size_t largestBytes = std::size_t{256} << 20;

  /// `progress` hears of a new table. Throws Cancelled.
  std::shared_ptr<const LensTable> get(const LensKey& key, const ParallelRows& parallelRows,
                                       const Progress& progress = {});

 private:
  struct Entry {
    LensKey key;
    std::shared_ptr<const LensTable> table;
  };
  std::list<Entry> m_entries;  ///< the latest first
};

}  // namespace hogelscope
