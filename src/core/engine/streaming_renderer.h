// SPDX-License-Identifier: BSD-3-Clause
// A picture of a light field that passes by once, hogel row after hogel row: of the rows that have
// come only what the pixels still to be made need is kept.
#pragma once

#include <optional>
#include <vector>

#include "core/engine/fast_simulation.h"

namespace hogelscope {

class StreamingRenderer {
 public:
  /// Casts all rays, but keeps no texels yet. The view's light field has nothing in memory.
  /// `progress` is FastSimulation's. Throws InputError, as Simulation does, std::length_error for a
  /// slice beyond 2^32 texels, and Cancelled, as begin() and finish() do.
  StreamingRenderer(const View& view, LensTables& tables, const ParallelRows& parallelRows,
                    const Progress& progress = {});

  /// Of the texels that are kept at a time.
  [[nodiscard]] std::size_t bytes() const;
  /// Whose table of rays is kept as well; none for a plain lens.
  [[nodiscard]] const std::optional<LensKey>& lens() const { return m_lens; }
  [[nodiscard]] const Footprint& footprint() const { return m_slice.footprint; }

  /// Takes the memory; then rows can come.
  void begin(LensTables& tables, const ParallelRows& parallelRows);
  /// Directions (·, v) of hogels (·, j): a row of the hogel image, T the stored type. Rows of
  /// hogels come from the top.
  template <class T>
  void take(int j, int v, const T* rgb) {
    const CellRange& needed = m_slice.footprint.v[std::size_t(j)];
    if (needed.first <= v && v <= needed.last) m_texels->takeRow(j, v, rgb);
  }
  /// All of hogel row j has come: makes the pixels that waited for it.
  void finish(int j);
  /// After the last row; the memory is free again.
  [[nodiscard]] Image takeImage();

 private:
  /// Pixels [x0, x1) of row y.
  struct Piece {
    int y = 0;
    int x0 = 0;
    int x1 = 0;
  };

  View m_view;
  Progress m_progress;
  std::optional<LensKey> m_lens;
  SliceLayout m_slice;
  std::vector<std::vector<Piece>> m_due;  ///< when hogel row j has come
  std::shared_ptr<LightField> m_texels;
  std::optional<FastSimulation> m_simulation;
  Image m_image;
};

}  // namespace hogelscope
