// SPDX-License-Identifier: BSD-3-Clause
// The program's version; only this file is compiled with it.
#include "core/base/version.h"

namespace hogelscope {

const char* programVersion() {
  return HOGELSCOPE_VERSION;
}

}  // namespace hogelscope
