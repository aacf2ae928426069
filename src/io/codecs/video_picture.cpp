// SPDX-License-Identifier: BSD-3-Clause
#include "io/codecs/video_picture.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string_view>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/optics/image.h"

namespace hogelscope {

namespace {

/// What Y is made of, by the number that H.273 gives it.
struct YuvColours {
  AVColorSpace space;
  double red;
  double blue;
  const char* name;
};

constexpr std::array yuvColours{YuvColours{AVCOL_SPC_UNSPECIFIED, 0.299, 0.114, "BT.601 (assumed)"},
                                YuvColours{AVCOL_SPC_BT470BG, 0.299, 0.114, "BT.601"},
                                YuvColours{AVCOL_SPC_SMPTE170M, 0.299, 0.114, "BT.601"},
                                YuvColours{AVCOL_SPC_BT709, 0.2126, 0.0722, "BT.709"},
                                YuvColours{AVCOL_SPC_BT2020_NCL, 0.2627, 0.0593, "BT.2020"},
                                YuvColours{AVCOL_SPC_FCC, 0.30, 0.11, "FCC"},
                                YuvColours{AVCOL_SPC_SMPTE240M, 0.212, 0.087, "SMPTE 240M"}};

/// Throws InputError for colours that are not a matrix of red, green and blue.
const YuvColours& coloursOf(const AVFrame& frame, const std::filesystem::path& file) {
  // FFmpeg takes samples Y, Cb, Cr that are tagged as RGB for untagged ones, too.
  const AVColorSpace space =
      frame.colorspace == AVCOL_SPC_RGB ? AVCOL_SPC_UNSPECIFIED : frame.colorspace;
  const auto* const found = std::ranges::find(yuvColours, space, &YuvColours::space);
  if (found != yuvColours.end()) return *found;
  const char* const name = av_color_space_name(space);
  throw InputError(file.string(), "",
                   std::string("has colours of the kind ") + (name == nullptr ? "?" : name) +
                       "; convert them to RGB or BT.709");
}

/// Returns the samples that a picture has in planes of one size: the file's own, or of 16 bits
/// where chroma is interpolated.
AVPixelFormat planesFor(const AVPixFmtDescriptor& from) {
  const bool isRgb = (from.flags & AV_PIX_FMT_FLAG_RGB) != 0;
  const bool isWhole = from.log2_chroma_w == 0 && from.log2_chroma_h == 0;
  const std::string name = std::string(isRgb ? "gbr" : "yuv") +
                           ((from.flags & AV_PIX_FMT_FLAG_ALPHA) == 0 ? "" : "a") +
                           (isRgb ? "p" : "444p");
  const int bits = from.comp[0].depth;
  if (bits <= 8 && (isRgb || isWhole)) return av_get_pix_fmt(name.c_str());
  const AVPixelFormat own = av_get_pix_fmt((name + std::to_string(bits)).c_str());
  return own == AV_PIX_FMT_NONE || !(isRgb || isWhole) ? av_get_pix_fmt((name + "16").c_str())
                                                       : own;
}

/// Returns the format without the range that old names have in them.
AVPixelFormat withoutRange(AVPixelFormat format) {
  const std::string name = av_get_pix_fmt_name(format);
  return name.starts_with("yuvj") ? av_get_pix_fmt(("yuv" + name.substr(4)).c_str()) : format;
}

/// The place of a chroma sample in 1/256 of a luma pixel from the middle of the first one, x and y.
std::array<int, 2> sitingOf(AVChromaLocation location) {
  switch (location) {
    case AVCHROMA_LOC_CENTER:
      return {128, 128};
    case AVCHROMA_LOC_TOPLEFT:
      return {0, 0};
    case AVCHROMA_LOC_TOP:
      return {128, 0};
    case AVCHROMA_LOC_BOTTOMLEFT:
      return {0, 256};
    case AVCHROMA_LOC_BOTTOM:
      return {128, 256};
    default:  // left, also where nothing is said, as in MPEG-2, H.264 and H.265
      return {0, 128};
  }
}

FfmpegPtr<SwsContext> scalerFor(const AVFrame& frame, AVPixelFormat from, AVPixelFormat to) {
  FfmpegPtr<SwsContext> scaler(sws_alloc_context());
  if (!scaler) throw std::bad_alloc();
  const AVPixFmtDescriptor& samples = *av_pix_fmt_desc_get(from);
  const auto [right, down] = sitingOf(frame.chroma_location);
  const auto set = [&scaler](const char* name, int value) {
    av_opt_set_int(scaler.get(), name, value, 0);
  };
  for (const char* name : {"srcw", "dstw"}) set(name, frame.width);
  for (const char* name : {"srch", "dsth"}) set(name, frame.height);
  set("src_format", from);
  set("dst_format", to);
  // Samples are not converted, only interpolated, so any range will do if it is that of both.
  for (const char* name : {"src_range", "dst_range"}) set(name, 1);
  if (samples.log2_chroma_w > 0) set("src_h_chr_pos", right);
  if (samples.log2_chroma_h > 0) set("src_v_chr_pos", down);
  set("sws_flags",
      SWS_BICUBIC | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INT | SWS_FULL_CHR_H_INP | SWS_BITEXACT);
  if (sws_init_context(scaler.get(), nullptr, nullptr) < 0) scaler.reset();
  return scaler;
}

}  // namespace

void VideoPicture::take(const AVFrame& frame, const std::int32_t* displayMatrix,
                        const std::filesystem::path& file) {
  const AVFrameSideData* const own = av_frame_get_side_data(&frame, AV_FRAME_DATA_DISPLAYMATRIX);
  takeOrientation(own == nullptr ? displayMatrix
                                 : reinterpret_cast<const std::int32_t*>(own->data));
  takeSamples(frame, file);
  takeColours(frame, file);
  m_pixelShape = frame.sample_aspect_ratio;
}

/// A point (x, y) of the stored picture is shown at (m₀ x + m₃ y, m₁ x + m₄ y), but for a shift.
void VideoPicture::takeOrientation(const std::int32_t* matrix) {
  m_isTurned = m_isMirrored = m_isUpsideDown = false;
  m_oddAngle = 0;
  if (matrix == nullptr) return;
  const double a = matrix[0], b = matrix[1], c = matrix[3], d = matrix[4];
  const double along = std::min(std::abs(a), std::abs(d));
  const double across = std::min(std::abs(b), std::abs(c));
  constexpr double small = 0.02;
  if (std::max(std::abs(b), std::abs(c)) <= small * along) {
    m_isMirrored = a < 0;
    m_isUpsideDown = d < 0;
  } else if (std::max(std::abs(a), std::abs(d)) <= small * across) {
    m_isTurned = true;
    m_isMirrored = c < 0;
    m_isUpsideDown = b < 0;
  } else {
    m_oddAngle = av_display_rotation_get(matrix);
  }
}

/// Sets the samples as planes of one size.
void VideoPicture::takeSamples(const AVFrame& frame, const std::filesystem::path& file) {
  const auto named = AVPixelFormat(frame.format);
  const AVPixelFormat from = withoutRange(named);
  const AVPixFmtDescriptor* const samples = av_pix_fmt_desc_get(from);
  const AVPixelFormat to = samples == nullptr ? AV_PIX_FMT_NONE : planesFor(*samples);
  const bool isSame =
      m_scaler && m_format == named && m_width == frame.width && m_height == frame.height;
  m_format = named;
  m_width = frame.width;
  m_height = frame.height;
  m_samples.reset(av_frame_alloc());
  if (!m_samples) throw std::bad_alloc();
  if (to == from) {
    if (av_frame_ref(m_samples.get(), &frame) < 0) throw std::bad_alloc();
    m_samples->format = to;
    return;
  }
  const bool isXyz = samples != nullptr && std::string_view(samples->name).starts_with("xyz");
  if (!isSame && !isXyz && to != AV_PIX_FMT_NONE) m_scaler = scalerFor(frame, from, to);
  if (!m_scaler || isXyz || to == AV_PIX_FMT_NONE)
    throw InputError(file.string(), "",
                     std::string("has samples of the kind ") +
                         (samples == nullptr ? "?" : samples->name) + "; convert them to yuv444p");
  m_samples->format = to;
  m_samples->width = frame.width;
  m_samples->height = frame.height;
  if (av_frame_get_buffer(m_samples.get(), 0) < 0) throw std::bad_alloc();
  sws_scale(m_scaler.get(), frame.data, frame.linesize, 0, frame.height, m_samples->data,
            m_samples->linesize);
}

void VideoPicture::takeColours(const AVFrame& frame, const std::filesystem::path& file) {
  const AVPixFmtDescriptor& from = *av_pix_fmt_desc_get(m_format);
  const int planeBits = av_pix_fmt_desc_get(AVPixelFormat(m_samples->format))->comp[0].depth;
  m_bits = std::clamp(from.comp[0].depth, 8, 16);
  m_isYuv = (from.flags & AV_PIX_FMT_FLAG_RGB) == 0;
  m_hasAlpha = (from.flags & AV_PIX_FMT_FLAG_ALPHA) != 0;
  m_weights = {};
  m_colours.clear();
  const auto most = float(largestValue(m_bits));
  const auto largestSample =
      float(largestValue(m_bits) << unsigned(std::max(0, planeBits - m_bits)));
  m_weights.luma = most / largestSample;
  m_opacity = 1 / largestSample;
  if (!m_isYuv) return;
  const YuvColours& colours = coloursOf(frame, file);
  const bool isGrey = from.nb_components < 3;
  const bool isNamedFull = withoutRange(m_format) != m_format;
  const bool isSaid = frame.color_range != AVCOL_RANGE_UNSPECIFIED || isNamedFull;
  const bool isFull = isNamedFull || frame.color_range == AVCOL_RANGE_JPEG ||
                      (isGrey && frame.color_range == AVCOL_RANGE_UNSPECIFIED);
  const auto unit = float(std::exp2(planeBits - 8));
  const double chroma = most / (isFull ? largestSample : 224 * unit);
  const double green = 1 - colours.red - colours.blue;
  m_weights = {.black = isFull ? 0 : 16 * unit,
               .luma = most / (isFull ? largestSample : 219 * unit),
               .middle = 128 * unit,
               .crToRed = float(2 * (1 - colours.red) * chroma),
               .cbToGreen = float(-2 * (1 - colours.blue) * colours.blue / green * chroma),
               .crToGreen = float(-2 * (1 - colours.red) * colours.red / green * chroma),
               .cbToBlue = float(2 * (1 - colours.blue) * chroma)};
  m_colours = (isGrey ? std::string() : std::string(", ") + colours.name) +
              (isFull ? ", full range" : ", limited range") + (isSaid ? "" : " (assumed)");
}

std::string VideoPicture::words() const {
  const bool isUpright = !m_isTurned && !m_isMirrored && !m_isUpsideDown;
  return av_get_pix_fmt_name(m_format) + m_colours + (isUpright ? "" : ", turned upright");
}

std::vector<std::string> VideoPicture::notes() const {
  std::vector<std::string> notes;
  const auto [across, down] = m_pixelShape;
  if (across > 0 && down > 0 && across != down)
    notes.push_back("has pixels of " + std::to_string(across) + ":" + std::to_string(down) +
                    ", wide:high, which are taken for square");
  if (m_oddAngle != 0)
    notes.push_back("is to be shown turned by " + rounded(m_oddAngle, 1) +
                    "°; it is read as stored, since that is no multiple of 90°");
  return notes;
}

/// Reads the samples of row y, as it is shown, from a plane.
void VideoPicture::gather(std::size_t y, int component, std::vector<float>& row) const {
  const AVPixFmtDescriptor& format = *av_pix_fmt_desc_get(AVPixelFormat(m_samples->format));
  const AVComponentDescriptor& place = format.comp[component];
  const std::uint8_t* const plane = m_samples->data[place.plane];
  const std::ptrdiff_t down = m_samples->linesize[place.plane];
  const std::ptrdiff_t right = place.step;
  const auto at = std::ptrdiff_t(y);
  const auto flipped = [](bool isFlipped, std::ptrdiff_t k, int count) {
    return isFlipped ? count - 1 - k : k;
  };
  const auto [alongRow, acrossRows] = m_isTurned ? std::pair(down, right) : std::pair(right, down);
  const int length = m_isTurned ? m_height : m_width;
  const std::uint8_t* from =
      plane + acrossRows * flipped(m_isUpsideDown, at, m_isTurned ? m_width : m_height) +
      alongRow * flipped(m_isMirrored, 0, length);
  const std::ptrdiff_t step = m_isMirrored ? -alongRow : alongRow;
  row.resize(std::size_t(length));
  const bool isWide = place.depth > 8;
  if (step == (isWide ? 2 : 1)) {
    if (isWide)
      copySamples(reinterpret_cast<const std::uint16_t*>(from), row.size(), row.data());
    else
      copySamples(from, row.size(), row.data());
    return;
  }
  for (float& sample : row) {
    sample = place.depth <= 8 ? *from : *reinterpret_cast<const std::uint16_t*>(from);
    from += step;
  }
}

template <class T>
void VideoPicture::setRow(std::size_t y, T* rgb) {
  const int components = 3 + (m_hasAlpha ? 1 : 0);
  for (int c = 0; c < components; ++c) gather(y, c, m_row[std::size_t(c)]);
  const auto most = float(largestValue(m_bits));
  auto& [first, second, third, alpha] = m_row;
  if (m_isYuv)
    yuvToRgb(m_weights, width(), first.data(), second.data(), third.data());
  else
    for (auto* const values : {&first, &second, &third})
      for (float& value : *values) value *= m_weights.luma;
  if (m_hasAlpha)
    for (auto* const values : {&first, &second, &third})
      for (std::size_t x = 0; x < width(); ++x)
        (*values)[x] = std::clamp((*values)[x], 0.0F, most) * (alpha[x] * m_opacity);
  writePixels(first.data(), second.data(), third.data(), width(), most, rgb);
}

template void VideoPicture::setRow(std::size_t y, std::uint8_t* rgb);
template void VideoPicture::setRow(std::size_t y, std::uint16_t* rgb);

}  // namespace hogelscope
