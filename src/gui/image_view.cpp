// SPDX-License-Identifier: BSD-3-Clause
// Shows the simulated view, as large as fits.
#include "gui/image_view.h"

#include <QMouseEvent>
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
  painter.setRenderHint(QPainter::SmoothPixmapTransform, target().width() < m_image.width());
  painter.drawImage(target(), m_image);
}

QRect ImageView::target() const {
  QRect target(QPoint(0, 0), m_image.size().scaled(size(), Qt::KeepAspectRatio));
  target.moveCenter(rect().center());
  return target;
}

void ImageView::mousePressEvent(QMouseEvent* event) {
  if (m_image.isNull() || !target().contains(event->position().toPoint())) return;
  const QPointF at = event->position() - target().topLeft();
  Q_EMIT pixelPicked(int(at.x() * m_image.width() / target().width()),
                     int(at.y() * m_image.height() / target().height()));
}

}  // namespace hogelscope
