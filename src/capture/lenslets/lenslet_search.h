// SPDX-License-Identifier: BSD-3-Clause
// Finds the lenslets in an image (docs/formulas.md, Lenslets), best in one of even light. The
// search is a pure function of a grey image. It runs whenever the image is opened, so there is no
// document of a calibration; figures that a session gives are used as they are.
#pragma once

#include <optional>
#include <vector>

#include "capture/lenslets/lenslet_lattice.h"
#include "core/base/progress.h"

namespace hogelscope {

/// A grey image, in rows from the top.
struct LensletPlane {
  int width = 0;
  int height = 0;
  std::vector<float> values;
};

struct FoundLenslets {
  LensletLattice lattice;
  int count = 0;        ///< lenslets in the fit; 0 if all figures were given
  double residual = 0;  ///< rms distance of their middles from the lattice, pixels
};

/// Finds the figures that the parameters do not give. Throws InputError without a file name if the
/// image has no regular grid of lenslets; Cancelled.
FoundLenslets findLenslets(const LensletPlane& picture, const LensletParams& params,
                           const Progress& progress = {});

/// Recognises an image taken through lenslets: many bright spots on a regular lattice, square or
/// hexagonal and turned by less than 10°, with less light between them. None for other images;
/// those of dots on such a lattice are mistaken. Throws Cancelled.
std::optional<FoundLenslets> recognisedLenslets(const LensletPlane& picture,
                                                const Progress& progress = {});

/// Returns a first estimate of the step of a row from the peaks of the spectrum of the image's
/// middle, accurate to some hundredths of a pixel. A given pitch or rotation restricts the search.
/// None if there are no such peaks.
std::optional<PicturePoint> stepFromSpectrum(const LensletPlane& picture,
                                             const LensletParams& params);

}  // namespace hogelscope
