// SPDX-License-Identifier: BSD-3-Clause
// --make-cameras: a set of camera states, added to a copy of a session.
#include <iostream>

#include "cli/inputs.h"
#include "cli/jobs.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_file.h"
#include "io/documents/camera_set_file.h"
#include "io/documents/session_file.h"
#include "io/files/folders.h"

namespace hogelscope {

namespace {

void sayWhatWasMade(const CameraSet& set, const Session& before, const Session& after,
                    const std::string& output) {
  const bool isKept = set.params.keepTemplate;
  const bool isOfFile = std::holds_alternative<CalibratedCameras>(set.source);
  const std::size_t first = before.cameras.size() - (isKept ? 0 : 1);
  const std::string& model = set.params.templateState.empty() ? before.cameras.front().camera.name
                                                              : set.params.templateState;
  std::cout << after.cameras.size() - first
            << " camera state(s) added: " << after.cameras[first].camera.name << " … "
            << after.cameras.back().camera.name << "; " << after.cameras.size() << " in "
            << printable(output) << "\ntheir "
            << (isOfFile ? "lens, intrinsics and size are the file's, the rest is that of \""
                         : "lens, PSF, resolution and field of view are those of \"")
            << model << "\", "
            << (isKept ? "which stays (--set cameraSet.keepTemplate=false leaves it out)"
                       : "which is left out")
            << "\n";
}

/// Says what was guessed of a file, and which size is assumed of cameras that do not say it.
void sayGuesses(const CameraSet& set, const Session& after) {
  for (const std::string& note : set.notes) printNote(set.traceFile + ": " + note);
  if (set.keepsTimes)
    printNote(set.traceFile +
              ": each sample is a state with a time, since the light field has several frames; "
              "cameraSet.place is left aside");
  const auto* const file = std::get_if<CalibratedCameras>(&set.source);
  if (file == nullptr) return;
  const std::size_t first = after.cameras.size() - file->cameras.size();
  for (std::size_t k = 0; k < file->cameras.size(); ++k) {
    const CameraParams& camera = after.cameras[first + k].camera;
    const std::string warning = sizeWarning(file->cameras[k].calibration, camera.res);
    if (warning.empty()) continue;
    return printNote(set.traceFile + ": warning: " + camera.name + " " + warning);
  }
}

int runMakeCameras(const CommandLine& line) {
  const Session session = loadSelected(line);
  const std::string camera = line.has("calibration") ? "" : line.text("camera");
  CameraSet set = loadCameraSet(line.subject, line.jobOverrides, camera);
  set.keepsTimes = std::holds_alternative<Trace>(set.source) && isInTime(session);
  if (!camera.empty() && !std::holds_alternative<CalibratedCameras>(set.source))
    throw InputError("--camera " + camera, line.subject + " is no file of cameras");
  const Session result = withCameras(session, set);
  if (!line.has("quiet")) sayGuesses(set, result);
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

}  // namespace

Job cameraJob() {
  return {
      .name = "make-cameras",
      .value = "uniform|random|normal|FILE",
      .help =
          "Adds camera states to a copy of the session: uniform (a grid), random or normal "
          "over a region, a distribution of your own, a viewer's trace, or the cameras of a file.",
      .details =
          "--output may be the session itself. With --states only those of the session's "
          "states are kept. What a FILE is, is told by what is in it: a camera set, a trace, or "
          "cameras of OpenCV, ROS, Kalibr, transforms.json, COLMAP or glTF, with their places.",
      .examples =
          "  hogelscope --make-cameras uniform --session s.json --count 15 --region arc \\\n"
          "             --output arc.json\n"
          "  hogelscope --make-cameras random --session s.json --count 200 --seed 7 \\\n"
          "             --set cameraRegion.lookat=nearest --output random.json\n"
          "  hogelscope --make-cameras trace.csv --session s.json --count 600 --output "
          "viewer.json\n"
          "  hogelscope --make-cameras transforms.json --session s.json \\\n"
          "             --set cameraSet.scale=0.1 --output capture.json\n"
          "  hogelscope --make-cameras viewer.json --session s.json --set trace.only=I01P2R3 \\\n"
          "             --output seen.json\n",
      .sections = {"cameraSet", "cameraRegion", "trace"},
      .needs = {"session", "output"},
      .takes = {"set", "states", "calibration", "plugins-path", "seed", "quiet"},
      .own = {{.name = "count",
               .value = "N",
               .heading = "Making camera states and test light fields",
               .after = "rate",
               .shortFor = "cameraSet.count",
               .help = "States to add; short for --set cameraSet.count=N."},
              {.name = "region",
               .value = "box|plane|arc",
               .shortFor = "cameraRegion.region",
               .help = "Where the cameras stand; short for --set cameraRegion.region=…."}},
      .mayReplaceSession = true,
      .run = runMakeCameras};
}

}  // namespace hogelscope
