// SPDX-License-Identifier: BSD-3-Clause
// The section Twin in the real window: an edit is what the view shows, Y shows the design, the
// scene shows what is wrong where.
#include <QDoubleSpinBox>
#include <QUndoStack>

#include "gui/scene/display_scene.h"
#include "gui/scene/scene_controller.h"
#include "gui/view/image_widget.h"
#include "io/documents/session_file.h"
#include "io/documents/twin_file.h"
#include "io/scene/view_source.h"
#include "tests/core/rendered.h"
#include "tests/gui/shown_image.h"
#include "tests/gui/window_test.h"
#include "tests/io/documents.h"

using namespace hogelscope;

class TestTwinSection : public WindowTest {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { start(); }
  void init();
  void editsAreShown();
  void showsTheDesign();
  void changesOfLightMakeItLinear();
  void sceneShowsErrors();
  void savingKeepsTheUnit();

 private:
  void set(const char* field, double value) const {
    auto* box = editor<QDoubleSpinBox>("twinArea", field);
    QVERIFY2(box, field);
    box->setValue(value);
  }
  [[nodiscard]] Image expected(Session session) const {
    return rendered(loadViewSource(session, {}).job(m_model->current()));
  }
  [[nodiscard]] bool isShown(const Image& image) const {
    return equals(child<ImageWidget>("pictureView")->image(), image);
  }
};

void TestTwinSection::init() {
  QVERIFY(files(*m_window).open("s.json"));
  openSection("twin");
  QTRY_VERIFY_WITH_TIMEOUT(isShown(expected(m_model->session())), patience);
}

void TestTwinSection::editsAreShown() {
  set("rotation", 3);
  QCOMPARE(m_model->session().twin.lensArray.rotation, 3.0);
  const Image built = expected(m_model->session());
  Session designed = m_model->session();
  designed.twin = {};
  QVERIFY(built != expected(designed));
  QTRY_VERIFY_WITH_TIMEOUT(isShown(built), patience);
  m_model->undoStack()->undo();
  QVERIFY(m_model->session().twin.isZero());
  QTRY_VERIFY_WITH_TIMEOUT(isShown(expected(designed)), patience);
}

void TestTwinSection::showsTheDesign() {
  set("rotation", 3);
  const Image built = expected(m_model->session());
  Session designed = m_model->session();
  designed.twin = {};
  QTRY_VERIFY_WITH_TIMEOUT(isShown(built), patience);
  key(Qt::Key_Y);
  QTRY_VERIFY_WITH_TIMEOUT(isShown(expected(designed)), patience);
  QCOMPARE(m_model->session().twin.lensArray.rotation, 3.0);
  key(Qt::Key_Y);
  QTRY_VERIFY_WITH_TIMEOUT(isShown(built), patience);
}

/// A twin that adds light needs linear light in all states, in one edit.
void TestTwinSection::changesOfLightMakeItLinear() {
  QCOMPARE(m_model->session().cameras[1].psf.light, LightModel::encoded);
  set("black", 0.1);
  for (const CameraState& state : m_model->session().cameras)
    QCOMPARE(state.psf.light, LightModel::linear);
  QTRY_VERIFY_WITH_TIMEOUT(isShown(expected(m_model->session())), patience);
  m_model->undoStack()->undo();
  QCOMPARE(m_model->session().cameras[1].psf.light, LightModel::encoded);
  QVERIFY(m_model->session().twin.isZero());
}

void TestTwinSection::sceneShowsErrors() {
  const auto& twin = m_window->findChild<SceneController*>()->scene().twin();
  QCOMPARE(twin.arrows(), 0);
  set("rotation", 3);
  QTRY_VERIFY_WITH_TIMEOUT(twin.arrows() > 200, patience);  // of 16 × 16; the middle does not move
  QCOMPARE(twin.colours(), 0);
  TwinParams uneven;
  uneven.random.gain.sigma = 0.1;
  m_model->setContent(withTwin(m_model->session(), uneven));
  QTRY_COMPARE_WITH_TIMEOUT(twin.colours(), 256, patience);
  QCOMPARE(twin.arrows(), 0);
  m_model->setContent(withTwin(m_model->session(), {}));
  QTRY_COMPARE_WITH_TIMEOUT(twin.colours(), 0, patience);
}

/// A session is saved over no document that it names, under any name.
void TestTwinSection::savingKeepsTheUnit() {
  Session session = m_model->session();
  session.twin.lensArray.rotation = 1;
  session.twinFile = "unit.json";
  saveTwin("unit.json", session.twin);
  saveSession("twinned.json", session);
  QVERIFY(files(*m_window).open("twinned.json"));
  QVERIFY(QFile::link("unit.json", "link.json"));
  const QByteArray before = contentOf("unit.json");
  for (const char* name : {"unit.json", "link.json"}) QVERIFY(!files(*m_window).save(name));
  QCOMPARE(contentOf("unit.json"), before);
  QVERIFY(files(*m_window).save("twinned.json"));
}

int main(int argc, char** argv) {
  return runWindowTest<TestTwinSection>(argc, argv);
}

#include "test_twin_section.moc"
