// SPDX-License-Identifier: BSD-3-Clause
// MULTIVERSIONED before a function makes GCC compile it for AVX-512, AVX2 and the baseline; the
// version is chosen when the program starts.
#pragma once

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_THREAD__)
#define MULTIVERSIONED __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define MULTIVERSIONED
#endif
