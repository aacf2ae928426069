// SPDX-License-Identifier: BSD-3-Clause
// Spearman's rank correlation.
#pragma once

#include <vector>

namespace hogelscope {

/// Returns the rank of each value, 1 for the least; equal values share the mean of their ranks.
/// No value may be NaN.
std::vector<double> ranksOf(const std::vector<double>& values);

/// Returns Spearman's ρ, Pearson's correlation of the ranks, over the pairs without NaN. NaN for
/// fewer than two pairs, or if all values of one list are equal. Throws std::invalid_argument if
/// the sizes differ.
double rankCorrelation(const std::vector<double>& a, const std::vector<double>& b);

}  // namespace hogelscope
