// SPDX-License-Identifier: BSD-3-Clause
// Converts decoded frames to red, green and blue.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/codecs/ffmpeg.h"
#include "io/codecs/video_rows.h"

namespace hogelscope {

/// A frame as it is shown: upright, as red, green and blue of the bits of its samples, multiplied
/// by alpha (docs/formulas.md, Videos). Chroma with fewer samples is interpolated by libswscale.
class VideoPicture {
 public:
  /// Takes a frame. `displayMatrix` (libavutil/display.h) is that of the stream, or null; a frame's
  /// own counts more. Throws InputError that names `file` for colours that are not modelled.
  void take(const AVFrame& frame, const std::int32_t* displayMatrix,
            const std::filesystem::path& file);

  [[nodiscard]] std::size_t width() const { return std::size_t(m_isTurned ? m_height : m_width); }
  [[nodiscard]] std::size_t height() const { return std::size_t(m_isTurned ? m_width : m_height); }
  [[nodiscard]] int bits() const { return m_bits; }  ///< 8 … 16
  [[nodiscard]] bool hasAlpha() const { return m_hasAlpha; }
  /// Returns the samples and colours in words, such as "yuv420p10le, BT.709, limited range".
  [[nodiscard]] std::string words() const;
  /// Returns what of the frame is not used: non-square pixels, a rotation by other angles than 90°.
  [[nodiscard]] std::vector<std::string> notes() const;

  /// Sets the 3·width() values of row y, 0 … 2^bits − 1; bytes for 8 bits only.
  void readRow(std::size_t y, std::uint8_t* rgb) { setRow(y, rgb); }
  void readRow(std::size_t y, std::uint16_t* rgb) { setRow(y, rgb); }

 private:
  void takeOrientation(const std::int32_t* matrix);
  void takeColours(const AVFrame& frame, const std::filesystem::path& file);
  void takeSamples(const AVFrame& frame, const std::filesystem::path& file);
  template <class T>
  void setRow(std::size_t y, T* rgb);
  void gather(std::size_t y, int component, std::vector<float>& row) const;

  FfmpegPtr<AVFrame> m_samples;  ///< planes of one size: Y, Cb, Cr or R, G, B, then alpha
  FfmpegPtr<SwsContext> m_scaler;
  AVPixelFormat m_format = AV_PIX_FMT_NONE;  ///< of the frame
  std::string m_colours;                     ///< in words
  AVRational m_pixelShape{1, 1};
  double m_oddAngle = 0;  ///< degrees, if it is no multiple of 90
  bool m_isTurned = false;
  bool m_isMirrored = false;  ///< columns run from the right
  bool m_isUpsideDown = false;
  int m_width = 0;  ///< as stored
  int m_height = 0;
  int m_bits = 8;
  bool m_isYuv = false;
  bool m_hasAlpha = false;
  YuvWeights m_weights;
  float m_opacity = 1;  ///< of one step of an alpha sample
  std::array<std::vector<float>, 4> m_row;
};

}  // namespace hogelscope
