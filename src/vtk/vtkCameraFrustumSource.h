// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCameraFrustumSource
 * @brief   a camera state as lines: what it sees, at its true field of view and aspect
 *
 * Edges from the eye to the corners of the picture at a distance along the optical axis, the
 * picture's outline there, and a triangle on its upper edge. In the world, without lens distortion.
 */
#ifndef vtkCameraFrustumSource_h
#define vtkCameraFrustumSource_h

#include <vtkPolyDataAlgorithm.h>

#include "core/camera.h"
#include "hogelscope_vtkModule.h" // for export macro

class HOGELSCOPE_VTK_EXPORT vtkCameraFrustumSource : public vtkPolyDataAlgorithm
{
public:
  static vtkCameraFrustumSource* New();
  vtkTypeMacro(vtkCameraFrustumSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetCamera(
    const hogelscope::CameraParams& camera, const hogelscope::IntrinsicsParams& intrinsics = {});

  ///@{
  /**
   * From the eye to the picture's plane, in metres. 0.1 by default.
   */
  vtkSetClampMacro(Distance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Distance, double);
  ///@}

protected:
  vtkCameraFrustumSource();
  ~vtkCameraFrustumSource() override = default;

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

private:
  vtkCameraFrustumSource(const vtkCameraFrustumSource&) = delete;
  void operator=(const vtkCameraFrustumSource&) = delete;

  hogelscope::CameraParams Camera;
  hogelscope::IntrinsicsParams Intrinsics;
  double Distance = 0.1;
};

#endif
