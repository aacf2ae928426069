// SPDX-License-Identifier: BSD-3-Clause
// Reads light fields and renders views on a thread of its own.
#include "gui/view_worker.h"

#include <vtkNew.h>

#include <QElapsedTimer>

#include "core/error.h"
#include "core/plan.h"
#include "vtk/parallel_rows.h"
#include "vtk/vtkHogelViewFilter.h"

namespace hogelscope {

namespace {

QImage toQImage(const Image& image) {
  const QImage view(image.rgb.data(), image.width, image.height, qsizetype(3) * image.width,
                    QImage::Format_RGB888);
  return view.copy();
}

}  // namespace

ViewWorker::ViewWorker(QObject* parent) : QObject(parent) {
  qRegisterMetaType<Scene>("hogelscope::Scene");
  qRegisterMetaType<LensCertificate>("hogelscope::LensCertificate");
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
    m_toRender.reset();
  }
  m_wake.notify_one();
}

void ViewWorker::render(const CameraState& state, const std::optional<NamedMethod>& method) {
  {
    const std::lock_guard lock(m_mutex);
    m_toRender = Request{state, method};
  }
  m_wake.notify_one();
}

bool ViewWorker::hasNewer(bool isLoading) {
  const std::lock_guard lock(m_mutex);
  return m_ends || m_toLoad || (!isLoading && m_toRender);
}

void ViewWorker::run() {
  const vtkNew<vtkHogelViewFilter> filter;
  filter->SetProgress([this](double) { return !hasNewer(false); });
  for (;;) {
    std::unique_lock lock(m_mutex);
    m_wake.wait(lock, [this] { return m_ends || m_toLoad || m_toRender; });
    if (m_ends) return;
    const std::optional<Session> session = std::exchange(m_toLoad, std::nullopt);
    const std::optional<Request> request =
        session ? std::nullopt : std::exchange(m_toRender, std::nullopt);
    lock.unlock();
    try {
      if (session) loadNow(*session, *filter);
      if (!request || !m_scene) continue;
      const View view = m_scene->view(request->state);
      renderNow(request->method ? with(*request->method, view) : view, *filter);
      if (!hasNewer(false)) certifyNow(request->state);
    } catch (const Cancelled&) {
      // a newer request waits
    } catch (const std::exception& error) {
      Q_EMIT failed(QString::fromUtf8(error.what()));
    }
  }
}

void ViewWorker::loadNow(const Session& session, vtkHogelViewFilter& filter) {
  filter.SetView({});
  m_scene.reset();  // frees the old one's memory before the new one is read
  m_scene = loadScene(session, [this](double) { return !hasNewer(true); });
  Q_EMIT loaded(*m_scene);
}

void ViewWorker::renderNow(const View& view, vtkHogelViewFilter& filter) {
  const CameraState& state = view.state;
  QElapsedTimer timer;
  timer.start();
  check(state, state.camera.name.empty() ? "state" : state.camera.name);
  filter.SetView(view);
  const Image image = filter.GetImage();
  Q_EMIT rendered(toQImage(image), double(timer.nsecsElapsed()) * 1e-6);
}

void ViewWorker::certifyNow(const CameraState& state) {
  const LensKey key = lensKeyOf(state, m_scene->sampling);
  if (key == m_lens) return;
  Q_EMIT certified(certify(key, parallelRows));
  m_lens = key;
}

}  // namespace hogelscope
