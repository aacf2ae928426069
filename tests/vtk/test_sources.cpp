// SPDX-License-Identifier: BSD-3-Clause
// The panel and the frusta stand where the simulation has them.
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <QtTest>

#include "core/display.h"
#include "vtk/vtkCameraFrustumSource.h"
#include "vtk/vtkHogelDisplaySource.h"

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
    DisplayParams display;
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
    DisplayParams display;
    display.hogels = {512, 3};
    const vtkNew<vtkHogelDisplaySource> source;
    source->SetDisplay(display);
    source->SetMaximumLines(64);
    source->Update();
    QCOMPARE(source->GetOutput(1)->GetNumberOfLines(), vtkIdType(512 / 16 + 1 + 4));
  }

  void withoutHogelsIsEmpty() {
    const vtkNew<vtkHogelDisplaySource> source;
    source->Update();
    QCOMPARE(source->GetOutput(0)->GetNumberOfPoints(), vtkIdType(0));
  }

  void frustumHasTheFieldOfView() {
    CameraParams camera;
    camera.eye = {0, 0, 2};
    camera.fov = 90;
    camera.res = {200, 100};
    const vtkNew<vtkCameraFrustumSource> source;
    source->SetCamera(camera);
    source->SetDistance(0.5);
    source->Update();
    vtkPolyData* lines = source->GetOutput();
    QVERIFY(isNear(point(lines, 0), {0, 0, 2}));
    QVERIFY(isNear(point(lines, 1), {-1, 0.5, 1.5}));  // upper left of the picture
    QVERIFY(isNear(point(lines, 3), {1, -0.5, 1.5}));
    QCOMPARE(lines->GetNumberOfLines(), vtkIdType(10));
  }
};

QTEST_APPLESS_MAIN(TestSources)
#include "test_sources.moc"
