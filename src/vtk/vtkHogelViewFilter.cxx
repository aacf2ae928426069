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
#include <atomic>

#include "core/base/parallel.h"
#include "core/engine/scaled_view.h"

vtkStandardNewMacro(vtkHogelViewFilter);

namespace
{
constexpr const char* seenName = "Seen";

/// One row of the update extent, VTK's row y.
template <class T>
void fillRow(const hogelscope::FastSimulation& simulation, int height, vtkImageData* output, int y)
{
  const int* extent = output->GetExtent();
  auto* seen = vtkUnsignedCharArray::SafeDownCast(output->GetPointData()->GetArray(seenName));
  const int width = extent[1] - extent[0] + 1;
  simulation.row(height - 1 - y, extent[0], extent[1] + 1,
    static_cast<T*>(output->GetScalarPointer(extent[0], y, 0)),
    seen->GetPointer(vtkIdType(y - extent[2]) * width));
}

/// VTK's rows, from the bottom, become a picture's, from the top.
template <class T>
void copyFlipped(vtkDataArray* source, int height, std::vector<T>& target)
{
  const std::size_t row = target.size() / std::size_t(height);
  const T* values = static_cast<const T*>(source->GetVoidPointer(0));
  for (auto to = target.end(); to != target.begin(); values += row)
  {
    to -= std::ptrdiff_t(row);
    std::copy_n(values, row, to);
  }
}
}

vtkHogelViewFilter::vtkHogelViewFilter()
{
  this->SetNumberOfInputPorts(0);
}

void vtkHogelViewFilter::SetView(const hogelscope::View& view)
{
  if (this->View == view)
  {
    return;
  }
  this->View = view;
  this->IsChosen = false;
  this->Choice = {}; // they may hold the last reference to another light field
  this->Rendered = {};
  this->Modified();
}

void vtkHogelViewFilter::SetThreads(int count)
{
  hogelscope::setThreads(count);
}

/// What to render in the place of the view. False where that fails or is stopped.
bool vtkHogelViewFilter::Choose()
{
  try
  {
    this->Choice =
      hogelscope::choose(this->View, this->Tables, hogelscope::parallelRows, this->Progress);
    this->Rendered = hogelscope::reduced(this->Choice.view);
    this->IsChosen = true;
  }
  catch (const hogelscope::Cancelled&)
  {
    this->Stopped = true;
  }
  catch (const std::exception& error)
  {
    this->ErrorMessage = error.what();
    vtkErrorMacro(<< this->ErrorMessage);
  }
  return this->IsChosen;
}

int vtkHogelViewFilter::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->ErrorMessage.clear();
  this->Stopped = false;
  if (!this->IsChosen && !this->Choose())
  {
    return 0;
  }
  vtkInformation* info = outputVector->GetInformationObject(0);
  const auto [width, height] = this->Rendered.state.camera.res;
  const double scale = this->Choice.view.method.scale;
  const int extent[6] = { 0, width - 1, 0, height - 1, 0, 0 };
  const double spacing[3] = { scale, scale, 1 };
  const double origin[3] = { (scale - 1) / 2, (scale - 1) / 2, 0 };
  info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  // VTK 9.1 keeps what a failed execution was asked for, and asks for the union of both.
  info->Remove(vtkStreamingDemandDrivenPipeline::COMBINED_UPDATE_EXTENT());
  info->Set(vtkDataObject::SPACING(), spacing, 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(
    info, this->FloatOutput ? VTK_FLOAT : VTK_UNSIGNED_CHAR, 3);
  return 1;
}

int vtkHogelViewFilter::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  this->ErrorMessage.clear();
  this->Stopped = false;
  vtkInformation* info = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(info);
  int* extent = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT());
  this->AllocateOutputData(output, info, extent);
  output->GetPointData()->GetScalars()->SetName("View");
  vtkNew<vtkUnsignedCharArray> seen;
  seen->SetName(seenName);
  seen->SetNumberOfValues(output->GetNumberOfPoints());
  output->GetPointData()->AddArray(seen);
  try
  {
    this->Fill(hogelscope::forThreads(this->Progress), output);
  }
  catch (const hogelscope::Cancelled&)
  {
    this->Stopped = true;
  }
  catch (const std::exception& error)
  {
    this->ErrorMessage = error.what();
    vtkErrorMacro(<< this->ErrorMessage);
    return 0;
  }
  return this->Stopped ? 0 : 1;
}

void vtkHogelViewFilter::Fill(const hogelscope::Progress& progress, vtkImageData* output)
{
  const hogelscope::FastSimulation simulation(
    this->Rendered, this->Tables, hogelscope::parallelRows, progress);
  const int first = output->GetExtent()[2];
  const int rows = output->GetExtent()[3] - first + 1;
  const int height = this->Rendered.state.camera.res[1];
  std::atomic<int> done = 0;
  hogelscope::parallelRows(rows,
    [&](int begin, int end)
    {
      for (int row = begin; row < end; ++row)
      {
        if (this->FloatOutput)
        {
          fillRow<float>(simulation, height, output, first + row);
        }
        else
        {
          fillRow<unsigned char>(simulation, height, output, first + row);
        }
        hogelscope::advance(progress, double(++done) / rows);
      }
    });
}

void vtkHogelViewFilter::UpdateOrThrow()
{
  if (this->Stopped || !this->ErrorMessage.empty())
  {
    this->Modified(); // the pipeline takes what a failed execution left for its result
  }
  this->Update();
  if (!this->ErrorMessage.empty())
  {
    throw hogelscope::InputError(this->ErrorMessage, "");
  }
  if (this->Stopped)
  {
    throw hogelscope::Cancelled();
  }
}

hogelscope::Image vtkHogelViewFilter::GetImage()
{
  this->FloatOutputOff();
  this->UpdateOrThrow();
  vtkImageData* output = this->GetOutput();
  const auto [width, height] = this->Rendered.state.camera.res;
  hogelscope::Image image(width, height);
  copyFlipped(output->GetPointData()->GetScalars(), height, image.rgb);
  copyFlipped(output->GetPointData()->GetArray(seenName), height, image.seen);
  const int scale = this->Choice.view.method.scale;
  return scale == 1 ? image : hogelscope::enlarged(image, scale, this->View.state.camera.res);
}

std::vector<float> vtkHogelViewFilter::GetCodeValues()
{
  this->FloatOutputOn();
  this->UpdateOrThrow();
  vtkPointData* output = this->GetOutput()->GetPointData();
  const int height = this->Rendered.state.camera.res[1];
  std::vector<float> values(std::size_t(this->GetOutput()->GetNumberOfPoints()) * 3);
  copyFlipped(output->GetScalars(), height, values);
  const int scale = this->Choice.view.method.scale;
  if (scale == 1)
  {
    return values;
  }
  std::vector<unsigned char> seen(values.size() / 3);
  copyFlipped(output->GetArray(seenName), height, seen);
  return hogelscope::enlarged(values, seen, scale, this->View.state.camera.res);
}

void vtkHogelViewFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "View: " << this->View.state.camera.name << "\n";
  os << indent << "FloatOutput: " << (this->FloatOutput ? "on" : "off") << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
