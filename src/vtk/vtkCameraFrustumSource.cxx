// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCameraFrustumSource.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include "atlas.h"

vtkStandardNewMacro(vtkCameraFrustumSource);

namespace
{
using hogelscope::CameraFrustum;
using hogelscope::Vec3;

/// The eye, the image's corners clockwise from the upper left, and the tip above its upper edge.
using Corners = std::array<Vec3, 6>;

Corners cornersOf(const CameraFrustum& frustum)
{
  const hogelscope::Camera camera(frustum.Camera, frustum.Intrinsics);
  const double distance =
    frustum.Length * hogelscope::length(frustum.Camera.lookat - frustum.Camera.eye);
  const auto [width, height] = frustum.Camera.res;
  const auto at = [&](double px, double py)
  {
    const hogelscope::Vec2 p = camera.normalised(px, py);
    return camera.worldFromCamera().point({ distance * p.x, distance * p.y, distance });
  };
  return { frustum.Camera.eye, at(-0.5, -0.5), at(width - 0.5, -0.5), at(width - 0.5, height - 0.5),
    at(-0.5, height - 0.5), at((width - 1) / 2.0, -0.5 - 0.2 * height) };
}

/// Lines with a state's number and colour.
class Lines
{
public:
  Lines()
  {
    this->States->SetName("State");
    this->Colours->SetName("Colour");
    this->Colours->SetNumberOfComponents(3);
  }
  void Add(const CameraFrustum& frustum)
  {
    constexpr int edges[10][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 0, 4 }, { 1, 2 }, { 2, 3 },
      { 3, 4 }, { 4, 1 }, { 1, 5 }, { 5, 2 } };
    const Corners corners = cornersOf(frustum);
    for (const auto& [a, b] : edges)
    {
      this->AddEdge(frustum, corners[std::size_t(a)], corners[std::size_t(b)]);
    }
  }
  void Into(vtkPolyData* output)
  {
    output->SetPoints(this->Points);
    output->SetLines(this->Cells);
    output->GetCellData()->SetScalars(this->Colours);
    output->GetCellData()->AddArray(this->States);
  }

private:
  /// Adds a line. Dashed lines have a fixed number of dashes, so that they look the same at any
  /// distance.
  void AddEdge(const CameraFrustum& frustum, const Vec3& from, const Vec3& to)
  {
    const int parts = frustum.IsDashed ? 15 : 1;
    for (int k = 0; k < parts; k += 2)
    {
      this->Cells->InsertNextCell(2);
      for (const int end : { k, k + 1 })
      {
        const Vec3 p = from + (double(end) / parts) * (to - from);
        this->Cells->InsertCellPoint(this->Points->InsertNextPoint(p.x, p.y, p.z));
      }
      this->States->InsertNextValue(frustum.State);
      this->Colours->InsertNextTypedTuple(frustum.Colour.data());
    }
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkIntArray> States;
  vtkNew<vtkUnsignedCharArray> Colours;
};

/// Near planes with a place in the atlas.
class Pictures
{
public:
  explicit Pictures(int atlasColumns)
    : Tiles{ atlasColumns }
  {
    this->States->SetName("State");
    this->Texture->SetNumberOfComponents(2);
  }
  void Add(const CameraFrustum& frustum)
  {
    const Corners corners = cornersOf(frustum);
    const double columns = this->Tiles.Columns;
    const int sides[4][2] = { { 0, 1 }, { 1, 1 }, { 1, 0 }, { 0, 0 } }; // right, up
    this->Cells->InsertNextCell(4);
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Vec3& p = corners[k + 1];
      this->Cells->InsertCellPoint(this->Points->InsertNextPoint(p.x, p.y, p.z));
      this->Texture->InsertNextTuple2((this->Tiles.Column(frustum.State) + sides[k][0]) / columns,
        (this->Tiles.Row(frustum.State) + sides[k][1]) / columns);
    }
    this->States->InsertNextValue(frustum.State);
  }
  void Into(vtkPolyData* output)
  {
    output->SetPoints(this->Points);
    output->SetPolys(this->Cells);
    output->GetPointData()->SetTCoords(this->Texture);
    output->GetCellData()->AddArray(this->States);
  }

private:
  hogelscope::Atlas Tiles;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkIntArray> States;
  vtkNew<vtkFloatArray> Texture;
};
}

vtkCameraFrustumSource::vtkCameraFrustumSource()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

void vtkCameraFrustumSource::SetFrusta(const std::vector<CameraFrustum>& frusta)
{
  if (this->Frusta == frusta)
  {
    return;
  }
  this->Frusta = frusta;
  this->Modified();
}

int vtkCameraFrustumSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  Lines lines;
  Pictures pictures(this->AtlasColumns);
  for (const CameraFrustum& frustum : this->Frusta)
  {
    if (hasFrame(frustum.Camera))
    {
      lines.Add(frustum);
      pictures.Add(frustum);
    }
  }
  lines.Into(vtkPolyData::GetData(outputVector, 0));
  pictures.Into(vtkPolyData::GetData(outputVector, 1));
  return 1;
}

void vtkCameraFrustumSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Frusta: " << this->Frusta.size() << "\n";
  os << indent << "AtlasColumns: " << this->AtlasColumns << "\n";
}
