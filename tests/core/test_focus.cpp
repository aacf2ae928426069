// SPDX-License-Identifier: BSD-3-Clause
// The focus at which a pixel is sharp, and focus stacks, against the depths of scenes.
#include "core/engine/focus_search.h"

#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/cameras/focus_stack.h"
#include "tests/core/live_content.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

constexpr double distance = 0.5;

/// A display of fine hogels and many directions.
RenderJob fineJob() {
  RenderJob job;
  job.display.size = {0.1, 0.1};
  job.display.hogels = {200, 200};
  job.display.directions = {60, 60};
  job.display.fov = {30, 30};
  job.state.camera.eye = {0, 0, distance};
  job.state.camera.fov = 10;
  job.state.camera.res = {200, 200};
  job.state.pupil.diameter = 0.008;
  return job;
}

/// Content of squares of several sizes at a depth.
std::shared_ptr<LivePlanes> squaresAt(double z) {
  return std::make_shared<LivePlanes>(std::vector<LivePlane>{
      {z, [](double x, double y) {
         const auto cell = [](double at) { return int(std::floor(at / 0.0013)); };
         return ((cell(x) * 7 + cell(y) * 3) % 5 + 5) % 5 < 2 ? 220.0 : 30.0;
       }}});
}

/// A plane of two triangles, tilted about y, in front of a wall.
class Wedge : public LivePlanes {
 public:
  Wedge() : LivePlanes({{-0.1, [](double, double) { return 100.0; }}}) {}
  [[nodiscard]] plugin::Triangles triangles() const override {
    plugin::Triangles made;
    made.points = {-1, -1, -0.1F, 1, -1, -0.1F, 0, 2, -0.1F,  // the wall
                   0,  -1, 0,     1, -1, 0.1F,  0, 1, 0};     // z = x/10
    made.corners = {0, 1, 2, 3, 4, 5};
    return made;
  }
};

}  // namespace

class TestFocus : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void findsTheDepthByContrast_data();
  void findsTheDepthByContrast();
  void findsTheDepthOfTriangles();
  void nothingToFocusOn();
  void borderOfCells();
  void stacksCoverTheSharpDepths();
  void stacksAreCut();
  void stacksNeedAPupilInFront();
};

void TestFocus::findsTheDepthByContrast_data() {
  QTest::addColumn<double>("z");
  QTest::addColumn<bool>("isIdeal");
  QTest::newRow("scene on the panel") << 0.0 << true;
  QTest::newRow("scene in front") << 0.12 << true;
  QTest::newRow("scene behind") << -0.25 << true;
  QTest::newRow("display, on the panel") << 0.0 << false;
  QTest::newRow("display, in front") << 0.05 << false;
  QTest::newRow("display, behind") << -0.07 << false;
}

void TestFocus::findsTheDepthByContrast() {
  QFETCH(const double, z);
  QFETCH(const bool, isIdeal);
  RenderJob job = fineJob();
  job.lightField = liveSource(squaresAt(z), job.display);
  job.isIdeal = isIdeal;
  LensTables tables;
  const auto focus = sharpestFocus(job, 95, 105, tables, serialRows);
  QVERIFY(focus.has_value());
  // Within a step of the search, 1.5/D/24 dioptres.
  QVERIFY2(std::abs(1 / *focus - 1 / (distance - z)) < 1.5 / distance / 24,
           qPrintable(QString("%1, not %2").arg(*focus).arg(distance - z)));
}

void TestFocus::findsTheDepthOfTriangles() {
  RenderJob job = fineJob();
  job.lightField = liveSource(std::make_shared<Wedge>(), job.display);
  LensTables tables;
  const Camera camera(job.state.camera);
  for (const int x : {30, 99, 101, 150, 199}) {
    const auto focus = sharpestFocus(job, x, 100, tables, serialRows);
    QVERIFY(focus.has_value());
    const double slope = (x - camera.centre().x) / camera.focalLength().x;
    // The slope's plane z = x/10 and the ray's x = slope (D − z).
    const double depth = slope > 0 ? distance / (1 + slope / 10) : distance + 0.1;
    QVERIFY2(std::abs(*focus - depth) < 1e-6, qPrintable(QString("%1: %2").arg(x).arg(*focus)));
  }
}

