// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/histogram_widget.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace hogelscope {

HistogramWidget::HistogramWidget(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  setAccessibleName(tr("Histogram"));
  setToolTip(
      tr("How many seen pixels have which luma, 0 at the left to 255 at the right, heights being "
         "square roots: filled the session's own picture, as a line the other; of the marked "
         "rectangle where there is one"));
}

void HistogramWidget::setHistograms(const std::vector<Histogram>& histograms) {
  m_histograms = histograms;
  update();
}

void HistogramWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().base());
  std::size_t most = 1;
  for (const Histogram& counts : m_histograms)
    most = std::max(most, *std::ranges::max_element(counts));
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t which = 0; which < m_histograms.size(); ++which) {
    const Histogram& counts = m_histograms[which];
    const double step = double(width()) / double(counts.size());
    QPainterPath line(QPointF(0, height()));
    for (std::size_t k = 0; k < counts.size(); ++k) {
      const double y = height() * (1 - 0.95 * std::sqrt(double(counts[k]) / double(most)));
      line.lineTo(step * double(k), y);
      line.lineTo(step * double(k + 1), y);
    }
    line.lineTo(width(), height());
    if (which == 0)
      painter.fillPath(line, QColor(128, 128, 128));
    else
      painter.strokePath(line, QPen(palette().highlight(), 1.5));
  }
}

}  // namespace hogelscope
