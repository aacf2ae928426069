// SPDX-License-Identifier: BSD-3-Clause
// Layout "hogels": one image of hogel tiles, (i·du + u, j·dv + v).
#pragma once

#include <memory>

#include "core/panel/display.h"
#include "io/layouts/light_field_file.h"

namespace hogelscope {

/// Opens it. Throws InputError that names the file: missing, damaged, or not the display's size.
std::unique_ptr<LightFieldFile> openHogelImage(const LightFieldParams& params,
                                               const DisplayParams& display);

}  // namespace hogelscope
