// SPDX-License-Identifier: BSD-3-Clause
// Drives the camera set dock of the real window: the template, and what it says of the states that
// it would add.
#include <QComboBox>
#include <QDockWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>

#include "gui/docks/camera_set_widget.h"
#include "gui/scene/display_scene.h"
#include "gui/scene/scene_controller.h"
#include "gui/widgets/colours.h"
#include "tests/gui/shown_image.h"
#include "tests/gui/window_test.h"

using namespace hogelscope;

using States = std::vector<CameraState>;

class TestCameraSet : public WindowTest {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    start();
    m_sets = m_window->findChild<CameraSetWidget*>();
    m_previews = std::make_unique<QSignalSpy>(m_sets, &CameraSetWidget::previewChanged);
  }
  void cleanup() {
    m_previews.reset();
    m_window.reset();
  }

  /// The session's states have other lenses: a has one, b and c have none.
  void theTemplateIsChosenFromTheStates() {
    auto* box = child<QComboBox>("templateBox");
    QCOMPARE(items(*box), QStringList({"Current state (a)", "a", "b", "c"}));
    m_model->setCurrentIndex(1);
    QCOMPARE(box->itemText(0), QString("Current state (b)"));
    child<QPushButton>("addSetButton")->click();
    QCOMPARE(m_model->session().cameras.back().distortion.k1, 0.0);
    box->setCurrentIndex(box->findText("a"));
    child<QPushButton>("addSetButton")->click();
    QCOMPARE(m_model->session().cameras.back().distortion.k1, 0.1);
    QCOMPARE(box->currentText(), QString("a"));  // the list is another one
    QVERIFY(box->count() > 30);
    m_model->changeStates("delete a", [](Session& session) {
      session.cameras.erase(session.cameras.begin());
      return std::size_t(0);
    });
    QCOMPARE(box->currentText(), QString("Current state (b)"));
  }

  /// They are the states that the button adds.
  void thePreviewIsWhatIsAdded() {
    QVERIFY(m_previews->isEmpty());
    child<QDockWidget>("cameraSetDock")->show();
    child<QDockWidget>("cameraSetDock")->raise();
    QTRY_COMPARE_WITH_TIMEOUT(m_previews->size(), 1, patience);
    QCOMPARE(last().size(), std::size_t(16));
    // In the scene they have frusta, too.
    const auto frusta = [this] {
      return m_window->findChild<SceneController*>()->scene().frusta().points().size();
    };
    const std::size_t perState = frusta() / (16 + 3);
    QVERIFY(perState > 10);
    QVERIFY(count(child<VtkWidget>("sceneWidget")->image(), tokens().focus) > 50);
    m_sets->findChild<QSpinBox*>("count")->setValue(7);
    QCOMPARE(m_previews->size(), 2);
    QCOMPARE(last().size(), std::size_t(7));
    m_model->edit("move the panel", [](Session& session) { session.display.position.x = 1; });
    QCOMPARE(m_previews->size(), 3);
    QVERIFY(last()[0].camera.lookat.x > 0.5);
    auto* box = child<QComboBox>("templateBox");
    box->setCurrentIndex(2);
    Q_EMIT box->activated(2);
    QCOMPARE(last()[0].distortion.k1, 0.0);
    m_model->setCurrentIndex(2);  // does not count: b is the template
    const States wanted = last();
    QCOMPARE(m_previews->size(), 4);
    child<QPushButton>("addSetButton")->click();
    QVERIFY(last().empty());
    const States& all = m_model->session().cameras;
    QVERIFY(States(all.begin() + 3, all.end()) == wanted);
    m_model->setCurrentIndex(0);
    QCOMPARE(m_previews->size(), 5);  // nothing comes back by itself
    m_sets->findChild<QSpinBox*>("count")->setValue(5);
    QCOMPARE(last().size(), std::size_t(5));
    child<QDockWidget>("cameraSetDock")->hide();
    QVERIFY(last().empty());
    QCOMPARE(count(child<VtkWidget>("sceneWidget")->image(), tokens().focus), 0);
    QCOMPARE(m_previews->size(), 7);
    m_sets->findChild<QSpinBox*>("count")->setValue(6);
    QCOMPARE(m_previews->size(), 7);  // nobody sees it
  }

 private:
  static QStringList items(const QComboBox& box) {
    QStringList texts;
    for (int k = 0; k < box.count(); ++k) texts << box.itemText(k);
    return texts;
  }
  [[nodiscard]] States last() const { return m_previews->last()[0].value<States>(); }

  CameraSetWidget* m_sets = nullptr;
  std::unique_ptr<QSignalSpy> m_previews;
};

int main(int argc, char** argv) {
  return runWindowTest<TestCameraSet>(argc, argv);
}
#include "test_camera_set.moc"
