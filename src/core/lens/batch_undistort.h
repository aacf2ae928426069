// SPDX-License-Identifier: BSD-3-Clause
// The inverse of a lens for many points: the same as Distortion::undistort, in batches.
#pragma once

#include "core/base/progress.h"
#include "core/optics/distortion.h"

namespace hogelscope {

/// Within a certain radius of ideal points the Jacobian is positive definite, so the model is
/// injective there, and preimages of all segments shorter than a certain length stay in it: any
/// root that Newton finds there is the right one. Other points go Distortion's certified way.
class BatchUndistort {
 public:
  /// `progress` is asked before each point that goes the certified way, which takes up to some
  /// milliseconds near a fold.
  explicit BatchUndistort(const Distortion& distortion, Progress progress = {});

  /// Puts ideal points in the place of `count` distorted ones; not numbers where there is no ray.
  /// Throws Cancelled.
  void undistort(double* x, double* y, int count) const;

 private:
  [[nodiscard]] double leastEigenvalue(double radius) const;
  void undistortBatch(double* x, double* y, int count) const;

  Distortion m_distortion;
  Progress m_progress;
  double m_certainRadius = 0;     ///< of ideal points
  double m_certainDistorted = 0;  ///< of distorted points
};

}  // namespace hogelscope
