// SPDX-License-Identifier: BSD-3-Clause
// The Help menu: the manual and the About box.
#pragma once

#include <QObject>

class QWidget;

namespace Ui {
class MainWindow;
}

namespace hogelscope {

class ManualWindow;

class HelpCommands : public QObject {
  Q_OBJECT

 public:
  HelpCommands(const Ui::MainWindow& ui, QWidget* window);

 private:
  void showManual();

  QWidget* m_window;
  ManualWindow* m_manual = nullptr;  ///< created on first use
};

}  // namespace hogelscope
