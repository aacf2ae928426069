// SPDX-License-Identifier: BSD-3-Clause
// The pointer in the 3-D scene of the real window: clicks frusta, hogels and pixels, drags handles.
#include <QAction>
#include <QSignalSpy>
#include <QToolButton>
#include <QToolTip>
#include <QUndoStack>

#include "core/optics/pixel_inspection.h"
#include "gui/view/image_widget.h"
#include "tests/gui/scene_test.h"
#include "tests/gui/shown_image.h"

using namespace hogelscope;

class TestScenePicking : public SceneTest {
  Q_OBJECT

 private Q_SLOTS:
  void init() { start(); }
  void cleanup() { m_window.reset(); }

  void aClickMakesAStateCurrent() {
    press(Qt::Key_F6);
    click(onScreen(cornerOf(m_session.cameras[2])));
    QCOMPARE(current(), 2);
    click(QPoint(5, 5));  // nothing is there
    QCOMPARE(current(), 2);
    // Three states are at one place: the next one each time.
    const QPoint both = onScreen(cornerOf(m_session.cameras[5]));
    click(both);
    QCOMPARE(current(), 4);
    click(both);
    QCOMPARE(current(), 5);
    click(both);
    QCOMPARE(current(), 0);
  }

  void namesAppearUnderThePointer() {
    press(Qt::Key_F6);
    QTest::mouseMove(widget(), onScreen(cornerOf(m_session.cameras[3])));
    QTRY_VERIFY2_WITH_TIMEOUT(QToolTip::text().startsWith("Fig 4: "), qPrintable(QToolTip::text()),
                              patience);
    QTest::mouseMove(widget(), QPoint(5, 5));
    QTRY_VERIFY_WITH_TIMEOUT(!QToolTip::isVisible() || QToolTip::text().isEmpty(), patience);
  }

  void draggingTheBallsMovesEyeAndLookat() {
    press(Qt::Key_F6);
    const Vec3 lookat = edited("lookat");
    const QPoint to = onScreen(edited("eye")) + QPoint(40, 25);
    drag(onScreen(edited("eye")), to);
    QVERIFY(!isNear(edited("eye"), m_session.cameras[0].camera.eye, 0.01));
    const QPoint eyeMiss = onScreen(edited("eye")) - to;
    QVERIFY2(eyeMiss.manhattanLength() <= 4, qPrintable(QString::number(eyeMiss.x())));
    QVERIFY(std::abs(edited("eye").y) < 1e-3);  // seen from above it stays at its height
    QVERIFY(isNear(edited("lookat"), lookat, 0));
    const QPoint aim = onScreen(lookat) + QPoint(-30, 10);
    drag(onScreen(lookat), aim);
    QVERIFY(!isNear(edited("lookat"), lookat, 0.01));
    QVERIFY((onScreen(edited("lookat")) - aim).manhattanLength() <= 4);
    QVERIFY(m_window->isWindowModified());
  }

  /// Seen from the right, z points left and y up.
  void anArrowMovesAlongOneAxis() {
    press(Qt::Key_F7);
    const Vec3 before = edited("eye");
    const QPoint ball = onScreen(before);
    const int steps = m_model->undoStack()->count();
    QVERIFY(count(painted(), tokens().axes[2]) > 60);
    drag(ball + QPoint(-35, 0), ball + QPoint(-75, 30));
    QCOMPARE(edited("eye").x, before.x);
    QCOMPARE(edited("eye").y, before.y);
    QVERIFY(edited("eye").z > before.z + 0.01);
    const QPoint after = onScreen(edited("eye"));
    QVERIFY2(std::abs(after.x() - (ball.x() - 40)) <= 2, qPrintable(QString::number(after.x())));
    QCOMPARE(m_model->undoStack()->count(), steps + 1);
    const double z = edited("eye").z;
    drag(after + QPoint(0, -35), after + QPoint(-10, -65));
    QCOMPARE(edited("eye").x, before.x);
    QCOMPARE(edited("eye").z, z);
    QVERIFY(std::abs(onScreen(edited("eye")).y() - (after.y() - 30)) <= 2);
    child<QAction>("undoAction")->trigger();
    child<QAction>("undoAction")->trigger();
    QVERIFY(isNear(edited("eye"), before, 0));
    // x points at the scene's eye, so nothing is there to be dragged.
    for (const AxisArrow& arrow : scene().handles().arrows()) QVERIFY(arrow.axis != 0);
  }