void TestFocus::nothingToFocusOn() {
  RenderJob job = fineJob();
  LensTables tables;
  const auto grey = std::make_shared<LivePlanes>(
      std::vector<LivePlane>{{0, [](double, double) { return -1.0; }}});
  job.lightField = liveSource(grey, job.display);
  QVERIFY(!sharpestFocus(job, 100, 100, tables, serialRows).has_value());
  job.state.distortion.k1 = -3;  // folds before the corner
  job.state.camera.fov = 90;
  QVERIFY(!sharpestFocus(job, 0, 0, tables, serialRows).has_value());
}

/// Single pixels whose rays meet borders of cells, which points of the aperture find in float
/// arithmetic: what is traced for them has all cells that they read.
void TestFocus::borderOfCells() {
  RenderJob job;
  job.display.size = {0.2, 0.15};
  job.display.hogels = {64, 48};
  job.display.directions = {24, 24};
  CameraState& state = job.state;
  state.camera.eye = {0.004, 0, 0.6};
  state.camera.lookat = {0.004, 0, 0};
  state.camera.res = {1, 1};
  state.pupil = {0.004, 0, 60};
  const auto live = liveSource(squaresAt(-0.02), job.display);
  const auto whole = live->slice(readsOfRows(live->size(), {0, 47}, {0, 23}, {0, 23}), {});
  Renderer renderer;
  int compared = 0;
  for (int i = 1; i < 64; i += 2)
    for (int j = 1; j < 48; j += 2) {
      const double x = 0.2 * (i / 64.0 - 0.5);
      const double y = 0.15 * (0.5 - j / 48.0);
      constexpr double focal = 960000;
      state.intrinsics = {focal, focal, -(x - 0.004) / 0.6 * focal, y / 0.6 * focal};
      job.lightField = live;
      const FloatImage traced = renderer.renderFloat(job);
      job.lightField = whole;
      const FloatImage expected = renderer.renderFloat(job);
      QCOMPARE(traced.seen, expected.seen);
      QVERIFY(traced.rgb == expected.rgb);
      ++compared;
    }
  QCOMPARE(compared, 32 * 24);
}

void TestFocus::stacksCoverTheSharpDepths() {
  const RenderJob job = fineJob();
  const std::vector<double> focus = focusDistances(job.state, job.display, 5);
  const double step = 2 * std::tan(radians(15)) / 60;
  const double half = 0.0005 / (step * distance * distance);
  QCOMPARE(int(focus.size()), 5);
  for (int k = 0; k < 5; ++k)
    QVERIFY(std::abs(1 / focus[std::size_t(k)] - (1 / distance + half * (1 - k / 2.0))) < 1e-9);
  const std::vector<CameraState> states = focusStack(job.state, focus);
  QCOMPARE(states[1].camera.name, job.state.camera.name + ".focus02");
  QCOMPARE(states[1].pupil.focus, focus[1]);
}

void TestFocus::stacksAreCut() {
  RenderJob job = fineJob();
  job.display.directions = {400, 400};  // sharp to infinity, and near to the eye
  job.display.hogels = {20, 20};
  const std::vector<double> focus = focusDistances(job.state, job.display, 120);
  QVERIFY(focus.front() >= 0.1 && focus.back() == 10);
  QCOMPARE(focusStack(job.state, focus).front().camera.name, job.state.camera.name + ".focus001");
}

void TestFocus::stacksNeedAPupilInFront() {
  RenderJob job = fineJob();
  job.state.pupil = {};
  QVERIFY_EXCEPTION_THROWN((void)focusDistances(job.state, job.display, 3), InputError);
  job = fineJob();
  job.state.camera.eye.z = -1;
  QVERIFY_EXCEPTION_THROWN((void)focusDistances(job.state, job.display, 3), InputError);
}

QTEST_APPLESS_MAIN(TestFocus)
#include "test_focus.moc"
