// SPDX-License-Identifier: BSD-3-Clause
// Common elements of the report's page; its style sheet, script and security policy.
#pragma once

#include <string>
#include "core/base/text.h"

namespace hogelscope {

/// Escapes a text for HTML or SVG; its lines are made printable(), because XML does not allow all
/// characters.
std::string escaped(const std::string& text);

/// Encodes bytes in base64 (RFC 4648), padded.
std::string base64(const std::string& bytes);

/// Returns an embedded image of a PNG file's bytes; `text` is its alternative text.
std::string imageTag(const std::string& png, const std::string& text);

/// Returns a folded part of the page with LaTeX, for copying.
std::string latexPart(const std::string& tex);

/// Returns a complete page of this title (not escaped yet) and body, with style, script and policy.
std::string pageOf(const std::string& title, const std::string& body);

/// Returns an SVG element as a file of its own, with the style of plots, `width` millimetres wide
/// and as high as its viewBox asks.
std::string svgFile(const std::string& svg, double width);

/// CSS of plots; it is a part of the next one.
extern const char* const plotStyle;
/// CSS for screen and paper.
extern const char* const pageStyle;

/// JavaScript that sorts tables; the page is complete without it. Contains no < or &, so that the
/// page is XML.
extern const char* const pageScript;

/// Content-Security-Policy: allows this style and this script, by their hashes, and embedded
/// images. Names in a page cannot run as code.
extern const char* const pagePolicy;

}  // namespace hogelscope
