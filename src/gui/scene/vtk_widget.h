// SPDX-License-Identifier: BSD-3-Clause
// A Qt 6 widget that hosts a VTK render window: Debian's own Qt module of VTK is for Qt 5.
#pragma once

#include <vtkNew.h>

#include <QOpenGLWidget>
#include <QSurfaceFormat>

class vtkGenericOpenGLRenderWindow;
class vtkGenericRenderWindowInteractor;
class vtkObject;

namespace hogelscope {

/// All rendering happens in paintGL: vtkRenderWindow::Render requests only schedule a repaint. Put
/// renderers into `renderWindow()`; call `update()` after a change.
class VtkWidget : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit VtkWidget(QWidget* parent = nullptr);
  ~VtkWidget() override;

  /// What VTK needs of a context; make it the default before the QApplication.
  static QSurfaceFormat surfaceFormat();

  [[nodiscard]] vtkGenericOpenGLRenderWindow* renderWindow() const { return m_window; }
  [[nodiscard]] vtkGenericRenderWindowInteractor* interactor() const { return m_interactor; }
  /// In the screen's own pixels, as VTK counts them.
  [[nodiscard]] QSize deviceSize() const;

 Q_SIGNALS:
  /// The left button went down and up at one place; pixels from the lower left.
  void clicked(int x, int y);
  /// The pointer is there, no button is pressed.
  void hovered(int x, int y);
  void resized();

 protected:
  bool event(QEvent* event) override;
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void releaseGL();
  void copyToWidget();
  void emitPointer(const QPointF& position, Qt::KeyboardModifiers modifiers);
  void onMakeCurrent(vtkObject* caller, unsigned long event, void* data);
  void onIsCurrent(vtkObject* caller, unsigned long event, void* isCurrent);
  void onSupportsOpenGL(vtkObject* caller, unsigned long event, void* isSupported);
  void onRenderRequest(vtkObject* caller, unsigned long event, void* data);
  [[nodiscard]] QPoint fromLowerLeft(const QPointF& position) const;

  vtkNew<vtkGenericOpenGLRenderWindow> m_window;
  vtkNew<vtkGenericRenderWindowInteractor> m_interactor;
  QMetaObject::Connection m_contextEnds;
  QPointF m_pressedAt;
  bool m_isClick = false;  ///< the left button is down and has not been moved
};

}  // namespace hogelscope
