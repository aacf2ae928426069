// SPDX-License-Identifier: BSD-3-Clause
// --make-cameras: a set of camera states, added to a copy of a session.
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs/all_jobs.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/documents/camera_set_file.h"
#include "io/documents/session_file.h"
#include "io/files/files_in_use.h"
#include "io/files/folders.h"
#include "io/scene/view_source.h"

namespace hogelscope {

namespace {

void sayWhatWasMade(const CameraSet& set, const Session& before, const Session& after,
                    const std::string& output) {
  const bool isKept = set.params.keepTemplate;
  const std::size_t first = before.cameras.size() - (isKept ? 0 : 1);
  const std::string& model = set.params.templateState.empty() ? before.cameras.front().camera.name
                                                              : set.params.templateState;
  std::cout << after.cameras.size() - first
            << " camera state(s) added: " << after.cameras[first].camera.name << " … "
            << after.cameras.back().camera.name << "; " << after.cameras.size() << " in "
            << printable(output)
            << "\ntheir lens, PSF, resolution and field of view are those of \"" << model << "\", "
            << (isKept ? "which stays (--set cameraSet.keepTemplate=false leaves it out)"
                       : "which is left out")
            << "\n";
}

}  // namespace

int runMakeCameras(const CommandLine& line) {
  const Session session = loadSelected(line);
  const CameraSet set = loadCameraSet(line.subject, line.jobOverrides);
  const Session result = withCameras(session, set);
  const std::string output = line.text("output");
  if (!isSessionFile(output))
    throw InputError(output, "cannot be written", "a session's name ends in .hogelscope or .json");
  std::vector<std::filesystem::path> inputs = filesOf(session);
  inputs.emplace_back(set.traceFile);
  const FilesInUse inUse(inputs);
  makeFolderOf(output);
  saveSession(output, result);
  if (!line.has("quiet")) sayWhatWasMade(set, session, result, output);
  return 0;
}

}  // namespace hogelscope
