// SPDX-License-Identifier: BSD-3-Clause
// A column of widgets that scrolls up and down and is never narrower than what is in it, also after
// the size of text has changed.
#pragma once

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>

namespace hogelscope {

class ColumnArea : public QScrollArea {
 public:
  ColumnArea() {
    setWidgetResizable(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  }
  [[nodiscard]] QSize sizeHint() const override {
    return {minimumSizeHint().width(), QScrollArea::sizeHint().height()};
  }
  [[nodiscard]] QSize minimumSizeHint() const override {
    if (widget() == nullptr) return QScrollArea::minimumSizeHint();
    return {widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width(),
            QScrollArea::minimumSizeHint().height()};
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest) updateGeometry();
    return QScrollArea::eventFilter(watched, event);
  }
};

}  // namespace hogelscope
