// SPDX-License-Identifier: BSD-3-Clause
// Tests vectors and rigid transforms, the latter against VTK's.
#include <vtkAssembly.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkTransform.h>

#include <QTest>
#include <cmath>

#include "core/base/geometry.h"
#include "core/optics/scene_eyes.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

double distance(const Vec3& a, const Vec3& b) {
  return length(a - b);
}

Vec3 randomVector(Random& random, double limit) {
  return {random.uniform(-limit, limit), random.uniform(-limit, limit),
          random.uniform(-limit, limit)};
}

/// The largest difference between a transform and the 3×4 part of a matrix.
double difference(const RigidTransform& t, vtkMatrix4x4* matrix) {
  const auto column = [&](int c) {
    return Vec3{matrix->GetElement(0, c), matrix->GetElement(1, c), matrix->GetElement(2, c)};
  };
  return std::max({distance(t.xAxis, column(0)), distance(t.yAxis, column(1)),
                   distance(t.zAxis, column(2)), distance(t.origin, column(3))});
}

}  // namespace

class TestGeometry : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void products();
  void angles();
  void normaliseGivesLengthOne_data();
  void normaliseGivesLengthOne();
  void normaliseLeavesZero();
  void poseByHand_data();
  void poseByHand();
  void poseIsVtkTransforms();
  void poseIsVtkProps();
  void inverseTakesBack();
  void nearestOfALine();
};

void TestGeometry::products() {
  QCOMPARE(dot({1, 2, 3}, {4, -5, 6}), 12.0);
  QVERIFY(cross({1, 2, 3}, {4, -5, 6}) == (Vec3{27, 6, -13}));
  QVERIFY(cross({1, 0, 0}, {0, 1, 0}) == (Vec3{0, 0, 1}));
  QVERIFY((Vec3{1, 2, 3}) + (Vec3{10, 20, 30}) == (Vec3{11, 22, 33}));
  QVERIFY((Vec3{1, 2, 3}) - (Vec3{10, 20, 30}) == (Vec3{-9, -18, -27}));
  QVERIFY((-2.0 * Vec3{1, 2, 3} == Vec3{-2, -4, -6}));
  QCOMPARE(length({2, 3, -6}), 7.0);
}

void TestGeometry::angles() {
  QCOMPARE(radians(180), std::acos(-1.0));
  QCOMPARE(radians(-90), -std::acos(0.0));
}

void TestGeometry::normaliseGivesLengthOne_data() {
  QTest::addColumn<double>("scale");
  QTest::newRow("ordinary") << 1.0;
  QTest::newRow("square overflows") << 1e200;
  QTest::newRow("nearly the largest") << 2e307;
  QTest::newRow("square vanishes") << 1e-200;
  QTest::newRow("nearly denormal") << 1e-307;
}

void TestGeometry::normaliseGivesLengthOne() {
  QFETCH(const double, scale);
  const Vec3 unit = normalise({2 * scale, -3 * scale, 6 * scale});
  QVERIFY(distance(unit, {2.0 / 7, -3.0 / 7, 6.0 / 7}) < 1e-15);
}

void TestGeometry::normaliseLeavesZero() {
  QVERIFY(normalise({0, 0, 0}) == Vec3{});
}

void TestGeometry::poseByHand_data() {
  QTest::addColumn<QList<double>>("orientation");
  QTest::addColumn<QList<double>>("xAxis");
  QTest::addColumn<QList<double>>("zAxis");
  using List = QList<double>;
  QTest::newRow("none") << List{0, 0, 0} << List{1, 0, 0} << List{0, 0, 1};
  QTest::newRow("about x") << List{90, 0, 0} << List{1, 0, 0} << List{0, -1, 0};
  QTest::newRow("about y") << List{0, 90, 0} << List{0, 0, -1} << List{1, 0, 0};
  QTest::newRow("about z") << List{0, 0, 90} << List{0, 1, 0} << List{0, 0, 1};
  QTest::newRow("y before x") << List{90, 90, 0} << List{0, 1, 0} << List{1, 0, 0};
  QTest::newRow("x before z") << List{90, 0, 90} << List{0, 1, 0} << List{1, 0, 0};
  QTest::newRow("y before z") << List{0, 90, 90} << List{0, 0, -1} << List{0, 1, 0};
}

