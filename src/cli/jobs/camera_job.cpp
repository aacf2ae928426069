// SPDX-License-Identifier: BSD-3-Clause
// --make-cameras: a set of camera states, added to a copy of a session.
#include "cli/jobs/camera_job.h"

#include <filesystem>
#include <iostream>

#include "cli/inputs.h"
#include "core/base/error.h"
#include "io/documents/camera_set_file.h"
#include "io/documents/session_file.h"
#include "io/files/output_folder.h"

namespace hogelscope {

int makeCameras(const Options& options) {
  const Session session = loadSelected(options);
  const Session result = withCameras(session, loadCameraSet(options.subject, options.jobOverrides));
  if (!isSessionFile(options.output))
    throw InputError(options.output, "cannot be written", "a session's name ends in .json");
  // The session itself may be replaced by the one with more states; nothing that it reads may.
  checkOutputs({options.output}, {options.subject, options.calibration, session.lightField.file});
  makeFolderOf(options.output);
  saveSession(options.output, result);
  if (!options.quiet)
    std::cout << result.cameras.size() - session.cameras.size()
              << " camera state(s) added: " << result.cameras[session.cameras.size()].camera.name
              << " … " << result.cameras.back().camera.name << "; " << result.cameras.size()
              << " in " << options.output << "\n";
  return 0;
}

}  // namespace hogelscope
