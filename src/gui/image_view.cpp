// SPDX-License-Identifier: BSD-3-Clause
// Shows the simulated view, as large as fits.
#include "gui/image_view.h"

#include <QPainter>

namespace hogelscope {

ImageView::ImageView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(160, 120);
}

void ImageView::setImage(const QImage& image) {
  m_image = image;
  update();
}

void ImageView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (m_image.isNull()) {
    painter.setPen(Qt::gray);
    painter.drawText(rect(), Qt::AlignCenter, tr("No view yet: open a session (Ctrl+O)"));
    return;
  }
  const QSize fitted = m_image.size().scaled(size(), Qt::KeepAspectRatio);
  QRect target(QPoint(0, 0), fitted);
  target.moveCenter(rect().center());
  painter.setRenderHint(QPainter::SmoothPixmapTransform, fitted.width() < m_image.width());
  painter.drawImage(target, m_image);
}

}  // namespace hogelscope
