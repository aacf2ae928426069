// SPDX-License-Identifier: BSD-3-Clause
// The frusta of all states in the 3-D scene: the current one marked, those outside the viewing
// zone dashed, the others optionally coloured by PSNR, all optionally filled with their images.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>

#include <vector>

#include "core/metrics/psnr_scale.h"
#include "core/optics/session.h"
#include "gui/widgets/colours.h"
#include "vtk/state_atlas.h"
#include "vtk/vtkCameraFrustumSource.h"

class vtkRenderer;

namespace hogelscope {

struct ScreenPlace;

class FrustumActors {
 public:
  explicit FrustumActors(vtkRenderer* renderer);

  void setColours(const Tokens& colours);
  void show(const PanelParams& display, const std::vector<CameraState>& states,
            std::size_t current);
  /// Shows the frusta of states that are not in the session yet.
  void showPreview(const std::vector<CameraState>& states);
  void setVisible(bool areVisible);
  /// Scales the frusta's length, 1/64 … 4. The default is a quarter of the distance to lookat or,
  /// from 30 states on, a twentieth for all but the current one; the image is at lookat at most.
  void setSize(double factor);
  [[nodiscard]] double size() const { return m_size; }
  /// Sets the PSNR in dB of each state; empty: none.
  void showPsnr(const std::vector<double>& values);
  [[nodiscard]] const PsnrScale& psnr() const { return m_psnr; }
  void setImagesVisible(bool areVisible);
  void setImage(std::size_t state, vtkImageData* image) { m_images.SetImage(state, image); }
  void clearImages() { m_images.Clear(); }
  /// Returns the points of all frustum lines, in the world.
  [[nodiscard]] std::vector<Vec3> points() const;
  /// Returns the states whose frusta are drawn at a place on the screen, in ascending order.
  [[nodiscard]] std::vector<int> statesAt(vtkRenderer* renderer, const ScreenPlace& place) const;

 private:
  void update();

  const Tokens* m_colours = &tokens();
  PanelParams m_display;
  std::vector<CameraState> m_states;
  std::vector<CameraState> m_preview;
  std::size_t m_current = 0;
  double m_size = 1;
  PsnrScale m_psnr;
  StateAtlas m_images;
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
