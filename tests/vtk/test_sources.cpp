// SPDX-License-Identifier: BSD-3-Clause
// The panel and the frusta stand where the simulation has them.
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/panel/display.h"
#include "vtk/atlas.h"
#include "vtk/line_picker.h"
#include "vtk/vtkCameraFrustumSource.h"
#include "vtk/vtkHogelDisplaySource.h"
#include "vtk/vtkHogelFieldSource.h"

using namespace hogelscope;

namespace {

Vec3 point(vtkPolyData* data, vtkIdType id) {
  std::array<double, 3> p{};
  data->GetPoint(id, p.data());
  return {p[0], p[1], p[2]};
}

bool isNear(const Vec3& a, const Vec3& b) {
  return length(a - b) < 1e-6;
}

}  // namespace

class TestSources : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void panelStandsAtItsPose() {
    PanelParams display;
    display.position = {1, 2, 3};
    display.orientation = {0, 90, 0};  // its right is now the world's -z
    display.size = {0.4, 0.2};
    display.hogels = {8, 4};
    const vtkNew<vtkHogelDisplaySource> source;
    source->SetDisplay(display);
    source->Update();
    vtkPolyData* panel = source->GetOutput(0);
    QVERIFY(isNear(point(panel, 0), {1, 1.9, 3.2}));
    QVERIFY(isNear(point(panel, 2), {1, 2.1, 2.8}));
    QCOMPARE(source->GetOutput(1)->GetNumberOfLines(), vtkIdType(9 + 5));
  }

  void gridThinsOut() {
    PanelParams display;  // 0.5 m × 0.5 m
    display.hogels = {512, 3};
    const vtkNew<vtkHogelDisplaySource> source;
    source->SetDisplay(display);
    const auto lines = [&](double spacing) {
      source->SetSpacing(spacing);
      source->Update();
      return int(source->GetOutput(1)->GetNumberOfLines());
    };
    QCOMPARE(lines(0), 513 + 4);
    QCOMPARE(lines(0.5 / 512), 513 + 4);
    QCOMPARE(lines(0.006), 512 / 8 + 1 + 4);
    QCOMPARE(lines(10), 2 + 2);  // only the panel's edges are left
    display.hogels = {65536, 65536};
    source->SetDisplay(display);
    QVERIFY(lines(0) <= 2 * 2049);
  }

  /// Along each line of a lens sheet x + y/slope is the same; all end at the panel's edges.
  void linesFollowTheLenses() {
    PanelParams display;
    SheetDisplay& sheet = display.sheet.emplace();
    sheet.calibration.params = {
        .pitch = 5, .slope = -6, .center = 0.1, .dpi = 50, .panel = {180, 120}, .cone = 40};
    const LensSheet lenses(sheet);
    display.size = lenses.size();
    display.hogels = {180, 120};
    const vtkNew<vtkHogelDisplaySource> source;
    source->SetDisplay(display);
    source->Update();
    vtkPolyData* lines = source->GetOutput(1);
    QCOMPARE(lines->GetNumberOfLines(), vtkIdType(19));
    const auto [right, top] = std::pair(display.size[0] / 2, display.size[1] / 2);
    for (vtkIdType k = 0; k < lines->GetNumberOfLines(); ++k) {
      const double across = double(k - 9) * lenses.period();
      for (const Vec3& end : {point(lines, 2 * k), point(lines, 2 * k + 1)}) {
        QVERIFY(std::abs(end.x - end.y / 6 - across) < 1e-6);
        const double beyond = std::max(std::abs(end.x) - right, std::abs(end.y) - top);
        QVERIFY(std::abs(beyond) < 1e-6);
      }
    }
    source->SetSpacing(display.size[0] / 20);
    source->Update();
    QCOMPARE(source->GetOutput(1)->GetNumberOfLines(), vtkIdType(9));
  }

  void withoutHogelsIsEmpty() {
    const vtkNew<vtkHogelDisplaySource> source;
    source->Update();
    QCOMPARE(source->GetOutput(0)->GetNumberOfPoints(), vtkIdType(0));
  }

  void frustumHasTheFieldOfView() {
    const vtkNew<vtkCameraFrustumSource> source;
    source->SetFrusta({{wideCamera(), {}, 7, {1, 2, 3}, false}});
    source->Update();
    vtkPolyData* lines = source->GetOutput(0);
    QCOMPARE(lines->GetNumberOfLines(), vtkIdType(10));
    // Line 0 is from the eye to the picture's upper left, line 2 to its lower right; the near plane
    // is a quarter of 2 m away.
    QVERIFY(isNear(point(lines, 0), {0, 0, 2}));
    QVERIFY(isNear(point(lines, 1), {-1, 0.5, 1.5}));
    QVERIFY(isNear(point(lines, 5), {1, -0.5, 1.5}));
    for (vtkIdType cell = 0; cell < 10; ++cell) {
      QCOMPARE(lines->GetCellData()->GetArray("State")->GetTuple1(cell), 7.0);
      const double* colour = lines->GetCellData()->GetScalars()->GetTuple3(cell);
      QVERIFY(colour[0] == 1 && colour[1] == 2 && colour[2] == 3);
    }
  }

  void manyFrustaAreOnePolyData() {
    std::vector<CameraFrustum> frusta(300, {wideCamera(), {}});
    for (int k = 0; k < 300; ++k) frusta[std::size_t(k)].State = k;
    frusta[17].Camera.lookat = frusta[17].Camera.eye;  // no frame
    frusta[20].IsDashed = true;
    const vtkNew<vtkCameraFrustumSource> source;
    source->SetFrusta(frusta);
    source->SetAtlasColumns(Atlas::ForCount(300).Columns);
    source->Update();
    QCOMPARE(source->GetOutput(0)->GetNumberOfLines(), vtkIdType(298 * 10 + 10 * 8));
    QCOMPARE(source->GetOutput(1)->GetNumberOfPolys(), vtkIdType(299));
    const vtkMTimeType before = source->GetMTime();
    source->SetFrusta(frusta);
    QCOMPARE(source->GetMTime(), before);
  }

  void picturesLieOnTheNearPlane() {
    const Atlas atlas = Atlas::ForCount(5);
    QCOMPARE(atlas.Columns, 3);
    QCOMPARE(Atlas::ForCount(0).Columns, 1);
    const vtkNew<vtkCameraFrustumSource> source;
    source->SetFrusta({{wideCamera(), {}, 4}});  // the middle tile
    source->SetAtlasColumns(atlas.Columns);
    source->Update();
    vtkPolyData* pictures = source->GetOutput(1);
    const auto isAt = [&](vtkIdType id, const Vec3& p, double s, double t) {
      const double* texture = pictures->GetPointData()->GetTCoords()->GetTuple2(id);
      return isNear(point(pictures, id), p) && std::abs(texture[0] - s / 3) < 1e-6 &&
             std::abs(texture[1] - t / 3) < 1e-6;
    };
    QVERIFY(isAt(0, {-1, 0.5, 1.5}, 1, 2));
    QVERIFY(isAt(1, {1, 0.5, 1.5}, 2, 2));
    QVERIFY(isAt(2, {1, -0.5, 1.5}, 2, 1));
    QVERIFY(isAt(3, {-1, -0.5, 1.5}, 1, 1));
  }

  void hogelFieldIsWhereItsDirectionsGo() {
    for (const HogelLensModel lens : {HogelLensModel::rectilinear, HogelLensModel::equiangular}) {
      PanelParams display;
      display.position = {0.3, -0.2, 1};
      display.orientation = {20, 30, 40};
      display.size = {0.4, 0.2};
      display.hogels = {8, 4};
      display.directions = {7, 40};
      display.fov = {100, 40};
      display.lens = lens;
      const vtkNew<vtkHogelFieldSource> source;
      source->SetHogel(display, 2, 3);
      source->Update();
      QCOMPARE(source->GetOutput(0)->GetNumberOfLines(), vtkIdType(17 + 16));
      vtkPolyData* end = source->GetOutput(1);
      QCOMPARE(end->GetNumberOfPoints(), vtkIdType(8 * 33));
      // Seen from each point of the end the hogel shows the direction that its texture says.
      const Display core(display);
      for (vtkIdType id = 0; id < end->GetNumberOfPoints(); ++id) {
        const Vec3 eye = core.displayFromWorld().point(point(end, id));
        QVERIFY(std::abs(eye.z - source->GetLength()) < 1e-6);
        const Vec2 middle = core.position(2.5, 3.5);
        const auto place = core.intersectPlane(eye, Vec3{middle.x, middle.y, 0} - eye);
        const double* texture = end->GetPointData()->GetTCoords()->GetTuple2(id);
        QVERIFY(std::abs(place->u - 7 * texture[0]) < 1e-4);
        QVERIFY(std::abs(place->v - 40 * (1 - texture[1])) < 1e-4);
      }
      const Vec3 label = core.displayFromWorld().point(source->GetLabelPosition());
      const Vec2 from = core.position(2.5, 3.5);
      const auto below = core.intersectPlane(label, Vec3{from.x, from.y, 0} - label);
      QVERIFY(std::abs(below->u - 3.5) < 1e-9 && std::abs(below->v - 40) < 1e-9);
      QVERIFY(isNear(core.displayFromWorld().point(point(source->GetOutput(0), 0)),
                     {-0.2 + 2.5 * 0.05, 0.1 - 3.5 * 0.05, 0}));
    }
  }

  void linesArePickedOnTheScreen() {
    const vtkNew<vtkCameraFrustumSource> source;
    CameraParams other = wideCamera();
    other.res = {100, 100};  // the same eye and axis, a narrower picture
    source->SetFrusta({{wideCamera(), {}, 3}, {other, {}, 9}});
    source->Update();
    vtkPolyData* lines = source->GetOutput(0);
    const vtkNew<vtkMatrix4x4> clip;  // x and y as they are, w = z: seen from the origin along +z
    clip->SetElement(3, 2, 1);
    clip->SetElement(3, 3, 0);
    const auto at = [&](double x, double y) { return statesAt(lines, clip, {x, y, 4, 600, 600}); };
    // (-1, 0.5, 1.5) is drawn at (-2/3, 1/3): pixel (100, 400) of 600.
    QCOMPARE(at(100, 400), std::vector<int>{3});
    QCOMPARE(at(103, 398), std::vector<int>{3});
    QCOMPARE(at(95, 400), std::vector<int>{});
    QCOMPARE(at(200, 400), (std::vector<int>{3, 9}));
    QCOMPARE(at(300, 300), (std::vector<int>{3, 9}));  // the eye
    QCOMPARE(at(170, 300), std::vector<int>{});
    clip->SetElement(3, 2, -1);  // all of it is behind the eye
    QCOMPARE(at(300, 300), std::vector<int>{});
    clip->SetElement(3, 2, 1);
    clip->SetElement(3, 3, -1.75);  // the near plane is behind, the eye before
    QCOMPARE(at(300, 300), (std::vector<int>{3, 9}));
    QCOMPARE(at(100, 400), (std::vector<int>{3}));  // on its way there
    QCOMPARE(at(300, 450), std::vector<int>{});
  }

 private:
  /// 90° high, twice as wide, looks from (0, 0, 2) at the origin.
  static CameraParams wideCamera() {
    CameraParams camera;
    camera.eye = {0, 0, 2};
    camera.fov = 90;
    camera.res = {200, 100};
    return camera;
  }
};

QTEST_APPLESS_MAIN(TestSources)
#include "test_sources.moc"
