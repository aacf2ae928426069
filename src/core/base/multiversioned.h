// SPDX-License-Identifier: BSD-3-Clause
// MULTIVERSIONED before a function makes GCC compile it for AVX-512, AVX2 and the baseline; the
// version is chosen at program start.
#pragma once

#include <string_view>

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && \
    !defined(__SANITIZE_THREAD__) && !defined(HOGELSCOPE_BASELINE)
#define HOGELSCOPE_IS_MULTIVERSIONED 1
#define MULTIVERSIONED __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define HOGELSCOPE_IS_MULTIVERSIONED 0
#define MULTIVERSIONED
#endif

namespace hogelscope {

/// Returns which version runs on this machine, as the functions' resolvers choose it: "AVX-512",
/// "AVX2" or "baseline".
inline std::string_view kernelVersion() {
#if HOGELSCOPE_IS_MULTIVERSIONED
  if (__builtin_cpu_supports("x86-64-v4")) return "AVX-512";
  if (__builtin_cpu_supports("x86-64-v3")) return "AVX2";
#endif
  return "baseline";
}

}  // namespace hogelscope
