// SPDX-License-Identifier: BSD-3-Clause
// The packets of a video, and what its container says of its pictures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "io/codecs/ffmpeg.h"

namespace hogelscope {

/// The stream of pictures in a container, opened by libavformat; of several the one that FFmpeg's
/// program takes. The container cannot open other files. Throws InputError that names the file.
class VideoStream {
 public:
  /// `format` is FFmpeg's name of the container (videoFormatOf()).
  VideoStream(std::filesystem::path file, const std::string& format);

  /// Reads the next packet of the stream that has bytes. Returns false at the end.
  bool read(AVPacket& packet);
  /// Continues with a packet at this time of the stream or before it. Returns whether it can.
  bool seek(std::int64_t time);

  /// Returns how many packets of the container's index have not been read since it was opened.
  [[nodiscard]] std::size_t missing() const;

  [[nodiscard]] const AVStream& stream() const { return *m_container->streams[m_index]; }
  [[nodiscard]] std::int64_t bytes() const { return m_size; }  ///< of the file
  /// Returns the matrix by which pictures are shown (libavutil/display.h), 9 numbers; null if there
  /// is none.
  [[nodiscard]] const std::int32_t* displayMatrix() const;
  /// Returns what the container says beyond the pictures: that it has other streams of them.
  [[nodiscard]] std::vector<std::string> notes() const;
  /// Throws InputError that the file is damaged, with FFmpeg's words for its error.
  [[noreturn]] void fail(int error) const;

 private:
  static int readBytes(void* self, std::uint8_t* to, int bytes);
  static std::int64_t seekBytes(void* self, std::int64_t offset, int whence);

  std::filesystem::path m_file;
  std::ifstream m_bytes;
  std::int64_t m_size = 0;
  std::int64_t m_read = 0;    ///< packets of all streams, also empty ones
  std::size_t m_packets = 0;  ///< those of the stream
  FfmpegPtr<AVIOContext> m_input;
  FfmpegPtr<AVFormatContext> m_container;
  int m_index = 0;
};

}  // namespace hogelscope
