// SPDX-License-Identifier: BSD-3-Clause
// Chooses what the simulated view shows of a state with two eyes.
#pragma once

#include <QPoint>
#include <optional>

#include "core/optics/eyes.h"
#include "core/optics/simulate.h"
#include "core/optics/stereo_image.h"

namespace hogelscope {

enum class StereoView { head, left, right, sideBySide, anaglyph, anaglyphGrey, crossEyed };

/// Returns how the images of both eyes are joined; none if the view is of one eye.
inline std::optional<StereoMode> jointModeOf(StereoView view) {
  if (view < StereoView::sideBySide) return std::nullopt;
  return static_cast<StereoMode>(int(view) - int(StereoView::sideBySide));
}

/// A pixel of one eye's image.
struct EyePixel {
  CameraState state;
  QPoint pixel;
};

/// The same, with the job that renders the image.
struct PickedView {
  RenderJob job;
  QPoint pixel;
};

/// Returns the eye that a pixel of the view belongs to; an anaglyph's are the left eye's. A state
/// with one eye is always shown itself.
inline EyePixel eyeAt(StereoView view, const CameraState& state, const DisplayParams& display,
                      QPoint pixel) {
  if (view == StereoView::head || !hasTwoEyes(state)) return {state, pixel};
  Eye eye = view == StereoView::right ? Eye::right : Eye::left;
  const int width = state.camera.res[0];
  if (view == StereoView::sideBySide || view == StereoView::crossEyed) {
    const bool isSecond = pixel.x() >= width;
    eye = isSecond == (view == StereoView::sideBySide) ? Eye::right : Eye::left;
    if (isSecond) pixel.rx() -= width;
  }
  return {eyeOf(state, display, eye), pixel};
}

}  // namespace hogelscope
