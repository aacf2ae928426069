// SPDX-License-Identifier: BSD-3-Clause
// Reads picture files whose channels are measured values with names, as writePlanes() writes them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "io/images/codecs.h"

namespace hogelscope {

/// An opened picture of floats. Every error is an InputError that names the file.
class ChannelFile {
 public:
  /// Opens an EXR, or a file of any other format that openPicture() opens, as that does.
  explicit ChannelFile(const std::filesystem::path& file);

  [[nodiscard]] const std::filesystem::path& file() const { return m_file; }
  [[nodiscard]] std::size_t width() const { return m_input->facts().width; }
  [[nodiscard]] std::size_t height() const { return m_input->facts().height; }
  /// Returns the names of the channels, of which there is at least one.
  [[nodiscard]] const std::vector<std::string>& names() const {
    return m_input->facts().channelNames;
  }

  /// Returns a channel's width·height values, row by row from the top. Throws InputError that says
  /// what is wrong with the channel: damaged, whole numbers, a value that is not a number or
  /// infinite, too large for this machine's memory. Throws Cancelled.
  [[nodiscard]] std::vector<float> read(std::size_t channel, const Progress& progress = {});

  /// Returns the error of one value of a channel, which names the channel and the pixel.
  [[nodiscard]] InputError errorAt(std::size_t channel, std::size_t value,
                                   const std::string& why) const;

 private:
  std::filesystem::path m_file;
  std::unique_ptr<ImageInput> m_input;
};

}  // namespace hogelscope
