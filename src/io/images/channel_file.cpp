// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/channel_file.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "io/files/system_limits.h"
#include "io/images/image_inputs.h"

namespace hogelscope {

ChannelFile::ChannelFile(const std::filesystem::path& file)
    : m_file(file), m_input(openPicture(file)) {}

std::vector<float> ChannelFile::read(std::size_t channel, const Progress& progress) {
  checkFits(double(width() * height() * sizeof(float)), m_file);
  std::vector<float> values;
  values.reserve(width() * height());  // memory that a truncated file does not fill is not taken
  const std::size_t band = m_input->facts().bandRows;
  for (std::size_t row = 0; row < height(); row += band) {
    reportProgress(progress, double(row) / double(height()));
    const std::size_t rows = std::min(band, height() - row);
    values.resize((row + rows) * width());
    m_input->readChannel(channel, row, rows, values.data() + row * width());
  }
  const auto bad = std::ranges::find_if_not(values, [](float v) { return std::isfinite(v); });
  if (bad != values.end())
    throw errorAt(channel, std::size_t(bad - values.begin()),
                  std::isnan(*bad) ? "is not a number" : "is infinite");
  return values;
}

InputError ChannelFile::errorAt(std::size_t channel, std::size_t value,
                                const std::string& why) const {
  return {m_file.string(),
          "channel \"" + names()[channel] + "\", pixel (" + std::to_string(value % width()) + ", " +
              std::to_string(value / width()) + ")",
          why};
}

}  // namespace hogelscope
