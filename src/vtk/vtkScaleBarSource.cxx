// SPDX-License-Identifier: BSD-3-Clause
#include "vtkScaleBarSource.h"

#include <vtkCellArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>

#include "core/base/axis.h"

vtkStandardNewMacro(vtkScaleBarSource);

vtkScaleBarSource::vtkScaleBarSource()
{
  this->SetNumberOfInputPorts(0);
}

void vtkScaleBarSource::SetDisplay(const hogelscope::DisplayParams& display)
{
  if (this->Display == display)
  {
    return;
  }
  this->Display = display;
  this->Modified();
}

double vtkScaleBarSource::GetLength() const
{
  return hogelscope::roundedDown(this->Display.size[0] / 2);
}

hogelscope::Vec3 vtkScaleBarSource::At(double along, double down) const
{
  const auto& [width, height] = this->Display.size;
  return hogelscope::transformFromPose(this->Display.position, this->Display.orientation)
    .point({ along - width / 2, -height / 2 - down * std::max(width, height), 0 });
}

hogelscope::Vec3 vtkScaleBarSource::GetLabelPosition() const
{
  return this->At(this->GetLength() / 2, 0.07);
}

int vtkScaleBarSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkNew<vtkPoints> points;
  const auto add = [&](double along, double down)
  {
    const hogelscope::Vec3 p = this->At(along, down);
    points->InsertNextPoint(p.x, p.y, p.z);
  };
  const double length = this->GetLength();
  add(0, 0.04);
  add(length, 0.04);
  add(0, 0.03);
  add(0, 0.05);
  add(length, 0.03);
  add(length, 0.05);
  vtkNew<vtkCellArray> lines;
  for (vtkIdType k = 0; k < 6; k += 2)
  {
    const vtkIdType line[2] = { k, k + 1 };
    lines->InsertNextCell(2, line);
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->SetPoints(points);
  output->SetLines(lines);
  return 1;
}

void vtkScaleBarSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Length: " << this->GetLength() << "\n";
}
