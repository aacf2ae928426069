// SPDX-License-Identifier: BSD-3-Clause
// Shows an image, or compares two of the same size: painting and pixel read-out.
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "gui/view/image_widget.h"
#include "gui/widgets/colours.h"
#include "picture/error_image.h"
#include "picture/labels.h"
#include "picture/marks.h"

namespace hogelscope {

namespace {

QString values(const QColor& colour) {
  return QStringLiteral("%1 %2 %3").arg(colour.red()).arg(colour.green()).arg(colour.blue());
}

QColor difference(const QColor& a, const QColor& b) {
  return {std::abs(a.red() - b.red()), std::abs(a.green() - b.green()),
          std::abs(a.blue() - b.blue())};
}

QColor withAlpha(QColor colour, double alpha) {
  colour.setAlphaF(float(alpha));
  return colour;
}

LabelColours labelColours() {
  return {withAlpha(tokens().raised, 0.85), tokens().text};
}

}  // namespace

void ImageWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), tokens().canvas);
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
  if (m_notice.isEmpty())
    return paintText(painter, noticeArea(), Qt::AlignCenter, m_remark, labelColours());
  constexpr double left = 0.35;  // of the outdated picture
  if (!image().isNull()) painter.fillRect(rect(), withAlpha(tokens().canvas, 1 - left));
  paintText(painter, noticeArea(), Qt::AlignCenter, m_notice, labelColours());
  if (m_cures->isHidden()) return;
  painter.setPen(tokens().error);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

/// Returns the part in whose middle notice or remark stand; buttons follow below it.
QRect ImageWidget::noticeArea() const {
  const int longest = 60 * fontMetrics().averageCharWidth();
  const int margin = std::max(0, width() - longest) / 2;
  const int buttons = m_cures->isHidden() ? 0 : m_cures->height();
  return rect().adjusted(margin, 0, -margin, -buttons);
}

void ImageWidget::paintImages(QPainter& painter) const {
  const QRect all = deviceRect();
  const QRect left = paneAt({});
  const QRect right = paneAt(all.bottomRight());
  switch (shownMode()) {
    case Mode::single:
      return paintOne(painter, all, all, 0);
    case Mode::blink:
      return paintOne(painter, all, all, m_turn);
    case Mode::sideBySide:
      paintOne(painter, left, left, 0);
      return paintOne(painter, right, right, 1);
    case Mode::wipe:
      return paintBoth(painter, all);
    case Mode::difference:
      return paintDifference(painter, all);
    case Mode::wipeAndError:
      paintBoth(painter, left);
      return paintDifference(painter, right);
  }
}

/// Paints both images with the wipe's line between them.
void ImageWidget::paintBoth(QPainter& painter, const QRect& pane) const {
  const int line = wipeColumn();
  paintOne(painter, pane, {0, 0, line, pane.height()}, 0);
  paintOne(painter, pane, pane.adjusted(line, 0, 0, 0), 1);
  paintWipe(painter, line, pane.height(), devicePixelRatioF());
}

void ImageWidget::paintOne(QPainter& painter, const QRect& pane, const QRect& clip,
                           std::size_t which) const {
  const Placement at = placement(pane);
  m_images[which].toned.paint(painter, clip, at);
  if (which == 0 && tint().size() == image().size()) m_tint.paint(painter, clip, at);
  m_images[which].hatch.paint(painter, clip, at);
  paintValues(painter, clip, at, which);
  paintMarks(painter, clip, at);
}

/// Paints the code values of an image's visible pixels, or without `which` their errors, into each,
/// if zoomed enough.
void ImageWidget::paintValues(QPainter& painter, const QRect& clip, const Placement& at,
                              std::optional<std::size_t> which) const {
  constexpr double least = 20;  // device pixels per image pixel
  if (at.zoom < least) return;
  const QImage& shown = which ? m_images[*which].toned.image() : m_difference.image();
  const QRect visible =
      QRectF(at.toImage(clip.topLeft()), at.toImage(clip.bottomRight())).toAlignedRect() &
      shown.rect();
  QFont font = textFont(TextSize::caption);
  // Three lines have to fit into a pixel.
  font.setPixelSize(std::min(int(at.zoom / 3.2), int(11 * devicePixelRatioF())));
  painter.save();
  painter.setClipRect(clip);
  painter.setFont(font);
  const int line = font.pixelSize();
  for (int y = visible.top(); y <= visible.bottom(); ++y)
    for (int x = visible.left(); x <= visible.right(); ++x) {
      const QStringList lines =
          (which ? values(m_images[*which].image.pixelColor(x, y))
                 : ErrorText::values(m_error.kind, image().pixel(x, y), otherImage().pixel(x, y)))
              .split(' ');
      const QRectF box(at.toDevice(QPointF(x, y)), QSizeF(at.zoom, at.zoom));
      const double top = box.center().y() - 0.5 * double(line * lines.size());
      constexpr int middle = 128;
      painter.setPen(qGray(shown.pixel(x, y)) < middle ? Qt::white : Qt::black);
      for (qsizetype k = 0; k < lines.size(); ++k)
        painter.drawText(QRectF(box.left(), top + double(k * line), box.width(), line),
                         int(Qt::AlignCenter) | int(Qt::TextDontClip), lines[k]);
    }
  painter.restore();
}

void ImageWidget::paintDifference(QPainter& painter, const QRect& pane) const {
  const Placement at = placement(pane);
  m_difference.paint(painter, pane, at);
  for (const Shown& image : m_images) image.hatch.paint(painter, pane, at);
  paintValues(painter, pane, at, {});
  paintMarks(painter, pane, at);
}

