// SPDX-License-Identifier: BSD-3-Clause
#include "report/view_pairs.h"

#include <algorithm>
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
      m_shard(request.frames.empty() ? request.shard.value_or(Shard{}) : Shard{}),
      m_memory(request.memory / (request.frames.empty() ? 2 : request.tests.size() + 1)),
      m_lights(request.tests.size() + 1),
      m_isInTime(!request.frames.empty()),
      m_renderers(workers, Renderer(rowsWithin)) {
  m_lights[0].test = m_own;
  std::ranges::transform(request.tests, m_lights.begin() + 1, [](const ReportTest& test) {
    return Light{test, {}, {}};
  });
}

void ViewPairs::expect(std::vector<FrameViews> frames) {
  m_frames = std::move(frames);
  if (!m_isInTime) return;
  m_test.reset();
  m_reference.reset();
  for (Light& one : m_lights) one.reader.reset();
}

int ViewPairs::frameOf(const Light& one, int frame) const {
  return &one == &m_lights[0] ? frame : frameOfTest(*m_own.file, one.test, frame);
}

FrameReader& ViewPairs::readerOf(Light& one) const {
  if (one.reader) return *one.reader;
  std::vector<int> frames;
  for (const FrameViews& views : m_frames) frames.push_back(frameOf(one, views.frame));
  const SourceUse use{m_memory, 0, m_renderers.size() > 1 ? 1 : threadCount()};
  return *(one.reader = std::make_unique<FrameReader>(*one.test.file, frames, use));
}

StateImages ViewPairs::imagesOf(Light& one, const Progress& progress) {
  const auto& [name, session, file, order, unloaded] = one.test;
  ViewSource source = unloaded       ? *unloaded
                      : one.unloaded ? *one.unloaded
                                     : unloadedViewSource(session, *file, progress);
  if (m_isInTime) one.unloaded = source;
  const auto first = m_own.session.cameras.begin();
  const std::vector<CameraState> states(first + std::ptrdiff_t(m_views.begin),
                                        first + std::ptrdiff_t(m_views.end));
  setKind(source, one.test);
  if (mustStream(*file, m_memory)) {
    file->select(frameOf(one, m_views.frame));
    return {source,
            *file,
            states,
            {.use = {m_memory, 0, m_renderers.size() > 1 ? 1 : threadCount()},
             .shard = m_shard,
             .bits = file->bits(),
             .keepsUnrounded = m_keepsUnrounded,
             .rows = serialRows},
            progress};
  }
  const bool isOwn = &one != &m_lights[0] && file == m_own.file && m_isInTime;
  source.lightField = isOwn ? reference().lightField : readerOf(one).next(progress);
  return {source, states};
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

void ViewPairs::readSideBySide(Light& test, const Progress& progress) {
  JointProgress halves(progress);
  auto reading = std::async([&] {  // runs sequentially if no thread can be started
    return halves.run(0, [&](const Progress& half) { return imagesOf(m_lights[0], half); });
  });
  try {
    m_test = halves.run(1, [&](const Progress& half) { return imagesOf(test, half); });
  } catch (const Cancelled&) {
    reading.get();  // may throw the error that caused the cancellation
    throw;
  }
  m_reference = reading.get();
}

void ViewPairs::read(std::size_t test, std::size_t frame, const Progress& progress) {
  m_test.reset();
  if (m_isInTime && m_views != m_frames[frame]) m_reference.reset();
  m_views = m_frames[frame];
  const bool isFirst = !m_reference;
  if (isFirst || m_references.empty())
    m_references.assign(m_lights.size() > 2 ? m_views.end - m_views.begin : 0, Image());
  Light& light = m_lights[test + 1];
  const bool areTwo = m_own.file != light.test.file;  // a file has one decoder
  if (isFirst && areTwo && mustStream(*m_own.file, m_memory) &&
      mustStream(*light.test.file, m_memory))
    return readSideBySide(light, progress);
  if (isFirst) {
    m_reference = imagesOf(m_lights[0], part(progress, 0, 0.5));
    if (m_isAgainstIdeal) m_reference->showIdeal();
  }
  m_test = imagesOf(light, part(progress, isFirst ? 0.5 : 0, 1));
}

std::vector<double> ViewPairs::viewErrors(const Progress& progress) const {
  const LightFieldSource& ours = *reference().lightField;
  const LightFieldSource& others = *test().lightField;
  const bool areInMemory = ours.isInMemory() && others.isInMemory();
  if (m_isAgainstIdeal || !areInMemory || ours.size() != others.size()) return {};
  return hogelscope::viewErrors(*ours.overview(), *others.overview(), parallelRows, progress);
}

RayMoves ViewPairs::moves(std::size_t state, std::size_t worker, const Progress& progress) {
  const RenderJob job = m_test->job(state - m_views.begin);
  Renderer& renderer = m_renderers[worker];
  return job.twin ? movesOf(job, renderer.tables(), renderer.rows(), progress) : RayMoves{};
}

Viewing ViewPairs::viewing(std::size_t state) const {
  Viewing viewing =
      viewingOf(m_own.session.cameras[state], reference().display, reference().sampling.mapping);
  if (m_isInTime) viewing.frame = m_views.frame;
  return viewing;
}

ViewPair ViewPairs::render(std::size_t state, std::size_t worker, const Progress& progress) {
  const std::size_t own = state - m_views.begin;
  const bool isKept = !m_references.empty() && !m_references[own].seen.empty();
  try {
    Renderer& renderer = m_renderers[worker];
    ViewPair pair{isKept ? m_references[own] : m_reference->render(own, renderer, progress),
                  m_test->render(own, renderer, progress),
                  {}};
    if (!m_references.empty()) m_references[own] = pair.reference;
    return pair;
  } catch (const InputError& error) {
    return {{}, {}, error.what()};
  } catch (const std::bad_alloc&) {
    return {{}, {}, "not enough memory for its picture"};
  }
}

}  // namespace hogelscope
