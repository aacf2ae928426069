// SPDX-License-Identifier: BSD-3-Clause
#include "gui/session/camera_commands.h"

#include "gui/session/session_model.h"
#include "gui/widgets/command.h"
#include "gui/widgets/guarded.h"

namespace hogelscope {

struct CameraCommands::MotionCommand {
  const char* name;
  QString title;
  QString help;  ///< %1 is the amount
  Motion motion;
  int sign;
  Qt::Key key;
};

std::vector<CameraCommands::MotionCommand> CameraCommands::motions() {
  const QString walk = tr("Moves the camera %1 along its view");
  const QString strafe = tr("Moves the camera %1 across its view");
  const QString rise = tr("Moves the camera %1 along its up direction");
  const QString turn = tr("Turns the view by %1 about the camera's up direction");
  const QString tilt = tr("Turns the view by %1, up to 1° from the camera's up direction");
  const QString roll = tr("Rolls the camera by %1 about its view");
  const QString across = tr("Takes the eye by %1 around the look-at, which stays in the middle");
  const QString up = tr("Takes the eye by %1 around the look-at, up to 1° from the up direction");
  return {
      {"walkForward", tr("Walk &forward"), walk, Motion::walk, 1, Qt::Key_W},
      {"walkBackward", tr("Walk &backward"), walk, Motion::walk, -1, Qt::Key_S},
      {"strafeLeft", tr("Strafe &left"), strafe, Motion::strafe, -1, Qt::Key_A},
      {"strafeRight", tr("Strafe &right"), strafe, Motion::strafe, 1, Qt::Key_D},
      {"rise", tr("Ri&se"), rise, Motion::rise, 1, Qt::Key_E},
      {"sink", tr("Sin&k"), rise, Motion::rise, -1, Qt::Key_Q},
      {"turnLeft", tr("Turn left"), turn, Motion::turn, -1, Qt::Key_J},
      {"turnRight", tr("Turn right"), turn, Motion::turn, 1, Qt::Key_L},
      {"tiltUp", tr("Tilt up"), tilt, Motion::tilt, 1, Qt::Key_I},
      {"tiltDown", tr("Tilt down"), tilt, Motion::tilt, -1, Qt::Key_K},
      {"rollLeft", tr("Roll left"), roll, Motion::roll, -1, Qt::Key_U},
      {"rollRight", tr("Roll right"), roll, Motion::roll, 1, Qt::Key_O},
      {"orbitLeft", tr("Orbit left"), across, Motion::orbitAcross, -1, Qt::Key_F},
      {"orbitRight", tr("Orbit right"), across, Motion::orbitAcross, 1, Qt::Key_H},
      {"orbitUp", tr("Orbit up"), up, Motion::orbitUp, 1, Qt::Key_T},
      {"orbitDown", tr("Orbit down"), up, Motion::orbitUp, -1, Qt::Key_G},
  };
}

CameraCommands::CameraCommands(QMenu* menu, SessionModel* model, QObject* parent)
    : QObject(parent), m_menu(menu), m_model(model) {
  addMotions(m_menu, 1);
  constexpr int large = 5;
  addMotions(m_menu->addMenu(tr("Lar&ge steps")), large);
  m_menu->addSeparator();
  addPsfSteps();
  m_menu->addSeparator();
  addSwitches();
  m_menu->addSeparator();
  addStates();
  add(m_menu, "lookAtPanel", tr("Face the pa&nel"),
      tr("Looks at the panel's middle; an eye behind the panel is taken to the same place in "
         "front"),
      Qt::Key_N, [this] { facePanel(); });
  connect(m_model, &SessionModel::opened, this, [this] {
    m_lenses.clear();
    m_windows.clear();
  });
}

template <class Action>
void CameraCommands::add(QMenu* menu, const QString& name, const QString& title,
                         const QString& help, const QKeySequence& key, Action action) {
  addCommand(menu, {name + "Action", title, help, key}, this, action);
}

/// Adds the motions; those with Shift have larger steps.
void CameraCommands::addMotions(QMenu* menu, int factor) {
  for (const MotionCommand& command : motions()) {
    const double step = factor * stepOf(command.motion);
    const QString amount =
        stepOf(command.motion) < 1 ? tr("%1 cm").arg(100 * step) : tr("%1°").arg(step);
    const QString title = QString(command.title).remove('&');
    const QString name = QString(command.name) + (factor == 1 ? "" : "Large");
    const QKeyCombination key(factor == 1 ? Qt::NoModifier : Qt::ShiftModifier, command.key);
    add(menu, name, command.title, command.help.arg(amount), key,
        [this, title, motion = command.motion, by = command.sign * step] {
          edit(title, [&](CameraState& state) { state.camera = moved(state.camera, motion, by); });
        });
  }
}

void CameraCommands::addPsfSteps() {
  const QString sigma = tr("Changes the leakage's σ by 0.05 px");
  const QString window = tr("Changes the width of the leakage's window by 2 px; 1 is no leakage");
  add(m_menu, "lessSigma", tr("Less &σ"), sigma, Qt::Key_Z, [this] { stepSigma(-1); });
  add(m_menu, "moreSigma", tr("More σ"), sigma, Qt::Key_X, [this] { stepSigma(1); });
  add(m_menu, "smallerWindow", tr("Smaller &window"), window, Qt::Key_C,
      [this] { stepWindow(-1); });
  add(m_menu, "largerWindow", tr("Larger window"), window, Qt::Key_V, [this] { stepWindow(1); });
}

void CameraCommands::addSwitches() {
  add(m_menu, "toggleDistortion", tr("Lens &distortion off or on"),
      tr("Sets the current state's coefficients to 0, or to what they were before"), Qt::Key_B,
      [this] {
        toggle<DistortionParams>(
            tr("lens distortion"),
            [](CameraState& state) -> DistortionParams& { return state.distortion; }, {}, m_lenses);
      });
  add(m_menu, "togglePsf", tr("Light leakage (&PSF) off or on"),
      tr("Sets the current state's window to 1, or to what it was before"), Qt::Key_P, [this] {
        toggle<int>(
            tr("light leakage"), [](CameraState& state) -> int& { return state.psf.windowSize; }, 1,
            m_windows);
      });
}

/// The model ignores indices without a state.
void CameraCommands::addStates() {
  add(m_menu, "nextState", tr("&Next state"), tr("Makes the next camera state current"),
      Qt::Key_PageDown, [this] { m_model->setCurrentIndex(m_model->currentIndex() + 1); });
  add(m_menu, "previousState", tr("Pre&vious state"), tr("Makes the camera state before current"),
      Qt::Key_PageUp, [this] { m_model->setCurrentIndex(m_model->currentIndex() - 1); });
}

/// Edits the current state, if there is one.
void CameraCommands::edit(const QString& name, const std::function<void(CameraState&)>& action) {
  const std::size_t current = m_model->currentIndex();
  if (current >= m_model->session().cameras.size()) return;
  guarded(this, [&] {
    m_model->edit(name, [&](Session& session) { action(session.cameras[current]); });
  });
}

void CameraCommands::facePanel() {
  const DisplayParams& display = m_model->session().display;
  const RigidTransform panel = transformFromPose(display.position, display.orientation);
  edit(tr("Face the panel"),
       [&](CameraState& state) { state.camera = facing(state.camera, panel); });
}

void CameraCommands::stepSigma(int steps) {
  edit(tr("Change sigma"),
       [&](CameraState& state) { state.psf.sigma = steppedSigma(state.psf.sigma, steps); });
}

void CameraCommands::stepWindow(int steps) {
  edit(tr("Change windowSize"), [&](CameraState& state) {
    state.psf.windowSize = steppedWindow(state.psf.windowSize, steps);
  });
}

template <class Value>
void CameraCommands::toggle(const QString& part, Value& (*in)(CameraState&), const Value& off,
                            Kept<Value>& kept) {
  CameraState state = m_model->current();
  const std::string& name = state.camera.name;
  const bool isOn = in(state) != off;
  if (isOn) kept[name] = in(state);
  if (!kept.contains(name)) {
    Q_EMIT failed(tr("%1 has no %2 to switch on").arg(QString::fromStdString(name), part));
    return;
  }
  const Value wanted = isOn ? off : kept[name];
  edit((isOn ? tr("Switch off %1") : tr("Switch on %1")).arg(part),
       [&](CameraState& other) { in(other) = wanted; });
}

}  // namespace hogelscope
