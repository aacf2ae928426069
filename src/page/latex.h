// SPDX-License-Identifier: BSD-3-Clause
// Tables of the report's page for a paper.
#pragma once

#include <string>
#include <vector>

namespace hogelscope {

/// A folded part of the page with the table as LaTeX's tabular, to be copied: texts to the left,
/// columns whose cells begin with a digit or a sign to the right. It needs no package.
std::string latexTable(const std::vector<std::string>& heads,
                       const std::vector<std::vector<std::string>>& rows);

}  // namespace hogelscope
