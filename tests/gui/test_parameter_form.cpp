// SPDX-License-Identifier: BSD-3-Clause
// A form shows the parameters it is made from, and takes over exactly what a user changed.
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>
#include <memory>

#include "core/cameras/camera_region.h"
#include "core/optics/session.h"
#include "gui/widgets/parameter_form.h"
#include "tests/gui/patience.h"
#include "tests/gui/scrub.h"

using namespace hogelscope;

namespace {

QLabel* labelOf(const ParameterForm& form, const char* name) {
  QWidget* row = form.findChild<QWidget*>(name);
  const auto* layout = form.findChild<QFormLayout*>();
  while (layout->labelForField(row) == nullptr) row = row->parentWidget();
  return qobject_cast<QLabel*>(layout->labelForField(row));
}

}  // namespace

class TestParameterForm : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void hasARowForEachField() {
    CameraState state;
    const ParameterForm form([&](ParameterVisitor& v) { describe(v, state.psf); });
    for (const char* name : {"sigma", "windowSize", "border", "light"})
      QVERIFY2(form.findChild<QWidget*>(name) != nullptr, name);
    QVERIFY(!form.findChild<QWidget*>("sigma")->parentWidget()->toolTip().isEmpty());
    QCOMPARE(form.findChild<QDoubleSpinBox*>("sigma")->accessibleName(), QString("Sigma px"));
  }

  void aDragScrubs() {
    CameraState state;
    state.psf = {0.5, 3};
    const ParameterForm form([&](ParameterVisitor& v) { describe(v, state.psf); });
    auto* sigma = form.findChild<QDoubleSpinBox*>("sigma");
    scrub(sigma, 20);  // 200 pixels are 0 … 3
    QCOMPARE(state.psf.sigma, 0.8);
    scrub(sigma, 20, Qt::ShiftModifier);
    QCOMPARE(state.psf.sigma, 0.83);
    scrub(sigma, 20, Qt::ControlModifier);
    QCOMPARE(state.psf.sigma, 3.83);
    scrub(sigma, 2);  // a click
    QCOMPARE(state.psf.sigma, 3.83);
    scrub(sigma, -300);
    QCOMPARE(state.psf.sigma, 0.0);
    auto* window = form.findChild<QSpinBox*>("windowSize");
    scrub(window, 20);  // 2.4 of 1 … 25, in steps of 2
    QCOMPARE(state.psf.windowSize, 5);
  }

  void theWheelScrolls() {
    CameraState state;
    ParameterForm form([&](ParameterVisitor& v) { describe(v, state.psf); });
    form.show();
    auto* box = form.findChild<QDoubleSpinBox*>("sigma");
    box->setFocus();
    const QPointF at = box->rect().center();
    QWheelEvent event(at, box->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(box, &event);
    QCOMPARE(state.psf.sigma, PsfParams{}.sigma);
  }

  /// In proportion, without a drift by rounded numbers.
  void aLinkedPair() {
    DisplayParams display;
    display.hogels = {30, 20};
    ParameterForm form([&](ParameterVisitor& v) { describe(v, display); });
    form.linkPair("hogels", true);
    auto* across = form.findChild<QSpinBox*>("hogels.0");
    for (const int count : {31, 32, 33, 60}) across->setValue(count);
    QCOMPARE(display.hogels[0], 60);
    QCOMPARE(display.hogels[1], 40);
    form.findChild<QSpinBox*>("hogels.1")->setValue(80);
    QCOMPARE(display.hogels[0], 120);
    form.findChild<QToolButton*>("hogels.link")->setChecked(false);
    across->setValue(7);
    QCOMPARE(display.hogels[1], 80);
  }

  /// Before the label of a value that is not the default; a click brings that back.
  void theDotResets() {
    PsfParams psf{1.5, 7};
    ParameterForm form([&](ParameterVisitor& v) { describe(v, psf); },
                       [](ParameterVisitor& v) {
                         PsfParams defaults;
                         describe(v, defaults);
                       });
    form.show();
    QWidget* label = labelOf(form, "windowSize");
    const auto isDotted = [label] {
      const QImage picture = label->grab().toImage();
      return picture.pixelColor(6, picture.height() / 2) == tokens().focus;
    };
    QVERIFY(isDotted());
    QVERIFY(label->toolTip().contains("1 … 99 px, default 1 px"));
    QTest::mouseClick(label, Qt::LeftButton, {}, {6, label->height() / 2});
    QCOMPARE(psf.windowSize, 1);
    QCOMPARE(psf.sigma, 1.5);
    QVERIFY(!isDotted());
  }

  void evenWindowBecomesOdd() {
    CameraState state;
    const ParameterForm form([&](ParameterVisitor& v) { describe(v, state.psf); });
    auto* box = form.findChild<QSpinBox*>("windowSize");
    box->setValue(6);
    QCOMPARE(state.psf.windowSize, 5);
    QCOMPARE(box->value(), 5);
  }

  void anEditLeavesTheOthersExact() {
    CameraState state;
    state.distortion.k1 = -0.26637260909660681234;
    const double k1 = state.distortion.k1;
    const ParameterForm form([&](ParameterVisitor& v) { describe(v, state.distortion); });
    form.findChild<QDoubleSpinBox*>("k2")->setValue(0.25);
    QCOMPARE(state.distortion.k2, 0.25);
    QVERIFY(state.distortion.k1 == k1);
  }

  void listsAndTexts() {
    CameraState state;
    const ParameterForm form([&](ParameterVisitor& v) { describe(v, state.camera); });
    form.findChild<QDoubleSpinBox*>("eye.2")->setValue(1.25);
    QVERIFY((state.camera.eye == Vec3{0, 0, 1.25}));
    auto* name = form.findChild<QLineEdit*>("name");
    name->setText("mine");
    QTest::keyClick(name, Qt::Key_Return);
    QCOMPARE(state.camera.name, std::string("mine"));
  }

  void choices() {
    CameraState state;
    const ParameterForm form([&](ParameterVisitor& v) { describe(v, state.psf); });
    form.findChild<QComboBox*>("light")->setCurrentText("linear");
    QVERIFY(state.psf.light == LightModel::linear);
  }

  void anEmptiedBoxIsNotGiven() {
    IntrinsicsParams intrinsics;
    const ParameterForm form([&](ParameterVisitor& v) { describe(v, intrinsics); });
    for (const char* name : {"fx", "cx"}) {
      auto* box = form.findChild<QDoubleSpinBox*>(name);
      QCOMPARE(box->text(), QString("not given"));
      box->selectAll();
      QTest::keyClicks(box, "320.5");
      QTest::keyClick(box, Qt::Key_Return);
    }
    QVERIFY((intrinsics == IntrinsicsParams{320.5, notGiven, 320.5, notGiven}));
    auto* fy = form.findChild<QDoubleSpinBox*>("fy");
    fy->setValue(0);  // below its range, which begins above 0
    QVERIFY(intrinsics.fy == notGiven);
    QCOMPARE(fy->text(), QString("not given"));
    auto* box = form.findChild<QDoubleSpinBox*>("cx");
    box->selectAll();
    QTest::keyClick(box, Qt::Key_Delete);
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(box->text(), QString("not given"));
    QVERIFY((intrinsics == IntrinsicsParams{320.5, notGiven, notGiven, notGiven}));
  }

  void labelsAreWords() {
    CameraState state;
    const ParameterForm camera([&](ParameterVisitor& v) { describe(v, state.camera); });
    const ParameterForm psf([&](ParameterVisitor& v) { describe(v, state.psf); });
    const ParameterForm lens([&](ParameterVisitor& v) { describe(v, state.distortion); });
    QCOMPARE(labelOf(camera, "lookat.0")->accessibleName(), QString("Look at"));
    QCOMPARE(labelOf(camera, "fov")->accessibleName(), QString("Field of view"));
    QCOMPARE(labelOf(camera, "weight")->accessibleName(), QString("Weight"));
    QCOMPARE(labelOf(psf, "windowSize")->accessibleName(), QString("Window size"));
    QCOMPARE(labelOf(lens, "k1")->accessibleName(), QString("k1"));
    const ParameterForm intrinsics([&](ParameterVisitor& v) { describe(v, state.intrinsics); });
    QCOMPARE(labelOf(intrinsics, "fx")->accessibleName(), QString("Focal length, x"));
    QCOMPARE(labelOf(intrinsics, "cy")->accessibleName(), QString("Centre, y"));
    QCOMPARE(psf.findChild<QLabel*>("heading")->text(), QString("PSF"));
    QVERIFY(psf.findChild<QComboBox*>("border")->toolTip().contains("psf.border"));
  }

  /// The line covers what people use.
  void theLineIsTheUsualRange() {
    CameraState state;
    ParameterForm form([&](ParameterVisitor& v) { describe(v, state.distortion); });
    form.show();
    auto* box = form.findChild<QDoubleSpinBox*>("p1");  // -0.2 … 0.2
    for (const auto& [value, share] :
         {std::pair(-0.1, 0.25), std::pair(0.1, 0.75), std::pair(0.7, 1.0), std::pair(-0.7, 0.0)}) {
      box->setValue(value);
      QCOMPARE(state.distortion.p1, value);
      QVERIFY2(std::abs(lineShare(box) - share) < 0.06, qPrintable(QString::number(value)));
    }
  }

  void fiveDigitsAreShown() {
    CameraState state;
    state.camera.eye = {0.123456789, -1234.56789, 1234567};
    const ParameterForm form([&](ParameterVisitor& v) { describe(v, state.camera); });
    const auto textOf = [&](const char* name) {
      return form.findChild<QDoubleSpinBox*>(name)->text();
    };
    QCOMPARE(textOf("eye.0"), QString("0.12346"));
    QCOMPARE(textOf("eye.1"), QLocale().toString(-1234.6, 'g', 5));
    QCOMPARE(textOf("eye.2"), QLocale().toString(1000000.0, 'g', 7));  // of its range
    form.findChild<QDoubleSpinBox*>("eye.1")->setValue(2);
    QCOMPARE(state.camera.eye.x, 0.123456789);
  }

  void onlyWhatCounts() {
    CameraRegionParams region;
    region.region = RegionShape::arc;
    const ParameterForm form([&](ParameterVisitor& v) { describe(v, region); });
    const auto isShown = [&](const char* name) {
      return form.findChild<QWidget*>(name)->isVisibleTo(&form);
    };
    QVERIFY(isShown("angle.0") && isShown("distance.1") && isShown("target.0"));
    QVERIFY(!isShown("centre.0") && !isShown("extent.2"));
    form.findChild<QComboBox*>("region")->setCurrentText("box");
    QVERIFY(!isShown("angle.0") && isShown("centre.0") && isShown("extent.2"));
    form.findChild<QComboBox*>("lookat")->setCurrentText("nearest");
    QVERIFY(!isShown("target.0") && !isShown("jitter"));
  }

  void rightClickOffersTheDefault() {
    CameraState state;
    state.psf = {1.5, 7};
    state.camera.up = {1, 0, 0};
    ParameterForm psf([&](ParameterVisitor& v) { describe(v, state.psf); },
                      [](ParameterVisitor& v) {
                        PsfParams defaults;
                        describe(v, defaults);
                      });
    ParameterForm camera([&](ParameterVisitor& v) { describe(v, state.camera); },
                         [](ParameterVisitor& v) {
                           CameraParams defaults;
                           describe(v, defaults);
                         });
    const auto choose = [](QWidget* on) {
      QContextMenuEvent event(QContextMenuEvent::Mouse, {2, 2}, on->mapToGlobal(QPoint(2, 2)));
      QCoreApplication::sendEvent(on, &event);
      auto* menu = on->findChild<QMenu*>();
      if (menu == nullptr) return QString("no menu");
      auto* action = menu->findChild<QAction*>("defaultAction");
      const QString text = action->text();
      action->trigger();
      delete menu;
      return text;
    };
    psf.show();
    camera.show();
    QCOMPARE(choose(psf.findChild<QSpinBox*>("windowSize")), QString("&Default: 1 px"));
    QCOMPARE(state.psf.windowSize, PsfParams{}.windowSize);
    QCOMPARE(state.psf.sigma, 1.5);
    QCOMPARE(choose(camera.findChild<QDoubleSpinBox*>("up.1")->findChild<QLineEdit*>()),
             QString("&Default: 0, 1, 0"));
    QVERIFY((state.camera.up == Vec3{0, 1, 0}));
  }

  void escapeTakesNothing() {
    CameraState state;
    ParameterForm form([&](ParameterVisitor& v) { describe(v, state.psf); });
    const QSignalSpy left(&form, &ParameterForm::escaped);
    auto* box = form.findChild<QDoubleSpinBox*>("sigma");
    const QString was = box->text();
    box->selectAll();
    QTest::keyClicks(box, "1.75");
    QTest::keyClick(box, Qt::Key_Escape);
    QCOMPARE(left.count(), 1);
    QCOMPARE(box->text(), was);
    QCOMPARE(state.psf.sigma, PsfParams{}.sigma);
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(left.count(), 1);
    QCOMPARE(state.psf.sigma, PsfParams{}.sigma);
  }

  /// Also of a text that was cleared or taken back, which the line edit does not call modified.
  void escapeAfterClearAndUndo() {
    CameraState state;
    ParameterForm form([&](ParameterVisitor& v) { describe(v, state.psf); });
    auto* box = form.findChild<QDoubleSpinBox*>("sigma");
    const auto leave = [box] {
      QFocusEvent out(QEvent::FocusOut);
      QCoreApplication::sendEvent(box, &out);
    };
    const QString was = box->text();
    box->clear();
    QTest::keyClick(box, Qt::Key_Escape);
    QCOMPARE(box->text(), was);
    box->selectAll();
    QTest::keyClicks(box, "1.75");
    leave();
    QCOMPARE(state.psf.sigma, 1.75);
    box->findChild<QLineEdit*>()->setText(was);  // as its undo does
    QTest::keyClick(box, Qt::Key_Escape);
    QCOMPARE(box->text(), QString("1.75"));
    leave();
    QCOMPARE(state.psf.sigma, 1.75);
  }

  /// A form that ends with a text that is being typed takes nothing from it.
  void endsWhileTyping() {
    CameraState state;
    auto form =
        std::make_unique<ParameterForm>([&](ParameterVisitor& v) { describe(v, state.psf); });
    form->show();
    QVERIFY(QTest::qWaitForWindowExposed(form.get()));
    activate(form.get());
    auto* box = form->findChild<QDoubleSpinBox*>("sigma");
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, "1.75");
    form.reset();
    QCOMPARE(state.psf.sigma, PsfParams{}.sigma);
  }

  void refreshShowsChanges() {
    CameraState state;
    ParameterForm form([&](ParameterVisitor& v) { describe(v, state.psf); });
    state.psf.sigma = 2.5;
    form.refresh();
    QCOMPARE(form.findChild<QDoubleSpinBox*>("sigma")->value(), 2.5);
  }
};

QTEST_MAIN(TestParameterForm)
#include "test_parameter_form.moc"
