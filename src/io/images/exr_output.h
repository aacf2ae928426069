// SPDX-License-Identifier: BSD-3-Clause
// EXR output of floats through OpenEXR itself, which brings five libraries instead of OpenImageIO's
// 230; every report ends with images of floats.
#pragma once

#include "io/images/codecs.h"

namespace hogelscope {

/// Creates an image of StoredType::real only. `name` is for errors; `bytes` must outlive the
/// output. Throws InputError.
std::unique_ptr<ImageOutput> exrOutput(std::string name, const ImageSpec& spec, ByteOutput& bytes);

}  // namespace hogelscope
