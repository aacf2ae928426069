// SPDX-License-Identifier: BSD-3-Clause
// The program's version.
#pragma once

namespace hogelscope {

/// Returns the project's version in CMakeLists.txt, as "1.2.3".
const char* programVersion();

}  // namespace hogelscope
