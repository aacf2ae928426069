// SPDX-License-Identifier: BSD-3-Clause
// Reads raw planar YUV.
#include <algorithm>
#include <cmath>
#include <string>

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

class YuvInput : public RowInput {
 public:
  YuvInput(const fs::path& file, const YuvParams& params)
      : m_file(file), m_step(params.sampling == YuvSampling::s420 ? 2 : 1), m_toRgb(params) {
    if (params.size[0] < 1 || params.size[1] < 1)
      throw InputError(
          file.string(), "lightField.yuvSize",
          "is not given, and raw YUV does not say its size; for a folder of views give "
          "lightField.pattern too, such as RRR_CCC.yuv");
    m_planes = planesOf(params);
    m_facts = {{m_planes[0].width, m_planes[0].height, 3,
                params.bits > 8 ? StoredType::uint16 : StoredType::uint8, params.bits},
               "yuv"};
    const std::uint64_t needed = m_planes[2].end();
    if (m_file.size() == needed) return;
    throw InputError(file.string(), "size",
                     "is " + std::to_string(m_file.size()) + " bytes, but one picture of " +
                         pairText(params.size[0], params.size[1]) + " px, " +
                         (m_step > 1 ? "4:2:0" : "4:4:4") + ", " + std::to_string(params.bits) +
                         " bits has " + std::to_string(needed) +
                         "; mend lightField.yuvSize, yuvSampling or yuvBits");
  }

 private:
  void readRow(std::size_t y, std::uint8_t* rgb) override { convertRow(y, rgb); }
  void readRow(std::size_t y, std::uint16_t* rgb) override { convertRow(y, rgb); }

  template <class T>
  void convertRow(std::size_t row, T* rgb) const {
    const auto y = hogelscope::readRow(m_file, m_planes[0], row);
    const auto cb = hogelscope::readRow(m_file, m_planes[1], row / m_step);
    const auto cr = hogelscope::readRow(m_file, m_planes[2], row / m_step);
    for (std::size_t x = 0; x < m_facts.width; ++x)
      for (const std::uint32_t value : m_toRgb(y[x], cb[x / m_step], cr[x / m_step]))
        *rgb++ = spread<T>(value, m_facts.bits);
  }

  RandomAccessFile m_file;
  std::size_t m_step;
  ToRgb m_toRgb;
  std::array<RawPlane, 3> m_planes;
};

}  // namespace

std::unique_ptr<ImageInput> openYuv(const fs::path& file, const YuvParams& params) {
  return file.extension() == ".yuv" ? std::make_unique<YuvInput>(file, params) : nullptr;
}

}  // namespace hogelscope
