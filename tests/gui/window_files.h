// SPDX-License-Identifier: BSD-3-Clause
// The main window's files, without dialogs.
#pragma once

#include "gui/app/main_window.h"
#include "gui/files/file_commands.h"

inline hogelscope::FileCommands& files(const hogelscope::MainWindow& window) {
  return *window.findChild<hogelscope::FileCommands*>();
}
