// SPDX-License-Identifier: BSD-3-Clause
// How the content of one view moves to its neighbours, and what hides what on the way.
#pragma once

#include <array>
#include <functional>
#include <opencv2/core.hpp>

#include "capture/order/view_order.h"

namespace cv {
class DISOpticalFlow;
}  // namespace cv

namespace hogelscope {

/// Dense motion from one view to another, and where it can be trusted: there the motion back leads
/// to the same pixel, which has the same value.
struct DenseMotion {
  cv::Mat2f shift;  ///< pixels
  cv::Mat1b isSure;
};

/// Measures motion. Keeps the buffers of the flow: to allocate them anew takes a third of its time.
class MotionFinder {
 public:
  MotionFinder();
  /// Both pictures are 8-bit grey and of one size.
  DenseMotion between(const cv::Mat1b& from, const cv::Mat1b& to);

 private:
  cv::Mat2f flow(const cv::Mat1b& from, const cv::Mat1b& to);

  cv::Ptr<cv::DISOpticalFlow> m_flow;
};

/// Returns where a picture, moved along axis 0 (x) or 1 (y) by 4 to 28 pixels, looks as it did:
/// there a motion may as well be another. Repeated patterns are such places, and edges along the
/// axis.
cv::Mat1b repetitions(const cv::Mat1b& picture, int axis);

/// A view and those before and after it in its row or column, at `step`; at a border one is
/// missing.
struct Neighbours {
  cv::Mat1b view;
  int step = 1;
  DenseMotion before;
  DenseMotion after;
  [[nodiscard]] bool hasBefore() const { return !before.shift.empty(); }
  [[nodiscard]] bool hasAfter() const { return !after.shift.empty(); }
};

/// Returns the motion of each pixel from one view to the next, and where it can be trusted: where
/// both neighbours say the same, or the only one; empty without any.
DenseMotion motionPerView(const Neighbours& neighbours);

/// Judges, along picture axis 0 (x) or 1 (y), which of two pixels that arrive at one pixel of
/// another view is seen there. The motion comes from the neighbour on the other side of the view,
/// so what is hidden there was not needed to measure it, and `repeats` are the view's repetitions()
/// along the axis. `target(t)` is the view t steps further;
/// it is called for t within [-before, after].
Occlusions occlusionsIn(const Neighbours& neighbours, const cv::Mat1b& repeats, int axis,
                        int before, int after, const std::function<cv::Mat1b(int)>& target);

}  // namespace hogelscope
