// SPDX-License-Identifier: BSD-3-Clause
// A plot that a function paints, with a title and "Save plot…"; the mouse may read it.
#pragma once

#include <QMouseEvent>
#include <QPainter>
#include <QWidget>
#include <functional>
#include <optional>

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

  /// Is told where the mouse is below the title, none once it has left, and of clicks there; `size`
  /// is that of what is painted.
  struct Mouse {
    std::function<void(std::optional<QPointF> place, const QSizeF& size)> moved;
    std::function<void(const QPointF& place, const QSizeF& size)> clicked;
  };
  void setMouse(Mouse mouse) {
    m_mouse = std::move(mouse);
    setMouseTracking(true);
  }

 protected:
  void mouseMoveEvent(QMouseEvent* event) override {
    if (m_mouse.moved) m_mouse.moved(event->position() - QPointF(0, titleHeight()), plotSize());
  }
  void leaveEvent(QEvent*) override {
    if (m_mouse.moved) m_mouse.moved(std::nullopt, plotSize());
  }
  void mousePressEvent(QMouseEvent* event) override {
    if (!m_mouse.clicked || event->button() != Qt::LeftButton) return event->ignore();
    m_mouse.clicked(event->position() - QPointF(0, titleHeight()), plotSize());
  }
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(chartFont());
    painter.fillRect(rect(), chartColours().background);
    painter.setPen(chartColours().text);
    const double line = titleHeight();
    painter.drawText(QRectF(scaled(8), 0, width(), line), Qt::AlignVCenter, m_title);
    painter.translate(0, line);
    m_paint(painter, plotSize(), chartColours());
  }

 private:
  [[nodiscard]] static double titleHeight() { return 1.6 * QFontMetrics(chartFont()).height(); }
  [[nodiscard]] QSizeF plotSize() const { return {double(width()), height() - titleHeight()}; }

  QString m_title;
  ColouredPaint m_paint;
  Mouse m_mouse;
};

}  // namespace hogelscope
