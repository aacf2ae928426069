// SPDX-License-Identifier: BSD-3-Clause
// The images of many states from a light field that exceeds the memory and must be streamed. It is
// read once if the states' slices fit in memory together.
#pragma once

#include <string>
#include <vector>

#include "core/engine/fast_simulation.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// A state's image, or the problem.
struct StateImage {
  Image image;
  std::string problem;
};

/// Whether the file exceeds `memory` bytes and can be streamed.
bool mustStream(const LightFieldFile& file, std::size_t memory);

/// Renders views of a light field that has nothing in memory. Uses at most `memory` bytes besides
/// the images and one hogel row of the file; if that is too little for all views, the file is read
/// several times, and a view that alone needs more has a problem. Throws InputError (damaged file,
/// images exceed the machine's memory), Cancelled.
std::vector<StateImage> renderStreamed(LightFieldFile& file, const std::vector<RenderJob>& views,
                                       std::size_t memory, const ParallelRows& parallelRows,
                                       const Progress& progress);

}  // namespace hogelscope
