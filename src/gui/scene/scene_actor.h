// SPDX-License-Identifier: BSD-3-Clause
// Unlit parts and labels of the 3-D scene, and the texts of its read-out, with units.
#pragma once

#include <vtkActor.h>
#include <vtkAlgorithmOutput.h>
#include <vtkRenderer.h>
#include <QCoreApplication>
#include <QString>
#include <array>

#include "core/optics/pixel_inspection.h"

class vtkTextActor;
class vtkTextProperty;

namespace hogelscope {

/// The order of coplanar parts, from back to front. Handles hide everything except lines `inFront`,
/// at any distance.
enum class SceneLevel { panel, onPanel, handle, inFront };

/// Adds a source's output to the scene, in one colour unless its cells have colours.
void addToScene(vtkRenderer* renderer, vtkActor* actor, vtkAlgorithmOutput* source,
                const std::array<double, 3>& colour, SceneLevel level);

/// Sets the depth of an actor's lines or handle. VTK's own depth is undefined for thick unlit
/// lines.
void setDepth(vtkActor* actor, SceneLevel level);

/// Sets light, upright text without a shadow.
void makePlain(vtkTextProperty* text);

/// Adds a text of constant size below a point of the world.
void addLabel(vtkRenderer* renderer, vtkTextActor* label);

/// Texts of the read-out under the 3-D scene, with units.
class SceneText {
  Q_DECLARE_TR_FUNCTIONS(SceneText)

 public:
  /// Returns a state's name and the share of the panel that lights its eye.
  static QString eye(const CameraState& state, const PanelParams& display);
  /// Describes a pixel in one line.
  static QString pixel(int x, int y, const PixelTrace& trace);
  /// Describes the pixel's ray and where it ends, in further lines; "" without a ray.
  static QString ray(const PixelTrace& trace);
  /// Describes what the pixel shows and, if it is black, the reason.
  static QString verdict(const PixelTrace& trace, const PanelParams& display);
  /// Returns a hogel's indices as a short label.
  static QString hogelName(int i, int j);
  /// Describes a picked hogel.
  static QString hogel(const PanelParams& display, int i, int j);
};

}  // namespace hogelscope
