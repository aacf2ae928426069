// SPDX-License-Identifier: BSD-3-Clause
// A part of the 3-D scene that is drawn as it is, unlit; labels.
#pragma once

#include <vtkActor.h>
#include <vtkAlgorithmOutput.h>
#include <vtkRenderer.h>

#include <array>

class vtkTextActor;
class vtkTextProperty;

namespace hogelscope {

/// Decides which of two things in one plane lies on top. Handles hide all but the lines inFront,
/// wherever they are.
enum class SceneLevel { panel, onPanel, handle, inFront };

/// Puts a source's output into the scene, in one colour unless its cells have their own.
void addToScene(vtkRenderer* renderer, vtkActor* actor, vtkAlgorithmOutput* source,
                const std::array<double, 3>& colour, SceneLevel level);

/// Gives an actor's lines or handle their depth: VTK's own is undefined where lines are thick and
/// unlit.
void setDepth(vtkActor* actor, SceneLevel level);

/// Light, upright, without a shadow.
void makePlain(vtkTextProperty* text);

/// A text that hangs below a point of the world, of the same size wherever that is.
void addLabel(vtkRenderer* renderer, vtkTextActor* label);

}  // namespace hogelscope
