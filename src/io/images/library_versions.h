// SPDX-License-Identifier: BSD-3-Clause
// Versions of the libraries used by `io`, for the About box and the report.
#pragma once

#include <string>

namespace hogelscope {

/// Returns the version of the loaded library, not of its headers, such as "4.6.0".
std::string openCvVersion();
/// Returns the version of the headers, because querying the library would load it. The first two
/// numbers are the same.
std::string openImageIoVersion();

}  // namespace hogelscope
