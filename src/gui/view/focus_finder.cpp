// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/focus_finder.h"

#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/content/capture_content.h"
#include "core/engine/focus_search.h"
#include "gui/session/session_model.h"
#include "gui/view/image_widget.h"
#include "gui/widgets/command.h"

namespace hogelscope {

namespace {

/// Returns a distance for people, to 1 mm.
double rounded(double metres) {
  return std::round(1000 * metres) / 1000;
}

/// Returns the capture that a live light field shows; null if it shows none.
const CaptureContent* captureOf(const LiveSource* live) {
  return live != nullptr ? dynamic_cast<const CaptureContent*>(&live->content()) : nullptr;
}

/// Returns the depth before a capture's panel at which a pixel is sharp between its directions.
std::optional<double> sharpestDepth(const RenderJob& job, const QPoint& pixel,
                                    const LiveSource& live, const Progress& progress) {
  const CaptureContent& capture = *captureOf(&live);
  constexpr double mostHogels = 10, step = 0.25;  // by which neighbouring views differ
  constexpr int count = int(2 * mostHogels / step) + 1;
  const double unit = capture.depthOfOneHogel();
  LensTables tables;
  return sharpestContent(
      job, pixel.x(), pixel.y(), count, [&](double k) { return (k * step - mostHogels) * unit; },
      [&](double depth) { return live.withContent(capture.focusedAt(depth)); }, tables, serialRows,
      progress);
}

/// Whether two jobs differ in nothing but the pupil, which the sharpest focus does not depend on.
bool areAlike(RenderJob a, const RenderJob& b) {
  a.state.pupil = b.state.pupil;
  return a == b;
}

}  // namespace

FocusFinder::FocusFinder(QMenu* menu, ImageWidget* view, SessionModel* model,
                         std::function<std::optional<PickedView>(const QPoint&)> viewAt,
                         QObject* parent)
    : QObject(parent),
      m_model(model),
      m_viewAt(std::move(viewAt)),
      m_focus(addCommand(menu,
                         {"focusAction", tr("F&ocus on the picked pixel"),
                          tr("Sets the pupil's focus to the depth of the picked pixel, or, where "
                             "the content has no depth, to where it is sharpest; without a pupil, "
                             "the focus of a capture that is shown on another display; Ctrl and a "
                             "click on a pixel do so too"),
                          Qt::CTRL | Qt::ALT | Qt::Key_D},
                         this,
                         [this] {
                           if (m_pixel) focusOn(m_pixel->x(), m_pixel->y());
                         })),
      m_task(new Task(this)) {
  m_focus->setEnabled(false);
  connect(view, &ImageWidget::pixelPicked, this, &FocusFinder::pick);
  connect(view, &ImageWidget::focusAsked, this, &FocusFinder::focusOn);
  connect(m_task, &Task::failed, this, &FocusFinder::failed);
  connect(model, &SessionModel::edited, this, &FocusFinder::forgetEdited);
  for (const auto change : {&SessionModel::opened, &SessionModel::currentChanged,
                            &SessionModel::statesChanged, &SessionModel::contentChanged})
    connect(model, change, this, [this] {
      m_task->abandon();
      m_asked.reset();
      m_pixel.reset();
      m_focus->setEnabled(false);
    });
}

void FocusFinder::pick(int x, int y) {
  m_pixel = QPoint(x, y);
  m_focus->setEnabled(true);
  if (m_model->current().pupil.diameter > 0) search(*m_pixel, false);
}

void FocusFinder::focusOn(int x, int y) {
  m_pixel = QPoint(x, y);
  m_focus->setEnabled(true);
  if (m_model->current().pupil.diameter > 0) return search(*m_pixel, true);
  if (searchCapture(*m_pixel)) return;
  Q_EMIT failed(
      tr("This state is a pinhole, which sees everything sharp: give its pupil a diameter"));
}

void FocusFinder::search(const QPoint& pixel, bool isApplied) {
  const std::optional<PickedView> view = m_viewAt(pixel);
  if (!view) return;
  m_asked = view->job;
  m_task->start([this, view = *view, pixel, isApplied](const Progress& progress) -> Task::Answer {
    LensTables tables;
    // On one thread, since it must not delay the view.
    const std::optional<double> focus =
        sharpestFocus(view.job, view.pixel.x(), view.pixel.y(), tables, serialRows, progress);
    return [this, pixel, focus, isApplied] { take(pixel, focus, isApplied); };
  });
}

/// Returns false if the content is no capture.
bool FocusFinder::searchCapture(const QPoint& pixel) {
  const std::optional<PickedView> view = m_viewAt(pixel);
  if (!view) return false;
  auto live = std::dynamic_pointer_cast<const LiveSource>(view->job.lightField);
  if (captureOf(live.get()) == nullptr) return false;
  m_asked = view->job;
  m_task->start([this, view = *view, live, pixel](const Progress& progress) -> Task::Answer {
    const auto depth = sharpestDepth(view.job, view.pixel, *live, progress);
    return [this, pixel, depth] { takeDepth(pixel, depth); };
  });
  return true;
}

void FocusFinder::takeDepth(const QPoint& pixel, const std::optional<double>& depth) {
  if (!depth) {
    Q_EMIT failed(tr("Nothing here differs between the capture's directions: no focus is found"));
    return;
  }
  m_model->edit(tr("Focus of the capture"), [&](Session& session) {
    session.lightField.content.set("focus", std::vector<double>{rounded(*depth)});
  });
  Q_EMIT found(pixel, tr("The capture is sharp at %1 m before its panel.").arg(rounded(*depth)));
}

void FocusFinder::take(const QPoint& pixel, const std::optional<double>& focus, bool isApplied) {
  if (!focus) {
    Q_EMIT found(pixel, tr("No focus: there is no contrast here."));
    if (isApplied) Q_EMIT failed(tr("There is no contrast here to focus on"));
    return;
  }
  if (isApplied)
    m_model->editMarked([&](CameraState& state) { state.pupil.focus = rounded(*focus); });
  Q_EMIT found(
      pixel,
      tr("Sharp at a focus of %1 m, %2 dpt.").arg(rounded(*focus)).arg(1 / *focus, 0, 'f', 2));
}

/// An edit of anything but the pupil makes the answer wrong.
void FocusFinder::forgetEdited() {
  if (!m_asked || !m_pixel) return;
  const std::optional<PickedView> now = m_viewAt(*m_pixel);
  if (now && areAlike(now->job, *m_asked)) return;
  m_task->abandon();
  m_asked.reset();
  Q_EMIT found(*m_pixel, {});
}

}  // namespace hogelscope
