// SPDX-License-Identifier: BSD-3-Clause
// The 3-D scene: the panel with its hogel grid, and the frusta of all states.
#include "gui/display_scene.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkAxesActor.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkOrientationMarkerWidget.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "core/error.h"
#include "gui/vtk_widget.h"
#include "vtk/vtkCameraFrustumSource.h"
#include "vtk/vtkHogelDisplaySource.h"

namespace hogelscope {

namespace {

/// Shows a source's output in one unlit colour.
void connect(vtkRenderer* renderer, vtkActor* actor, vtkAlgorithmOutput* source,
             std::array<double, 3> colour, float lineWidth) {
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source);
  // What is drawn later lies on top of the panel in its own plane.
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2, 200);
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -200);
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour.data());
  actor->GetProperty()->SetLineWidth(lineWidth);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

bool hasFrame(const CameraParams& params) {
  try {
    const Camera camera(params);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Long enough to be seen, short enough to leave the panel free.
double frustumLength(const CameraParams& camera) {
  return 0.25 * length(camera.lookat - camera.eye);
}

}  // namespace

DisplayScene::DisplayScene(VtkWidget& widget) : m_widget(widget) {
  m_renderer->SetBackground(0.13, 0.14, 0.17);
  m_widget.renderWindow()->AddRenderer(m_renderer);
  const vtkNew<vtkActor> panel;
  connect(m_renderer, panel, m_display->GetOutputPort(0), {0.24, 0.28, 0.36}, 1);
  const vtkNew<vtkActor> grid;
  connect(m_renderer, grid, m_display->GetOutputPort(1), {0.50, 0.58, 0.70}, 1);
  connect(m_renderer, m_otherActor, m_otherFrusta->GetOutputPort(), {0.55, 0.75, 0.60}, 1);
  connect(m_renderer, m_currentActor, m_currentFrustum->GetOutputPort(), {1.00, 0.65, 0.15}, 3);
  m_marker->SetOrientationMarker(m_axes);
  m_marker->SetInteractor(m_widget.interactor());
  m_marker->SetViewport(0, 0, 0.2, 0.2);
  m_marker->EnabledOn();
  m_marker->InteractiveOff();
}

DisplayScene::~DisplayScene() {
  m_marker->SetInteractor(nullptr);
}

void DisplayScene::show(const DisplayParams& display, const std::vector<CameraState>& states,
                        std::size_t current) {
  m_display->SetDisplay(display);
  m_otherFrusta->RemoveAllInputConnections(0);
  m_currentActor->SetVisibility(current < states.size() && hasFrame(states[current].camera));
  for (std::size_t k = 0; k < states.size(); ++k) {
    const CameraParams& camera = states[k].camera;
    if (!hasFrame(camera)) continue;
    if (k == current) {
      m_currentFrustum->SetCamera(camera, states[k].intrinsics);
      m_currentFrustum->SetDistance(frustumLength(camera));
      continue;
    }
    const vtkNew<vtkCameraFrustumSource> frustum;
    frustum->SetCamera(camera, states[k].intrinsics);
    frustum->SetDistance(frustumLength(camera));
    m_otherFrusta->AddInputConnection(frustum->GetOutputPort());
  }
  m_otherActor->SetVisibility(m_otherFrusta->GetNumberOfInputConnections(0) > 0);
  m_renderer->ResetCameraClippingRange();
  m_widget.update();
}

void DisplayScene::fit() {
  vtkCamera* camera = m_renderer->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(1.1, 0.7, 1.3);
  camera->SetViewUp(0, 1, 0);
  m_renderer->ResetCamera();
  m_widget.update();
}

}  // namespace hogelscope
