// SPDX-License-Identifier: BSD-3-Clause
// The window's words in other forms and languages.
#pragma once

namespace hogelscope {

/// English plural forms ("1 thread", "2 threads") from the program itself; over them the user's own
/// language, where a hogelscope_<language>.qm lies beside the program. Needs a QCoreApplication,
/// which owns what is installed; windows that are there already keep their words.
void installTranslations();

}  // namespace hogelscope
