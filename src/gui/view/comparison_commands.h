// SPDX-License-Identifier: BSD-3-Clause
// Commands for comparing two images: the Picture menu, the bar above the image, the metrics, the
// histogram.
#pragma once

#include <QObject>

#include "gui/view/image_widget.h"

class QActionGroup;
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

  /// Sets whether there is an image to compare with.
  void setComparing(bool isComparing);
  /// Measures the current images.
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
