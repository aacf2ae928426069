// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/scene_controller.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/error.h"
#include "core/engine/hogel_pixels.h"
#include "core/optics/scene_eyes.h"
#include "gui/scene/display_scene.h"
#include "gui/scene/vtk_widget.h"
#include "gui/session/session_model.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/command.h"
#include "io/layouts/layouts.h"
#include "picture/scene_text.h"

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

SceneController::SceneController(QMenu* menu, VtkWidget* widget, QLabel* readout,
                                 SessionModel* model, QObject* parent)
    : QObject(parent),
      m_widget(widget),
      m_readout(readout),
      m_model(model),
      m_worker(new SceneWorker(this)),
      m_scene(std::make_unique<DisplayScene>(*widget, nullptr)) {
  addCommands(menu);
  addTools(menu);
  connectModel();
  connectScene();
  m_stateDelay.setSingleShot(true);
  m_stateDelay.setInterval(200);
  connect(&m_stateDelay, &QTimer::timeout, this, [this] {
    if (m_isPanelOld) renderPanel();
    requestStates();
  });
  showText();
  m_scene->reset();
}

SceneController::~SceneController() = default;

void SceneController::addCommands(QMenu* menu) {
  addSides(menu);
  addTurns(menu->addMenu(tr("T&urn and zoom")));
  menu->addSeparator();
  m_forget = addCommand(menu,
                        {"sceneForgetAction", tr("Re&move what is picked"),
                         tr("Takes the picked hogel's field and picture and the picked pixel's ray "
                            "out of the scene (Esc)"),
                         Qt::Key_Escape},
                        this, &SceneController::removePicks);
  menu->addSeparator();
  addCommand(menu,
             {"sceneLookThroughAction", tr("&Look through the current state"),
              tr("Puts the scene's eye where the current state's camera is, with its vertical "
                 "field of view"),
              Qt::Key_F8},
             this, [this] {
               m_parallel->setChecked(false);  // a camera has a perspective projection
               m_scene->lookThrough(m_model->current());
             });
  addCommand(menu,
             {"sceneSetStateAction", tr("S&et the current state from the scene"),
              tr("Gives the current state the eye, look-at point and up of the scene; its field of "
                 "view and lens stay"),
              Qt::Key_F9},
             this, &SceneController::setStateFromScene);
  menu->addSeparator();
  m_panelImage = addSwitch(menu,
                           {"scenePanelPictureAction", tr("&Panel shows what is seen"),
                            tr("On: what the scene's own eye would see on the panel, with the "
                               "current state's PSF. Off: a plain panel with its hogel grid"),
                            Qt::CTRL | Qt::Key_G},
                           true, this, &SceneController::renderPanel);
  m_stateImages = addSwitch(menu,
                            {"sceneStatePicturesAction", tr("P&ictures on the frusta"),
                             tr("Each state's simulated view, small, on its near plane"),
                             Qt::CTRL | Qt::SHIFT | Qt::Key_G},
                            false, this, [this] {
                              m_worker->setSource(m_loaded);  // the list alone has old pictures
                              refresh();
                            });
  m_showsMesh = addSwitch(
      menu,
      {"sceneMeshAction", tr("&Mesh of a live scene"),
       tr("The mesh that the display shows, where it stands; its ball is dragged to move it"),
       Qt::CTRL | Qt::SHIFT | Qt::Key_B},
      true, this, &SceneController::showMesh);
  addParts(menu->addMenu(tr("S&how")));
  m_measures =
      addSwitch(menu,
                {"sceneMeasureAction", tr("Measu&re"),
                 tr("Two clicks show the distance of two points: of eyes, the look-at point, the "
                    "panel's corners, the panel or the mesh. A third click begins anew, Esc ends"),
                 Qt::ALT | Qt::SHIFT | Qt::Key_M},
                false, this, &SceneController::setMeasuring);
  menu->addSeparator();
}

