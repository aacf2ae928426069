// SPDX-License-Identifier: BSD-3-Clause
#include "runs/state_images.h"

#include <algorithm>
#include <stdexcept>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/engine/streaming_renderer.h"
#include "io/files/system_limits.h"

namespace hogelscope {

namespace {

InputError tooLarge(std::size_t bytes, std::size_t memory) {
  return {"memory", "a view needs " + bytesText(bytes) + " of the light field at a time, " +
                        bytesText(memory) + " are allowed: allow more"};
}

struct StreamedView {
  std::size_t state;
  std::unique_ptr<StreamingRenderer> job;
};

/// Views whose slices fit in memory together.
class Group {
 public:
  explicit Group(std::size_t memory) : m_memory(memory) {}

  /// Adds a view. Returns false if it does not fit beside the others.
  bool add(StreamedView& passenger) {
    const StreamingRenderer& job = *passenger.job;
    const auto& lens = job.lens();
    const bool isNew = lens && std::find(m_lenses.begin(), m_lenses.end(), *lens) == m_lenses.end();
    const std::size_t bytes =
        job.bytes() + (isNew ? LensTable::bytes(lens->res, lens->samplesPerPixel) : 0);
    if (m_bytes + bytes > m_memory) {
      if (m_passengers.empty()) throw tooLarge(bytes, m_memory);
      return false;
    }
    if (isNew) m_lenses.push_back(*lens);
    m_bytes += bytes;
    m_passengers.push_back(std::move(passenger));
    return true;
  }

  [[nodiscard]] std::vector<StreamedView>& passengers() { return m_passengers; }

 private:
  std::size_t m_memory;
  std::size_t m_bytes = 0;
  std::vector<LensKey> m_lenses;
  std::vector<StreamedView> m_passengers;
};

/// Adds each state to the current group, or to a new one if it does not fit.
std::vector<Group> grouped(const std::vector<RenderJob>& views, std::size_t memory,
                           LensTables& tables, const ParallelRows& parallelRows,
                           std::vector<StateImage>& pictures, const Progress& progress) {
  std::vector<Group> groups;
  groups.emplace_back(memory);
  for (std::size_t k = 0; k < views.size(); ++k) {
    try {
      StreamedView next{
          k, std::make_unique<StreamingRenderer>(views[k], tables, parallelRows, progress)};
      if (!groups.back().add(next)) groups.emplace_back(memory).add(next);
    } catch (const InputError& error) {
      pictures[k].problem = error.what();
    } catch (const std::length_error& error) {
      pictures[k].problem = error.what();
    }
  }
  return groups;
}

/// Throws if the images, all kept until the last row, do not fit in memory.
void checkRoom(const std::vector<RenderJob>& views) {
  std::size_t bytes = 0;
  for (const RenderJob& job : views) {
    const auto [width, height] = job.state.camera.res;
    const std::size_t each = (job.bits > 8 ? Image::deepBytesPerPixel : Image::bytesPerPixel) +
                             (job.keepsUnrounded ? Image::unroundedBytesPerPixel : 0);
    bytes += each * std::size_t(width) * std::size_t(height);
  }
  if (bytes > machineMemory() / 2)
    throw InputError("cameras", "their " + std::to_string(views.size()) + " pictures need " +
                                    bytesText(bytes) + " of memory, this machine has " +
                                    bytesText(machineMemory()) +
                                    ": take fewer states, or pack the light field into a store");
}

void pass(LightFieldFile& file, std::vector<StreamedView>& passengers, const Progress& progress) {
  int current = 0;
  const auto finish = [&] {
    for (const StreamedView& passenger : passengers) passenger.job->finish(current);
  };
  file.stream(
      [&](int j, int v, const StoredRows& rgb) {
        if (j != current) finish();
        current = j;
        std::visit(
            [&](const auto* values) {
              for (const StreamedView& passenger : passengers) passenger.job->take(j, v, values);
            },
            rgb);
      },
      progress);
  finish();
}

}  // namespace

bool mustStream(const LightFieldFile& file, std::size_t memory) {
  return file.isStream() && !fitsInMemory(file, memory);
}

std::vector<StateImage> renderStreamed(LightFieldFile& file, const std::vector<RenderJob>& views,
                                       std::size_t memory, const ParallelRows& parallelRows,
                                       const Progress& progress) {
  checkRoom(views);
  std::vector<StateImage> pictures(views.size());
  LensTables tables;
  std::vector<Group> groups = grouped(views, memory, tables, parallelRows, pictures, progress);
  std::erase_if(groups, [](Group& group) { return group.passengers().empty(); });
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (const StreamedView& passenger : groups[g].passengers())
      passenger.job->begin(tables, parallelRows);
    const auto count = double(groups.size());
    pass(file, groups[g].passengers(), part(progress, double(g) / count, double(g + 1) / count));
    for (const StreamedView& passenger : groups[g].passengers())
      pictures[passenger.state].image = passenger.job->takeImage();
    groups[g].passengers().clear();
  }
  return pictures;
}

StateImages::StateImages(ViewSource unloaded, LightFieldFile& file,
                         const std::vector<CameraState>& states, const Options& options,
                         const Progress& progress)
    : m_source(std::move(unloaded)), m_states(states) {
  const auto& [use, shard, bits, keepsUnrounded, rows] = options;
  const bool isStreamed = mustStream(file, use.memory);
  if (isStreamed)
    m_source.sampling.tolerance = 0;  // no view can be probed before the texels have been read
  else
    m_source.lightField = file.source(use, progress);
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
