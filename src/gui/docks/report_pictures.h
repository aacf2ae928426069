// SPDX-License-Identifier: BSD-3-Clause
// A state's reference, test and difference beside each other, zoomed and panned together.
#pragma once

#include <QImage>
#include <QWidget>
#include <array>

class QLabel;

namespace hogelscope {

class PictureView;

class ReportPictures : public QWidget {
  Q_OBJECT

 public:
  explicit ReportPictures(QWidget* parent = nullptr);

  /// Null pictures where there are none.
  void setPictures(const QString& state, const QImage& reference, const QImage& test);
  void clear();

 private:
  PictureView* add(std::size_t index, const char* name);

  std::array<QLabel*, 3> m_captions{};
  PictureView* m_reference;
  PictureView* m_test;
  PictureView* m_difference;
};

}  // namespace hogelscope
