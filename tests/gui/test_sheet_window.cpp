// SPDX-License-Identifier: BSD-3-Clause
// Lens sheets in the real window: a quilt and a calibration, in any order, become a session; scene,
// inspector and Display section show lenses and views where those of hogels show hogels.
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QUndoStack>
#include <cmath>

#include "gui/files/opening_dialog.h"
#include "gui/scene/display_scene.h"
#include "gui/scene/scene_controller.h"
#include "gui/view/image_widget.h"
#include "io/opening/session_around.h"
#include "io/scene/view_source.h"
#include "tests/core/rendered.h"
#include "tests/gui/habits_test.h"
#include "tests/gui/shown_image.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

using namespace hogelscope;

namespace {

constexpr int views = 6;
constexpr double away = 0.6;  // the viewing distance, metres

const QByteArray calibration = R"({"serial": "unit", "pitch": {"value": 5.0}, "slope": -6.0,
    "center": 0.1, "viewCone": 40, "DPI": 50, "screenW": 180, "screenH": 120})";

}  // namespace

class TestSheetWindow : public HabitsTest {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup() { stop(); }
  void quiltStaysWithHogels();
  void quiltIsOpenedOnASheet();
  void calibrationShowsTheOpenQuilt();
  void calibrationAsksForAQuilt();
  void bothAreDropped();
  void mistakes();
  void displaySectionHasTheCalibration();
  void wrongCalibrationIsTried();
  void sectionsOfferWhatASheetHas();
  void sceneShowsLensesAndFlips();
  void eyesAreTold();
  void inspectorNamesSubPixels();
  void bothEyesAreShown();

 private:
  [[nodiscard]] QString path(const char* name) const { return m_folder->filePath(name); }
  [[nodiscard]] OpeningDialog* dialog() const { return m_window->findChild<OpeningDialog*>(); }
  template <class T>
  T* child(const char* name) const {
    return m_window->findChild<T*>(name);
  }
  [[nodiscard]] QString text(const char* label) const { return child<QLabel>(label)->text(); }
  [[nodiscard]] const ImageWidget* view() const { return child<ImageWidget>("pictureView"); }
  [[nodiscard]] DisplayScene& scene() const {
    return m_window->findChild<SceneController*>()->scene();
  }
  [[nodiscard]] bool hasPicture() const {
    return dialog() == nullptr && !view()->image().isNull() && view()->notice().isEmpty();
  }
  [[nodiscard]] bool isSettled() const {
    return dialog() != nullptr && dialog()->isVisible() &&
           !dialog()->findChild<ImageWidget*>("previewView")->notice().startsWith("Looking");
  }
  void askAbout(const QString& file) {
    const DialogAnswer answer(file);
    action("openLightFieldAsAction")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
  }
  void choose(int display) {
    auto* box = dialog()->findChild<QComboBox*>("displaysBox");
    QVERIFY(box->isVisible());
    box->setCurrentIndex(display);
    Q_EMIT box->activated(display);
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
  }
  void accept() {
    QTest::mouseClick(
        dialog()->findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::Open),
        Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  }
  /// Drops quilt and calibration, and waits for the view.
  void openSheet() {
    drop({path("q_qs6x1a1.5.png"), path("visual.json")});
    QTRY_VERIFY_WITH_TIMEOUT(model().session().display.sheet && hasPicture(), patience);
  }
  /// The session of the quilt and a calibration is open, before the sheet's middle.
  void verifySheet(const char* file = "visual.json") const {
    const Session& session = model().session();
    QVERIFY(session.display.sheet.has_value());
    QCOMPARE(QString::fromStdString(session.display.sheet->file), path(file));
    QCOMPARE(session.display.sheet->viewingDistance, away);
    QVERIFY(session.lightField.layout == Layout::quilt);
    QCOMPARE(session.cameras.size(), std::size_t{1});
    QVERIFY((session.cameras[0].camera.eye == Vec3{0, 0, away}));
    const Image seen = rendered(loadViewSource(session, {}).job(model().current()));
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), seen), patience);
    QCOMPARE(errors(), QString());
  }
};

/// Views of 30×20 pixels, each of one grey.
void TestSheetWindow::init() {
  start();
  makeWindow({});
  writeFile(path("visual.json"), calibration);
  writeImageFile(path("q_qs6x1a1.5.png"), 30 * views, 20,
                 [](int x, int, int) { return float(40 * (x / 30) + 20) / 255; });
}

