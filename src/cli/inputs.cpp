// SPDX-License-Identifier: BSD-3-Clause
// What the jobs of the command line begin with.
#include "cli/inputs.h"

#include <fnmatch.h>

#include <cmath>
#include <iostream>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/documents/session_file.h"
#include "report/passing_pictures.h"

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

std::size_t pixelBytesOf(const LightFieldFile& file) {
  const LightFieldSize size = file.size();
  return 3 * (memoryBytes(file.type()) / 4) * size.width() * size.height();
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

std::vector<std::filesystem::path> inputsOf(const Options& options,
                                            const LightFieldFile* lightField) {
  std::vector<std::filesystem::path> inputs{options.subject, options.session, options.calibration,
                                            options.calibrations};
  inputs.insert(inputs.end(), options.tests.begin(), options.tests.end());
  if (lightField != nullptr)
    for (const std::filesystem::path& file : lightField->files()) inputs.push_back(file);
  return inputs;
}

Session aroundLightField(const std::string& file, const Options& options) {
  for (const std::string& text : options.overrides)
    if (!text.starts_with("lightField.") && !text.starts_with("display."))
      throw InputError("--set " + text,
                       "does not apply to a light field; lightField and display do");
  return sessionAround(file, options.overrides);
}

std::string readingTime(const LightFieldFile& file) {
  constexpr double bytesPerMinute = 60 * 1.5e9;  // measured: docs/measurements.md
  const double minutes = double(pixelBytesOf(file)) / bytesPerMinute;
  if (minutes < 0.2) return "";
  return ", about " + numberText(std::ceil(minutes)) + " min";
}

void announcePassing(const LightFieldFile& file, std::size_t memory, const Options& options) {
  if (options.quiet || !mustPass(file, memory)) return;
  std::cerr << "hogelscope: " << file.files().front().string() << ": has "
            << bytesText(pixelBytesOf(file)) << " of pixels, " << bytesText(memory)
            << " are allowed: read from the top, all pictures made on the way" << readingTime(file)
            << "\n";
}

}  // namespace hogelscope
