// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkScaleBarSource
 * @brief   a scale bar under the panel, in world coordinates
 *
 * A line with a tick at each end, parallel to the panel's lower edge and under its left end. Its
 * length is the largest of 1, 2, 5 × 10^n metres that is at most half the panel's width.
 */
#ifndef vtkScaleBarSource_h
#define vtkScaleBarSource_h

#include <vtkPolyDataAlgorithm.h>

#include "core/panel/display.h"
#include "hogelscope_vtkModule.h" // for export macro

class HOGELSCOPE_VTK_EXPORT vtkScaleBarSource : public vtkPolyDataAlgorithm
{
public:
  static vtkScaleBarSource* New();
  vtkTypeMacro(vtkScaleBarSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetDisplay(const hogelscope::DisplayParams& display);
  /**
   * Get the length in metres.
   */
  double GetLength() const;
  /**
   * Get the position of the label, under the bar's middle, in world coordinates.
   */
  hogelscope::Vec3 GetLabelPosition() const;

protected:
  vtkScaleBarSource();
  ~vtkScaleBarSource() override = default;

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

private:
  vtkScaleBarSource(const vtkScaleBarSource&) = delete;
  void operator=(const vtkScaleBarSource&) = delete;

  /// Returns a point of the panel's plane; `along` is in metres from the bar's left end, `down` in
  /// fractions of the panel's longer side below its lower edge.
  hogelscope::Vec3 At(double along, double down) const;

  hogelscope::DisplayParams Display;
};

#endif
