// SPDX-License-Identifier: BSD-3-Clause
#include "report/panel_projection.h"

#include <algorithm>

#include "io/documents/panel_error_file.h"

namespace hogelscope {

PanelProjection::PanelProjection(std::filesystem::path file, std::string key,
                                 const LightFieldSize& size, bool isDeep)
    : m_file(std::move(file)), m_key(std::move(key)), m_error(size, isDeep) {
  if (auto saved = loadPanelError(m_file, m_key, size, isDeep)) {
    m_states = std::move(saved->states);
    m_error = std::move(saved->error);
  }
}

void PanelProjection::add(std::size_t state, std::size_t worker, const ViewPair& pair,
                          ViewPairs& pairs, const Progress& progress) {
  constexpr std::chrono::seconds pause{5};  // lost by kill -9; later states are repeated
  const std::lock_guard lock(m_mutex);
  Renderer& renderer = pairs.renderer(worker);
  if (pair.problem.empty())
    m_error.add(pairs.job(state), renderer.tables(), renderer.rows(), pair.reference, pair.test,
                progress);
  m_states.insert(state);
  if (std::chrono::steady_clock::now() - m_saved > pause) save();
}

void PanelProjection::save() {
  savePanelError(m_file, m_key, {m_states, m_error});
  m_saved = std::chrono::steady_clock::now();
}

void PanelProjection::join(const std::filesystem::path& file) {
  const auto saved = loadPanelError(file, m_key, m_error.size(), m_error.isDeep());
  if (!saved) return;
  const auto isThere = [this](std::size_t state) { return has(state); };
  if (std::ranges::any_of(saved->states, isThere)) return;
  m_error.add(saved->error);
  m_states.insert(saved->states.begin(), saved->states.end());
}

void PanelProjection::remove() {
  std::error_code ignored;
  std::filesystem::remove(m_file, ignored);
}

}  // namespace hogelscope
