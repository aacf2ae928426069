// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHogelFieldSource
 * @brief   the angular field of one hogel, in world coordinates
 *
 * Port 0 has rays from the hogel's middle to the border of its field, and that border. Port 1 has
 * the field's end, a plane parallel to the panel at Length in front of it; texture coordinates are
 * (0, 0) at the direction u = 0, v = dv, so that it shows the hogel's image as its lens spreads it.
 */
#ifndef vtkHogelFieldSource_h
#define vtkHogelFieldSource_h

#include <vtkPolyDataAlgorithm.h>

#include "core/panel/display.h"
#include "hogelscope_vtkModule.h" // for export macro

class HOGELSCOPE_VTK_EXPORT vtkHogelFieldSource : public vtkPolyDataAlgorithm
{
public:
  static vtkHogelFieldSource* New();
  vtkTypeMacro(vtkHogelFieldSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Set the hogel (i, j) of a display whose hogels and directions are given.
   */
  void SetHogel(const hogelscope::PanelParams& display, int i, int j);

  /**
   * Get the distance from the panel to the field's end in metres. It makes the end about a quarter
   * as wide as the panel, which it stands in front of.
   */
  double GetLength() const;

  /**
   * Get the middle of the end's lower edge in world coordinates; a label hangs below it.
   */
  hogelscope::Vec3 GetLabelPosition() const;

protected:
  vtkHogelFieldSource();
  ~vtkHogelFieldSource() override = default;

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

private:
  vtkHogelFieldSource(const vtkHogelFieldSource&) = delete;
  void operator=(const vtkHogelFieldSource&) = delete;

  hogelscope::PanelParams Display;
  int I = 0;
  int J = 0;
};

#endif
