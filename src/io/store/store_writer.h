// SPDX-License-Identifier: BSD-3-Clause
// Packs a light field of any layout into a store. Streams its files once, in bounded memory, and
// keeps the pages of an earlier, cancelled run.
#pragma once

#include "io/layouts/light_field_file.h"
#include "io/store/store_header.h"

namespace hogelscope {

struct PackPlan {
  StoreHeader header;
  std::size_t rows = 0;          ///< rows of the hogel image in memory at once
  std::size_t memory = 0;        ///< bytes of these rows
  std::uint64_t storeBytes = 0;  ///< approximate size on disk
};

/// Plans the packing of `file`, opened from `params`, with at most `memory` bytes of rows; blocks
/// are less than 8 hogels high if these are too few. `display` is stored. Throws InputError if not
/// even one row of hogels fits.
PackPlan planPack(const LightFieldParams& params, const LightFieldFile& file,
                  const std::optional<DisplayParams>& display, std::size_t memory);

/// Writes `output` through OUTPUT.part, which a later run resumes; 0 `threads` means all. Throws
/// InputError (before the work if the disk has too little space), or Cancelled.
void pack(LightFieldFile& file, const PackPlan& plan, const std::filesystem::path& output,
          int threads, const Progress& progress);

}  // namespace hogelscope
