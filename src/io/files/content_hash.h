// SPDX-License-Identifier: BSD-3-Clause
// Distinguishes contents, but not intentionally similar ones: XXH3, 128 bits, as fast as reading
// from memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"

struct XXH3_state_s;

namespace hogelscope {

class ContentHash {
 public:
  ContentHash();
  void add(std::span<const std::byte> bytes);
  /// Returns 32 hexadecimal digits, as xxh128sum prints for the bytes so far.
  [[nodiscard]] std::string hex() const;

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };
  std::unique_ptr<XXH3_state_s, Free> m_state;
};

/// Returns the hash of a file or, for several, of the lines "HASH  NAME\n" that xxh128sum prints
/// for them in their folder. Throws InputError, Cancelled.
std::string contentHash(const std::vector<std::filesystem::path>& files,
                        const Progress& progress = {});
std::string contentHash(const std::string& text);

/// Returns a text that changes when a file is written or replaced, even if its size and time are
/// restored: device, inode, times of the last change of its status and content, size. "" if there
/// is no file.
std::string fileIdentity(const std::filesystem::path& file);

}  // namespace hogelscope
