// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/parameter_drawings.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include "chart/kernel_drawing.h"
#include "chart/lens_drawing.h"
#include "gui/docks/chart_colours.h"
#include "gui/docks/plot_saver.h"

namespace hogelscope {

LensWidget::LensWidget(QWidget* parent)
    : QWidget(parent),
      m_saver(new PlotSaver(this, tr("Lens"), {480, 480},
                            [this](QPainter& painter, const QSizeF& size) {
                              paintLens(painter, size, m_grid, printColours());
                            })) {
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

void LensWidget::paintEvent(QPaintEvent*) {
  if (m_grid.res[0] < 1 || m_grid.res[1] < 1) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (!isEnabled()) painter.setOpacity(0.35);
  paintLens(painter, size(), m_grid, chartColours());
}

KernelWidget::KernelWidget(QWidget* parent) : QWidget(parent) {
  setObjectName("kernelView");
  setMinimumSize(120, 200);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  new PlotSaver(this, tr("Leakage"), {400, 424}, [this](QPainter& painter, const QSizeF& size) {
    paintKernel(painter, size, m_params, m_weights);
  });
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

QString KernelWidget::textAt(const QPointF& position) const {
  const int side = m_params.windowSize;
  const std::optional<QPoint> tap = tapAt(position, size(), fontMetrics(), side);
  if (m_weights.empty() || !tap) return {};
  return tr("Tap (%1, %2): %3 % of the light")
      .arg(tap->x() - side / 2)
      .arg(tap->y() - side / 2)
      .arg(100 * m_weights[std::size_t(tap->y() * side + tap->x())], 0, 'g', 4);
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
  paintKernel(painter, size(), m_params, m_weights);
}

}  // namespace hogelscope
