// SPDX-License-Identifier: BSD-3-Clause
// The sessions and light fields that the jobs of the command line begin with.
#include "cli/inputs.h"

#include <fnmatch.h>

#include <cmath>
#include <iostream>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/documents/session_file.h"
#include "report/streamed_images.h"

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

std::size_t pixelBytes(const LightFieldFile& file) {
  const LightFieldSize size = file.size();
  return 3 * (memoryBytes(file.type()) / 4) * size.width() * size.height();
}

}  // namespace

Session loadSelected(const CommandLine& line) {
  const std::string file = line.text("session");
  std::optional<Calibration> calibration;
  if (line.has("calibration")) calibration = loadCalibration(line.text("calibration"));
  Session session = loadSession(file, line.texts("set"), calibration);
  session.cameras = selected(session, line.text("states", "*"), file);
  if (!line.has("quiet"))
    for (const std::string& warning : warnings(session))
      std::cerr << "hogelscope: " << file << ": warning: " << warning << "\n";
  return session;
}

std::vector<std::filesystem::path> inputFiles(std::vector<std::filesystem::path> others,
                                              const Session& session,
                                              const LightFieldFile& lightField) {
  for (const std::string& file : session.display.lensParams.files()) others.emplace_back(file);
  for (const std::filesystem::path& file : lightField.files()) others.push_back(file);
  return others;
}

Session sessionAroundSubject(const CommandLine& line) {
  for (const std::string& text : line.texts("set"))
    if (!text.starts_with("lightField.") && !text.starts_with("display."))
      throw InputError("--set " + text,
                       "does not apply to a light field; lightField and display do");
  return sessionAround(line.subject, line.texts("set"));
}

std::string readingTimeText(const LightFieldFile& file) {
  constexpr double bytesPerMinute = 60 * 1.5e9;  // measured: docs/measurements.md
  const double minutes = double(pixelBytes(file)) / bytesPerMinute;
  if (minutes < 0.2) return "";
  return ", about " + numberText(std::ceil(minutes)) + " min";
}

void announcePassing(const LightFieldFile& file, std::size_t memory, bool isQuiet) {
  if (isQuiet || !mustPass(file, memory)) return;
  std::cerr << "hogelscope: " << file.files().front().string() << ": has "
            << bytesText(pixelBytes(file)) << " of pixels, " << bytesText(memory)
            << " are allowed: read from the top, all pictures made on the way"
            << readingTimeText(file) << "\n";
}

}  // namespace hogelscope
