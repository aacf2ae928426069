// SPDX-License-Identifier: BSD-3-Clause
// The entry point of the library that the program loads.
#include "io/images/codecs.h"

extern "C" const hogelscope::Codecs* hogelscopeCodecs() {
  return &hogelscope::codecs();
}
