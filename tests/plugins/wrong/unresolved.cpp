// SPDX-License-Identifier: BSD-3-Clause
// A plugin that calls a function that no library has.
#include <hogelscope/plugin.h>

hogelscope::plugin::Metric* functionOfNoLibrary();

HOGELSCOPE_PLUGIN("wrong", "1.0", nullptr, nullptr, functionOfNoLibrary);
