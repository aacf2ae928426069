// SPDX-License-Identifier: BSD-3-Clause
// Starts the desktop app.
#pragma once

#include <string>
#include <vector>

namespace hogelscope {

/// Installs the built-in English plural forms ("1 thread", "2 threads") and, with precedence, the
/// translation into the user's language if hogelscope_<language>.qm lies beside the program. Needs
/// a QCoreApplication, which owns the translators; existing windows keep their texts.
void installTranslations();

/// Opens the window and `files` in it (FileCommands::openFiles). Returns the exit status.
int runWindow(int argc, char** argv, const std::vector<std::string>& files);

}  // namespace hogelscope
