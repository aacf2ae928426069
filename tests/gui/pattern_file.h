// SPDX-License-Identifier: BSD-3-Clause
// An image file of a light field with a closed form.
#pragma once

#include <vector>

#include "core/content/pattern_list.h"
#include "io/images/image_writer.h"

/// Writes all hogels of a display as one image, as `--generate` does.
inline void writePattern(const std::string& pattern, const hogelscope::DisplayParams& display,
                         const std::string& file) {
  const auto made = hogelscope::makePattern(pattern, {display}, {});
  const int width = display.hogels[0] * display.directions[0];
  const int height = display.hogels[1] * display.directions[1];
  hogelscope::ImageRowWriter writer(file, width, height);
  std::vector<std::uint8_t> row(3 * std::size_t(width));
  for (int y = 0; y < height; ++y) {
    made->row(y, row.data());
    writer.write(row.data());
  }
  writer.finish();
}
