// SPDX-License-Identifier: BSD-3-Clause
#include "io/documents/light_field_params.h"

#include "core/base/error.h"
#include "core/content/capture_content.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

namespace {

constexpr std::array<std::string_view, 8> layoutNames{"hogels",   "views", "quilt", "mosaic",
                                                      "lenslets", "pack",  "live",  "woven"};
constexpr std::array<std::string_view, 2> gridNames{"square", "hexagonal"};
constexpr std::array<std::string_view, 3> typeNames{"uint8", "real", "capture"};
constexpr std::array<std::string_view, 2> rowOrderNames{"top-down", "bottom-up"};
constexpr std::array<std::string_view, 2> columnOrderNames{"left-right", "right-left"};
constexpr std::array<std::string_view, 4> scanNames{"raster", "serpentine", "columns",
                                                    "columns-serpentine"};
constexpr std::array<std::string_view, 2> startNames{"bottom-left", "top-left"};
constexpr std::array<std::string_view, 2> samplingNames{"4:2:0", "4:4:4"};
constexpr std::array<std::string_view, 2> colourMatrixNames{"bt709", "bt601"};
constexpr std::array<std::string_view, 2> rangeNames{"limited", "full"};

/// Whether the names of its files are those of raw YUV.
bool isYuv(const LightFieldParams& params) {
  if (params.layout == Layout::pack || params.isLive()) return false;
  return params.file.ends_with(".yuv") ||
         (params.layout == Layout::views && params.pattern.ends_with(".yuv"));
}

void describeYuv(ParameterVisitor& v, YuvParams& p) {
  auto& [size, sampling, bits, matrix, range] = p;
  v.field({"yuvSize", "YUV size"}, size, {1, 1e6, 1, true}, "px",
          "Width and height of the picture, or of each view, in raw YUV; not given: the name's, as "
          "in NAME_1920x1080_yuv420p10le.yuv, with sampling and bits.");
  v.field({"yuvSampling", "YUV sampling"}, sampling, samplingNames,
          "4:2:0: Cb and Cr have half the width and height, rounded up; 4:4:4: all of it.");
  v.field({"yuvBits", "YUV bits"}, bits, {8, 16, 2}, "bits",
          "Bits of a sample: 8, a byte; more, in 16 with the low byte first.");
  v.field({"yuvMatrix", "YUV matrix"}, matrix, colourMatrixNames,
          "What Y, Cb and Cr are made of: BT.709 or BT.601.");
  v.field({"yuvRange", "YUV range"}, range, rangeNames,
          "limited: 8-bit Y is 16 … 235, Cb and Cr 16 … 240; full: all values.");
}

void describeLenslets(ParameterVisitor& v, LensletParams& p) {
  auto& [white, dark, grid, pitch, rotation, origin, gain] = p;
  v.field(
      "white", white,
      "Picture of even light through the same lenslets: they are found in it, and its vignetting "
      "is divided out. Empty: they are found in the light field itself.");
  v.field("dark", dark, "Picture without light, subtracted from both. Empty: none.");
  v.field("grid", grid, gridNames,
          "hexagonal: every second row of lenslets is shifted by half a pitch.");
  v.field("pitch", pitch, {3, 1e4, 0.01, true}, "px",
          "Distance of neighbouring lenslets of a row; not given: found.");
  v.field("rotation", rotation, {-45, 45, 0.01, true}, "°",
          "Of the rows of lenslets, clockwise; not given: found.");
  v.field(
      "origin", origin, {-1e6, 1e6, 0.1, true}, "px",
      "Middle of the first lenslet that is used; (0, 0) is the middle of the top left pixel. Not "
      "given: found.");
  v.field("gain", gain, {1e-6, 1e6, 0.1}, "",
          "Multiplies the light: for pictures that use few of their bits.");
}

void describeNames(ParameterVisitor& v, std::string& pattern, std::string& exclude,
                   ViewScan& scan) {
  v.field("pattern", pattern,
          "Names the numbers in the file names: RR row, CC column, NNN running number, x and y "
          "a coordinate, {T} the number of a frame, * anything. Empty: the known ones are tried, "
          "then the largest series of pictures.");
  v.field("exclude", exclude,
          "File names that are not views, with the shell's wildcards * ? [ ], and ; between "
          "them: *_thumb.png;input_Cam040.png.");
  v.field("scan", scan, scanNames,
          "How one running number, a video's frames too, counts the views: row by row or column by "
          "column, each from its beginning, or (serpentine) every second one from its end.");
}

void describeLive(ParameterVisitor& v, std::string& source, LiveType& type) {
  const std::string sourceBefore = source;
  v.field(
      "source", source,
      "What computes the content: \"scene\" is built in, others are plugins; its parameters are "
      "an object of that name.");
  const bool isCapture = source == CaptureContent::sourceName;
  if (isCapture && source != sourceBefore) type = LiveType::capture;
  if (!isCapture && type == LiveType::capture) type = LiveType::uint8;
  v.field("type", type, std::span(typeNames).first(isCapture ? 3 : 2),
          isCapture ? "How directional pixels are rounded: to 8 bits, not, or (capture) to 8 "
                      "bits only if the capture has no more."
                    : "How directional pixels are rounded: to 8 bits, or not.");
}

}  // namespace

