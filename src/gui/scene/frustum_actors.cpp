// SPDX-License-Identifier: BSD-3-Clause
#include "gui/scene/frustum_actors.h"

#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <algorithm>
#include <cmath>

#include "core/base/colour_map.h"
#include "core/panel/viewing_zone.h"
#include "gui/scene/scene_actor.h"
#include "vtk/line_picker.h"

namespace hogelscope {

namespace {

constexpr int longestTile = 192;   ///< texels: few states have fine images
constexpr int longestSide = 1024;  ///< of the texture, which is uploaded again with each image
constexpr std::uint8_t emptyGrey = 40;

using Colour = std::array<unsigned char, 3>;
constexpr double fullLength = 0.25;   // of the distance to lookat
constexpr double shortLength = 0.05;  // for many states, which would hide each other at full length
constexpr std::size_t manyStates = 30;

Colour bytesOf(const QColor& colour) {
  const QRgb rgb = colour.rgb();
  return {std::uint8_t(qRed(rgb)), std::uint8_t(qGreen(rgb)), std::uint8_t(qBlue(rgb))};
}

/// Returns the range of the finite values, at least 1 dB wide so that equal values have a scale
/// too.
std::array<double, 2> rangeOf(const std::vector<double>& values) {
  double least = HUGE_VAL;
  double most = -HUGE_VAL;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (least > most) return {0, 1};
  return {least, std::max(most, least + 1)};
}

}  // namespace

void PsnrScale::setValues(const std::vector<double>& values) {
  m_values = values;
  m_range = rangeOf(values);
}

std::array<std::uint8_t, 3> PsnrScale::colour(std::size_t state) const {
  return falseColour((m_values[state] - m_range[0]) / (m_range[1] - m_range[0]));
}

StateImages::StateImages() {
  m_texture->SetInputData(m_image);
  m_texture->InterpolateOn();
  setCount(1);
}

void StateImages::setCount(std::size_t count) {
  if (count == m_count) return;
  m_count = count;
  m_atlas = Atlas::ForCount(count);
  m_tile = std::clamp(longestSide / m_atlas.Columns, 1, longestTile);
  const int side = m_tile * m_atlas.Columns;
  m_image->SetDimensions(side, side, 1);
  m_image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  clear();
}

void StateImages::clear() {
  std::fill_n(static_cast<std::uint8_t*>(m_image->GetScalarPointer()),
              3 * m_image->GetNumberOfPoints(), emptyGrey);
  m_image->Modified();
  m_texture->Modified();  // marks actors with this texture as changed
}

void StateImages::setImage(std::size_t index, vtkImageData* image) {
  if (index >= m_count) return;
  const int* size = image->GetDimensions();
  const int left = m_atlas.Column(int(index)) * m_tile;
  const int bottom = m_atlas.Row(int(index)) * m_tile;
  for (int y = 0; y < m_tile; ++y) {
    auto* to = static_cast<std::uint8_t*>(m_image->GetScalarPointer(left, bottom + y, 0));
    for (int x = 0; x < m_tile; ++x, to += 3)
      std::copy_n(static_cast<const std::uint8_t*>(
                      image->GetScalarPointer(x * size[0] / m_tile, y * size[1] / m_tile, 0)),
                  3, to);
  }
  m_image->Modified();
  m_texture->Modified();
}

FrustumActors::FrustumActors(vtkRenderer* renderer) {
  addToScene(renderer, m_otherImages, m_others->GetOutputPort(1), SceneLevel::panel);
  addToScene(renderer, m_markedImage, m_marked->GetOutputPort(1), SceneLevel::panel);
  addToScene(renderer, m_otherLines, m_others->GetOutputPort(0), SceneLevel::onPanel);
  addToScene(renderer, m_markedLines, m_marked->GetOutputPort(0), SceneLevel::inFront);
  addToScene(renderer, m_previewLines, m_previewed->GetOutputPort(0), SceneLevel::onPanel);
  m_markedLines->GetProperty()->SetLineWidth(3);
  m_markedLines->GetProperty()->RenderLinesAsTubesOn();  // plain lines are one pixel wide
  for (vtkActor* images : {m_otherImages.Get(), m_markedImage.Get()})
    images->SetTexture(m_images.texture());
  setImagesVisible(false);
}

void FrustumActors::show(const PanelParams& display, const std::vector<CameraState>& states,
                         std::size_t current) {
  m_display = display;
  m_states = states;
  m_current = current;
  m_images.setCount(states.size());
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
  const auto lengthAmong = [this](std::size_t count) {
    return std::min(1.0, m_size * (count < manyStates ? fullLength : shortLength));
  };
  const double currentLength = lengthAmong(1);
  const double otherLength = lengthAmong(m_states.size());
  for (std::size_t k = 0; k < m_states.size(); ++k) {
    const CameraParams& camera = m_states[k].camera;
    const bool isOutside = shareSeenFrom(m_display, camera.eye) == 0;
    Colour colour = bytesOf(k == m_current ? m_colours->eye : m_colours->text3);
    if (k != m_current && m_psnr.hasValue(k)) colour = m_psnr.colour(k);
    (k == m_current ? marked : others)
        .push_back({camera, m_states[k].intrinsics, int(k), colour, isOutside,
                    k == m_current ? currentLength : otherLength});
  }
  for (const CameraState& state : m_preview)
    previewed.push_back({state.camera, state.intrinsics, -1, bytesOf(m_colours->focus),
                         shareSeenFrom(m_display, state.camera.eye) == 0,
                         lengthAmong(m_preview.size())});
  m_others->SetFrusta(others);
  m_marked->SetFrusta(marked);
  m_previewed->SetFrusta(previewed);
  m_others->SetAtlasColumns(m_images.columns());
  m_marked->SetAtlasColumns(m_images.columns());
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
