// SPDX-License-Identifier: BSD-3-Clause
// The rays of a lens for an image, row by row.
#pragma once

#include <array>
#include <vector>

#include "core/lens/batch_undistort.h"
#include "core/optics/method.h"
#include "core/optics/sampling.h"

namespace hogelscope {

/// Everything that an image's rays in the camera frame depend on.
struct LensKey {
  DistortionParams distortion;
  LensMapping mapping = LensMapping::exact;
  std::array<int, 2> res{};
  Vec2 focalLength;  ///< pixels, across and down
  Vec2 centre;       ///< pixels
  int samplesPerPixel = 1;
  LensInverse inverse = LensInverse::exact;
  int steps = 0;           ///< steps of the inverse
  bool hasStrips = false;  ///< of its table, with one ray a pixel
  /// Returns the point of the plane z = 1 under a pixel.
  [[nodiscard]] Vec2 onSensor(double px, double py) const {
    return {(px - centre.x) / focalLength.x, (py - centre.y) / focalLength.y};
  }
  bool operator==(const LensKey&) const = default;
};

class LensRays {
 public:
  /// `progress` is passed to BatchUndistort. Throws Cancelled.
  explicit LensRays(const LensKey& key, const Progress& progress = {});

  /// Writes the ideal points of one ray of each of the pixels [x0, x0 + count) of row y; NaN where
  /// there is no ray. Throws Cancelled.
  void row(int y, const RaySample& sample, int x0, int count, double* idealX, double* idealY) const;

 private:
  void invert(double* x, double* y, int count) const;
  void makeNodes();
  [[nodiscard]] Vec2 betweenNodes(double px, double py) const;

  LensKey m_key;
  BatchUndistort m_exact;
  int m_nodesAcross = 0;
  std::vector<double> m_nodeX;  ///< LensInverse::table: rows of exact ideal points
  std::vector<double> m_nodeY;
};

}  // namespace hogelscope
