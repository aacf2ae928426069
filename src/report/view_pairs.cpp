// SPDX-License-Identifier: BSD-3-Clause
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
    : m_own{"", request.session, request.file},
      m_isAgainstIdeal(request.isAgainstIdeal),
      m_keepsUnrounded(request.metrics.readUnrounded()),
      m_shard(request.shard.value_or(Shard{})),
      m_memory(request.memory / 2),
      m_references(request.tests.size() > 1 ? m_own.session.cameras.size() : 0),
      m_renderers(workers, Renderer(rowsWithin)) {}

StateImages ViewPairs::imagesOf(const ReportTest& one, const Progress& progress) const {
  const auto& [name, session, file, order, unloaded] = one;
  return {unloaded ? *unloaded : unloadedViewSource(session, *file, progress),
          *file,
          m_own.session.cameras,
          {.use = {m_memory, 0, m_renderers.size() > 1 ? 1 : threadCount()},
           .shard = m_shard,
           .bits = file->bits(),
           .keepsUnrounded = m_keepsUnrounded,
           .rows = serialRows},
          progress};
}

namespace {

/// The joint progress of two threads; if one fails, the other stops.
class JointProgress {
 public:
  explicit JointProgress(const Progress& whole) : m_whole(whole) {}

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
  JointProgress halves(progress);
  auto reading = std::async([&] {  // runs sequentially if no thread can be started
    return halves.run(0, [&](const Progress& half) { return imagesOf(m_own, half); });
  });
  try {
    m_test = halves.run(1, [&](const Progress& half) { return imagesOf(test, half); });
  } catch (const Cancelled&) {
    reading.get();  // may throw the error that caused the cancellation
    throw;
  }
  m_reference = reading.get();
}

void ViewPairs::read(const ReportTest& test, const Progress& progress) {
  m_test.reset();
  const bool areTwo = m_own.file != test.file;  // a file has one decoder
  if (!m_reference && areTwo && mustStream(*m_own.file, m_memory) &&
      mustStream(*test.file, m_memory))
    return readSideBySide(test, progress);
  const bool isFirst = !m_reference;
  if (isFirst) {
    m_reference = imagesOf(m_own, part(progress, 0, 0.5));
    if (m_isAgainstIdeal) m_reference->showIdeal();
  }
  m_test = imagesOf(test, part(progress, isFirst ? 0.5 : 0, 1));
}

std::vector<double> ViewPairs::viewErrors(const Progress& progress) const {
  const LightFieldSource& ours = *reference().lightField;
  const LightFieldSource& others = *test().lightField;
  const bool areInMemory = ours.isInMemory() && others.isInMemory();
  if (m_isAgainstIdeal || !areInMemory || ours.size() != others.size()) return {};
  return hogelscope::viewErrors(*ours.overview(), *others.overview(), parallelRows, progress);
}

RayMoves ViewPairs::moves(std::size_t state, std::size_t worker, const Progress& progress) {
  const RenderJob job = m_test->job(state);
  Renderer& renderer = m_renderers[worker];
  return job.twin ? movesOf(job, renderer.tables(), renderer.rows(), progress) : RayMoves{};
}

Viewing ViewPairs::viewing(std::size_t state) const {
  return viewingOf(m_own.session.cameras[state], reference().display, reference().sampling.mapping);
}

ViewPair ViewPairs::render(std::size_t state, std::size_t worker, const Progress& progress) {
  const bool isKept = !m_references.empty() && !m_references[state].seen.empty();
  try {
    Renderer& renderer = m_renderers[worker];
    ViewPair pair{isKept ? m_references[state] : m_reference->render(state, renderer, progress),
                  m_test->render(state, renderer, progress),
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
