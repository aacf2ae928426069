// SPDX-License-Identifier: BSD-3-Clause
// Finds the lenslets in a picture of even light (docs/formulas.md, Lenslets).
#pragma once

#include <vector>

#include "capture/lenslets/lenslet_lattice.h"
#include "core/base/progress.h"

namespace hogelscope {

/// A grey picture, in rows from the top.
struct LensletPlane {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

struct FoundLenslets {
  LensletLattice lattice;
  int count = 0;        ///< lenslets that it was fitted to; 0: all was given
  double residual = 0;  ///< rms distance of their middles from the lattice, pixels
};

/// Finds what the parameters do not give. Throws InputError, which names no file: there is no
/// regular grid of lenslets in it. Throws Cancelled.
FoundLenslets findLenslets(const LensletPlane& picture, const LensletParams& params,
                           const Progress& progress = {});

}  // namespace hogelscope
