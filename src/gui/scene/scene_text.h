// SPDX-License-Identifier: BSD-3-Clause
// What the read-out under the 3-D scene says, with units.
#pragma once

#include <QCoreApplication>
#include <QString>

#include "core/optics/pixel_inspection.h"

namespace hogelscope {

class SceneText {
  Q_DECLARE_TR_FUNCTIONS(SceneText)

 public:
  /// Whether the display's light reaches a state's eye.
  static QString eye(const CameraState& state, const DisplayParams& display);
  /// A pixel in one line.
  static QString pixel(int x, int y, const PixelTrace& trace);
  /// Its ray and what that meets, in lines that follow; "" where there is none.
  static QString ray(const PixelTrace& trace);
  /// What it shows, and if that is black, why.
  static QString verdict(const PixelTrace& trace, const DisplayParams& display);
  /// A hogel's indices, short enough for the scene.
  static QString hogelName(int i, int j);
  /// A picked hogel.
  static QString hogel(const DisplayParams& display, int i, int j);
};

}  // namespace hogelscope
