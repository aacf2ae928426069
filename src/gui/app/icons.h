// SPDX-License-Identifier: BSD-3-Clause
// The icons of the window and its commands.
#pragma once

namespace Ui {
class MainWindow;
}

namespace hogelscope {

/// Sets the icons of the tool bar's actions and of the application.
void addIcons(const Ui::MainWindow& ui);

}  // namespace hogelscope
