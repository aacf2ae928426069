// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/scene_export.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkGLTFExporter.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkIntArray.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkShaderProperty.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>
#include <vtkTextureObject.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>
#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"
#include "gui/scene/scene_actor.h"
#include "io/files/atomic_file.h"
#include "io/files/system_limits.h"
#include "vtk/vtkCameraFrustumSource.h"
#include "vtk/vtkHogelDisplaySource.h"

namespace hogelscope {

namespace {

/// Returns the node of a camera, which in glTF looks along its -z with +y up. Distortion and
/// principal point are not exported.
QJsonObject cameraNode(const CameraState& state, int index) {
  const auto [right, down, forward, eye] = Camera(state.camera, state.intrinsics).worldFromCamera();
  const Vec3 up = -1.0 * down;
  const Vec3 back = -1.0 * forward;
  const QJsonArray matrix{right.x, right.y, right.z, 0, up.x,  up.y,  up.z,  0,
                          back.x,  back.y,  back.z,  0, eye.x, eye.y, eye.z, 1};
  return {
      {"name", QString::fromStdString(state.camera.name)}, {"camera", index}, {"matrix", matrix}};
}

QJsonObject cameraOf(const CameraState& state) {
  const auto [width, height] = state.camera.res;
  const Vec2 focal = Camera(state.camera, state.intrinsics).focalLength();
  const double nearest = 1e-3;  // metres
  return {{"name", QString::fromStdString(state.camera.name)},
          {"type", "perspective"},
          {"perspective", QJsonObject{{"yfov", 2 * std::atan(height / 2.0 / focal.y)},
                                      {"aspectRatio", width / focal.x * focal.y / height},
                                      {"znear", nearest}}}};
}

/// Names the objects, and replaces the exporter's only camera, whose matrix VTK 9.1 writes
/// inverted, by those of the states.
std::string withCameras(const std::string& gltf, const QStringList& names,
                        const std::vector<CameraState>& states) {
  QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(gltf)).object();
  QJsonArray nodes;
  QJsonArray children;
  const auto add = [&](const QJsonObject& node) {
    children.append(nodes.size());
    nodes.append(node);
  };
  for (qsizetype k = 0; k < names.size(); ++k) add({{"name", names[k]}, {"mesh", k}});
  QJsonArray cameras;
  for (const CameraState& state : states) {
    if (!hasFrame(state.camera)) continue;
    add(cameraNode(state, int(cameras.size())));
    cameras.append(cameraOf(state));
  }
  root["nodes"] = nodes;
  root["scenes"] = QJsonArray{QJsonObject{{"nodes", children}}};
  root["scene"] = 0;
  if (cameras.isEmpty())
    root.remove("cameras");
  else
    root["cameras"] = cameras;
  return QJsonDocument(root).toJson(QJsonDocument::Compact).toStdString();
}

}  // namespace

