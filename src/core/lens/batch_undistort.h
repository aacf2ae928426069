// SPDX-License-Identifier: BSD-3-Clause
// The inverse of a lens for many points, equal to Distortion::undistort.
#pragma once

#include "core/base/progress.h"
#include "core/lens/lens_shadow.h"
#include "core/optics/distortion.h"
#include "core/optics/lens_branch.h"

namespace hogelscope {

/// Inverts a lens in batches. Within a certain radius of ideal points the Jacobian is positive
/// definite, so the model is injective there, and preimages of segments up to a certain length stay
/// in it: any root that Newton finds there is the right one. Elsewhere runs of points follow their
/// branch together from there on.
class BatchUndistort {
 public:
  /// `progress` is called before each point that Distortion inverts, which takes up to some
  /// milliseconds near a fold.
  explicit BatchUndistort(const Distortion& distortion, Progress progress = {});

  /// Replaces `count` distorted points by ideal ones; NaN where there is no ray.
  /// Throws Cancelled.
  void undistort(double* x, double* y, int count) const;

 private:
  [[nodiscard]] double leastEigenvalue(double radius) const;
  void undistortBatch(double* x, double* y, int count) const;
  bool solveInSector(const Vec2& distorted, Vec2& ideal) const;
  [[nodiscard]] BranchStart certainStart(const Disc& disc) const;
  void followRun(double* x, double* y, int count, const BranchStart& start) const;
  bool solveFrom(const Vec2& start, double* x, double* y, int count) const;

  Distortion m_distortion;
  Progress m_progress;
  mutable LensShadow m_shadow;    ///< safe to use from several threads
  double m_certainRadius = 0;     ///< radius of ideal points
  double m_certainDistorted = 0;  ///< radius of distorted points
};

}  // namespace hogelscope
