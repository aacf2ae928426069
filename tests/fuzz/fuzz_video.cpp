// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes videos, whose libraries read them in a process of their own: frames in order, then back.
#include "io/images/image_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  constexpr double most = 1e6;  // pixels; more of them find nothing new
  mayRefuse([&] {
    ImageFile video(fileOf("views.mp4", input));
    require(video.frames() > 0);
    if (double(video.width()) * double(video.height()) > most) return;
    const std::size_t last = video.frames() - 1;
    for (const std::size_t frame : {0, 1, 2, 1, 9, 5}) {
      video.select(std::min(frame, last));
      std::size_t rows = 0;
      video.read(video.type(),
                 [&rows](std::size_t, std::size_t count, const StoredRows&) { rows += count; }, {});
      require(rows == video.height());
    }
  });
}
