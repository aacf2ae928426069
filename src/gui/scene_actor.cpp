// SPDX-License-Identifier: BSD-3-Clause
// A part of the 3-D scene that is drawn as it is, unlit.
#include "gui/scene_actor.h"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace hogelscope {

void addToScene(vtkRenderer* renderer, vtkActor* actor, vtkAlgorithmOutput* source,
                const std::array<double, 3>& colour, SceneLevel level) {
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  if (level == SceneLevel::panel)
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 4);
  else
    mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-1, -4);
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

}  // namespace hogelscope
