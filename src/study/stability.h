// SPDX-License-Identifier: BSD-3-Clause
// Where methods fail: which inverse of a lens finds the right root, and the other unstable places;
// stability.csv.
#pragma once

#include "study/instabilities.h"
#include "study/lens_maps.h"

namespace hogelscope {

struct NamedLens {
  std::string name;
  LensKey key;
};

/// Lenses that are known to be hard: the paper's Table I, and the others of docs/formulas.md, Known
/// failures.
std::vector<NamedLens> hardLenses();

struct Stability {
  std::vector<NamedLens> lenses;
  /// For each lens those of each of inverseMethods(), over 41×41 of its pixels.
  std::vector<std::vector<LensOutcomes>> outcomes;
  std::vector<LensMap> maps;  ///< of lensPlanes()
  std::vector<InstabilityRow> instabilities;
};

/// The same to the last digit for any number of threads. Throws Cancelled.
Stability measureStability(const std::vector<NamedLens>& lenses, const ParallelRows& parallelRows,
                           const Progress& progress);

/// One table, RFC 4180; what a row does not have is an empty cell. The manual says what x, y and
/// value are for each kind.
std::string csv(const Stability& stability);

}  // namespace hogelscope
