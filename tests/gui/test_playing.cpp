// SPDX-License-Identifier: BSD-3-Clause
// Plays paths of the camera in the real window.
#include <QAction>

#include "core/cameras/camera_path.h"
#include "gui/view/camera_player.h"
#include "gui/view/image_widget.h"
#include "tests/core/rendered.h"
#include "tests/gui/scene_test.h"
#include "tests/gui/shown_image.h"

using namespace hogelscope;

class TestPlaying : public SceneTest {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    startSmall();
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), own()), patience);
  }
  void cleanup() { m_window.reset(); }

  /// The view leaves the current state, and nothing is edited.
  void playsThroughTheStates() {
    QSignalSpy moved(player(), &CameraPlayer::moved);
    key(Qt::Key_Space, Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(moved.size() > 3, patience);
    QVERIFY(player()->shown().camera.eye != m_session.cameras[0].camera.eye);
    QTRY_VERIFY_WITH_TIMEOUT(!equals(view()->image(), own()), patience);
    QVERIFY(m_model->session() == m_session);
    QCOMPARE(m_model->currentIndex(), std::size_t(0));
    QCOMPARE(m_model->undoStack()->count(), 0);
    QVERIFY(!m_window->isWindowModified());
  }

  void escapeEndsIt() {
    for (const char* name : {"playAction", "playOrbitAction", "playTurntableAction"}) {
      begin(name);
      key(Qt::Key_Escape);
      isBack();
    }
  }

  void itsCommandEndsIt() {
    begin("playTurntableAction");
    child<QAction>("playTurntableAction")->trigger();
    isBack();
  }

  /// Another one of them goes on at once.
  void anotherCommandChangesThePath() {
    begin("playTurntableAction");
    child<QAction>("playOrbitAction")->trigger();
    const Vec3 lookat = m_model->current().camera.lookat;
    QTRY_VERIFY_WITH_TIMEOUT(player()->shown().camera.eye != m_model->current().camera.eye,
                             patience);
    QVERIFY(player()->shown().camera.lookat == lookat);
    key(Qt::Key_Escape);
    isBack();
  }

  void editsEndIt() {
    begin("playOrbitAction");
    key(Qt::Key_W);
    QVERIFY(m_model->current().camera.eye != m_session.cameras[0].camera.eye);
    isBack();
    begin("playOrbitAction");
    key(Qt::Key_PageDown);
    QCOMPARE(m_model->currentIndex(), std::size_t(1));
    isBack();
  }

  void endsByItself() {
    m_model->changeStates("two", [](Session& session) {
      session.cameras.resize(2);
      return std::size_t(0);
    });
    begin("playAction");
    QTRY_VERIFY_WITH_TIMEOUT(player()->shown() == m_model->current(), patience);
    isBack();
  }

  void saysWhatCannotBePlayed() {
    CameraState state = m_model->current();
    state.camera.res = {60, 50};
    m_model->setCurrent(state);
    child<QAction>("playAction")->trigger();
    QVERIFY(message().contains("differs from that of"));
    QVERIFY(player()->shown() == m_model->current());
    state.camera.lookat = state.camera.eye;
    m_model->setCurrent(state);
    m_model->changeStates("one", [](Session& session) {
      session.cameras.resize(1);
      return std::size_t(0);
    });
    child<QAction>("playOrbitAction")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("the camera looks nowhere"), patience);
    QVERIFY(player()->shown() == m_model->current());
  }

 private:
  CameraPlayer* player() const { return m_window->findChild<CameraPlayer*>(); }
  ImageWidget* view() const { return child<ImageWidget>("pictureView"); }
  Image own() const { return rendered(m_loaded.job(m_model->current())); }
  void begin(const char* name) {
    child<QAction>(name)->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(player()->shown().camera.eye != m_model->current().camera.eye,
                             patience);
  }
  /// The view shows the current state again.
  void isBack() {
    QVERIFY(player()->shown() == m_model->current());
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), own()), patience);
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestPlaying>(argc, argv);
}
#include "test_playing.moc"
