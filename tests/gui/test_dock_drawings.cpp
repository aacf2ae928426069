// SPDX-License-Identifier: BSD-3-Clause
// What the distortion and PSF docks of the real window draw, and what they say about it.
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>

#include "core/base/colour_map.h"
#include "gui/docks/parameter_drawings.h"
#include "gui/widgets/colours.h"
#include "tests/gui/docks_test.h"
#include "tests/gui/shown_image.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

/// Pixels of a drawing that are nearly of a colour.
int pixelsOf(QWidget* drawing, const QColor& colour) {
  return count(drawing->grab().toImage(), colour, 60);
}

/// Of a tap in the drawing, near its top left corner.
QColor colourOfTap(KernelWidget& kernel, const QString& tap) {
  const QImage image = kernel.grab().toImage();
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (kernel.textAt(QPointF(x, y)).startsWith("Tap " + tap))
        return image.pixelColor(x + 3, y + 3);
  return {};
}

bool isColour(const QColor& colour, double share) {
  const auto [r, g, b] = falseColour(share);
  return distance(colour, QColor(r, g, b)) < 6;
}

}  // namespace

class TestDockDrawings : public DocksTest {
  Q_OBJECT

 private Q_SLOTS:
  void init() { showWindow(); }
  void cleanup() { m_window.reset(); }

  /// docs/formulas.md, Design numbers.
  void theDisplaysNumbersAreToldForTheEye() {
    start();  // 16 hogels of 4 directions, seen from 0.7 m
    for (const char* side : {"size.0", "size.1"})
      editor<QDoubleSpinBox>("displayArea", side)->setValue(0.4);
    const auto told = [this](const char* name) { return child<QLabel>(name)->accessibleName(); };
    QCOMPARE(told("number1"), QString("25.0 mm, hogel pitch"));
    QVERIFY2(told("number2").startsWith("123 arcmin"), qPrintable(told("number2")));
    editor<QDoubleSpinBox>("cameraArea", "eye.2")->setValue(1.4);
    QVERIFY2(told("number2").startsWith("61.4 arcmin"), qPrintable(told("number2")));
    editor<QDoubleSpinBox>("cameraArea", "eye.2")->setValue(-1);  // behind the panel
    QVERIFY(told("number2").startsWith("– "));
  }

