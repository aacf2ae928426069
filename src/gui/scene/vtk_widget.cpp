// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/vtk_widget.h"

#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>
#include <utility>

#include "gui/widgets/colours.h"

namespace hogelscope {

namespace {

/// Returns the format that VTK 9.1 needs. VTK resolves its own multisampling.
QSurfaceFormat surfaceFormat() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  return format;
}

}  // namespace

VtkWidget::VtkWidget(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);

  m_window->SetReadyForRendering(false);  // until there is a context
  m_window->SetOwnContext(0);
  m_window->SetFrameBlitModeToNoBlit();
  m_window->SetMultiSamples(0);  // multisampling costs 5 × on software GL
  m_window->AddObserver(vtkCommand::WindowMakeCurrentEvent, this, &VtkWidget::onMakeCurrent);
  m_window->AddObserver(vtkCommand::WindowIsCurrentEvent, this, &VtkWidget::onIsCurrent);
  m_window->AddObserver(vtkCommand::WindowSupportsOpenGLEvent, this, &VtkWidget::onSupportsOpenGL);

  m_interactor->SetRenderWindow(m_window);
  m_interactor->SetInteractorStyle(vtkNew<vtkInteractorStyleTrackballCamera>());
  m_interactor->EnableRenderOff();  // Render() only raises RenderEvent; paintEvent draws
  m_interactor->AddObserver(vtkCommand::RenderEvent, this, &VtkWidget::redraw);
  m_interactor->Initialize();
}

VtkWidget::~VtkWidget() {
  if (m_context != nullptr && m_context->makeCurrent(m_surface.get())) {
    m_window->Finalize();
    m_context->doneCurrent();
  }
  m_interactor->RemoveAllObservers();
  m_window->RemoveAllObservers();
}

void VtkWidget::redraw() {
  m_isCurrent = false;
  update();
}

const QImage& VtkWidget::image() {
  if (!m_isCurrent || m_image.size() != deviceSize()) render();
  return m_image;
}

void VtkWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  if (!image().isNull()) {
    painter.drawImage(rect(), m_image);
    Q_EMIT painted(painter);
    return;
  }
  painter.fillRect(rect(), tokens().canvas);
  painter.setPen(tokens().text);
  painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("OpenGL 3.2 is not available."));
}

void VtkWidget::resizeEvent(QResizeEvent*) {
  m_interactor->UpdateSize(deviceSize().width(), deviceSize().height());
  Q_EMIT resized();
}

void VtkWidget::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) Q_EMIT coloursChanged();
  QWidget::changeEvent(event);
}

void VtkWidget::makeContext() {
  m_surface = std::make_unique<QOffscreenSurface>();
  m_surface->setFormat(surfaceFormat());
  m_surface->create();
  m_context = std::make_unique<QOpenGLContext>();
  m_context->setFormat(surfaceFormat());
  const bool isThere = m_context->create() &&
                       m_context->format().version() >= surfaceFormat().version() &&
                       m_context->makeCurrent(m_surface.get());
  if (!isThere) return m_context.reset();
  m_window->SetMapped(1);
  m_window->SetIsCurrent(true);
  m_window->SetReadyForRendering(true);
  m_window->OpenGLInitContext();
}

void VtkWidget::render() {
  m_isCurrent = true;  // set first, because rendering may request another redraw
  if (m_surface == nullptr) makeContext();
  if (m_context == nullptr || !m_context->makeCurrent(m_surface.get())) return;
  const QSize size = deviceSize();
  m_interactor->UpdateSize(size.width(), size.height());
  m_window->Render();
  if (m_image.size() != size) m_image = QImage(size, QImage::Format_RGB32);
  readPixels();
}

void VtkWidget::readPixels() {
  vtkOpenGLState* state = m_window->GetState();
  state->PushReadFramebufferBinding();
  m_window->GetDisplayFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
  m_window->GetDisplayFramebuffer()->ActivateReadBuffer(0);
  m_context->functions()->glReadPixels(0, 0, m_image.width(), m_image.height(), GL_BGRA,
                                       GL_UNSIGNED_BYTE, m_image.bits());
  state->PopReadFramebufferBinding();
  // OpenGL's first row is the lowest.
#if QT_VERSION >= QT_VERSION_CHECK(6, 9, 0)
  m_image = std::move(m_image).flipped(Qt::Vertical);
#else
  m_image = std::move(m_image).mirrored();
#endif
}

void VtkWidget::onMakeCurrent(vtkObject*, unsigned long, void*) {
  if (m_context != nullptr) m_context->makeCurrent(m_surface.get());
}

void VtkWidget::onIsCurrent(vtkObject*, unsigned long, void* isCurrent) {
  *static_cast<bool*>(isCurrent) =
      m_context != nullptr && QOpenGLContext::currentContext() == m_context.get();
}

void VtkWidget::onSupportsOpenGL(vtkObject*, unsigned long, void* isSupported) {
  *static_cast<int*>(isSupported) = 1;
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
  constexpr double still = 3;  // pixels of a trembling hand
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
