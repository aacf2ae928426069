// SPDX-License-Identifier: BSD-3-Clause
// Unlit parts of the 3-D scene, and where they are on the screen.
#pragma once

#include <vtkActor.h>
#include <vtkAlgorithmOutput.h>
#include <vtkRenderer.h>
#include <QColor>
#include <QPointF>
#include <optional>
#include <utility>

#include "core/base/geometry.h"

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

}  // namespace hogelscope
