// SPDX-License-Identifier: BSD-3-Clause
// Input sessions and light fields of the jobs.
#include "cli/inputs.h"

#include <fnmatch.h>

#include <charconv>
#include <cmath>

#include "campaign/streamed_images.h"
#include "cli/notes.h"
#include "cli/progress_bar.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/documents/session_file.h"
#include "io/files/folders.h"
#include "io/files/output_folder.h"
#include "io/layouts/lenslet_picture.h"

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

void warn(const CommandLine& line, const std::string& warning) {
  if (!line.has("quiet") && !warning.empty())
    printNote(line.text("session") + ": warning: " + warning);
}

/// Prints a warning if the lenslets are not on a regular grid.
void checkLenslets(const CommandLine& line, const Session& session) {
  if (line.has("quiet") || session.lightField.layout != Layout::lenslets) return;
  warn(line, warningOf(session.lightField, lensletsOf(session.lightField, session.display)));
}

/// Returns a new session for a folder, an image or a mesh, and prints the assumptions about it.
Session sessionAroundFile(const CommandLine& line) {
  ProgressBar bar("looking at the views", line.has("quiet"));
  const OrderedSession around =
      orderedSessionAround(line.text("session"), line.texts("set"), bar.progress());
  bar.done();
  const LightFieldParams& used = around.session.lightField;
  for (const std::string& warning : around.order.warnings) warn(line, warning);
  warn(line, contradictionOf(used, around.order));
  if (!line.has("quiet") && !around.assumed.empty())
    printNote(line.text("session") + ": " + around.assumed);
  if (!line.has("quiet") && isGridOfViews(used.layout))
    printNote(line.text("session") + ": rows " + nameOf(used.rows) + ", columns " +
              nameOf(used.columns) + " (" + nameOf(around.order.sureness) + "), shear " +
              numberText(used.shear[0]) + ", " + numberText(used.shear[1]));
  checkLenslets(line, around.session);
  return around.session;
}

/// Returns the session of a document, and prints a warning if its views are in another order.
Session checkedSession(const CommandLine& line, const std::optional<Calibration>& calibration) {
  Session session = loadSession(line.text("session"), line.texts("set"), calibration);
  checkLenslets(line, session);
  // Shards skip this check of all views, which the run without a shard does.
  const bool isShard = line.mayHave("shard") && line.has("shard");
  if (line.has("quiet") || isShard || !isGridOfViews(session.lightField.layout)) return session;
  ProgressBar bar("looking at the views", false);
  const LightFieldOrder order =
      findLightFieldOrder(session.lightField, session.display, bar.progress());
  bar.done();
  for (const std::string& warning : order.warnings) warn(line, warning);
  warn(line, contradictionOf(session.lightField, order));
  return session;
}

}  // namespace

bool isSessionDocument(const std::string& file) {
  return isSessionFile(file) && !isFolder(file);
}

Session loadSessionOf(const CommandLine& line) {
  const std::string file = line.text("session");
  std::optional<Calibration> calibration;
  if (line.mayHave("calibration") && line.has("calibration"))
    calibration = loadCalibration(line.text("calibration"));
  const bool isAround = !isSessionDocument(file);
  Session session = isAround ? sessionAroundFile(line) : checkedSession(line, calibration);
  if (isAround && calibration)
    for (CameraState& state : session.cameras) apply(*calibration, state);
  return session;
}

void keepSession(const CommandLine& line, const Session& session) {
  if (!line.has("save-session")) return;
  const std::string file = line.text("save-session");
  if (!isSessionFile(file))
    throw InputError("--save-session " + file,
                     "cannot be written: a session's name ends in .hogelscope or .json");
  checkOutputs({file}, {contentName(session.lightField)});
  makeFolderOf(file);
  saveSession(file, session);
}

Session loadSelected(const CommandLine& line) {
  const std::string file = line.text("session");
  Session session = loadSessionOf(line);
  session.cameras = selected(session, line.text("states", "*"), file);
  for (const std::string& warning : warnings(session)) warn(line, warning);
  return session;
}

std::optional<Shard> shardOf(const CommandLine& line) {
  if (!line.has("shard")) return std::nullopt;
  const std::string text = line.text("shard");
  const char* const end = text.data() + text.size();
  Shard shard;
  const auto [slash, wrong] = std::from_chars(text.data(), end, shard.number);
  const bool hasCount = wrong == std::errc() && slash != end && *slash == '/';
  const auto [last, error] = std::from_chars(hasCount ? slash + 1 : end, end, shard.count);
  if (!hasCount || error != std::errc() || last != end || shard.number < 1 ||
      shard.number > shard.count)
    throw InputError("--shard " + text, "must be K/N, such as 2/8, with 1 ≤ K ≤ N");
  return shard;
}

void warnOf(const LightFieldFile& lightField, const std::string& name, const CommandLine& line) {
  if (line.has("quiet")) return;
  for (const std::string& warning : lightField.warnings())
    printNote(name + ": warning: " + warning);
}

void warnOfCuts(const LightFieldFile& lightField, const Session& session, const CommandLine& line) {
  if (!line.has("quiet") && !session.cameras.empty() && !isSessionDocument(line.text("session")))
    warn(line, lightField.cutWarning(session.cameras.front()));
}

std::vector<std::filesystem::path> inputFiles(std::vector<std::filesystem::path> others,
                                              const Session& session,
                                              const LightFieldFile& lightField) {
  for (const std::string& file : session.display.lensParams.files()) others.emplace_back(file);
  for (const std::filesystem::path& file : lightField.files()) others.push_back(file);
  return others;
}

OrderedSession sessionAroundSubject(const CommandLine& line) {
  for (const std::string& text : line.texts("set"))
    if (!text.starts_with("lightField.") && !text.starts_with("display."))
      throw InputError("--set " + text,
                       "does not apply to a light field; lightField and display do");
  ProgressBar bar("looking at the views", line.mayHave("quiet") && line.has("quiet"));
  OrderedSession around = orderedSessionAround(line.subject, line.texts("set"), bar.progress());
  bar.done();
  return around;
}

std::string readingTimeText(const LightFieldFile& file) {
  constexpr double bytesPerMinute = 60 * 1.5e9;  // measured, see docs/measurements.md
  const double minutes = double(pixelBytes(file)) / bytesPerMinute;
  if (minutes < 0.2) return "";
  return ", about " + numberText(std::ceil(minutes)) + " min";
}

void announceStreaming(const LightFieldFile& file, std::size_t memory, bool isQuiet) {
  if (isQuiet || !mustStream(file, memory)) return;
  printNote(file.files().front().string() + ": has " + bytesText(pixelBytes(file)) +
            " of pixels, " + bytesText(memory) +
            " are allowed: read from the top, all pictures made on the way" +
            readingTimeText(file));
}

}  // namespace hogelscope
