// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the rows of PNGs of every kind.
#include "tests/fuzz/rows.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  mayRefuse([&] {
    if (const auto png = openPng(fileOf("p.png", input))) readAll(*png);
  });
}
