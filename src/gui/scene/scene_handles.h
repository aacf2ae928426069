// SPDX-License-Identifier: BSD-3-Clause
// Balls in the 3-D scene that are dragged to move a camera's eye and look-at point, and a mesh.
#pragma once

#include <vtkNew.h>

#include <QObject>
#include <array>
#include <optional>

#include "core/base/geometry.h"

class vtkHandleWidget;
class vtkObject;
class vtkRenderer;
class vtkRenderWindowInteractor;
class vtkSphereHandleRepresentation;

namespace hogelscope {

class SceneHandles : public QObject {
  Q_OBJECT

 public:
  SceneHandles(vtkRenderer* renderer, vtkRenderWindowInteractor* interactor, QObject* parent);
  ~SceneHandles() override;

  /// In the world, metres. They are shown once placed.
  void showAt(const Vec3& eye, const Vec3& lookat);
  void hide();
  /// A mesh has a ball only where it has a place.
  void showMeshAt(const std::optional<Vec3>& place);
  /// Who looks through a ball, or nearly, would see nothing but that: it is not shown.
  void setSceneEye(const Vec3& sceneEye);

 Q_SIGNALS:
  void eyeDragged(const hogelscope::Vec3& eye);
  void lookatDragged(const hogelscope::Vec3& lookat);
  void meshDragged(const hogelscope::Vec3& place);

 private:
  struct Handle {
    vtkNew<vtkHandleWidget> widget;
    vtkNew<vtkSphereHandleRepresentation> ball;
    bool isPlaced = false;
  };
  void setUp(Handle& handle, const std::array<double, 3>& colour);
  void update();
  void onDrag(vtkObject* widget, unsigned long event, void* data);

  vtkRenderer* m_renderer;
  vtkRenderWindowInteractor* m_interactor;
  Handle m_eye;
  Handle m_lookat;
  Handle m_mesh;
  Vec3 m_sceneEye;
};

}  // namespace hogelscope
