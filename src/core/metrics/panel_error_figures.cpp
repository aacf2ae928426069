// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/panel_error_figures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "core/base/colour_map.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

using Cells = std::vector<PanelError::Cell>;

/// Returns the share of the non-empty cells that hold half of the squares.
double halfShare(Cells cells) {
  std::erase_if(cells, [](const PanelError::Cell& cell) { return cell.pixels == 0; });
  std::ranges::sort(cells, std::greater{}, &PanelError::Cell::squares);
  std::uint64_t total = 0;
  for (const PanelError::Cell& cell : cells) total += cell.squares;
  std::uint64_t sum = 0;
  std::size_t count = 0;
  while (sum < total - total / 2) sum += cells[count++].squares;
  return count == 0 ? 0 : double(count) / double(cells.size());
}

std::array<int, 2> costliest(const Cells& cells, int columns) {
  const auto found = std::ranges::max_element(cells, {}, &PanelError::Cell::squares);
  const auto at = int(found - cells.begin());
  return {at % columns, at / columns};
}

double degreesOf(double slope) {
  return std::atan(slope) * 180 / std::numbers::pi;
}

/// Formats an angle, such as "12.0° right" for 12.
std::string angleText(double degrees, const char* negative, const char* positive) {
  return rounded(std::abs(degrees), 1) + "° " + (degrees < 0 ? negative : positive);
}

std::string percent(double share) {
  return rounded(100 * share, share < 0.1 ? 1 : 0) + " %";
}

/// Returns a cell's size in pixels: integers as close to `shape` as possible.
std::array<int, 2> blockOf(const std::array<int, 2>& cells, const std::array<double, 2>& shape) {
  constexpr double least = 256;
  const double wanted = least / std::max(shape[0], shape[1]);
  const std::size_t dense = cells[0] * shape[1] >= cells[1] * shape[0] ? 0 : 1;
  const std::size_t other = 1 - dense;
  std::array<int, 2> block{};
  block[dense] = std::max(1, int(std::ceil(wanted * shape[dense] / cells[dense] - 1e-9)));
  const double scale = block[dense] * cells[dense] / shape[dense];
  const double largest = std::ceil(2 * least / cells[other]);  // limits extreme shapes
  block[other] = int(std::clamp(std::round(scale * shape[other] / cells[other]), 1.0, largest));
  return block;
}

/// Returns an image with a block of each cell's colour.
Image picture(const std::vector<double>& shares, const std::array<int, 2>& count,
              const std::array<double, 2>& shape) {
  const auto [blockWidth, blockHeight] = blockOf(count, shape);
  Image image(count[0] * blockWidth, count[1] * blockHeight);
  std::fill(image.seen.begin(), image.seen.end(), std::uint8_t{255});
  std::size_t at = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto cell =
          std::size_t(y / blockHeight) * std::size_t(count[0]) + std::size_t(x / blockWidth);
      for (const std::uint8_t value : falseColour(shares[cell])) image.rgb[at++] = value;
    }
  return image;
}

std::vector<double> meansOf(const Cells& cells, int perCode) {
  std::vector<double> means;
  for (const PanelError::Cell& cell : cells) means.push_back(meanSquare(cell, perCode));
  return means;
}

/// Returns the cells' positions on the scale, starting at 0.
std::vector<double> sharesOf(const Cells& cells, int perCode) {
  std::vector<double> shares = meansOf(cells, perCode);
  const double end = scaleEndOf(shares);
  if (end > 0)
    for (double& share : shares) share /= end;
  return shares;
}

}  // namespace

double meanSquare(const PanelError::Cell& cell, int perCode) {
  const double each = 3 * double(perCode) * perCode;
  return double(cell.squares) / (each * double(cell.pixels));  // 0/0 is NaN
}

double scaleEndOf(std::vector<double> means) {
  std::erase_if(means, [](double mean) { return std::isnan(mean); });
  if (means.empty()) return 0;
  std::sort(means.begin(), means.end());
  const double end = means[std::size_t(std::ceil(0.99 * double(means.size()))) - 1];
  return end > 0 ? end : means.back();
}

double scaleEnd(const Cells& cells, int perCode) {
  return scaleEndOf(meansOf(cells, perCode));
}

PanelErrorFigures figuresOf(const PanelError& error, const PanelParams& display) {
  PanelErrorFigures figures;
  figures.hogelScale = scaleEnd(error.hogels(), error.perCode());
  figures.directionScale = scaleEnd(error.directions(), error.perCode());
  figures.hogelShare = halfShare(error.hogels());
  figures.directionShare = halfShare(error.directions());
  figures.hogel = costliest(error.hogels(), error.size().nx);
  const auto [u, v] = costliest(error.directions(), error.size().du);
  const Vec2 slopes = Display(display).slopes(u + 0.5, v + 0.5);
  figures.direction = {degreesOf(slopes.x), degreesOf(slopes.y)};
  return figures;
}

std::string panelErrorText(const PanelErrorFigures& figures) {
  if (!(figures.hogelShare > 0)) return "No pixel seen in both pictures differs.";
  return "Half of the squared error comes from " + percent(figures.hogelShare) +
         " of the hogels seen and from " + percent(figures.directionShare) +
         " of the directions seen; the costliest hogel is (" + std::to_string(figures.hogel[0]) +
         ", " + std::to_string(figures.hogel[1]) + "), the costliest direction is " +
         angleText(figures.direction.x, "left", "right") + ", " +
         angleText(figures.direction.y, "down", "up") + ".";
}

std::vector<float> meanSquares(const Cells& cells, int perCode) {
  std::vector<float> plane;
  for (const PanelError::Cell& cell : cells)
    plane.push_back(static_cast<float>(meanSquare(cell, perCode)));
  return plane;
}

std::vector<float> pixelCounts(const Cells& cells) {
  std::vector<float> plane;
  for (const PanelError::Cell& cell : cells) plane.push_back(static_cast<float>(cell.pixels));
  return plane;
}

Image hogelErrorImage(const PanelError& error, const PanelParams& display) {
  return picture(sharesOf(error.hogels(), error.perCode()), display.hogels, display.size);
}

Image directionErrorImage(const PanelError& error, const PanelParams& display) {
  return directionImage(sharesOf(error.directions(), error.perCode()), display);
}

Image directionImage(const std::vector<double>& shares, const PanelParams& display) {
  return picture(shares, display.directions, display.fov);
}

}  // namespace hogelscope
