// SPDX-License-Identifier: BSD-3-Clause
// The rules of a session that join several fields.
#include "core/optics/session.h"

#include <algorithm>
#include <cstdio>
#include <map>

#include "core/base/error.h"
#include "core/base/plugin_params.h"
#include "core/base/text.h"
#include "core/optics/eyes.h"
#include "core/optics/state_name.h"

namespace hogelscope {

namespace {

std::string statePath(std::size_t index) {
  return "cameras[" + std::to_string(index) + "]";
}

/// Throws if a state's files would be those of an eye of another state.
void checkEyeNames(const std::vector<CameraState>& states,
                   const std::map<std::u32string, std::size_t>& places) {
  for (const CameraState& head : states) {
    if (!hasTwoEyes(head)) continue;
    for (const Eye eye : {Eye::left, Eye::right}) {
      const std::string file = head.camera.name + "." + std::string(nameOf(eye));
      const auto same = places.find(caseFolded(file));
      if (same != places.end())
        throw InputError(statePath(same->second) + ".name",
                         "\"" + states[same->second].camera.name + "\" names the file of the " +
                             std::string(nameOf(eye)) + " eye of \"" + head.camera.name +
                             "\": give it another name");
    }
  }
}

/// Throws if the state's light cannot be scaled or added to as the twin does.
void checkLight(const CameraState& state, const TwinParams& twin, const std::string& path) {
  if (twin.changesLight() && state.psf.light != LightModel::linear)
    throw InputError(path + ".psf.light",
                     "must be \"linear\", because the twin scales or adds light");
}

/// Throws if a state's pupil is focused on the panel, which its axis does not meet.
void checkFocus(const CameraState& state, const DisplayParams& display, const std::string& path) {
  const PupilParams& pupil = state.pupil;
  if (pupil.diameter > 0 && !(pupil.focus > 0) && !(axisDistance(state.camera, display) > 0))
    throw InputError(path + ".pupil.focus", noFocusOnPanel);
}

void checkMetrics(const std::vector<std::string>& names) {
  for (auto name = names.begin(); name != names.end(); ++name) {
    const std::string path = "metrics[" + std::to_string(name - names.begin()) + "]";
    checkPluginName(*name, path);
    if (std::find(names.begin(), name, *name) != name)
      throw InputError(path, "\"" + *name + "\" stands twice in the list");
  }
}

/// Throws unless content is what a lens sheet shows, if the display is one.
void checkSheetContent(const LightFieldParams& content, const DisplayParams& display) {
  if (!display.sheet) {
    if (content.calibration)
      throw InputError("lightField.calibration",
                       "is for a lens sheet: a display of kind \"sheet\"");
    return;
  }
  if (content.viewingDistance != notGiven)
    throw InputError("lightField.viewingDistance",
                     "is for a display of hogels: a lens sheet has display.viewingDistance");
  const bool isWoven = content.layout == Layout::woven;
  if (content.layout != Layout::quilt && !isWoven && !content.isLive())
    throw InputError("lightField.layout",
                     "must be \"quilt\", \"woven\" or \"live\" for a lens sheet");
  if (content.calibration && isWoven)
    throw InputError("lightField.calibration",
                     "is for views: the panel's picture is woven already");
  const auto panel = display.sheet->calibration.params.panel;
  if (content.calibration && content.calibration->params.panel != panel)
    throw InputError("lightField.calibration.panel",
                     "is not the display's, " + pairText(panel[0], panel[1]) + " px");
  if (!content.isLive() && display.hogels[0] > 0)
    throw InputError("display.hogels",
                     "is of a live scene's views: for a lens sheet the file says it");
  if (content.isLive() && display.directions[1] > 1)
    throw InputError("display.directions", "must be one row of views for a lens sheet: [" +
                                               std::to_string(display.directions[0]) + ", 1]");
}

}  // namespace

Session withTwin(Session session, const TwinParams& twin) {
  session.twin = twin;
  session.twinFile.clear();
  if (twin.changesLight())
    for (CameraState& state : session.cameras) state.psf.light = LightModel::linear;
  return session;
}

void check(const CameraState& state, const std::string& path) {
  checkStateName(state.camera.name, path);
  try {
    const Camera camera(state.camera);
  } catch (const InputError& error) {
    throw InputError(path + "." + error.what(), "");
  }
  const auto& [fx, fy, cx, cy] = state.intrinsics;
  if ((fx != notGiven && !(fx > 0)) || (fy != notGiven && !(fy > 0)))
    throw InputError(path + ".intrinsics.fx", "and fy are focal lengths, above 0 px");
  if (!state.intrinsics.isGiven() && state.intrinsics != IntrinsicsParams{})
    throw InputError(path + ".intrinsics.fx", "is missing: intrinsics need at least fx, in pixels");
  if (state.psf.windowSize > 1 && !(state.psf.sigma > 0))
    throw InputError(path + ".psf.sigma",
                     "is 0 with a windowSize of " + std::to_string(state.psf.windowSize) +
                         ": give a sigma above 0, or windowSize 1 for no leakage");
}

void checkWithoutDirections(const SamplingParams& sampling, const TwinParams& twin) {
  if (sampling.reconstruction != Reconstruction::nearest)
    throw InputError("sampling.reconstruction",
                     "must be \"nearest\" for a lens sheet, whose pixels are not interpolated");
  if (!isOfSheet(twin))
    throw InputError("twin",
                     "has errors that a lens sheet cannot have: give offset, rotation, pitchError "
                     "and gapError of lensArray alone");
}

void checkWithoutDirections(const PsfParams& psf, const std::string& path) {
  if (psf.windowSize > 1)
    throw InputError(path + "psf.windowSize",
                     "must be 1 for a lens sheet, whose pixels have no directions to leak into");
}

void checkLightField(const Session& session) {
  checkSheetContent(session.lightField, session.display);
  if (!hasDirections(session.display)) {
    checkWithoutDirections(session.sampling, session.twin);
    for (std::size_t index = 0; index < session.cameras.size(); ++index)
      checkWithoutDirections(session.cameras[index].psf, statePath(index) + ".");
  }
  const bool isLive = session.lightField.isLive();
  if (isLive && session.lightField.source.empty())
    throw InputError("lightField.source", "is missing: name what computes the content");
  if (isLive && !session.lightField.file.empty())
    throw InputError("lightField.file",
                     "is not of a live light field: its source has a file of its own");
  if (const auto& [back, front] = session.lightField.live.depth; !(back < front))
    throw InputError("lightField." + session.lightField.source + ".depth",
                     "begins in front of its end: give the back first, then the front");
  if (!isLive && session.lightField.file.empty())
    throw InputError("lightField.file", "is missing: name the image or folder to show");
  for (const auto& [name, pair] : {std::pair("display.hogels", session.display.hogels),
                                   std::pair("display.directions", session.display.directions)})
    if ((pair[0] > 0) != (pair[1] > 0))
      throw InputError(name, "has one number only: give both, across and down, or neither");
  const bool given = session.display.hogels[0] > 0 && session.display.directions[0] > 0;
  if ((isLive || session.lightField.layout == Layout::hogels) && !given)
    throw InputError(
        session.display.hogels[0] > 0 ? "display.directions" : "display.hogels",
        std::string("is missing: a ") + (isLive ? "scene" : "hogel image") + " does not say it");
}

void check(const Session& session) {
  checkLightField(session);
  checkMetrics(session.metrics);
  if (session.cameras.empty())
    throw InputError("cameras", "is empty: give at least one camera state");
  std::map<std::u32string, std::size_t> seen;
  for (std::size_t index = 0; index < session.cameras.size(); ++index) {
    const CameraState& state = session.cameras[index];
    check(state, statePath(index));
    checkFocus(state, session.display, statePath(index));
    checkLight(state, session.twin, statePath(index));
    const auto [first, isNew] = seen.emplace(caseFolded(state.camera.name), index);
    if (isNew) continue;
    const std::string& other = session.cameras[first->second].camera.name;
    throw InputError(statePath(index) + ".name",
                     "\"" + state.camera.name + "\" is also " + statePath(first->second) +
                         (other == state.camera.name ? "" : ", \"" + other + "\"") +
                         "; every state has a name of its own" +
                         (other == state.camera.name ? "" : ", whatever its case"));
  }
  checkEyeNames(session.cameras, seen);
}

std::vector<std::string> warnings(const Session& session) {
  std::map<std::string, std::vector<std::string>> statesOf;
  for (const CameraState& state : session.cameras) {
    if (!cutsTooMuch(state.psf)) continue;
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(),
                  "psf: a window of %d keeps %.1f %% of the Gaussian of sigma %g; widen it",
                  state.psf.windowSize, 100 * energyInWindow(state.psf), state.psf.sigma);
    statesOf[text.data()].push_back(state.camera.name);
  }
  std::vector<std::string> lines;
  for (const auto& [what, states] : statesOf) {
    const std::size_t others = states.size() - 1;
    lines.push_back(states.front() +
                    (others == 0 ? "" : " and " + std::to_string(others) + " more") + ": " + what);
  }
  return lines;
}

