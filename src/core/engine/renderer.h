// SPDX-License-Identifier: BSD-3-Clause
// Renders views. Only this class resolves sampling.tolerance, the method and its scale.
#pragma once

#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/engine/adaptive_method.h"
#include "core/lens/lens_table.h"
#include "core/optics/image.h"

namespace hogelscope {

/// Renders views, and keeps lens tables between them. Not thread-safe.
class Renderer {
 public:
  /// `rows` distributes the rows of an image over threads.
  explicit Renderer(ParallelRows rows = parallelRows) : m_rows(std::move(rows)) {}

  /// Returns the view that render() uses in place of one with a tolerance, see chooseMethod() in
  /// adaptive_method.h. Throws as render() does.
  [[nodiscard]] Choice chooseMethod(const RenderJob& job, const Progress& progress = {});

  /// Renders the image of the view's camera. `progress` is called from any thread with the fraction
  /// of the rows done, never concurrently. Throws InputError as Simulation and
  /// LightFieldSource::slice() do, and Cancelled.
  [[nodiscard]] Image render(const RenderJob& job, const Progress& progress = {});
  /// Renders the same image without rounding.
  [[nodiscard]] FloatImage renderFloat(const RenderJob& job, const Progress& progress = {});
  /// Writes what render() or renderFloat() returns into memory of 3·width·height values and of
  /// width·height for the mask, whatever they hold before. `Value` is std::uint8_t, for a job of 8
  /// bits, or float.
  template <class Value>
  void renderInto(const RenderJob& job, Value* rgb, std::uint8_t* seen,
                  const Progress& progress = {});

  [[nodiscard]] LensTables& tables() { return m_tables; }
  [[nodiscard]] const ParallelRows& rows() const { return m_rows; }

 private:
  template <class AnyImage>
  [[nodiscard]] AnyImage renderChosen(const RenderJob& chosen, const Progress& progress);
  template <class Value>
  void renderRows(const RenderJob& job, Value* rgb, std::uint8_t* seen, const Progress& progress);

  ParallelRows m_rows;
  LensTables m_tables;
};

}  // namespace hogelscope
