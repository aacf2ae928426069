// SPDX-License-Identifier: BSD-3-Clause
// The inverse of a lens for many points, 128 at once, equal to Distortion::undistort.
#pragma once

#include "core/base/progress.h"
#include "core/lens/lens_fans.h"
#include "core/optics/distortion.h"

namespace hogelscope {

/// Inverts a lens in batches of points. Within a certain radius of ideal points the Jacobian is
/// positive definite, so the model is injective there, and preimages of segments up to a certain
/// length stay in it: any root that Newton finds there is the right one. Elsewhere Newton starts
/// from the certified facts of a point's direction, and near a fold each point follows its branch.
class BatchUndistort {
 public:
  /// `progress` is called before each step along a branch. Throws Cancelled.
  explicit BatchUndistort(const Distortion& distortion, Progress progress = {});

  /// Replaces `count` distorted points by ideal ones; NaN where there is no ray.
  /// Throws Cancelled.
  void undistort(double* x, double* y, int count) const;

 private:
  [[nodiscard]] double leastEigenvalue(double radius) const;
  void undistortBatch(double* x, double* y, int count) const;

  Distortion m_distortion;
  Progress m_progress;
  LensFans m_fans;
  double m_certainRadius = 0;     ///< radius of ideal points
  double m_certainDistorted = 0;  ///< radius of distorted points
};

}  // namespace hogelscope
