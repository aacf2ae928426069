// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHogelDisplaySource
 * @brief   the panel and its hogel grid as polygonal data, in world coordinates
 *
 * Port 0 has the panel, one quad whose texture coordinates are (0, 0) at its lower left. Port 1 has
 * the borders of the hogels as lines; if they are closer to each other than Spacing, only every
 * 2nd, 4th, 8th … of them. Of a lens sheet it has lines along the lenses, twice as far apart,
 * because they are over the picture too.
 */
#ifndef vtkHogelDisplaySource_h
#define vtkHogelDisplaySource_h

#include <vtkPolyDataAlgorithm.h>

#include "core/panel/display.h"
#include "hogelscope_vtkModule.h" // for export macro

class HOGELSCOPE_VTK_EXPORT vtkHogelDisplaySource : public vtkPolyDataAlgorithm
{
public:
  static vtkHogelDisplaySource* New();
  vtkTypeMacro(vtkHogelDisplaySource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetDisplay(const hogelscope::DisplayParams& display);

  ///@{
  /**
   * Set/Get the least distance between two lines in metres. 0 by default.
   */
  vtkSetClampMacro(Spacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Spacing, double);
  ///@}

protected:
  vtkHogelDisplaySource();
  ~vtkHogelDisplaySource() override = default;

  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

private:
  vtkHogelDisplaySource(const vtkHogelDisplaySource&) = delete;
  void operator=(const vtkHogelDisplaySource&) = delete;

  hogelscope::DisplayParams Display;
  double Spacing = 0;
};

#endif
