// SPDX-License-Identifier: BSD-3-Clause
// Shows an image, or compares two of the same size: painting and pixel read-out.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "gui/view/error_image.h"
#include "gui/view/image_widget.h"

namespace hogelscope {

namespace {

QString values(const QColor& colour) {
  return QStringLiteral("%1 %2 %3").arg(colour.red()).arg(colour.green()).arg(colour.blue());
}

QColor difference(const QColor& a, const QColor& b) {
  return {std::abs(a.red() - b.red()), std::abs(a.green() - b.green()),
          std::abs(a.blue() - b.blue())};
}

/// Paints a text on a dark background in the given corner of `area`.
void paintText(QPainter& painter, const QRect& area, Qt::Alignment corner, const QString& text) {
  if (text.isEmpty()) return;
  constexpr int margin = 4;
  const QRect inner = area.adjusted(margin, margin, -margin, -margin);
  QRect box = painter.boundingRect(inner, int(corner) | int(Qt::TextWordWrap), text);
  box = box.adjusted(-margin, -margin / 2, margin, margin / 2);
  painter.fillRect(box, QColor(0, 0, 0, 170));
  painter.setPen(Qt::white);
  painter.drawText(box, int(Qt::AlignCenter) | int(Qt::TextWordWrap), text);
}

/// Paints white on black, which is visible on any image.
void paintOutline(QPainter& painter, const QRect& clip, const QPainterPath& outline,
                  Qt::PenStyle style) {
  painter.save();
  painter.setClipRect(clip);
  painter.strokePath(outline, QPen(Qt::black, 3));
  painter.strokePath(outline, QPen(Qt::white, 1, style));
  painter.restore();
}

QPainterPath around(const QRectF& box) {
  QPainterPath path;
  path.addRect(box);
  return path;
}

QRectF inDevice(const Placement& at, const QRectF& pixels) {
  return {at.toDevice(pixels.topLeft()), at.toDevice(pixels.bottomRight())};
}

/// Paints a line around pixels, large enough to be visible at any zoom.
void paintPixelMarks(QPainter& painter, const QRect& clip, const Placement& at,
                     const QPainterPath& outline) {
  if (outline.isEmpty()) return;
  constexpr double smallest = 9;
  const QRectF box = inDevice(at, outline.boundingRect());
  const double grow = std::max(0.0, (smallest - std::min(box.width(), box.height())) / 2) + 1;
  if (grow > 1) {
    paintOutline(painter, clip, around(box.adjusted(-grow, -grow, grow, grow)), Qt::SolidLine);
  } else {
    const QTransform toDevice(at.zoom, 0, 0, at.zoom, at.origin.x(), at.origin.y());
    paintOutline(painter, clip, toDevice.map(outline), Qt::SolidLine);
  }
}

void paintRegion(QPainter& painter, const QRect& clip, const Placement& at, const QRect& region) {
  paintOutline(painter, clip, around(inDevice(at, region)), Qt::DashLine);
}

/// Paints a colour scale at the right of `area`, with numbers and their unit.
void paintScale(QPainter& painter, const QRect& area, const ErrorMap& map, const QString& unit) {
  constexpr int parts = 4;
  constexpr int gap = 4;
  const QFontMetrics metrics(painter.font());
  QStringList numbers;
  int textWidth = metrics.horizontalAdvance(unit);
  for (int k = 0; k <= parts; ++k) {
    numbers << QString::number(map.errorAt(double(k) / parts), 'g', 4);
    textWidth = std::max(textWidth, metrics.horizontalAdvance(numbers.back()));
  }
  constexpr int barWidth = 12;
  const int line = metrics.height();
  const int height = std::min(area.height() - 4 * line, 260);
  if (height < (parts + 1) * line) return;
  const QRect ground(area.right() - barWidth - textWidth - 4 * gap,
                     area.center().y() - height / 2 - 2 * line, barWidth + textWidth + 3 * gap,
                     height + 3 * line);
  painter.fillRect(ground, QColor(0, 0, 0, 220));
  const QRect bar(ground.left() + gap, ground.top() + 2 * line, barWidth, height);
  for (int y = 0; y < height; ++y) {
    const auto [red, green, blue] = map.colourAt(1 - double(y) / (height - 1));
    painter.fillRect(bar.left(), bar.top() + y, barWidth, 1, QColor(red, green, blue));
  }
  painter.setPen(Qt::white);
  const int left = bar.right() + gap;
  painter.drawText(QRect(ground.left(), ground.top(), ground.width() - gap, line), Qt::AlignRight,
                   unit);
  for (int k = 0; k <= parts; ++k)
    painter.drawText(QRect(left, bar.bottom() - k * height / parts - line / 2, textWidth, line),
                     int(Qt::AlignRight) | int(Qt::AlignVCenter), numbers[k]);
}

}  // namespace

void ImageWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), QColor(38, 40, 44));
  if (!image().isNull()) {
    painter.save();
    painter.scale(1 / devicePixelRatioF(), 1 / devicePixelRatioF());
    paintImages(painter);
    paintOtherPointer(painter);
    painter.restore();
    paintTexts(painter);
  }
  paintNotice(painter);
}

