// SPDX-License-Identifier: BSD-3-Clause
// Where a test light field's error comes from: the squared error of its views, thrown back onto the
// hogels and the directions that the pixels showed.
#pragma once

#include <cstdint>
#include <vector>

#include "core/lens/lens_table.h"
#include "core/optics/image.h"
#include "core/optics/simulate.h"

namespace hogelscope {

/// Sums over all states of one test. Every pixel seen in both images counts for the one hogel and
/// the one direction that the ray through its centre meets; light leakage, interpolation and
/// several samples per pixel change nothing of that, and a pixel whose centre meets none counts
/// nowhere. Whole numbers, so that the order of the states does not matter.
class PanelError {
 public:
  struct Cell {
    std::uint64_t squares = 0;  ///< Σ Δr² + Δg² + Δb² of 8-bit values, or of 16-bit ones
    std::uint64_t pixels = 0;
    bool operator==(const Cell&) const = default;
  };

  /// `isDeep`: of 16-bit values, as images of more than 8 bits need.
  explicit PanelError(const LightFieldSize& size, bool isDeep = false);
  /// From sums that were kept. Throws std::invalid_argument where they are not of this size.
  PanelError(const LightFieldSize& size, std::vector<Cell> hogels, std::vector<Cell> directions,
             bool isDeep = false);

  /// Adds the images of one state. Rays are the fast engine's. Throws InputError as Simulation
  /// does, std::invalid_argument where a size is another, Cancelled: then nothing is added.
  void add(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
           const Image& reference, const Image& test, const Progress& progress = {});

  /// Adds the sums of other states. Throws std::invalid_argument where they are not of this size
  /// and depth.
  void add(const PanelError& other);

  [[nodiscard]] const LightFieldSize& size() const { return m_size; }
  [[nodiscard]] bool isDeep() const { return m_isDeep; }
  /// The values in a code value: 1, or 257 of 16 bits.
  [[nodiscard]] int perCode() const { return m_isDeep ? 257 : 1; }
  /// ny rows of nx, row 0 the top.
  [[nodiscard]] const std::vector<Cell>& hogels() const { return m_hogels; }
  /// dv rows of du, row 0 the light that leaves upwards, column 0 the light that leaves to the
  /// left.
  [[nodiscard]] const std::vector<Cell>& directions() const { return m_directions; }

 private:
  /// What each pixel of the image in hand adds, and where; kept, since new memory costs more time
  /// than the sums.
  struct Pixels {
    std::vector<std::uint32_t> hogel;
    std::vector<std::uint32_t> direction;
    std::vector<std::uint64_t> squares;
  };

  void resize(std::size_t pixels);

  LightFieldSize m_size;
  bool m_isDeep;
  std::vector<Cell> m_hogels;
  std::vector<Cell> m_directions;
  Pixels m_pixels;
};

}  // namespace hogelscope
