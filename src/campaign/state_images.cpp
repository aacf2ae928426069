// SPDX-License-Identifier: BSD-3-Clause
#include "campaign/state_images.h"

#include "core/base/error.h"

namespace hogelscope {

StateImages::StateImages(const Session& session, LightFieldFile& file,
                         const std::vector<CameraState>& states, const Options& options,
                         const Progress& progress)
    : m_states(states) {
  const auto& [use, shard, bits, keepsUnrounded, rows] = options;
  const bool isStreamed = mustStream(file, use.memory);
  m_source =
      isStreamed ? unloadedViewSource(session, file) : loadViewSource(session, file, progress, use);
  m_source.bits = bits;
  m_source.keepsUnrounded = keepsUnrounded;
  if (!isStreamed) return;
  std::vector<RenderJob> views;
  for (std::size_t k = 0; k < states.size(); ++k)
    if (shard.has(k)) views.push_back(job(k));
  std::vector<StateImage> made = renderStreamed(file, views, use.memory, rows, progress);
  m_streamed.resize(states.size());
  for (std::size_t k = 0, next = 0; k < states.size(); ++k)
    if (shard.has(k)) m_streamed[k] = std::move(made[next++]);
}

Image StateImages::render(std::size_t state, Renderer& renderer, const Progress& progress) const {
  if (!areStreamed()) return renderer.render(job(state), progress);
  const auto& [image, problem] = m_streamed[state];
  if (!problem.empty()) throw InputError(problem, "");
  return image;
}

}  // namespace hogelscope
