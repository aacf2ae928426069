// SPDX-License-Identifier: BSD-3-Clause
// Which versions of the libraries behind `io` are at work, for About and the report.
#pragma once

#include <string>

namespace hogelscope {

/// As "4.6.0": of the libraries that are loaded, not of the headers.
std::string openCvVersion();
std::string openImageIoVersion();

}  // namespace hogelscope
