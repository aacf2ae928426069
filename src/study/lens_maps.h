// SPDX-License-Identifier: BSD-3-Clause
// Maps of the success of lens inverses over planes of two coefficients.
#pragma once

#include <array>
#include <string>

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "study/lens_outcomes.h"

namespace hogelscope {

/// A plane of lenses: two coefficients from -reach to reach, the others 0. The camera is the
/// paper's, 60° over 600×600 pixels; the worst of 9×9 of its pixels counts.
struct LensPlane {
  std::string name;                   ///< such as "k1_k2"
  std::array<std::string, 2> axes;    ///< such as "k1", "k2"
  double DistortionParams::*across;   ///< the coefficient along the map's x axis
  double DistortionParams::*upwards;  ///< the coefficient along y
  int stepsPerSide;                   ///< the map has 2·stepsPerSide + 1 lenses per side
  int stepsPerUnit;
  [[nodiscard]] int side() const { return 2 * stepsPerSide + 1; }
  [[nodiscard]] double reach() const { return at(side() - 1); }
  /// Returns a coefficient by its index in [0, side()).
  [[nodiscard]] double at(int index) const { return double(index - stepsPerSide) / stepsPerUnit; }
  [[nodiscard]] DistortionParams lens(double x, double y) const;
};

struct LensMap {
  LensPlane plane;
  /// The outcomes of each of inverseMethods(): side()² lenses, in ascending y, x fastest.
  std::vector<std::vector<LensOutcomes>> outcomes;
  /// The line where the fold enters the image, as polylines of (x, y).
  std::vector<std::vector<Vec2>> foldLine;
};

/// Returns the planes of the radial coefficients k1, k2 and of the tangential p1, p2.
const std::vector<LensPlane>& lensPlanes();

/// Measures the map of a plane. Throws Cancelled.
LensMap measureMap(const LensPlane& plane, const ParallelRows& parallelRows,
                   const Progress& progress);

/// Returns the camera of the maps and of the paper's Table I with a lens.
LensKey paperCamera(const DistortionParams& distortion);

}  // namespace hogelscope
