// SPDX-License-Identifier: BSD-3-Clause
// A Qt 6 widget that hosts a VTK render window. Debian's own Qt module of VTK is for Qt 5.
// VTK draws off the screen in a context of its own, only when a prop or the eye has changed
// (DisplayScene::changedAt), and the widget paints that picture: the window stays a raster window,
// of which Qt composes only what changed.
#pragma once

#include <vtkNew.h>

#include <QImage>
#include <QWidget>
#include <memory>

class QOffscreenSurface;
class QOpenGLContext;
class vtkGenericOpenGLRenderWindow;
class vtkGenericRenderWindowInteractor;
class vtkObject;

namespace hogelscope {

/// Renders VTK off screen, in its own context and only after changes, and paints the resulting
/// image. The surrounding window is therefore no OpenGL window, of which Qt would compose all
/// pixels again for each change of any widget. All rendering happens in paintEvent; VTK's requests
/// only schedule one. Put renderers into `renderWindow()`; call `redraw()` after a change.
class VtkWidget : public QWidget {
  Q_OBJECT

 public:
  explicit VtkWidget(QWidget* parent = nullptr);
  ~VtkWidget() override;

  [[nodiscard]] vtkGenericOpenGLRenderWindow* renderWindow() const { return m_window; }
  [[nodiscard]] vtkGenericRenderWindowInteractor* interactor() const { return m_interactor; }
  /// Returns the size in device pixels, as in VTK.
  [[nodiscard]] QSize deviceSize() const { return (QSizeF(size()) * devicePixelRatioF()).toSize(); }
  /// Returns the middle of a device pixel that counts from the lower left, from the upper left.
  [[nodiscard]] QPointF fromUpperLeft(int x, int y) const {
    return {x + 0.5, deviceSize().height() - y - 0.5};
  }
  /// Schedules a redraw, so that several changes are drawn at once.
  void redraw();
  /// Returns the rendered image in device pixels; null without OpenGL.
  [[nodiscard]] const QImage& image();

 Q_SIGNALS:
  /// The left button was pressed and released at one place; pixels count from the lower left.
  void clicked(int x, int y);
  /// The pointer has moved without a pressed button.
  void hovered(int x, int y);
  void resized();
  /// The image has been painted; more can be painted over it, in the widget's pixels.
  void painted(QPainter& painter);
  void coloursChanged();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  void makeContext();
  void render();
  void readPixels();
  void emitPointer(const QPointF& position, Qt::KeyboardModifiers modifiers);
  void onMakeCurrent(vtkObject* caller, unsigned long event, void* data);
  void onIsCurrent(vtkObject* caller, unsigned long event, void* isCurrent);
  void onSupportsOpenGL(vtkObject* caller, unsigned long event, void* isSupported);
  [[nodiscard]] QPoint fromLowerLeft(const QPointF& position) const;

  vtkNew<vtkGenericOpenGLRenderWindow> m_window;
  vtkNew<vtkGenericRenderWindowInteractor> m_interactor;
  std::unique_ptr<QOffscreenSurface> m_surface;
  std::unique_ptr<QOpenGLContext> m_context;  ///< from the first paint on; not valid: no OpenGL
  QImage m_image;
  bool m_isCurrent = false;  ///< the image shows the current scene
  QPointF m_pressedAt;
  bool m_isClick = false;  ///< the left button is pressed and has not been moved
};

}  // namespace hogelscope
