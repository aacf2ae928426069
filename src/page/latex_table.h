// SPDX-License-Identifier: BSD-3-Clause
// Tables for papers, as LaTeX.
#pragma once

#include <string>

#include "core/base/text.h"

namespace hogelscope {

/// The width of a column of a paper in two columns (IEEEtran), points of TeX.
constexpr double texColumn = 252;

/// Returns a table, whose first row is its heads, as LaTeX's tabular of at most `width` points of
/// TeX: text columns left-aligned, columns whose cells begin with a digit or a sign right-aligned,
/// in \footnotesize. It needs no package. What would be too wide has, as far as needed, heads in
/// several lines, ranges such as "(0.1 … 0.2)" below their values, names in several lines, long
/// words of them without their middle, and tabulars one below the other, which all begin with the
/// columns of names. Widths are those of Computer Modern of 8 points, whose letters are wider than
/// those of Times.
std::string latexTable(const Table& table, double width = texColumn);

}  // namespace hogelscope
