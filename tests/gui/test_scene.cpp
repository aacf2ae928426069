// SPDX-License-Identifier: BSD-3-Clause
// What the 3-D scene of the real window shows, compared with the reference engine, and from where.
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>

#include <QAction>

#include "core/engine/fast_simulation.h"
#include "core/optics/scene_eyes.h"
#include "gui/app/main_window.h"
#include "gui/view/image_widget.h"
#include "tests/core/rendered.h"
#include "tests/gui/scene_test.h"
#include "tests/gui/shown_image.h"

using namespace hogelscope;

class TestScene : public SceneTest {
  Q_OBJECT

 private Q_SLOTS:
  void init() { startSmall(); }
  void cleanup() { m_window.reset(); }

  void thePanelShowsWhatTheScenesEyeSees() {
    press(Qt::Key_F5);
    // From a little to the side and above, so that parallax counts.
    scene().renderer()->GetActiveCamera()->Azimuth(12);
    scene().renderer()->GetActiveCamera()->Elevation(8);
    CameraState state = m_session.cameras[0];
    state.camera = scene().eye();
    state.camera.name = "eye";
    state.distortion = {};
    const auto shares = [&] {
      const QImage image = drawn();
      state.camera.res = {image.width(), image.height()};
      const Image expected = rendered(m_loaded.job(state));
      int seen = 0;
      int near = 0;
      for (std::size_t at = 0; at < expected.pixelCount(); ++at) {
        if (expected.seen[at] == 0) continue;
        const int x = int(at) % expected.width;
        const int y = int(at) / expected.width;
        const std::uint8_t* rgb = &expected.rgb[3 * at];
        ++seen;
        near += distance(image.pixelColor(x, y), QColor(rgb[0], rgb[1], rgb[2])) < 45 ? 1 : 0;
      }
      return seen > 5000 ? double(near) / seen : 0;
    };
    // The rest is the frusta, balls and axes before it, and the edges of hogels.
    QTRY_VERIFY_WITH_TIMEOUT(shares() > 0.8, patience);
    // The light leakage is the current state's.
    edit("eye.0", -0.25);
    QTRY_VERIFY_WITH_TIMEOUT(shares() > 0.8, patience);
  }

