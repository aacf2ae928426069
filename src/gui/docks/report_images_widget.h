// SPDX-License-Identifier: BSD-3-Clause
// A state's reference, test and difference beside each other, zoomed and panned together.
#pragma once

#include <QImage>
#include <QWidget>
#include <array>

class QLabel;

namespace hogelscope {

class ImageWidget;

class ReportImagesWidget : public QWidget {
  Q_OBJECT

 public:
  explicit ReportImagesWidget(QWidget* parent = nullptr);

  /// Null images where there are none.
  void setImages(const QString& state, const QImage& reference, const QImage& test);
  void clear();

 private:
  ImageWidget* add(std::size_t index, const char* name);

  std::array<QLabel*, 3> m_captions{};
  ImageWidget* m_reference;
  ImageWidget* m_test;
  ImageWidget* m_difference;
};

}  // namespace hogelscope
