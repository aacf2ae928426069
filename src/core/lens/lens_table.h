// SPDX-License-Identifier: BSD-3-Clause
// The rays of a lens, one for each (sub-)pixel of an image, computed once and shared by all states
// with the same lens and resolution.
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <vector>

#include "core/base/huge_pages.h"
#include "core/base/parallel.h"
#include "core/lens/lens_rays.h"
#include "core/lens/lens_strips.h"

namespace hogelscope {

class LensTable {
 public:
  /// Throws Cancelled.
  LensTable(const LensKey& key, const ParallelRows& parallelRows, const Progress& progress = {});

  /// Return the ideal points of one ray of each pixel of image row `y`: res[0] x and as many y; NaN
  /// where there is no ray.
  [[nodiscard]] const double* x(int y, const RaySample& s) const { return &m_x[at(y, s.index)]; }
  [[nodiscard]] const double* y(int y, const RaySample& s) const { return &m_y[at(y, s.index)]; }
  /// Returns the strips of the image, if the key has strips.
  [[nodiscard]] const LensStrips* strips() const { return m_strips.data(); }
  /// Returns the bytes that a table takes in memory without strips.
  static std::size_t bytes(const std::array<int, 2>& res, int samplesPerPixel);
  static std::size_t bytes(const LensKey& key);

 private:
  [[nodiscard]] std::size_t at(int y, int sample) const;

  LensKey m_key;
  std::vector<double, HugePageAllocator<double>> m_x;
  std::vector<double, HugePageAllocator<double>> m_y;
  std::vector<LensStrips> m_strips;
};

/// Keeps the latest tables, up to a total size. Not thread-safe.
class LensTables {
 public:
  static constexpr std::size_t largestBytes = std::size_t{256} << 20;

  /// Returns a table; `progress` is called while a new one is computed. Throws Cancelled.
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
