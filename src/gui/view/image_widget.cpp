// SPDX-License-Identifier: BSD-3-Clause
// Shows an image, or compares two of the same size: contents and interaction. The painting is in
// image_widget_painting.cpp.
#include "gui/view/image_widget.h"

#include <QAction>
#include <QApplication>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPushButton>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "gui/widgets/task.h"
#include "picture/error_image.h"

namespace hogelscope {

ImageWidget::ImageWidget(QWidget* parent)
    : QWidget(parent),
      m_mapping(new Task(this)),
      m_turns(new QTimer(this)),
      m_cures(new QWidget(this)) {
  constexpr int turn = 500;  // milliseconds
  m_turns->setInterval(turn);
  connect(m_turns, &QTimer::timeout, this, &ImageWidget::takeTurn);
  setMinimumSize(160, 120);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setContextMenuPolicy(Qt::ActionsContextMenu);
  setAccessibleName(tr("Picture"));
  new QBoxLayout(QBoxLayout::LeftToRight, m_cures);
  m_cures->setCursor(Qt::ArrowCursor);
  m_cures->hide();
  addCommands();
}

template <class Action>
void ImageWidget::addCommand(const char* name, const QString& text, const QString& help,
                             const QList<QKeySequence>& keys, std::optional<Mode> mode,
                             Action does) {
  auto* action = new QAction(text, this);
  action->setObjectName(name);
  action->setToolTip(help);
  action->setShortcuts(keys);
  action->setShortcutContext(Qt::WidgetShortcut);
  if (mode) action->setData(int(*mode));
  connect(action, &QAction::triggered, this, does);
  addAction(action);
}

/// Adds shortcuts that need the widget's focus, and its context menu.
void ImageWidget::addCommands() {
  addCommand("zoomInAction", tr("Zoom &in"), tr("Shows less, larger by √2"),
             {Qt::Key_Plus, Qt::Key_Equal}, {},
             [this] { zoomBy(1, paneAt({}).toRectF().center()); });
  addCommand("zoomOutAction", tr("Zoom &out"), tr("Shows more, smaller by √2"), {Qt::Key_Minus}, {},
             [this] { zoomBy(-1, paneAt({}).toRectF().center()); });
  addCommand("fitPictureAction", tr("&Fit"), tr("Shows the whole picture"), {Qt::Key_0}, {},
             &ImageWidget::fit);
  addCommand("oneToOneAction", tr("One &to one"),
             tr("One pixel of the picture on one of the screen"), {Qt::Key_1}, {},
             &ImageWidget::oneToOne);
  for (const auto& [name, text, key, x, y] :
       {std::tuple("panLeftAction", tr("More to the left"), Qt::Key_Left, -1, 0),
        std::tuple("panRightAction", tr("More to the right"), Qt::Key_Right, 1, 0),
        std::tuple("panUpAction", tr("More above"), Qt::Key_Up, 0, -1),
        std::tuple("panDownAction", tr("More below"), Qt::Key_Down, 0, 1)})
    addCommand(name, text, tr("Moves what is shown by a tenth"), {key}, {},
               [this, x = x, y = y] { pan(x, y); });
  addCommand("wipeLeftAction", tr("Line to the &left"),
             tr("Moves the wipe's line by 2 % of the width"), {Qt::SHIFT | Qt::Key_Left},
             Mode::wipe, [this] { setWipe(m_wipe - 0.02); });
  addCommand("wipeRightAction", tr("Line to the &right"),
             tr("Moves the wipe's line by 2 % of the width"), {Qt::SHIFT | Qt::Key_Right},
             Mode::wipe, [this] { setWipe(m_wipe + 0.02); });
  addCommand("flipAction", tr("The &other picture"),
             tr("Shows the other one; they take turns no longer, until blinking is chosen again"),
             {Qt::Key_Space}, Mode::blink, &ImageWidget::flip);
  addCommand("moreGainAction", tr("&Double the gain"),
             tr("Shows the picture, or the error, twice as bright"), {Qt::SHIFT | Qt::Key_Up}, {},
             [this] { setGain(2 * gain()); });
  addCommand("lessGainAction", tr("&Halve the gain"),
             tr("Shows the picture, or the error, half as bright"), {Qt::SHIFT | Qt::Key_Down}, {},
             [this] { setGain(gain() / 2); });
  addCommand("stretchAction", tr("&Stretch"), tr("Shows the lightest pixel of the picture white"),
             {Qt::SHIFT | Qt::Key_R}, {}, &ImageWidget::stretch);
  addCommand("moreGammaAction", tr("More &gamma"),
             tr("Brightens dark parts of what is shown; code values are raised to 1/gamma"),
             {Qt::CTRL | Qt::Key_Up}, {}, [this] { setGamma(gamma() + 0.2); });
  addCommand("lessGammaAction", tr("L&ess gamma"), tr("Darkens dark parts of what is shown"),
             {Qt::CTRL | Qt::Key_Down}, {}, [this] { setGamma(gamma() - 0.2); });
  addCommand("resetToneAction", tr("&Reset gain and gamma"),
             tr("The picture as it is, or the error 4 times"), {Qt::Key_R}, {},
             &ImageWidget::resetTone);
  addCommand("removeRegionAction", tr("Re&move the rectangle"),
             tr("Shift and a drag mark a rectangle, whose figures are shown too"), {Qt::Key_Delete},
             {}, &ImageWidget::removeRegion);
  showActions();
}

/// Shows only the actions of the current mode.
void ImageWidget::showActions() {
  for (QAction* action : actions())
    if (action->data().isValid())
      action->setVisible(action->data().toInt() == int(Mode::wipe) ? hasWipe()
                                                                   : shownMode() == Mode::blink);
}

void ImageWidget::setImages(const QImage& image, const QImage& other) {
  const bool hasOther = !other.isNull() && other.size() == image.size();
  m_images[0].image = image;
  m_images[1].image = hasOther ? other : QImage();
  updateTones();
  updateDifference();
  setRegion(m_region);
  setViewport(m_viewport);
  Q_EMIT imagesChanged();
}

void ImageWidget::setMask(const QImage& seen, const QImage& otherSeen) {
  m_images[0].seen = seen;
  m_images[1].seen = otherSeen;
  updateHatch();
}

void ImageWidget::setTitles(const QString& title, const QString& otherTitle) {
  m_images[0].title = title;
  m_images[1].title = otherTitle;
  update();
}

void ImageWidget::setNotice(const QString& notice, const QList<QAction*>& cures) {
  m_notice = notice;
  m_remark.clear();
  setAccessibleDescription(notice);
  setCures(cures);
}

void ImageWidget::setRemark(const QString& remark, const QList<QAction*>& cures) {
  if (!m_notice.isEmpty() || m_remark == remark) return;
  m_remark = remark;
  setAccessibleDescription(remark);
  setCures(cures);
}

void ImageWidget::setCures(const QList<QAction*>& cures) {
  // A button whose click leads here is still needed when this returns.
  for (auto* old : m_cures->findChildren<QPushButton*>()) {
    old->hide();
    old->setObjectName({});
    m_cures->layout()->removeWidget(old);
    old->deleteLater();
  }
  for (QAction* cure : cures) {
    auto* button = new QPushButton;
    button->setObjectName(cure->objectName() + "Cure");
    button->setToolTip(cure->toolTip());
    m_cures->layout()->addWidget(button);
    connect(button, &QPushButton::clicked, cure, &QAction::trigger);
    // An undo is enabled only after the edit's failure has been shown.
    const auto follow = [this, button, cure] {
      button->setText(cure->text().remove('&'));
      button->setVisible(cure->isEnabled());
      placeCures();
    };
    connect(cure, &QAction::changed, button, follow);
    follow();
  }
  m_cures->setHidden(cures.isEmpty());
  placeCures();
  update();
}

void ImageWidget::setMode(Mode mode) {
  m_mode = mode;
  m_turn = 0;
  if (mode == Mode::blink)
    m_turns->start();
  else
    m_turns->stop();
  updateDifference();
}

void ImageWidget::setErrorMap(ErrorKind kind, bool hasFalseColour) {
  m_error.kind = kind;
  m_error.hasFalseColour = hasFalseColour;
  m_map.reset();
  updateDifference();
}

void ImageWidget::setTag(const QString& tag) {
  m_tag = tag;
  update();
}

void ImageWidget::showMask(bool isShown) {
  m_showsMask = isShown;
  updateHatch();
}

const Tone& ImageWidget::shownTone() const {
  return hasError() ? m_error.tone : m_tone;
}

void ImageWidget::setTone(const Tone& tone) {
  const Tone next{std::clamp(tone.gain, hasError() ? 1.0 : 1.0 / 16, 128.0),
                  std::clamp(tone.gamma, 0.2, 5.0)};
  if (hasError()) {
    m_error.tone = next;
    m_map.reset();
    return updateDifference();
  }
  m_tone = next;
  updateTones();
  Q_EMIT toneChanged();
}

void ImageWidget::setGamma(double gamma) {
  setTone({gain(), std::round(10 * gamma) / 10});
}

void ImageWidget::setTint(const QImage& tint) {
  if (tint.isNull() && m_tint.image().isNull()) return;
  m_tint = ZoomableImage(tint);
  update();
}

void ImageWidget::markPixels(const QRegion& pixels) {
  m_marked = pixels;
  m_marks.clear();
  m_marks.addRegion(pixels);
  m_marks = m_marks.simplified();
  update();
}

void ImageWidget::setRegion(const QRect& region) {
  const QRect inside = region & image().rect();
  if (inside == m_region) return;
  m_region = inside;
  update();
  Q_EMIT regionChanged(m_region);
}

void ImageWidget::setWipe(double share) {
  m_wipe = std::clamp(share, 0.0, 1.0);
  update();
}

void ImageWidget::updateTones() {
  for (Shown& shown : m_images) shown.toned = ZoomableImage(toned(shown.image, m_tone));
  update();
}

void ImageWidget::updateDifference() {
  const bool isShown = hasError();
  if (isShown && !m_map) m_map = std::make_shared<const ErrorMap>(m_error);
  constexpr double large = 1e6;  // pixels; smaller maps take a few milliseconds
  m_isMapOld = isShown && double(image().width()) * image().height() > large;
  ++m_wanted;
  if (!m_isMapOld)
    m_difference =
        isShown ? ZoomableImage(errorImage(image(), otherImage(), *m_map)) : ZoomableImage();
  else if (m_difference.image().size() != image().size())
    m_difference = {};
  if (m_isMapOld && !m_mapping->isRunning()) startMap();
  showActions();
  update();
  Q_EMIT toneChanged();
}

void ImageWidget::startMap() {
  m_mapping->start([this, number = m_wanted, own = image(), other = otherImage(),
                    map = m_map](const Progress&) -> Task::Answer {
    return [this, number, made = errorImage(own, other, *map)] { takeMap(number, made); };
  });
}

/// Takes a computed map. The newest wins, but older ones are shown meanwhile.
void ImageWidget::takeMap(int number, const QImage& map) {
  if (!m_isMapOld) return;
  if (map.size() == image().size()) m_difference = ZoomableImage(map);
  m_isMapOld = number != m_wanted;
  if (m_isMapOld) startMap();
  update();
}

void ImageWidget::updateHatch() {
  for (Shown& image : m_images) {
    image.hatch =
        m_showsMask ? ZoomableImage(hatched(image.seen, hatchColours())) : ZoomableImage();
    image.reasons = m_showsMask ? reasonsIn(image.seen) : std::array<bool, 3>{};
  }
  update();
}

void ImageWidget::setViewport(const Viewport& viewport) {
  m_viewport = limitCentre(viewport, image().size());
  update();
}

ImageWidget::Mode ImageWidget::shownMode() const {
  return otherImage().isNull() ? Mode::single : m_mode;
}

bool ImageWidget::hasTwoPanes() const {
  return shownMode() == Mode::sideBySide || shownMode() == Mode::wipeAndError;
}

bool ImageWidget::hasWipe() const {
  return shownMode() == Mode::wipe || shownMode() == Mode::wipeAndError;
}

bool ImageWidget::hasError() const {
  return shownMode() == Mode::difference || shownMode() == Mode::wipeAndError;
}

QRect ImageWidget::deviceRect() const {
  return {QPoint(0, 0), (QSizeF(size()) * devicePixelRatioF()).toSize()};
}

QPointF ImageWidget::inDevice(const QPointF& position) const {
  return position * devicePixelRatioF();
}

/// Returns the pane at a position. Two panes have equal sizes and a gap between them.
QRect ImageWidget::paneAt(const QPointF& device) const {
  QRect pane = deviceRect();
  if (!hasTwoPanes()) return pane;
  constexpr int gap = 2;
  const int width = (pane.width() - gap) / 2;
  const bool isRight = device.x() >= width + gap / 2.0;
  return {isRight ? pane.width() - width : 0, 0, width, pane.height()};
}

Placement ImageWidget::placement(const QRect& pane) const {
  return placementOf(m_viewport, pane, image().size());
}

std::optional<QPoint> ImageWidget::pixelAt(const QPointF& position) const {
  if (image().isNull() || !m_notice.isEmpty()) return {};
  const QPointF device = inDevice(position);
  const QPointF point = placement(paneAt(device)).toImage(device);
  const QPoint pixel(int(std::floor(point.x())), int(std::floor(point.y())));
  return image().rect().contains(pixel) ? std::optional(pixel) : std::nullopt;
}

int ImageWidget::wipeColumn() const {
  return int(std::round(m_wipe * paneAt({}).width()));
}

bool ImageWidget::isOnLine(const QPointF& position) const {
  constexpr double reach = 6;
  return hasWipe() && std::abs(position.x() - wipeColumn() / devicePixelRatioF()) <= reach;
}

void ImageWidget::zoomBy(int steps, const QPointF& device) {
  if (image().isNull() || steps == 0) return;
  setViewport(zoomed(m_viewport, paneAt(device), image().size(), steps, device));
}

void ImageWidget::fit() {
  setViewport({});
}

void ImageWidget::oneToOne() {
  if (!image().isNull()) setViewport(zoomedTo(m_viewport, paneAt({}), image().size(), 1));
}

/// Moves the visible part by a tenth of the pane.
void ImageWidget::pan(int x, int y) {
  if (image().isNull()) return;
  const QRect pane = paneAt({});
  const QPointF by(-x * pane.width() / 10.0, -y * pane.height() / 10.0);
  setViewport(moved(m_viewport, pane, image().size(), by));
}

void ImageWidget::resetTone() {
  setTone(hasError() ? ErrorMap::Params().tone : Tone());
}

/// Swaps the blinking images by hand.
void ImageWidget::flip() {
  m_turns->stop();
  takeTurn();
}

void ImageWidget::takeTurn() {
  if (shownMode() != Mode::blink) return;
  m_turn = 1 - m_turn;
  update();
}

void ImageWidget::removeRegion() {
  setRegion({});
}

/// Returns the region from the pressed position to `position`, within the pressed pane.
QRect ImageWidget::regionTo(const QPointF& position) const {
  const Placement at = placement(paneAt(inDevice(m_pressed)));
  const auto pixel = [&](const QPointF& place) {
    const QPointF point = at.toImage(inDevice(place));
    return QPoint(std::clamp(int(std::floor(point.x())), 0, image().width() - 1),
                  std::clamp(int(std::floor(point.y())), 0, image().height() - 1));
  };
  const QPoint from = pixel(m_pressed);
  const QPoint to = pixel(position);
  return {QPoint(std::min(from.x(), to.x()), std::min(from.y(), to.y())),
          QPoint(std::max(from.x(), to.x()), std::max(from.y(), to.y()))};
}

void ImageWidget::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  m_pressed = event->position();
  m_draggedFrom = m_viewport;
  const bool isRegion = event->modifiers().testFlag(Qt::ShiftModifier) && !image().isNull();
  m_drag = isRegion ? Drag::region : isOnLine(m_pressed) ? Drag::wipe : Drag::press;
  if (isRegion) removeRegion();
}