void TestGeometry::poseByHand() {
  QFETCH(const QList<double>, orientation);
  QFETCH(const QList<double>, xAxis);
  QFETCH(const QList<double>, zAxis);
  const RigidTransform pose =
      transformFromPose({1, 2, 3}, {orientation[0], orientation[1], orientation[2]});
  QVERIFY(distance(pose.xAxis, {xAxis[0], xAxis[1], xAxis[2]}) < 1e-15);
  QVERIFY(distance(pose.zAxis, {zAxis[0], zAxis[1], zAxis[2]}) < 1e-15);
  QVERIFY(distance(pose.yAxis, cross(pose.zAxis, pose.xAxis)) < 1e-15);
  QVERIFY(pose.point({0, 0, 0}) == (Vec3{1, 2, 3}));
}

void TestGeometry::poseIsVtkTransforms() {
  Random random(1);
  for (int repeat = 0; repeat < 1000; ++repeat) {
    const Vec3 position = randomVector(random, 10);
    const Vec3 orientation = randomVector(random, 360);
    vtkNew<vtkTransform> expected;
    expected->Translate(position.x, position.y, position.z);
    expected->RotateZ(orientation.z);
    expected->RotateX(orientation.x);
    expected->RotateY(orientation.y);
    QVERIFY(difference(transformFromPose(position, orientation), expected->GetMatrix()) < 1e-13);
  }
}

void TestGeometry::poseIsVtkProps() {
  Random random(2);
  // vtkActor is abstract without a rendering backend; both take their pose from vtkProp3D.
  vtkNew<vtkAssembly> prop;
  for (int repeat = 0; repeat < 1000; ++repeat) {
    const Vec3 position = randomVector(random, 10);
    const Vec3 orientation = randomVector(random, 360);
    prop->SetPosition(position.x, position.y, position.z);
    prop->SetOrientation(orientation.x, orientation.y, orientation.z);
    vtkNew<vtkMatrix4x4> expected;
    prop->GetMatrix(expected);
    // SetOrientation stores angles that it finds again from the matrix: noisy near gimbal lock.
    QVERIFY(difference(transformFromPose(position, orientation), expected) < 1e-9);
  }
}

void TestGeometry::inverseTakesBack() {
  Random random(3);
  for (int repeat = 0; repeat < 1000; ++repeat) {
    const RigidTransform there =
        transformFromPose(randomVector(random, 10), randomVector(random, 360));
    const RigidTransform back = there.inverse();
    const Vec3 p = randomVector(random, 10);
    QVERIFY(distance(back.point(there.point(p)), p) < 1e-13);
    QVERIFY(distance(there.point(back.point(p)), p) < 1e-13);
    QVERIFY(distance(back.direction(there.direction(p)), p) < 1e-13);
    QVERIFY(distance(there.point(p) - there.point({0, 0, 0}), there.direction(p)) < 1e-13);
  }
}

/// Two lines whose nearest points are known: they are one normal apart.
void TestGeometry::nearestOfALine() {
  Random random(7);
  for (int k = 0; k < 200; ++k) {
    const Vec3 origin = randomVector(random, 3);
    const Vec3 direction = randomVector(random, 2);
    const Vec3 along = randomVector(random, 2);
    const double s = random.uniform(-4, 4);
    const Vec3 other = origin + s * direction + random.uniform(-2, 2) * cross(direction, along) +
                       random.uniform(-2, 2) * along;
    QVERIFY(std::abs(nearestOnLine(origin, direction, other, along) - s) < 1e-6);
  }
  QCOMPARE(nearestOnLine({1, 2, 3}, {1, 1, 0}, {4, 5, 6}, {2, 2, 0}), 0.0);
}

QTEST_APPLESS_MAIN(TestGeometry)
#include "test_geometry.moc"
