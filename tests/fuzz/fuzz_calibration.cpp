// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes OpenCV calibrations, YAML and JSON, and lists of cameras: a session can have what is read.
#include "core/cameras/state_list_edits.h"
#include "io/documents/calibration_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  const std::filesystem::path file = fileOf("k", input);
  mayRefuse([&] { require(!loadCalibrations(file).empty()); });
  mayRefuse([&] {
    CameraState state = inFrontOf({});
    apply(loadCalibration(file), state);
    check(state, "camera");
  });
}
