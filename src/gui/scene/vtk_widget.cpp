// SPDX-License-Identifier: BSD-3-Clause
// A Qt 6 widget that hosts a VTK render window.
#include "gui/scene/vtk_widget.h"

#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QScreen>
#include <QWheelEvent>
#include <cmath>
#include <utility>

namespace hogelscope {

QSurfaceFormat VtkWidget::surfaceFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setSwapBehavior(QSurfaceFormat::DoubleBuffer);  // else the window is painted only once
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setAlphaBufferSize(8);
  format.setSamples(0);  // VTK resolves its own multisampling
  return format;
}

VtkWidget::VtkWidget(QWidget* parent) : QOpenGLWidget(parent) {
  setFormat(surfaceFormat());
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);

  m_window->SetReadyForRendering(false);  // until initializeGL
  m_window->SetOwnContext(0);
  m_window->SetFrameBlitModeToNoBlit();
  m_window->SetMultiSamples(0);  // costs 5 × on software GL
  m_window->AddObserver(vtkCommand::WindowMakeCurrentEvent, this, &VtkWidget::onMakeCurrent);
  m_window->AddObserver(vtkCommand::WindowIsCurrentEvent, this, &VtkWidget::onIsCurrent);
  m_window->AddObserver(vtkCommand::WindowSupportsOpenGLEvent, this, &VtkWidget::onSupportsOpenGL);

  m_interactor->SetRenderWindow(m_window);
  m_interactor->SetInteractorStyle(vtkNew<vtkInteractorStyleTrackballCamera>());
  m_interactor->EnableRenderOff();  // Render() only raises RenderEvent; paintGL draws
  m_interactor->AddObserver(vtkCommand::RenderEvent, this, &VtkWidget::onRenderRequest);
  m_interactor->Initialize();
}

VtkWidget::~VtkWidget() {
  disconnect(m_contextEnds);  // ~QOpenGLWidget ends the context after our members are gone
  if (context() != nullptr) releaseGL();
  m_interactor->RemoveAllObservers();
  m_window->RemoveAllObservers();
}

void VtkWidget::initializeGL() {
  m_contextEnds = connect(context(), &QOpenGLContext::aboutToBeDestroyed, this,
                          &VtkWidget::releaseGL, Qt::DirectConnection);
  m_window->GetState()->Reset();
  m_window->SetMapped(1);
  m_window->SetIsCurrent(true);
  m_window->SetReadyForRendering(true);
  m_window->OpenGLInitContext();
}

void VtkWidget::releaseGL() {
  makeCurrent();
  m_window->Finalize();
  m_window->SetReadyForRendering(false);
  doneCurrent();
}

QSize VtkWidget::deviceSize() const {
  return (QSizeF(size()) * devicePixelRatioF()).toSize();
}

void VtkWidget::resizeGL(int, int) {
  m_window->SetDPI(qRound(72 * devicePixelRatioF()));
  const QSize screenSize = (QSizeF(screen()->size()) * devicePixelRatioF()).toSize();
  m_window->SetScreenSize(screenSize.width(), screenSize.height());
  m_interactor->UpdateSize(deviceSize().width(), deviceSize().height());
  Q_EMIT resized();
}

void VtkWidget::paintGL() {
  vtkOpenGLState* state = m_window->GetState();
  state->Reset();  // Qt painted with this context: what VTK remembers of it is stale
  state->Push();
  state->vtkglDepthFunc(GL_LEQUAL);  // Qt leaves GL_LESS
  m_window->Render();
  state->Pop();
  makeCurrent();  // an observer may have switched contexts; binds Qt's framebuffer again
  copyToWidget();
}

