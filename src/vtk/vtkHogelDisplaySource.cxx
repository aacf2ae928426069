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
  fillGrid(this->Display, this->Spacing, vtkPolyData::GetData(outputVector, 1));
  return 1;
}

void vtkHogelDisplaySource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Hogels: " << this->Display.hogels[0] << " " << this->Display.hogels[1] << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
}
