// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the search for lenslets: the input is a picture.
#include "io/images/image_file.h"
#include "io/layouts/layouts.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  constexpr double most = 1e5;  // pixels; more of them find nothing new
  LightFieldParams params;
  params.layout = Layout::lenslets;
  params.file = fileOf("lenslets.png", input).string();
  mayRefuse([&] {
    const ImageFile image{std::filesystem::path(params.file)};
    if (double(image.width()) * double(image.height()) > most) return;
    const LightFieldSize size = lensletsLayout.open(params, {}, {})->size();
    require(size.nx > 0 && size.ny > 0 && size.du > 0 && size.dv > 0);
  });
}
