// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/view_worker.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/engine/plan_words.h"
#include "core/engine/scaled_view.h"
#include "gui/widgets/task.h"
#include "picture/conversions.h"
#include "picture/stereo_picture.h"

namespace hogelscope {

namespace {

/// Returns the filter's output in Qt's fastest format, so that the window's thread need not convert
/// it. VTK's rows start at the bottom.
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

/// The fewest samples of a pupil that show its blur.
constexpr int fewestSamples = 4;

/// Gives a coarse view fewer samples of its pupil, as many times fewer as `scale`² says. Returns
/// the scale that is then left: 1 if the samples are enough for full resolution.
int withFewerSamples(RenderJob& view, int scale) {
  const Aperture aperture = plan(view).aperture;
  const auto all = static_cast<int>(aperture.points.size());
  if (aperture.isPinhole || all <= fewestSamples) return scale;
  const int wanted = all / (scale * scale);
  view.state.pupil.samples = std::max(wanted, fewestSamples);
  return wanted >= fewestSamples ? 1 : scale;
}

/// Returns the job of a view. For a light field in a store, the coarse image has fewer hogels and
/// directions instead of fewer pixels, because fetching them dominates. For a live one, where each
/// texel is expensive after every edit, it has no leakage, which reads the most texels.
RenderJob viewOf(const ViewSource& source, const CameraState& state,
                 const std::optional<NamedMethod>& method, int scale) {
  const bool isLive = source.lightField->scene() != nullptr;
  if (scale > 1 && !source.isIdeal && !source.lightField->isInMemory() && !isLive)
    return overview(viewOf(source, state, method, 1));
  RenderJob view = method ? applyMethod(*method, source.job(state)) : source.job(state);
  if (scale > 1 && isLive) view.state.psf.windowSize = 1;
  if (scale > 1) scale = withFewerSamples(view, scale);
  view.method.scale = std::max(view.method.scale, scale);
  return view;
}

/// The expected time of the first view of a store, in milliseconds.
constexpr double firstFetch = 1000;

QString planOf(const RenderJob& view) {
  const RenderJob made = reduced(view);
  const QString how = QString::fromStdString(oneLine(made, plan(made)));
  return how + ViewWorker::tr(", %n threads", "", threadCount());
}

}  // namespace

ViewWorker::ViewWorker(QObject* parent) : QObject(parent) {
  m_filter->SetProgress([this](double) { return !mustStop(); });
  m_thread.start([this] { return m_toLoad || m_toRender; },
                 [this](LatestWins::Lock& lock) { serve(lock); });
}

void ViewWorker::load(const Session& session, std::optional<int> frame) {
  m_thread.ask([&] {
    m_toLoad.emplace(session, frame);
    ++m_asked;
    m_isReadingStopped = false;
    m_toRender.reset();
    m_readShare = 0;
  });
}

/// Sends a signal from the thread.
template <class Signal>
void ViewWorker::send(Signal signal) {
  queueAnswer(this, m_asked, m_number, signal);
}

void ViewWorker::stopReading() {
  m_thread.ask([this] { m_isReadingStopped = true; });
}

void ViewWorker::render(const ViewRequest& request) {
  m_thread.ask([&] { m_toRender = request; });
}

bool ViewWorker::hasNewer(bool isLoading) {
  return m_thread.mustStop(
      [&] { return m_toLoad || (isLoading ? m_isReadingStopped : m_toRender.has_value()); });
}

/// Whether a running rendering must stop.
bool ViewWorker::mustStop() {
  const bool isPatient = double(m_timer.nsecsElapsed()) * 1e-6 < m_patience;
  return m_thread.mustStop([&] { return m_toLoad || (!isPatient && m_toRender); });
}

/// Waits a moment. Returns false if a newer request arrives.
bool ViewWorker::staysIdle() {
  constexpr std::chrono::milliseconds rest(60);
  return !m_thread.mustStopWithin(rest, [this] { return m_toLoad || m_toRender; });
}

void ViewWorker::serve(LatestWins::Lock& lock) {
  const auto toLoad = std::exchange(m_toLoad, std::nullopt);
  m_number = m_asked;
  const std::optional<ViewRequest> request =
      toLoad ? std::nullopt : std::exchange(m_toRender, std::nullopt);
  lock.unlock();
  try {
    if (toLoad) loadNow(toLoad->first, toLoad->second);
    if (request) {
      renderNow(*request);
      if (!hasNewer(false)) certifyNow(*request);
    }
  } catch (const Cancelled&) {
    // a newer request waits
  } catch (const std::exception& error) {
    send([this, line = QString::fromUtf8(error.what())] { Q_EMIT failed(line); });
  }
  m_filter->SetJob({});  // while it waits it holds no light field
}

void ViewWorker::loadNow(const Session& session, std::optional<int> frame) {
  m_lens.reset();  // its result may have been dropped
  Session designed = session;
  designed.twin = {};  // which comes with each request
  ViewSource source;
  const Progress progress = [this](double done) {
    if (hasNewer(true)) return false;  // the share belongs to the newer request now
    m_readShare = done;
    return true;
  };
  try {
    const auto file = openLightField(designed.lightField, designed.display, progress);
    if (frame && file->frames().has(*frame)) file->select(*frame);
    source = loadViewSource(designed, *file, progress);
  } catch (const Cancelled&) {
    send([this] { Q_EMIT readingStopped(); });  // received only if no newer request exists
    return;
  }
  m_readShare = 1;
  const LightFieldSource& read = *source.lightField;
  if (read.scene() == nullptr && !read.isInMemory()) m_pace.stopped(firstFetch);
  send([this, source] { Q_EMIT loaded(source); });
}

/// Renders a view. A coarse image is finished even if newer requests arrive, so that the view keeps
/// moving; a full image that is expected to be quick gets its expected time.
void ViewWorker::renderNow(const ViewRequest& request) {
  const CameraState& state = request.state;
  check(state, state.camera.name.empty() ? "state" : state.camera.name);
  const int scale = m_pace.firstScale();
  if (scale == 1) return renderAt(1, ViewPace::quick, request);
  renderAt(scale, std::numeric_limits<double>::infinity(), request);
  if (staysIdle()) renderAt(1, 0, request);
}

struct ViewWorker::Shown {
  QImage image;
  QImage seen;
};

/// Renders the views of all eyes that are shown, and joins them.
ViewWorker::Shown ViewWorker::renderEyes(const ViewSource& source, int scale,
                                         const ViewRequest& request) {
  const auto viewFrom = [&](const CameraState& eye) {
    return viewOf(source, eye, request.method, scale);
  };
  const std::optional<StereoMode> mode = jointModeOf(request.eyes);
  if (!mode || !hasTwoEyes(request.state)) {
    const EyePixel eye = eyeAt(request.eyes, request.state, source.display, {});
    return renderEye(viewFrom(eye.state), request.asksWhy);
  }
  const bool isAnaglyph = *mode == StereoMode::anaglyph || *mode == StereoMode::anaglyphGrey;
  std::array<Shown, 2> shown;
  for (const Eye eye : {Eye::left, Eye::right})
    shown[std::size_t(eye)] = renderEye(viewFrom(eyeOf(request.state, source.display, eye)),
                                        request.asksWhy && !isAnaglyph);
  return {joined(shown[0].image, shown[1].image, *mode),
          joined(shown[0].seen, shown[1].seen, *mode)};
}

ViewWorker::Shown ViewWorker::renderEye(const RenderJob& view, bool asksWhy) {
  m_filter->SetJob(view);
  m_filter->UpdateOrThrow();
  Shown shown{toQImage(*m_filter->GetOutput()), toMask(*m_filter->GetOutput())};
  if (asksWhy) shown.seen = withReasons(shown.seen, view, [this](double) { return !mustStop(); });
  return shown;
}

void ViewWorker::renderAt(int scale, double patience, const ViewRequest& request) {
  const auto elapsed = [this] { return double(m_timer.nsecsElapsed()) * 1e-6; };
  m_patience = patience;
  m_timer.start();
  RenderedView result;
  try {
    if (request.other) {
      const Shown other = renderEyes(*request.other, scale, request);
      result.otherImage = other.image;
      result.otherSeen = other.seen;
    }
    const Shown own = renderEyes(request.source, scale, request);
    result.image = own.image;
    result.seen = own.seen;
  } catch (const Cancelled&) {
    m_pace.stopped(elapsed());
    throw;
  }
  result.milliseconds = elapsed();
  m_pace.rendered(scale, result.milliseconds);
  const RenderJob& made = m_filter->GetJob();
  result.isOverview = made.lightField != request.source.lightField;
  if (scale > 1 && made.state.pupil.samples != request.state.pupil.samples)
    result.samples = made.state.pupil.samples;
  result.scale = result.samples > 0 ? made.method.scale : scale;
  if (request.method) result.method = QString::fromStdString(request.method->name);
  if (hasTwoEyes(request.state)) result.eyes = request.eyes;
  result.isBuilt = request.source.twin != nullptr;
  result.plan = planOf(m_filter->GetChoice().job);
  send([this, result] { Q_EMIT rendered(result); });
}

void ViewWorker::certifyNow(const ViewRequest& request) {
  const LensKey key = lensKeyOf(request.state, request.source.sampling);
  if (key == m_lens) return;
  const Progress progress = [this](double) { return !hasNewer(false); };
  const CertifiedLens lens{key, certify(key, parallelRows, progress), lensGrid(key, progress)};
  send([this, lens] { Q_EMIT certified(lens); });
  m_lens = key;
}

}  // namespace hogelscope