/// Puts the buttons of some commands over the scene's upper left corner.
void SceneController::addTools(QMenu* menu) {
  auto* tools = new QHBoxLayout;
  tools->setSpacing(scaled(2));
  for (const auto& [name, picture] :
       {std::pair("scenePanelPictureAction", "seen"), std::pair("sceneZoneAction", "zone"),
        std::pair("sceneGridAction", "depth"), std::pair("sceneMeasureAction", "ruler"),
        std::pair("fitAction", "fit")}) {
    auto* action = menu->findChild<QAction*>(name);
    action->setIcon(icon(picture));
    auto* button = new QToolButton(m_widget);
    button->setObjectName(QString(name).replace("Action", "Button"));
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
    button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the scene
    button->setCursor(Qt::ArrowCursor);
    button->setIconSize({scaled(16), scaled(16)});
    tools->addWidget(button);
  }
  tools->addStretch();
  auto* rows = new QVBoxLayout(m_widget);
  rows->setContentsMargins(8, 8, 8, 8);
  rows->addLayout(tools);
  rows->addStretch();
}

void SceneController::addSides(QMenu* menu) {
  addCommand(menu,
             {"fitAction", tr("&Fit scene"),
              tr("Shows the display and all cameras in the 3-D scene, from the side that you look "
                 "from; again: from the front"),
              Qt::CTRL | Qt::Key_0},
             this, [this] { m_scene->fit(); });
  const auto add = [this, menu](const CommandText& text, SceneSide side) {
    addCommand(menu, text, this, [this, side] { m_scene->lookFrom(side); });
  };
  add({"sceneFrontAction", tr("F&ront"), tr("Looks at the panel from its front"), Qt::Key_F5},
      SceneSide::front);
  add({"sceneTopAction", tr("&Top"), tr("Looks at the panel from above"), Qt::Key_F6},
      SceneSide::top);
  add({"sceneSideAction", tr("Ri&ght side"), tr("Looks at the panel from its right"), Qt::Key_F7},
      SceneSide::right);
  add({"sceneBackAction", tr("&Back"), tr("Looks at the panel from behind"),
       Qt::SHIFT | Qt::Key_F5},
      SceneSide::back);
  add({"sceneBottomAction", tr("Botto&m"), tr("Looks at the panel from below"),
       Qt::SHIFT | Qt::Key_F6},
      SceneSide::bottom);
  add({"sceneLeftSideAction", tr("Left si&de"), tr("Looks at the panel from its left"),
       Qt::SHIFT | Qt::Key_F7},
      SceneSide::left);
  m_parallel = addSwitch(menu,
                         {"sceneParallelAction", tr("Para&llel projection"),
                          tr("Lengths across the view are the same at any distance; the panel "
                             "shows what is seen from very far away"),
                          Qt::ALT | Qt::SHIFT | Qt::Key_P},
                         false, this, [this](bool isOn) { m_scene->setParallel(isOn); });
}

/// Adds commands whose keys work in the scene only, because arrows have other meanings elsewhere.
void SceneController::addTurns(QMenu* menu) {
  const auto add = [this, menu](const CommandText& text, auto slot) {
    QAction* action = addCommand(menu, text, this, slot);
    action->setShortcutContext(Qt::WidgetShortcut);
    m_widget->addAction(action);
  };
  constexpr double step = 5;  // degrees
  add({"sceneLeftAction", tr("Eye to the &left"),
       tr("The scene's eye goes round the panel, to the left"), Qt::Key_Left},
      [this] { m_scene->turn(-step, 0); });
  add({"sceneRightAction", tr("Eye to the &right"),
       tr("The scene's eye goes round the panel, to the right"), Qt::Key_Right},
      [this] { m_scene->turn(step, 0); });
  add({"sceneUpAction", tr("Eye &up"), tr("The scene's eye goes round the panel, upwards"),
       Qt::Key_Up},
      [this] { m_scene->turn(0, step); });
  add({"sceneDownAction", tr("Eye &down"), tr("The scene's eye goes round the panel, downwards"),
       Qt::Key_Down},
      [this] { m_scene->turn(0, -step); });
  add({"sceneNearerAction", tr("&Nearer"), tr("The scene's eye comes nearer"), Qt::Key_Plus},
      [this] { m_scene->approach(1.1); });
  add({"sceneFartherAction", tr("&Farther"), tr("The scene's eye goes farther away"),
       Qt::Key_Minus},
      [this] { m_scene->approach(1 / 1.1); });
}

