// SPDX-License-Identifier: BSD-3-Clause
// XXH3 by libxxhash.
#include "io/files/content_hash.h"

#include <xxhash.h>

#include <array>
#include <cstdio>
#include <new>

namespace hogelscope {

void ContentHash::Free::operator()(XXH3_state_s* state) const {
  XXH3_freeState(state);
}

ContentHash::ContentHash() : m_state(XXH3_createState()) {
  if (!m_state) throw std::bad_alloc();
  XXH3_128bits_reset(m_state.get());
}

void ContentHash::add(std::span<const std::byte> bytes) {
  XXH3_128bits_update(m_state.get(), bytes.data(), bytes.size());
}

std::string ContentHash::hex() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(m_state.get());
  std::array<char, 33> text{};
  std::snprintf(text.data(), text.size(), "%016llx%016llx",
                static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return text.data();
}

}  // namespace hogelscope
