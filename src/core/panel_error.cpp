// SPDX-License-Identifier: BSD-3-Clause
// The squared error of views, thrown back onto the panel.
#include "core/panel_error.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/fast_simulation.h"

namespace hogelscope {

namespace {

/// In place of a cell: the pixel counts nowhere.
constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

std::size_t product(int a, int b) {
  return std::size_t(a) * std::size_t(b);
}

/// One exact ray through each pixel's centre, whatever the picture was made of.
View raysThroughCentres(View view) {
  view.sampling.samplesPerPixel = 1;
  view.method = {};
  return view;
}

std::uint32_t squaredDifference(const std::uint8_t* a, const std::uint8_t* b) {
  const int red = a[0] - b[0];
  const int green = a[1] - b[1];
  const int blue = a[2] - b[2];
  return static_cast<std::uint32_t>(red * red + green * green + blue * blue);
}

void addTo(std::vector<PanelError::Cell>& cells, const std::vector<std::uint32_t>& at,
           const std::vector<std::uint32_t>& squares) {
  for (std::size_t k = 0; k < at.size(); ++k) {
    if (at[k] == nowhere) continue;
    PanelError::Cell& cell = cells[at[k]];
    cell.squares += squares[k];
    ++cell.pixels;
  }
}

void checkSizes(const View& view, const LightFieldSize& size, const Image& reference,
                const Image& test) {
  const auto [width, height] = view.state.camera.res;
  for (const Image* image : {&reference, &test})
    if (image->width != width || image->height != height)
      throw std::invalid_argument("PanelError: a picture is not of the state's size");
  if (Display(view.display).size() != size)
    throw std::invalid_argument("PanelError: a display of another size");
}

}  // namespace

PanelError::PanelError(const LightFieldSize& size)
    : m_size(size), m_hogels(product(size.nx, size.ny)), m_directions(product(size.du, size.dv)) {}

PanelError::PanelError(const LightFieldSize& size, std::vector<Cell> hogels,
                       std::vector<Cell> directions)
    : m_size(size), m_hogels(std::move(hogels)), m_directions(std::move(directions)) {
  if (m_hogels.size() != product(size.nx, size.ny) ||
      m_directions.size() != product(size.du, size.dv))
    throw std::invalid_argument("PanelError: sums of another size");
}

void PanelError::resize(std::size_t pixels) {
  for (auto* list : {&m_pixels.hogel, &m_pixels.direction, &m_pixels.squares}) list->resize(pixels);
}

void PanelError::add(const View& view, LensTables& tables, const ParallelRows& parallelRows,
                     const Image& reference, const Image& test) {
  checkSizes(view, m_size, reference, test);
  const FastSimulation rays(raysThroughCentres(view), tables, parallelRows);
  const auto columns = static_cast<std::uint32_t>(m_size.nx);
  const auto angles = static_cast<std::uint32_t>(m_size.du);
  resize(reference.pixelCount());
  const auto batchAt = [&](int y, int x0, int count) {
    CellBatch batch;
    rays.cells(y, x0, count, 0, 0, batch);
    const std::size_t first = product(y, reference.width) + std::size_t(x0);
    for (std::size_t k = 0; k < std::size_t(count); ++k) {
      const std::size_t at = first + k;
      const bool counts = (batch.seen[k] != 0) & (reference.seen[at] != 0) & (test.seen[at] != 0);
      m_pixels.hogel[at] = counts ? batch.cell[1][k] * columns + batch.cell[0][k] : nowhere;
      m_pixels.direction[at] = counts ? batch.cell[3][k] * angles + batch.cell[2][k] : nowhere;
      m_pixels.squares[at] = squaredDifference(&reference.rgb[3 * at], &test.rgb[3 * at]);
    }
  };
  parallelRows(reference.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < reference.width; x += batchSize)
        batchAt(y, x, std::min(batchSize, reference.width - x));
  });
  // On this thread: pixels of many rows meet one cell.
  addTo(m_hogels, m_pixels.hogel, m_pixels.squares);
  addTo(m_directions, m_pixels.direction, m_pixels.squares);
}

}  // namespace hogelscope