void ImageWidget::paintNotice(QPainter& painter) const {
  if (m_notice.isEmpty()) return;
  if (!image().isNull()) painter.fillRect(rect(), QColor(0, 0, 0, 150));
  const int longest = 60 * fontMetrics().averageCharWidth();
  const int margin = std::max(0, width() - longest) / 2;
  paintText(painter, rect().adjusted(margin, 0, -margin, 0), Qt::AlignCenter, m_notice);
}

void ImageWidget::paintImages(QPainter& painter) const {
  const QRect all = deviceRect();
  const QRect left = paneAt({});
  const QRect right = paneAt(all.bottomRight());
  const int line = wipeColumn();
  switch (shownMode()) {
    case Mode::single:
      return paintOne(painter, all, all, 0);
    case Mode::blink:
      return paintOne(painter, all, all, m_turn);
    case Mode::sideBySide:
      paintOne(painter, left, left, 0);
      return paintOne(painter, right, right, 1);
    case Mode::wipe:
      paintOne(painter, all, {0, 0, line, all.height()}, 0);
      paintOne(painter, all, all.adjusted(line, 0, 0, 0), 1);
      painter.fillRect(line - 1, 0, 3, all.height(), QColor(0, 0, 0, 120));
      return painter.fillRect(line, 0, 1, all.height(), Qt::white);
    case Mode::difference:
      return paintDifference(painter, all);
  }
}

void ImageWidget::paintOne(QPainter& painter, const QRect& pane, const QRect& clip,
                           std::size_t which) const {
  const Placement at = placement(pane);
  m_images[which].toned.paint(painter, clip, at);
  m_images[which].hatch.paint(painter, clip, at);
  paintMarks(painter, clip, at);
}

void ImageWidget::paintDifference(QPainter& painter, const QRect& pane) const {
  const Placement at = placement(pane);
  m_difference.paint(painter, pane, at);
  for (const Shown& image : m_images) image.hatch.paint(painter, pane, at);
  paintMarks(painter, pane, at);
}

void ImageWidget::paintMarks(QPainter& painter, const QRect& clip, const Placement& at) const {
  paintPixelGrid(painter, clip, at, image().size());
  paintPixelMarks(painter, clip, at, m_marks);
  if (!m_region.isNull()) paintRegion(painter, clip, at, m_region);
}

/// Paints the pointer's position in the other pane, side by side only.
void ImageWidget::paintOtherPointer(QPainter& painter) const {
  if (shownMode() != Mode::sideBySide || !m_pointer || !pixelAt(*m_pointer)) return;
  const QPointF device = inDevice(*m_pointer);
  const QRect pane = paneAt(device);
  const QRect all = deviceRect();
  const QRect other = paneAt(pane.left() > 0 ? QPointF() : QPointF(all.bottomRight()));
  const QPoint at = (device + other.topLeft() - pane.topLeft()).toPoint();
  constexpr int arm = 7;
  for (const auto& [colour, width] : {std::pair(Qt::black, 3), std::pair(Qt::white, 1)}) {
    painter.fillRect(at.x() - arm, at.y() - width / 2, 2 * arm + 1, width, colour);
    painter.fillRect(at.x() - width / 2, at.y() - arm, width, 2 * arm + 1, colour);
  }
}

