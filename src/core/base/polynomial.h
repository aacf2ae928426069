// SPDX-License-Identifier: BSD-3-Clause
// Finds where a polynomial of one number changes its sign.
#pragma once

#include <vector>

namespace hogelscope {

/// Returns the places in (0, end) where the polynomial of these coefficients, the constant one
/// first, changes its sign, in order and as exact as rounding of its values allows.
std::vector<double> signChanges(const std::vector<double>& polynomial, double end);

}  // namespace hogelscope
