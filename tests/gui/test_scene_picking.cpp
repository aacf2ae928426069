// SPDX-License-Identifier: BSD-3-Clause
// The pointer in the 3-D scene of the real window: clicks frusta, hogels and pixels, drags handles.
#include <QAction>
#include <QSignalSpy>
#include <QToolTip>

#include "core/optics/pixel_inspection.h"
#include "gui/view/image_widget.h"
#include "tests/gui/scene_test.h"
#include "tests/gui/shown_image.h"

using namespace hogelscope;

namespace {

const QColor rayColour(255, 64, 115);

}  // namespace

class TestScenePicking : public SceneTest {
  Q_OBJECT

 private:
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

  void draggingTheSceneTurnsIt() {
    const Vec3 before = scene().eye().eye;
    drag(QPoint(20, 20), QPoint(90, 60));
    QVERIFY(!isNear(scene().eye().eye, before, 0.05));
    QVERIFY(!m_window->isWindowModified());
    QVERIFY(readout().contains("Click a frustum"));  // that was no click
  }

  void aPickedPixelIsTracedInNumbers() {
    auto* view = m_window->findChild<ImageWidget*>("pictureView");
    const int side = std::min(view->width(), view->height());
    const QPoint at = view->rect().center() + QPoint(side / 10, side / 7);
    QTest::mouseClick(view, Qt::LeftButton, {}, at);
    const QString before = readout();  // the inspector says more
    const QStringList lines = before.split('\n');
    QCOMPARE(lines.size(), 2);
    static const QRegularExpression pixel(R"(Pixel \((\d+), (\d+)\): sees)");
    const QRegularExpressionMatch match = pixel.match(lines[1]);
    QVERIFY2(match.hasMatch(), qPrintable(readout()));
    const int x = match.captured(1).toInt();
    const int y = match.captured(2).toInt();
    QVERIFY(std::abs(x - 300 - 60) <= 3 && std::abs(y - 300 - 600 / 7) <= 3);
    const PixelTrace traced = pixelTrace(m_loaded.job(m_session.cameras[0]), x, y);
    QVERIFY2(lines[1].contains(QString::number(traced.colour->g, 'f', 1)), qPrintable(lines[1]));
    QVERIFY(lines[1].endsWith("25 leakage taps"));
    QCOMPARE(scene().picked().label(), std::string("hogel ") +
                                           std::to_string(int(traced.place->i)) + ", " +
                                           std::to_string(int(traced.place->j)));
    QVERIFY(scene().picked().hasRay() && !scene().picked().label().empty());
    press(Qt::Key_F7);
    QVERIFY(count(drawn(), rayColour) > 50);
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
    QVERIFY(!scene().picked().hasRay() && readout().contains("Click a frustum"));
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
    QVERIFY(readout().contains("Click a frustum") && !remove->isEnabled());
    QCOMPARE(count(drawn(), rayColour), 0);
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
