// SPDX-License-Identifier: BSD-3-Clause
// Reads raw planar YUV.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/images/image_inputs.h"
#include "io/images/raw_plane.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Converts Y, Cb, Cr, integers of `bits` bits, to red, green, blue of the same bits.
class ToRgb {
 public:
  explicit ToRgb(const YuvParams& params)
      : m_kr(params.matrix == YuvMatrix::bt709 ? 0.2126 : 0.299),
        m_kb(params.matrix == YuvMatrix::bt709 ? 0.0722 : 0.114),
        m_most((1 << params.bits) - 1),
        m_middle(1 << (params.bits - 1)) {
    const int unit = 1 << (params.bits - 8);
    const bool isFull = params.range == YuvRange::full;
    m_black = isFull ? 0 : 16 * unit;
    m_lumaSpan = isFull ? m_most : 219 * unit;
    m_chromaSpan = isFull ? m_most : 224 * unit;
  }

  [[nodiscard]] std::array<std::uint32_t, 3> operator()(int y, int cb, int cr) const {
    const double luma = (y - m_black) / m_lumaSpan;
    const double red = luma + 2 * (1 - m_kr) * (cr - m_middle) / m_chromaSpan;
    const double blue = luma + 2 * (1 - m_kb) * (cb - m_middle) / m_chromaSpan;
    const double green = (luma - m_kr * red - m_kb * blue) / (1 - m_kr - m_kb);
    return {rounded(red), rounded(green), rounded(blue)};
  }

 private:
  [[nodiscard]] std::uint32_t rounded(double light) const {
    return std::uint32_t(std::floor(std::clamp(light, 0.0, 1.0) * m_most + 0.5));
  }

  double m_kr;
  double m_kb;
  double m_most;
  double m_middle;
  double m_black;
  double m_lumaSpan;
  double m_chromaSpan;
};

std::array<RawPlane, 3> planesOf(const YuvParams& params) {
  const auto width = std::uint64_t(params.size[0]);
  const auto height = std::uint64_t(params.size[1]);
  const std::uint64_t step = params.sampling == YuvSampling::s420 ? 2 : 1;
  const RawPlane y{0, width, height, params.bits};
  const RawPlane cb{y.end(), (width + step - 1) / step, (height + step - 1) / step, params.bits};
  RawPlane cr = cb;
  cr.at = cb.end();
  return {y, cb, cr};
}

/// Returns a number of at most six digits at a place of a text; 0 if there is none.
int numberAt(std::string_view text, std::size_t at) {
  int number = 0;
  const std::string_view digits = text.substr(std::min(at, text.size()), 6);
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// Returns the width and height in a file's name, as in NAME_1920x1080_yuv420p10le.yuv; 0 if there
/// are none.
std::array<int, 2> sizeInName(std::string_view name) {
  constexpr std::string_view digits = "0123456789";
  for (std::size_t at = name.find('x'); at != std::string_view::npos; at = name.find('x', at + 1)) {
    const std::size_t before = name.substr(0, at).find_last_not_of(digits);
    const std::array size{numberAt(name, before == std::string_view::npos ? 0 : before + 1),
                          numberAt(name, at + 1)};
    if (size[0] > 0 && size[1] > 0 && before + 1 != at) return size;
  }
  return {0, 0};
}

/// Returns the parameters, completed by the file's name if they have no size: its size and, where
/// it names FFmpeg's kind of samples (yuv420p, yuv420p10le), sampling and bits. Throws InputError
/// for a kind that is not read.
YuvParams withName(YuvParams params, const fs::path& file) {
  if (params.size[0] > 0 && params.size[1] > 0) return params;
  const std::string name = file.stem().string();
  params.size = sizeInName(name);
  const std::size_t kind = name.find("yuv4");
  if (params.size[0] == 0 || kind == std::string::npos) return params;
  const int sampling = numberAt(name, kind + 3);
  const int bits = numberAt(name, kind + 7);
  params.sampling = sampling == 444 ? YuvSampling::s444 : YuvSampling::s420;
  params.bits = bits == 0 ? 8 : bits;
  if ((sampling != 444 && sampling != 420) || params.bits < 8 || params.bits > 16 ||
      name.find("be", kind + 7) == kind + 7 + (params.bits > 9 ? 2 : 1))
    throw InputError(file.string(), "",
                     "has the name of " + name.substr(kind) +
                         "; of raw YUV 4:2:0 and 4:4:4 are read, 8 to 16 bits, low byte first");
  return params;
}

class YuvInput : public RowInput {
 public:
  YuvInput(const fs::path& file, const YuvParams& given)
      : YuvInput(file, withName(given, file), given.size[0] < 1 || given.size[1] < 1) {}

  void read(std::size_t frame, std::size_t first, std::size_t rows, const Rows& to) override {
    m_frame = frame;
    RowInput::read(frame, first, rows, to);
  }

 private:
  YuvInput(const fs::path& file, const YuvParams& params, bool isNamed)
      : m_file(file), m_step(params.sampling == YuvSampling::s420 ? 2 : 1), m_toRgb(params) {
    if (params.size[0] < 1 || params.size[1] < 1)
      throw InputError(
          file.string(), "lightField.yuvSize",
          "is not given, and raw YUV does not say its size; for a folder of views give "
          "lightField.pattern too, such as RRR_CCC.yuv");
    m_planes = planesOf(params);
    const std::uint64_t needed = m_planes[2].end();
    m_facts = {{m_planes[0].width, m_planes[0].height, 3,
                params.bits > 8 ? StoredType::uint16 : StoredType::uint8, params.bits,
                std::size_t(m_file.size() / needed)},
               isNamed ? "yuv by its name" : "yuv"};
    m_facts.isVideo = true;
    if (m_file.size() > 0 && m_file.size() % needed == 0) return;
    throw InputError(file.string(), "size",
                     "is " + std::to_string(m_file.size()) + " bytes, but one picture of " +
                         pairText(params.size[0], params.size[1]) + " px, " +
                         (m_step > 1 ? "4:2:0" : "4:4:4") + ", " + std::to_string(params.bits) +
                         " bits has " + std::to_string(needed) +
                         "; mend lightField.yuvSize, yuvSampling or yuvBits");
  }

  void readRow(std::size_t y, std::uint8_t* rgb) override { convertRow(y, rgb); }
  void readRow(std::size_t y, std::uint16_t* rgb) override { convertRow(y, rgb); }

  template <class T>
  void convertRow(std::size_t row, T* rgb) const {
    const auto samples = [this](RawPlane plane, std::size_t of) {
      plane.at += m_frame * m_planes[2].end();
      return hogelscope::readRow(m_file, plane, of);
    };
    const auto y = samples(m_planes[0], row);
    const auto cb = samples(m_planes[1], row / m_step);
    const auto cr = samples(m_planes[2], row / m_step);
    for (std::size_t x = 0; x < m_facts.width; ++x)
      for (const std::uint32_t value : m_toRgb(y[x], cb[x / m_step], cr[x / m_step]))
        *rgb++ = spread<T>(value, m_facts.bits);
  }

  RandomAccessFile m_file;
  std::size_t m_step;
  ToRgb m_toRgb;
  std::array<RawPlane, 3> m_planes;  ///< of the first picture
  std::size_t m_frame = 0;
};

}  // namespace

std::unique_ptr<ImageInput> openYuv(const fs::path& file, const YuvParams& params) {
  return file.extension() == ".yuv" ? std::make_unique<YuvInput>(file, params) : nullptr;
}

}  // namespace hogelscope
