// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes files of cameras of all formats: a session can have what is read, and COLMAP's images
// beside its cameras.
#include "core/cameras/state_list_edits.h"
#include "io/cameras/camera_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

namespace {

/// Makes states of all cameras that are read.
void readStates(const std::filesystem::path& file) {
  mayRefuse([&] {
    const CameraFile read = readCameraFile(file, CameraUse::poses);
    require(!read.cameras.empty() && isCameraFile(file));
    const CameraState model = inFrontOf({});
    const auto states = statesOf(calibratedCameras(read), model, {}, {model});
    require(states.size() == read.cameras.size());
    for (const CameraState& state : states) check(state, "camera");
  });
}

}  // namespace

void fuzz(std::string_view input) {
  const std::filesystem::path file = fileOf("k", input);
  mayRefuse([&] { require(!loadCalibrations(file).empty()); });
  mayRefuse([&] {
    CameraState state = inFrontOf({});
    apply(loadCalibration(file), state);
    check(state, "camera");
  });
  readStates(file);
  static const std::filesystem::path cameras =
      fileOf("cameras.txt", "1 PINHOLE 640 480 500 500 320 240\n");
  readStates(fileOf("images.dat", input));
}
