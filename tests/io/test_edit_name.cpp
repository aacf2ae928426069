// SPDX-License-Identifier: BSD-3-Clause
// Tests the name of the field that an edit changes.
#include "io/documents/edit_name.h"

#include <QTest>
#include <functional>

using namespace hogelscope;

class TestChangedField : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void eachKindOfField_data();
  void eachKindOfField();

  void nothingChanged() { QCOMPARE(changedField(CameraState{}, CameraState{}), std::string()); }

  void theFirstOfSeveral() {
    CameraState after;
    after.psf.sigma = 2;
    after.distortion.p1 = 0.1;
    after.camera.fov = 50;
    QCOMPARE(changedField({}, after), std::string("fov"));
    after.camera.fov = CameraState{}.camera.fov;
    QCOMPARE(changedField({}, after), std::string("p1"));
  }
};

using Change = std::function<void(CameraState&)>;
Q_DECLARE_METATYPE(Change)

void TestChangedField::eachKindOfField_data() {
  QTest::addColumn<Change>("change");
  const auto row = [](const char* field, const Change& change) { QTest::newRow(field) << change; };
  row("name", [](CameraState& s) { s.camera.name = "b"; });
  row("eye", [](CameraState& s) { s.camera.eye.z += 1; });
  row("lookat", [](CameraState& s) { s.camera.lookat.y += 1e-12; });
  row("res", [](CameraState& s) { s.camera.res[1] += 1; });
  row("weight", [](CameraState& s) { s.camera.weight = 2; });
  row("fx", [](CameraState& s) { s.intrinsics.fx = 500; });
  row("k3", [](CameraState& s) { s.distortion.k3 = 0.1; });
  row("sigma", [](CameraState& s) { s.psf.sigma = 1; });
  row("windowSize", [](CameraState& s) { s.psf.windowSize = 3; });
  row("border", [](CameraState& s) { s.psf.border = PsfBorder::black; });
  row("light", [](CameraState& s) { s.psf.light = LightModel::linear; });
}

/// There and back.
void TestChangedField::eachKindOfField() {
  QFETCH(Change, change);
  CameraState after;
  change(after);
  QCOMPARE(changedField({}, after), std::string(QTest::currentDataTag()));
  QCOMPARE(changedField(after, {}), std::string(QTest::currentDataTag()));
}

QTEST_APPLESS_MAIN(TestChangedField)
#include "test_edit_name.moc"