void ImageWidget::paintMarks(QPainter& painter, const QRect& clip, const Placement& at) const {
  paintPixelGrid(painter, clip, at, image().size());
  paintPixelMarks(painter, clip, at, m_marks);
  if (!m_region.isNull()) paintRegion(painter, clip, at, m_region);
}

/// Paints the pointer's position in the other pane, if there is one.
void ImageWidget::paintOtherPointer(QPainter& painter) const {
  if (!hasTwoPanes() || !m_pointer || !pixelAt(*m_pointer)) return;
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
  if (mode == Mode::difference) return errorHeading();
  if (mode == Mode::wipeAndError) return m_images[0].title;
  const QString what = mode == Mode::single  ? QString()
                       : mode == Mode::blink ? m_images[m_turn].title
                                             : m_images[0].title;
  return (what + ' ' + toneText()).trimmed();
}

QString ImageWidget::errorHeading() const {
  return (ErrorText::name(m_error.kind) + ' ' + toneText()).trimmed();
}

QString ImageWidget::toneText() const {
  return ErrorText::tone(shownTone());
}

void ImageWidget::paintTexts(QPainter& painter) const {
  const Mode mode = shownMode();
  const bool hasTwo = mode == Mode::sideBySide || hasWipe();
  QRect left = rect(), right = rect();
  if (hasTwoPanes()) {
    left.setRight(width() / 2 - 1);
    right.setLeft(width() / 2 + 1);
  }
  const auto paint = [&](const QRect& area, Qt::Alignment where, const QString& text,
                         const QColor& mark = {}) {
    paintText(painter, area, where, text, labelColours(), mark, scaled(8));
  };
  paint(
      rect(), Qt::AlignLeft | Qt::AlignTop, heading(),
      hasTwo || mode == Mode::blink ? tokens().series[mode == Mode::blink ? m_turn : 0] : QColor());
  const bool hasScale = hasError() && m_error.hasFalseColour;
  paintLegend(painter, hasScale ? paintScale(painter, rect(), *m_map, ErrorText::unit(m_error.kind),
                                             labelColours())
                                : rect().right());
  QRect top = rect();
  if (mode == Mode::wipe) top.translate(0, 2 * painter.fontMetrics().height());
  paint(top, Qt::AlignRight | Qt::AlignTop, m_tag);
  if (hasWipe()) paint(left, Qt::AlignRight | Qt::AlignTop, m_images[1].title, tokens().series[1]);
  if (mode == Mode::sideBySide)
    paint(right, Qt::AlignLeft | Qt::AlignTop, m_images[1].title, tokens().series[1]);
  if (mode == Mode::wipeAndError) paint(right, Qt::AlignLeft | Qt::AlignTop, errorHeading());
  // Moves the text away from the pointer, so that it does not cover that area.
  const bool isLow = m_pointer && m_pointer->y() > height() * 0.8 && m_pointer->x() < width() * 0.6;
  paint(rect(), (isLow ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom, readOut());
}

/// Paints what the mask's patterns mean, left of `right`.
void ImageWidget::paintLegend(QPainter& painter, int right) const {
  const std::array words{tr("no ray: the lens folds or ends before it"), tr("misses the panel"),
                         tr("outside the hogels' angular field")};
  constexpr int margin = 4;
  const int line = painter.fontMetrics().height() + margin;
  int bottom = height() - margin;
  for (std::size_t end = 0; end < words.size(); ++end) {
    if (!m_images[0].reasons[end] && !m_images[1].reasons[end]) continue;
    const int width = painter.fontMetrics().horizontalAdvance(words[end]) + line + margin;
    const QRect box(right - margin - width, bottom - line, width, line);
    paintGround(painter, box, labelColours().ground);
    painter.drawImage(box.topLeft(), hatchOf(RayEnd(end), line, hatchColours()));
    painter.setPen(tokens().text);
    painter.drawText(box.adjusted(line + margin, 0, 0, 0), Qt::AlignVCenter, words[end]);
    bottom -= line;
  }
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
  if (hasError() && m_error.kind != ErrorKind::absolute)
    text += tr(", %1 %2").arg(
        ErrorText::name(m_error.kind).toLower(),
        ErrorText::values(m_error.kind, image().pixel(*pixel), otherImage().pixel(*pixel)));
  const double zoom = placement(paneAt(inDevice(*m_pointer))).zoom;
  return text + tr(" (%1 %)").arg(100 * zoom, 0, 'f', 0);
}

QImage ImageWidget::shownImage() const {
  const Mode mode = shownMode();
  const QImage& first = m_images[0].toned.image();
  if (mode == Mode::single) return first;
  if (mode == Mode::blink) return m_images[m_turn].toned.image();
  if (mode == Mode::wipe) return wipedImage();
  const QImage error = !hasError()  ? QImage()
                       : m_isMapOld ? errorImage(image(), otherImage(), *m_map)
                                    : m_difference.image();
  if (mode == Mode::difference) return error;
  QImage shown(2 * first.width(), first.height(), first.format());
  QPainter painter(&shown);
  painter.drawImage(0, 0, hasWipe() ? wipedImage() : first);
  painter.drawImage(first.width(), 0, hasError() ? error : m_images[1].toned.image());
  return shown;
}

/// Returns the first image, right of the wipe's line the second.
QImage ImageWidget::wipedImage() const {
  QImage shown = m_images[0].toned.image();
  const double line = placement(paneAt({})).toImage(QPointF(wipeColumn(), 0)).x();
  const int from = std::clamp(int(std::round(line)), 0, shown.width());
  QPainter(&shown).drawImage(from, 0, m_images[1].toned.image(), from, 0);
  return shown;
}

}  // namespace hogelscope
