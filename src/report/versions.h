// SPDX-License-Identifier: BSD-3-Clause
// The program's version and those of its libraries: the one list, for the report and for About.
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

/// "Hogelscope 0.1.0, Qt 6.4.2, …".
std::string versionsLine();

}  // namespace hogelscope
