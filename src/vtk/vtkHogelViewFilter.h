// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHogelViewFilter
 * @brief   the image of a light field display that a camera state sees
 *
 * A source without inputs: an adapter of hogelscope::Renderer to VTK's pipeline. The output has the
 * camera's resolution, spacing 1, and two point arrays: "View" (RGB, the scalars; 8 bit, or float
 * code values) and "Seen" (8 bit, 255 or 0). As in all of VTK row 0 is the bottom. Errors are
 * reported by error events and GetErrorMessage(); exceptions are thrown only where documented.
 */
#ifndef vtkHogelViewFilter_h
#define vtkHogelViewFilter_h

#include <vtkImageAlgorithm.h>

#include <exception>
#include <string>

#include "core/engine/renderer.h"
#include "hogelscope_vtkModule.h" // for export macro

class HOGELSCOPE_VTK_EXPORT vtkHogelViewFilter : public vtkImageAlgorithm
{
public:
  static vtkHogelViewFilter* New();
  vtkTypeMacro(vtkHogelViewFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set/Get whether the output is float code values (0 to 255) before rounding. Off by default.
   */
  vtkSetMacro(FloatOutput, bool);
  vtkGetMacro(FloatOutput, bool);
  vtkBooleanMacro(FloatOutput, bool);
  ///@}

  /**
   * Get the reason why the last execution failed; empty if it succeeded or was cancelled.
   */
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }

  /**
   * Return whether the last execution was cancelled by the progress function.
   */
  bool IsCancelled() const { return this->Cancelled; }

#ifndef __VTK_WRAP__
  ///@{
  /**
   * Set/Get the view to simulate. Setting an equal view does not modify the filter.
   */
  void SetJob(const hogelscope::RenderJob& job);
  const hogelscope::RenderJob& GetJob() const
  {
    return this->Job;
  }
  ///@}

  /**
   * Set a function that is called with the fraction done (0 to 1), from any thread, never
   * concurrently; it returns false to cancel. Setting it does not modify the filter.
   */
  void SetProgress(hogelscope::Progress progress)
  {
    this->Progress = std::move(progress);
  }

  /**
   * Get the view that was rendered in place of the given one; valid after an update.
   */
  const hogelscope::Choice& GetChoice() const
  {
    return this->Choice;
  }

  /**
   * Update, and throw hogelscope::InputError or Cancelled on failure. Executes again after a
   * failure.
   */
  void UpdateOrThrow();
#endif

protected:
  vtkHogelViewFilter();
  ~vtkHogelViewFilter() override = default;

  /// Reports an error through GetErrorMessage() and an error event.
  void Fail(const std::exception& error);

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

private:
  vtkHogelViewFilter(const vtkHogelViewFilter&) = delete;
  void operator=(const vtkHogelViewFilter&) = delete;

  void Render(vtkImageData* output);

  hogelscope::RenderJob Job;
  hogelscope::Choice Choice;
  hogelscope::Renderer Renderer;
  bool FloatOutput = false;
  hogelscope::Progress Progress;
  std::string ErrorMessage;
  bool Cancelled = false;
};

#endif
