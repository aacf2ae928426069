// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/frustum_actors.h"

#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <algorithm>

#include "core/optics/eyes.h"
#include "core/panel/viewing_zone.h"
#include "gui/scene/scene_actor.h"
#include "vtk/line_picker.h"

namespace hogelscope {

namespace {

using Colour = std::array<unsigned char, 3>;
constexpr double fullLength = 0.25;   // of the distance to lookat
constexpr double shortLength = 0.05;  // for many states, which would hide each other at full length
constexpr std::size_t manyStates = 30;

Colour bytesOf(const QColor& colour) {
  const QRgb rgb = colour.rgb();
  return {std::uint8_t(qRed(rgb)), std::uint8_t(qGreen(rgb)), std::uint8_t(qBlue(rgb))};
}

}  // namespace

FrustumActors::FrustumActors(vtkRenderer* renderer) {
  addToScene(renderer, m_otherImages, m_others->GetOutputPort(1), SceneLevel::panel);
  addToScene(renderer, m_markedImage, m_marked->GetOutputPort(1), SceneLevel::panel);
  addToScene(renderer, m_otherLines, m_others->GetOutputPort(0), SceneLevel::onPanel);
  addToScene(renderer, m_markedLines, m_marked->GetOutputPort(0), SceneLevel::inFront);
  addToScene(renderer, m_previewLines, m_previewed->GetOutputPort(0), SceneLevel::onPanel);
  m_markedLines->GetProperty()->SetLineWidth(3);
  m_markedLines->GetProperty()->RenderLinesAsTubesOn();  // plain lines are one pixel wide
  for (vtkActor* images : {m_otherImages.Get(), m_markedImage.Get()})
    images->SetTexture(m_images.GetTexture());
  setImagesVisible(false);
}

void FrustumActors::show(const PanelParams& display, const std::vector<CameraState>& states,
                         std::size_t current) {
  m_display = display;
  m_states = states;
  m_current = current;
  m_images.SetCount(states.size());
  update();
}

void FrustumActors::setColours(const Tokens& colours) {
  m_colours = &colours;
  update();
}

void FrustumActors::showPsnr(const std::vector<double>& values) {
  m_psnr.setValues(values);
  update();
}

void FrustumActors::showPreview(const std::vector<CameraState>& states) {
  m_preview = states;
  update();
}

void FrustumActors::setVisible(bool areVisible) {
  for (vtkActor* lines : {m_otherLines.Get(), m_markedLines.Get(), m_previewLines.Get()})
    lines->SetVisibility(areVisible);
}

void FrustumActors::setSize(double factor) {
  m_size = std::clamp(factor, 1.0 / 64, 4.0);
  update();
}

void FrustumActors::update() {
  std::vector<CameraFrustum> others;
  std::vector<CameraFrustum> marked;
  std::vector<CameraFrustum> previewed;
  const auto frustumOf = [this](const CameraState& state, int number, const Colour& colour,
                                std::size_t among) {
    const bool isOutside = shareSeenFrom(m_display, state.camera.eye) == 0;
    const double length = std::min(1.0, m_size * (among < manyStates ? fullLength : shortLength));
    return CameraFrustum{state.camera, state.intrinsics, number, colour, isOutside, length};
  };
  const auto eyesIn = [this](const CameraState& state) {
    return hasFrame(state.camera) ? eyesOf(state, m_display) : std::vector{state};
  };
  for (std::size_t k = 0; k < m_states.size(); ++k)
    for (const CameraState& eye : eyesIn(m_states[k]))
      if (k == m_current)
        marked.push_back(frustumOf(eye, int(k), bytesOf(m_colours->eye), 1));
      else
        others.push_back(frustumOf(
            eye, int(k), m_psnr.hasValue(k) ? m_psnr.colour(k) : bytesOf(m_colours->text3),
            m_states.size()));
  for (const CameraState& state : m_preview)
    previewed.push_back(frustumOf(state, -1, bytesOf(m_colours->focus), m_preview.size()));
  m_others->SetFrusta(others);
  m_marked->SetFrusta(marked);
  m_previewed->SetFrusta(previewed);
  m_others->SetAtlasColumns(m_images.GetColumns());
  m_marked->SetAtlasColumns(m_images.GetColumns());
}

void FrustumActors::setImagesVisible(bool areVisible) {
  m_otherImages->SetVisibility(areVisible);
  m_markedImage->SetVisibility(areVisible);
}

std::vector<Vec3> FrustumActors::points() const {
  std::vector<Vec3> all;
  for (vtkCameraFrustumSource* source : {m_others.Get(), m_marked.Get(), m_previewed.Get()}) {
    source->Update();
    vtkPolyData* lines = source->GetOutput(0);
    for (vtkIdType k = 0; k < lines->GetNumberOfPoints(); ++k) {
      const double* p = lines->GetPoint(k);
      all.push_back({p[0], p[1], p[2]});
    }
  }
  return all;
}

std::vector<int> FrustumActors::statesAt(vtkRenderer* renderer, const ScreenPlace& place) const {
  vtkMatrix4x4* clipFromWorld = renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
      renderer->GetTiledAspectRatio(), -1, 1);
  std::vector<int> all;
  if (m_otherLines->GetVisibility() == 0) return all;
  for (vtkCameraFrustumSource* source : {m_others.Get(), m_marked.Get()}) {
    source->Update();
    const std::vector<int> found = hogelscope::statesAt(source->GetOutput(0), clipFromWorld, place);
    all.insert(all.end(), found.begin(), found.end());
  }
  std::ranges::sort(all);
  return all;
}

}  // namespace hogelscope