/// Exports the parts as objects of a window that is never shown.
std::string gltfText(const std::vector<VtkMesh>& parts, const std::vector<CameraState>& states,
                     vtkImageData* panelImage) {
  const vtkNew<vtkRenderer> renderer;
  const std::array<const char*, 4> allNames{"panel", "hogel grid", "frusta", "mesh"};
  QStringList names;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k]->GetNumberOfCells() == 0) continue;  // the exporter skips it too
    names << allNames[k];
    const vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(parts[k]);
    const vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    if (k == 0 && panelImage != nullptr) {
      mapper->ScalarVisibilityOff();  // a texture is multiplied by the colour
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

namespace {

using Colour = std::array<unsigned char, 3>;

constexpr Colour gridColour{128, 148, 179};
constexpr Colour frustumColour{140, 191, 153};
constexpr Colour meshColour{200, 200, 200};  // for a mesh without colours

/// Returns a copy without arrays other than texture coordinates.
VtkMesh bare(vtkPolyData* source) {
  auto part = VtkMesh::New();
  part->CopyStructure(source);
  part->GetPointData()->SetTCoords(source->GetPointData()->GetTCoords());
  return part;
}

void setColour(vtkPolyData& part, const Colour& rgb) {
  const vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("Colour");
  colours->SetNumberOfComponents(3);
  for (vtkIdType k = 0; k < part.GetNumberOfPoints(); ++k)
    colours->InsertNextTypedTuple(rgb.data());
  part.GetPointData()->SetScalars(colours);
}

std::array<VtkMesh, 2> panelAndGrid(const PanelParams& display) {
  const vtkNew<vtkHogelDisplaySource> source;
  source->SetDisplay(display);
  source->Update();
  std::array<VtkMesh, 2> parts{bare(source->GetOutput(0)), bare(source->GetOutput(1))};
  setColour(*parts[0], SceneWorker::panelColour);
  setColour(*parts[1], gridColour);
  return parts;
}

/// Returns the frusta with the cell array State.
VtkMesh frusta(const std::vector<CameraState>& states) {
  std::vector<CameraFrustum> all;
  for (std::size_t k = 0; k < states.size(); ++k)
    all.push_back({states[k].camera, states[k].intrinsics, int(k)});
  const vtkNew<vtkCameraFrustumSource> source;
  source->SetFrusta(all);
  source->Update();
  VtkMesh part = bare(source->GetOutput(0));
  part->GetCellData()->AddArray(source->GetOutput(0)->GetCellData()->GetArray("State"));
  setColour(*part, frustumColour);
  return part;
}

/// Returns the mesh in the world.
VtkMesh meshIn(const PanelParams& display, vtkPolyData* mesh) {
  VtkMesh part = bare(mesh);
  const RigidTransform worldFromDisplay = transformFromPose(display.position, display.orientation);
  const vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k) {
    const double* p = mesh->GetPoint(k);
    const Vec3 at = worldFromDisplay.point({p[0], p[1], p[2]});
    points->SetPoint(k, at.x, at.y, at.z);
  }
  part->SetPoints(points);
  if (vtkDataArray* colours = mesh->GetPointData()->GetScalars(); colours != nullptr) {
    const auto copy = vtkSmartPointer<vtkDataArray>::Take(colours->NewInstance());
    copy->DeepCopy(colours);
    copy->SetName("Colour");
    part->GetPointData()->SetScalars(copy);
  } else {
    setColour(*part, meshColour);
  }
  return part;
}

/// Returns panel, hogel grid, frusta and mesh.
std::vector<VtkMesh> partsOf(const SceneParts& scene) {
  const auto [panel, grid] = panelAndGrid(scene.display);
  std::vector<VtkMesh> parts{panel, grid, frusta(scene.states)};
  if (scene.mesh != nullptr) parts.push_back(meshIn(scene.display, scene.mesh));
  return parts;
}

void addNumbers(vtkPolyData& part, const char* name, int number) {
  if (part.GetCellData()->GetArray(name) != nullptr) return;
  const vtkNew<vtkIntArray> numbers;
  numbers->SetName(name);
  numbers->SetNumberOfValues(part.GetNumberOfCells());
  numbers->FillValue(number);
  part.GetCellData()->AddArray(numbers);
}

std::string vtpOf(const std::vector<VtkMesh>& parts) {
  const vtkNew<vtkAppendPolyData> all;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    addNumbers(*parts[k], "Part", int(k));
    addNumbers(*parts[k], "State", -1);
    parts[k]->GetPointData()->SetTCoords(nullptr);
    all->AddInputData(parts[k]);
  }
  const vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(all->GetOutputPort());
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0) return {};
  return writer->GetOutputString();
}

}  // namespace

void exportScene(const std::filesystem::path& file, const SceneParts& parts) {
  const std::string extension = file.extension().string();
  if (extension != ".gltf" && extension != ".vtp")
    throw InputError(file.string(), "cannot be written",
                     "a scene's extension is .gltf or .vtp, not \"" + extension + "\"");
  const std::string text = extension == ".vtp"
                               ? vtpOf(partsOf(parts))
                               : gltfText(partsOf(parts), parts.states, parts.panelImage);
  if (text.empty()) throw InputError(file.string(), "cannot be written", "VTK made nothing of it");
  writeTextFile(file, text);
}

