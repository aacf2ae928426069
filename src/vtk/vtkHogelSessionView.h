// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHogelSessionView
 * @brief   the image that a camera state of a session document sees
 *
 * A vtkHogelViewFilter that takes a file in place of C++ values, for languages that VTK wraps.
 * Failures are error events, false, and GetErrorMessage().
 */
#ifndef vtkHogelSessionView_h
#define vtkHogelSessionView_h

#include <string>

#include "hogelscope_vtkModule.h" // for export macro
#include "vtkHogelViewFilter.h"

class HOGELSCOPE_VTK_EXPORT vtkHogelSessionView : public vtkHogelViewFilter
{
public:
  static vtkHogelSessionView* New();
  vtkTypeMacro(vtkHogelSessionView, vtkHogelViewFilter);

  /**
   * Read a session document with its light field, and take the camera state of that name. Returns
   * false, and keeps the view as it was, if it cannot be read or has no such state.
   */
  bool SetSession(const std::string& file, const std::string& state);

  /**
   * Move the eye, in metres; the point that it looks at stays.
   */
  void SetEye(double x, double y, double z);

protected:
  vtkHogelSessionView() = default;
  ~vtkHogelSessionView() override = default;

private:
  vtkHogelSessionView(const vtkHogelSessionView&) = delete;
  void operator=(const vtkHogelSessionView&) = delete;
};

#endif
