// SPDX-License-Identifier: BSD-3-Clause
// The translations of the window's texts.
#pragma once

namespace hogelscope {

/// Installs the built-in English plural forms ("1 thread", "2 threads") and, with precedence, the
/// translation into the user's language if hogelscope_<language>.qm lies beside the program. Needs
/// a QCoreApplication, which owns the translators; existing windows keep their texts.
void installTranslations();

}  // namespace hogelscope
