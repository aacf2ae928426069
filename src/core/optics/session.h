// SPDX-License-Identifier: BSD-3-Clause
// A session, the content of a session document: display, light field and camera states.
#pragma once

#include <string>
#include <vector>

#include "core/light_field/light_field.h"
#include "core/optics/aperture.h"
#include "core/optics/camera.h"
#include "core/optics/distortion.h"
#include "core/optics/optimise_params.h"
#include "core/optics/psf.h"
#include "core/optics/sampling.h"
#include "core/panel/depth_budget.h"
#include "core/panel/display.h"
#include "core/panel/twin_params.h"

namespace hogelscope {

/// One camera of a session.
struct CameraState {
  CameraParams camera;
  IntrinsicsParams intrinsics;
  DistortionParams distortion;
  PsfParams psf;
  PupilParams pupil;
  StereoParams stereo;
  bool operator==(const CameraState&) const = default;
};

/// Visits the parts of a state in the order of documents (SectionVisitor, io/json/sections.h).
template <class Visitor>
void describeParts(Visitor& v, CameraState& state) {
  v.fields(state.camera);
  v.section("intrinsics", state.intrinsics, state.intrinsics.isGiven());
  if (state.intrinsics.isGiven()) v.leaveOut("fov");
  v.optional("pupil", state.pupil);
  v.optional("stereo", state.stereo);
  v.section("distortion", state.distortion);
  v.section("psf", state.psf);
}

struct Session {
  DisplayParams display;
  TwinParams twin;       ///< the unit that is seen
  std::string twinFile;  ///< the document that names it, which must say the same; "": none
  LightFieldParams lightField;
  SamplingParams sampling;
  DepthParams depth;
  OptimiseParams optimise;
  std::vector<std::string> metrics;  ///< plugins whose figures a report also has
  std::vector<CameraState> cameras;
  bool operator==(const Session&) const = default;
};

/// Returns the session with another unit, which no document names. Where that scales or adds light,
/// the light of all states becomes linear.
Session withTwin(Session session, const TwinParams& twin);

/// Checks the rules that join several fields. Throws InputError with the JSON path of the field.
void check(const Session& session);

/// Checks those of them that are about the display and its light field.
void checkLightField(const Session& session);

/// Throws InputError for sampling or a unit that a display whose hogels have one direction, a lens
/// sheet, cannot have; and for leakage, with `path` in front.
void checkWithoutDirections(const SamplingParams& sampling, const TwinParams& twin);
void checkWithoutDirections(const PsfParams& psf, const std::string& path);

/// Checks the rules of one state; paths begin with `path`, such as "cameras[2]".
void check(const CameraState& state, const std::string& path);

/// Returns warnings about values that are allowed but probably not intended, one line for each
/// kind, which begins with the name of the first state concerned.
std::vector<std::string> warnings(const Session& session);

/// Throws InputError if the display is a lens sheet, which `what`, such as "a sweep", does not
/// know.
void requireHogels(const DisplayParams& display, const char* what);

/// Returns the display; hogels and directions that it leaves out are taken from `fromFile`. Throws
/// InputError if both give them and differ.
PanelParams resolved(const PanelParams& display, const LightFieldSize& fromFile);

/// Returns the display with the hogels and directions of `known` where it leaves them out.
PanelParams withCounts(PanelParams display, const DisplayParams& known);

/// Returns the session's display with the viewing distance of its light field. A lens sheet's
/// hogels and directions, which are those of a live scene's views, are left out.
PanelParams displayOf(const Session& session);

}  // namespace hogelscope
