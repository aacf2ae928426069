// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the file of a panel error on its way.
#include "io/documents/panel_error_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  mayRefuse([&] { (void)loadPanelError(fileOf("panel", input), "key", {2, 1, 1, 2}); });
}
