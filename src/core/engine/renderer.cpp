// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/renderer.h"

#include <algorithm>
#include <atomic>
#include <type_traits>

#include "core/engine/fast_simulation.h"
#include "core/engine/ideal_view.h"
#include "core/engine/scaled_view.h"

namespace hogelscope {

Choice Renderer::chooseMethod(const RenderJob& job, const Progress& progress) {
  return hogelscope::chooseMethod(job, m_tables, m_rows, progress);
}

template <class Value>
void Renderer::renderRows(const RenderJob& job, Value* rgb, std::uint8_t* seen,
                          const Progress& progress) {
  const FastSimulation simulation(job, m_tables, m_rows, progress);
  const auto [width, height] = job.state.camera.res;
  std::atomic<int> done = 0;
  m_rows(height, [&, width = width, height = height](int begin, int end) {
    const std::size_t first = std::size_t(begin) * std::size_t(width);
    simulation.rows(begin, end, 0, width, rgb + 3 * first, seen + first);
    reportProgress(progress, double(done += end - begin) / height);
  });
}

/// Renders one pixel for each method.scale × method.scale, and enlarges the image.
template <class AnyImage>
AnyImage Renderer::renderChosen(const RenderJob& chosen, const Progress& progress) {
  const RenderJob small = reduced(chosen);
  const auto [width, height] = small.state.camera.res;
  AnyImage image(width, height);
  renderRows(small, image.rgb.data(), image.seen.data(), progress);
  const int scale = chosen.method.scale;
  return scale == 1 ? image : enlarged(image, scale, chosen.state.camera.res);
}

Image Renderer::render(const RenderJob& job, const Progress& progress) {
  if (job.isIdeal || job.bits > 8 || job.keepsUnrounded)
    return rounded(renderFloat(job, progress), job.bits, job.keepsUnrounded);
  const Progress heard = forThreads(progress);
  return renderChosen<Image>(chooseMethod(job, heard).job, heard);
}

FloatImage Renderer::renderFloat(const RenderJob& job, const Progress& progress) {
  if (job.isIdeal) return renderIdeal(job, m_tables, m_rows, progress);
  const Progress heard = forThreads(progress);
  return renderChosen<FloatImage>(chooseMethod(job, heard).job, heard);
}

template <class Value>
void Renderer::renderInto(const RenderJob& job, Value* rgb, std::uint8_t* seen,
                          const Progress& progress) {
  const auto copy = [&](const auto& image) {
    std::ranges::copy(image.rgb, rgb);
    std::ranges::copy(image.seen, seen);
  };
  const Progress heard = forThreads(progress);
  const RenderJob chosen = job.isIdeal ? job : chooseMethod(job, heard).job;
  if (!chosen.isIdeal && chosen.method.scale == 1) return renderRows(chosen, rgb, seen, heard);
  if constexpr (std::is_same_v<Value, float>)
    copy(renderFloat(chosen, heard));
  else
    copy(render(chosen, heard));
}

template void Renderer::renderInto(const RenderJob&, std::uint8_t*, std::uint8_t*, const Progress&);
template void Renderer::renderInto(const RenderJob&, float*, std::uint8_t*, const Progress&);

}  // namespace hogelscope
