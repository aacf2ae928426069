// SPDX-License-Identifier: BSD-3-Clause
#include "scene_export.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkGLTFExporter.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <string>

#include "core/base/error.h"
#include "io/documents/gltf_cameras.h"
#include "io/files/atomic_file.h"
#include "vtkCameraFrustumSource.h"
#include "vtkHogelDisplaySource.h"

namespace hogelscope
{

namespace
{

/// Returns a complete glTF document; "" if VTK's export fails. Exports the parts as objects of a
/// window that is never shown. `panelImage`, unless null, replaces the panel's colour.
std::string gltfText(const std::vector<VtkMesh>& parts, const std::vector<CameraState>& states,
  vtkImageData* panelImage)
{
  const vtkNew<vtkRenderer> renderer;
  const std::array<std::string, 4> allNames{ "panel", "hogel grid", "frusta", "mesh" };
  std::vector<std::string> names;
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    if (parts[k]->GetNumberOfCells() == 0)
    {
      continue; // the exporter skips it too
    }
    names.push_back(allNames[k]);
    const vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(parts[k]);
    const vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    if (k == 0 && panelImage != nullptr)
    {
      mapper->ScalarVisibilityOff(); // a texture is multiplied by the colour
      const vtkNew<vtkTexture> texture;
      texture->SetInputData(panelImage);
      actor->SetTexture(texture);
    }
    renderer->AddActor(actor);
  }
  const vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetReadyForRendering(false);
  window->AddRenderer(renderer);
  renderer->ResetCamera();
  const vtkNew<vtkGLTFExporter> exporter;
  exporter->SetRenderWindow(window);
  exporter->InlineDataOn();
  const std::string text = exporter->WriteToString();
  return text.empty() ? text : withCameras(text, names, states);
}

using Colour = std::array<unsigned char, 3>;

constexpr Colour gridColour{ 128, 148, 179 };
constexpr Colour frustumColour{ 140, 191, 153 };
constexpr Colour meshColour{ 200, 200, 200 }; // for a mesh without colours

/// Returns a copy without arrays other than texture coordinates.
VtkMesh bare(vtkPolyData* source)
{
  auto part = VtkMesh::New();
  part->CopyStructure(source);
  part->GetPointData()->SetTCoords(source->GetPointData()->GetTCoords());
  return part;
}

void setColour(vtkPolyData& part, const Colour& rgb)
{
  const vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Colour");
  colours->SetNumberOfComponents(3);
  for (vtkIdType k = 0; k < part.GetNumberOfPoints(); ++k)
  {
    colours->InsertNextTypedTuple(rgb.data());
  }
  part.GetPointData()->SetScalars(colours);
}

std::array<VtkMesh, 2> panelAndGrid(const PanelParams& display)
{
  const vtkNew<vtkHogelDisplaySource> source;
  source->SetDisplay(display);
  source->Update();
  std::array<VtkMesh, 2> parts{ bare(source->GetOutput(0)), bare(source->GetOutput(1)) };
  setColour(*parts[0], panelColour);
  setColour(*parts[1], gridColour);
  return parts;
}

/// Returns the frusta with the cell array State.
VtkMesh frusta(const std::vector<CameraState>& states)
{
  std::vector<CameraFrustum> all;
  for (std::size_t k = 0; k < states.size(); ++k)
  {
    all.push_back({ states[k].camera, states[k].intrinsics, int(k) });
  }
  const vtkNew<vtkCameraFrustumSource> source;
  source->SetFrusta(all);
  source->Update();
  VtkMesh part = bare(source->GetOutput(0));
  part->GetCellData()->AddArray(source->GetOutput(0)->GetCellData()->GetArray("State"));
  setColour(*part, frustumColour);
  return part;
}

/// Returns the mesh in the world.
VtkMesh meshIn(const PanelParams& display, vtkPolyData* mesh)
{
  VtkMesh part = bare(mesh);
  const RigidTransform worldFromDisplay = transformFromPose(display.position, display.orientation);
  const vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
  {
    const double* p = mesh->GetPoint(k);
    const Vec3 at = worldFromDisplay.point({ p[0], p[1], p[2] });
    points->SetPoint(k, at.x, at.y, at.z);
  }
  part->SetPoints(points);
  if (vtkDataArray* colours = mesh->GetPointData()->GetScalars(); colours != nullptr)
  {
    const auto copy = vtkSmartPointer<vtkDataArray>::Take(colours->NewInstance());
    copy->DeepCopy(colours);
    copy->SetName("Colour");
    part->GetPointData()->SetScalars(copy);
  }
  else
  {
    setColour(*part, meshColour);
  }
  return part;
}

/// Returns panel, hogel grid, frusta and mesh.
std::vector<VtkMesh> partsOf(const SceneParts& scene)
{
  const auto [panel, grid] = panelAndGrid(scene.display);
  std::vector<VtkMesh> parts{ panel, grid, frusta(scene.states) };
  if (scene.mesh != nullptr)
  {
    parts.push_back(meshIn(scene.display, scene.mesh));
  }
  return parts;
}

void addNumbers(vtkPolyData& part, const char* name, int number)
{
  if (part.GetCellData()->GetArray(name) != nullptr)
  {
    return;
  }
  const vtkNew<vtkIntArray> numbers;
  numbers->SetName(name);
  numbers->SetNumberOfValues(part.GetNumberOfCells());
  numbers->FillValue(number);
  part.GetCellData()->AddArray(numbers);
}

std::string vtpOf(const std::vector<VtkMesh>& parts)
{
  const vtkNew<vtkAppendPolyData> all;
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    addNumbers(*parts[k], "Part", int(k));
    addNumbers(*parts[k], "State", -1);
    parts[k]->GetPointData()->SetTCoords(nullptr);
    all->AddInputData(parts[k]);
  }
  const vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(all->GetOutputPort());
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0)
  {
    return {};
  }
  return writer->GetOutputString();
}

} // namespace

void exportScene(const std::filesystem::path& file, const SceneParts& parts)
{
  const std::string extension = file.extension().string();
  if (extension != ".gltf" && extension != ".vtp")
  {
    throw InputError(file.string(), "cannot be written",
      "a scene's extension is .gltf or .vtp, not \"" + extension + "\"");
  }
  const std::string text = extension == ".vtp"
    ? vtpOf(partsOf(parts))
    : gltfText(partsOf(parts), parts.states, parts.panelImage);
  if (text.empty())
  {
    throw InputError(file.string(), "cannot be written", "VTK made nothing of it");
  }
  writeTextFile(file, text);
}

} // namespace hogelscope
