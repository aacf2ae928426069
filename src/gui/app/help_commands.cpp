// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/help_commands.h"

#include <QAction>

#include "gui/app/manual_window.h"
#include "gui/widgets/message_boxes.h"
#include "ui_main_window.h"

namespace hogelscope {

HelpCommands::HelpCommands(const Ui::MainWindow& ui, QWidget* window)
    : QObject(window), m_window(window) {
  connect(ui.manualAction, &QAction::triggered, this, &HelpCommands::showManual);
  connect(ui.aboutAction, &QAction::triggered, this, [this] { showAbout(m_window); });
}

void HelpCommands::showManual() {
  if (m_manual == nullptr) m_manual = new ManualWindow(m_window);
  m_manual->show();
  m_manual->raise();
  m_manual->activateWindow();
}

}  // namespace hogelscope
