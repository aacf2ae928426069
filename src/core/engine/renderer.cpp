// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/renderer.h"

#include <atomic>

#include "core/engine/fast_simulation.h"
#include "core/engine/ideal_view.h"
#include "core/engine/scaled_view.h"

namespace hogelscope {

Choice Renderer::chooseMethod(const RenderJob& job, const Progress& progress) {
  return hogelscope::chooseMethod(job, m_tables, m_rows, progress);
}

/// Renders one pixel for each method.scale × method.scale, and enlarges the image.
template <class AnyImage>
AnyImage Renderer::renderChosen(const RenderJob& job, const Progress& progress) {
  const Progress heard = forThreads(progress);
  const RenderJob chosen = chooseMethod(job, heard).job;
  const FastSimulation simulation(reduced(chosen), m_tables, m_rows, heard);
  const auto [width, height] = simulation.rays().job().state.camera.res;
  AnyImage image(width, height);
  std::atomic<int> done = 0;
  m_rows(height, [&, width = width, height = height](int begin, int end) {
    const std::size_t first = std::size_t(begin) * std::size_t(width);
    simulation.rows(begin, end, 0, width, &image.rgb[3 * first], &image.seen[first]);
    reportProgress(heard, double(done += end - begin) / height);
  });
  const int scale = chosen.method.scale;
  return scale == 1 ? image : enlarged(image, scale, job.state.camera.res);
}

Image Renderer::render(const RenderJob& job, const Progress& progress) {
  if (job.isIdeal || job.bits > 8 || job.keepsUnrounded)
    return rounded(renderFloat(job, progress), job.bits, job.keepsUnrounded);
  return renderChosen<Image>(job, progress);
}

FloatImage Renderer::renderFloat(const RenderJob& job, const Progress& progress) {
  return job.isIdeal ? renderIdeal(job, m_tables, m_rows, progress)
                     : renderChosen<FloatImage>(job, progress);
}

}  // namespace hogelscope