void SceneController::addParts(QMenu* menu) {
  const auto add = [this, menu](const CommandText& text, bool isOn, auto show) {
    const auto showAndDraw = [this, show](bool isShown) {
      show(isShown);
      m_scene->redraw();
    };
    addSwitch(menu, text, isOn, this, showAndDraw);
    showAndDraw(isOn);
  };
  const auto addSize = [this, menu](const CommandText& text, double factor) {
    addCommand(menu, text, this, [this, factor] {
      m_scene->frusta().setSize(factor * m_scene->frusta().size());
      m_scene->redraw();
    });
  };
  add({"sceneFrustaAction", tr("&Frusta"),
       tr("All states, each at its true field of view and aspect"),
       Qt::ALT | Qt::SHIFT | Qt::Key_F},
      true, [this](bool isOn) { m_scene->frusta().setVisible(isOn); });
  addSize({"sceneLargerFrustaAction", tr("&Larger frusta"),
           tr("Makes all frusta half as large again"), Qt::ALT | Qt::SHIFT | Qt::Key_Up},
          1.5);
  addSize({"sceneSmallerFrustaAction", tr("&Smaller frusta"),
           tr("Makes all frusta smaller by a third, at last no more than points"),
           Qt::ALT | Qt::SHIFT | Qt::Key_Down},
          1 / 1.5);
  add({"sceneZoneAction", tr("Viewing &zone"),
       tr("The points from which the whole panel is seen, as a body, and those from which some of "
          "it is seen, in lines; its outline at the current eye's depth is always there"),
       Qt::ALT | Qt::SHIFT | Qt::Key_Z},
      false, [this](bool isOn) { m_scene->zone().setVisible(isOn); });
  add({"sceneDepthsAction", tr("Sharp &depths"),
       tr("The panel's outline at the depths between which content is sharp for the current eye"),
       Qt::ALT | Qt::SHIFT | Qt::Key_D},
      false, [this](bool isOn) { m_scene->setDepthsVisible(isOn); });
  add({"sceneGridAction", tr("Hogel &grid"),
       tr("The hogel grid also where the panel shows what is seen; every 2nd, 4th, 8th … line "
          "where they are close together"),
       Qt::ALT | Qt::SHIFT | Qt::Key_G},
      false, [this](bool isOn) { m_scene->panel().setGridVisible(isOn); });
  add({"sceneTwinAction", tr("Errors of the &twin"),
       tr("Where the twin's lenses are shifted, as arrows of one scale, and which hogels are too "
          "bright or too dim, in orange and blue"),
       Qt::ALT | Qt::SHIFT | Qt::Key_B},
      true, [this](bool isOn) { m_scene->twin().setVisible(isOn); });
  add({"sceneAxesAction", tr("World &axes"), tr("The axes x, y, z of the world"),
       Qt::ALT | Qt::SHIFT | Qt::Key_A},
      false, [this](bool isOn) { m_scene->setAxesVisible(isOn); });
  add({"sceneScaleBarAction", tr("Scale &bar"),
       tr("A length at the depth of the panel's middle, at the lower left"),
       Qt::ALT | Qt::SHIFT | Qt::Key_R},
      true, [this](bool isOn) { m_scene->setScaleBarVisible(isOn); });
}

bool SceneController::showsPanelImage() const {
  return m_panelImage->isChecked();
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
    showModel();
    m_isPanelOld = true;  // it has the state's leakage
    m_stateDelay.start();
  });
}

void SceneController::connectScene() {
  connect(m_widget, &VtkWidget::clicked, this, &SceneController::pickAt);
  connect(m_widget, &VtkWidget::hovered, this, &SceneController::nameAt);
  connect(m_scene.get(), &DisplayScene::eyeChanged, this, &SceneController::renderPanel);
  connect(m_worker, &SceneWorker::panelRendered, this, [this](const VtkImage& image) {
    if (!showsPanelImage() || m_isPanelDark) return;
    m_scene->panel().setImage(image);
    m_scene->redraw();
  });
  connect(m_worker, &SceneWorker::stateRendered, this, [this](int index, const VtkImage& image) {
    Q_EMIT stateRendered(index, image);
    if (!m_stateImages->isChecked()) return;
    m_scene->frusta().setImage(std::size_t(index), image);
    m_scene->redraw();
  });
  connect(m_worker, &SceneWorker::meshMade, this, [this](const VtkMesh& mesh) {
    const bool isNew = !m_scene->mesh().isShown();
    m_scene->mesh().setMesh(mesh);
    if (isNew) m_scene->keepFitted();
    m_scene->redraw();
  });
  connect(&m_scene->handles(), &SceneHandles::dragged, this,
          [this](SceneBall ball, const Vec3& to) {
            if (ball == SceneBall::mesh) return moveMesh(to);
            CameraState state = m_model->current();
            Vec3& point = ball == SceneBall::eye ? state.camera.eye : state.camera.lookat;
            point = rounded(to, point, m_scene->pixelOnPanel());
            m_model->setCurrent(state);
          });
}

