// SPDX-License-Identifier: BSD-3-Clause
// A line of text that is cut where there is no room for it.
#pragma once

#include <QLabel>
#include <QPainter>

namespace hogelscope {

class ElidedLabel : public QLabel {
 public:
  using QLabel::QLabel;
  [[nodiscard]] QSize sizeHint() const override {
    constexpr int longest = 64;  // characters
    return QLabel::sizeHint().boundedTo(
        {longest * fontMetrics().averageCharWidth(), QLabel::sizeHint().height()});
  }
  [[nodiscard]] QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter(this).drawText(contentsRect(), Qt::AlignVCenter,
                            fontMetrics().elidedText(text(), Qt::ElideRight, width()));
  }
};

}  // namespace hogelscope
