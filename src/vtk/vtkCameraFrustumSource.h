// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCameraFrustumSource
 * @brief   camera states as lines, at their true field of view and aspect ratio
 *
 * Port 0 has for each camera the edges from the eye to the corners of the image on its near plane
 * (a share of the way to lookat), the image's outline there, and a triangle on its upper edge.
 * The cell data are the colour as scalars and the number as "State". Port 1 has the images'
 * rectangles on the near planes, quads with texture coordinates of an atlas with a tile for each
 * number, and "State".
 *
 * Points are in world coordinates, without lens distortion. Cameras without a frame (eye = lookat)
 * are omitted. One polydata holds all cameras, so that hundreds are drawn as fast as one.
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
  double Length = 0.25; ///< distance of the near plane as a share of that of lookat
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
   * Set the cameras. Setting equal ones does not modify the source.
   */
  void SetFrusta(const std::vector<hogelscope::CameraFrustum>& frusta);

  ///@{
  /**
   * Set/Get the number of tiles in a row of the atlas (atlas.h). 1 by default.
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
