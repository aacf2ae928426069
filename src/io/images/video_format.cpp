// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/video_format.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace hogelscope {

namespace {

using namespace std::string_view_literals;

/// A text at a place of a file, by which a container is recognised.
struct VideoMark {
  const char* format;
  std::size_t at;
  std::string_view text;
};

/// Of elementary streams those that begin with parameter sets or an access unit delimiter.
constexpr std::array videoMarks{
    VideoMark{"mov", 4, "ftyp"sv},
    VideoMark{"mov", 4, "moov"sv},
    VideoMark{"mov", 4, "mdat"sv},
    VideoMark{"mov", 4, "free"sv},
    VideoMark{"mov", 4, "skip"sv},
    VideoMark{"mov", 4, "wide"sv},
    VideoMark{"mov", 20, "mjp2"sv},
    VideoMark{"matroska", 0, "\x1a\x45\xdf\xa3"sv},
    VideoMark{"avi", 8, "AVI "sv},
    VideoMark{"yuv4mpegpipe", 0, "YUV4MPEG2"sv},
    VideoMark{"flv", 0, "FLV\1"sv},
    VideoMark{"asf", 0, "\x30\x26\xb2\x75"sv},
    VideoMark{"ogg", 0, "OggS"sv},
    VideoMark{"ivf", 0, "DKIF"sv},
    VideoMark{"mpeg", 0, "\0\0\1\xba"sv},
    VideoMark{"mpegvideo", 0, "\0\0\1\xb3"sv},
    VideoMark{"mpegts", 0, "\x47\x40"sv},
    VideoMark{"h264", 0, "\0\0\0\1\x67"sv},
    VideoMark{"h264", 0, "\0\0\0\1\x27"sv},
    VideoMark{"h264", 0, "\0\0\0\1\x09"sv},
    VideoMark{"h264", 0, "\0\0\1\x67"sv},
    VideoMark{"hevc", 0, "\0\0\0\1\x40\1"sv},
    VideoMark{"hevc", 0, "\0\0\0\1\x46\1"sv},
    VideoMark{"hevc", 0, "\0\0\1\x40\1"sv},
};

/// The brands of ISO files that are pictures: HEIF, AVIF, CR3.
constexpr std::array pictureBrands{"hei"sv,  "hev"sv,  "avi"sv, "mif1"sv,
                                   "msf1"sv, "miaf"sv, "crx "sv};

}  // namespace

std::string videoFormatOf(const std::filesystem::path& file) {
  std::string begin(24, '\0');
  std::ifstream(file, std::ios::binary).read(begin.data(), std::streamsize(begin.size()));
  const std::string_view all(begin);
  const auto has = [all](std::size_t at, std::string_view text) {
    return all.substr(at).starts_with(text);
  };
  const auto mark =
      std::ranges::find_if(videoMarks, [&](const VideoMark& one) { return has(one.at, one.text); });
  const bool isPicture =
      has(4, "ftyp") &&
      std::ranges::any_of(pictureBrands, [&](std::string_view brand) { return has(8, brand); });
  return mark == videoMarks.end() || isPicture ? "" : mark->format;
}

}  // namespace hogelscope
