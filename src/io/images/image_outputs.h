// SPDX-License-Identifier: BSD-3-Clause
// Output row by row of PNG through libspng, which also reads PNGs, and of EXR of floats through
// OpenEXR itself, which brings five libraries instead of OpenImageIO's 230; every report ends with
// images of floats.
#pragma once

#include <functional>
#include <memory>

#include "io/images/codecs.h"

namespace hogelscope {

/// `small` makes small files; `quick`, for large ones, needs a quarter of the time without filters.
enum class PngEffort { small, quick };
/// Receives the bytes of the file in order.
using PngSink = std::function<void(const void* bytes, std::size_t size)>;

/// Creates an image; `name` is for errors. Throws InputError for floats and for too large sizes.
std::unique_ptr<ImageOutput> pngOutput(std::string name, const ImageSpec& spec, PngEffort effort,
                                       PngSink sink);

/// Creates an image of StoredType::real only. `name` is for errors; `bytes` must outlive the
/// output. Throws InputError.
std::unique_ptr<ImageOutput> exrOutput(std::string name, const ImageSpec& spec, ByteOutput& bytes);

}  // namespace hogelscope
