// SPDX-License-Identifier: BSD-3-Clause
// Reads XML as cv::FileStorage writes it, from untrusted files.
#pragma once

#include <string>

#include "io/json/json_parameters.h"

namespace hogelscope {

/// Returns the names and values in the root of a file that cv::FileStorage wrote. An element with
/// elements in it is an object, or a list if they are called _; one with words is a number, a text,
/// or a list if there are several. Attributes and comments are ignored,
/// and of entities only the characters of XML itself are known: nothing is loaded or expanded.
/// Throws InputError that names the line: not XML, a document type, a name that stands twice,
/// nesting deeper than in any calibration.
Json parseOpenCvXml(const std::string& text);

}  // namespace hogelscope
