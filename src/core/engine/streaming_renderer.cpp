// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/streaming_renderer.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <utility>

#include "core/engine/view_rays.h"

namespace hogelscope {

namespace {

/// Returns the rows of hogels that a piece of an image reads.
CellRange hogelRows(const Footprint& footprint) {
  const auto& v = footprint.v;
  const auto isNeeded = [](const CellRange& range) { return !range.isEmpty(); };
  const auto first = std::find_if(v.begin(), v.end(), isNeeded);
  if (first == v.end()) return {};
  const auto last = std::find_if(v.rbegin(), v.rend(), isNeeded);
  return {int(first - v.begin()), int(v.rend() - last) - 1};
}

}  // namespace

StreamingRenderer::StreamingRenderer(const RenderJob& job, LensTables& tables,
                                     const ParallelRows& parallelRows, const Progress& progress)
    : m_job(job), m_progress(progress), m_due(std::size_t(job.lightField->size().ny)) {
  const ViewRays rays(job, tables, parallelRows, progress);
  if (rays.lens() != nullptr) m_lens = rays.lensKey();
  const auto [width, height] = job.state.camera.res;
  Footprint all(job.lightField->size().nx, job.lightField->size().ny);
  std::vector<int> lastUse(m_due.size());
  std::mutex mutex;
  const auto add = [&](const PixelRun& piece) {
    const Footprint read = rays.footprint(piece.y, piece.x0, piece.x1);
    const CellRange rows = hogelRows(read);
    if (rows.isEmpty()) return;
    const std::lock_guard lock(mutex);
    all.include(read);
    m_due[std::size_t(rows.last)].push_back(piece);
    int& used = lastUse[std::size_t(rows.first)];
    used = std::max(used, rows.last);
  };
  parallelRows(height, [&, width = width](int begin, int end) {
    for (int y = begin; y < end; ++y)
      for (int x = 0; x < width; x += batchSize) add({y, x, std::min(x + batchSize, width)});
  });
  m_slice = rollingLayout(all, lastUse);
}

std::size_t StreamingRenderer::bytes() const {
  return std::size_t(m_slice.texels) * memoryBytes(m_job.lightField->type());
}

void StreamingRenderer::begin(LensTables& tables, const ParallelRows& parallelRows) {
  m_texels =
      std::make_shared<LightField>(m_job.lightField->size(), m_job.lightField->type(), m_slice);
  RenderJob job = m_job;
  job.lightField = m_texels;
  m_simulation.emplace(job, tables, parallelRows, m_progress);
  const auto [width, height] = m_job.state.camera.res;
  m_image = Image(width, height, m_job.bits, m_job.keepsUnrounded);
}

void StreamingRenderer::finish(int j) {
  for (const auto& [y, x0, x1] : m_due[std::size_t(j)]) {
    const std::size_t at = std::size_t(y) * std::size_t(m_image.width) + std::size_t(x0);
    if (m_job.bits == 8 && !m_job.keepsUnrounded) {
      m_simulation->rows(y, y + 1, x0, x1, &m_image.rgb[3 * at], &m_image.seen[at]);
      continue;
    }
    std::array<float, std::size_t{3} * batchSize> values{};
    m_simulation->rows(y, y + 1, x0, x1, values.data(), &m_image.seen[at]);
    setValues(m_image, 3 * at, std::span(values).first(3 * std::size_t(x1 - x0)));
  }
}

Image StreamingRenderer::takeImage() {
  m_simulation.reset();
  m_texels.reset();
  return std::move(m_image);
}

}  // namespace hogelscope
