// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/panel_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/base/multiversioned.h"
#include "core/engine/hogel_pixels.h"

namespace hogelscope {

namespace {

/// The index of a pixel that counts for no cell.
constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

std::size_t product(int a, int b) {
  return std::size_t(a) * std::size_t(b);
}

MULTIVERSIONED
void squaredDifferences(const std::uint8_t* a, const std::uint8_t* b, std::size_t count,
                        std::uint64_t* __restrict squares) {
  for (std::size_t k = 0; k < count; ++k) {
    const int red = a[3 * k] - b[3 * k];
    const int green = a[3 * k + 1] - b[3 * k + 1];
    const int blue = a[3 * k + 2] - b[3 * k + 2];
    squares[k] = static_cast<std::uint32_t>(red * red + green * green + blue * blue);
  }
}

/// Computes the squared differences of 16-bit values.
void squaredDifferences(const Image& a, const Image& b, std::size_t from, std::size_t count,
                        std::uint64_t* squares) {
  std::vector<double> valuesA(3 * count);
  std::vector<double> valuesB(3 * count);
  readCodeValues(a, 3 * from, valuesA);
  readCodeValues(b, 3 * from, valuesB);
  std::fill_n(squares, count, 0U);
  for (std::size_t k = 0; k < valuesA.size(); ++k) {
    const std::int64_t difference = std::llround(257 * valuesA[k]) - std::llround(257 * valuesB[k]);
    squares[k / 3] += static_cast<std::uint64_t>(difference * difference);
  }
}

/// Computes row-major cell indices along two axes of a batch; `nowhere` for pixels not seen by all.
MULTIVERSIONED
void cellIndices(const CellBatch& batch, std::size_t axis, int columns, const std::uint8_t* seenA,
                 const std::uint8_t* seenB, int count, std::uint32_t* __restrict at) {
  const std::uint32_t* column = batch.cell[axis].data();
  const std::uint32_t* row = batch.cell[axis + 1].data();
  const std::uint8_t* seen = batch.seen.data();
  const auto width = static_cast<std::uint32_t>(columns);
  for (int k = 0; k < count; ++k) {
    const bool counts = (seen[k] & seenA[k] & seenB[k]) != 0;
    at[k] = counts ? row[k] * width + column[k] : nowhere;
  }
}

/// Adds squares to cells. Neighbours that meet one cell are summed first, so it is written once.
void addTo(std::vector<PanelError::Cell>& cells, const std::vector<std::uint32_t>& at,
           const std::vector<std::uint64_t>& squares) {
  for (std::size_t k = 0; k < at.size();) {
    const std::uint32_t index = at[k];
    PanelError::Cell sum;
    for (; k < at.size() && at[k] == index; ++k) {
      sum.squares += squares[k];
      ++sum.pixels;
    }
    if (index == nowhere) continue;
    cells[index].squares += sum.squares;
    cells[index].pixels += sum.pixels;
  }
}

void checkSizes(const RenderJob& job, const LightFieldSize& size, const Image& reference,
                const Image& test) {
  const auto [width, height] = job.state.camera.res;
  for (const Image* image : {&reference, &test})
    if (image->width != width || image->height != height)
      throw std::invalid_argument("PanelError: a picture is not of the state's size");
  if (Display(job.display).size() != size)
    throw std::invalid_argument("PanelError: a display of another size");
}

}  // namespace

PanelError::PanelError(const LightFieldSize& size, bool isDeep)
    : m_size(size),
      m_isDeep(isDeep),
      m_hogels(product(size.nx, size.ny)),
      m_directions(product(size.du, size.dv)) {}

PanelError::PanelError(const LightFieldSize& size, std::vector<Cell> hogels,
                       std::vector<Cell> directions, bool isDeep)
    : m_size(size),
      m_isDeep(isDeep),
      m_hogels(std::move(hogels)),
      m_directions(std::move(directions)) {
  if (m_hogels.size() != product(size.nx, size.ny) ||
      m_directions.size() != product(size.du, size.dv))
    throw std::invalid_argument("PanelError: sums of another size");
}

void PanelError::add(const PanelError& other) {
  if (other.m_size != m_size || other.m_isDeep != m_isDeep)
    throw std::invalid_argument("PanelError: sums of another size or depth");
  const auto sum = [](const Cell& a, const Cell& b) {
    return Cell{a.squares + b.squares, a.pixels + b.pixels};
  };
  std::ranges::transform(m_hogels, other.m_hogels, m_hogels.begin(), sum);
  std::ranges::transform(m_directions, other.m_directions, m_directions.begin(), sum);
}

void PanelError::add(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
                     const Image& reference, const Image& test, const Progress& progress) {
  checkSizes(job, m_size, reference, test);
  const ViewRays rays(middleRays(job), tables, parallelRows, progress);
  for (auto* list : {&m_pixels.hogel, &m_pixels.direction}) list->resize(reference.pixelCount());
  m_pixels.squares.resize(reference.pixelCount());
  const auto batchAt = [&](int y, int x0, int count) {
    CellBatch batch;
    rays.cells(y, x0, count, {}, batch);
    const std::size_t at = product(y, reference.width) + std::size_t(x0);
    const std::uint8_t* seenA = &reference.seen[at];
    const std::uint8_t* seenB = &test.seen[at];
    cellIndices(batch, 0, m_size.nx, seenA, seenB, count, &m_pixels.hogel[at]);
    cellIndices(batch, 2, m_size.du, seenA, seenB, count, &m_pixels.direction[at]);
    if (m_isDeep)
      squaredDifferences(reference, test, at, std::size_t(count), &m_pixels.squares[at]);
    else
      squaredDifferences(&reference.rgb[3 * at], &test.rgb[3 * at], std::size_t(count),
                         &m_pixels.squares[at]);
  };
  parallelRows(reference.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < reference.width; x += batchSize)
        batchAt(y, x, std::min(batchSize, reference.width - x));
  });
  // Runs on this thread only, because pixels of many rows meet one cell.
  addTo(m_hogels, m_pixels.hogel, m_pixels.squares);
  addTo(m_directions, m_pixels.direction, m_pixels.squares);
}

}  // namespace hogelscope