  /// In a parallel projection every pixel is as long, so that the way is known exactly.
  void anArrowOfAnotherBall() {
    child<QAction>("sceneParallelAction")->trigger();
    press(Qt::Key_F7);
    const Vec3 before = edited("lookat");
    const QPoint ball = onScreen(before);
    click(ball);  // the arrows go there
    drag(ball + QPoint(-35, 0), ball + QPoint(-65, 20));
    const double way = 30 * scene().pixelOnPanel();
    QVERIFY2(std::abs(edited("lookat").z - before.z - way) < 0.05 * way,
             qPrintable(QString::number(edited("lookat").z)));
    QCOMPARE(edited("lookat").x, before.x);
    QCOMPARE(edited("lookat").y, before.y);
    QVERIFY(isNear(edited("eye"), m_session.cameras[0].camera.eye, 0));
  }

  void aLengthIsMeasured() {
    press(Qt::Key_F5);
    const int state = current();
    const auto linePixels = [this] {  // below the buttons, which have this colour too
      return count(painted().copy(0, 60, widget()->width(), widget()->height() - 60),
                   tokens().focus);
    };
    QTest::keyClick(m_window.get(), Qt::Key_M, Qt::AltModifier | Qt::ShiftModifier);
    QVERIFY(child<QAction>("sceneMeasureAction")->isChecked());
    QVERIFY(child<QToolButton>("sceneMeasureButton")->isChecked());
    QVERIFY2(readout().contains("click the first point"), qPrintable(readout()));
    QCOMPARE(linePixels(), 0);
    click(onScreen({-0.25, -0.25, 0}) + QPoint(2, -2));
    QVERIFY2(readout().contains("click the second point"), qPrintable(readout()));
    click(onScreen({0.25, 0.25, 0}));
    QVERIFY2(readout().endsWith("Distance 0.7071 m · Δx 0.5 m, Δy 0.5 m, Δz 0 m"),
             qPrintable(readout()));
    QVERIFY(linePixels() > 200);
    click(QPoint(5, widget()->height() / 2));  // nothing is there
    QVERIFY(readout().contains("0.7071 m"));
    // A third click begins anew: a point of the panel, then an eye.
    click(onScreen({0.1, -0.2, 0}));
    QVERIFY(readout().contains("click the second point"));
    const Vec3 eye = m_session.cameras[2].camera.eye;
    click(onScreen(eye));
    QCOMPARE(scene().measured().size(), std::size_t(2));
    QVERIFY(isNear(scene().measured()[0], {0.1, -0.2, 0}, 2 * scene().pixelOnPanel()));
    QVERIFY(isNear(scene().measured()[1], eye, 0));
    QCOMPARE(current(), state);  // nothing is picked meanwhile
    press(Qt::Key_Escape);
    QVERIFY(!child<QAction>("sceneMeasureAction")->isChecked() && scene().measured().empty());
    QVERIFY(readout().contains("lights this eye"));
    QCOMPARE(linePixels(), 0);
  }

  void buttonsOverTheScene() {
    QVERIFY(child<QToolButton>("scenePanelPictureButton")->isChecked());
    QTest::mouseClick(child<QToolButton>("sceneZoneButton"), Qt::LeftButton);
    QVERIFY(scene().zone().isVisible());
    scene().turn(20, 0);
    const CameraParams turned = scene().eye();
    QTest::mouseClick(child<QToolButton>("fitButton"), Qt::LeftButton);
    QVERIFY(!(scene().eye() == turned));
    for (const char* name : {"scenePanelPictureButton", "sceneZoneButton", "sceneGridButton",
                             "sceneMeasureButton", "fitButton"})
      QVERIFY2(!child<QToolButton>(name)->icon().isNull(), name);
  }

  void draggingTheSceneTurnsIt() {
    const Vec3 before = scene().eye().eye;
    drag(QPoint(20, 60), QPoint(90, 100));
    QVERIFY(!isNear(scene().eye().eye, before, 0.05));
    QVERIFY(!m_window->isWindowModified());
    QVERIFY(readout().contains("lights this eye"));  // that was no click
  }

