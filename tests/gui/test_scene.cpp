// SPDX-License-Identifier: BSD-3-Clause
// Drives the 3-D scene in the real window: clicks frusta and hogels, drags handles, uses each
// command, and compares what is drawn with the reference engine.
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QScrollArea>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolTip>
#include <QtTest>

#include "core/fast_simulation.h"
#include "core/panel_view.h"
#include "core/pixel_trace.h"
#include "gui/display_scene.h"
#include "gui/main_window.h"
#include "gui/picture_view.h"
#include "gui/scene_controller.h"
#include "gui/vtk_widget.h"
#include "io/light_field_file.h"
#include "io/session_file.h"

using namespace hogelscope;

namespace {

int distance(const QColor& a, const QColor& b) {
  return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) +
         std::abs(a.blue() - b.blue());
}

/// How many pixels of the scene are nearly of this colour.
int count(const QImage& image, const QColor& colour) {
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (distance(image.pixelColor(x, y), colour) < 30) ++found;
  return found;
}

bool isNear(const Vec3& a, const Vec3& b, double tolerance) {
  return length(a - b) <= tolerance;
}

const QColor gridColour(128, 148, 179);
const QColor rayColour(255, 64, 115);

}  // namespace

class TestScene : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<MainWindow> m_window;
  Session m_session;
  Scene m_loaded;
  QTemporaryDir m_folder;

  template <class T>
  T* find(const char* name) const {
    return m_window->findChild<T*>(name);
  }
  SceneController* controller() const { return m_window->findChild<SceneController*>(); }
  DisplayScene& scene() const { return controller()->scene(); }
  VtkWidget* widget() const { return m_window->findChild<VtkWidget*>(); }
  QImage drawn() const { return widget()->grabFramebuffer(); }
  QString readout() const { return find<QLabel>("sceneReadout")->text(); }
  int current() const { return find<QComboBox>("stateBox")->currentIndex(); }
  Vec3 edited(const char* name) const {
    std::array<double, 3> value{};
    QWidget* form = find<QScrollArea>("cameraArea")->widget();
    for (int k = 0; k < 3; ++k)
      value[std::size_t(k)] =
          form->findChild<QDoubleSpinBox*>(QString("%1.%2").arg(name).arg(k))->value();
    return {value[0], value[1], value[2]};
  }
  void edit(const char* name, double value) {
    find<QScrollArea>("cameraArea")->widget()->findChild<QDoubleSpinBox*>(name)->setValue(value);
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(m_window.get(), key, modifiers);
    QTest::qWait(50);
  }

  /// Where a point of the world is drawn in the widget.
  QPoint onScreen(const Vec3& p) const {
    vtkRenderer* renderer = scene().renderer();
    renderer->SetWorldPoint(p.x, p.y, p.z, 1);
    renderer->WorldToDisplay();
    const double* at = renderer->GetDisplayPoint();
    return {int(at[0]), widget()->height() - 1 - int(at[1])};
  }
  void click(const QPoint& at) {
    QTest::mouseClick(widget(), Qt::LeftButton, {}, at);
    QTest::qWait(20);
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
  /// The lower right corner of a state's near plane.
  static Vec3 cornerOf(const CameraState& state) {
    const Camera camera(state.camera, state.intrinsics);
    const double depth = 0.25 * length(state.camera.lookat - state.camera.eye);
    const auto [width, height] = state.camera.res;
    const Vec2 p = camera.normalised(width - 0.5, height - 0.5);
    return camera.worldFromCamera().point({depth * p.x, depth * p.y, depth});
  }
  void open(const Session& session) {
    const QString file = m_folder.filePath("session.json");
    saveSession(file.toStdString(), session);
    m_session = session;
    m_loaded = loadScene(session, {});
    QVERIFY(m_window->openSession(file));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->statusBar()->currentMessage().contains(" ms"), 60000);
    QTest::qWait(100);
  }

 private Q_SLOTS:
  void init() {
    m_window = std::make_unique<MainWindow>();
    m_window->resize(1400, 800);
    m_window->show();
    m_window->activateWindow();  // shortcuts are the active window's
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    Session session = loadSession(HOGELSCOPE_SOURCE_DIR "/data/table1.json");
    session.lightField.file = HOGELSCOPE_SOURCE_DIR "/data/scene.png";
    // Some side by side; the others are at one place with the first.
    for (std::size_t k = 1; k < 4; ++k) session.cameras[k].camera.eye.x = 0.25 * double(k) - 0.3;
    open(session);
  }
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
      const Image expected = simulateFast(m_loaded.view(state));
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
    QTRY_VERIFY_WITH_TIMEOUT(shares() > 0.8, 10000);
    // The light leakage is the current state's.
    edit("eye.0", -0.25);
    QTRY_VERIFY_WITH_TIMEOUT(shares() > 0.8, 10000);
  }

  void thePanelCanShowItsGrid() {
    press(Qt::Key_F5);
    QTRY_COMPARE(scene().panel().gridLines(), 0);
    press(Qt::Key_G, Qt::ControlModifier);
    QVERIFY(!find<QAction>("scenePanelPictureAction")->isChecked());
    QTRY_VERIFY(count(drawn(), gridColour) > 1000);
    const int far = scene().panel().gridLines();
    QVERIFY2(far <= 2 * 65, qPrintable(QString::number(far)));  // not each of 128
    scene().renderer()->GetActiveCamera()->Dolly(8);
    QTRY_COMPARE(scene().panel().gridLines(), 2 * 129);
    press(Qt::Key_G, Qt::ControlModifier);
    QTRY_COMPARE(scene().panel().gridLines(), 0);
  }

  void aClickMakesAStateCurrent() {
    press(Qt::Key_F6);
    QSignalSpy picked(controller(), &SceneController::statePicked);
    click(onScreen(cornerOf(m_session.cameras[2])));
    QCOMPARE(current(), 2);
    QCOMPARE(picked.count(), 1);
    QCOMPARE(picked[0][0].toInt(), 2);
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
    QTRY_VERIFY2(QToolTip::text().startsWith("Fig 4: "), qPrintable(QToolTip::text()));
    QTest::mouseMove(widget(), QPoint(5, 5));
    QTRY_VERIFY(!QToolTip::isVisible() || QToolTip::text().isEmpty());
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

  void theBallsKeepTheirSizeOnTheScreen() {
    press(Qt::Key_F7);
    // How wide it is on the screen, across the frustum's axis.
    const auto ball = [this] {
      QTest::qWait(50);
      const QImage image = drawn();
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
      const QColor orange(255, 166, 38);
      const QPoint eye = onScreen(edited("eye"));
      return count(drawn().copy(QRect(eye - QPoint(12, 12), QSize(25, 25))), orange);
    };
    const std::vector<Vec3> corners{{-0.25, -0.25, 0}, {0.25, 0.25, 0}, edited("eye")};
    std::vector<QPoint> before;
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

  void draggingTheSceneTurnsIt() {
    const Vec3 before = scene().eye().eye;
    drag(QPoint(20, 20), QPoint(90, 60));
    QVERIFY(!isNear(scene().eye().eye, before, 0.05));
    QVERIFY(!m_window->isWindowModified());
    QVERIFY(readout().contains("Click a frustum"));  // that was no click
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
    find<QScrollArea>("cameraArea")->widget()->findChild<QDoubleSpinBox*>("eye.0")->setFocus();
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
    QVERIFY(scene().eye().eye.x > 0.1 && scene().eye().eye.y > 0.1 && scene().eye().eye.z > 0.5);
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
    QTRY_VERIFY(readout().contains("% of the panel lights this eye"));
  }

  void aPickedPixelIsTracedInNumbers() {
    auto* view = m_window->findChild<PictureView*>("pictureView");
    const int side = std::min(view->width(), view->height());
    const QPoint at = view->rect().center() + QPoint(side / 10, side / 7);
    QTest::mouseClick(view, Qt::LeftButton, {}, at);
    const QStringList lines = readout().split('\n');
    QCOMPARE(lines.size(), 4);
    static const QRegularExpression pixel(R"(Pixel \((\d+), (\d+)\): sees)");
    const QRegularExpressionMatch match = pixel.match(lines[1]);
    QVERIFY2(match.hasMatch(), qPrintable(readout()));
    const int x = match.captured(1).toInt();
    const int y = match.captured(2).toInt();
    QVERIFY(std::abs(x - 300 - 60) <= 3 && std::abs(y - 300 - 600 / 7) <= 3);
    const PixelTrace traced = trace(m_loaded.view(m_session.cameras[0]), x, y);
    QVERIFY2(lines[1].contains(QString::number(traced.colour->g, 'f', 1)), qPrintable(lines[1]));
    QVERIFY(lines[1].endsWith("25 leakage taps"));
    QVERIFY2(lines[2].startsWith(QString("hogel i %1, j %2 · direction u %3, v %4")
                                     .arg(int(traced.place->i))
                                     .arg(int(traced.place->j))
                                     .arg(int(traced.place->u))
                                     .arg(int(traced.place->v))),
             qPrintable(lines[2]));
    QVERIFY(lines[3].contains(QString::number(traced.slopes.y, 'f', 4)));
    QVERIFY(scene().picked().hasRay() && scene().picked().hasHogel());
    press(Qt::Key_F7);
    QVERIFY(count(drawn(), rayColour) > 50);
    // An edit moves the ray; another state has none.
    edit("eye.1", 0.05);
    QVERIFY(readout().split('\n')[3] != lines[3]);
    find<QComboBox>("stateBox")->setCurrentIndex(1);
    QVERIFY(!scene().picked().hasRay() && !scene().picked().hasHogel());
    controller()->showPixel(0, 0);
    QVERIFY2(readout().contains("Pixel (0, 0): no ray"), qPrintable(readout()));
    QVERIFY(!scene().picked().hasRay());
    find<QComboBox>("stateBox")->setCurrentIndex(3);
    controller()->showPixel(0, 0);  // the picture's corner does not see the panel
    QVERIFY2(readout().contains("Pixel (0, 0): misses the panel"), qPrintable(readout()));
    QVERIFY(scene().picked().hasRay() && !scene().picked().hasHogel());
    controller()->showPixel(-1, 0);
    QVERIFY(!scene().picked().hasRay() && readout().contains("Click a frustum"));
  }

  void aPickedHogelShowsItsPicture() {
    press(Qt::Key_F5);
    const Vec2 middle = hogelscope::Display(m_loaded.display).position(100.5, 20.5);
    click(onScreen({middle.x, middle.y, 0}));
    QVERIFY2(readout().contains("Hogel i 100, j 20 at x "), qPrintable(readout()));
    QVERIFY(readout().endsWith("20 × 20 directions over 60° × 60°"));
    QVERIFY(scene().picked().hasHogel() && !scene().picked().hasRay());
    QCOMPARE(scene().picked().label(), std::string("hogel 100, 20"));
    press(Qt::Key_0, Qt::ControlModifier);
    drawn().save(QCoreApplication::applicationDirPath() + "/picked_hogel.png");
  }

  void whatIsPickedIsRemoved() {
    press(Qt::Key_F7);
    auto* remove = find<QAction>("sceneForgetAction");
    QVERIFY(!remove->isEnabled());
    controller()->showPixel(300, 300);
    QVERIFY(remove->isEnabled());
    QVERIFY(scene().picked().hasRay() && !scene().picked().label().empty());
    press(Qt::Key_Escape);
    QVERIFY(!scene().picked().hasRay() && !scene().picked().hasHogel());
    QCOMPARE(scene().picked().label(), std::string());
    QVERIFY(readout().contains("Click a frustum") && !remove->isEnabled());
    QCOMPARE(count(drawn(), rayColour), 0);
    edit("eye.1", 0.05);  // it does not come back
    QVERIFY(!scene().picked().hasRay());
    press(Qt::Key_F5);
    const Vec2 middle = hogelscope::Display(m_loaded.display).position(100.5, 20.5);
    click(onScreen({middle.x, middle.y, 0}));
    QVERIFY(scene().picked().hasHogel());
    remove->trigger();
    QVERIFY(!scene().picked().hasHogel());
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
      const QImage image = drawn();
      const int left = image.width() * 4 / 5;
      return count(image.copy(left, 0, image.width() - left, image.height()), colour);
    };
    QCOMPARE(frusta(bright) + bar(bright) + frusta(dark) + bar(dark), 0);
    controller()->showPsnr({20, 30, HUGE_VAL, std::nan(""), 20, 20});
    QTRY_VERIFY(frusta(bright) > 50);  // the 2nd, and the 3rd that is identical
    QVERIFY(frusta(dark) > 50);
    QVERIFY(bar(bright) > 20 && bar(dark) > 20);
    controller()->showPsnr({});
    QTRY_COMPARE(frusta(bright) + bar(bright) + frusta(dark) + bar(dark), 0);
    controller()->showPsnr({25});  // fewer than states, one value
    QTest::qWait(50);
    find<QComboBox>("stateBox")->setCurrentIndex(2);
    find<QAction>("duplicateAction")->trigger();
    QTRY_COMPARE(count(drawn(), dark), 0);  // they are other states' now
  }

  void frustaCarryTheirViews() {
    scene().lookThrough(m_session.cameras[3]);  // without distortion; its near plane is the window
    press(Qt::Key_G, Qt::ControlModifier);      // the panel itself is plain
    const auto meanError = [this] {
      const QImage image = drawn();
      CameraState state = m_session.cameras[3];
      state.camera.res = {image.height(), image.height()};
      const Image expected = simulateFast(m_loaded.view(state));
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
    find<QComboBox>("stateBox")->setCurrentIndex(3);
    QVERIFY(meanError() > 60);
    press(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY2_WITH_TIMEOUT(meanError() < 25, qPrintable(QString::number(meanError())), 10000);
    press(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(meanError() > 60);
  }

  void impossibleCamerasAndManyStatesDoNoHarm() {
    edit("eye.0", 0);
    edit("eye.2", 0);  // the eye is the look-at point
    QTRY_VERIFY(readout().contains("outside the viewing zone"));
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
    m_window.reset();  // while pictures are being rendered
  }
};

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(VtkWidget::surfaceFormat());
  QApplication application(argc, argv);
  TestScene test;
  return QTest::qExec(&test, argc, argv);
}
#include "test_scene.moc"
