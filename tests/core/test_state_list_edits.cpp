// SPDX-License-Identifier: BSD-3-Clause
// Tests adding, copying, moving, naming and removing camera states.
#include "core/cameras/state_list_edits.h"

#include <QTest>
#include <cmath>

#include "io/documents/edit_name.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

CameraState named(const char* name) {
  CameraState state;
  state.camera.name = name;
  return state;
}

Session abc() {
  Session session;
  session.cameras = {named("a"), named("b"), named("c")};
  return session;
}

QString namesOf(const Session& session) {
  QStringList names;
  for (const CameraState& state : session.cameras)
    names << QString::fromStdString(state.camera.name);
  return names.join("|");
}

}  // namespace

class TestStates : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void addingFindsAFreeName() {
    Session session = abc();
    QCOMPARE(addState(session, named("d")), std::size_t(3));
    addState(session, named("a"));
    addState(session, named("a"));
    addState(session, named("a 2"));
    QCOMPARE(namesOf(session), QString("a|b|c|d|a 2|a 3|a 2 2"));
  }

  /// Files whose names differ in case only are the same on many systems.
  void aFreeNameIsFreeInAnyCase() {
    Session session = abc();
    addState(session, named("B"));
    QCOMPARE(namesOf(session), QString("a|b|c|B 2"));
    QCOMPARE(errorOf([&] { renameState(session, 3, "A"); }),
             QString("name: \"A\" is another state's already"));
    renameState(session, 0, "A");
    QCOMPARE(namesOf(session), QString("A|b|c|B 2"));
  }

  void aCopyStandsBehindItsOriginal() {
    Session session = abc();
    session.cameras[1].psf.sigma = 3;
    QCOMPARE(duplicateState(session, 1), std::size_t(2));
    QCOMPARE(namesOf(session), QString("a|b|b 2|c"));
    QCOMPARE(session.cameras[2].psf.sigma, 3.0);
    duplicateState(session, 3);
    QCOMPARE(namesOf(session), QString("a|b|b 2|c|c 2"));
  }

  void moving_data() {
    QTest::addColumn<std::vector<std::size_t>>("indices");
    QTest::addColumn<int>("before");
    QTest::addColumn<QString>("names");
    using Indices = std::vector<std::size_t>;
    QTest::newRow("down") << Indices{0} << 2 << "b|a|c|d";
    QTest::newRow("to the end") << Indices{0} << 4 << "b|c|d|a";
    QTest::newRow("up") << Indices{2} << 0 << "c|a|b|d";
    QTest::newRow("above itself") << Indices{1} << 1 << "a|b|c|d";
    QTest::newRow("below itself") << Indices{1} << 2 << "a|b|c|d";
    QTest::newRow("two that are apart") << Indices{0, 3} << 2 << "b|a|d|c";
    QTest::newRow("two, in their own order") << Indices{3, 1} << 0 << "b|d|a|c";
    QTest::newRow("all") << Indices{0, 1, 2, 3} << 2 << "a|b|c|d";
    QTest::newRow("none") << Indices{} << 2 << "a|b|c|d";
  }

  void moving() {
    QFETCH(const std::vector<std::size_t>, indices);
    QFETCH(const int, before);
    Session session = abc();
    addState(session, named("d"));
    moveStates(session, indices, std::size_t(before));
    QTEST(namesOf(session), "names");
  }

  void movingByOnePlace() {
    Session session = abc();
    QCOMPARE(moveStateUp(session, 2), std::size_t(1));
    QCOMPARE(namesOf(session), QString("a|c|b"));
    QCOMPARE(moveStateDown(session, 0), std::size_t(1));
    QCOMPARE(namesOf(session), QString("c|a|b"));
    QCOMPARE(moveStateUp(session, 0), std::size_t(0));
    QCOMPARE(moveStateDown(session, 2), std::size_t(2));
    QCOMPARE(namesOf(session), QString("c|a|b"));
  }

  void removingLeavesOne() {
    Session session = abc();
    removeStates(session, {1});
    QCOMPARE(namesOf(session), QString("a|c"));
    QCOMPARE(errorOf([&] {
               removeStates(session, {1, 0});
             }),
             QString("cameras: would have no state left, and a session needs one"));
    QCOMPARE(namesOf(session), QString("a|c"));
    removeStates(session, {0, 0});
    QCOMPARE(namesOf(session), QString("c"));
  }

  void removing() {
    Session session = abc();
    session.cameras.push_back(named("d"));
    removeStates(session, {3, 0});
    QCOMPARE(namesOf(session), QString("b|c"));
  }

  /// The panel's corners are in the image, its middle in the image's middle, its top on top.
  void aNewStateSeesTheWholePanel() {
    PanelParams display;
    display.position = {3, -2, 5};
    display.orientation = {20, 140, -35};
    display.size = {0.4, 0.9};
    const CameraParams camera = inFrontOf(display).camera;
    const RigidTransform world = transformFromPose(display.position, display.orientation);
    const RigidTransform cameraFromWorld = Camera(camera).worldFromCamera().inverse();
    QVERIFY(length(camera.lookat - display.position) < 1e-12);
    const double half = std::tan(radians(camera.fov) / 2);
    for (const double x : {-0.2, 0.2})
      for (const double y : {-0.45, 0.45}) {
        const Vec3 corner = cameraFromWorld.point(world.point({x, y, 0}));
        QVERIFY(corner.z > 0);
        QVERIFY(std::abs(corner.x) < half * corner.z && std::abs(corner.y) < half * corner.z);
        QVERIFY((corner.x > 0) == (x > 0));
        QVERIFY((corner.y < 0) == (y > 0));  // +y is down
        QVERIFY(std::abs(corner.y) > 0.7 * half * corner.z);
      }
  }

  void anEditIsNamedAfterItsField() {
    const Session before = abc();
    Session after = before;
    QCOMPARE(changedField(before, after), std::string());
    after.sampling.tolerance = 1;
    QCOMPARE(changedField(before, after), std::string("tolerance"));
    after.lightField.layout = Layout::views;
    after.lightField.shear = {1, 0};
    QCOMPARE(changedField(before, after), std::string("layout"));
    after.display.size[1] = 1;
    QCOMPARE(changedField(before, after), std::string("size"));
    CameraState state = before.cameras[0];
    state.psf.sigma = 2;
    QCOMPARE(changedField(before.cameras[0], state), std::string("sigma"));
    Session views = before;
    views.lightField.layout = Layout::views;
    Session more = views;
    more.lightField.shear = {0, 1};
    QCOMPARE(changedField(views, more), std::string("shear"));
  }

  void renaming() {
    Session session = abc();
    renameState(session, 1, "b");
    renameState(session, 1, "new");
    QCOMPARE(namesOf(session), QString("a|new|c"));
    QCOMPARE(errorOf([&] { renameState(session, 1, "c"); }),
             QString("name: \"c\" is another state's already"));
    QVERIFY(errorOf([&] { renameState(session, 1, "d/e"); }).startsWith("cameras[1].name: "));
    QVERIFY(!errorOf([&] { renameState(session, 1, ""); }).isEmpty());
    QCOMPARE(namesOf(session), QString("a|new|c"));
  }

  void mergingKeepsAll() {
    Session session = abc();
    mergeStates(session, {named("b"), named("x"), named("b")});
    QCOMPARE(namesOf(session), QString("a|b|c|b 2|x|b 3"));
  }
};

QTEST_APPLESS_MAIN(TestStates)
#include "test_state_list_edits.moc"
