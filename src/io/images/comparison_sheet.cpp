// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/comparison_sheet.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/axis.h"
#include "core/base/text.h"
#include "core/metrics/error_map.h"

namespace hogelscope {

namespace {

/// Lengths in pixels, in proportion to the pictures, so that a sheet has one look at all sizes.
struct SheetSizes {
  explicit SheetSizes(int height)
      : text(std::clamp(height / 700.0, 0.45, 4.0)), em(int(30 * text)) {}
  double text;  ///< factor of OpenCV's font
  int em;       ///< height of a line
};

void write(cv::Mat3b& sheet, const std::string& text, const cv::Point& at,
           const SheetSizes& sizes) {
  const int thickness = std::max(1, int(1.5 * sizes.text));
  cv::putText(sheet, text, at, cv::FONT_HERSHEY_SIMPLEX, sizes.text, cv::Scalar(0, 0, 0), thickness,
              cv::LINE_AA);
}

/// Returns the text without its end, so that it is no wider.
std::string fitting(std::string text, int width, const SheetSizes& sizes) {
  int base = 0;
  const auto isWide = [&] {
    return cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, sizes.text, 1, &base).width > width;
  };
  while (!text.empty() && isWide()) text.pop_back();
  return text;
}

void put(cv::Mat3b& sheet, std::vector<std::uint8_t> rgb, const cv::Rect& place) {
  cv::Mat3b(place.height, place.width, reinterpret_cast<cv::Vec3b*>(rgb.data()))
      .copyTo(sheet(place));
}

void putScale(cv::Mat3b& sheet, const ErrorMap& map, const cv::Rect& place,
              const SheetSizes& sizes) {
  for (int y = 0; y < place.height; ++y) {
    const auto [r, g, b] = map.colourAt(1 - (y + 0.5) / place.height);
    sheet(cv::Rect(place.x, place.y + y, place.width, 1)).setTo(cv::Scalar(r, g, b));
  }
  if (place.height < sizes.em) return;  // no number has room
  const Axis axis{0, map.errorAt(1), double(place.y + place.height), double(place.y)};
  for (const Tick& tick : linearTicks(axis, 4))
    write(sheet, tick.text,
          {place.x + place.width + sizes.em / 4,
           std::clamp(int(axis.at(tick.value)) + sizes.em / 3, place.y + sizes.em / 2,
                      place.y + place.height)},
          sizes);
}

}  // namespace

Image comparisonSheet(const Image& reference, const Image& test, const SheetLabels& labels) {
  const DifferenceImage difference = differenceImage(reference, test);
  const ErrorMap map({.kind = ErrorKind::absolute,
                      .tone = {.gain = double(std::min(difference.gain, 256))},
                      .hasFalseColour = true});
  std::vector<std::uint8_t> colours(reference.rgb.size());
  map.write(reference.rgb, test.rgb, colours);
  const SheetSizes sizes(reference.height);
  const int gap = sizes.em / 2;
  const int scale = 4 * sizes.em;  // with its numbers
  Image sheet(3 * reference.width + 4 * gap + scale, reference.height + 2 * sizes.em);
  std::ranges::fill(sheet.rgb, std::uint8_t{255});
  std::ranges::fill(sheet.seen, std::uint8_t{255});
  cv::Mat3b pixels(sheet.height, sheet.width, reinterpret_cast<cv::Vec3b*>(sheet.rgb.data()));
  const int top = 3 * sizes.em / 2;
  const std::array texts{labels.reference, labels.test,
                         "error in code values, " + rounded(labels.psnr, 2) +
                             (std::isfinite(labels.psnr) ? " dB" : "")};
  const std::array<const std::vector<std::uint8_t>*, 3> pictures{&reference.rgb, &test.rgb,
                                                                 &colours};
  cv::Rect place(gap, top, reference.width, reference.height);
  for (std::size_t k = 0; k < pictures.size(); ++k) {
    write(pixels, fitting(texts[k], place.width, sizes), {place.x, sizes.em}, sizes);
    put(pixels, *pictures[k], place);
    place.x += reference.width + gap;
  }
  putScale(pixels, map, {place.x, top, gap, reference.height}, sizes);
  return sheet;
}

}  // namespace hogelscope
