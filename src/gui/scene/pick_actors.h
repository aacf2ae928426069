// SPDX-License-Identifier: BSD-3-Clause
// The picked objects in the 3-D scene: a hogel's angular field with its image, a pixel's ray.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

#include <string>

#include "core/panel/display.h"
#include "gui/widgets/colours.h"
#include "vtk/vtkHogelFieldSource.h"

class vtkImageData;
class vtkRenderer;

namespace hogelscope {

class PickActors {
 public:
  explicit PickActors(vtkRenderer* renderer);
  void setColours(const Tokens& colours);

  /// Shows a hogel with its indices below it. `image` has a pixel for each of the hogel's
  /// directions.
  void showHogel(const PanelParams& display, int i, int j, vtkImageData* image);
  /// Shows a ray between two points of the world, in metres.
  void showRay(const Vec3& from, const Vec3& to);
  void hideHogel();
  void hideRay() { m_ray->VisibilityOff(); }
  [[nodiscard]] bool hasRay() const { return m_ray->GetVisibility() != 0; }
  /// Returns the hogel's label; "" if no hogel is shown.
  [[nodiscard]] const std::string& label() const { return m_label; }
  /// Returns the point of the world below which the label stands.
  [[nodiscard]] Vec3 labelPlace() const { return m_field->GetLabelPosition(); }

 private:
  vtkNew<vtkHogelFieldSource> m_field;
  vtkNew<vtkActor> m_rays;
  vtkNew<vtkActor> m_end;
  vtkNew<vtkTexture> m_image;
  std::string m_label;
  vtkNew<vtkPolyData> m_line;
  vtkNew<vtkActor> m_ray;
};

}  // namespace hogelscope
