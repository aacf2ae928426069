// SPDX-License-Identifier: BSD-3-Clause
// Reads YAML as cv::FileStorage and others write it, from untrusted files.
#pragma once

#include <string>
#include <vector>

#include "io/json/json_parameters.h"

namespace hogelscope {

/// Returns the names and values of all documents in the file, as one object. A plain scalar that is
/// a finite number becomes a number, every other scalar a text (also .Inf and .Nan); tags are
/// ignored. Throws InputError that names the line: not YAML, an alias, a duplicate name, nesting
/// deeper than in any calibration.
Json parseOpenCvYaml(const std::string& text);

/// Returns the names and values of each document of standard YAML, as ROS and Kalibr write it.
/// Scalars and errors are as above.
std::vector<Json> parseYaml(const std::string& text);

}  // namespace hogelscope
