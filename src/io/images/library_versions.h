// SPDX-License-Identifier: BSD-3-Clause
// The versions of the libraries that `io` uses, for About and the report.
#pragma once

#include <string>

namespace hogelscope {

/// Returns the version of the loaded library, not of its headers, such as "4.6.0".
std::string openCvVersion();
/// Returns that of the headers: asking the library would load it. It has the same first two
/// numbers.
std::string openImageIoVersion();

}  // namespace hogelscope
