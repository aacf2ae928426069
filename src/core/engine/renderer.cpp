// SPDX-License-Identifier: BSD-3-Clause
// Renders views.
#include "core/engine/renderer.h"

#include <atomic>

#include "core/engine/fast_simulation.h"
#include "core/engine/scaled_view.h"

namespace hogelscope {

Choice Renderer::chooseMethod(const View& view, const Progress& progress) {
  return hogelscope::chooseMethod(view, m_tables, m_rows, progress);
}

/// One pixel for each method.scale × method.scale.
template <class AnyImage>
AnyImage Renderer::renderReduced(const View& view, const Progress& progress) {
  const FastSimulation simulation(reduced(view), m_tables, m_rows, progress);
  const auto [width, height] = simulation.rays().view().state.camera.res;
  AnyImage image(width, height);
  std::atomic<int> done = 0;
  m_rows(height, [&, width = width, height = height](int begin, int end) {
    for (int y = begin; y < end; ++y) {
      const std::size_t first = std::size_t(y) * std::size_t(width);
      simulation.row(y, 0, width, &image.rgb[3 * first], &image.seen[first]);
      reportProgress(progress, double(++done) / height);
    }
  });
  return image;
}

Image Renderer::render(const View& view, const Progress& progress) {
  const Progress heard = forThreads(progress);
  const View chosen = chooseMethod(view, heard).view;
  Image image = renderReduced<Image>(chosen, heard);
  const int scale = chosen.method.scale;
  return scale == 1 ? image : enlarged(image, scale, view.state.camera.res);
}

FloatImage Renderer::renderFloat(const View& view, const Progress& progress) {
  const Progress heard = forThreads(progress);
  const View chosen = chooseMethod(view, heard).view;
  FloatImage image = renderReduced<FloatImage>(chosen, heard);
  const int scale = chosen.method.scale;
  return scale == 1 ? image : enlarged(image, scale, view.state.camera.res);
}

}  // namespace hogelscope
