// SPDX-License-Identifier: BSD-3-Clause
// Reads light fields and renders views on a thread of its own.
#include "gui/view/view_worker.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/content/live_source.h"
#include "core/engine/plan_words.h"
#include "core/engine/scaled_view.h"
#include "gui/widgets/queued_answer.h"
#include "vtk/vtkHogelViewFilter.h"

namespace hogelscope {

namespace {

/// The filter's output as Qt paints it fastest, so that the window's thread need not convert it.
/// VTK's rows are from the bottom.
QImage toQImage(vtkImageData& output) {
  const auto [width, height] = std::array{output.GetDimensions()[0], output.GetDimensions()[1]};
  QImage image(width, height, QImage::Format_RGB32);
  const auto* rgb = static_cast<const std::uint8_t*>(output.GetScalarPointer());
  for (int y = height - 1; y >= 0; --y) {
    auto* pixel = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < width; ++x, rgb += 3) *pixel++ = qRgb(rgb[0], rgb[1], rgb[2]);
  }
  return image;
}

QImage toMask(vtkImageData& output) {
  const auto [width, height] = std::array{output.GetDimensions()[0], output.GetDimensions()[1]};
  QImage mask(width, height, QImage::Format_Grayscale8);
  const auto* seen =
      static_cast<const std::uint8_t*>(output.GetPointData()->GetArray("Seen")->GetVoidPointer(0));
  for (int y = height - 1; y >= 0; --y, seen += width) std::copy_n(seen, width, mask.scanLine(y));
  return mask;
}

/// Of a light field in a store the coarse image has not fewer pixels, but fewer hogels and
/// directions: what takes long there is to fetch them. In a live one each texel that is read takes
/// long, again after each edit of its content: the coarse image is without leakage, which reads
/// most.
RenderJob viewOf(const Scene& scene, const CameraState& state,
                 const std::optional<NamedMethod>& method, int scale) {
  const bool isLive = dynamic_cast<const LiveSource*>(scene.lightField.get()) != nullptr;
  if (scale > 1 && !scene.isIdeal && !scene.lightField->isInMemory() && !isLive)
    return overview(viewOf(scene, state, method, 1));
  RenderJob view = method ? applyMethod(*method, scene.job(state)) : scene.job(state);
  if (scale > 1 && isLive) view.state.psf.windowSize = 1;
  view.method.scale = std::max(view.method.scale, scale);
  return view;
}

/// Milliseconds: what the first view of a store is thought to take.
constexpr double firstFetch = 1000;

QString planOf(const RenderJob& view) {
  const RenderJob made = reduced(view);
  const QString how = QString::fromStdString(oneLine(made, plan(made)));
  return how + ViewWorker::tr(", %n threads", "", threadCount());
}

}  // namespace

ViewWorker::ViewWorker(QObject* parent) : QObject(parent) {
  m_thread = std::thread([this] { run(); });
}

ViewWorker::~ViewWorker() {
  {
    const std::lock_guard lock(m_mutex);
    m_ends = true;
  }
  m_wake.notify_one();
  m_thread.join();
}

void ViewWorker::load(const Session& session) {
  {
    const std::lock_guard lock(m_mutex);
    m_toLoad = session;
    ++m_asked;
    m_isReadingStopped = false;
    m_toRender.reset();
    m_readShare = 0;
  }
  m_wake.notify_one();
}

/// From the thread.
template <class Signal>
void ViewWorker::send(Signal signal) {
  queueAnswer(this, m_asked, m_number, signal);
}

void ViewWorker::stopReading() {
  const std::lock_guard lock(m_mutex);
  m_isReadingStopped = true;
}

void ViewWorker::render(const ViewRequest& request) {
  {
    const std::lock_guard lock(m_mutex);
    m_toRender = request;
  }
  m_wake.notify_one();
}

bool ViewWorker::hasNewer(bool isLoading) {
  const std::lock_guard lock(m_mutex);
  return m_ends || m_toLoad || (isLoading ? m_isReadingStopped : m_toRender.has_value());
}

/// Asked while a view is rendered.
bool ViewWorker::mustStop() {
  const std::lock_guard lock(m_mutex);
  const bool isPatient = double(m_timer.nsecsElapsed()) * 1e-6 < m_patience;
  return m_ends || m_toLoad || (!isPatient && m_toRender);
}