void SceneController::setSource(const std::optional<ViewSource>& scene) {
  m_loaded = scene;
  m_display = scene ? scene->display : displayOf(m_model->session());
  m_scene->twin().show(m_display, scene ? scene->twin.get() : nullptr);
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
  showModel();
  renderPanel();
}

void SceneController::showModel() {
  m_scene->show(m_display, m_model->session().cameras, m_model->currentIndex());
  showMesh();
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
  const bool isShown = m_showsMesh->isChecked();
  m_scene->mesh().setVisible(isShown);
  const auto* position =
      m_model->session().lightField.content.find<std::vector<double>>("position");
  std::optional<Vec3> origin;
  if (isShown && position != nullptr && position->size() == 3)
    origin = transformFromPose(m_display.position, m_display.orientation)
                 .point(Vec3{(*position)[0], (*position)[1], (*position)[2]} + toMeshBall());
  m_scene->handles().show(SceneBall::mesh, origin);
  m_scene->redraw();
}

void SceneController::moveMesh(const Vec3& ball) {
  const auto toDisplay = transformFromPose(m_display.position, m_display.orientation).inverse();
  const auto* before = m_model->session().lightField.content.find<std::vector<double>>("position");
  if (before == nullptr || before->size() != 3) return;
  const Vec3 place = rounded(toDisplay.point(ball) - toMeshBall(),
                             {(*before)[0], (*before)[1], (*before)[2]}, m_scene->pixelOnPanel());
  m_model->edit(tr("Move the mesh"), [&](Session& session) {
    session.lightField.content.set("position", std::vector<double>{place.x, place.y, place.z});
  });
}

/// Renders the panel with one pixel per screen pixel, fewer for wide leakage windows.
void SceneController::renderPanel() {
  m_isPanelOld = false;
  const CameraState current = m_model->current();
  const int longest = std::max(64, 1024 * 7 / std::max(7, current.psf.windowSize));
  std::optional<CameraState> seen =
      litPanelState(m_display, m_scene->viewpoint(), m_scene->pixelOnPanel(), longest);
  m_isPanelDark = !seen;
  if (!showsPanelImage() || !m_loaded || m_isPanelDark) {
    m_scene->panel().setImage(nullptr);
    return m_scene->redraw();
  }
  seen->psf = current.psf;
  m_worker->renderPanel(*seen);
}

/// Renders the states' images for the frusta at once, the current state's first; for the list
/// alone once nothing has been edited for a moment, so that they never delay the view.
void SceneController::renderStates() {
  const bool areShown = m_stateImages->isChecked();
  m_scene->frusta().setImagesVisible(areShown);
  m_scene->redraw();
  if (areShown)
    requestStates();
  else
    m_stateDelay.start();
}

void SceneController::requestStates() {
  if (!m_loaded) return;
  std::vector<std::size_t> wanted = m_watched;
  if (m_stateImages->isChecked()) {
    wanted.insert(wanted.begin(), m_model->currentIndex());
    for (std::size_t k = 0; k < m_model->session().cameras.size(); ++k) wanted.push_back(k);
  }
  m_worker->renderStates(m_model->session().cameras, std::move(wanted));
}

void SceneController::watchStates(const std::vector<std::size_t>& states) {
  if (std::exchange(m_watched, states) != states) m_stateDelay.start();
}

void SceneController::setStateFromScene() {
  const CameraParams eye = m_scene->eye();
  CameraState state = m_model->current();
  state.camera.eye = eye.eye;
  state.camera.lookat = eye.lookat;
  state.camera.up = eye.up;
  m_model->setCurrent(state);
}

void SceneController::setMeasuring(bool isOn) {
  if (isOn) forgetPicks();
  m_scene->measured().clear();
  m_widget->setCursor(isOn ? Qt::CrossCursor : Qt::ArrowCursor);
  showText();
  m_scene->redraw();
}

