// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/other_formats.h"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "core/base/text.h"
#include "io/files/random_access_file.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

using namespace std::string_view_literals;

constexpr std::string_view splats =
    "holds 3-D Gaussian splats, which are not rendered here: render a grid of views with the "
    "program that made them and open their folder";
constexpr std::string_view points =
    "is a cloud of points, which is not rendered here: make a surface of triangles of it (.ply, "
    ".glb), or render a grid of views";
constexpr std::string_view archive = "is an archive: unpack it and open the folder of its pictures";
constexpr std::string_view bag =
    "is a recording of ROS: extract its pictures, such as by image_view's extract_images, and open "
    "their folder";
constexpr std::string_view array =
    "is an array of NumPy: open it in Python (hogelscope.LightField), or write its views as "
    "pictures";

/// The mark of a format, at a place of the file, and what its files are.
struct Mark {
  std::size_t at;
  std::string_view bytes;
  std::string_view advice;
};

constexpr std::array marks{
    Mark{0, "\x89LFP\r\n\x1a\n"sv,
         "is a raw file of a Lytro camera: decode it, such as by PlenoptiCam or the Light Field "
         "Toolbox, and open the views, or the raw picture with layout lenslets"},
    Mark{0, "#ROSBAG V"sv, bag},
    Mark{0, "\x89MCAP0\r\n"sv, bag},
    Mark{0, "SQLite format 3\0"sv,
         "is a data base of SQLite, such as a recording of ROS 2 or COLMAP's data base: extract "
         "its pictures and open their folder"},
    Mark{0, "NGSP"sv, splats},
    Mark{0, "LASF"sv, points},
    Mark{0, "ASTM-E57"sv, points},
    Mark{0, "# .PCD"sv, points},
    Mark{0, "\x93NUMPY"sv, array},
    Mark{0, "PK\x03\x04"sv, archive},
    Mark{0, "Rar!\x1a\x07"sv, archive},
    Mark{0, "7z\xbc\xaf\x27\x1c"sv, archive},
    Mark{257, "ustar"sv, archive},
    Mark{0, "\x1f\x8b"sv, archive},
    Mark{0, "BZh"sv, archive},
    Mark{0,
         "\xfd"
         "7zXZ\0"sv,
         archive},
    Mark{0, "\x28\xb5\x2f\xfd"sv, archive},
    Mark{0, "%PDF-"sv, "is a PDF: take its pictures out, such as by pdfimages"},
    Mark{0, "<svg"sv, "is a drawing (SVG): draw it as pixels, such as by rsvg-convert"}};

/// Formats without a mark of their own, by their extensions, or files that begin as others do.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> endings{
    {{".splat", splats}, {".spz", splats}, {".xyz", points}, {".npz", array}, {".ksplat", splats}}};

std::string firstBytes(const fs::path& path) {
  constexpr std::size_t most = 4096;
  std::string bytes(most, '\0');
  const RandomAccessFile file(path);
  bytes.resize(file.readSome(0, std::as_writable_bytes(std::span(bytes))));
  return bytes;
}

/// Returns what a PLY without triangles is, by its header.
std::string_view adviceOnPly(const std::string& begin) {
  const std::string header = begin.substr(0, begin.find("end_header"));
  if (header.find("f_dc_0") != std::string::npos) return splats;
  const bool hasFaces = header.find("element face") != std::string::npos ||
                        header.find("element tristrips") != std::string::npos;
  // A longer header may have them further on.
  return hasFaces || header.size() == begin.size() ? ""sv : points;
}

}  // namespace

std::string adviceOnFormat(const fs::path& file) {
  const std::string begin = firstBytes(file);
  const std::string extension = lowerCase(file.extension().string());
  for (const auto& [ending, advice] : endings)
    if (extension == ending) return std::string(advice);
  if (begin.starts_with("ply\n") || begin.starts_with("ply\r"))
    return std::string(adviceOnPly(begin));
  const auto mark = std::ranges::find_if(marks, [&begin](const Mark& each) {
    return begin.size() > each.at &&
           std::string_view(begin).substr(each.at).starts_with(each.bytes);
  });
  return mark == marks.end() ? std::string() : std::string(mark->advice);
}

}  // namespace hogelscope
