// SPDX-License-Identifier: BSD-3-Clause
// Tells contents apart that nobody has made to be alike: XXH3, 128 bits, some 50 times as fast as
// SHA-256 on machines without instructions for that.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

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

}  // namespace hogelscope
