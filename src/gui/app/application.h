// SPDX-License-Identifier: BSD-3-Clause
// Starts the desktop app.
#pragma once

#include <string>
#include <vector>

namespace hogelscope {

/// Opens the window and `files` in it (FileCommands::openFiles). Returns the exit status.
int runWindow(int argc, char** argv, const std::vector<std::string>& files);

}  // namespace hogelscope
