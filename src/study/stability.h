// SPDX-License-Identifier: BSD-3-Clause
// Measures the failures of methods: which inverse of a lens finds the right root, and other
// instabilities; stability.csv.
#pragma once

#include "study/instabilities.h"
#include "study/lens_maps.h"

namespace hogelscope {

struct NamedLens {
  std::string name;
  LensKey key;
};

/// Returns lenses that are difficult to invert: the paper's Table I, and those of docs/formulas.md,
/// Known failures.
std::vector<NamedLens> hardLenses();

struct Stability {
  std::vector<NamedLens> lenses;
  /// The outcomes at 41×41 pixels, for each lens and each of inverseMethods().
  std::vector<std::vector<LensOutcomes>> outcomes;
  std::vector<LensMap> maps;  ///< maps of lensPlanes()
  std::vector<InstabilityRow> instabilities;
};

/// Measures everything; the result does not depend on the number of threads. Throws Cancelled.
Stability measureStability(const std::vector<NamedLens>& lenses, const ParallelRows& parallelRows,
                           const Progress& progress);

/// Returns one table (RFC 4180) with empty cells for missing values. The manual defines x, y and
/// value for each kind.
std::string csv(const Stability& stability);

}  // namespace hogelscope
