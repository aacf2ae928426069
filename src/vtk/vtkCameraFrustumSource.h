// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCameraFrustumSource
 * @brief   camera states as lines: what they see, at their true field of view and aspect
 *
 * Port 0: for each camera the edges from the eye to the corners of the picture on its near plane (a
 * quarter of the way to lookat), the picture's outline there, and a triangle on its upper edge. The
 * cells have the colour as scalars and the number as "State". Port 1: the pictures' places on the
 * near planes, quads with texture coordinates of an atlas with a tile for each number, and "State".
 *
 * All is in the world and without lens distortion. Cameras without a frame (eye = lookat) are left
 * out. One polydata for all of them, so that hundreds are no slower to draw than one.
 */
#ifndef vtkCameraFrustumSource_h
#define vtkCameraFrustumSource_h

#include <vtkPolyDataAlgorithm.h>

#include <array>
#include <vector>

#include "core/optics/camera.h"
#include "hogelscope_vtkModule.h" // for export macro

namespace hogelscope
{
struct CameraFrustum
{
  CameraParams Camera;
  IntrinsicsParams Intrinsics;
  int State = 0;
  std::array<unsigned char, 3> Colour{ 255, 255, 255 };
  bool IsDashed = false;
  bool operator==(const CameraFrustum&) const = default;
};
}

class HOGELSCOPE_VTK_EXPORT vtkCameraFrustumSource : public vtkPolyDataAlgorithm
{
public:
  static vtkCameraFrustumSource* New();
  vtkTypeMacro(vtkCameraFrustumSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Setting equal ones changes nothing.
   */
  void SetFrusta(const std::vector<hogelscope::CameraFrustum>& frusta);

  ///@{
  /**
   * Tiles in a row of the atlas (atlas.h). 1 by default.
   */
  vtkSetClampMacro(AtlasColumns, int, 1, VTK_INT_MAX);
  vtkGetMacro(AtlasColumns, int);
  ///@}

protected:
  vtkCameraFrustumSource();
  ~vtkCameraFrustumSource() override = default;

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

private:
  vtkCameraFrustumSource(const vtkCameraFrustumSource&) = delete;
  void operator=(const vtkCameraFrustumSource&) = delete;

  std::vector<hogelscope::CameraFrustum> Frusta;
  int AtlasColumns = 1;
};

#endif
