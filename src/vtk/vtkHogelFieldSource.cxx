// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHogelFieldSource.h"

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

vtkStandardNewMacro(vtkHogelFieldSource);

namespace
{
/// A hogel's field up to a distance.
class Field
{
public:
  Field(const hogelscope::PanelParams& params, int i, int j, double length)
    : Display(params)
    , Size(Display.size())
    , WorldFromDisplay(hogelscope::transformFromPose(params.position, params.orientation))
    , Middle(Display.position(i + 0.5, j + 0.5))
    , Length(length)
  {
  }

  void AddRays(vtkPolyData* output) const
  {
    constexpr int parts = 4; // rays at each side's quarters
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    const vtkIdType apex =
      Field::Insert(points, this->WorldFromDisplay.point({ this->Middle.x, this->Middle.y, 0 }));
    vtkIdType last = -1;
    for (int k = 0; k <= 4 * parts; ++k)
    {
      const auto [s, t] = this->OnBorder(double(k % (4 * parts)) / parts);
      const vtkIdType end = this->AtDirection(points, s, t);
      const vtkIdType ray[2] = { apex, end };
      lines->InsertNextCell(2, ray);
      const vtkIdType side[2] = { last, end };
      if (last >= 0)
      {
        lines->InsertNextCell(2, side);
      }
      last = end;
    }
    output->SetPoints(points);
    output->SetLines(lines);
  }

  hogelscope::Vec3 LowerMiddle() const { return this->ToWorld(0.5, 1); }

  /// Adds a mesh, because an equiangular lens' directions are not evenly spaced on a plane.
  void AddEnd(vtkPolyData* output) const
  {
    const int nx = std::min(this->Size.du, 32);
    const int ny = std::min(this->Size.dv, 32);
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> texture;
    texture->SetNumberOfComponents(2);
    vtkNew<vtkCellArray> quads;
    for (int y = 0; y <= ny; ++y)
    {
      for (int x = 0; x <= nx; ++x)
      {
        this->AtDirection(points, double(x) / nx, double(y) / ny);
        texture->InsertNextTuple2(double(x) / nx, 1 - double(y) / ny);
        if (x < nx && y < ny)
        {
          const vtkIdType at = vtkIdType(y) * (nx + 1) + x;
          const vtkIdType quad[4] = { at, at + 1, at + nx + 2, at + nx + 1 };
          quads->InsertNextCell(4, quad);
        }
      }
    }
    output->SetPoints(points);
    output->SetPolys(quads);
    output->GetPointData()->SetTCoords(texture);
  }

private:
  /// Returns a point of the border, 0 … 4 clockwise from the upper left, as fractions of u and v.
  static hogelscope::Vec2 OnBorder(double at)
  {
    const double along = at - std::floor(at);
    switch (static_cast<int>(at))
    {
      case 0:
        return { along, 0 };
      case 1:
        return { 1, along };
      case 2:
        return { 1 - along, 1 };
      default:
        return { 0, 1 - along };
    }
  }
  /// Returns a point of the field's end at fractions of u and v.
  hogelscope::Vec3 ToWorld(double s, double t) const
  {
    const auto [a, b] = this->Display.slopes(s * this->Size.du, t * this->Size.dv);
    const auto [turnX, turnY] = this->Display.turn(this->Middle);
    return this->WorldFromDisplay.point({ this->Middle.x + this->Length * (a - turnX),
      this->Middle.y + this->Length * (b - turnY), this->Length });
  }
  vtkIdType AtDirection(vtkPoints* points, double s, double t) const
  {
    return Field::Insert(points, this->ToWorld(s, t));
  }
  static vtkIdType Insert(vtkPoints* points, const hogelscope::Vec3& world)
  {
    return points->InsertNextPoint(world.x, world.y, world.z);
  }

  hogelscope::Display Display;
  hogelscope::LightFieldSize Size;
  hogelscope::RigidTransform WorldFromDisplay;
  hogelscope::Vec2 Middle;
  double Length;
};
}

vtkHogelFieldSource::vtkHogelFieldSource()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

void vtkHogelFieldSource::SetHogel(const hogelscope::PanelParams& display, int i, int j)
{
  if (this->Display == display && this->I == i && this->J == j)
  {
    return;
  }
  this->Display = display;
  this->I = i;
  this->J = j;
  this->Modified();
}

double vtkHogelFieldSource::GetLength() const
{
  const double size = std::max(this->Display.size[0], this->Display.size[1]);
  const double fov = std::max(this->Display.fov[0], this->Display.fov[1]);
  return size * std::min(1.0, 0.125 / std::tan(hogelscope::radians(fov) / 2));
}

hogelscope::Vec3 vtkHogelFieldSource::GetLabelPosition() const
{
  return Field(this->Display, this->I, this->J, this->GetLength()).LowerMiddle();
}

int vtkHogelFieldSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  if (this->Display.hogels[0] < 1 || this->Display.directions[0] < 1)
  {
    return 1; // no hogel yet: empty outputs
  }
  const Field field(this->Display, this->I, this->J, this->GetLength());
  field.AddRays(vtkPolyData::GetData(outputVector, 0));
  field.AddEnd(vtkPolyData::GetData(outputVector, 1));
  return 1;
}

void vtkHogelFieldSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Hogel: " << this->I << " " << this->J << "\n";
}
