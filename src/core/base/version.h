// SPDX-License-Identifier: BSD-3-Clause
// The program's version.
#pragma once

namespace hogelscope {

/// "0.2.0": the project's version in CMakeLists.txt.
const char* programVersion();

}  // namespace hogelscope
