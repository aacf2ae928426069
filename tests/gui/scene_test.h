// SPDX-License-Identifier: BSD-3-Clause
// Common parts of the 3-D scene's tests: the sample session in a large window, with some states
// side by side, and screen positions of objects.
#pragma once

#include <vtkRenderer.h>

#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>

#include "gui/scene/display_scene.h"
#include "gui/scene/scene_controller.h"
#include "gui/scene/vtk_widget.h"
#include "gui/widgets/colours.h"
#include "io/documents/session_file.h"
#include "io/scene/view_source.h"
#include "tests/gui/pattern_file.h"
#include "tests/gui/window_test.h"

inline bool isNear(const hogelscope::Vec3& a, const hogelscope::Vec3& b, double tolerance) {
  return length(a - b) <= tolerance;
}

class SceneTest : public WindowTest {
 protected:
  static constexpr const char* sampleFile = HOGELSCOPE_SOURCE_DIR "/data/table1.json";

  void start() { startWith({"display.directions=[6,6]"}); }
  /// Starts with small images, which are fast.
  void startSmall() { startWith({"display.directions=[6,6]", "camera.res=[120,120]"}); }
  void startWith(const std::vector<std::string>& overrides) {
    hogelscope::Session session = hogelscope::loadSession(sampleFile, overrides);
    session.lightField.file = m_folder.filePath("scene.png").toStdString();
    if (!QFileInfo::exists(m_folder.filePath("scene.png")))
      writePattern("scene", session.display, session.lightField.file);
    start(session);
  }
  void start(hogelscope::Session session) {
    showWindow({1400, 800});
    // Moves some side by side; the others stay at the first one's place.
    for (std::size_t k = 1; k < 4; ++k) session.cameras[k].camera.eye.x = 0.25 * double(k) - 0.3;
    open(session);
  }
  void open(const hogelscope::Session& session) {
    const QString file = m_folder.filePath("session.json");
    hogelscope::saveSession(file.toStdString(), session);
    m_session = session;
    m_loaded = hogelscope::loadViewSource(session, {});
    WindowTest::open(file);
    // Half of the window, so that the scene has the pixels that tests pick and count.
    child<QDockWidget>("statesDock")->hide();
    m_window->resizeDocks({child<QDockWidget>("sceneDock")}, {560}, Qt::Horizontal);
    QTest::qWait(100);
  }

  hogelscope::SceneController* controller() const {
    return m_window->findChild<hogelscope::SceneController*>();
  }
  hogelscope::DisplayScene& scene() const { return controller()->scene(); }
  hogelscope::VtkWidget* widget() const { return m_window->findChild<hogelscope::VtkWidget*>(); }
  QImage drawn() const { return widget()->image(); }
  /// Returns the scene with what is painted over it.
  QImage painted() const { return widget()->grab().toImage(); }
  QString readout() const { return child<QLabel>("sceneReadout")->text(); }
  int current() const { return child<QComboBox>("stateBox")->currentIndex(); }
  QDoubleSpinBox* spinBox(const char* name) const {
    return editor<QDoubleSpinBox>("cameraArea", name);
  }
  hogelscope::Vec3 edited(const char* name) const {
    std::array<double, 3> value{};
    for (int k = 0; k < 3; ++k)
      value[std::size_t(k)] = spinBox(qPrintable(QString("%1.%2").arg(name).arg(k)))->value();
    return {value[0], value[1], value[2]};
  }
  void edit(const char* name, double value) const { spinBox(name)->setValue(value); }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(m_window.get(), key, modifiers);
    QTest::qWait(50);
  }

  /// Returns where a point of the world is drawn in the widget.
  QPoint onScreen(const hogelscope::Vec3& p) const {
    vtkRenderer* renderer = scene().renderer();
    renderer->SetWorldPoint(p.x, p.y, p.z, 1);
    renderer->WorldToDisplay();
    const double* at = renderer->GetDisplayPoint();
    return {int(at[0]), widget()->height() - 1 - int(at[1])};
  }
  void drag(const QPoint& from, const QPoint& to) {
    QTest::mouseMove(widget(), from);
    QTest::mousePress(widget(), Qt::LeftButton, {}, from);
    // Windows of X tell a moving pointer of its buttons; QTest::mouseMove does not.
    for (int k = 1; k <= 5; ++k) {
      const QPoint at = from + (to - from) * k / 5;
      QMouseEvent move(QEvent::MouseMove, at, widget()->mapToGlobal(at), Qt::NoButton,
                       Qt::LeftButton, {});
      QCoreApplication::sendEvent(widget(), &move);
    }
    QTest::mouseRelease(widget(), Qt::LeftButton, {}, to);
    QTest::qWait(50);
  }
  void click(const QPoint& at) {
    QTest::mouseClick(widget(), Qt::LeftButton, {}, at);
    QTest::qWait(20);
  }
  /// Returns the lower right corner of a state's near plane.
  static hogelscope::Vec3 cornerOf(const hogelscope::CameraState& state) {
    const hogelscope::Camera camera(state.camera, state.intrinsics);
    const double depth = 0.25 * length(state.camera.lookat - state.camera.eye);
    const auto [width, height] = state.camera.res;
    const hogelscope::Vec2 p = camera.normalised(width - 0.5, height - 0.5);
    return camera.worldFromCamera().point({depth * p.x, depth * p.y, depth});
  }

  hogelscope::Session m_session;
  hogelscope::ViewSource m_loaded;
};
