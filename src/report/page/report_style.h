// SPDX-License-Identifier: BSD-3-Clause
// How the report's page looks on screen and on paper, the script that sorts its tables, and that
// nothing else may run.
#pragma once

namespace hogelscope {

/// CSS. Nothing of it lies elsewhere.
extern const char* const reportStyle;

/// JavaScript; without it the page is as complete. Free of < and &, so that the page is XML too.
extern const char* const reportScript;

/// Content-Security-Policy: this style and this script, by their hashes, and images that are in
/// the page; whatever a name in a report should smuggle in does nothing.
extern const char* const reportPolicy;

}  // namespace hogelscope
