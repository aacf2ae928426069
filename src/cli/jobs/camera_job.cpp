// SPDX-License-Identifier: BSD-3-Clause
// --make-cameras: a set of camera states, added to a copy of a session.
#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs/all_jobs.h"
#include "core/base/error.h"
#include "io/documents/camera_set_file.h"
#include "io/documents/session_file.h"
#include "io/files/output_folder.h"

namespace hogelscope {

int runMakeCameras(const CommandLine& line) {
  const Session session = loadSelected(line);
  const Session result = withCameras(session, loadCameraSet(line.subject, line.jobOverrides));
  const std::string output = line.text("output");
  if (!isSessionFile(output))
    throw InputError(output, "cannot be written", "a session's name ends in .json");
  // The session itself may be replaced by the one with more states; nothing that it reads may.
  checkOutputs({output}, {line.subject, line.text("calibration"), contentName(session.lightField)});
  makeFolderOf(output);
  saveSession(output, result);
  if (!line.has("quiet"))
    std::cout << result.cameras.size() - session.cameras.size()
              << " camera state(s) added: " << result.cameras[session.cameras.size()].camera.name
              << " … " << result.cameras.back().camera.name << "; " << result.cameras.size()
              << " in " << output << "\n";
  return 0;
}

}  // namespace hogelscope
