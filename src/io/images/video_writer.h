// SPDX-License-Identifier: BSD-3-Clause
// Videos, made by the program ffmpeg.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>

#include "core/base/progress.h"
#include "io/files/atomic_file.h"

namespace hogelscope {

/// Whether a name is that of a video that can be written: it ends in .mp4.
bool isVideoName(const std::filesystem::path& file);

/// Writes a video, completely or not at all: H.264 (or ffmpeg's default for MP4) in pixels that all
/// players know; odd sides get a black row or column. All functions throw InputError.
class VideoWriter {
 public:
  /// Starts `ffmpeg`, a path or a name in PATH. The file's name must end in .mp4.
  VideoWriter(const std::filesystem::path& file, const std::array<int, 2>& size,
              double picturesPerSecond, const std::string& ffmpeg = "ffmpeg");
  VideoWriter(const VideoWriter&) = delete;
  VideoWriter& operator=(const VideoWriter&) = delete;
  /// Without finish() nothing is left.
  ~VideoWriter();

  /// Adds a picture of 8-bit RGB, row by row; waits while the program is busy. Throws Cancelled.
  void add(std::span<const std::uint8_t> rgb, const Progress& progress);
  /// Waits for the program, counts the pictures of its file and names it. Throws Cancelled.
  void finish(const Progress& progress);

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path m_path;
  AtomicFile m_file;
  Descriptor m_messages;  ///< what ffmpeg prints
  Descriptor m_pictures;  ///< what it reads
  pid_t m_process = -1;
  std::uint64_t m_count = 0;  ///< pictures
};

}  // namespace hogelscope
