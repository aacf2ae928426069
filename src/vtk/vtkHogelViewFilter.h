// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHogelViewFilter
 * @brief   what a camera state sees of a light field display, as an image
 *
 * A source without inputs: an adapter of hogelscope::FastSimulation to VTK's pipeline, run over
 * vtkSMPTools. The output has the camera's resolution, spacing 1, and two point arrays: "View"
 * (RGB, the scalars; 8 bit, or float code values) and "Seen" (8 bit, 255 or 0). As in all of VTK
 * row 0 is the bottom. What a user can mend is an error event and GetErrorMessage(), never an
 * exception.
 */
#ifndef vtkHogelViewFilter_h
#define vtkHogelViewFilter_h

#include <vtkImageAlgorithm.h>

#include <string>

#include "core/base/progress.h"
#include "core/engine/adaptive_method.h"
#include "core/engine/fast_simulation.h"
#include "core/optics/image.h"
#include "hogelscope_vtkModule.h" // for export macro

class HOGELSCOPE_VTK_EXPORT vtkHogelViewFilter : public vtkImageAlgorithm
{
public:
  static vtkHogelViewFilter* New();
  vtkTypeMacro(vtkHogelViewFilter, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What is simulated. Setting an equal view changes nothing.
   */
  void SetView(const hogelscope::View& view);
  const hogelscope::View& GetView() const { return this->View; }
  ///@}

  ///@{
  /**
   * Float output holds code values (0 to 255) before rounding. Off by default.
   */
  vtkSetMacro(FloatOutput, bool);
  vtkGetMacro(FloatOutput, bool);
  vtkBooleanMacro(FloatOutput, bool);
  ///@}

  /**
   * Hears the done fraction of each picture from any of the threads, one at a time; may say stop.
   * No new execution.
   */
  void SetProgress(hogelscope::Progress progress) { this->Progress = std::move(progress); }

  /**
   * What was chosen to be rendered in the place of the view; after an update. The pipeline's output
   * has its pixels: fewer than the view where its method says so, at a larger spacing.
   */
  const hogelscope::Choice& GetChoice() const { return this->Choice; }

  /**
   * Why the last execution failed; empty if it did not, or was stopped.
   */
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }

  ///@{
  /**
   * For code that is no pipeline: updates, and gives the picture from its top row on; with
   * FloatOutput its code values too. Throws hogelscope::InputError or Cancelled.
   */
  hogelscope::Image GetImage();
  std::vector<float> GetCodeValues();
  ///@}

  /**
   * How many threads work from now on, in the whole process; 0 = all.
   */
  static void SetThreads(int count);

protected:
  vtkHogelViewFilter();
  ~vtkHogelViewFilter() override = default;

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;
  int RequestData(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

private:
  vtkHogelViewFilter(const vtkHogelViewFilter&) = delete;
  void operator=(const vtkHogelViewFilter&) = delete;

  bool Choose();
  void Fill(const hogelscope::Progress& progress, vtkImageData* output);
  void UpdateOrThrow();

  hogelscope::View View;
  hogelscope::Choice Choice;
  bool IsChosen = false;     ///< Choice and Rendered are View's
  hogelscope::View Rendered; ///< Choice.view with the pixels of the output
  hogelscope::LensTables Tables;
  bool FloatOutput = false;
  hogelscope::Progress Progress;
  std::string ErrorMessage;
  bool Stopped = false;
};

#endif
