// SPDX-License-Identifier: BSD-3-Clause
// --info: what a file is.
#pragma once

#include <string>

namespace hogelscope {

/// For a session, a picture or a folder of views. Throws InputError.
std::string infoText(const std::string& file);

}  // namespace hogelscope