void describe(ParameterVisitor& v, LightFieldParams& p) {
  auto& [file, layout, incoming, rows, columns, pattern, exclude, scan, shear, viewingDistance,
         quiltColumns, quiltRows, quiltStart, lenslets, yuv, source, type, content, live,
         calibration, calibrationFile, frames, fps] = p;
  v.group("lightField", "The display's content: a file and how it is laid out.");
  if (!p.isLive())
    v.field(
        "file", file,
        "Image (hogels, quilt, mosaic, lenslets, woven); folder or %-pattern of images, video, "
        "TIFF of several pages or HDF5 file (views); store (pack); relative to the session. {T} "
        "stands for the number of a frame.");
  v.field("layout", layout, layoutNames,
          "One image of hogel tiles, a folder of views (sub-aperture images), a quilt of views, a "
          "mosaic of views from several rows of cameras, a picture taken through lenslets, a store "
          "of blocks; live: a 3-D scene, of which a view's "
          "rays are traced; woven: the picture of a lens sheet's panel.");
  if (!p.isLive() && layout != Layout::woven)
    v.field({"incoming", "Depth reversed"}, incoming,
            "Directions were recorded looking into the scene: both u and v are flipped.");
  if (isGridOfViews(layout)) {
    v.field("rows", rows, rowOrderNames, "Where the first row of views was taken from.");
    v.field("columns", columns, columnOrderNames, "Where the first column was taken from.");
  }
  if (layout == Layout::views) describeNames(v, pattern, exclude, scan);
  if (isGridOfViews(layout))
    v.field("shear", shear, {-1e4, 1e4, 0.1}, "px/view",
            "Moves view (u, v) to the right and down, so that the wanted depth lies on the panel; "
            "by whole pixels, rounded.");
  if (layout != Layout::woven)
    v.field(
        "viewingDistance", viewingDistance, {1e-6, 1e6, 0.01, true}, "m",
        "Distance before the panel of the plane on which the views' cameras stood, each looking at "
        "all of the panel; not given: every hogel has the same directions.");
  if (p.isLive()) describeLive(v, source, type);
  if (layout == Layout::quilt) {
    v.field("columns", quiltColumns, {1, 4096, 1, true}, "views",
            "Views side by side; not given: from the file name's _qs{columns}x{rows}a{aspect}.");
    v.field("rows", quiltRows, {1, 4096, 1, true}, "views", "Rows of views.");
    v.field("start", quiltStart, startNames,
            "The tile of the first view; the others follow to the right, then row by row.");
  }
  if (layout == Layout::lenslets) describeLenslets(v, lenslets);
  if (isYuv(p)) describeYuv(v, yuv);
  v.count(frames || fps != notGiven || isNumbered(p));
  v.field({"fps", "Frame rate"}, fps, {0.01, 1000, 1, true, 1, 120}, "frames/s",
          "Frames of a light field in time that are shown in a second; not given: those of its "
          "video, and 30 of a scene's animation.");
  v.count(true);
}

std::string_view nameOf(Layout layout) {
  return layoutNames[std::size_t(layout)];
}

PatternParams patternParams(const std::vector<std::string>& overrides) {
  Json document = Json::object();
  for (const std::string& text : overrides) {
    const Override change = parseOverride(text);
    document[change.section][change.field] = change.value;
  }
  PatternParams params;
  inFile("override", [&] {
    JsonReader reader(document, "");
    readSection(reader, "pattern", params);
    reader.refuseUnknown();
  });
  return params;
}

}  // namespace hogelscope
