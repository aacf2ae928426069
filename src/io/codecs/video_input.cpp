// SPDX-License-Identifier: BSD-3-Clause
#include "io/codecs/video_input.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/optics/image.h"
#include "io/codecs/video_decoder.h"
#include "io/codecs/video_picture.h"
#include "io/images/raw_plane.h"

namespace hogelscope {

namespace {

class VideoInput : public ImageInput {
 public:
  VideoInput(const std::filesystem::path& file, const std::string& format)
      : m_file(file), m_decoder(file, format) {}

  bool prepare(std::size_t frame) override {
    if (m_shown == frame) return true;
    if (!m_decoder.advance(frame)) return false;
    m_picture.take(m_decoder.current(), m_decoder.stream().displayMatrix(), m_file);
    if (m_facts.width == 0) takeFacts();
    if (m_picture.width() != m_facts.width || m_picture.height() != m_facts.height ||
        m_picture.bits() != m_facts.bits)
      throw InputError(m_file.string(), "frame " + std::to_string(frame),
                       "is " + pairText(m_picture.width(), m_picture.height()) + " px of " +
                           std::to_string(m_picture.bits()) + " bits, but frame 0 is " +
                           pairText(m_facts.width, m_facts.height) + " px of " +
                           std::to_string(m_facts.bits) + " bits");
    m_shown = frame;
    return true;
  }

  void read(std::size_t frame, std::size_t first, std::size_t rows, const Rows& to) override {
    while (!prepare(frame)) {
    }
    std::visit(
        [&](auto* rgb) {
          using T = std::remove_pointer_t<decltype(rgb)>;
          for (std::size_t y = first; y < first + rows; ++y, rgb += m_row.size()) {
            if constexpr (sizeof(T) == 1)
              if (m_facts.bits == 8) {  // as they are
                m_picture.readRow(y, rgb);
                continue;
              }
            m_picture.readRow(y, m_row.data());
            std::ranges::transform(m_row, rgb,
                                   [this](std::uint16_t value) { return converted<T>(value); });
          }
        },
        to);
  }

 private:
  void takeFacts() {
    const AVStream& stream = m_decoder.stream().stream();
    const int bits = m_picture.bits();
    m_facts = {
        {m_picture.width(), m_picture.height(), m_picture.hasAlpha() ? 4 : 3,
         bits > 8 ? StoredType::uint16 : StoredType::uint8, bits, m_decoder.frames()},
        std::string(avcodec_get_name(stream.codecpar->codec_id)) + " video, " + m_picture.words()};
    m_facts.isVideo = true;
    if (const AVRational rate = stream.avg_frame_rate; rate.num > 0 && rate.den > 0)
      m_facts.rate = av_q2d(rate);
    m_facts.notes = m_decoder.notes();
    std::ranges::copy(m_picture.notes(), std::back_inserter(m_facts.notes));
    m_facts.bandRows = bandRowsOf(m_facts.width);
    m_row.resize(3 * m_facts.width);
    for (int value = 0; value <= largestValue(bits); ++value)
      m_stored.push_back(bits > 8 ? spread<std::uint16_t>(std::uint32_t(value), bits)
                                  : std::uint16_t(value));
  }

  /// Converts a value of the video's bits to a type of pixels as RowInput converts stored ones.
  template <class T>
  [[nodiscard]] T converted(std::uint16_t value) const {
    const unsigned stored = m_stored[value];
    const bool isWide = m_facts.type == StoredType::uint16;
    if constexpr (std::is_same_v<T, float>)
      return float(stored) / (isWide ? 65535.0F : 255.0F);
    else if constexpr (sizeof(T) > 1)
      return T(isWide ? stored : stored * 257);
    else
      return T(isWide ? (stored + 128) / 257 : stored);
  }

  std::filesystem::path m_file;
  VideoDecoder m_decoder;
  VideoPicture m_picture;
  std::size_t m_shown = std::numeric_limits<std::size_t>::max();  ///< the frame in m_picture
  std::vector<std::uint16_t> m_stored;  ///< of each value of the video's bits
  std::vector<std::uint16_t> m_row;
};

}  // namespace

std::unique_ptr<ImageInput> openVideo(const std::filesystem::path& file,
                                      const std::string& format) {
  return std::make_unique<VideoInput>(file, format);
}

}  // namespace hogelscope