void TestSheetWindow::quiltStaysWithHogels() {
  drop({path("q_qs6x1a1.5.png")});
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  QVERIFY(!model().session().display.sheet);
  askAbout(path("q_qs6x1a1.5.png"));
  const auto* box = dialog()->findChild<QComboBox*>("displaysBox");
  QCOMPARE(box->currentIndex(), 0);
  QCOMPARE(box->count(), 2);  // no calibration is known yet
  accept();
  QVERIFY(!model().session().display.sheet);
  QVERIFY(!child<QLabel>("sheetLabel")->isVisible());
  // The section Display offers a lens sheet, as an edit.
  auto* offer = child<QPushButton>("chooseSheetButton");
  QVERIFY(!offer->isHidden() && offer->text().contains("lens sheet"));
  const DialogAnswer answer(path("visual.json"));
  offer->click();
  QVERIFY(model().session().display.sheet.has_value());
  const Image seen = rendered(loadViewSource(model().session(), {}).job(model().current()));
  QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), seen), patience);
  model().undoStack()->undo();
  QVERIFY(!model().session().display.sheet);
  QCOMPARE(errors(), QString());
}

void TestSheetWindow::quiltIsOpenedOnASheet() {
  askAbout(path("q_qs6x1a1.5.png"));
  {
    const DialogAnswer answer("");  // none is chosen
    choose(1);
  }
  QCOMPARE(dialog()->findChild<QComboBox*>("displaysBox")->currentIndex(), 0);
  {
    const DialogAnswer answer(path("visual.json"));
    choose(1);
  }
  const auto* box = dialog()->findChild<QComboBox*>("displaysBox");
  QCOMPARE(box->currentText(), QString("Seen on the lens sheet of visual.json"));
  const QString table = dialog()->findChild<QLabel*>("assumedLabel")->text();
  QVERIFY2(table.contains("unit · 180 × 120 px of 0.5080 mm"), qPrintable(table));
  QVERIFY(!table.contains("Field of view"));
  QVERIFY(dialog()->findChild<QLabel*>("headlineLabel")->text().startsWith("6 views of 30 × 20"));
  QVERIFY(!dialog()->findChild<QSpinBox*>("hogels.0")->isVisible());
  QVERIFY(!dialog()->findChild<QDoubleSpinBox*>("viewingDistance")->isVisible());
  accept();
  verifySheet();
  // The next one may be seen on the same sheet.
  askAbout(path("q_qs6x1a1.5.png"));
  QCOMPARE(dialog()->findChild<QComboBox*>("displaysBox")->currentIndex(), 0);
  choose(1);
  accept();
  verifySheet();
}

void TestSheetWindow::calibrationShowsTheOpenQuilt() {
  drop({path("q_qs6x1a1.5.png")});
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  const DialogAnswer answer(path("visual.json"));
  action("openAction")->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(model().session().display.sheet && hasPicture(), patience);
  verifySheet();
}

void TestSheetWindow::calibrationAsksForAQuilt() {
  const DialogAnswer answer(path("q_qs6x1a1.5.png"));
  makeWindow({path("visual.json")});  // as an argument of the program
  QTRY_VERIFY_WITH_TIMEOUT(model().session().display.sheet && hasPicture(), patience);
  verifySheet();
}

/// In any order, also while another session is open.
void TestSheetWindow::bothAreDropped() {
  openSheet();
  verifySheet();
  makeWindow({m_session});
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  openSheet();
  verifySheet();
}

/// The session stays, and one line says why.
void TestSheetWindow::mistakes() {
  drop({path("q_qs6x1a1.5.png")});
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  const Session before = model().session();
  writeFile(path("visual.json"),
            QByteArray(calibration).replace("\"slope\": -6.0", "\"slope\": 0"));
  drop({path("visual.json")});
  QTRY_VERIFY_WITH_TIMEOUT(
      errors().contains("visual.json: slope: is 0: lenses along the rows; turn the panel by 90°"),
      patience);
  QVERIFY(model().session() == before);
  askAbout(path("q_qs6x1a1.5.png"));
  {
    const DialogAnswer answer(path("visual.json"));
    choose(1);
  }
  QVERIFY(dialog()->findChild<QLabel*>("problemLabel")->text().contains("slope: is 0"));
  auto* buttons = dialog()->findChild<QDialogButtonBox*>("buttons");
  QVERIFY(!buttons->button(QDialogButtonBox::Open)->isEnabled());
  choose(0);
  QVERIFY(buttons->button(QDialogButtonBox::Open)->isEnabled());
  dialog()->reject();
  writeFile(path("visual.json"), calibration);
  writeFile(path("a.obj"), "v -1 -1 0\nv 1 -1 0\nv 0 1 0.5\nf 1 2 3\n");
  drop({path("a.obj"), path("visual.json")});
  QTRY_VERIFY_WITH_TIMEOUT(errors().contains("must be \"quilt\" for a lens sheet"), patience);
  QVERIFY(model().session() == before);
}

