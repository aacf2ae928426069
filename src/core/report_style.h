// SPDX-License-Identifier: BSD-3-Clause
// How the report's page looks on screen and on paper, and the script that sorts its tables.
#pragma once

namespace hogelscope {

/// CSS. Nothing of it lies elsewhere.
extern const char* const reportStyle;

/// JavaScript; without it the page is as complete. Free of < and &, so that the page is XML too.
extern const char* const reportScript;

}  // namespace hogelscope
