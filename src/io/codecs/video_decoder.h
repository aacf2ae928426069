// SPDX-License-Identifier: BSD-3-Clause
// Decodes the frames of a video by their number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/codecs/video_stream.h"

namespace hogelscope {

/// The frames of a video, counted from 0 in their order of presentation, as FFmpeg's program shows
/// them with -vsync passthrough: what an edit list leaves out is not counted. One thread; it keeps
/// what the codec needs, and one frame.
///
/// The packets are listed once. If each of them is one frame and has a time of its own, the frames
/// are numbered by these times, so that decoding can begin at any key frame. Otherwise all frames
/// are decoded once to count them, and going back begins again at the first one. Frames that follow
/// each other are decoded without seeking.
class VideoDecoder {
 public:
  /// Throws InputError that names the file, as advance() does.
  VideoDecoder(std::filesystem::path file, std::string format);

  /// Works for about half a second towards a frame; returns whether it is current(). Throws
  /// InputError if the file is damaged.
  bool advance(std::size_t frame);

  /// Returns the number of frames; known once frame 0 was current.
  [[nodiscard]] std::size_t frames() const { return m_frames; }
  [[nodiscard]] const AVFrame& current() const { return *m_frame; }
  [[nodiscard]] const VideoStream& stream() const { return *m_stream; }
  /// Returns what the container has beyond the frames, and which of them are left out; for users.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  /// The work that comes before frames can be read.
  enum class Phase { list, first, count, read };
  enum class Step { frame, more, end };
  struct Packet {
    std::int64_t time = 0;      ///< of presentation
    std::int64_t decoding = 0;  ///< its time; both in the stream's unit
    std::size_t place = 0;      ///< in the order of decoding
    bool isKey = false;
  };

  void restart();
  void listPacket();
  void finishList();
  [[nodiscard]] bool isOneFrameAPacket();
  void decodeFirst();
  void countFrame();
  bool reach(std::size_t frame);
  void goTowards(std::size_t frame);
  void take(std::size_t frame);
  [[nodiscard]] const Packet* keyOf(std::size_t frame) const;
  bool beginAt(std::int64_t time, const Packet& key);
  Step step();
  void send();
  void check(int error) const;
  [[noreturn]] void fail(std::size_t frame, const std::string& why) const;

  static constexpr std::size_t none = std::size_t(-1);

  std::filesystem::path m_file;
  std::string m_format;
  std::unique_ptr<VideoStream> m_stream;
  FfmpegPtr<AVCodecContext> m_decoder;
  FfmpegPtr<AVPacket> m_packet;
  FfmpegPtr<AVFrame> m_frame;
  Phase m_phase = Phase::list;
  bool m_beginsAlone = false;         ///< the first packet needs nothing before it
  std::size_t m_listed = 0;           ///< frames by the list; 0 if it does not number them
  std::vector<Packet> m_packets;      ///< in their order of presentation, if m_times is not empty
  std::vector<std::int64_t> m_times;  ///< of the frames; empty if they are decoded in order
  std::size_t m_frames = 0;
  std::size_t m_target = none;   ///< the frame that is wanted
  std::size_t m_current = none;  ///< the number of the last frame that was decoded
  bool m_isHeld = false;         ///< it is in m_frame
  std::size_t m_next = 0;        ///< the place of the packet that is read next
  bool m_isPending = false;      ///< it is in m_packet already
  bool m_hasKey = false;         ///< the decoder has got a key frame
  bool m_isSeekable = true;
};

}  // namespace hogelscope
