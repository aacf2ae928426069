// SPDX-License-Identifier: BSD-3-Clause
// Tables of the report's page as LaTeX.
#pragma once

#include <string>
#include <vector>

namespace hogelscope {

/// Returns a folded part of the page with the table as LaTeX's tabular, for copying: text columns
/// left-aligned, columns whose cells begin with a digit or a sign right-aligned. It needs no
/// package.
std::string latexTable(const std::vector<std::string>& heads,
                       const std::vector<std::vector<std::string>>& rows);

}  // namespace hogelscope
