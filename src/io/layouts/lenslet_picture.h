// SPDX-License-Identifier: BSD-3-Clause
// Layout "lenslets": a picture taken through an array of lenslets, by a plenoptic camera or a
// light field microscope. Lenslets are hogels, pixels under a lenslet are directions.
#pragma once

#include <memory>
#include <string>

#include "capture/lenslets/lenslet_search.h"
#include "core/optics/display.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// Opens it and finds its lenslets. Throws InputError that names the file: missing, damaged, of
/// another size than the white picture, or there are no lenslets in it.
std::unique_ptr<LightFieldFile> openLenslets(const LightFieldParams& params,
                                             const DisplayParams& display,
                                             const Progress& progress);

/// Finds the lenslets; its lattice begins at hogel (0, 0). Throws what openLenslets() throws.
FoundLenslets lensletsOf(const LightFieldParams& params, const DisplayParams& display,
                         const Progress& progress = {});

/// Returns a line for the user if the lenslets do not lie on the lattice that was found, or its
/// rows hardly run along the picture's; else "".
std::string warningOf(const LightFieldParams& params, const FoundLenslets& found);

}  // namespace hogelscope
