// SPDX-License-Identifier: BSD-3-Clause
// Texts about pixels, hogels and lengths, with units.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <vector>

#include "core/optics/pixel_inspection.h"

namespace hogelscope {

/// Texts of the read-out under the 3-D scene and of the inspector.
class SceneText {
  Q_DECLARE_TR_FUNCTIONS(SceneText)

 public:
  /// Returns a state's name and the share of the panel that lights its eye; before a lens sheet,
  /// how far the eye is from the next flip, as the panel's middle shows it.
  static QString eye(const CameraState& state, const PanelParams& display);
  /// Describes a pixel in one line.
  static QString pixel(int x, int y, const PixelTrace& trace);
  /// Describes the pixel's ray and where it ends, in further lines; "" without a ray. `views` is
  /// the number of views of a lens sheet's quilt.
  static QString ray(const PixelTrace& trace, const PanelParams& display, int views);
  /// Describes what the pixel shows and, if it is black, the reason.
  static QString verdict(const PixelTrace& trace, const PanelParams& display);
  /// Returns a lens sheet's serial number, panel, lenses and cone.
  static QString sheet(const SheetDisplay& display);
  /// Returns a hogel's indices as a short label.
  static QString hogelName(int i, int j);
  /// Returns a length in metres or millimetres.
  static QString length(double metres);
  /// Describes the way from the first to the second measured point, as far as they are there.
  static QString measured(const std::vector<Vec3>& points);
  /// Describes a picked hogel.
  static QString hogel(const PanelParams& display, int i, int j);
};

}  // namespace hogelscope
