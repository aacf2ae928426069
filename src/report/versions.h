// SPDX-License-Identifier: BSD-3-Clause
// Versions of the program and of the libraries that affect its results, for reports; the About box
// adds those of the window.
#pragma once

#include <string>
#include <vector>

namespace hogelscope {

struct Version {
  std::string name;
  std::string version;
};

/// Returns the versions, Hogelscope first.
std::vector<Version> versions();

/// Returns a line such as "Hogelscope 0.2.0, OpenCV 4.6.0, …".
std::string versionsLine();

}  // namespace hogelscope
