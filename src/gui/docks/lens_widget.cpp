// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/lens_widget.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "gui/docks/plot_saver.h"

namespace hogelscope {

namespace {

const QColor paper(255, 255, 255);
const QColor line(52, 94, 150);
const QColor fold(200, 40, 40);

QPolygonF polygonOf(const std::vector<Vec2>& points) {
  QPolygonF polygon;
  for (const Vec2& point : points) polygon << QPointF(point.x, point.y);
  return polygon;
}

}  // namespace

LensWidget::LensWidget(QWidget* parent)
    : QWidget(parent),
      m_saver(
          new PlotSaver(this, tr("Lens"), {480, 480},
                        [this](QPainter& painter, const QSizeF& size) { paint(painter, size); })) {
  m_saver->setEnabled(false);
  setObjectName("lensView");
  setAccessibleName(tr("Drawing of the lens"));
  setToolTip(
      tr("Blue: a grid of straight lines, ten squares in a pinhole's picture height, as the "
         "lens shows it. Frame: the picture. Red: the fold; what is hatched has no ray"));
  setMinimumSize(120, 120);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void LensWidget::setLens(const LensGrid& grid) {
  m_grid = grid;
  m_saver->setEnabled(grid.res[0] > 0);
  update();
}

QRectF LensWidget::border() const {
  return {-0.5, -0.5, double(m_grid.res[0]), double(m_grid.res[1])};
}

/// Returns the transform of the image into the widget, with a margin for the grid beyond it.
QTransform LensWidget::fromImage(const QSizeF& size) const {
  constexpr double margin = 1.12;
  const double scale =
      std::min(size.width() / (margin * m_grid.res[0]), size.height() / (margin * m_grid.res[1]));
  QTransform transform;
  transform.translate(size.width() / 2, size.height() / 2);
  transform.scale(scale, scale);
  transform.translate(-border().center().x(), -border().center().y());
  return transform;
}

QPainterPath LensWidget::foldPath() const {
  QPainterPath path;
  path.addPolygon(polygonOf(m_grid.fold));
  path.closeSubpath();
  return path;
}

void LensWidget::paintEvent(QPaintEvent*) {
  if (m_grid.res[0] < 1 || m_grid.res[1] < 1) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!isEnabled()) painter.setOpacity(0.35);
  painter.setPen(palette().color(QPalette::WindowText));
  paint(painter, size());
}

/// Paints the lens; the frame has the painter's colour.
void LensWidget::paint(QPainter& painter, const QSizeF& size) const {
  const QColor ink = painter.pen().color();
  const QTransform transform = fromImage(size);
  const QRectF frame = transform.mapRect(border());
  painter.fillRect(frame, paper);
  paintLines(painter, transform);
  if (!m_grid.fold.empty()) paintFold(painter, transform);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(ink, 1.5));
  painter.drawRect(frame);
}

void LensWidget::paintLines(QPainter& painter, const QTransform& transform) const {
  painter.setPen(QPen(line, 1));
  for (const std::vector<Vec2>& points : m_grid.lines)
    painter.drawPolyline(transform.map(polygonOf(points)));
}

void LensWidget::paintFold(QPainter& painter, const QTransform& transform) const {
  QPainterPath image;
  image.addRect(border());
  painter.fillPath(transform.map(image.subtracted(foldPath())), QBrush(fold, Qt::BDiagPattern));
  // Intersects paths, because Qt's SVG ignores clipping.
  const QPainterPath line =
      QPainterPathStroker(QPen(fold, 2)).createStroke(transform.map(foldPath()));
  painter.fillPath(line.intersected(transform.map(image)), fold);
}

}  // namespace hogelscope
