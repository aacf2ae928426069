// SPDX-License-Identifier: BSD-3-Clause
// Drives the real window over meshes: opening, parameters, the mesh in the 3-D scene, the ideal
// view.
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <cmath>

#include "gui/docks/light_field_dock.h"
#include "gui/scene/mesh_actors.h"
#include "gui/scene/scene_controller.h"
#include "gui/session/library_menu.h"
#include "gui/view/image_widget.h"
#include "gui/view/view_worker.h"
#include "tests/core/rendered.h"
#include "tests/gui/scene_test.h"
#include "tests/gui/shown_image.h"
#include "tests/io/images.h"

using namespace hogelscope;

class TestLiveScenes : public SceneTest {
  Q_OBJECT

 private:
  ImageWidget* view() const { return child<ImageWidget>("pictureView"); }
  ViewSource sceneNow() const { return loadViewSource(m_model->session(), {}); }
  bool showsWhatIsTrue() const {
    return equals(view()->image(), rendered(sceneNow().job(m_model->current())));
  }
  QString text() const { return child<QLabel>("contentsLabel")->text(); }
  double x() const {
    return (*m_model->session().lightField.content.find<std::vector<double>>("position"))[0];
  }
  QDoubleSpinBox* position() const {
    return child<QWidget>("meshForm")->findChild<QDoubleSpinBox*>("position.0");
  }

