// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes the files in which captures describe their cameras: parameters.cfg and config.cfg. The
// input's first line is the name of the first view.
#include "io/opening/capture_geometry.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  const std::size_t end = std::min(input.find('\n'), input.size());
  ViewFiles views;
  views.rows = 1;
  views.columns = 2;
  views.files = {folder() / input.substr(0, end), folder() / "view_0_5_30_36.png"};
  for (const char* name : {"parameters.cfg", "config.cfg"}) {
    const auto file = fileOf(name, input.substr(end));
    mayRefuse([&] {
      const auto geometry = captureGeometry(folder(), views, 64, 48);
      if (!geometry) return;
      (void)geometry->fovOf(2, 1);
    });
    std::filesystem::remove(file);
  }
}
