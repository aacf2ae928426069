// SPDX-License-Identifier: BSD-3-Clause
// A light field's files, of any layout.
#include "io/layouts/light_field_file.h"

#include <stdexcept>

#include "core/base/error.h"
#include "io/files/system_limits.h"

namespace hogelscope {

namespace fs = std::filesystem;

LightField blankLightField(const LightFieldSize& size, StoredType type, const fs::path& file,
                           const std::string& hint) {
  try {
    checkFits(LightField::bytes(size, type), file, hint);
    return {size, type};
  } catch (const std::length_error&) {
    throw InputError(file.string(), "size",
                     "is more than 2^32 directional pixels in memory" + hint);
  }
}

}  // namespace hogelscope
