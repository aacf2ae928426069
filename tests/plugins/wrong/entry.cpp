// SPDX-License-Identifier: BSD-3-Clause
// A plugin whose symbol has the numbers and the name of the compiler's options.
#include <hogelscope/plugin.h>

extern "C" __attribute__((visibility("default"))) const hogelscope::plugin::Entry hogelscope_plugin{
    ABI, BUILD, NAME, "1.0", nullptr, nullptr, nullptr};
