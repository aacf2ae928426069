// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes videos, whose library reads them in a process of its own.
#include "io/images/image_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  constexpr double most = 1e6;  // pixels; more of them find nothing new
  mayRefuse([&] {
    ImageFile video(fileOf("views.mp4", input));
    require(video.frames() > 0);
    if (double(video.width()) * double(video.height()) > most) return;
    for (std::size_t frame = 0; frame < std::min<std::size_t>(video.frames(), 3); ++frame) {
      video.select(frame);
      std::size_t rows = 0;
      video.read(video.type(),
                 [&rows](std::size_t, std::size_t count, const StoredRows&) { rows += count; }, {});
      require(rows == video.height());
    }
  });
}
