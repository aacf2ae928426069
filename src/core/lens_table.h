// SPDX-License-Identifier: BSD-3-Clause
// The rays of a lens, one for each (sub-)pixel of a picture: computed once, shared by all states
// that have the lens and the resolution.
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <vector>

#include "core/camera.h"
#include "core/quick_inverse.h"
#include "core/sampling.h"

namespace hogelscope {

/// Runs `rows(begin, end)` over [0, count), perhaps on several threads.
using ParallelRows =
    std::function<void(int count, const std::function<void(int begin, int end)>& rows)>;
/// On the calling thread.
void serialRows(int count, const std::function<void(int begin, int end)>& rows);

/// All that a lens table depends on.
struct LensKey {
  DistortionParams distortion;
  LensMapping mapping = LensMapping::exact;
  std::array<int, 2> res{};
  Vec2 focalLength;  ///< pixels, across and down
  Vec2 centre;       ///< pixels
  int samplesPerPixel = 1;
  bool operator==(const LensKey&) const = default;
};

/// Ideal points of pixels [x0, x0 + count) of row y, sub-pixel (sx, sy); not numbers where there is
/// no ray.
void lensRow(const LensKey& key, const QuickInverse& inverse, int y, int sx, int sy, int x0,
             int count, double* idealX, double* idealY);

class LensTable {
 public:
  LensTable(const LensKey& key, const ParallelRows& parallelRows);

  /// Ideal points of picture row `y`, sub-pixel (sx, sy): res[0] x and as many y; not numbers
  /// where there is no ray.
  [[nodiscard]] const double* x(int y, int sx, int sy) const { return &m_x[at(y, sx, sy)]; }
  [[nodiscard]] const double* y(int y, int sx, int sy) const { return &m_y[at(y, sx, sy)]; }
  static std::size_t bytes(const LensKey& key);

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

  std::shared_ptr<const LensTable> get(const LensKey& key, const ParallelRows& parallelRows);

 private:
  struct Entry {
    LensKey key;
    std::shared_ptr<const LensTable> table;
  };
  std::list<Entry> m_entries;  ///< the latest first
};

}  // namespace hogelscope
