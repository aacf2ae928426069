// SPDX-License-Identifier: BSD-3-Clause
// The origin of a test light field's error: the squared error of its views, back-projected onto the
// hogels and directions that the pixels showed.
#pragma once

#include <cstdint>
#include <vector>

#include "core/lens/lens_table.h"
#include "core/optics/image.h"
#include "core/optics/simulate.h"

namespace hogelscope {

/// Sums over all states of one test. Every pixel seen in both images counts for the one hogel and
/// the one direction that the ray through its centre meets, regardless of light leakage,
/// interpolation and samples per pixel; a pixel whose centre meets none is not counted. Integers
/// make the result independent of the order of the states.
class PanelError {
 public:
  struct Cell {
    std::uint64_t squares = 0;  ///< Σ Δr² + Δg² + Δb² of 8-bit values, or of 16-bit ones if deep
    std::uint64_t pixels = 0;
    bool operator==(const Cell&) const = default;
  };

  /// `isDeep` selects 16-bit values, which images of more than 8 bits need.
  explicit PanelError(const LightFieldSize& size, bool isDeep = false);
  /// Takes stored sums. Throws std::invalid_argument if they do not have this size.
  PanelError(const LightFieldSize& size, std::vector<Cell> hogels, std::vector<Cell> directions,
             bool isDeep = false);

  /// Adds the images of one state. Rays are computed by the fast engine. Throws InputError as
  /// Simulation does, std::invalid_argument if sizes differ, and Cancelled; nothing is then added.
  void add(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
           const Image& reference, const Image& test, const Progress& progress = {});

  /// Adds the sums of other states. Throws std::invalid_argument if size or depth differ.
  void add(const PanelError& other);

  [[nodiscard]] const LightFieldSize& size() const { return m_size; }
  [[nodiscard]] bool isDeep() const { return m_isDeep; }
  /// Returns the values per code value: 1, or 257 for 16 bits.
  [[nodiscard]] int perCode() const { return m_isDeep ? 257 : 1; }
  /// Returns ny rows of nx cells, row 0 at the top.
  [[nodiscard]] const std::vector<Cell>& hogels() const { return m_hogels; }
  /// Returns dv rows of du cells: row 0 is light that leaves upwards, column 0 light that leaves to
  /// the left.
  [[nodiscard]] const std::vector<Cell>& directions() const { return m_directions; }

 private:
  /// The contribution and cells of each pixel of the current image. Kept as a member, because
  /// allocating memory takes longer than the sums.
  struct Pixels {
    std::vector<std::uint32_t> hogel;
    std::vector<std::uint32_t> direction;
    std::vector<std::uint64_t> squares;
  };

  LightFieldSize m_size;
  bool m_isDeep;
  std::vector<Cell> m_hogels;
  std::vector<Cell> m_directions;
  Pixels m_pixels;
};

}  // namespace hogelscope