  void thePanelCanShowItsGrid() {
    press(Qt::Key_F5);
    QTRY_COMPARE_WITH_TIMEOUT(scene().panel().gridLines(), 0, patience);
    press(Qt::Key_G, Qt::ControlModifier);
    QVERIFY(!child<QAction>("scenePanelPictureAction")->isChecked());
    QTRY_VERIFY_WITH_TIMEOUT(count(drawn(), tokens().text3) > 1000, patience);
    const int far = scene().panel().gridLines();
    QVERIFY2(far <= 2 * 65, qPrintable(QString::number(far)));  // not each of 128
    scene().renderer()->GetActiveCamera()->Dolly(8);
    QTRY_COMPARE_WITH_TIMEOUT(scene().panel().gridLines(), 2 * 129, patience);
    press(Qt::Key_G, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(scene().panel().gridLines(), 0, patience);
  }

  void aDarkPanelShowsWhereItIs() {
    press(Qt::Key_F5);
    QTRY_COMPARE_WITH_TIMEOUT(scene().panel().gridLines(), 0, patience);
    press(Qt::Key_F7);  // along the panel
    scene().turn(-4, 0);
    QTRY_VERIFY_WITH_TIMEOUT(scene().panel().gridLines() > 10, patience);
    press(Qt::Key_F5);
    QTRY_COMPARE_WITH_TIMEOUT(scene().panel().gridLines(), 0, patience);
  }

  /// Of panel and frusta, in the window's height or width.
  void theSceneFillsItsWindow() {
    for (const Qt::Key key : {Qt::Key_0, Qt::Key_F5, Qt::Key_F6, Qt::Key_F7}) {
      press(key, key == Qt::Key_0 ? Qt::ControlModifier : Qt::NoModifier);
      QRect all;
      std::vector<Vec3> points{
          {-0.25, -0.25, 0}, {0.25, -0.25, 0}, {-0.25, 0.25, 0}, {0.25, 0.25, 0}};
      for (const CameraState& state : m_session.cameras) points.push_back(state.camera.eye);
      for (const double side : {-1, 1}) {  // the viewing zone at the current eye's depth
        const double z = m_session.cameras[0].camera.eye.z;
        const double half = z * std::tan(radians(30)) - 0.25;
        points.insert(points.end(), {{side * half, half, z}, {side * half, -half, z}});
      }
      for (const Vec3& point : points) all |= QRect(onScreen(point), QSize(1, 1));
      QVERIFY(widget()->rect().contains(all));
      const double share = std::max(double(all.width()) / widget()->width(),
                                    double(all.height()) / widget()->height());
      QVERIFY2(share > 0.75, qPrintable(QString::number(share)));
    }
  }

  void theBallsKeepTheirSizeOnTheScreen() {
    press(Qt::Key_F7);
    // How wide it is on the screen, across the frustum's axis.
    const auto ball = [this] {
      QTest::qWait(50);
      const QImage image = painted();
      const QPoint eye = onScreen(edited("eye"));
      int height = 0;
      for (int y = eye.y() - 30; y < eye.y() + 30; ++y)
        if (image.pixelColor(eye.x(), y).red() > 2 * image.pixelColor(eye.x(), y).blue()) ++height;
      return height;
    };
    const int before = ball();
    QVERIFY2(before >= 6 && before < 25, qPrintable(QString::number(before)));
    scene().renderer()->GetActiveCamera()->Dolly(0.2);
    scene().redraw();
    const int after = ball();
    QVERIFY2(2 * after > before, qPrintable(QString::number(after)));  // the lines at it do shrink
  }

  /// A display of another size, all lengths with it, fills the window as this one did.
  void anotherSizeIsFitted_data() {
    QTest::addColumn<double>("factor");
    QTest::newRow("a watch") << 0.01;
    QTest::newRow("a wall") << 100.0;
  }

  void anotherSizeIsFitted() {
    QFETCH(const double, factor);
    const auto ball = [this] {
      QTest::qWait(50);
      const QPoint eye = onScreen(edited("eye"));
      return count(painted().copy(QRect(eye - QPoint(12, 12), QSize(25, 25))), tokens().eye);
    };
    const std::vector<Vec3> corners{{-0.25, -0.25, 0}, {0.25, 0.25, 0}, edited("eye")};
    std::vector<QPoint> before;
    before.reserve(corners.size());
    for (const Vec3& corner : corners) before.push_back(onScreen(corner));
    const int ballBefore = ball();
    QVERIFY(ballBefore > 20);
    Session other = m_session;
    for (double& side : other.display.size) side *= factor;
    for (CameraState& state : other.cameras) {
      state.camera.eye = factor * state.camera.eye;
      state.camera.lookat = factor * state.camera.lookat;
    }
    open(other);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const QPoint way = onScreen(factor * corners[k]) - before[k];
      QVERIFY2(way.manhattanLength() <= 4, qPrintable(QString::number(way.manhattanLength())));
    }
    QVERIFY(std::abs(ball() - ballBefore) <= ballBefore / 4);
  }