  /// docs/formulas.md, Lens sheet; and those of hogels again.
  void aLensSheetHasNumbersOfItsOwn() {
    QImage quilt(32, 12, QImage::Format_RGB32);
    quilt.fill(Qt::gray);
    QVERIFY(quilt.save(m_folder.filePath("q_qs8x6a1.5.png")));
    writeFile(m_folder.filePath("sheet.json"), R"({"hogelscope": 1,
      "display": {"kind": "sheet", "calibration": {"pitch": 5, "slope": -6, "center": 0.1,
        "dpi": 50, "panel": [180, 120], "cone": 40}},
      "lightField": {"layout": "quilt", "file": "q_qs8x6a1.5.png"},
      "cameras": [{"name": "a", "eye": [0, 0, 0.5], "fov": 20, "res": [40, 30]}]})");
    open(m_folder.filePath("sheet.json"));
    const auto told = [this](const char* name) { return child<QLabel>(name)->accessibleName(); };
    QCOMPARE(told("number1"), QString("132 views/m, sideways"));
    QCOMPARE(told("number2"), QString("40.0 °, viewing cone"));
    QCOMPARE(told("number3"), QString("36.4 cm, between flips"));
    QCOMPARE(told("number4"), QString("0.51 views, in one place, rms"));
    QCOMPARE(told("number5"), QString("17.3 %, eyes swapped"));
    QVERIFY(child<QLabel>("number1")->toolTip().startsWith("How many views"));
    openSmall();
    QVERIFY2(told("number1").endsWith("hogel pitch"), qPrintable(told("number1")));
    QVERIFY(child<QLabel>("number1")->toolTip().startsWith("The panel's size"));
  }

  /// More hogels are smaller, or with an open lock make a larger panel.
  void theLockHoldsTheSize() {
    start();
    auto* hogels = editor<QSpinBox>("displayArea", "hogels.0");
    const auto size = [this] { return m_model->session().display.size; };
    const auto before = size();
    hogels->setValue(32);
    QCOMPARE(m_model->session().display.hogels[1], 32);  // linked
    QVERIFY(size() == before);
    child<QAbstractButton>("size.lock")->setChecked(false);
    hogels->setValue(64);
    QCOMPARE(size()[0], 2 * before[0]);
    QCOMPARE(size()[1], 2 * before[1]);
  }

  void theKernelIsDrawnAndItsLossTold() {
    openSmall();
    openSection("psf");
    auto* kernel = m_window->findChild<KernelWidget*>("kernelView");
    auto* energy = child<QLabel>("energyLabel");
    QTRY_VERIFY_WITH_TIMEOUT(kernel->isVisible(), patience);
    editor<QDoubleSpinBox>("psfArea", "sigma")->setValue(2);
    editor<QSpinBox>("psfArea", "windowSize")->setValue(7);
    QCOMPARE(editor<QSpinBox>("psfArea", "windowSize")->value(), 7);
    QCOMPARE(kernel->weights().size(), std::size_t(49));
    // docs/formulas.md, Light leakage.
    QVERIFY2(energy->text().contains("⚠ 15.4 % of the Gaussian's energy"),
             qPrintable(energy->text()));
    const QString middle = kernel->textAt(kernel->rect().center() - QPointF(0, 12));
    QVERIFY2(middle.startsWith("Tap (0, 0): 4.67"), qPrintable(middle));  // 1 / Σ W
    QVERIFY(kernel->textAt({0, 0}).isEmpty());
    QVERIFY(isColour(colourOfTap(*kernel, "(0, 0)"), 1));
    QVERIFY(isColour(colourOfTap(*kernel, "(-3, 3)"), std::exp(-18.0 / 8)));
    QVERIFY(isColour(colourOfTap(*kernel, "(1, -2)"), std::exp(-5.0 / 8)));
    editor<QDoubleSpinBox>("psfArea", "sigma")->setValue(1);
    QVERIFY(!energy->text().contains("⚠"));
    QVERIFY(energy->text().startsWith("0.0930 %") || energy->text().startsWith("0.093 %"));
    QVERIFY(isColour(colourOfTap(*kernel, "(1, -2)"), std::exp(-5.0 / 2)));
    editor<QDoubleSpinBox>("psfArea", "sigma")->setValue(0);
    QVERIFY(kernel->weights().empty());
    QVERIFY(energy->text().contains("⚠"));
    editor<QSpinBox>("psfArea", "windowSize")->setValue(99);
    kernel->grab();
  }

  void theLensIsDrawnWithItsFold() {
    openSmall();
    openSection("distortion");
    auto* lens = m_window->findChild<LensWidget*>();
    QTRY_VERIFY_WITH_TIMEOUT(lens->isVisible(), patience);
    lens->setFixedSize(400, 360);
    const QColor red(200, 40, 40);
    const QColor blue(52, 94, 150);
    for (const char* name : {"k1", "k2", "k3"})
      editor<QDoubleSpinBox>("distortionArea", name)->setValue(0);
    QTRY_VERIFY_WITH_TIMEOUT(pixelsOf(lens, blue) > 1000 && pixelsOf(lens, red) == 0, patience);
    const int straight = pixelsOf(lens, blue);
    editor<QDoubleSpinBox>("distortionArea", "k1")->setValue(-1.2);  // folds at r = 0.527
    QTRY_VERIFY_WITH_TIMEOUT(pixelsOf(lens, red) > 500, patience);
    QVERIFY(pixelsOf(lens, blue) != straight);
    auto* certificate = child<QLabel>("certificateLabel");
    QVERIFY(certificate->text().contains("have no ray: the lens folds"));
    editor<QComboBox>("samplingArea", "mapping")->setCurrentText("direct");
    QTRY_VERIFY_WITH_TIMEOUT(pixelsOf(lens, red) == 0, patience);
    lens->setFixedSize(1, 1);
    lens->grab();
  }

  /// What the other model has too is kept, the rest is 0, and one undo brings all of it back.
  void theLensModelIsOneEdit() {
    openSmall();
    openSection("distortion");
    auto* certificate = child<QLabel>("certificateLabel");
    auto* model = editor<QComboBox>("distortionArea", "model");
    editor<QDoubleSpinBox>("distortionArea", "k1")->setValue(0.2);
    editor<QDoubleSpinBox>("distortionArea", "p1")->setValue(0.01);
    const DistortionParams brown = m_model->current().distortion;
    QVERIFY(editor<QDoubleSpinBox>("distortionArea", "k4") == nullptr ||
            !editor<QDoubleSpinBox>("distortionArea", "k4")->isVisible());
    const int before = m_model->undoStack()->index();
    model->setCurrentText("fisheye");
    QCOMPARE(m_model->undoStack()->index(), before + 1);
    QVERIFY((m_model->current().distortion == DistortionParams{brown.k1, brown.k2, 0, 0, brown.k3,
                                                               0, 0, 0, DistortionModel::fisheye}));
    QTRY_VERIFY_WITH_TIMEOUT(certificate->isEnabled(), patience);
    QVERIFY2(certificate->text().contains("one-to-one"), qPrintable(certificate->text()));
    m_model->undoStack()->undo();
    QVERIFY(m_model->current().distortion == brown);
    QCOMPARE(model->currentText(), QString("brown"));
  }

  /// A picture wider than a fisheye's field: its edge, a circle of θ = 90°, is drawn.
  void theFieldsEdgeOfAFisheyeIsDrawn() {
    openSmall();
    openSection("distortion");
    auto* lens = m_window->findChild<LensWidget*>();
    QTRY_VERIFY_WITH_TIMEOUT(lens->isVisible(), patience);
    lens->setFixedSize(400, 360);
    CameraState state = m_model->current();
    state.camera.fov = 140;  // its corners are 2.7 from the middle, π/2 has no ray
    state.distortion = {0, 0, 0, 0, 0, 0, 0, 0, DistortionModel::fisheye};
    m_model->setCurrent(state);
    QTRY_VERIFY_WITH_TIMEOUT(pixelsOf(lens, QColor(200, 40, 40)) > 500, patience);
    QVERIFY(child<QLabel>("certificateLabel")->text().contains("they would be 90° off the axis"));
  }

  /// Grey from the edit on, until what is said is of this lens.
  void aStaleCertificateIsGrey() {
    openSmall();
    openSection("distortion");
    auto* certificate = child<QLabel>("certificateLabel");
    auto* lens = m_window->findChild<LensWidget*>();
    const auto isGrey = [&] { return !certificate->isEnabled() && !lens->isEnabled(); };
    QTRY_VERIFY_WITH_TIMEOUT(certificate->isEnabled() && lens->isEnabled(), patience);
    const QString before = certificate->text();
    const int blue = pixelsOf(lens, tokens().series[0]);
    editor<QDoubleSpinBox>("distortionArea", "k1")->setValue(0.2);
    QVERIFY(isGrey());
    QCOMPARE(certificate->text(), before);
    QVERIFY(pixelsOf(lens, tokens().series[0]) < blue / 10);
    QTRY_VERIFY_WITH_TIMEOUT(certificate->isEnabled() && lens->isEnabled(), patience);
    QVERIFY(certificate->text() != before);
    editor<QDoubleSpinBox>("cameraArea", "eye.0")->setValue(0.01);  // the lens stays
    QVERIFY(!isGrey());
    // Another one and back before anything could be worked out.
    editor<QDoubleSpinBox>("distortionArea", "k1")->setValue(0.3);
    m_model->undoStack()->undo();
    QVERIFY(!isGrey());
    child<QComboBox>("stateBox")->setCurrentIndex(3);
    QVERIFY(isGrey());
    QTRY_VERIFY_WITH_TIMEOUT(certificate->isEnabled(), patience);
    editor<QDoubleSpinBox>("cameraArea", "eye.2")->setValue(0);  // the look-at: no camera
    QVERIFY(!certificate->text().isEmpty());
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestDockDrawings>(argc, argv);
}
#include "test_dock_drawings.moc"
