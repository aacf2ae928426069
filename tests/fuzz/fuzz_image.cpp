// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes images of the formats that light fields come in: EXR, JPEG, PNG, TIFF, also those that are
// turned, have windows, layers, pages or further pictures.
#include "io/images/image_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  constexpr double most = 1e6;  // pixels; more of them find nothing new
  mayRefuse([&] {
    // Other TIFFs than those of that name may be cameras' raw files.
    const bool isTiff = input.starts_with("II") || input.starts_with("MM");
    ImageFile image(fileOf(isTiff ? "image.tif" : "image", input));
    if (double(image.width()) * double(image.height()) > most) return;
    std::size_t rows = 0;
    image.read(image.type(),
               [&rows](std::size_t first, std::size_t count, const StoredRows&) {
                 require(first == rows);
                 rows += count;
               },
               {});
    require(rows == image.height());
    if (image.frames() == 1) return;
    image.select(image.frames() - 1);
    image.readRows([](std::size_t, const float*) {}, {});
  });
}
