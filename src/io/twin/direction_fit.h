// SPDX-License-Identifier: BSD-3-Clause
// Completes tables of directions by polynomials (docs/formulas.md, Twin).
#pragma once

#include <cstddef>

#include "io/twin/measured_directions.h"

namespace hogelscope {

struct DirectionFit {
  std::size_t given = 0;
  std::size_t fitted = 0;
  int degree = 0;    ///< 1 … 3; 0 if nothing was fitted
  double error = 0;  ///< root of the mean squared distance of given slopes from the polynomial
};

/// Sets the values of the directions that are not given to a polynomial of u and v: cubic, or of
/// the highest degree that the given ones determine, which it fits best (least squares). Light is
/// at least 0. Throws InputError if they do not determine a plane.
DirectionFit fitDirections(MeasuredDirections& table);

}  // namespace hogelscope
