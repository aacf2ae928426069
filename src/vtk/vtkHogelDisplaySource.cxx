// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHogelDisplaySource.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkHogelDisplaySource);

namespace
{
/// Points of the panel's plane, x and y in -1/2 … 1/2 of its size.
class PanelPoints
{
public:
  explicit PanelPoints(const hogelscope::DisplayParams& display)
    : Size(display.size)
    , WorldFromDisplay(hogelscope::transformFromPose(display.position, display.orientation))
  {
  }
  vtkIdType Add(double x, double y)
  {
    const hogelscope::Vec3 p =
      this->WorldFromDisplay.point({ x * this->Size[0], y * this->Size[1], 0 });
    return this->Points->InsertNextPoint(p.x, p.y, p.z);
  }
  vtkPoints* Get() { return this->Points; }

private:
  std::array<double, 2> Size;
  hogelscope::RigidTransform WorldFromDisplay;
  vtkNew<vtkPoints> Points;
};

void fillPanel(const hogelscope::DisplayParams& display, vtkPolyData* output)
{
  PanelPoints points(display);
  vtkNew<vtkCellArray> quad;
  vtkNew<vtkFloatArray> texture;
  texture->SetNumberOfComponents(2);
  const float corners[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  quad->InsertNextCell(4);
  for (const auto& [s, t] : corners)
  {
    quad->InsertCellPoint(points.Add(s - 0.5, t - 0.5));
    texture->InsertNextTuple2(s, t);
  }
  output->SetPoints(points.Get());
  output->SetPolys(quad);
  output->GetPointData()->SetTCoords(texture);
}

/// The most lines per direction, at any distance of the eye.
constexpr int maximumLines = 2048;

int lineStep(int cells, double size, double spacing)
{
  int step = 1;
  while (step < cells && (cells / step > maximumLines || step * size / cells < spacing))
  {
    step *= 2;
  }
  return step;
}

void fillLenses(const hogelscope::DisplayParams& display, double spacing, vtkPolyData* output)
{
  PanelPoints points(display);
  vtkNew<vtkCellArray> lines;
  const hogelscope::LensSheet sheet(*display.sheet);
  // The way of a lens to the left along the panel's height, in parts of the width.
  const double tilt = display.size[1] / display.size[0] / sheet.calibration().params.slope;
  constexpr double sparse = 2;
  const int step = lineStep(int(sheet.lenses()), display.size[0], sparse * spacing);
  const double apart = step / sheet.lenses();
  const int reach = int((1 + std::abs(tilt)) / 2 / apart);
  for (int k = -reach; k <= reach; ++k)
  {
    const double x = k * apart; // at half the height
    const auto [low, high] = std::minmax({ (x - 0.5) / tilt, (x + 0.5) / tilt });
    const double from = std::max(low, -0.5);
    const double to = std::min(high, 0.5);
    lines->InsertNextCell(2);
    lines->InsertCellPoint(points.Add(x - from * tilt, from));
    lines->InsertCellPoint(points.Add(x - to * tilt, to));
  }
  output->SetPoints(points.Get());
  output->SetLines(lines);
}

void fillGrid(const hogelscope::DisplayParams& display, double spacing, vtkPolyData* output)
{
  PanelPoints points(display);
  vtkNew<vtkCellArray> lines;
  const auto add = [&](double x0, double y0, double x1, double y1)
  {
    lines->InsertNextCell(2);
    lines->InsertCellPoint(points.Add(x0, y0));
    lines->InsertCellPoint(points.Add(x1, y1));
  };
  const auto [nx, ny] = display.hogels;
  // Always includes the panel's own edge.
  const int stepX = lineStep(nx, display.size[0], spacing);
  for (int i = 0; i < nx + stepX; i += stepX)
  {
    const double x = double(std::min(i, nx)) / nx - 0.5;
    add(x, -0.5, x, 0.5);
  }
  const int stepY = lineStep(ny, display.size[1], spacing);
  for (int j = 0; j < ny + stepY; j += stepY)
  {
    const double y = 0.5 - double(std::min(j, ny)) / ny;
    add(-0.5, y, 0.5, y);
  }
  output->SetPoints(points.Get());
  output->SetLines(lines);
}
}

vtkHogelDisplaySource::vtkHogelDisplaySource()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

void vtkHogelDisplaySource::SetDisplay(const hogelscope::DisplayParams& display)
{
  if (this->Display == display)
  {
    return;
  }
  this->Display = display;
  this->Modified();
}

int vtkHogelDisplaySource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (this->Display.hogels[0] < 1 || this->Display.hogels[1] < 1)
  {
    return 1; // no display yet: empty outputs
  }
  fillPanel(this->Display, vtkPolyData::GetData(outputVector, 0));
  const auto fill = this->Display.sheet ? fillLenses : fillGrid;
  fill(this->Display, this->Spacing, vtkPolyData::GetData(outputVector, 1));
  return 1;
}

void vtkHogelDisplaySource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Hogels: " << this->Display.hogels[0] << " " << this->Display.hogels[1] << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
}