/// A sheet gets the other calibration, as an edit that keeps its place and states.
void TestSheetWindow::displaySectionHasTheCalibration() {
  openSheet();
  const QString figures = text("sheetLabel");
  QVERIFY2(figures.startsWith("<b>visual.json</b>") && figures.endsWith("cone 40°") &&
               figures.contains("leaning 9.46° to the right"),
           qPrintable(figures));
  auto* area = child<QWidget>("displayArea");
  for (const char* name : {"size.0", "hogels.0", "directions.0", "fov.0"})
    if (const auto* box = area->findChild<QWidget*>(name)) QVERIFY2(!box->isVisible(), name);
  area->findChild<QDoubleSpinBox*>("viewingDistance")->setValue(0.7);
  writeFile(path("other.json"), QByteArray(calibration).replace("40", "30"));
  const DialogAnswer answer(path("other.json"));
  child<QPushButton>("chooseSheetButton")->click();
  const SheetDisplay& sheet = *model().session().display.sheet;
  QCOMPARE(QString::fromStdString(sheet.file), path("other.json"));
  QCOMPARE(sheet.viewingDistance, 0.7);
  QVERIFY(text("sheetLabel").endsWith("cone 30°"));
  QVERIFY((model().current().camera.eye == Vec3{0, 0, away}));
  model().undoStack()->undo();
  QCOMPARE(text("sheetLabel"), figures);
}

/// The panel is woven for another calibration: views move aside, as an edit.
void TestSheetWindow::wrongCalibrationIsTried() {
  openSheet();
  auto* box = child<QCheckBox>("weaveBox");
  auto* area = child<QWidget>("lightFieldArea");
  QVERIFY(!box->isChecked());
  const QImage right = view()->image();
  box->click();
  QVERIFY(model().session().lightField.calibration == model().session().display.sheet->calibration);
  auto* center = area->findChild<QDoubleSpinBox*>("center");
  QVERIFY(center != nullptr);
  center->setValue(center->value() + 2.0 / views);
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture() && view()->image() != right, patience);
  const Image seen = rendered(loadViewSource(model().session(), {}).job(model().current()));
  QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), seen), patience);
  box->click();
  QTRY_VERIFY_WITH_TIMEOUT(view()->image() == right, patience);
  QVERIFY(!model().session().lightField.calibration);
  QCOMPARE(errors(), QString());
}

/// What a sheet refuses is not offered, but can be mended where it is given.
void TestSheetWindow::sectionsOfferWhatASheetHas() {
  const auto offers = [this](const char* area, const char* name) {
    const auto* box = child<QWidget>(area)->findChild<QWidget*>(name);
    return box != nullptr && box->isVisibleTo(child<QWidget>(area));
  };
  const std::vector<std::pair<const char*, const char*>> ofHogels{
      {"twinArea", "focalError"}, {"twinArea", "wedge.0"},   {"twinArea", "sigmaGrowth"},
      {"psfArea", "windowSize"},  {"psfArea", "kernelView"}, {"samplingArea", "reconstruction"}};
  drop({path("q_qs6x1a1.5.png")});
  QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  for (const auto& [area, name] : ofHogels) QVERIFY2(offers(area, name), name);
  openSheet();
  for (const auto& [area, name] : ofHogels) QVERIFY2(!offers(area, name), name);
  QVERIFY(offers("twinArea", "gapError") && offers("samplingArea", "samplesPerPixel"));
  QVERIFY(text("energyLabel").contains("no directions to leak into"));
  TwinParams twin;
  twin.lensArray.focalError = 0.01;
  Session content = withTwin(model().session(), twin);
  content.sampling.reconstruction = Reconstruction::bilinear;
  model().setContent(content);
  QVERIFY(offers("twinArea", "focalError") && offers("samplingArea", "reconstruction"));
  QVERIFY(!offers("psfArea", "windowSize"));
  model().editMarked([](CameraState& state) { state.psf = {.sigma = 1, .windowSize = 3}; });
  QVERIFY(offers("psfArea", "windowSize") && offers("psfArea", "kernelView"));
}

