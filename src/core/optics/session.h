// SPDX-License-Identifier: BSD-3-Clause
// A session: display, light field and camera states; what a session document holds.
#pragma once

#include <string>
#include <vector>

#include "core/light_field/light_field.h"
#include "core/optics/camera.h"
#include "core/optics/display.h"
#include "core/optics/distortion.h"
#include "core/optics/psf.h"
#include "core/optics/sampling.h"

namespace hogelscope {

/// One camera of a session.
struct CameraState {
  CameraParams camera;
  IntrinsicsParams intrinsics;
  DistortionParams distortion;
  PsfParams psf;
  bool operator==(const CameraState&) const = default;
};

struct Session {
  DisplayParams display;
  LightFieldParams lightField;
  SamplingParams sampling;
  std::vector<CameraState> cameras;
  bool operator==(const Session&) const = default;
};

/// The rules that join several fields. Throws InputError with the JSON path of the field to change.
void check(const Session& session);

/// The rules of one state; paths begin with `path`, such as "cameras[2]".
void check(const CameraState& state, const std::string& path);

/// What is allowed but probably not meant: a line for each kind, which begins with the state's
/// name, or the first one's of several.
std::vector<std::string> warnings(const Session& session);

/// Takes what `fromFile` says where the display leaves hogels or directions out. Throws InputError
/// where both say it and differ.
DisplayParams resolved(const DisplayParams& display, const LightFieldSize& fromFile);

}  // namespace hogelscope
