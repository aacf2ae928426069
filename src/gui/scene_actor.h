// SPDX-License-Identifier: BSD-3-Clause
// A part of the 3-D scene that is drawn as it is, unlit.
#pragma once

#include <vtkActor.h>
#include <vtkAlgorithmOutput.h>
#include <vtkRenderer.h>

#include <array>

namespace hogelscope {

/// Which of two things in one plane lies on top.
enum class SceneLevel { panel, onPanel };

/// Puts a source's output into the scene, in one colour unless its cells have their own.
void addToScene(vtkRenderer* renderer, vtkActor* actor, vtkAlgorithmOutput* source,
                const std::array<double, 3>& colour, SceneLevel level);

}  // namespace hogelscope