 private Q_SLOTS:
  /// A small mesh with content behind and in front of the panel, and few directions.
  void init() {
    writeFile(m_folder.filePath("a.obj"),
              "v -1 -1 -1 1 0 0\nv 1 -1 -1 1 0 0\nv 1 1 -1 0 1 0\nv -1 1 -1 0 1 0\n"
              "v -0.3 -0.3 1 0 0 1\nv 0.3 -0.3 1 0 0 1\nv 0 0.3 1 0 0 1\nf 1 2 3 4\nf 5 6 7\n");
    showWindow({1400, 800});
    QVERIFY(files(*m_window).open(m_folder.filePath("a.obj")));
    QTRY_VERIFY_WITH_TIMEOUT(!view()->image().isNull(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(scene().mesh().isShown(), patience);
  }
  void cleanup() { m_window.reset(); }

  void opensAMesh() {
    QTRY_VERIFY_WITH_TIMEOUT(showsWhatIsTrue(), patience);
    QVERIFY2(text().contains("traced as each view needs it"), qPrintable(text()));
    QVERIFY(position() != nullptr && position()->accessibleName().endsWith(" m"));
    QVERIFY(child<QWidget>("liveForm") != nullptr);
    QVERIFY(child<QLabel>("depthLegend")->text().contains("content "));
  }

  void viewsFollowParameters() {
    const QImage before = view()->image();
    position()->setValue(0.05);
    QCOMPARE(x(), 0.05);
    QTRY_VERIFY_WITH_TIMEOUT(showsWhatIsTrue(), patience);
    QVERIFY(view()->image() != before);
    QCOMPARE(m_model->undoStack()->undoText(), QString("Change position"));
    child<QAction>("undoAction")->trigger();
    QCOMPARE(x(), 0.0);
    QTRY_COMPARE_WITH_TIMEOUT(view()->image(), before, patience);
    QCOMPARE(position()->value(), 0.0);
  }

  void sourcesHaveTheirParameters() {
    auto* source = child<QWidget>("lightFieldForm")->findChild<QLineEdit*>("source");
    const Session before = m_model->session();
    source->setText("nothing");
    Q_EMIT source->editingFinished();
    QVERIFY2(message().contains("plugin nothing: is not installed"), qPrintable(message()));
    QVERIFY(m_model->session() == before);
    QCOMPARE(source->text(), QString("mesh"));
    source->setText("scene");
    Q_EMIT source->editingFinished();
    QVERIFY(m_model->session().lightField.content.find<std::string>("file") == nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(showsWhatIsTrue(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(!scene().mesh().isShown(), patience);
  }

  void theMeshStandsInTheScene() {
    // It was fitted when it arrived, so that fitting it again changes nothing.
    const Vec3 eye = scene().eye().eye;
    child<QAction>("fitAction")->trigger();
    QVERIFY2(isNear(scene().eye().eye, eye, 1e-6), qPrintable(QString::number(length(eye))));
    QTest::qWait(50);
    const QImage with = drawn();
    child<QAction>("sceneMeshAction")->trigger();
    QVERIFY(!scene().mesh().isShown());
    QTRY_VERIFY_WITH_TIMEOUT(drawn() != with, patience);
    child<QAction>("sceneMeshAction")->trigger();
    QVERIFY(scene().mesh().isShown());
  }

  /// Half a million triangles are drawn; of more, a box.
  void aLargeMeshIsABox() {
    plugin::Triangles triangles;
    triangles.points = {-1, -2, -3, 4, 5, 6, 0, 0, 1};
    for (int k = 0; k < 500000; ++k) triangles.corners.insert(triangles.corners.end(), {0, 1, 2});
    QCOMPARE(toVtkMesh(triangles)->GetNumberOfPolys(), 500000);
    triangles.corners.insert(triangles.corners.end(), {0, 1, 2});
    const VtkMesh box = toVtkMesh(triangles);
    QCOMPARE(box->GetNumberOfPolys(), 0);
    QCOMPARE(box->GetNumberOfLines(), 12);
    std::array<double, 6> bounds{};
    box->GetBounds(bounds.data());
    QCOMPARE(bounds, (std::array<double, 6>{-1, 4, -2, 5, -3, 6}));
  }

  void theMeshIsDragged() {
    child<QAction>("sceneFrontAction")->trigger();
    child<QAction>("sceneStatePicturesAction")->setChecked(false);
    QTest::qWait(300);
    // Beside the origin, where the look-at point has its ball.
    const double step = 0.08 * m_model->session().display.size[1];
    const double z =
        (*m_model->session().lightField.content.find<std::vector<double>>("position"))[2];
    const QPoint from = onScreen({step, step, z});
    const QPoint to = onScreen({step + 0.05, step + 0.01, z});
    const QColor ball =
        painted().pixelColor(from);  // in front of the panel, where it stands behind
    QVERIFY2(ball.green() > ball.red() + 50 && ball.blue() > 60, qPrintable(ball.name()));
    const int count = m_model->undoStack()->count();
    const CameraState before = m_model->current();
    QTest::mouseMove(widget(), from);
    QTest::mousePress(widget(), Qt::LeftButton, {}, from);
    for (const QPoint& at : {(from + to) / 2, to}) {
      QTest::mouseMove(widget(), at);
      QTest::qWait(20);
    }
    QTest::mouseRelease(widget(), Qt::LeftButton, {}, to);
    QVERIFY2(std::abs(x() - 0.05) < 0.005, qPrintable(QString::number(x())));
    QVERIFY(m_model->current() == before);
    QCOMPARE(m_model->undoStack()->count(), count + 1);
    QTRY_VERIFY_WITH_TIMEOUT(showsWhatIsTrue(), patience);
  }

  /// An overview of all of the light field would be traced anew after each edit.
  void coarsePicturesReadWhatTheyShow() {
    std::vector<RenderedView> views;
    connect(m_window->findChild<ViewWorker*>(), &ViewWorker::rendered, this,
            [&](const RenderedView& view) { views.push_back(view); });
    m_model->edit("large", [](Session& session) { session.cameras[0].camera.res = {2500, 2500}; });
    for (const double at : {0.01, 0.02, 0.03}) {
      const std::size_t before = views.size();
      position()->setValue(at);
      QTRY_VERIFY_WITH_TIMEOUT(views.size() > before, patience);
    }
    QTRY_VERIFY_WITH_TIMEOUT(views.back().scale == 1, patience);
    for (const RenderedView& view : views) QVERIFY(!view.isOverview);
  }

  void theIdealView() {
    auto* compare = child<QAction>("compareIdealAction");
    QVERIFY(compare->isEnabled());
    compare->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!view()->otherImage().isNull(), patience);
    const auto isIdeal = [this] {
      ViewSource ideal = sceneNow();
      ideal.isIdeal = true;
      return equals(view()->otherImage(), rendered(ideal.job(m_model->current())));
    };
    QTRY_VERIFY_WITH_TIMEOUT(isIdeal(), patience);
    QVERIFY(view()->otherImage() != view()->image());
    position()->setValue(0.04);  // it follows edits
    QTRY_VERIFY_WITH_TIMEOUT(showsWhatIsTrue() && isIdeal(), patience);
    child<QAction>("stopComparingAction")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(view()->otherImage().isNull(), patience);
    QVERIFY(files(*m_window).open(sampleFile));
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
    QVERIFY(!compare->isEnabled());
  }

  /// Two displays side by side on one scene: the one that was kept stays while the other is edited.
  void aDisplayIsComparedWithWhatItWas() {
    const ViewSource before = sceneNow();
    child<QAction>("compareKeptAction")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!view()->otherImage().isNull(), patience);
    const auto isKept = [&] {
      return equals(view()->otherImage(), rendered(before.job(m_model->current())));
    };
    QTRY_VERIFY_WITH_TIMEOUT(isKept() && view()->otherImage() == view()->image(), patience);
    m_model->edit("fewer hogels", [](Session& session) {
      session.display.hogels = {9, 7};
      session.display.fov = {40, 40};
    });
    QTRY_VERIFY_WITH_TIMEOUT(showsWhatIsTrue() && isKept(), patience);
    QVERIFY(view()->otherImage() != view()->image());
    QCOMPARE(view()->titles(), QStringList({"Display", "Display before"}));
    child<QAction>("stopComparingAction")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(view()->otherImage().isNull(), patience);
    child<QAction>("undoAction")->trigger();
  }

  /// One command puts the content on another display and compares it with the one before; one undo
  /// takes it back.
  void theContentIsSeenOnOtherDisplays() {
    m_model->edit("a unit", [](Session& session) {
      session.display.position = {0.01, 0, 0};
      session.twin.lensArray.rotation = 0.01;
    });
    QTRY_VERIFY_WITH_TIMEOUT(view()->tag() == "as built", patience);
    const Session before = m_model->session();
    auto* see = child<QAction>("integral_imaging_8kAction");
    QVERIFY(see->isEnabled() && see->toolTip().contains("Infrared and Laser Engineering"));
    see->trigger();
    const DisplayParams wanted =
        loadSession(HOGELSCOPE_SOURCE_DIR "/data/displays/integral_imaging_8k.json").display;
    DisplayParams placed = wanted;
    placed.position = before.display.position;
    QVERIFY(m_model->session().display == placed);
    QVERIFY(m_model->session().twin.isZero() && m_model->session().cameras == before.cameras);
    QVERIFY(child<QAction>("wipeAction")->isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(showsWhatIsTrue() && !view()->otherImage().isNull(), patience);
    QCOMPARE(view()->titles(),
             QStringList({"Integral imaging, 8K, 31.5 inches", "Display before"}));
    child<QAction>("paperAction")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(showsWhatIsTrue(), patience);
    QCOMPARE(view()->titles(),
             QStringList({"The paper's display", "Integral imaging, 8K, 31.5 inches"}));
    child<QAction>("undoAction")->trigger();
    child<QAction>("undoAction")->trigger();
    QVERIFY(m_model->session() == before);
    child<QAction>("stopComparingAction")->trigger();
    // A capture becomes a scene, beside itself on its own display.
    QVERIFY(files(*m_window).open(sampleFile));
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms") && see->isEnabled(), patience);
    const Session stored = m_model->session();
    see->trigger();
    const LightFieldParams& shown = m_model->session().lightField;
    QCOMPARE(shown.source, std::string("session"));
    QCOMPARE(*shown.content.find<std::string>("file"), m_model->file().toStdString());
    QTRY_VERIFY_WITH_TIMEOUT(showsWhatIsTrue() && !view()->otherImage().isNull(), patience);
    QVERIFY(
        equals(view()->otherImage(), rendered(loadViewSource(stored, {}).job(m_model->current()))));
    child<QAction>("undoAction")->trigger();
    QVERIFY(m_model->session() == stored);
  }

  /// Ctrl and a click set the depth at which a capture's directions are brought together; one undo
  /// takes it back. The form's field does the same.
  void aCaptureIsFocused() {
    constexpr double depth = 0.05, width = 0.24, most = 0.4663;  // tan 25°
    writeImageFile(m_folder.filePath("plane.png"), 96 * 9, 96 * 9, [&](int x, int y, int) {
      const auto at = [&](int k) {
        return ((k / 9 + 0.5) / 96 - 0.5) * width + depth * (2 * (k % 9 + 0.5) / 9 - 1) * most;
      };
      double sum = 0.5;  // of waves that have no period in common
      for (const double wave : {0.02, 0.023, 0.031})
        sum += 0.15 * std::sin(2 * M_PI * at(x) / wave - 3 * at(y) / wave);
      return float(sum);
    });
    writeFile(m_folder.filePath("plane.json"), R"({"hogelscope": 1,
      "display": {"size": [0.24, 0.24], "hogels": [96, 96], "directions": [9, 9], "fov": [50, 50]},
      "lightField": {"file": "plane.png"},
      "cameras": [{"name": "a", "eye": [0.03, -0.02, 0.6], "res": [120, 120], "fov": 22}]})");
    QVERIFY(files(*m_window).open(m_folder.filePath("plane.json")));
    auto* see = child<QAction>("paperAction");
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms") && see->isEnabled(), patience);
    see->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(showsWhatIsTrue(), patience);
    child<QAction>("stopComparingAction")->trigger();
    const Session before = m_model->session();
    const auto focus = [&] {
      return (*m_model->session().lightField.content.find<std::vector<double>>("focus"))[0];
    };
    QCOMPARE(focus(), 0.0);
    QTest::mouseClick(view(), Qt::LeftButton, Qt::ControlModifier, view()->rect().center());
    QTRY_VERIFY_WITH_TIMEOUT(focus() != 0, patience);
    QVERIFY2(std::abs(focus() - depth) < 0.01, qPrintable(QString::number(focus())));
    QTRY_VERIFY_WITH_TIMEOUT(showsWhatIsTrue(), patience);
    const QImage sharp = view()->image();
    child<QAction>("undoAction")->trigger();
    QVERIFY(m_model->session() == before);
    auto* field = child<QWidget>("sessionForm")->findChild<QDoubleSpinBox*>("focus");
    QVERIFY(field != nullptr);
    field->setValue(0.04);
    QCOMPARE(focus(), 0.04);
    QTRY_VERIFY_WITH_TIMEOUT(showsWhatIsTrue() && view()->image() != sharp, patience);
  }

  /// The menu keeps the display of another session, and names the file and the field.
  void aDamagedLibraryIsTold() {
    const QString file = m_folder.filePath("library.json");
    for (const auto& [content, expected] :
         {std::pair(R"({"hogelscopeDisplays": 2})", "hogelscopeDisplays"),
          std::pair(R"({"hogelscopeDisplays": 1, "displays": [{"file": 7}]})", "displays[0].file"),
          std::pair("{", "library.json: ")}) {
      writeFile(file, content);
      QMenu menu;
      LibraryMenu library(&menu, file, nullptr);
      QSignalSpy told(&library, &LibraryMenu::failed);
      QTRY_COMPARE_WITH_TIMEOUT(told.size(), 1, patience);
      const QString line = told[0][0].toString();
      QVERIFY2(line.startsWith(file) && line.contains(expected), qPrintable(line));
      QCOMPARE(menu.actions().size(), 2);  // a separator, and another session's display
    }
  }

  void aDamagedMeshIsTold() {
    writeFile(m_folder.filePath("bad.glb"), "glTF");
    const Session before = m_model->session();
    QVERIFY(files(*m_window).open(m_folder.filePath("bad.glb")));
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("bad.glb"), patience);
    QTRY_VERIFY_WITH_TIMEOUT(message().startsWith("Error"), patience);
    QVERIFY(m_model->session() == before);
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestLiveScenes>(argc, argv);
}
#include "test_live_scenes.moc"
