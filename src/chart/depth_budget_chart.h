// SPDX-License-Identifier: BSD-3-Clause
// The chart of --depth: the content's depths, even in dioptres, over the limits of display and
// comfort, and the view with what lies outside them tinted; now, and as proposed.
#pragma once

#include <QImage>
#include <QPainter>
#include <QSize>

#include "chart/painting.h"
#include "measure/depth_budget_run.h"

namespace hogelscope {

/// The depths of one state, for a histogram.
struct DepthHistogram {
  const DepthFigures& figures;
  DepthBars bars;  ///< symmetric about the panel
};

/// Paints bars, limits and the axis of depths, in the painter's font: dark within both limits, blue
/// behind them, red in front of them. Bars that tower over the others are cut, with a note.
void paintDepths(QPainter& painter, const QRectF& area, const DepthHistogram& depths,
                 const ChartColours& colours);

/// Returns the picture, half grey, with what lies behind both limits tinted blue and what lies in
/// front of them red.
QImage tintedByDepth(const Image& picture, const PixelDepths& depths, const DepthLimits& limits);

/// Returns the tint alone of a picture of `size`, transparent where content is within both limits.
QImage depthTint(const QSize& size, const PixelDepths& depths, const DepthLimits& limits);

/// The chart of the first state.
class DepthBudgetChart {
 public:
  /// Both must outlive the chart.
  DepthBudgetChart(const DepthBudget& budget, const Session& session)
      : m_budget(budget), m_session(session) {}

  [[nodiscard]] QSize size() const;
  void paint(QPainter& painter, const QSizeF& size) const;

 private:
  void paintRow(QPainter& painter, const QRectF& area, const QString& heading,
                const StatesDepths& depths) const;
  [[nodiscard]] double end() const;

  const DepthBudget& m_budget;
  const Session& m_session;
};

}  // namespace hogelscope
