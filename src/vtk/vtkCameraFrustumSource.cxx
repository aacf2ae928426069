// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCameraFrustumSource.h"

#include <vtkCellArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "core/error.h"

vtkStandardNewMacro(vtkCameraFrustumSource);

namespace
{
/// Eye, the picture's corners from the upper left clockwise, the tip over its upper edge.
vtkNew<vtkPoints> frustumPoints(const hogelscope::CameraParams& params,
  const hogelscope::IntrinsicsParams& intrinsics, double distance)
{
  const hogelscope::Camera camera(params, intrinsics);
  const auto [width, height] = params.res;
  vtkNew<vtkPoints> points;
  const auto add = [&](double px, double py, double depth)
  {
    const hogelscope::Vec2 p = camera.normalised(px, py);
    const hogelscope::Vec3 w = camera.worldFromCamera().point({ depth * p.x, depth * p.y, depth });
    points->InsertNextPoint(w.x, w.y, w.z);
  };
  add(0, 0, 0);
  add(-0.5, -0.5, distance);
  add(width - 0.5, -0.5, distance);
  add(width - 0.5, height - 0.5, distance);
  add(-0.5, height - 0.5, distance);
  add(camera.centre().x, -0.5 - 0.2 * height, distance);
  return points;
}
}

vtkCameraFrustumSource::vtkCameraFrustumSource()
{
  this->SetNumberOfInputPorts(0);
}

void vtkCameraFrustumSource::SetCamera(
  const hogelscope::CameraParams& camera, const hogelscope::IntrinsicsParams& intrinsics)
{
  if (this->Camera == camera && this->Intrinsics == intrinsics)
  {
    return;
  }
  this->Camera = camera;
  this->Intrinsics = intrinsics;
  this->Modified();
}

int vtkCameraFrustumSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    output->SetPoints(frustumPoints(this->Camera, this->Intrinsics, this->Distance));
  }
  catch (const hogelscope::InputError& error)
  {
    vtkErrorMacro(<< error.what());
    return 0;
  }
  const vtkIdType edges[10][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 0, 4 }, { 1, 2 }, { 2, 3 },
    { 3, 4 }, { 4, 1 }, { 1, 5 }, { 5, 2 } };
  vtkNew<vtkCellArray> lines;
  for (const auto& edge : edges)
  {
    lines->InsertNextCell(2, edge);
  }
  output->SetLines(lines);
  return 1;
}

void vtkCameraFrustumSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Camera: " << this->Camera.name << "\n";
  os << indent << "Distance: " << this->Distance << "\n";
}
