// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/gltf_text.h"

#include <vtkActor.h>
#include <vtkGLTFExporter.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <array>
#include <cmath>

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

}  // namespace hogelscope
