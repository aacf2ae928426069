// SPDX-License-Identifier: BSD-3-Clause
// Style sheet, script and security policy of a page.
#pragma once

namespace hogelscope {

/// CSS for screen and paper.
extern const char* const pageStyle;

/// JavaScript that sorts tables; the page is complete without it. Contains no < or &, so that the
/// page is XML.
extern const char* const pageScript;

/// Content-Security-Policy: allows this style and this script, by their hashes, and embedded
/// images. Names in a page cannot run as code.
extern const char* const pagePolicy;

}  // namespace hogelscope
