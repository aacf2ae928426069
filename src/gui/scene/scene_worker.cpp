// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/scene_worker.h"

#include <algorithm>
#include <utility>

#include "core/engine/scaled_view.h"
#include "gui/widgets/task.h"

namespace hogelscope {

namespace {

/// The approximate width or height of a state's image in the scene, in pixels.
constexpr int smallSide = 192;

/// Returns the image; null if it cannot be rendered or was cancelled.
VtkImage imageOf(const RenderJob& view, const std::array<std::uint8_t, 3>& unseen,
                 vtkHogelViewFilter& filter) {
  try {
    filter.SetJob(reduced(view));  // throws if the camera has no frame
    filter.UpdateOrThrow();
    return toVtkImage(*filter.GetOutput(), unseen);
  } catch (const std::exception&) {
    return nullptr;  // cancelled, or reported by the simulated view
  }
}

/// Returns the fastest job, for display only.
RenderJob quick(const RenderJob& asked) {
  RenderJob view = overview(asked);
  view.sampling.tolerance = 0;
  view.sampling.samplesPerPixel = 1;
  view.state.pupil = {};
  return view;
}

}  // namespace

SceneWorker::SceneWorker(QObject* parent) : QObject(parent) {
  m_filter->SetProgress([this](double) { return !mustStop(); });
  m_thread.start([this] { return hasWork(); }, [this](LatestWins::Lock& lock) { serve(lock); });
}

void SceneWorker::setSource(const std::optional<ViewSource>& scene) {
  m_thread.ask([&] {
    m_newScene = scene;
    m_isSceneNew = true;
    ++m_asked;
    m_panel.reset();
    m_states.clear();
    m_done.clear();
  });
}

void SceneWorker::renderPanel(const CameraState& state) {
  m_thread.ask([&] { m_panel = state; });
}

void SceneWorker::renderStates(const std::vector<CameraState>& states,
                               std::vector<std::size_t> wanted) {
  m_thread.ask([&] {
    m_states = states;
    m_done.resize(states.size());
    m_wanted = std::move(wanted);
  });
}

std::optional<std::size_t> SceneWorker::nextState() const {
  for (const std::size_t index : m_wanted)
    if (index < m_states.size() && m_done[index] != m_states[index]) return index;
  return std::nullopt;
}

bool SceneWorker::hasWork() const {
  return m_isSceneNew || (m_scene && (m_panel || nextState()));
}

bool SceneWorker::mustStop() {
  return m_thread.mustStop([this] { return m_isSceneNew; });
}

/// Switches to a new scene. Returns true if there is one.
bool SceneWorker::switchScene() {
  if (!std::exchange(m_isSceneNew, false)) return false;
  m_scene = std::exchange(m_newScene, std::nullopt);
  m_number = m_asked;
  return true;
}

void SceneWorker::serve(LatestWins::Lock& lock) {
  const bool isNew = switchScene();
  const std::optional<CameraState> panel =
      m_scene ? std::exchange(m_panel, std::nullopt) : std::nullopt;
  lock.unlock();
  if (isNew) m_filter->SetJob({});  // it may hold the last reference to the old light field
  if (isNew) makeMesh();
  if (!m_scene) return;
  if (!panel) return renderNextState();
  const VtkImage image = imageOf(quick(m_scene->job(*panel)), panelColour, *m_filter);
  if (image != nullptr)
    queueAnswer(this, m_asked, m_number, [this, image] { Q_EMIT panelRendered(image); });
}

void SceneWorker::makeMesh() {
  if (!m_scene) return;
  if (m_meshOf.lock() != m_scene->lightField) {
    m_meshOf = m_scene->lightField;
    m_mesh = nullptr;
    const LiveScene* const live = m_scene->lightField->scene();
    try {
      if (live != nullptr) m_mesh = toVtkMesh(live->triangles());
    } catch (const std::exception&) {
      // a plugin's error; the simulated view still works
    }
  }
  queueAnswer(this, m_asked, m_number, [this, mesh = m_mesh] { Q_EMIT meshMade(mesh); });
}

void SceneWorker::renderNextState() {
  std::optional<CameraState> state;
  std::size_t index = 0;
  m_thread.ask([&] {
    const std::optional<std::size_t> next = nextState();
    if (!next) return;
    index = *next;
    state = m_states[index];
    m_done[index] = state;
  });
  if (!state) return;
  RenderJob view = quick(m_scene->job(*state));
  const auto [width, height] = state->camera.res;
  view.method.scale = (std::max(width, height) + smallSide - 1) / smallSide;
  VtkImage image = imageOf(view, {0, 0, 0}, *m_filter);
  if (image == nullptr) image = toVtkImage(Image(1, 1), {0, 0, 0});  // black
  queueAnswer(this, m_asked, m_number,
              [this, index, image] { Q_EMIT stateRendered(int(index), image); });
}

}  // namespace hogelscope
