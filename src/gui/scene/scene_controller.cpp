// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/scene_controller.h"

#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/engine/hogel_pixels.h"
#include "core/optics/scene_eyes.h"
#include "core/panel/viewing_zone.h"
#include "gui/scene/display_scene.h"
#include "gui/scene/scene_actor.h"
#include "gui/scene/vtk_widget.h"
#include "gui/session/session_model.h"
#include "ui_main_window.h"

namespace hogelscope {

namespace {

VtkImage hogelImageOf(const LightFieldSource& lightField, int i, int j) {
  try {
    return toVtkImage(hogelImage(lightField, i, j), {0, 0, 0});
  } catch (const InputError&) {  // damaged; reported by the simulated view
    return toVtkImage(Image(1, 1), {0, 0, 0});
  }
}

QRegion regionOf(const std::vector<PixelRun>& runs) {
  std::vector<QRect> rows;
  rows.reserve(runs.size());
  for (const PixelRun& run : runs) rows.emplace_back(run.x0, run.y, run.x1 - run.x0, 1);
  QRegion region;
  region.setRects(rows.data(), int(rows.size()));
  return region;
}

}  // namespace

SceneController::SceneController(const Ui::MainWindow& form, SessionModel* model, QObject* parent)
    : QObject(parent),
      m_form(form),
      m_model(model),
      m_worker(new SceneWorker(this)),
      m_scene(std::make_unique<DisplayScene>(*form.sceneWidget, nullptr)) {
  connectActions();
  connectModel();
  connectScene();
  showText();
  m_scene->reset();
}

SceneController::~SceneController() = default;

void SceneController::connectActions() {
  const auto on = [this](QAction* action, auto slot) {
    connect(action, &QAction::triggered, this, slot);
  };
  on(m_form.fitAction, [this] { m_scene->fit(); });
  on(m_form.sceneFrontAction, [this] { m_scene->lookFrom(SceneSide::front); });
  on(m_form.sceneTopAction, [this] { m_scene->lookFrom(SceneSide::top); });
  on(m_form.sceneSideAction, [this] { m_scene->lookFrom(SceneSide::right); });
  on(m_form.sceneBackAction, [this] { m_scene->lookFrom(SceneSide::back); });
  on(m_form.sceneBottomAction, [this] { m_scene->lookFrom(SceneSide::bottom); });
  on(m_form.sceneLeftSideAction, [this] { m_scene->lookFrom(SceneSide::left); });
  connect(m_form.sceneParallelAction, &QAction::toggled, this,
          [this](bool isOn) { m_scene->setParallel(isOn); });
  // Keys of the scene only, because arrows have other meanings elsewhere.
  const auto onScene = [this, on](QAction* action, auto slot) {
    m_form.sceneWidget->addAction(action);
    on(action, slot);
  };
  constexpr double step = 5;  // degrees
  onScene(m_form.sceneLeftAction, [this] { m_scene->turn(-step, 0); });
  onScene(m_form.sceneRightAction, [this] { m_scene->turn(step, 0); });
  onScene(m_form.sceneUpAction, [this] { m_scene->turn(0, step); });
  onScene(m_form.sceneDownAction, [this] { m_scene->turn(0, -step); });
  onScene(m_form.sceneNearerAction, [this] { m_scene->approach(1.1); });
  onScene(m_form.sceneFartherAction, [this] { m_scene->approach(1 / 1.1); });
  on(m_form.sceneForgetAction, [this] { removePicks(); });
  on(m_form.sceneLookThroughAction, [this] {
    m_form.sceneParallelAction->setChecked(false);  // a camera has a perspective projection
    m_scene->lookThrough(m_model->current());
  });
  on(m_form.sceneSetStateAction, [this] { setStateFromScene(); });
  on(m_form.scenePanelPictureAction, [this] { renderPanel(); });
  on(m_form.sceneStatePicturesAction, [this] { renderStates(); });
  on(m_form.sceneMeshAction, [this] { showMesh(); });
  const auto onPart = [this](QAction* action, auto show) {
    const auto showAndDraw = [this, show](bool isOn) {
      show(isOn);
      m_scene->redraw();
    };
    connect(action, &QAction::toggled, this, showAndDraw);
    showAndDraw(action->isChecked());
  };
  onPart(m_form.sceneFrustaAction, [this](bool isOn) { m_scene->frusta().setVisible(isOn); });
  onPart(m_form.sceneZoneAction, [this](bool isOn) { m_scene->zone().setVisible(isOn); });
  onPart(m_form.sceneGridAction, [this](bool isOn) { m_scene->panel().setGridVisible(isOn); });
  onPart(m_form.sceneAxesAction, [this](bool isOn) { m_scene->panel().setAxesVisible(isOn); });
  onPart(m_form.sceneScaleBarAction,
         [this](bool isOn) { m_scene->panel().setScaleBarVisible(isOn); });
  const auto resize = [this](double factor) {
    return [this, factor] {
      m_scene->frusta().setSize(factor * m_scene->frusta().size());
      m_scene->redraw();
    };
  };
  on(m_form.sceneLargerFrustaAction, resize(1.5));
  on(m_form.sceneSmallerFrustaAction, resize(1 / 1.5));
}

void SceneController::connectModel() {
  connect(m_model, &SessionModel::opened, this, [this] {
    m_scene->frusta().showPsnr({});
    forgetPicks();
    setSource(std::nullopt);
    m_scene->reset();
  });
  connect(m_model, &SessionModel::currentChanged, this, [this] {
    forgetPicks();
    refresh();
  });
  connect(m_model, &SessionModel::statesChanged, this, [this] {
    m_scene->frusta().showPsnr({});  // values of other states
    forgetPicks();
    refresh();
  });
  connect(m_model, &SessionModel::edited, this, [this] {
    tracePixel();
    markHogel();
    refresh();
  });
}

void SceneController::connectScene() {
  connect(m_form.sceneWidget, &VtkWidget::clicked, this, &SceneController::pickAt);
  connect(m_form.sceneWidget, &VtkWidget::hovered, this, &SceneController::nameAt);
  connect(m_scene.get(), &DisplayScene::eyeChanged, this, &SceneController::renderPanel);
  connect(m_worker, &SceneWorker::panelRendered, this, [this](const VtkImage& image) {
    if (!m_form.scenePanelPictureAction->isChecked() || m_isPanelDark) return;
    m_scene->panel().setImage(image);
    m_scene->redraw();
  });
  connect(m_worker, &SceneWorker::stateRendered, this, [this](int index, const VtkImage& image) {
    m_scene->frusta().setImage(std::size_t(index), image);
    m_scene->redraw();
  });
  connect(m_worker, &SceneWorker::meshMade, this, [this](const VtkMesh& mesh) {
    m_scene->mesh().setMesh(mesh);
    m_scene->redraw();
  });
  connect(&m_scene->handles(), &SceneHandles::meshDragged, this, &SceneController::moveMesh);
  const auto moved = [this](Vec3 CameraParams::*point) {
    return [this, point](const Vec3& to) {
      CameraState state = m_model->current();
      state.camera.*point = rounded(to);
      m_model->setCurrent(state);
    };
  };
  connect(&m_scene->handles(), &SceneHandles::eyeDragged, this, moved(&CameraParams::eye));
  connect(&m_scene->handles(), &SceneHandles::lookatDragged, this, moved(&CameraParams::lookat));
}

void SceneController::setSource(const std::optional<ViewSource>& scene) {
  m_loaded = scene;
  m_display = scene ? scene->display : displayOf(m_model->session());
  m_worker->setSource(scene);
  if (!scene) {
    m_scene->panel().setImage(nullptr);
    m_scene->frusta().clearImages();
    m_scene->mesh().setMesh(nullptr);
  }
  refresh();
}

void SceneController::showPsnr(const std::vector<double>& dB) {
  m_scene->frusta().showPsnr(dB);
  m_scene->redraw();
}

void SceneController::showPreview(const std::vector<CameraState>& states) {
  m_scene->frusta().showPreview(states);
  m_scene->redraw();
}

/// Updates the scene after a change of the model.
void SceneController::refresh() {
  m_scene->show(m_display, m_model->session().cameras, m_model->currentIndex());
  showMesh();
  renderPanel();
  renderStates();
  showText();
}

/// Returns the offset of the mesh's ball from its origin, in the display frame. It keeps the ball
/// apart from those of states that look at the origin.
Vec3 SceneController::toMeshBall() const {
  const double step = 0.08 * m_display.size[1];
  return {step, step, 0};
}

/// Shows the mesh, with a ball beside it if the content has a position.
void SceneController::showMesh() {
  const bool isShown = m_form.sceneMeshAction->isChecked();
  m_scene->mesh().setVisible(isShown);
  const auto* position =
      m_model->session().lightField.content.find<std::vector<double>>("position");
  std::optional<Vec3> origin;
  if (isShown && position != nullptr && position->size() == 3)
    origin = transformFromPose(m_display.position, m_display.orientation)
                 .point(Vec3{(*position)[0], (*position)[1], (*position)[2]} + toMeshBall());
  m_scene->handles().showMeshAt(origin);
  m_scene->redraw();
}

/// Rounds to the decimal place that a screen pixel resolves.
Vec3 SceneController::rounded(const Vec3& place) const {
  const double perMetre = std::pow(10, -std::floor(std::log10(m_scene->pixelOnPanel())));
  const auto round = [perMetre](double x) { return std::round(x * perMetre) / perMetre; };
  return {round(place.x), round(place.y), round(place.z)};
}

void SceneController::moveMesh(const Vec3& ball) {
  const auto toDisplay = transformFromPose(m_display.position, m_display.orientation).inverse();
  const Vec3 place = rounded(toDisplay.point(ball) - toMeshBall());
  m_model->edit(tr("Move the mesh"), [&](Session& session) {
    session.lightField.content.set("position", std::vector<double>{place.x, place.y, place.z});
  });
}

/// Renders the panel with one pixel per screen pixel, fewer for wide leakage windows.
void SceneController::renderPanel() {
  const CameraState current = m_model->current();
  const double longest = std::max(64, 1024 * 7 / std::max(7, current.psf.windowSize));
  const auto pixels = [&](double side) {
    return int(std::clamp(side / m_scene->pixelOnPanel(), 1.0, longest));
  };
  const auto [width, height] = m_display.size;
  const std::optional<CameraState> state =
      panelState(m_display, m_scene->viewpoint(), {pixels(width), pixels(height)});
  m_isPanelDark = !state || shareSeenFrom(m_display, m_scene->viewpoint()) == 0;
  if (!m_form.scenePanelPictureAction->isChecked() || !m_loaded || m_isPanelDark) {
    m_scene->panel().setImage(nullptr);
    return m_scene->redraw();
  }
  CameraState seen = *state;
  seen.psf = current.psf;
  m_worker->renderPanel(seen);
}

void SceneController::renderStates() {
  const bool areShown = m_form.sceneStatePicturesAction->isChecked();
  m_scene->frusta().setImagesVisible(areShown);
  if (areShown && m_loaded)
    m_worker->renderStates(m_model->session().cameras, m_model->currentIndex());
  m_scene->redraw();
}

void SceneController::setStateFromScene() {
  const CameraParams eye = m_scene->eye();
  CameraState state = m_model->current();
  state.camera.eye = eye.eye;
  state.camera.lookat = eye.lookat;
  state.camera.up = eye.up;
  m_model->setCurrent(state);
}

/// Picks a state or a hogel. Repeated clicks cycle through overlapping frusta.
void SceneController::pickAt(int x, int y) {
  const std::vector<int> states = m_scene->statesAt(x, y);
  if (states.empty()) {
    const std::optional<Hit> hogel = m_scene->hogelAt(x, y);
    if (hogel) showHogel(int(hogel->i), int(hogel->j));
    return;
  }
  const auto next = std::upper_bound(states.begin(), states.end(), int(m_model->currentIndex()));
  const int picked = next == states.end() ? states.front() : *next;
  m_model->setCurrentIndex(std::size_t(picked));
}

void SceneController::nameAt(int x, int y) {
  constexpr std::size_t mostNames = 12;
  QStringList names;
  const std::vector<int> states = m_scene->statesAt(x, y);
  for (const int index : states) {
    if (std::size_t(names.size()) == mostNames) {
      names << tr("and %1 more").arg(states.size() - mostNames);
      break;
    }
    names << SceneText::eye(m_model->session().cameras[std::size_t(index)], m_display);
  }
  if (names.isEmpty()) return QToolTip::hideText();
  QToolTip::showText(QCursor::pos(), names.join('\n'), m_form.sceneWidget);
}

void SceneController::forgetPicks() {
  m_pixel.reset();
  m_hogel.reset();
  m_pixelSearch.abandon();
  m_pickText.clear();
  m_form.pictureView->markPixels({});
  m_scene->picked().hideHogel();
  m_scene->picked().hideRay();
}

void SceneController::removePicks() {
  forgetPicks();
  showText();
  m_scene->redraw();
}

void SceneController::showHogel(int i, int j) {
  forgetPicks();
  if (!m_loaded) return;
  m_scene->picked().showHogel(m_display, i, j, hogelImageOf(*m_loaded->lightField, i, j));
  m_hogel = QPoint(i, j);
  m_pickText = SceneText::hogel(m_display, i, j);
  markHogel();
  showText();
  m_scene->redraw();
}

/// Marks the pixels that see the picked hogel.
void SceneController::markHogel() {
  const std::optional<RenderJob> view = job();
  if (!m_hogel || !view) return;
  m_pixelSearch.start(
      [this, job = *view, hogel = *m_hogel](const Progress& progress) -> Task::Answer {
        try {
          const auto runs = pixelsSeeing(job, hogel.x(), hogel.y(), parallelRows, progress);
          return [this, region = regionOf(runs)] { m_form.pictureView->markPixels(region); };
        } catch (const InputError&) {  // a camera without a frame, reported by the simulated view
          return [this] { m_form.pictureView->markPixels({}); };
        }
      });
}

std::optional<RenderJob> SceneController::job() const {
  if (!m_loaded || m_model->session().cameras.empty()) return {};
  return m_loaded->job(m_model->current());
}

void SceneController::showPixel(int x, int y) {
  m_pixel = QPoint(x, y);
  tracePixel();
  showText();
  m_scene->redraw();
}

void SceneController::tracePixel() {
  if (!m_pixel) return;
  const QPoint pixel = *m_pixel;
  forgetPicks();
  const std::optional<RenderJob> view = job();
  if (!view) return;
  const auto [width, height] = view->state.camera.res;
  if (!QRect(0, 0, width, height).contains(pixel)) return;
  try {
    const PixelTrace traced = pixelTrace(*view, pixel.x(), pixel.y());
    m_pixel = pixel;
    m_form.pictureView->markPixels(QRect(pixel, QSize(1, 1)));
    m_pickText = SceneText::pixel(pixel.x(), pixel.y(), traced);
    if (traced.end == RayEnd::noRay) return;
    m_scene->picked().showRay(traced.eye, traced.target);
    if (traced.end == RayEnd::misses) return;
    const int i = int(traced.place->i);
    const int j = int(traced.place->j);
    m_scene->picked().showHogel(m_display, i, j, hogelImageOf(*m_loaded->lightField, i, j));
  } catch (const InputError&) {
    // A camera without a frame is reported by the simulated view.
  }
}

void SceneController::showText() {
  m_form.sceneForgetAction->setEnabled(!m_pickText.isEmpty());
  Q_EMIT pickChanged();
  if (m_model->session().cameras.empty()) return m_form.sceneReadout->clear();
  const QString hint = tr("Click a frustum, a hogel, or a pixel of the simulated view.");
  m_form.sceneReadout->setText(SceneText::eye(m_model->current(), m_display) + '\n' +
                               (m_pickText.isEmpty() ? hint : m_pickText));
}

}  // namespace hogelscope
