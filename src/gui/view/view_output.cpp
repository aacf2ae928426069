// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/view_output.h"

#include <QStandardPaths>
#include <algorithm>
#include <cmath>

#include "core/engine/renderer.h"
#include "core/engine/scaled_view.h"
#include "gui/session/session_model.h"
#include "gui/view/animation_dialog.h"
#include "gui/widgets/command.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/guarded.h"
#include "io/files/files_in_use.h"
#include "io/files/folders.h"
#include "io/images/image_writer.h"
#include "io/scene/animation.h"

namespace hogelscope {

namespace fs = std::filesystem;

namespace {

/// Whether the format holds more than 8 bits.
bool holdsFloats(const QString& file) {
  return file.endsWith(".exr") || file.endsWith(".tif") || file.endsWith(".tiff");
}

void writeView(const RenderJob& job, const QString& file, const Progress& progress) {
  const auto [width, height] = job.state.camera.res;
  const fs::path path = file.toStdString();
  checkFits(double(width) * height * 2 * sizeof(std::array<float, 3>), path,
            "choose a smaller size");
  checkWritable(path.has_parent_path() ? path.parent_path() : ".");
  const Progress rendering = part(progress, 0, 0.9);
  Renderer renderer;
  if (holdsFloats(file))
    writeImage(path, width, height, renderer.renderFloat(job, rendering).rgb);
  else
    writeImage(path, width, height, renderer.render(job, rendering).rgb,
               [&](double) { return !progress || progress(0.9); });
}

}  // namespace

ViewOutput::ViewOutput(QMenu* menu, QWidget* view, QStatusBar* statusBar, SessionModel* model,
                       QObject* parent)
    : FileOutput("outputBar", tr("Writing"), tr("How much has been rendered and written"),
                 statusBar, parent),
      m_view(view),
      m_model(model),
      m_saveView(addCommand(
          menu,
          {"saveViewAction", tr("Save view at any si&ze…"),
           tr("Renders the current state's simulated view again, with as many pixels as you say "
              "over the same field: PNG, TIFF of 16 bits, or EXR of floats that are not rounded"),
           Qt::CTRL | Qt::ALT | Qt::Key_E},
          this, &ViewOutput::askView)),
      m_saveAnimation(addCommand(menu,
                                 {"saveAnimationAction", tr("Save a&nimation…"),
                                  tr("Renders a path of the camera, or a focus stack: numbered "
                                     "pictures, and a video where the program ffmpeg is installed"),
                                  Qt::CTRL | Qt::ALT | Qt::Key_A},
                                 this, &ViewOutput::askAnimation)) {
  connect(m_task, &Task::runningChanged, this, &ViewOutput::showState);
  showState();
}

void ViewOutput::setSource(const std::optional<ViewSource>& source) {
  m_source = source;
  showState();
}

void ViewOutput::showState() {
  for (QAction* action : {m_saveView, m_saveAnimation})
    action->setEnabled(m_source && !m_task->isRunning());
}

void ViewOutput::saveView(const QString& file, const CameraState& state) {
  const std::optional<RenderJob> job =
      m_source ? std::optional(m_source->job(state)) : std::nullopt;
  if (!job)  // removed while the name was asked for
    return Q_EMIT failed(tr("%1: not written: there is no light field").arg(file));
  m_task->start([this, job, file](const Progress& progress) {
    check(job->state, job->state.camera.name);
    checkOutputs({file.toStdString()});
    writeView(*job, file, progress);
    return [this, file] { Q_EMIT done(tr("Saved %1").arg(file)); };
  });
}

void ViewOutput::saveAnimation(const CameraPath& path, const QString& folder, double scale,
                               const QString& ffmpeg, int framesPerSecond) {
  if (!m_source) return Q_EMIT failed(tr("%1: not written: there is no light field").arg(folder));
  AnimationRequest request{
      *m_source, {}, folder.toStdString(), framesPerSecond, ffmpeg.toStdString()};
  const auto scaled = [scale](int side) { return std::max(1, int(std::lround(scale * side))); };
  for (const CameraState& state : statesAlong(path, resolvedSession(), m_model->currentIndex())) {
    const auto [width, height] = state.camera.res;
    request.states.push_back(resized(state, {scaled(width), scaled(height)}));
  }
  m_task->start([this, folder, request](const Progress& progress) {
    for (const CameraState& state : request.states) check(state, state.camera.name);
    writeAnimation(request, progress);
    return [this, folder, count = request.states.size()] {
      Q_EMIT done(tr("Saved %n pictures in %1", "", int(count)).arg(folder));
    };
  });
}

/// Returns the session with the hogels and directions of its light field, which it may not say.
Session ViewOutput::resolvedSession() const {
  Session session = m_model->session();
  if (session.display.sheet || !m_source) return session;
  session.display.hogels = m_source->display.hogels;
  session.display.directions = m_source->display.directions;
  return session;
}

QSize ViewOutput::currentSize() const {
  const auto [width, height] = m_model->current().camera.res;
  return {width, height};
}

void ViewOutput::askView() {
  SizeDialog dialog(tr("Save view at any size"), currentSize(), m_view);
  if (dialog.exec() != QDialog::Accepted) return;
  const QString name = QString::fromStdString(m_model->current().camera.name) + ".png";
  const QString file =
      chooseNewFile(m_view, tr("Save view"), name, tr("Pictures (*.png *.tif *.tiff *.exr *.jpg)"));
  const QSize size = dialog.size();
  if (!file.isEmpty()) saveView(file, resized(m_model->current(), {size.width(), size.height()}));
}

void ViewOutput::askAnimation() {
  const QString ffmpeg = QStandardPaths::findExecutable("ffmpeg");
  AnimationDialog dialog(resolvedSession(), m_model->currentIndex(), currentSize(), ffmpeg, m_view);
  if (dialog.exec() != QDialog::Accepted) return;
  const double scale = double(dialog.size().width()) / currentSize().width();
  guarded(this, [&] {
    saveAnimation(dialog.path(), dialog.folder(), scale, dialog.hasVideo() ? ffmpeg : QString(),
                  dialog.framesPerSecond());
  });
}

}  // namespace hogelscope
