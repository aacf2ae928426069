// SPDX-License-Identifier: BSD-3-Clause
// Shows the simulated view, as large as fits.
#pragma once

#include <QImage>
#include <QWidget>

namespace hogelscope {

class ImageView : public QWidget {
  Q_OBJECT

 public:
  explicit ImageView(QWidget* parent = nullptr);

  void setImage(const QImage& image);
  [[nodiscard]] const QImage& image() const { return m_image; }

 Q_SIGNALS:
  /// A click on a pixel of the picture.
  void pixelPicked(int x, int y);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;

 private:
  /// Where the picture is in the widget.
  [[nodiscard]] QRect target() const;

  QImage m_image;
};

}  // namespace hogelscope
