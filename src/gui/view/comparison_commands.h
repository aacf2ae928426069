// SPDX-License-Identifier: BSD-3-Clause
// How two pictures are compared: commands of the Picture menu, the bar above the picture, the
// figures, the histogram.
#pragma once

#include <QObject>

#include "gui/view/image_widget.h"

class QActionGroup;
class QBoxLayout;
class QLabel;
class QMenu;

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class ComparisonMeter;
class HistogramWidget;

class ComparisonCommands : public QObject {
  Q_OBJECT

 public:
  ComparisonCommands(const Ui::MainWindow& ui, QObject* parent);

  /// Whether there is something to compare with.
  void setComparing(bool isComparing);
  /// Of the pictures as they are now.
  void measure();

 private:
  void addModes();
  void addErrorMaps();
  void addTone();
  void addHistogram();
  void addBar();
  QAction* add(QMenu* menu, const char* name, const QString& text, const QString& help,
               const QKeySequence& key);
  void showErrorMap();

  const Ui::MainWindow& m_ui;
  ImageWidget* m_view;
  QActionGroup* m_modes;
  QActionGroup* m_kinds;
  QMenu* m_errorMenu;
  QAction* m_falseColour = nullptr;
  QAction* m_showHistogram = nullptr;
  QWidget* m_bar;
  QLabel* m_figures;
  HistogramWidget* m_histogram;
  ComparisonMeter* m_meter;
};

}  // namespace hogelscope
