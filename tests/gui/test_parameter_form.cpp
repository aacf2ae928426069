// SPDX-License-Identifier: BSD-3-Clause
// A form shows the parameters it is made from, and takes over exactly what a user changed.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSlider>
#include <QtTest>

#include "core/optics/session.h"
#include "gui/widgets/parameter_form.h"

using namespace hogelscope;

class TestParameterForm : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void hasARowForEachField() {
    CameraState state;
    const ParameterForm form([&](ParameterVisitor& v) { describe(v, state.psf); });
    for (const char* name :
         {"sigma", "sigma.slider", "windowSize", "windowSize.slider", "border", "light"})
      QVERIFY2(form.findChild<QWidget*>(name) != nullptr, name);
    QVERIFY(!form.findChild<QWidget*>("sigma")->parentWidget()->toolTip().isEmpty());
    QCOMPARE(form.findChild<QDoubleSpinBox*>("sigma")->suffix(), QString(" px"));
  }

  void sliderMovesTheValue() {
    CameraState state;
    const ParameterForm form([&](ParameterVisitor& v) { describe(v, state.psf); });
    form.findChild<QSlider*>("sigma.slider")->setValue(150);
    QCOMPARE(state.psf.sigma, 1.5);
    form.findChild<QSlider*>("windowSize.slider")->setValue(3);
    QCOMPARE(state.psf.windowSize, 7);
    QCOMPARE(form.findChild<QSpinBox*>("windowSize")->value(), 7);
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

  void refreshShowsChanges() {
    CameraState state;
    ParameterForm form([&](ParameterVisitor& v) { describe(v, state.psf); });
    state.psf.sigma = 2.5;
    form.refresh();
    QCOMPARE(form.findChild<QDoubleSpinBox*>("sigma")->value(), 2.5);
    QCOMPARE(form.findChild<QSlider*>("sigma.slider")->value(), 250);
  }
};

QTEST_MAIN(TestParameterForm)
#include "test_parameter_form.moc"