void ImageWidget::mouseMoveEvent(QMouseEvent* event) {
  const QPointF position = event->position();
  m_pointer = position;
  const bool isFar = (position - m_pressed).manhattanLength() >= QApplication::startDragDistance();
  if (m_drag == Drag::press && isFar) m_drag = Drag::pan;
  if (m_drag == Drag::wipe) setWipe(inDevice(position).x() / paneAt({}).width());
  if (m_drag == Drag::region && isFar) setRegion(regionTo(position));
  Q_EMIT pointed(pixelAt(position).value_or(QPoint(-1, -1)));
  if (m_drag == Drag::pan && !image().isNull())
    setViewport(moved(m_draggedFrom, paneAt({}), image().size(), inDevice(position - m_pressed)));
  setCursor(isOnLine(position) ? Qt::SplitHCursor : Qt::CrossCursor);
  update();
}

void ImageWidget::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const std::optional<QPoint> pixel = pixelAt(event->position());
  if (std::exchange(m_drag, Drag::none) != Drag::press || !pixel) return;
  if (event->modifiers().testFlag(Qt::ControlModifier))
    Q_EMIT focusAsked(pixel->x(), pixel->y());
  else
    Q_EMIT pixelPicked(pixel->x(), pixel->y());
}

void ImageWidget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) fit();
}

