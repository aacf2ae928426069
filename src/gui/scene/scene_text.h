// SPDX-License-Identifier: BSD-3-Clause
// What the read-out under the 3-D scene says, with units.
#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/optics/pixel_trace.h"

namespace hogelscope {

class SceneText {
  Q_DECLARE_TR_FUNCTIONS(SceneText)

 public:
  /// Whether the display's light reaches a state's eye.
  static QString eye(const CameraState& state, const DisplayParams& display);
  /// A picked pixel, its ray and what that meets.
  static QString pixel(int x, int y, const PixelTrace& trace);
  /// A hogel's indices, short enough for the scene.
  static QString hogelName(int i, int j);
  /// A picked hogel.
  static QString hogel(const DisplayParams& display, int i, int j);
};

}  // namespace hogelscope
