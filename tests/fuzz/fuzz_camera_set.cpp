// SPDX-License-Identifier: BSD-3-Clause
// Fuzzes camera set documents, up to the states that they make.
#include "core/cameras/state_list_edits.h"
#include "io/documents/camera_set_file.h"
#include "tests/fuzz/fuzz.h"

using namespace hogelscope;

void fuzz(std::string_view input) {
  const std::filesystem::path file = fileOf("c.json", input);
  mayRefuse([&] {
    CameraSet set = loadCameraSet(file.string());
    set.params.count = std::min(set.params.count, 100);
    Session session;
    addState(session, inFrontOf(displayOf(session)));
    require(withCameras(session, set).cameras.size() > 1);
  });
}