/// Plain GL from VTK's framebuffer to Qt's, so that nothing VTK remembers can be wrong.
void VtkWidget::copyToWidget() {
  QOpenGLExtraFunctions* gl = context()->extraFunctions();
  vtkOpenGLFramebufferObject* source = m_window->GetDisplayFramebuffer();
  const int* from = source->GetLastSize();
  const QSize to = deviceSize();
  const GLenum colour = GL_COLOR_ATTACHMENT0;
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, source->GetFBOIndex());
  gl->glReadBuffer(colour);
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
  gl->glDrawBuffers(1, &colour);
  gl->glBlitFramebuffer(0, 0, from[0], from[1], 0, 0, to.width(), to.height(), GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);  // opaque, else Qt blends
  gl->glClearColor(0, 0, 0, 1);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void VtkWidget::onMakeCurrent(vtkObject*, unsigned long, void*) {
  // Not QOpenGLWidget::makeCurrent(): that also binds Qt's framebuffer behind VTK's back.
  if (isValid()) context()->makeCurrent(context()->surface());
}

void VtkWidget::onIsCurrent(vtkObject*, unsigned long, void* isCurrent) {
  *static_cast<bool*>(isCurrent) = isValid() && QOpenGLContext::currentContext() == context();
}

void VtkWidget::onSupportsOpenGL(vtkObject*, unsigned long, void* isSupported) {
  *static_cast<int*>(isSupported) = 1;
}

void VtkWidget::onRenderRequest(vtkObject*, unsigned long, void*) {
  update();
}

bool VtkWidget::event(QEvent* event) {
  if (event->type() == QEvent::ScreenChangeInternal) update();
  return QOpenGLWidget::event(event);
}

void VtkWidget::emitPointer(const QPointF& position, Qt::KeyboardModifiers modifiers) {
  const QPoint p = (position * devicePixelRatioF()).toPoint();
  m_interactor->SetEventInformationFlipY(p.x(), p.y(), modifiers.testFlag(Qt::ControlModifier),
                                         modifiers.testFlag(Qt::ShiftModifier));
  m_interactor->SetAltKey(modifiers.testFlag(Qt::AltModifier));
}

QPoint VtkWidget::fromLowerLeft(const QPointF& position) const {
  const QPoint p = (position * devicePixelRatioF()).toPoint();
  return {p.x(), deviceSize().height() - 1 - p.y()};
}

void VtkWidget::mousePressEvent(QMouseEvent* event) {
  m_pressedAt = event->position();
  m_isClick = event->button() == Qt::LeftButton;
  emitPointer(event->position(), event->modifiers());
  if (event->button() == Qt::LeftButton) m_interactor->LeftButtonPressEvent();
  if (event->button() == Qt::MiddleButton) m_interactor->MiddleButtonPressEvent();
  if (event->button() == Qt::RightButton) m_interactor->RightButtonPressEvent();
}

void VtkWidget::mouseReleaseEvent(QMouseEvent* event) {
  emitPointer(event->position(), event->modifiers());
  if (event->button() == Qt::LeftButton) m_interactor->LeftButtonReleaseEvent();
  if (event->button() == Qt::MiddleButton) m_interactor->MiddleButtonReleaseEvent();
  if (event->button() == Qt::RightButton) m_interactor->RightButtonReleaseEvent();
  if (event->button() != Qt::LeftButton || !std::exchange(m_isClick, false)) return;
  const QPoint at = fromLowerLeft(event->position());
  Q_EMIT clicked(at.x(), at.y());
}

void VtkWidget::mouseMoveEvent(QMouseEvent* event) {
  emitPointer(event->position(), event->modifiers());
  m_interactor->MouseMoveEvent();
  constexpr double still = 3;  // a hand trembles
  const QPointF way = event->position() - m_pressedAt;
  if (std::hypot(way.x(), way.y()) > still) m_isClick = false;
  if (event->buttons() != Qt::NoButton) return;
  const QPoint at = fromLowerLeft(event->position());
  Q_EMIT hovered(at.x(), at.y());
}

void VtkWidget::wheelEvent(QWheelEvent* event) {
  emitPointer(event->position(), event->modifiers());
  if (event->angleDelta().y() > 0) m_interactor->MouseWheelForwardEvent();
  if (event->angleDelta().y() < 0) m_interactor->MouseWheelBackwardEvent();
}

}  // namespace hogelscope
