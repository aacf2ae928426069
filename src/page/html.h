// SPDX-License-Identifier: BSD-3-Clause
// The few things that every part of the report's page writes.
#pragma once

#include <string>

namespace hogelscope {

/// A text in HTML or SVG; its lines are printable(), since XML does not allow all characters.
std::string escaped(const std::string& text);

/// The alphabet of RFC 4648, padded.
std::string base64(const std::string& bytes);

/// An image within the page, from a PNG file's bytes; `text` is what stands for it where it cannot
/// be seen.
std::string imageTag(const std::string& png, const std::string& text);

}  // namespace hogelscope
