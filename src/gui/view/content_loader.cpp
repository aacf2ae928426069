// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/content_loader.h"

#include <exception>
#include <utility>

#include "core/panel/twin.h"
#include "gui/session/session_model.h"
#include "gui/view/view_worker.h"

namespace hogelscope {

ContentLoader::ContentLoader(SessionModel* model, ViewWorker* worker, QObject* parent)
    : QObject(parent), m_model(model), m_worker(worker) {
  constexpr int quick = 300;  // milliseconds
  m_delay.setSingleShot(true);
  m_delay.setInterval(quick);
  connect(&m_delay, &QTimer::timeout, this, &ContentLoader::sayReading);
  connect(worker, &ViewWorker::loaded, this, &ContentLoader::onLoaded);
  connect(worker, &ViewWorker::failed, this, &ContentLoader::onFailed);
  connect(worker, &ViewWorker::readingStopped, this, &ContentLoader::onStopped);
}

/// The memory is free then.
void ContentLoader::forget() {
  m_source.reset();
  m_frame.reset();
  Q_EMIT sourceChanged();
}

/// Without a light field, if one was being read.
void ContentLoader::end() {
  m_delay.stop();
  if (std::exchange(m_isReading, false)) forget();
  m_isAwaited = false;
}

/// While a live scene is edited, all that is shown stays until there is something newer, and edits
/// that come faster than images wait for the next one (followImage()): else none would ever come.
void ContentLoader::load() {
  const auto isLive = [](const Session& session) { return session.lightField.isLive(); };
  const bool isEdit = m_source && isLive(m_asked) && isLive(m_model->session());
  if (isEdit && m_isAwaited) return;
  m_asked = m_model->session();
  m_isReading = m_isAwaited = true;
  if (!isEdit) forget();
  m_worker->load(m_asked, m_frame);
  if (isEdit)
    m_delay.start();
  else
    sayReading();
}

void ContentLoader::showFrame(int number, const std::shared_ptr<const LightFieldSource>& frame) {
  if (!isReady()) return;
  m_frame = number;
  m_source->lightField = frame;
  Q_EMIT frameChanged();
}

void ContentLoader::sayReading() {
  Q_EMIT reading(tr("Reading %1 …").arg(QString::fromStdString(contentName(m_asked.lightField))));
}

bool ContentLoader::follow() {
  if (!isReady() || !readTheSame(m_asked, m_model->session())) {
    load();
    return false;
  }
  showSession();
  return true;
}

void ContentLoader::followImage() {
  m_isAwaited = false;
  if (m_source && !readTheSame(m_asked, m_model->session())) load();
}

void ContentLoader::showTwin(bool isBuilt) {
  m_showsTwin = isBuilt;
  if (isReady()) showSession();
}

/// Returns the session's twin; maps are read, and numbers drawn, only after they were edited.
std::shared_ptr<const Twin> ContentLoader::twin(const PanelParams& display) {
  const std::pair wanted{m_model->session().twin, display};
  if (!m_showsTwin || wanted.first.isZero()) return nullptr;
  if (!m_twin || m_twinOf != wanted) {
    m_twin = twinOf(wanted.first, display);
    m_twinOf = wanted;
  }
  return m_twin;
}

/// The display, twin and sampling of the session as they are now.
void ContentLoader::showSession() {
  m_source->display = resolved(displayOf(m_model->session()), m_source->lightField->size());
  m_source->sampling = m_model->session().sampling;
  m_source->twin = nullptr;
  try {
    m_source->twin = twin(m_source->display);
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
    return;
  }
  Q_EMIT sourceChanged();
}

/// A live scene may have been edited since it was asked for.
void ContentLoader::onLoaded(const ViewSource& source) {
  m_isReading = false;
  m_source = source;
  if (m_delay.isActive())
    m_delay.stop();
  else
    Q_EMIT renderingBegun();
  if (readTheSame(m_asked, m_model->session()))
    showSession();
  else
    Q_EMIT sourceChanged();
  Q_EMIT loaded();
}

void ContentLoader::onFailed(const QString& line) {
  const bool isOld = !readTheSame(m_asked, m_model->session());
  end();
  if (isOld)
    load();
  else
    Q_EMIT failed(line);
}

void ContentLoader::onStopped() {
  end();
  Q_EMIT stopped(tr("Stopped reading %1; to read it, open the session again")
                     .arg(QString::fromStdString(contentName(m_model->session().lightField))));
}

}  // namespace hogelscope
