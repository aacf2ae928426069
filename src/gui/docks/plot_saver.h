// SPDX-License-Identifier: BSD-3-Clause
// Export of a plot of the window as SVG or PNG.
#pragma once

#include <QAction>
#include <QObject>
#include <QSize>

#include "chart/painting.h"

class QWidget;

namespace hogelscope {

/// Adds "Save plot…" to the plot's context menu.
class PlotSaver : public QObject {
  Q_OBJECT

 public:
  /// Saves with `paint`, which draws the plot on white for print. `title` is the SVG's title and
  /// the proposed file name.
  PlotSaver(QWidget* plot, const QString& title, const QSize& size, Paint paint);

  /// Enables the action while there is a plot to save.
  void setEnabled(bool isEnabled) { m_action->setEnabled(isEnabled); }
  void save(const QString& file);

 Q_SIGNALS:
  void done(const QString& line);
  void failed(const QString& line);

 private:
  void ask();

  QWidget* m_plot;
  QString m_title;
  QSize m_size;
  Paint m_paint;
  QAction* m_action;
};

}  // namespace hogelscope
