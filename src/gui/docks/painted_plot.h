// SPDX-License-Identifier: BSD-3-Clause
// A plot that a function paints, with a title and "Save plot…".
#pragma once

#include <QPainter>
#include <QWidget>
#include <functional>

#include "gui/docks/chart_colours.h"
#include "gui/docks/plot_saver.h"

namespace hogelscope {

class PaintedPlot : public QWidget {
 public:
  /// Paints in the window's colours, or for print.
  using ColouredPaint =
      std::function<void(QPainter& painter, const QSizeF& size, const ChartColours& colours)>;

  PaintedPlot(const char* name, const QString& title, const QString& help, ColouredPaint paint)
      : m_title(title), m_paint(std::move(paint)) {
    setObjectName(name);
    setToolTip(help);
    setAccessibleName(title);
    setMinimumSize(scaled(220), scaled(120));
    new PlotSaver(this, title, {720, 420}, [this](QPainter& painter, const QSizeF& size) {
      m_paint(painter, size, printColours());
    });
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(chartFont());
    painter.fillRect(rect(), chartColours().background);
    painter.setPen(chartColours().text);
    const double line = 1.6 * painter.fontMetrics().height();
    painter.drawText(QRectF(scaled(8), 0, width(), line), Qt::AlignVCenter, m_title);
    painter.translate(0, line);
    m_paint(painter, QSizeF(width(), height() - line), chartColours());
  }

 private:
  QString m_title;
  ColouredPaint m_paint;
};

}  // namespace hogelscope
