// SPDX-License-Identifier: BSD-3-Clause
// The kernel version, detected as by the functions' resolvers.
#include "core/base/multiversioned.h"

namespace hogelscope {

std::string_view kernelVersion() {
#if HOGELSCOPE_IS_MULTIVERSIONED
  if (__builtin_cpu_supports("x86-64-v4")) return "AVX-512";
  if (__builtin_cpu_supports("x86-64-v3")) return "AVX2";
#endif
  return "baseline";
}

}  // namespace hogelscope
