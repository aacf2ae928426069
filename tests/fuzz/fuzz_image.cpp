// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes images of the formats that light fields come in: EXR, JPEG, PNG, TIFF.
#include "io/images/image_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  constexpr double most = 1e6;  // pixels; more of them find nothing new
  mayRefuse([&] {
    ImageFile image(fileOf("image", input));
    if (double(image.width()) * double(image.height()) > most) return;
    std::size_t rows = 0;
    image.read(image.type(),
               [&rows](std::size_t first, std::size_t count, const StoredRows&) {
                 require(first == rows);
                 rows += count;
               },
               {});
    require(rows == image.height());
  });
}
