// SPDX-License-Identifier: BSD-3-Clause
// Common parts of all fuzzers: a folder for the files that readers need, and the only exception
// that bad input may cause.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "core/base/error.h"

/// Defined by each fuzzer: reads `input` and stops the program (require) if the outcome is wrong.
void fuzz(std::string_view input);

/// Returns a folder in memory, because ext4 takes 3 ms to rewrite a file. It is removed at the end,
/// unless a finding ends the program.
inline const std::filesystem::path& folder() {
  static const struct Folder {
    std::filesystem::path path = "/dev/shm/hogelscope-fuzz-" + std::to_string(::getpid());
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  } own;
  return own.path;
}

inline std::filesystem::path fileOf(const char* name, std::string_view content) {
  const std::filesystem::path file = folder() / name;
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  if (!out.write(content.data(), std::streamsize(content.size())).flush()) std::abort();
  return file;
}

inline void require(bool isTrue) {
  if (!isTrue) __builtin_trap();
}

/// Allows only InputError with a message of one line without control characters.
template <class Action>
void mayRefuse(const Action& action) {
  try {
    action();
  } catch (const hogelscope::InputError& error) {
    const std::string_view line = error.what();
    require(!line.empty() && std::none_of(line.begin(), line.end(),
                                          [](unsigned char c) { return c < 32 || c == 127; }));
  }
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz({reinterpret_cast<const char*>(data), size});
  return 0;
}
