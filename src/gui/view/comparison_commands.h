// SPDX-License-Identifier: BSD-3-Clause
// Commands for comparing two images: the Picture menu, the bar above the image, the metrics, the
// histogram.
#pragma once

#include <QObject>

#include "gui/view/image_widget.h"

class QActionGroup;
class QHBoxLayout;
class QLabel;
class QMenu;
class QVBoxLayout;

namespace hogelscope {

class ComparisonMeter;
class HistogramWidget;

class ComparisonCommands : public QObject {
  Q_OBJECT

 public:
  /// Puts the bar above `view` and the histogram below it, into the layout `around` it.
  ComparisonCommands(QMenu* menu, ImageWidget* view, QVBoxLayout* around, QObject* parent);

  /// Adds a button for another command to the end of the bar.
  void addToBar(QAction* action);
  /// Shows both pictures with a line between them.
  void wipe();
  /// Sets whether there is an image to compare with.
  void setComparing(bool isComparing);
  /// Measures the current images.
  void measure();

 private:
  void addModes();
  void addErrorMaps();
  void addTone();
  void addHistogram(QVBoxLayout* around);
  void addBar(QVBoxLayout* around);
  void showErrorMap();
  void showTone();

  QMenu* m_menu;
  ImageWidget* m_view;
  QActionGroup* m_modes;
  QActionGroup* m_kinds;
  QMenu* m_errorMenu = nullptr;
  QAction *m_wipe = nullptr, *m_difference = nullptr;
  QAction* m_falseColour = nullptr;
  QAction* m_showHistogram = nullptr;
  QWidget* m_bar = nullptr;
  QHBoxLayout* m_buttons;  ///< in it
  QLabel* m_figures;
  QLabel* m_gain;
  HistogramWidget* m_histogram;
  ComparisonMeter* m_meter;
};

}  // namespace hogelscope
