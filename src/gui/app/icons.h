// SPDX-License-Identifier: BSD-3-Clause
// The window's icon, and those of its commands.
#pragma once

namespace Ui {
class MainWindow;
}

namespace hogelscope {

/// Gives the actions of the tool bar their pictures, and the program its own.
void addIcons(const Ui::MainWindow& ui);

}  // namespace hogelscope