/// Returns the title of the whole, or of the first image.
QString ImageWidget::heading() const {
  const Mode mode = shownMode();
  const QString what = mode == Mode::difference ? ErrorText::name(m_error.kind)
                       : mode == Mode::single   ? QString()
                       : mode == Mode::blink    ? m_images[m_turn].title
                                                : m_images[0].title;
  return (what + ' ' + ErrorText::tone(shownTone())).trimmed();
}

void ImageWidget::paintTexts(QPainter& painter) const {
  const Mode mode = shownMode();
  const auto corner = [](Qt::AlignmentFlag side, Qt::AlignmentFlag end) { return side | end; };
  paintText(painter, rect(), corner(Qt::AlignLeft, Qt::AlignTop), heading());
  if (mode == Mode::difference && m_error.hasFalseColour)
    paintScale(painter, rect(), *m_map, ErrorText::unit(m_error.kind));
  if (mode == Mode::sideBySide || mode == Mode::wipe) {
    QRect second = rect();
    if (mode == Mode::sideBySide) second.setLeft(width() / 2 + 1);
    paintText(painter, second,
              corner(mode == Mode::wipe ? Qt::AlignRight : Qt::AlignLeft, Qt::AlignTop),
              m_images[1].title);
  }
  // Moves the text away from the pointer, so that it does not cover that area.
  const bool isLow = m_pointer && m_pointer->y() > height() * 0.8 && m_pointer->x() < width() * 0.6;
  paintText(painter, rect(), corner(isLow ? Qt::AlignRight : Qt::AlignLeft, Qt::AlignBottom),
            readOut());
}

QString ImageWidget::readOut() const {
  const std::optional<QPoint> pixel = m_pointer ? pixelAt(*m_pointer) : std::nullopt;
  if (!pixel) return {};
  const auto valuesOf = [&](const Shown& image) {
    const bool isUnseen = image.seen.valid(*pixel) && qGray(image.seen.pixel(*pixel)) == 0;
    return isUnseen ? tr("not seen") : values(image.image.pixelColor(*pixel));
  };
  QString text = tr("x %1, y %2: ").arg(pixel->x()).arg(pixel->y()) + valuesOf(m_images[0]);
  if (!otherImage().isNull())
    text +=
        tr(" | %1, difference %2")
            .arg(valuesOf(m_images[1]),
                 values(difference(image().pixelColor(*pixel), otherImage().pixelColor(*pixel))));
  if (shownMode() == Mode::difference && m_error.kind != ErrorKind::absolute)
    text += tr(", %1 %2").arg(
        ErrorText::name(m_error.kind).toLower(),
        ErrorText::values(m_error.kind, image().pixel(*pixel), otherImage().pixel(*pixel)));
  const double zoom = placement(paneAt(inDevice(*m_pointer))).zoom;
  return text + tr(" (%1 %)").arg(100 * zoom, 0, 'f', 0);
}

QImage ImageWidget::shownImage() const {
  const Mode mode = shownMode();
  const QImage& first = m_images[0].toned.image();
  const QImage& second = m_images[1].toned.image();
  if (mode == Mode::single) return first;
  if (mode == Mode::blink) return m_images[m_turn].toned.image();
  if (mode == Mode::difference)
    return m_isMapOld ? errorImage(image(), otherImage(), *m_map) : m_difference.image();
  const bool isWipe = mode == Mode::wipe;
  const int split =
      isWipe ? int(std::round(placement(deviceRect()).toImage(QPointF(wipeColumn(), 0)).x()))
             : first.width();
  QImage shown(isWipe ? first.size() : QSize(2 * first.width(), first.height()), first.format());
  QPainter painter(&shown);
  painter.drawImage(0, 0, first);
  const int from = std::clamp(split, 0, first.width());
  if (isWipe)
    painter.drawImage(from, 0, second, from, 0);
  else
    painter.drawImage(from, 0, second);
  return shown;
}

}  // namespace hogelscope