namespace {

/// Returns the actors of all renderers, including those inside axes and other assemblies.
std::vector<vtkActor*> actorsOf(vtkRenderWindow& window) {
  const vtkNew<vtkPropCollection> actors;
  vtkRendererCollection* renderers = window.GetRenderers();
  renderers->InitTraversal();
  while (vtkRenderer* renderer = renderers->GetNextItem()) {
    vtkCollectionSimpleIterator at = nullptr;
    renderer->GetViewProps()->InitTraversal(at);
    while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(at)) prop->GetActors(actors);
  }
  std::vector<vtkActor*> all;
  actors->InitTraversal();
  while (vtkProp* actor = actors->GetNextProp()) all.push_back(vtkActor::SafeDownCast(actor));
  return all;
}

bool hasLinesAlone(vtkActor* actor) {
  auto* data = vtkPolyData::SafeDownCast(
      actor->GetMapper() != nullptr ? actor->GetMapper()->GetInput() : nullptr);
  return data != nullptr && data->GetNumberOfLines() > 0 &&
         data->GetNumberOfLines() == data->GetNumberOfCells();
}

/// Scales line widths by `factor` during its lifetime. Plain lines are limited to one pixel, so
/// lines become tubes, without lighting, which would shade one of their sides.
class ThickerLines {
 public:
  ThickerLines(vtkRenderWindow& window, double factor) {
    for (vtkActor* actor : actorsOf(window)) {
      if (!hasLinesAlone(actor)) continue;
      if (actor->GetShaderProperty()->GetNumberOfShaderReplacements() == 0)
        setDepth(actor, SceneLevel::onPanel);
      vtkProperty* look = actor->GetProperty();
      m_before.push_back(
          {look, look->GetLineWidth(), look->GetRenderLinesAsTubes(), look->GetLighting()});
    }
    for (const Look& look : m_before) {
      look.property->SetLineWidth(float(factor) * look.width);
      look.property->RenderLinesAsTubesOn();
      look.property->LightingOff();
    }
  }
  ~ThickerLines() {
    for (const Look& look : m_before) {
      look.property->SetLineWidth(look.width);
      look.property->SetRenderLinesAsTubes(look.areTubes);
      look.property->SetLighting(look.isLit);
    }
  }
  ThickerLines(const ThickerLines&) = delete;
  ThickerLines& operator=(const ThickerLines&) = delete;

 private:
  struct Look {
    vtkSmartPointer<vtkProperty> property;
    float width;
    bool areTubes;
    bool isLit;
  };
  std::vector<Look> m_before;
};

/// Returns the samples per pixel: 4, the most in software, at 8 bytes each; none for a large image.
int samplesFor(const QSize& size) {
  constexpr int largest = 4096;
  return std::max(size.width(), size.height()) <= largest ? 4 : 0;
}

}  // namespace

QImage scenePicture(vtkGenericOpenGLRenderWindow& window, const QSize& size) {
  constexpr std::size_t bytesPerPixel = 24;  // colour, depth and their copies
  checkFits(bytesPerPixel * std::size_t(size.width()) * std::size_t(size.height()),
            "the scene's picture", {});
  window.MakeCurrent();
  const int largest = vtkTextureObject::GetMaximumTextureSize(&window);
  if (std::max(size.width(), size.height()) > largest)
    throw InputError("the scene's picture", "size",
                     "OpenGL ends at " + std::to_string(largest) + " px here");
  const int* own = window.GetSize();
  const QSize before(own[0], own[1]);
  const double factor = double(size.height()) / std::max(1, before.height());
  const ThickerLines lines(window, factor);
  window.SetSize(size.width(), size.height());
  window.SetMultiSamples(samplesFor(size));
  window.Render();
  const vtkNew<vtkUnsignedCharArray> rgba;
  window.GetRGBACharPixelData(0, 0, size.width() - 1, size.height() - 1, 0, rgba.Get(), 0);
  window.SetMultiSamples(0);
  window.SetSize(before.width(), before.height());
  return QImage(rgba->GetPointer(0), size.width(), size.height(),
                QImage::Format_RGBA8888_Premultiplied)
      .mirrored();  // OpenGL's first row is the lowest
}

}  // namespace hogelscope
