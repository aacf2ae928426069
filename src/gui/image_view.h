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

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QImage m_image;
};

}  // namespace hogelscope
