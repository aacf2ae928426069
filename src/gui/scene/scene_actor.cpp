// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/scene_actor.h"

#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

namespace hogelscope {

void addToScene(vtkRenderer* renderer, vtkActor* actor, vtkAlgorithmOutput* source,
                const std::array<double, 3>& colour, SceneLevel level) {
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  if (level == SceneLevel::panel)
    mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 4);
  else
    setDepth(actor, level);
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

void setDepth(vtkActor* actor, SceneLevel level) {
  // Follows VTK's own depth; the offset is twice VTK's offset of coincident lines.
  const std::string place = "//VTK::Depth::Impl";
  std::string depth = "gl_FragCoord.z - 8.0 / 65000.0";
  if (level == SceneLevel::handle) depth = "0.01 * gl_FragCoord.z";  // keeps the order of handles
  if (level == SceneLevel::inFront) depth = "0.0";
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
      place, true, place + "\n  gl_FragDepth = " + depth + ";\n", false);
}

void makePlain(vtkTextProperty* text) {
  text->SetFontSize(14);
  text->SetColor(0.85, 0.85, 0.85);
  text->ItalicOff();
  text->BoldOff();
  text->ShadowOff();
}

/// Uses vtkTextActor, because the translucency of vtkBillboardTextActor3D needs a pass over the
/// whole image.
void addLabel(vtkRenderer* renderer, vtkTextActor* label) {
  makePlain(label->GetTextProperty());
  label->GetTextProperty()->SetJustificationToCentered();
  label->GetTextProperty()->SetVerticalJustificationToTop();
  label->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  renderer->AddViewProp(label);
}

}  // namespace hogelscope
