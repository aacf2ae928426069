// SPDX-License-Identifier: BSD-3-Clause
// The rays of a lens, one for each (sub-)pixel of a picture: computed once, shared by all states
// that have the lens and the resolution; and the lens' certificate.
#pragma once

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <vector>

#include "core/camera.h"
#include "core/distortion.h"
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
  double focalLength = 0;  ///< pixels
  Vec2 centre;             ///< pixels
  int samplesPerPixel = 1;
  bool operator==(const LensKey&) const = default;
};

/// How far a lens can be trusted.
struct LensCertificate {
  double validRadius = 0;      ///< largest |ideal point| with a ray, in units of the plane z = 1
  double worstResidual = 0;    ///< of model(ideal) - pixel, over the pixels with a ray, in pixels
  std::size_t withoutRay = 0;  ///< pixels
  std::size_t pixels = 0;
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
  [[nodiscard]] LensCertificate certificate() const;
  static std::size_t bytes(const LensKey& key);

 private:
  [[nodiscard]] std::size_t at(int y, int sx, int sy) const;

  LensKey m_key;
  Distortion m_distortion;
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
