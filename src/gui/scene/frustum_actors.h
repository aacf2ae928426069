// SPDX-License-Identifier: BSD-3-Clause
// The frusta of all states in the 3-D scene: the current one marked, those outside the viewing zone
// dashed, coloured by PSNR where there is one, with their images where wanted.
#pragma once

#include <vtkNew.h>

#include <vector>

#include "core/optics/session.h"
#include "gui/scene/psnr_scale.h"
#include "gui/scene/state_images.h"

class vtkActor;
class vtkCameraFrustumSource;
class vtkRenderer;

namespace hogelscope {

struct ScreenPlace;

class FrustumActors {
 public:
  explicit FrustumActors(vtkRenderer* renderer);
  ~FrustumActors();
  FrustumActors(const FrustumActors&) = delete;
  FrustumActors& operator=(const FrustumActors&) = delete;

  void show(const DisplayParams& display, const std::vector<CameraState>& states,
            std::size_t current);
  /// Of states that are not in the session yet.
  void showPreview(const std::vector<CameraState>& states);
  void setVisible(bool areVisible);
  /// So many times as long as they are by themselves: a quarter of the way to lookat or, from 30
  /// states on, all but the current one a twentieth. 1/64 … 4; the image is at lookat at most.
  void setSize(double factor);
  [[nodiscard]] double size() const { return m_size; }
  /// In dB, by state; empty: none.
  void showPsnr(const std::vector<double>& values);
  void setImagesVisible(bool areVisible);
  void setImage(std::size_t state, vtkImageData* image);
  void clearImages() { m_images.clear(); }
  /// Of all their lines, in the world.
  [[nodiscard]] std::vector<Vec3> points() const;
  /// The states whose frusta are drawn at a place of the screen, in ascending order.
  [[nodiscard]] std::vector<int> statesAt(vtkRenderer* renderer, const ScreenPlace& place) const;

 private:
  void update();

  DisplayParams m_display;
  std::vector<CameraState> m_states;
  std::vector<CameraState> m_preview;
  std::size_t m_current = 0;
  double m_size = 1;
  PsnrScale m_psnr;
  StateImages m_images;
  vtkNew<vtkCameraFrustumSource> m_others;
  vtkNew<vtkCameraFrustumSource> m_marked;
  vtkNew<vtkCameraFrustumSource> m_previewed;
  vtkNew<vtkActor> m_otherLines;
  vtkNew<vtkActor> m_markedLines;
  vtkNew<vtkActor> m_previewLines;
  vtkNew<vtkActor> m_otherImages;
  vtkNew<vtkActor> m_markedImage;
};

}  // namespace hogelscope
