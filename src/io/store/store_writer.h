// SPDX-License-Identifier: BSD-3-Clause
// Packs a light field of any layout into a store: one pass over its files, in bounded memory; what
// an earlier, stopped run has finished is kept.
#pragma once

#include "io/layouts/light_field_file.h"
#include "io/store/store_header.h"

namespace hogelscope {

struct PackPlan {
  StoreHeader header;
  std::size_t rows = 0;          ///< of the hogel image, that are in memory at once
  std::size_t memory = 0;        ///< bytes that they take
  std::uint64_t storeBytes = 0;  ///< on the disk, about
};

/// How `file`, which is opened from `params`, is packed in at most `memory` bytes of rows: less
/// than 8 hogels high blocks where these are not enough. `display` is kept in the store. Throws
/// InputError where not even one row of hogels fits.
PackPlan planPack(const LightFieldParams& params, const LightFieldFile& file,
                  const std::optional<DisplayParams>& display, std::size_t memory);

/// Writes `output`, by way of OUTPUT.part, with which a later run goes on. `threads`: 0 = all.
/// Throws InputError (no room on the disk is told before the work), or Cancelled.
void pack(LightFieldFile& file, const PackPlan& plan, const std::filesystem::path& output,
          int threads, const Progress& progress);

}  // namespace hogelscope
