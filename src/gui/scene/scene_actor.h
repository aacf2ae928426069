// SPDX-License-Identifier: BSD-3-Clause
// Unlit parts and labels of the 3-D scene.
#pragma once

#include <vtkActor.h>
#include <vtkAlgorithmOutput.h>
#include <vtkRenderer.h>

#include <array>

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

}  // namespace hogelscope