/// Waits a moment; false if something newer comes.
bool ViewWorker::handRests() {
  constexpr auto rest = std::chrono::milliseconds(60);
  std::unique_lock lock(m_mutex);
  return !m_wake.wait_for(lock, rest, [this] { return m_ends || m_toLoad || m_toRender; });
}

void ViewWorker::run() {
  const vtkNew<vtkHogelViewFilter> filter;
  filter->SetProgress([this](double) { return !mustStop(); });
  for (;;) {
    filter->SetJob({});  // while it waits it holds no light field
    std::unique_lock lock(m_mutex);
    m_wake.wait(lock, [this] { return m_ends || m_toLoad || m_toRender; });
    if (m_ends) return;
    const std::optional<Session> session = std::exchange(m_toLoad, std::nullopt);
    m_number = m_asked;
    const std::optional<ViewRequest> request =
        session ? std::nullopt : std::exchange(m_toRender, std::nullopt);
    lock.unlock();
    try {
      if (session) loadNow(*session);
      if (!request || !m_scene) continue;
      renderNow(*request, *filter);
      if (!hasNewer(false)) certifyNow(*request);
    } catch (const Cancelled&) {
      // a newer request waits
    } catch (const std::exception& error) {
      send([this, line = QString::fromUtf8(error.what())] { Q_EMIT failed(line); });
    }
  }
}

void ViewWorker::loadNow(const Session& session) {
  m_scene.reset();  // frees the old one's memory before the new one is read
  m_lens.reset();   // what was said of it may have been dropped
  try {
    m_scene = loadScene(session, [this](double done) {
      if (hasNewer(true)) return false;  // the share is the newer one's now
      m_readShare = done;
      return true;
    });
  } catch (const Cancelled&) {
    send([this] { Q_EMIT readingStopped(); });  // heard only where nothing newer is asked for
    return;
  }
  m_readShare = 1;
  const bool isLive = session.lightField.isLive();
  if (!isLive && !m_scene->lightField->isInMemory()) m_pace.stopped(firstFetch);
  send([this, scene = *m_scene] { Q_EMIT loaded(scene); });
}

/// A smaller image is finished even if newer requests come, so that something moves however fast
/// they come; a full one that was thought to be quick gets the time it was thought to take.
void ViewWorker::renderNow(const ViewRequest& request, vtkHogelViewFilter& filter) {
  const CameraState& state = request.state;
  check(state, state.camera.name.empty() ? "state" : state.camera.name);
  const int scale = m_pace.firstScale();
  if (scale == 1) return renderAt(1, ViewPace::quick, request, filter);
  renderAt(scale, std::numeric_limits<double>::infinity(), request, filter);
  if (handRests()) renderAt(1, 0, request, filter);
}

void ViewWorker::renderAt(int scale, double patience, const ViewRequest& request,
                          vtkHogelViewFilter& filter) {
  const auto elapsed = [this] { return double(m_timer.nsecsElapsed()) * 1e-6; };
  m_patience = patience;
  m_timer.start();
  RenderedView result;
  Scene scene = *m_scene;
  scene.display = resolved(request.display, scene.lightField->size());
  scene.sampling = request.sampling;
  const RenderJob view = viewOf(scene, request.state, request.method, scale);
  try {
    if (request.other) {
      filter.SetJob(viewOf(*request.other, request.state, request.method, scale));
      filter.UpdateOrThrow();
      result.otherImage = toQImage(*filter.GetOutput());
      result.otherSeen = toMask(*filter.GetOutput());
    }
    filter.SetJob(view);
    filter.UpdateOrThrow();
  } catch (const Cancelled&) {
    m_pace.stopped(elapsed());
    throw;
  }
  result.milliseconds = elapsed();
  m_pace.rendered(scale, result.milliseconds);
  result.image = toQImage(*filter.GetOutput());
  result.seen = toMask(*filter.GetOutput());
  result.scale = scale;
  result.isOverview = view.lightField != scene.lightField;
  result.plan = planOf(filter.GetChoice().job);
  send([this, result] { Q_EMIT rendered(result); });
}

void ViewWorker::certifyNow(const ViewRequest& request) {
  const LensKey key = lensKeyOf(request.state, request.sampling);
  if (key == m_lens) return;
  const Progress progress = [this](double) { return !hasNewer(false); };
  const CertifiedLens lens{key, certify(key, parallelRows, progress), lensGrid(key, progress)};
  send([this, lens] { Q_EMIT certified(lens); });
  m_lens = key;
}

}  // namespace hogelscope
