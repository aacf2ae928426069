// SPDX-License-Identifier: BSD-3-Clause
// Unlit parts of the 3-D scene, and the texts of its read-out, with units.
#pragma once

#include <vtkActor.h>
#include <vtkAlgorithmOutput.h>
#include <vtkRenderer.h>
#include <QColor>
#include <QCoreApplication>
#include <QPointF>
#include <QString>
#include <optional>
#include <utility>
#include <vector>

#include "core/optics/pixel_inspection.h"

class vtkProperty;

namespace hogelscope {

/// The order of coplanar parts, from back to front. Lines `inFront` hide everything, at any
/// distance.
enum class SceneLevel { panel, onPanel, inFront };

/// Adds a source's output to the scene, in white unless its cells have colours.
void addToScene(vtkRenderer* renderer, vtkActor* actor, vtkAlgorithmOutput* source,
                SceneLevel level);

void setColour(vtkProperty* property, const QColor& colour);

/// Sets the depth of an actor's lines. VTK's own depth is undefined for thick unlit
/// lines.
void setDepth(vtkActor* actor, SceneLevel level);

/// Returns where a point of the world is drawn, in device pixels from the upper left; none for a
/// point behind the scene's eye.
std::optional<QPointF> onScreen(vtkRenderer& renderer, const Vec3& point);
/// Returns the transform to the frame of the scene's eye: right, up and towards it.
RigidTransform viewOf(vtkRenderer& renderer);
/// Returns the points of the nearest and the farthest plane that are drawn at a place, in device
/// pixels from the upper left.
std::pair<Vec3, Vec3> lineAt(vtkRenderer& renderer, const QPointF& place);
/// Returns the size in metres of a device pixel at the depth of a point.
double pixelSizeAt(vtkRenderer& renderer, const Vec3& point);

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
  /// Returns a length in metres or millimetres.
  static QString length(double metres);
  /// Describes the way from the first to the second measured point, as far as they are there.
  static QString measured(const std::vector<Vec3>& points);
  /// Describes a picked hogel.
  static QString hogel(const PanelParams& display, int i, int j);
};

}  // namespace hogelscope