  void aPickedPixelIsTracedInNumbers() {
    auto* view = m_window->findChild<ImageWidget*>("pictureView");
    const int side = std::min(view->width(), view->height());
    const QPoint at = view->rect().center() + QPoint(side / 10, side / 7);
    QTest::mouseClick(view, Qt::LeftButton, {}, at);
    const QString before = readout();  // the inspector says more
    static const QRegularExpression pixel(R"(Pixel \((\d+), (\d+)\): sees)");
    const QRegularExpressionMatch match = pixel.match(before);
    QVERIFY2(match.hasMatch(), qPrintable(readout()));
    const int x = match.captured(1).toInt();
    const int y = match.captured(2).toInt();
    QVERIFY(std::abs(x - 300 - 60) <= 3 && std::abs(y - 300 - 600 / 7) <= 3);
    const PixelTrace traced = pixelTrace(m_loaded.job(m_session.cameras[0]), x, y);
    QVERIFY2(before.contains(QString::number(traced.colour->g, 'f', 1)), qPrintable(before));
    QVERIFY(before.endsWith("25 leakage taps"));
    QCOMPARE(scene().picked().label(), std::string("hogel ") +
                                           std::to_string(int(traced.place->i)) + ", " +
                                           std::to_string(int(traced.place->j)));
    QVERIFY(scene().picked().hasRay() && !scene().picked().label().empty());
    press(Qt::Key_F7);
    QVERIFY(count(drawn(), tokens().series[3]) > 50);
    // An edit moves the ray; another state has none.
    edit("eye.1", 0.05);
    QVERIFY(readout() != before);
    child<QComboBox>("stateBox")->setCurrentIndex(1);
    QVERIFY(!scene().picked().hasRay() && scene().picked().label().empty());
    controller()->showPixel(0, 0);
    QVERIFY2(readout().contains("Pixel (0, 0): no ray"), qPrintable(readout()));
    QVERIFY(!scene().picked().hasRay());
    child<QComboBox>("stateBox")->setCurrentIndex(3);
    controller()->showPixel(0, 0);  // the image's corner does not see the panel
    QVERIFY2(readout().contains("Pixel (0, 0): misses the panel"), qPrintable(readout()));
    QVERIFY(scene().picked().hasRay() && scene().picked().label().empty());
    controller()->showPixel(-1, 0);
    QVERIFY(!scene().picked().hasRay() && readout().contains("lights this eye"));
  }

  void aPickedHogelShowsItsImage() {
    press(Qt::Key_F5);
    const Vec2 middle = hogelscope::Display(m_loaded.display).position(100.5, 20.5);
    click(onScreen({middle.x, middle.y, 0}));
    QVERIFY2(readout().contains("Hogel i 100, j 20 at x "), qPrintable(readout()));
    QVERIFY(readout().endsWith("6 × 6 directions over 60° × 60°"));
    QVERIFY(!scene().picked().hasRay());
    QCOMPARE(scene().picked().label(), std::string("hogel 100, 20"));
    press(Qt::Key_0, Qt::ControlModifier);
    drawn().save(QCoreApplication::applicationDirPath() + "/picked_hogel.png");
  }

  void whatIsPickedIsRemoved() {
    press(Qt::Key_F7);
    auto* remove = child<QAction>("sceneForgetAction");
    QVERIFY(!remove->isEnabled());
    controller()->showPixel(300, 300);
    QVERIFY(remove->isEnabled());
    QVERIFY(scene().picked().hasRay() && !scene().picked().label().empty());
    press(Qt::Key_Escape);
    QVERIFY(!scene().picked().hasRay() && scene().picked().label().empty());
    QVERIFY(readout().contains("lights this eye") && !remove->isEnabled());
    QCOMPARE(count(drawn(), tokens().series[3]), 0);
    edit("eye.1", 0.05);  // it does not come back
    QVERIFY(!scene().picked().hasRay());
    press(Qt::Key_F5);
    const Vec2 middle = hogelscope::Display(m_loaded.display).position(100.5, 20.5);
    click(onScreen({middle.x, middle.y, 0}));
    QVERIFY(!scene().picked().label().empty());
    remove->trigger();
    QVERIFY(scene().picked().label().empty());
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestScenePicking>(argc, argv);
}
#include "test_scene_picking.moc"
