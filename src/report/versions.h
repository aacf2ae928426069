// SPDX-License-Identifier: BSD-3-Clause
// The program's version and those of the libraries that pictures and figures come from, for
// reports; About adds those of the window.
#pragma once

#include <string>
#include <vector>

namespace hogelscope {

struct Version {
  std::string name;
  std::string version;
};

/// Hogelscope first.
std::vector<Version> versions();

/// "Hogelscope 0.1.0, OpenCV 4.6.0, …".
std::string versionsLine();

}  // namespace hogelscope