  void keysTurnTheScene() {
    press(Qt::Key_F5);
    widget()->setFocus();
    const auto key = [this](Qt::Key k) { QTest::keyClick(widget(), k); };
    const double before = length(scene().eye().eye - scene().eye().lookat);
    const auto direction = [this] { return normalise(scene().eye().eye - scene().eye().lookat); };
    for (int k = 0; k < 6; ++k) key(Qt::Key_Right);
    QVERIFY(isNear(direction(), {0.5, 0, std::sqrt(0.75)}, 1e-6));  // 30°
    for (int k = 0; k < 6; ++k) key(Qt::Key_Left);
    for (int k = 0; k < 6; ++k) key(Qt::Key_Up);
    QVERIFY(isNear(direction(), {0, 0.5, std::sqrt(0.75)}, 1e-6));
    for (int k = 0; k < 6; ++k) key(Qt::Key_Down);
    QVERIFY(isNear(direction(), {0, 0, 1}, 1e-6));
    key(Qt::Key_Plus);
    QCOMPARE(length(scene().eye().eye - scene().eye().lookat), before / 1.1);
    key(Qt::Key_Minus);
    QCOMPARE(length(scene().eye().eye - scene().eye().lookat), before);
    // In a field the arrows are the field's.
    spinBox("eye.0")->setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Up);
    QVERIFY(isNear(direction(), {0, 0, 1}, 1e-6));
  }

  void commandsPlaceTheScenesEye() {
    const auto isAlong = [this](const Vec3& axis) {
      const CameraParams eye = scene().eye();
      return isNear(normalise(eye.eye - eye.lookat), axis, 1e-6);
    };
    press(Qt::Key_F5);
    QVERIFY(isAlong({0, 0, 1}));
    press(Qt::Key_F6);
    QVERIFY(isAlong({0, 1, 0}));
    press(Qt::Key_F7);
    QVERIFY(isAlong({1, 0, 0}));
    press(Qt::Key_0, Qt::ControlModifier);
    QVERIFY(scene().eye().eye.x < -0.1 && scene().eye().eye.y > 0.1 && scene().eye().eye.z > 0.5);
    for (const Vec3& corner : {Vec3{-0.25, -0.25, 0}, Vec3{0.25, 0.25, 0}, edited("eye")})
      QVERIFY(widget()->rect().contains(onScreen(corner)));

    press(Qt::Key_F8);
    QVERIFY(isNear(scene().eye().eye, m_session.cameras[0].camera.eye, 1e-9));
    QVERIFY(isNear(scene().eye().lookat, {0, 0, 0}, 1e-9));
    QCOMPARE(scene().eye().fov, 60.0);
    const int height = widget()->height();
    QVERIFY(std::abs(onScreen(cornerOf(m_session.cameras[0])).y() - height) < 3);

    press(Qt::Key_F7);
    press(Qt::Key_F9);
    QVERIFY(isNear(edited("eye"), scene().eye().eye, 1e-3));
    QVERIFY(isNear(edited("lookat"), scene().eye().lookat, 1e-3));
    QVERIFY(m_window->isWindowModified());
    QVERIFY2(readout().contains("outside the viewing zone"), qPrintable(readout()));
    edit("eye.2", 2);
    edit("eye.0", 0.1);
    QTRY_VERIFY_WITH_TIMEOUT(readout().contains("% of the panel lights this eye"), patience);
  }

  void theOtherSides() {
    for (const auto& [key, axis] :
         {std::pair(Qt::Key_F5, Vec3{0, 0, -1}), std::pair(Qt::Key_F6, Vec3{0, -1, 0}),
          std::pair(Qt::Key_F7, Vec3{-1, 0, 0})}) {
      press(key, Qt::ShiftModifier);
      const CameraParams eye = scene().eye();
      QVERIFY(isNear(normalise(eye.eye - eye.lookat), axis, 1e-6));
      QVERIFY(widget()->rect().contains(onScreen(edited("eye"))));
    }
  }

  /// What was fitted stays so in a window of another shape; what somebody turned stays as it is.
  void aFittedSceneFollowsTheWindow() {
    press(Qt::Key_F5);
    const int height = widget()->height();
    m_window->resize(m_window->width(), 500);
    QTRY_VERIFY_WITH_TIMEOUT(widget()->height() < height - 150, patience);
    QTest::qWait(50);
    const QRect panel(onScreen({-0.25, 0.25, 0}), onScreen({0.25, -0.25, 0}));
    QVERIFY(widget()->rect().contains(panel));
    QVERIFY(panel.height() > widget()->height() / 2);
    scene().turn(5, 0);
    const CameraParams turned = scene().eye();
    m_window->resize(m_window->width(), 800);
    QTest::qWait(100);
    QVERIFY(scene().eye() == turned);
    // Fitted again it keeps the direction, and a second time it is where it began.
    press(Qt::Key_0, Qt::ControlModifier);
    const auto direction = [](const CameraParams& eye) { return normalise(eye.eye - eye.lookat); };
    QVERIFY(!(scene().eye() == turned));
    QVERIFY(isNear(direction(scene().eye()), direction(turned), 1e-6));
    press(Qt::Key_0, Qt::ControlModifier);
    QVERIFY(isNear(direction(scene().eye()), normalise({-0.85, 0.5, 2.5}), 1e-6));
  }

  /// Two lengths across the view, one of them far behind the other.
  void aParallelProjectionKeepsLengths() {
    press(Qt::Key_F6);
    const auto across = [this](double y) {
      return onScreen({0.25, y, 0}).x() - onScreen({-0.25, y, 0}).x();
    };
    QVERIFY(across(-0.2) < across(0.2) - 10);
    const int middle = across(0);
    child<QAction>("sceneParallelAction")->trigger();
    QVERIFY(std::abs(across(-0.2) - across(0.2)) <= 1);
    QVERIFY(std::abs(across(0) - middle) < middle / 10);
    QVERIFY(std::abs(scene().pixelOnPanel() * across(0) / 0.5 - 1) < 0.01);
    for (const Vec3& point : {Vec3{-0.25, 0, 0}, Vec3{0.25, 0, 0}, edited("eye")})
      QVERIFY(widget()->rect().contains(onScreen(point)));
    // The wheel and the keys zoom, a click picks what is under it.
    scene().approach(2);
    QVERIFY(std::abs(across(0) - 2 * middle) < middle / 5);
    press(Qt::Key_F5);
    const std::optional<Hit> hogel = scene().hogelAt(
        onScreen({0.125, 0, 0}).x(), widget()->height() - 1 - onScreen({0, 0.0625, 0}).y());
    QVERIFY(hogel && std::abs(hogel->i - 96) < 1 && std::abs(hogel->j - 48) < 1);
    child<QAction>("sceneParallelAction")->trigger();
    QVERIFY(std::abs(across(-0.2) - across(0.2)) <= 1);  // from the front they are equally far
    press(Qt::Key_F6);
    QVERIFY(across(-0.2) < across(0.2) - 10);
    // A camera has no parallel projection.
    child<QAction>("sceneParallelAction")->trigger();
    press(Qt::Key_F8);
    QVERIFY(!child<QAction>("sceneParallelAction")->isChecked());
    QVERIFY(std::abs(onScreen(cornerOf(m_session.cameras[0])).y() - widget()->height()) < 3);
  }

  /// Every hogel shows the one direction that goes straight ahead.
  void inAParallelProjectionAllRaysAreParallel() {
    child<QAction>("sceneParallelAction")->trigger();
    press(Qt::Key_F5);
    QTRY_COMPARE_WITH_TIMEOUT(scene().panel().gridLines(), 0, patience);
    child<QAction>("sceneFrustaAction")->trigger();
    CameraState far = m_session.cameras[0];
    far.distortion = {};
    far.camera = {};
    far.camera.eye = {0, 0, 5000};
    const auto share = [&] {
      const QImage image = drawn();
      const QRect panel(onScreen({-0.25, 0.25, 0}), onScreen({0.25, -0.25, 0}));
      far.camera.fov = 2 * std::atan(0.25 / 5000) * 180 / std::numbers::pi;
      far.camera.res = {panel.width(), panel.height()};
      const Image expected = rendered(m_loaded.job(far));
      int near = 0;
      for (int y = 0; y < panel.height(); ++y)
        for (int x = 0; x < panel.width(); ++x) {
          const std::uint8_t* rgb = &expected.rgb[3 * std::size_t(y * panel.width() + x)];
          near += distance(image.pixelColor(panel.topLeft() + QPoint(x, y)),
                           QColor(rgb[0], rgb[1], rgb[2])) < 45;
        }
      return double(near) / (panel.width() * panel.height());
    };
    QTRY_VERIFY2_WITH_TIMEOUT(share() > 0.9, qPrintable(QString::number(share())), patience);
  }

  void partsCanBeSwitchedOff() {
    press(Qt::Key_F7);
    press(Qt::Key_G, Qt::ControlModifier);
    const auto isShown = [this](const char* action, const QColor& colour, int pixels) {
      QTest::qWait(50);
      const int with = count(painted(), colour);
      child<QAction>(action)->trigger();
      QTest::qWait(50);
      const int without = count(painted(), colour);
      child<QAction>(action)->trigger();
      QTest::qWait(50);
      return without + pixels <= with && count(painted(), colour) == with;
    };
    QVERIFY(isShown("sceneFrustaAction", tokens().text3, 50));
    press(Qt::Key_F5);
    child<QAction>("sceneFrustaAction")->trigger();
    QVERIFY(isShown("sceneScaleBarAction", tokens().text2, 30));
    child<QAction>("sceneAxesAction")->trigger();
    QVERIFY(isShown("sceneAxesAction", tokens().axes[1], 30));
    // The grid is there where no picture is, and where it is wanted.
    const int grid = scene().panel().gridLines();
    QVERIFY(grid > 0);
    press(Qt::Key_G, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(scene().panel().gridLines(), 0, patience);
    child<QAction>("sceneGridAction")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(scene().panel().gridLines(), grid, patience);
  }

  /// The body of the points that see the whole panel tints what is behind it, here nothing else.
  void theViewingZoneIsABody() {
    child<QAction>("sceneFrustaAction")->trigger();
    press(Qt::Key_F7);
    scene().approach(0.4);
    QTest::qWait(50);
    const QImage before = drawn();
    child<QAction>("sceneZoneAction")->trigger();
    QVERIFY(scene().zone().isVisible());
    QTest::qWait(50);
    const QImage after = drawn();
    const auto isTinted = [&](const Vec3& place) {
      const QPoint at = onScreen(place);
      const QColor was = before.pixelColor(at);
      const QColor is = after.pixelColor(at);
      return is.green() > was.green() + 5 && is.green() < was.green() + 60;
    };
    // 0.5 m with a field of 60°: the whole panel is seen from 0.433 m on.
    for (const double z : {0.6, 0.8, 0.95}) {
      const double half = z * std::tan(radians(30)) - 0.25;
      QVERIFY2(isTinted({0, 0.8 * half, z}), qPrintable(QString::number(z)));
      QVERIFY(isTinted({0, -0.8 * half, z}));
      QVERIFY(!isTinted({0, 1.2 * half + 0.02, z}));
    }
    QVERIFY(!isTinted({0, 0.02, 0.3}));
  }

  /// The panel's outline where content begins and ends to be sharp, dotted.
  void theSharpDepthsArePlanes() {
    press(Qt::Key_F7);
    scene().approach(0.6);
    QTest::qWait(50);
    const QImage before = painted();
    child<QAction>("sceneDepthsAction")->trigger();
    QTest::qWait(50);
    const QImage after = painted();
    const auto isDrawn = [&](const Vec3& place) {
      const QPoint at = onScreen(place);
      for (int y = at.y() - 3; y <= at.y() + 3; ++y)
        for (int x = at.x() - 3; x <= at.x() + 3; ++x)
          if (before.valid(x, y) && before.pixel(x, y) != after.pixel(x, y)) return true;
      return false;
    };
    // p D/(s D ± p)
    const DisplayParams& display = m_session.display;
    const double pitch = display.size[0] / display.hogels[0];
    const double step = 2 * std::tan(radians(display.fov[0] / 2)) / display.directions[0];
    const double distance = m_session.cameras[0].camera.eye.z;
    const double front = pitch * distance / (step * distance + pitch);
    const double behind = pitch * distance / (step * distance - pitch);
    for (const double z : {front, -behind}) {
      int found = 0;
      for (int k = -9; k <= 9; ++k) found += isDrawn({0.25, 0.025 * k, z}) ? 1 : 0;
      QVERIFY2(found > 12, qPrintable(QString::number(z)));
    }
    QVERIFY(!isDrawn({0.25, 0.1, 0.3}));
    child<QAction>("sceneDepthsAction")->trigger();
    QTest::qWait(50);
    QCOMPARE(painted(), before);
  }

  /// Around the points at the eye's depth that see the whole panel, and dashed around those that
  /// see a part of it if that fits the window.
  void theViewingZoneHasAnOutline() {
    press(Qt::Key_F5);
    child<QAction>("sceneFrustaAction")->trigger();
    const double z = edited("eye").z;
    const auto lineAt = [&](double x, double y, double depth, int unlike = 60) {
      const QPoint at = onScreen({x, y, depth});
      return count(painted().copy(QRect(at - QPoint(2, 20), QSize(5, 41))), tokens().good, unlike);
    };
    const int halfCovered = 100;  // the colour of a line that lies between two pixels
    const double whole = z * std::tan(radians(30)) - 0.25;
    const double some = z * std::tan(radians(30)) + 0.25;
    QVERIFY(lineAt(whole, 0, z, halfCovered) > 25);  // the name of an arrow may lie on it
    QVERIFY(lineAt(-whole, 0, z, halfCovered) > 25);
    QCOMPARE(lineAt(some, 0, z), 0);  // beyond the window
    scene().approach(0.25);
    const int dashes = lineAt(some, 0, z);
    QVERIFY2(dashes > 5 && dashes < 60, qPrintable(QString::number(dashes)));
    edit("eye.2", 0.3);  // too near to see the whole panel
    QTRY_COMPARE_WITH_TIMEOUT(lineAt(whole, 0, z), 0, patience);
  }

  void coloursFollowTheScheme() {
    const QPoint corner(3, widget()->height() / 2);
    QCOMPARE(painted().pixelColor(corner), tokens().canvas);
    const QColor dark = tokens().canvas;
    child<QAction>("lightColours")->trigger();
    QVERIFY(tokens().canvas != dark);
    QTRY_COMPARE_WITH_TIMEOUT(painted().pixelColor(corner), tokens().canvas, patience);
    QVERIFY(count(drawn(), tokens().eye) > 100);
    child<QAction>("darkColours")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(painted().pixelColor(corner), dark, patience);
  }

  void sizesOfFrustaAndThoseOfAPreview() {
    const auto farthest = [this] {  // from the eyes
      double most = 0;
      for (const Vec3& point : scene().frusta().points()) {
        double nearest = HUGE_VAL;
        for (const CameraState& state : m_session.cameras)
          nearest = std::min(nearest, length(point - state.camera.eye));
        most = std::max(most, nearest);
      }
      return most;
    };
    const double before = farthest();
    child<QAction>("sceneSmallerFrustaAction")->trigger();
    QVERIFY(std::abs(farthest() - before / 1.5) < 0.02 * before);
    child<QAction>("sceneLargerFrustaAction")->trigger();
    QVERIFY(std::abs(farthest() - before) < 1e-6);
    for (int k = 0; k < 20; ++k) child<QAction>("sceneSmallerFrustaAction")->trigger();
    QVERIFY(farthest() < 0.02 * before && farthest() > 0.01 * before);
    const QColor blue = tokens().focus;
    QCOMPARE(count(drawn(), blue), 0);
    for (int k = 0; k < 20; ++k) child<QAction>("sceneLargerFrustaAction")->trigger();
    CameraState added = m_session.cameras[5];
    added.camera.eye = {0.3, 0.2, 0.6};
    controller()->showPreview({added});
    QTRY_VERIFY_WITH_TIMEOUT(count(drawn(), blue) > 20, patience);
    controller()->showPreview({});
    QTRY_COMPARE_WITH_TIMEOUT(count(drawn(), blue), 0, patience);
  }

  void psnrColoursTheFrusta() {
    press(Qt::Key_F6);
    const QColor dark(68, 1, 84);
    const QColor bright(253, 231, 37);
    // The colour bar is at the right, the frusta are not.
    const auto frusta = [this](const QColor& colour) {
      const QImage image = drawn();
      return count(image.copy(0, 0, image.width() * 4 / 5, image.height()), colour);
    };
    const auto bar = [this](const QColor& colour) {
      const QImage image = painted();
      const int left = image.width() * 4 / 5;
      return count(image.copy(left, 0, image.width() - left, image.height()), colour);
    };
    QCOMPARE(frusta(bright) + bar(bright) + frusta(dark) + bar(dark), 0);
    controller()->showPsnr({20, 30, HUGE_VAL, 20, std::nan(""), 20});
    QTRY_VERIFY_WITH_TIMEOUT(frusta(bright) > 50,
                             patience);  // the 2nd, and the 3rd that is identical
    QVERIFY(frusta(dark) > 50);          // the 4th
    QVERIFY2(bar(bright) > 12 && bar(dark) > 12,
             qPrintable(QString("%1 %2").arg(bar(bright)).arg(bar(dark))));
    // The current frustum keeps its colour, its eye's ball has that of 20 dB.
    QVERIFY(count(drawn(), tokens().eye) > 50);
    QVERIFY(distance(painted().pixelColor(onScreen(edited("eye"))), dark) < 30);
    controller()->showPsnr({});
    QTRY_COMPARE_WITH_TIMEOUT(frusta(bright) + bar(bright) + frusta(dark) + bar(dark), 0, patience);
    controller()->showPsnr({25});  // fewer than states, one value
    QTest::qWait(50);
    child<QComboBox>("stateBox")->setCurrentIndex(2);
    child<QAction>("duplicateAction")->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(count(drawn(), dark), 0, patience);  // they are other states' now
  }

  void frustaCarryTheirViews() {
    scene().lookThrough(m_session.cameras[3]);  // without distortion; its near plane is the window
    press(Qt::Key_G, Qt::ControlModifier);      // the panel itself is plain
    const auto meanError = [this] {
      const QImage image = drawn();
      CameraState state = m_session.cameras[3];
      state.camera.res = {image.height(), image.height()};
      const Image expected = rendered(m_loaded.job(state));
      const int left = (image.width() - image.height()) / 2;
      double sum = 0;
      int pixels = 0;
      for (int y = 0; y < image.height(); y += 3) {
        for (int x = std::max(0, -left); x < std::min(image.height(), image.width() - left);
             x += 3) {
          const std::uint8_t* rgb =
              &expected.rgb[3 * (std::size_t(y) * std::size_t(image.height()) + std::size_t(x))];
          sum += distance(image.pixelColor(left + x, y), QColor(rgb[0], rgb[1], rgb[2])) / 3.0;
          ++pixels;
        }
      }
      return sum / pixels;
    };
    child<QComboBox>("stateBox")->setCurrentIndex(3);
    const double plain = meanError();
    QVERIFY2(plain > 50, qPrintable(QString::number(plain)));
    press(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY2_WITH_TIMEOUT(meanError() < 25, qPrintable(QString::number(meanError())), patience);
    press(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE_WITH_TIMEOUT(meanError(), plain, patience);
  }

  /// All frusta of 30 states but the current one are a fifth as long as those of 29.
  void manyFrustaAreSmall() {
    Session many = m_session;
    const CameraState first = m_session.cameras[3];  // looks at the middle of the panel
    const double distance = length(first.camera.eye - first.camera.lookat);
    const auto farthest = [&](std::size_t count) {
      many.cameras.assign(count, first);
      for (std::size_t k = 1; k < count; ++k) {
        many.cameras[k].camera.name = "s" + std::to_string(k);
        many.cameras[k].camera.eye = many.cameras[0].camera.eye + Vec3{10, 0, 0};
        many.cameras[k].camera.lookat = many.cameras[0].camera.lookat + Vec3{10, 0, 0};
      }
      open(many);
      double current = 0;
      double others = 0;
      for (const Vec3& point : scene().frusta().points()) {
        const bool isCurrent = point.x < 5;
        const Vec3& eye = many.cameras[isCurrent ? 0 : 1].camera.eye;
        (isCurrent ? current : others) =
            std::max(isCurrent ? current : others, length(point - eye) / distance);
      }
      return std::pair(current, others);
    };
    const auto [few, otherFew] = farthest(29);
    const auto [current, others] = farthest(30);
    QVERIFY(few > 0.25 && few < 0.5);
    QVERIFY(std::abs(otherFew - few) < 1e-3);
    QVERIFY(std::abs(current - few) < 1e-3);
    QVERIFY(std::abs(5 * others - few) < 1e-3);
  }

  /// The lens changes the simulated view, and nothing in the scene.
  void whatDidNotChangeIsNotDrawnAgain() {
    press(Qt::Key_G, Qt::ControlModifier);
    QTest::qWait(200);
    int drawn = 0;
    const vtkNew<vtkCallbackCommand> count;
    count->SetClientData(&drawn);
    count->SetCallback(
        [](vtkObject*, unsigned long, void* client, void*) { ++*static_cast<int*>(client); });
    widget()->renderWindow()->AddObserver(vtkCommand::EndEvent, count);
    const auto edited = [this](const char* area, const char* name, double value) {
      const qint64 before = child<ImageWidget>("pictureView")->image().cacheKey();
      editor<QDoubleSpinBox>(area, name)->setValue(value);
      return QTest::qWaitFor(
          [&] { return child<ImageWidget>("pictureView")->image().cacheKey() != before; },
          patience);
    };
    QVERIFY(edited("distortionArea", "k1", 0.1));
    QTest::qWait(100);
    QCOMPARE(drawn, 0);
    QVERIFY(edited("cameraArea", "eye.0", 0.1));
    QTest::qWait(100);
    QVERIFY(drawn > 0);
    widget()->renderWindow()->RemoveObserver(count);
  }

  void impossibleCamerasAndManyStatesDoNoHarm() {
    edit("eye.0", 0);
    edit("eye.2", 0);  // the eye is the look-at point
    QTRY_VERIFY_WITH_TIMEOUT(readout().contains("outside the viewing zone"), patience);
    press(Qt::Key_F8);
    controller()->showPixel(10, 10);
    QTest::mouseMove(widget(), QPoint(200, 200));
    Session many = m_session;
    many.cameras.resize(1);
    for (int k = 1; k < 300; ++k) {
      many.cameras.push_back(many.cameras[0]);
      many.cameras.back().camera.name = "s" + std::to_string(k);
      many.cameras.back().camera.eye.x = 0.01 * k - 1.5;
    }
    open(many);
    press(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
    press(Qt::Key_F6);
    click(onScreen(many.cameras[250].camera.eye));
    QVERIFY2(std::abs(current() - 250) <= 3, qPrintable(QString::number(current())));
    m_window.reset();  // while images are being rendered
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestScene>(argc, argv);
}
#include "test_scene.moc"