void requireHogels(const DisplayParams& display, const char* what) {
  if (!hasDirections(display))
    throw InputError("display.kind", std::string("is \"sheet\", which ") + what + " does not know");
}

PanelParams displayOf(const Session& session) {
  PanelParams display{session.display, session.lightField.viewingDistance};
  if (!hasDirections(display))
    display.hogels = display.directions = {0, 0};  // they are of its views
  return display;
}

PanelParams resolved(const PanelParams& display, const LightFieldSize& fromFile) {
  const auto agree = [](std::array<int, 2> given, std::array<int, 2> found, const char* what) {
    if (given[0] > 0 && given != found)
      throw InputError(what, "is " + pairText(given[0], given[1]) +
                                 ", but the light field's file has " +
                                 pairText(found[0], found[1]));
    return found;
  };
  PanelParams result = display;
  result.hogels = agree(display.hogels, {fromFile.nx, fromFile.ny}, "display.hogels");
  result.directions = agree(display.directions, {fromFile.du, fromFile.dv}, "display.directions");
  return result;
}

PanelParams withCounts(PanelParams display, const DisplayParams& known) {
  for (const auto counts : {&PanelParams::hogels, &PanelParams::directions})
    for (const std::size_t axis : {0, 1})
      if (int& count = (display.*counts)[axis]; count < 1) count = (known.*counts)[axis];
  return display;
}

}  // namespace hogelscope