void TestSheetWindow::sceneShowsLensesAndFlips() {
  openSheet();
  const auto overview = [this] {
    QTest::qWait(100);
    return scene().panel().gridLines();
  };
  QVERIFY2(overview() >= 3 && overview() < 10, qPrintable(QString::number(overview())));
  CameraState near = model().current();
  near.camera.eye.z = 0.2;
  model().setCurrent(near);
  action("sceneLookThroughAction")->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(scene().panel().gridLines() >= 18, patience);  // each lens
  // The flips at the viewing distance lean as the lenses do.
  const PanelParams display{model().session().display};
  const std::vector<Vec3> cone = coneOf(display, 1, away);
  const double side = away * std::tan(radians(20));
  const double top = display.size[1] / 2;
  QCOMPARE(cone.size(), std::size_t{4});
  QVERIFY(length(cone[0] - Vec3{-side - top / 6, -top, away}) < 1e-12);
  QVERIFY(length(cone[2] - Vec3{side + top / 6, top, away}) < 1e-12);
}

/// Beyond a flip an eye sees the views of the other side.
void TestSheetWindow::eyesAreTold() {
  openSheet();
  const auto said = [this](double x) {
    CameraState state = model().current();
    state.camera.eye.x = x;
    model().setCurrent(state);
    return text("sceneReadout").section('\n', 0, 0);
  };
  const double side = away * std::tan(radians(20));
  QCOMPARE(said(0), QString("View: between the flips, 0.2184 m from the next one"));
  QVERIFY(said(side - 0.05).endsWith("between the flips, 50 mm from the next one"));
  QVERIFY(said(side + 0.05).contains("beyond a flip, where views are seen again, 50 mm"));
  // Both sides of the flip, as it is rendered: the last view, and the first one.
  const auto middle = [&](double x) {
    (void)said(x);
    const Image image = rendered(loadViewSource(model().session(), {}).job(model().current()));
    return int(image.rgb[3 * (std::size_t(image.height) / 2 * image.width + image.width / 2)]);
  };
  QCOMPARE(middle(side - 0.03), 220);
  QCOMPARE(middle(side + 0.03), 20);
}

void TestSheetWindow::inspectorNamesSubPixels() {
  openSheet();
  child<QDockWidget>("inspectorDock")->show();
  auto* controller = m_window->findChild<SceneController*>();
  QCOMPARE(controller->views(), views);
  const auto [width, height] = model().current().camera.res;
  const QPoint pixel(width / 3, height / 2);
  controller->showPixel(pixel.x(), pixel.y());
  QTRY_VERIFY_WITH_TIMEOUT(text("inspectorValues").startsWith("Pixel"), patience);
  const QString values = text("inspectorValues");
  for (const char* word : {"hogel", "direction", "leakage"})
    QVERIFY2(!values.contains(word), qPrintable(values));
  QVERIFY(child<ImageWidget>("inspectorHogel")->isHidden());
  QVERIFY(scene().picked().hasRay() && scene().picked().label().empty());
  // The views whose greys the pixel has.
  const QColor colour = view()->image().pixelColor(pixel);
  for (const auto& [name, grey] :
       {std::pair("red", colour.red()), std::pair("green", colour.green()),
        std::pair("blue", colour.blue())}) {
    const QString line = values.split('\n').filter(QString(name) + ": column ").value(0);
    QVERIFY2(line.endsWith(QString("view %1 of 0 … 5").arg((grey - 20) / 40)), qPrintable(values));
  }
}

/// Each eye of a viewer sees a view of its own.
void TestSheetWindow::bothEyesAreShown() {
  openSheet();
  CameraState state = model().current();
  state.stereo.ipd = 0.2;
  model().setCurrent(state);
  action("eyesSideBySideAction")->trigger();
  const int width = state.camera.res[0];
  QTRY_COMPARE_WITH_TIMEOUT(view()->image().width(), 2 * width, patience);
  const int row = state.camera.res[1] / 2;
  QVERIFY(view()->image().pixelColor(width / 2, row).red() <
          view()->image().pixelColor(width + width / 2, row).red());
}

int main(int argc, char** argv) {
  return runHabitsTest<TestSheetWindow>(argc, argv);
}
#include "test_sheet_window.moc"
