// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the rows of PNGs of every kind.
#include "io/images/png_rows.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  constexpr std::size_t most = 4096;  // a side; larger ones find nothing new
  mayRefuse([&] {
    PngRows png(fileOf("p.png", input));
    if (png.width() > most || png.height() > most) return;
    for (std::size_t y = 0; y < png.height(); ++y)
      require((png.type() == StoredType::uint8 ? png.next8().size() : png.next16().size()) ==
              3 * png.width());
  });
}
