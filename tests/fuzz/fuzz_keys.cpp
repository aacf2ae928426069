// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes keys.json.
#include "io/documents/key_map_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  mayRefuse([&] { (void)loadKeyTexts(fileOf("keys.json", input)); });
}
