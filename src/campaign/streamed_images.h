// SPDX-License-Identifier: BSD-3-Clause
// The images of many states from a light field that memory cannot hold and that can only be read
// from the top: read once, as long as what the states need of it fits in memory.
#pragma once

#include <string>
#include <vector>

#include "core/engine/fast_simulation.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// A state's image, or why there is none.
struct StateImage {
  Image image;
  std::string problem;
};

/// Whether the file exceeds `memory` bytes and can be streamed.
bool mustStream(const LightFieldFile& file, std::size_t memory);

/// The views' light field has nothing in memory. At most `memory` bytes are taken besides the
/// images and one hogel row of the file; where that is too little for all views the file is read
/// more than once, and a view that alone needs more has a problem. Throws InputError (damaged
/// file, images that the machine's memory cannot hold), Cancelled.
std::vector<StateImage> renderStreamed(LightFieldFile& file, const std::vector<RenderJob>& views,
                                       std::size_t memory, const ParallelRows& parallelRows,
                                       const Progress& progress);

}  // namespace hogelscope
