// SPDX-License-Identifier: BSD-3-Clause
// Finds the lenslets in a picture of even light (docs/formulas.md, Lenslets).
#pragma once

#include <optional>
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

/// Returns a first guess at the step of a row from the peaks of the spectrum of the picture's
/// middle, good to some hundredths of a pixel; a pitch or rotation that is given restricts where
/// they are looked for. None if there are none.
std::optional<PicturePoint> stepFromSpectrum(const LensletPlane& picture,
                                             const LensletParams& params);

}  // namespace hogelscope
