// SPDX-License-Identifier: BSD-3-Clause
// Rates how well a typed word fits an entry of a list, for searching.
#pragma once

#include <string_view>

namespace hogelscope {

/// Returns how well a word fits a title with a path, such as that of its menu; 0: not at all. The
/// beginning of the title is better than that of any of its words, then come those of the path,
/// then parts of the title, and letters in their order. The texts are compared as they are: callers
/// for whom upper and lower case are the same pass lower case.
int wordFit(std::string_view word, std::string_view title, std::string_view path);

}  // namespace hogelscope