void ImageWidget::leaveEvent(QEvent*) {
  m_pointer.reset();
  Q_EMIT pointed(QPoint(-1, -1));
  update();
}

void ImageWidget::resizeEvent(QResizeEvent*) {
  placeCures();
}

void ImageWidget::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) updateHatch();
  QWidget::changeEvent(event);
}

int ImageWidget::lightest(int enough) const {
  int most = 0;
  for (int y = 0; y < image().height() && most < enough; ++y)
    for (int x = 0; x < image().width() && most < enough; ++x) {
      const QRgb pixel = image().pixel(x, y);
      most = std::max({most, qRed(pixel), qGreen(pixel), qBlue(pixel)});
    }
  return most;
}

void ImageWidget::stretch() {
  if (const int most = lightest(); most > 0) setGain(255.0 / most);
  setRemark({});
}

/// Puts the buttons below the text.
void ImageWidget::placeCures() {
  constexpr int gap = 8;
  auto* row = static_cast<QBoxLayout*>(m_cures->layout());
  row->setDirection(QBoxLayout::LeftToRight);
  if (row->sizeHint().width() > width()) row->setDirection(QBoxLayout::TopToBottom);
  m_cures->adjustSize();
  const QRect text = fontMetrics().boundingRect(
      noticeArea(), int(Qt::AlignCenter) | int(Qt::TextWordWrap), m_notice + m_remark);
  m_cures->move((width() - m_cures->width()) / 2,
                std::min(text.bottom() + gap, height() - m_cures->height()));
}

void ImageWidget::wheelEvent(QWheelEvent* event) {
  constexpr int notch = 120;
  m_wheel += event->angleDelta().y();
  const int steps = m_wheel / notch;
  m_wheel -= steps * notch;
  zoomBy(steps, inDevice(event->position()));
}

}  // namespace hogelscope
