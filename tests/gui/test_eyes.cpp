// SPDX-License-Identifier: BSD-3-Clause
// Pupil, focus and two eyes in the real window: the fields of the section Eyes, what the simulated
// view shows, Ctrl and a click, and the frusta of both eyes.
#include <QAction>

#include "core/engine/focus_search.h"
#include "core/optics/eyes.h"
#include "core/optics/stereo_image.h"
#include "gui/scene/frustum_actors.h"
#include "gui/view/image_widget.h"
#include "tests/core/rendered.h"
#include "tests/gui/scene_test.h"
#include "tests/gui/shown_image.h"

using namespace hogelscope;

class TestEyes : public SceneTest {
  Q_OBJECT

 private:
  ImageWidget* view() const { return child<ImageWidget>("pictureView"); }
  QDoubleSpinBox* field(const char* name) const {
    return editor<QDoubleSpinBox>("propertiesDock", name);
  }
  /// Sets a field of the section, which keeps its form's unit.
  void set(const char* name, double value) const { field(name)->setValue(value); }
  CameraState state() const { return m_model->current(); }
  Image imageOf(const CameraState& eye) const { return rendered(m_loaded.job(eye)); }
  void trigger(const char* action) const { child<QAction>(action)->trigger(); }
  /// The widget's place of a pixel of the 120 × 120 px view.
  QPoint placeOf(const QPoint& pixel) const {
    const double zoom = std::min(view()->width() / 120.0, view()->height() / 120.0);
    const QPointF corner(view()->width() / 2.0 - 60 * zoom, view()->height() / 2.0 - 60 * zoom);
    return (corner + (QPointF(pixel) + QPointF(0.5, 0.5)) * zoom).toPoint();
  }

 private Q_SLOTS:
  void init() {
    startSmall();
    openSection("eyes");
  }
  void cleanup() { m_window.reset(); }

  void fieldsChangeTheView() {
    set("diameter", 30);
    set("focus", 0.4);
    QCOMPARE(state().pupil.diameter, 0.03);
    QCOMPARE(state().pupil.focus, 0.4);
    const Image expected = imageOf(state());
    QVERIFY(expected.rgb != imageOf(m_session.cameras[0]).rgb);
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), expected), patience);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" samples of the pupil"), patience);
    trigger("undoAction");
    QCOMPARE(state().pupil.focus, 0.0);
  }

  void aPinholeHasNoFocus() {
    QVERIFY(!field("focus")->isVisible());
    set("diameter", 4);
    QVERIFY(field("focus")->isVisible());
  }

  void ctrlAndAClickFocus() {
    QTest::mouseClick(view(), Qt::LeftButton, Qt::ControlModifier, placeOf({60, 60}));
    QVERIFY2(message().contains("pinhole"), qPrintable(message()));
    set("diameter", 30);
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), imageOf(state())), patience);
    LensTables tables;
    const auto expected =
        sharpestFocus(m_loaded.job(state()), 50, 70, tables, serialRows).value_or(0);
    QVERIFY(expected > 0);
    QTest::mouseClick(view(), Qt::LeftButton, Qt::ControlModifier, placeOf({50, 70}));
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(state().pupil.focus - expected) < 0.001, patience);
    QVERIFY(view()->markedPixels().isEmpty());
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), imageOf(state())), patience);
    QTest::qWait(50);
    m_window->grab().save(QCoreApplication::applicationDirPath() + "/eyes.png");
  }

  void aPlainClickSaysWhereItIsSharp() {
    set("diameter", 30);
    QTest::keyClick(m_window.get(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), imageOf(state())), patience);
    QTest::mouseClick(view(), Qt::LeftButton, {}, placeOf({50, 70}));
    QEvent away(QEvent::Leave);
    QApplication::sendEvent(view(), &away);
    QCOMPARE(view()->markedPixels(), QRegion(50, 70, 1, 1));
    QCOMPARE(state().pupil.focus, 0.0);
    const auto* values = child<QLabel>("inspectorValues");
    QTRY_VERIFY_WITH_TIMEOUT(values->text().contains("Sharp at a focus of"), patience);
    trigger("focusAction");
    QTRY_VERIFY_WITH_TIMEOUT(state().pupil.focus > 0, patience);
  }

  void bothEyesAreShown_data() {
    QTest::addColumn<QString>("action");
    QTest::addColumn<int>("mode");
    QTest::newRow("side by side") << "eyesSideBySideAction" << int(StereoMode::sideBySide);
    QTest::newRow("anaglyph") << "anaglyphAction" << int(StereoMode::anaglyph);
    QTest::newRow("anaglyph, grey") << "anaglyphGreyAction" << int(StereoMode::anaglyphGrey);
    QTest::newRow("cross-eyed") << "crossEyedAction" << int(StereoMode::crossEyed);
  }
  void bothEyesAreShown() {
    QFETCH(const QString, action);
    QFETCH(const int, mode);
    trigger(qPrintable(action));
    // A state with one eye is shown itself.
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), imageOf(state())), patience);
    set("ipd", 60);
    const std::vector<CameraState> eyes = eyesOf(state(), m_loaded.display);
    const Image expected =
        stereoImage(imageOf(eyes[0]), imageOf(eyes[1]), static_cast<StereoMode>(mode));
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), expected), patience);
    QCOMPARE(view()->seen().size(), view()->image().size());
    trigger("headViewAction");
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), imageOf(state())), patience);
  }

  void oneEyeIsShown() {
    set("ipd", 60);
    const std::vector<CameraState> eyes = eyesOf(state(), m_loaded.display);
    trigger("leftEyeAction");
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), imageOf(eyes[0])), patience);
    trigger("rightEyeAction");
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), imageOf(eyes[1])), patience);
  }

  /// A pixel on the right of two pictures is the right eye's.
  void picksKnowTheEye() {
    set("ipd", 60);
    const std::vector<CameraState> eyes = eyesOf(state(), m_loaded.display);
    trigger("eyesSideBySideAction");
    QTRY_COMPARE_WITH_TIMEOUT(view()->image().width(), 240, patience);
    const auto right = controller()->viewAt({170, 40});
    QVERIFY(right.has_value());
    QCOMPARE(right->pixel, QPoint(50, 40));
    QCOMPARE(right->job.state, eyes[1]);
    QCOMPARE(controller()->viewAt({119, 40})->job.state, eyes[0]);
    QVERIFY(!controller()->viewAt({240, 40}).has_value());
    trigger("crossEyedAction");
    QCOMPARE(controller()->viewAt({119, 40})->job.state, eyes[1]);
  }

  void theSceneHasTheFrustaOfBoth() {
    const auto hasPoint = [this](const Vec3& wanted) {
      return std::ranges::any_of(scene().frusta().points(),
                                 [&](const Vec3& point) { return isNear(point, wanted, 1e-6); });
    };
    QVERIFY(hasPoint(state().camera.eye));
    set("ipd", 60);
    QTest::qWait(50);
    for (const CameraState& eye : eyesOf(state(), m_loaded.display))
      QVERIFY(hasPoint(eye.camera.eye));
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestEyes>(argc, argv);
}

#include "test_eyes.moc"
