// SPDX-License-Identifier: BSD-3-Clause
// Dense optical flow from a view to its neighbours, and votes on occlusions.
#pragma once

#include <functional>
#include <opencv2/core.hpp>

#include "capture/order/view_order.h"

namespace cv {
class DISOpticalFlow;
}  // namespace cv

namespace hogelscope {

/// Dense motion from one view to another, and where it is reliable: the motion back leads to the
/// same pixel, and the values agree.
struct DenseMotion {
  cv::Mat2f shift;  ///< pixels
  cv::Mat1b isSure;
};

/// Measures motion. Keeps the buffers of the flow, because allocating them takes a third of its
/// time.
class MotionFinder {
 public:
  MotionFinder();
  /// Returns the motion between 8-bit grey images of one size.
  DenseMotion between(const cv::Mat1b& from, const cv::Mat1b& to);

 private:
  cv::Mat2f flow(const cv::Mat1b& from, const cv::Mat1b& to);

  cv::Ptr<cv::DISOpticalFlow> m_flow;
};

/// Returns where an image, moved along axis 0 (x) or 1 (y) by 4 to 28 pixels, looks the same, so
/// that its motion is ambiguous: at repeated patterns, and at edges along the axis.
cv::Mat1b repetitions(const cv::Mat1b& picture, int axis);

/// A view and its motion to the views `step` before and after it in its row or column; at a border
/// one is missing.
struct Neighbours {
  cv::Mat1b view;
  int step = 1;
  DenseMotion before;
  DenseMotion after;
  [[nodiscard]] bool hasBefore() const { return !before.shift.empty(); }
  [[nodiscard]] bool hasAfter() const { return !after.shift.empty(); }
};

/// Returns the motion of each pixel from one view to the next, and where it is reliable: where both
/// neighbours agree, or the only one is reliable; empty without any.
DenseMotion motionPerView(const Neighbours& neighbours);

/// Counts, along image axis 0 (x) or 1 (y), which of two pixels that move to one pixel of another
/// view is seen there. The motion is that to the neighbour on the other side of the view, which
/// also shows the surface that is hidden in the target. `repeats` are the view's repetitions()
/// along the axis. `target(t)` returns the view t steps further, for t within [-before, after].
Occlusions occlusionsIn(const Neighbours& neighbours, const cv::Mat1b& repeats, int axis,
                        int before, int after, const std::function<cv::Mat1b(int)>& target);

}  // namespace hogelscope
