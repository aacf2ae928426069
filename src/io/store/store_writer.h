// SPDX-License-Identifier: BSD-3-Clause
// Packs a light field of any layout into a store: one pass over its files, in bounded memory; pages
// that an earlier, cancelled run has finished are kept.
#pragma once

#include "io/layouts/light_field_file.h"
#include "io/store/store_header.h"

namespace hogelscope {

struct PackPlan {
  StoreHeader header;
  std::size_t rows = 0;          ///< rows of the hogel image in memory at once
  std::size_t memory = 0;        ///< bytes that they take
  std::uint64_t storeBytes = 0;  ///< on the disk, about
};

/// Plans how `file`, opened from `params`, is packed with at most `memory` bytes of rows: with
/// blocks less than 8 hogels high if these are not enough. `display` is kept in the store. Throws
/// InputError if not even one row of hogels fits.
PackPlan planPack(const LightFieldParams& params, const LightFieldFile& file,
                  const std::optional<DisplayParams>& display, std::size_t memory);

/// Writes `output` through OUTPUT.part, which a later run resumes; 0 `threads` means all. Throws
/// InputError (before the work if the disk has no room), or Cancelled.
void pack(LightFieldFile& file, const PackPlan& plan, const std::filesystem::path& output,
          int threads, const Progress& progress);

}  // namespace hogelscope
