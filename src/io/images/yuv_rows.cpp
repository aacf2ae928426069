// SPDX-License-Identifier: BSD-3-Clause
// Rows of raw planar YUV.
#include "io/images/yuv_rows.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Converts Y, Cb, Cr as integers of `bits` bits to red, green, blue of the same.
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

}  // namespace

bool YuvRows::isYuv(const fs::path& file) {
  return file.extension() == ".yuv";
}

YuvRows::YuvRows(const fs::path& file, const YuvParams& params) : m_file(file), m_params(params) {
  if (params.size[0] < 1 || params.size[1] < 1)
    throw InputError(file.string(), "lightField.yuvSize",
                     "is not given, and raw YUV does not say its size; for a folder of views give "
                     "lightField.pattern too, such as RRR_CCC.yuv");
  m_planes = planesOf(params);
  const std::uint64_t needed = m_planes[2].end();
  if (m_file.size() == needed) return;
  const std::string size = std::to_string(params.size[0]) + "×" + std::to_string(params.size[1]);
  const char* sampling = params.sampling == YuvSampling::s420 ? "4:2:0" : "4:4:4";
  throw InputError(file.string(), "size",
                   "is " + std::to_string(m_file.size()) + " bytes, but one picture of " + size +
                       " px, " + sampling + ", " + std::to_string(params.bits) + " bits has " +
                       std::to_string(needed) +
                       "; mend lightField.yuvSize, yuvSampling or yuvBits");
}

template <class T>
std::span<const T> YuvRows::next(std::vector<T>& rgb) {
  const std::size_t step = m_params.sampling == YuvSampling::s420 ? 2 : 1;
  const auto y = readRow(m_file, m_planes[0], m_row);
  const auto cb = readRow(m_file, m_planes[1], m_row / step);
  const auto cr = readRow(m_file, m_planes[2], m_row / step);
  const ToRgb toRgb(m_params);
  rgb.resize(3 * width());
  for (std::size_t x = 0; x < width(); ++x) {
    const auto values = toRgb(y[x], cb[x / step], cr[x / step]);
    for (std::size_t c = 0; c < 3; ++c) rgb[3 * x + c] = spread<T>(values[c], bits());
  }
  ++m_row;
  return rgb;
}

template std::span<const std::uint8_t> YuvRows::next(std::vector<std::uint8_t>&);
template std::span<const std::uint16_t> YuvRows::next(std::vector<std::uint16_t>&);

}  // namespace hogelscope
