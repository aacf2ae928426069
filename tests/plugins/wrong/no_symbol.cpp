// SPDX-License-Identifier: BSD-3-Clause
// A library that is no plugin.
extern "C" int someOtherFunction() {
  return 3;
}
