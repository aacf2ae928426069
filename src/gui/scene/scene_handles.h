// SPDX-License-Identifier: BSD-3-Clause
// Balls in the 3-D scene that are dragged to move a mesh or a camera's eye and look-at point.
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

  /// Shows the camera's balls, at points of the world in metres.
  void showAt(const Vec3& eye, const Vec3& lookat);
  void hide();
  /// Shows the mesh's ball; nullopt hides it.
  void showMeshAt(const std::optional<Vec3>& place);
  /// Sets the scene's eye. A ball at or near the eye is hidden, because it would fill the view.
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
