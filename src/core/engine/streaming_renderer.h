// SPDX-License-Identifier: BSD-3-Clause
// Renders a view of a light field that is streamed once, hogel row after hogel row. Only the texels
// that unfinished pixels still need are kept.
// Batches of pixels wait for the last hogel row that they read; the ring's size is known before the
// first row is read.
#pragma once

#include <optional>
#include <vector>

#include "core/engine/fast_simulation.h"

namespace hogelscope {

class StreamingRenderer {
 public:
  /// Casts all rays, but allocates no texels yet. The view's light field has nothing in memory.
  /// `progress` is passed to FastSimulation. Throws InputError, as Simulation does,
  /// std::length_error for a slice beyond 2^32 texels, and Cancelled, as begin() and finish() do.
  StreamingRenderer(const RenderJob& job, LensTables& tables, const ParallelRows& parallelRows,
                    const Progress& progress = {});

  /// Returns the bytes of the texels that are kept at a time.
  [[nodiscard]] std::size_t bytes() const;
  /// Returns the lens whose table of rays is kept as well; none for a plain lens.
  [[nodiscard]] const std::optional<LensKey>& lens() const { return m_lens; }
  [[nodiscard]] const Footprint& footprint() const { return m_slice.footprint; }

  /// Allocates the memory. Must be called before take().
  void begin(LensTables& tables, const ParallelRows& parallelRows);
  /// Takes directions (·, v) of hogels (·, j), a row of the hogel image; T is the stored type. Rows
  /// of hogels must come from the top.
  template <class T>
  void take(int j, int v, const T* rgb) {
    const CellRange& needed = m_slice.footprint.v[std::size_t(j)];
    if (needed.first <= v && v <= needed.last) m_texels->takeRow(j, v, rgb);
  }
  /// Renders the pixels that hogel row j completes; the whole row must have been taken.
  void finish(int j);
  /// Returns the image after the last row, and frees the memory.
  [[nodiscard]] Image takeImage();

 private:
  RenderJob m_job;
  Progress m_progress;
  std::optional<LensKey> m_lens;
  SliceLayout m_slice;
  std::vector<std::vector<PixelRun>> m_due;  ///< pieces that hogel row j completes
  std::shared_ptr<LightField> m_texels;
  std::optional<FastSimulation> m_simulation;
  Image m_image;
};

}  // namespace hogelscope
