// SPDX-License-Identifier: BSD-3-Clause
// Reads pictures row by row.
#pragma once

#include "io/images/image_inputs.h"
#include "tests/fuzz/fuzz.h"

/// Unless it is so large that nothing new is found in it.
inline void readAll(hogelscope::ImageInput& image) {
  constexpr std::size_t most = 4096;  // a side
  const auto& facts = image.facts();
  if (facts.width > most || facts.height > most) return;
  hogelscope::withStoredType(facts.type, [&]<class T>(T) {
    std::vector<T> row(3 * facts.width);
    for (std::size_t y = 0; y < facts.height; ++y) image.read(0, y, 1, row.data());
  });
}
