// SPDX-License-Identifier: BSD-3-Clause
// The images that a report compares.
#include "report/view_pairs.h"

#include <array>
#include <atomic>
#include <future>
#include <new>

#include "core/base/parallel.h"
#include "core/metrics/view_error.h"

namespace hogelscope {

ViewPairs::ViewPairs(const ReportRequest& request, std::size_t workers,
                     const ParallelRows& rowsWithin)
    : m_session(request.session),
      m_file(*request.file),
      m_isAgainstIdeal(request.isAgainstIdeal),
      m_shard(request.shard.value_or(Shard{})),
      m_memory(request.memory / 2),
      m_references(request.tests.size() > 1 ? m_session.cameras.size() : 0),
      m_renderers(workers, Renderer(rowsWithin)) {}

bool ViewPairs::streams(const LightFieldFile& file) const {
  return mustPass(file, m_memory);
}

ViewPairs::Source ViewPairs::readSource(const Session& session, LightFieldFile& file,
                                        const Progress& progress) const {
  Source source;
  if (!streams(file)) {
    source.scene = loadScene(session, file, progress,
                             {m_memory, 0, m_renderers.size() > 1 ? 1 : threadCount()});
    source.scene.bits = file.bits();
    return source;
  }
  source.scene = unloadedScene(session, file);
  source.scene.bits = file.bits();
  const std::vector<CameraState>& states = m_session.cameras;
  std::vector<RenderJob> views;
  for (std::size_t k = 0; k < states.size(); ++k)
    if (m_shard.has(k)) views.push_back(source.scene.job(states[k]));
  std::vector<StateImage> made = renderStreamed(file, views, m_memory, serialRows, progress);
  source.pictures.resize(states.size());
  for (std::size_t k = 0, next = 0; k < states.size(); ++k)
    if (m_shard.has(k)) source.pictures[k] = std::move(made[next++]);
  return source;
}

namespace {

/// What two threads have done together; where one fails the other stops.
class Halves {
 public:
  explicit Halves(const Progress& whole) : m_whole(whole) {}

  template <class Work>
  auto run(std::size_t half, Work work) {
    try {
      return work([this, half](double done) {
        m_done[half] = done;
        return !m_stops && (!m_whole || m_whole((m_done[0] + m_done[1]) / 2));
      });
    } catch (...) {
      m_stops = true;
      throw;
    }
  }

 private:
  const Progress& m_whole;
  std::array<std::atomic<double>, 2> m_done{};
  std::atomic<bool> m_stops = false;
};

}  // namespace

void ViewPairs::readSideBySide(const ReportTest& test, const Progress& progress) {
  Halves halves(progress);
  auto reading = std::async([&] {  // one after the other where no thread can be started
    return halves.run(0, [&](const Progress& half) { return readSource(m_session, m_file, half); });
  });
  try {
    m_test = halves.run(
        1, [&](const Progress& half) { return readSource(test.session, *test.file, half); });
  } catch (const Cancelled&) {
    reading.get();  // may have stopped for a better reason
    throw;
  }
  m_reference = reading.get();
}

void ViewPairs::read(const ReportTest& test, const Progress& progress) {
  m_test.reset();
  if (!m_reference && streams(m_file) && streams(*test.file)) return readSideBySide(test, progress);
  const bool isFirst = !m_reference;
  if (isFirst) {
    m_reference = readSource(m_session, m_file, part(progress, 0, 0.5));
    m_reference->scene.isIdeal = m_isAgainstIdeal;
  }
  m_test = readSource(test.session, *test.file, part(progress, isFirst ? 0.5 : 0, 1));
}

std::vector<double> ViewPairs::viewErrors(const Progress& progress) const {
  const LightFieldSource& reference = *m_reference->scene.lightField;
  const LightFieldSource& test = *m_test->scene.lightField;
  const bool areInMemory = reference.isInMemory() && test.isInMemory();
  if (m_isAgainstIdeal || !areInMemory || reference.size() != test.size()) return {};
  return hogelscope::viewErrors(*reference.overview(), *test.overview(), parallelRows, progress);
}

RenderJob ViewPairs::job(std::size_t state) const {
  return m_reference->scene.job(m_session.cameras[state]);
}

Image ViewPairs::picture(const Source& source, std::size_t state, std::size_t worker,
                         const Progress& progress) {
  if (source.pictures.empty())
    return m_renderers[worker].render(source.scene.job(m_session.cameras[state]), progress);
  const auto& [image, problem] = source.pictures[state];
  if (!problem.empty()) throw InputError(problem, "");
  return image;
}

ViewPair ViewPairs::render(std::size_t state, std::size_t worker, const Progress& progress) {
  const bool isKept = !m_references.empty() && !m_references[state].seen.empty();
  try {
    ViewPair pair{isKept ? m_references[state] : picture(*m_reference, state, worker, progress),
                  picture(*m_test, state, worker, progress),
                  {}};
    if (!m_references.empty()) m_references[state] = pair.reference;
    return pair;
  } catch (const InputError& error) {
    return {{}, {}, error.what()};
  } catch (const std::bad_alloc&) {
    return {{}, {}, "not enough memory for its picture"};
  }
}

}  // namespace hogelscope
