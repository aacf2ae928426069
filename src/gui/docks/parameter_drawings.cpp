// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/parameter_drawings.h"

#include <QHelpEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "core/base/colour_map.h"
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
  setMinimumSize(120, 200);
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

namespace {

QColor colourOf(double share) {
  const auto [r, g, b] = falseColour(share);
  return {r, g, b};
}

/// Returns the square of the taps; a line of text follows below it.
QRectF squareIn(const QSizeF& size, const QFontMetrics& text) {
  const double below = text.height() + 6;
  const double side = std::max(1.0, std::min(size.width() - 8, size.height() - below - 4));
  return {(size.width() - side) / 2, 4, side, side};
}

/// Returns a scaled font. The chart's font has a size in pixels, the window's one in points.
QFont smaller(QFont font, double factor) {
  if (font.pixelSize() > 0)
    font.setPixelSize(int(std::lround(factor * font.pixelSize())));
  else
    font.setPointSizeF(factor * font.pointSizeF());
  return font;
}

/// Returns a weight in per cent, in short form.
QString percent(double weight) {
  return weight < 0.001 ? QString::number(100 * weight, 'g', 1)
                        : QString::number(100 * weight, 'f', 1);
}

}  // namespace

KernelWidget::KernelWidget(QWidget* parent) : QWidget(parent) {
  setObjectName("kernelView");
  setMinimumSize(120, 200);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  new PlotSaver(this, tr("Leakage"), {400, 424},
                [this](QPainter& painter, const QSizeF& size) { paint(painter, size); });
}

void KernelWidget::setParams(const PsfParams& params) {
  const bool hasKernel = params.windowSize == 1 || params.sigma > 0;
  setWeights(params, hasKernel ? psfKernel(params) : std::vector<double>{});
}

void KernelWidget::setWeights(const PsfParams& params, const std::vector<double>& weights) {
  m_params = params;
  m_weights = weights;
  setAccessibleName(tr("Kernel of %1×%1 taps").arg(params.windowSize));
  update();
}

/// Returns the rectangle of tap k.
QRectF KernelWidget::cell(const QRectF& square, int k) const {
  const int side = m_params.windowSize;
  const double width = square.width() / side;
  const int row = k / side;
  return {square.left() + width * (k % side), square.top() + width * row, width, width};
}

QString KernelWidget::textAt(const QPointF& position) const {
  const QRectF square = squareIn(size(), fontMetrics());
  if (m_weights.empty() || !square.contains(position)) return {};
  const int side = m_params.windowSize;
  const QPointF inside = (position - square.topLeft()) / square.width() * side;
  const int column = std::min(int(inside.x()), side - 1);
  const int row = std::min(int(inside.y()), side - 1);
  return tr("Tap (%1, %2): %3 % of the light")
      .arg(column - side / 2)
      .arg(row - side / 2)
      .arg(100 * m_weights[std::size_t(row) * std::size_t(side) + std::size_t(column)], 0, 'g', 4);
}

bool KernelWidget::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), textAt(help->pos()), this);
  return true;
}

void KernelWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(palette().color(QPalette::WindowText));
  paint(painter, size());
}

/// Paints the taps; the text below them has the painter's colour.
void KernelWidget::paint(QPainter& painter, const QSizeF& size) const {
  if (m_weights.empty()) {
    painter.drawText(QRectF({0, 0}, size), Qt::AlignCenter, tr("no kernel: sigma is 0"));
    return;
  }
  const QRectF square = squareIn(size, painter.fontMetrics());
  painter.save();
  paintCells(painter, square);
  if (m_params.windowSize > 1) paintSigma(painter, square);
  paintNumbers(painter, square);
  painter.restore();
  const QRectF below(0, square.bottom(), size.width(), size.height() - square.bottom());
  painter.drawText(below, Qt::AlignCenter,
                   m_params.windowSize == 1 ? tr("no leakage") : tr("weights in %, circle: sigma"));
}

void KernelWidget::paintCells(QPainter& painter, const QRectF& square) const {
  const double most = *std::max_element(m_weights.begin(), m_weights.end());
  const bool hasGrid = cell(square, 0).width() >= 6;
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(hasGrid ? QPen(QColor(0, 0, 0, 90)) : QPen(Qt::NoPen));
  for (int k = 0; k < int(m_weights.size()); ++k) {
    painter.setBrush(colourOf(m_weights[std::size_t(k)] / most));
    // A small overlap prevents background lines between cells without a grid.
    const double overlap = hasGrid ? 0 : 1;
    painter.drawRect(cell(square, k).adjusted(0, 0, overlap, overlap).intersected(square));
  }
  painter.setRenderHint(QPainter::Antialiasing, true);
}

void KernelWidget::paintNumbers(QPainter& painter, const QRectF& square) const {
  const QFont small = smaller(painter.font(), 0.85);
  painter.setFont(small);
  if (cell(square, 0).width() < painter.fontMetrics().horizontalAdvance("100.0") + 2) return;
  const double most = *std::max_element(m_weights.begin(), m_weights.end());
  for (int k = 0; k < int(m_weights.size()); ++k) {
    const double weight = m_weights[std::size_t(k)];
    painter.setPen(weight > 0.6 * most ? Qt::black : Qt::white);
    painter.drawText(cell(square, k), Qt::AlignCenter, percent(weight));
  }
}

/// Paints a circle of radius sigma around the middle tap, clipped to the window.
void KernelWidget::paintSigma(QPainter& painter, const QRectF& square) const {
  const double radius = m_params.sigma * square.width() / m_params.windowSize;
  QPainterPath window;
  window.addRect(square);
  QPainterPath circle;
  circle.addEllipse(square.center(), radius, radius);
  const auto draw = [&](const QPen& pen) {
    // Intersects paths, because Qt's SVG ignores clipping.
    const QPainterPath line = QPainterPathStroker(pen).createStroke(circle);
    painter.fillPath(line.intersected(window), pen.brush());
  };
  draw(QPen(QColor(0, 0, 0, 160), 3.5));
  draw(QPen(Qt::white, 1.5, Qt::DashLine));
}

}  // namespace hogelscope
