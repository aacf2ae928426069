// SPDX-License-Identifier: BSD-3-Clause
// Common elements of the report's page.
#pragma once

#include <string>

namespace hogelscope {

/// Escapes a text for HTML or SVG; its lines are made printable(), because XML does not allow all
/// characters.
std::string escaped(const std::string& text);

/// Encodes bytes in base64 (RFC 4648), padded.
std::string base64(const std::string& bytes);

/// Returns an embedded image of a PNG file's bytes; `text` is its alternative text.
std::string imageTag(const std::string& png, const std::string& text);

}  // namespace hogelscope
