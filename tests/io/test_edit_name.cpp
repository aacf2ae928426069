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

  /// Of all sections: each field of a session has its name in the Edit menu.
  void sectionsOfASession() {
    const auto changed = [](const std::function<void(Session&)>& change) {
      Session after;
      change(after);
      return changedField(Session{}, after);
    };
    QCOMPARE(changed([](Session& s) { s.display.size[0] = 1; }), std::string("size"));
    QCOMPARE(changed([](Session& s) { s.display.sheet.emplace(); }), std::string("kind"));
    QCOMPARE(changed([](Session& s) { s.twin.dead.rows = {3}; }), std::string("rows"));
    QCOMPARE(changed([](Session& s) { s.twin.random.gain.sigma = 1; }), std::string("sigma"));
    QCOMPARE(changed([](Session& s) { s.twin.maps.kernelTiles = 3; }), std::string("kernelTiles"));
    QCOMPARE(changed([](Session& s) { s.lightField.file = "a.png"; }), std::string("file"));
    Session before;
    before.display.sheet.emplace();
    Session after = before;
    after.display.sheet->calibration.params.cone = 40;
    QCOMPARE(changedField(before, after), std::string("cone"));
    after = before;
    after.display.sheet->file = "visual.json";
    QCOMPARE(changedField(before, after), std::string("calibration"));
    after = before;
    after.lightField.calibration.emplace().params.slope = 3;
    QCOMPARE(changedField(before, after), std::string("slope"));
    QCOMPARE(changed([](Session& s) { s.depth.comfort = 0.1; }), std::string("comfort"));
    QCOMPARE(changed([](Session& s) { s.metrics = {"flip"}; }), std::string("metrics"));
    QCOMPARE(changed([](Session& s) {
               s.twinFile = "unit.json";
               s.twin.lensArray.gapError = 0.1;
             }),
             std::string("gapError"));
    QCOMPARE(changed([](Session& s) { s.twinFile = "unit.json"; }), std::string("twin"));
  }

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
