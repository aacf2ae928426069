// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHogelViewFilter.h"

#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

#include "core/base/error.h"

vtkStandardNewMacro(vtkHogelViewFilter);

namespace
{
/// Copies an image's rows, top first, to VTK's, bottom first.
template <class T>
void copyFlipped(const std::vector<T>& values, int height, void* target)
{
  const std::size_t row = values.size() / std::size_t(height);
  T* to = static_cast<T*>(target);
  for (auto from = values.end(); from != values.begin(); to += row)
  {
    from -= std::ptrdiff_t(row);
    std::copy_n(from, row, to);
  }
}

/// Copies an Image or a FloatImage of the output's size.
template <class AnyImage>
void copyToOutput(const AnyImage& image, vtkImageData* output)
{
  copyFlipped(image.rgb, image.height, output->GetScalarPointer());
  vtkNew<vtkUnsignedCharArray> seen;
  seen->SetName("Seen");
  seen->SetNumberOfValues(output->GetNumberOfPoints());
  copyFlipped(image.seen, image.height, seen->GetPointer(0));
  output->GetPointData()->AddArray(seen);
}
}

vtkHogelViewFilter::vtkHogelViewFilter()
{
  this->SetNumberOfInputPorts(0);
}

void vtkHogelViewFilter::SetJob(const hogelscope::RenderJob& job)
{
  if (this->Job == job)
  {
    return;
  }
  this->Job = job;
  this->Choice = {}; // it may hold the last reference to another light field
  this->Modified();
}

int vtkHogelViewFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* info = outputVector->GetInformationObject(0);
  const auto [width, height] = this->Job.state.camera.res;
  const int extent[6] = { 0, width - 1, 0, height - 1, 0, 0 };
  const double spacing[3] = { 1, 1, 1 };
  const double origin[3] = { 0, 0, 0 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  // VTK 9.1 keeps the extent of a failed execution, and requests the union of both.
  info->Remove(vtkStreamingDemandDrivenPipeline::COMBINED_UPDATE_EXTENT());
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(
    info, this->FloatOutput ? VTK_FLOAT : VTK_UNSIGNED_CHAR, 3);
  return 1;
}

int vtkHogelViewFilter::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->ErrorMessage.clear();
  this->Cancelled = false;
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(info);
  this->AllocateOutputData(
    output, info, info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  output->GetPointData()->GetScalars()->SetName("View");
  try
  {
    this->Render(output);
  }
  catch (const hogelscope::Cancelled&)
  {
    this->Cancelled = true;
    return 0;
  }
  catch (const std::exception& error)
  {
    this->Fail(error);
    return 0;
  }
  return 1;
}

void vtkHogelViewFilter::Fail(const std::exception& error)
{
  this->ErrorMessage = error.what();
  vtkErrorMacro(<< this->ErrorMessage);
}

void vtkHogelViewFilter::Render(vtkImageData* output)
{
  this->Choice = this->Renderer.chooseMethod(this->Job, this->Progress);
  if (this->FloatOutput)
  {
    copyToOutput(this->Renderer.renderFloat(this->Choice.job, this->Progress), output);
  }
  else
  {
    copyToOutput(this->Renderer.render(this->Choice.job, this->Progress), output);
  }
}

void vtkHogelViewFilter::UpdateOrThrow()
{
  if (this->Cancelled || !this->ErrorMessage.empty())
  {
    this->Modified(); // otherwise the pipeline would use the remains of a failed execution as its
                      // result
  }
  this->Update();
  if (!this->ErrorMessage.empty())
  {
    throw hogelscope::InputError(this->ErrorMessage, "");
  }
  if (this->Cancelled)
  {
    throw hogelscope::Cancelled();
  }
}

void vtkHogelViewFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Job: " << this->Job.state.camera.name << "\n";
  os << indent << "FloatOutput: " << (this->FloatOutput ? "on" : "off") << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
