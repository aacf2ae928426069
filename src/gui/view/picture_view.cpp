// SPDX-License-Identifier: BSD-3-Clause
// Shows a picture, or compares two of the same size: what it shows and how it is moved. How it is
// painted is in picture_view_painting.cpp.
#include "gui/view/picture_view.h"

#include <QAction>
#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/view/picture_difference.h"

namespace hogelscope {

PictureView::PictureView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(160, 120);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setContextMenuPolicy(Qt::ActionsContextMenu);
  setAccessibleName(tr("Picture"));
  addCommands();
}

/// Shortcuts of the widget that has the focus, and its context menu.
void PictureView::addCommands() {
  using View = PictureView;
  addCommand("zoomInAction", tr("Zoom &in"), tr("Shows less, larger by √2"),
             {Qt::Key_Plus, Qt::Key_Equal}, {}, &View::zoomIn);
  addCommand("zoomOutAction", tr("Zoom &out"), tr("Shows more, smaller by √2"), {Qt::Key_Minus}, {},
             &View::zoomOut);
  addCommand("fitPictureAction", tr("&Fit"), tr("Shows the whole picture"), {Qt::Key_0}, {},
             &View::fit);
  addCommand("oneToOneAction", tr("One &to one"),
             tr("One pixel of the picture on one of the screen"), {Qt::Key_1}, {}, &View::oneToOne);
  addCommand("panLeftAction", tr("More to the left"), tr("Moves what is shown by a tenth"),
             {Qt::Key_Left}, {}, &View::panLeft);
  addCommand("panRightAction", tr("More to the right"), tr("Moves what is shown by a tenth"),
             {Qt::Key_Right}, {}, &View::panRight);
  addCommand("panUpAction", tr("More above"), tr("Moves what is shown by a tenth"), {Qt::Key_Up},
             {}, &View::panUp);
  addCommand("panDownAction", tr("More below"), tr("Moves what is shown by a tenth"),
             {Qt::Key_Down}, {}, &View::panDown);
  addCommand("wipeLeftAction", tr("Line to the &left"),
             tr("Moves the wipe's line by 2 % of the width"), {Qt::SHIFT | Qt::Key_Left},
             Mode::wipe, &View::wipeLeft);
  addCommand("wipeRightAction", tr("Line to the &right"),
             tr("Moves the wipe's line by 2 % of the width"), {Qt::SHIFT | Qt::Key_Right},
             Mode::wipe, &View::wipeRight);
  addCommand("moreGainAction", tr("&Double the gain"), tr("Twice the difference, up to 128 times"),
             {Qt::SHIFT | Qt::Key_Up}, Mode::difference, &View::moreGain);
  addCommand("lessGainAction", tr("&Halve the gain"), tr("Half the difference, down to once"),
             {Qt::SHIFT | Qt::Key_Down}, Mode::difference, &View::lessGain);
  showActions();
}

void PictureView::addCommand(const char* name, const QString& text, const QString& help,
                             const QList<QKeySequence>& keys, std::optional<Mode> mode,
                             void (PictureView::*does)()) {
  auto* action = new QAction(text, this);
  action->setObjectName(name);
  action->setToolTip(help);
  action->setShortcuts(keys);
  action->setShortcutContext(Qt::WidgetShortcut);
  if (mode) action->setData(int(*mode));
  connect(action, &QAction::triggered, this, does);
  addAction(action);
}

/// Only those that do something.
void PictureView::showActions() {
  for (QAction* action : actions())
    if (action->data().isValid()) action->setVisible(action->data().toInt() == int(shownMode()));
}

void PictureView::setImages(const QImage& image, const QImage& other) {
  const bool hasOther = !other.isNull() && other.size() == image.size();
  m_pictures[0].image = ZoomableImage(image);
  m_pictures[1].image = ZoomableImage(hasOther ? other : QImage());
  updateDifference();
  setViewport(m_viewport);
}

void PictureView::setMask(const QImage& seen, const QImage& otherSeen) {
  m_pictures[0].seen = seen;
  m_pictures[1].seen = otherSeen;
  updateHatch();
}

void PictureView::setTitles(const QString& title, const QString& otherTitle) {
  m_pictures[0].title = title;
  m_pictures[1].title = otherTitle;
  update();
}

void PictureView::setNotice(const QString& notice) {
  m_notice = notice;
  setAccessibleDescription(notice);
  update();
}

void PictureView::setMode(Mode mode) {
  m_mode = mode;
  updateDifference();
}

void PictureView::showMask(bool isShown) {
  m_showsMask = isShown;
  updateHatch();
}

void PictureView::setGain(int gain) {
  m_gain = std::clamp(gain, 1, 128);
  updateDifference();
}

void PictureView::setWipe(double share) {
  m_wipe = std::clamp(share, 0.0, 1.0);
  update();
}

void PictureView::updateDifference() {
  m_difference = shownMode() == Mode::difference
                     ? ZoomableImage(pictureDifference(image(), otherImage(), m_gain))
                     : ZoomableImage();
  showActions();
  update();
}

void PictureView::updateHatch() {
  for (Shown& picture : m_pictures)
    picture.hatch = m_showsMask ? ZoomableImage(hatched(picture.seen)) : ZoomableImage();
  update();
}

