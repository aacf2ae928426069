// SPDX-License-Identifier: BSD-3-Clause
// The frusta of all states in the 3-D scene: the current one marked, those outside the viewing
// zone dashed, the others optionally coloured by PSNR, all optionally filled with their images.
#pragma once

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkTexture.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/optics/session.h"
#include "gui/widgets/colours.h"
#include "vtk/atlas.h"
#include "vtk/vtkCameraFrustumSource.h"

class vtkRenderer;

namespace hogelscope {

struct ScreenPlace;

/// Colour scale of the states' PSNR.
class PsnrScale {
 public:
  /// Sets the PSNR in dB of each state; infinite: identical, NaN: none.
  void setValues(const std::vector<double>& values);
  [[nodiscard]] bool hasValue(std::size_t state) const { return state < m_values.size(); }
  /// Returns the state's colour on the scale of the finite values. Identical is coloured as the
  /// largest, a state without a value is grey.
  [[nodiscard]] std::array<std::uint8_t, 3> colour(std::size_t state) const;
  /// Returns the least and the largest value in dB; none without values.
  [[nodiscard]] std::optional<std::array<double, 2>> range() const {
    return m_values.empty() ? std::nullopt : std::optional(m_range);
  }

 private:
  std::vector<double> m_values;
  std::array<double, 2> m_range{0, 1};  ///< dB
};

/// The small images of the states in one texture, with one tile each.
class StateImages {
 public:
  StateImages();

  /// Sets the number of tiles. If it changes, all tiles become empty.
  void setCount(std::size_t count);
  /// Empties all tiles.
  void clear();
  /// Sets an RGB image, stretched to the tile. Ignores an index without a tile.
  void setImage(std::size_t index, vtkImageData* image);
  [[nodiscard]] int columns() const { return m_atlas.Columns; }
  [[nodiscard]] vtkTexture* texture() const { return m_texture; }

 private:
  Atlas m_atlas;
  std::size_t m_count = 0;
  int m_tile = 0;  ///< side length in texels
  vtkNew<vtkImageData> m_image;
  vtkNew<vtkTexture> m_texture;
};

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
  void setImage(std::size_t state, vtkImageData* image) { m_images.setImage(state, image); }
  void clearImages() { m_images.clear(); }
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