void SceneController::measureAt(int x, int y) {
  const std::optional<Vec3> point = m_scene->pointAt(x, y);
  if (!point) return;
  std::vector<Vec3>& points = m_scene->measured();
  if (points.size() == 2) points.clear();
  points.push_back(*point);
  showText();
  m_scene->redraw();
}

/// Picks a state or a hogel. Repeated clicks cycle through overlapping frusta.
void SceneController::pickAt(int x, int y) {
  if (m_measures->isChecked()) return measureAt(x, y);
  const std::vector<int> states = m_scene->statesAt(x, y);
  if (states.empty()) {
    const std::optional<Hit> hogel = m_scene->hogelAt(x, y);
    if (hogel && hasDirections(m_display)) showHogel(int(hogel->i), int(hogel->j));
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
  QToolTip::showText(QCursor::pos(), names.join('\n'), m_widget);
}

void SceneController::forgetPicks() {
  m_pixel.reset();
  m_hogel.reset();
  m_pixelSearch.abandon();
  m_pickText.clear();
  Q_EMIT pixelsMarked({});
  m_scene->picked().hideHogel();
  m_scene->picked().hideRay();
}

void SceneController::removePicks() {
  forgetPicks();
  m_measures->setChecked(false);
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
  const std::optional<PickedView> view = viewAt({});
  const bool isJoint = view && jointModeOf(m_eyes) && hasTwoEyes(m_model->current());
  if (!m_hogel || !view || isJoint) return;
  m_pixelSearch.start(
      [this, job = view->job, hogel = *m_hogel](const Progress& progress) -> Task::Answer {
        try {
          const auto runs = pixelsSeeing(job, hogel.x(), hogel.y(), parallelRows, progress);
          return [this, region = regionOf(runs)] { Q_EMIT pixelsMarked(region); };
        } catch (const InputError&) {  // a camera without a frame, reported by the simulated view
          return [this] { Q_EMIT pixelsMarked({}); };
        }
      });
}

std::optional<RenderJob> SceneController::job() const {
  if (!m_loaded || m_model->session().cameras.empty()) return {};
  return m_loaded->job(m_model->current());
}

std::optional<PickedView> SceneController::viewAt(const QPoint& pixel) const {
  std::optional<RenderJob> view = job();
  if (!view) return {};
  const EyePixel eye = eyeAt(m_eyes, view->state, m_display, pixel);
  view->state = eye.state;
  const auto [width, height] = eye.state.camera.res;
  if (!QRect(0, 0, width, height).contains(eye.pixel)) return {};
  return PickedView{*view, eye.pixel};
}

int SceneController::views() const {
  return viewsOnSheet(m_model->session());
}

void SceneController::setEyes(StereoView eyes) {
  if (std::exchange(m_eyes, eyes) == eyes) return;
  forgetPicks();
  showText();
  m_scene->redraw();
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
  const std::optional<PickedView> view = viewAt(pixel);
  if (!view) return;
  try {
    const PixelTrace traced = pixelTrace(view->job, view->pixel.x(), view->pixel.y());
    m_pixel = pixel;
    Q_EMIT pixelsMarked(QRect(pixel, QSize(1, 1)));
    m_pickText = SceneText::pixel(view->pixel.x(), view->pixel.y(), traced);
    if (traced.end == RayEnd::noRay) return;
    m_scene->picked().showRay(traced.eye, traced.target);
    if (traced.end == RayEnd::misses || !hasDirections(m_display)) return;
    const int i = int(traced.place->i);
    const int j = int(traced.place->j);
    m_scene->picked().showHogel(m_display, i, j, hogelImageOf(*m_loaded->lightField, i, j));
  } catch (const InputError&) {
    // A camera without a frame is reported by the simulated view.
  }
}

void SceneController::showText() {
  const bool measures = m_measures->isChecked();
  m_forget->setEnabled(measures || !m_pickText.isEmpty());
  Q_EMIT pickChanged();
  if (m_model->session().cameras.empty()) return m_readout->clear();
  m_readout->setText(measures               ? SceneText::measured(m_scene->measured())
                     : m_pickText.isEmpty() ? SceneText::eye(m_model->current(), m_display)
                                            : m_pickText);
}

}  // namespace hogelscope