void PictureView::setViewport(const Viewport& viewport) {
  const Viewport next = limited(viewport, image().size());
  update();
  if (next == m_viewport) return;
  m_viewport = next;
  Q_EMIT viewportChanged(m_viewport);
}

void PictureView::linkTo(PictureView& other) {
  setViewport(other.viewport());
  connect(this, &PictureView::viewportChanged, &other, &PictureView::setViewport);
  connect(&other, &PictureView::viewportChanged, this, &PictureView::setViewport);
}

PictureView::Mode PictureView::shownMode() const {
  return otherImage().isNull() ? Mode::single : m_mode;
}

QRect PictureView::deviceRect() const {
  return {QPoint(0, 0), (QSizeF(size()) * devicePixelRatioF()).toSize()};
}

QPointF PictureView::inDevice(const QPointF& position) const {
  return position * devicePixelRatioF();
}

/// Side by side there are two of one size, with a gap between them.
QRect PictureView::paneAt(const QPointF& device) const {
  QRect pane = deviceRect();
  if (shownMode() != Mode::sideBySide) return pane;
  constexpr int gap = 2;
  const int width = (pane.width() - gap) / 2;
  const bool isRight = device.x() >= width + gap / 2.0;
  return {isRight ? pane.width() - width : 0, 0, width, pane.height()};
}

Placement PictureView::placement(const QRect& pane) const {
  return place(m_viewport, pane, image().size());
}

std::optional<QPoint> PictureView::pixelAt(const QPointF& position) const {
  if (image().isNull() || !m_notice.isEmpty()) return {};
  const QPointF device = inDevice(position);
  const QPointF point = placement(paneAt(device)).toPicture(device);
  const QPoint pixel(int(std::floor(point.x())), int(std::floor(point.y())));
  return image().rect().contains(pixel) ? std::optional(pixel) : std::nullopt;
}

int PictureView::wipeColumn() const {
  return int(std::round(m_wipe * deviceRect().width()));
}

bool PictureView::isOnLine(const QPointF& position) const {
  constexpr double reach = 6;
  return shownMode() == Mode::wipe && std::abs(position.x() - m_wipe * width()) <= reach;
}

void PictureView::zoomBy(int steps, const QPointF& device) {
  if (image().isNull() || steps == 0) return;
  setViewport(zoomed(m_viewport, paneAt(device), image().size(), steps, device));
}

void PictureView::zoomIn() {
  zoomBy(1, paneAt({}).toRectF().center());
}

void PictureView::zoomOut() {
  zoomBy(-1, paneAt({}).toRectF().center());
}

void PictureView::fit() {
  setViewport({});
}

void PictureView::oneToOne() {
  if (!image().isNull()) setViewport(zoomedTo(m_viewport, paneAt({}), image().size(), 1));
}

/// The part that is shown, by a tenth of the pane.
void PictureView::pan(int x, int y) {
  if (image().isNull()) return;
  const QRect pane = paneAt({});
  const QPointF by(-x * pane.width() / 10.0, -y * pane.height() / 10.0);
  setViewport(moved(m_viewport, pane, image().size(), by));
}

void PictureView::panLeft() {
  pan(-1, 0);
}

void PictureView::panRight() {
  pan(1, 0);
}

void PictureView::panUp() {
  pan(0, -1);
}

void PictureView::panDown() {
  pan(0, 1);
}

void PictureView::wipeLeft() {
  setWipe(m_wipe - 0.02);
}

void PictureView::wipeRight() {
  setWipe(m_wipe + 0.02);
}

void PictureView::moreGain() {
  setGain(2 * m_gain);
}

void PictureView::lessGain() {
  setGain(m_gain / 2);
}

void PictureView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  m_pressed = event->position();
  m_draggedFrom = m_viewport;
  m_drag = isOnLine(m_pressed) ? Drag::wipe : Drag::press;
}

void PictureView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF position = event->position();
  m_pointer = position;
  const bool isFar = (position - m_pressed).manhattanLength() >= QApplication::startDragDistance();
  if (m_drag == Drag::press && isFar) m_drag = Drag::pan;
  if (m_drag == Drag::wipe) setWipe(position.x() / width());
  if (m_drag == Drag::pan && !image().isNull())
    setViewport(moved(m_draggedFrom, paneAt({}), image().size(), inDevice(position - m_pressed)));
  setCursor(isOnLine(position) ? Qt::SplitHCursor : Qt::CrossCursor);
  update();
}

void PictureView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const std::optional<QPoint> pixel = pixelAt(event->position());
  if (std::exchange(m_drag, Drag::none) == Drag::press && pixel)
    Q_EMIT pixelPicked(pixel->x(), pixel->y());
}

void PictureView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) fit();
}

void PictureView::leaveEvent(QEvent*) {
  m_pointer.reset();
  update();
}

void PictureView::wheelEvent(QWheelEvent* event) {
  constexpr int notch = 120;
  m_wheel += event->angleDelta().y();
  const int steps = m_wheel / notch;
  m_wheel -= steps * notch;
  zoomBy(steps, inDevice(event->position()));
}

}  // namespace hogelscope
