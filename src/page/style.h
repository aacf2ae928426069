// SPDX-License-Identifier: BSD-3-Clause
// Style sheet, script and security policy of a page.
#pragma once

namespace hogelscope {

/// CSS for screen and paper.
extern const char* const pageStyle;

/// JavaScript that sorts tables; the page is complete without it. Free of < and &, so that the page
/// is XML.
extern const char* const pageScript;

/// Content-Security-Policy: this style and this script, by their hashes, and images within the
/// page. Nothing that a name in a page contains can run.
extern const char* const pagePolicy;

}  // namespace hogelscope
