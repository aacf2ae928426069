// SPDX-License-Identifier: BSD-3-Clause
// What the jobs of the command line begin with.
#include "cli/inputs.h"

#include <fnmatch.h>

#include <iostream>

#include "core/error.h"
#include "io/session_file.h"

namespace hogelscope {

namespace {

std::vector<CameraState> selected(const Session& session, const std::string& glob,
                                  const std::string& file) {
  std::vector<CameraState> states;
  std::string names;
  for (const CameraState& state : session.cameras) {
    if (::fnmatch(glob.c_str(), state.camera.name.c_str(), 0) == 0) states.push_back(state);
    names += (names.empty() ? "" : ", ") + state.camera.name;
  }
  constexpr std::size_t longest = 200;
  if (names.size() > longest) names = names.substr(0, longest) + "…";
  if (states.empty())
    throw InputError(file, "--states " + glob, "fits none of the states: " + names);
  return states;
}

}  // namespace

Session loadSelected(const Options& options) {
  std::optional<Calibration> calibration;
  if (!options.calibration.empty()) calibration = loadCalibration(options.calibration);
  Session session = loadSession(options.session, options.overrides, calibration);
  session.cameras = selected(session, options.states, options.session);
  if (!options.quiet)
    for (const std::string& line : warnings(session))
      std::cerr << "hogelscope: " << options.session << ": warning: " << line << "\n";
  return session;
}

}  // namespace hogelscope
