// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHogelSessionView.h"

#include <vtkObjectFactory.h>

#include <algorithm>

#include "core/base/error.h"
#include "io/documents/session_file.h"
#include "io/scene/view_source.h"

vtkStandardNewMacro(vtkHogelSessionView);

namespace
{
const hogelscope::CameraState& stateOf(
  const hogelscope::Session& session, const std::string& file, const std::string& name)
{
  const auto found = std::find_if(session.cameras.begin(), session.cameras.end(),
    [&](const hogelscope::CameraState& state) { return state.camera.name == name; });
  if (found == session.cameras.end())
  {
    throw hogelscope::InputError(file, "has no camera state \"" + name + "\"");
  }
  return *found;
}
}

bool vtkHogelSessionView::SetSession(const std::string& file, const std::string& state)
{
  try
  {
    const hogelscope::Session session = hogelscope::loadSession(file);
    const hogelscope::CameraState& wanted = stateOf(session, file, state);
    this->SetJob(hogelscope::loadViewSource(session, {}).job(wanted));
    return true;
  }
  catch (const std::exception& error)
  {
    this->Fail(error);
    return false;
  }
}

void vtkHogelSessionView::SetEye(double x, double y, double z)
{
  hogelscope::RenderJob job = this->GetJob();
  job.state.camera.eye = { x, y, z };
  this->SetJob(job);
}
