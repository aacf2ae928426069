// SPDX-License-Identifier: BSD-3-Clause
#include "cli/inputs.h"

#include <fnmatch.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cli/jobs.h"
#include "cli/terminal.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "io/cameras/camera_file.h"
#include "io/documents/session_file.h"
#include "io/documents/sheet_file.h"
#include "io/documents/twin_file.h"
#include "io/files/folders.h"
#include "io/images/video_writer.h"
#include "io/opening/opening.h"
#include "io/scene/numbered_frames.h"
#include "runs/state_images.h"

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

std::size_t bytesOf(const LightFieldFile& file) {
  return pixelBytes(file.type()) * file.size().width() * file.size().height();
}

void warn(const CommandLine& line, const std::string& warning) {
  if (!line.has("quiet") && !warning.empty())
    printNote(line.text("session") + ": warning: " + warning);
}

/// A new session around a folder, a picture or a mesh, and a line on what is assumed of it.
Session sessionAroundFile(const CommandLine& line) {
  const std::string file = line.text("session");
  ProgressBar bar("looking at the views", line.has("quiet"));
  const auto [session, order, assumed, hogels] =
      orderedSessionAround(file, line.texts("set"), bar.progress());
  bar.done();
  if (line.has("quiet")) return session;
  const LightFieldParams& used = session.lightField;
  std::vector<std::string> warnings = warningsOf(used, order);
  if (isGridOfViews(used.layout)) addFileWarnings(warnings, used, session.display);
  for (const std::string& warning : warnings) warn(line, warning);
  if (!assumed.empty()) printNote(file + ": " + assumed);
  if (isGridOfViews(used.layout))
    printNote(file + ": rows " + nameOf(used.rows) + ", columns " + nameOf(used.columns) + " (" +
              nameOf(order.sureness) + "), shear " + numberText(used.shear[0]) + ", " +
              numberText(used.shear[1]));
  else
    for (const std::string& warning : examine(used, session.display)) warn(line, warning);
  return session;
}

/// The session of a document, with warnings if its pictures contradict it.
Session checkedSession(const CommandLine& line, const std::optional<Calibration>& calibration) {
  Session session = loadSession(line.text("session"), line.texts("set"), calibration);
  const bool areViews = isGridOfViews(session.lightField.layout);
  // Of many shards each would look at all views again; the run without a shard does.
  const bool isShard = line.mayHave("shard") && line.has("shard");
  if (line.has("quiet") || (areViews && isShard)) return session;
  ProgressBar bar("looking at the views", !areViews);
  const auto warnings = examine(session.lightField, session.display, bar.progress());
  bar.done();
  for (const std::string& warning : warnings) warn(line, warning);
  return session;
}

/// Throws InputError for a file of cameras with several lenses.
void requireOneCamera(const std::string& file) {
  const std::vector<std::string> cameras = differingCameras(readCameraFile(file, CameraUse::lens));
  if (cameras.empty()) return;
  constexpr std::size_t most = 12;
  std::string names;
  for (std::size_t k = 0; k < std::min(most, cameras.size()); ++k)
    names += (k == 0 ? "" : ", ") + printable(cameras[k]);
  if (cameras.size() > most) names += ", …";
  throw InputError(file, "has the cameras " + names, "choose one with --camera NAME");
}

/// The camera of --calibration, if the job has it; prints what was guessed of it.
std::optional<Calibration> calibrationOf(const CommandLine& line) {
  if (!line.mayHave("calibration")) return std::nullopt;
  if (!line.has("calibration") && line.has("camera") && line.job->name != "make-cameras")
    throw InputError("--camera " + line.text("camera"),
                     "needs --calibration FILE, of which it is a camera");
  if (!line.has("calibration")) return std::nullopt;
  const std::string file = line.text("calibration");
  if (!line.has("camera")) requireOneCamera(file);
  std::vector<std::string> notes;
  const Calibration calibration = loadCalibration(file, line.text("camera"), &notes);
  if (!line.has("quiet"))
    for (const std::string& note : notes) printNote(file + ": warning: " + note);
  return calibration;
}

/// Says which size is assumed of a calibration's pictures, or how they fit the states.
void warnOfSize(const CommandLine& line, const Calibration& calibration, const Session& session) {
  if (line.has("quiet") || session.cameras.empty()) return;
  const std::string warning = sizeWarning(calibration, session.cameras.front().camera.res);
  if (!warning.empty()) printNote(line.text("calibration") + ": warning: " + warning);
}

}  // namespace

Session loadSessionOf(const CommandLine& line) {
  const std::string file = line.text("session");
  const std::optional<Calibration> calibration = calibrationOf(line);
  const bool isAround = !isSessionDocument(file);
  Session session = isAround ? sessionAroundFile(line) : checkedSession(line, calibration);
  if (isAround && calibration)
    for (CameraState& state : session.cameras) apply(*calibration, state);
  if (calibration) warnOfSize(line, *calibration, session);
  for (const std::string& warning : sheetWarnings(session)) warn(line, warning);
  const bool mayHaveTwin = line.mayHave("twin") && line.has("twin");
  if (!mayHaveTwin || (line.mayHave("against") && line.text("against", "") == "design"))
    return session;
  if (const auto twins = line.texts("twin"); twins.size() > 1)
    throw InputError("command line", "--twin",
                     "is given " + std::to_string(twins.size()) +
                         " times; one unit is seen, and --report --against design compares more");
  return withTwin(session, line.text("twin"), line);
}

Session withTwin(const Session& session, const std::string& file, const CommandLine& line) {
  Session built = session;
  built.twinFile = file;
  built.twin = loadTwin(file);
  std::vector<std::string> changes;
  for (const std::string& change : line.texts("set"))
    if (change.starts_with("twin.")) changes.push_back(change);
  return inFile(file, [&] {
    check(built);
    return overridden(built, changes);
  });
}

std::vector<std::filesystem::path> namedInputs(const CommandLine& line) {
  std::vector<std::filesystem::path> files;
  if (mayNameFile(line.job->value)) files.emplace_back(line.subject);
  for (const std::string& file : line.subjects) files.emplace_back(file);
  for (const Flag& flag : allFlags()) {
    const bool mayGrow = line.job->mayReplaceSession && flag.name == "session";
    if (!flag.isInput || mayGrow || !line.mayHave(flag.name)) continue;
    for (const std::string& file : line.texts(flag.name)) files.emplace_back(file);
  }
  return files;
}

void checkResults(const CommandLine& line, const Session& session,
                  std::vector<std::filesystem::path> files) {
  if (!line.mayHave("save-session") || !line.has("save-session")) return checkOutputs(files);
  const std::string kept = line.text("save-session");
  if (!isSessionFile(kept))
    throw InputError("--save-session " + kept,
                     "cannot be written: a session's name ends in .hogelscope or .json");
  files.emplace_back(kept);
  checkOutputs(files);
  (void)textFor(kept, session);
  makeFolderOf(kept);
}

bool finish(const CommandLine& line, const Session& session) {
  if (line.has("save-session")) saveSession(line.text("save-session"), session);
  return !line.has("quiet");
}

Session loadSelected(const CommandLine& line, const char* ofHogels) {
  const std::string file = line.text("session");
  Session session = loadSessionOf(line);
  session.cameras = selected(session, line.text("states", "*"), file);
  for (const std::string& warning : warnings(session)) warn(line, warning);
  if (ofHogels != nullptr) requireHogels(session.display, ofHogels);
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

std::optional<FrameNumbers> framesOf(const CommandLine& line, const LightFieldFile& lightField) {
  if (!line.has("frames")) return std::nullopt;
  const std::string text = line.text("frames");
  if (lightField.frames().isStill())
    throw InputError("--frames " + text,
                     "the light field is one frame: name several with {T} in lightField.file or "
                     "pattern, or give videos of its views");
  return framesFrom("--frames", text, lightField.frames());
}

void warnOfFrames(const CommandLine& line, const FrameNumbers& listed) {
  if (listed.isStill() || line.has("quiet")) return;
  printNote("warning: of " + std::to_string(listed.count()) + " frames the first one, " +
            std::to_string(listed.first) + ", is used" +
            (line.mayHave("frames") ? "; --frames all uses all"
                                    : "; lightField.frames=[first,last] lists others"));
}

std::vector<FrameOutput> outputsOfFrames(const CommandLine& line,
                                         const LightFieldFile& lightField) {
  const std::string output = line.text("output");
  const FrameNumbers listed = lightField.frames();
  const bool isNamed = output.find(frameMark) != std::string::npos;
  if (isNamed && listed.isStill())
    throw InputError("--output " + output, "has {T}, but the light field is one frame");
  const std::optional<FrameNumbers> chosen = framesOf(line, lightField);
  if (!chosen && !isNamed) {
    warnOfFrames(line, listed);
    return {{listed.first, output}};
  }
  const FrameNumbers frames = chosen.value_or(listed);
  if (!isNamed && frames.count() > 1 && !isVideoName(output))
    throw InputError("--output " + output, "is one name for " + std::to_string(frames.count()) +
                                               " frames: put {T} into it, where the number of the "
                                               "frame is to be");
  std::vector<FrameOutput> outputs;
  for (std::size_t k = 0; k < frames.count(); ++k) {
    const int frame = frames.number(k);
    outputs.push_back({frame, withFrame(output, frameDigits(frame, listed))});
  }
  return outputs;
}

std::vector<FrameState> statesInTime(const CommandLine& line, const Input& input) {
  const FrameNumbers listed = input.file->frames();
  const std::optional<FrameNumbers> chosen = framesOf(line, *input.file);
  const std::vector<CameraState>& states = input.session.cameras;
  const bool haveAllTimes = std::ranges::none_of(
      states, [](const CameraState& state) { return state.camera.time == notGiven; });
  if (chosen && haveAllTimes)
    throw InputError("--frames " + line.text("frames"),
                     "all states have a time, which chooses their frame: leave out --frames");
  if (!chosen && !haveAllTimes) warnOfFrames(line, listed);
  const FrameNumbers first{listed.first, listed.first, 1};
  return inFile(line.text("session"), [&] {
    return statesAtFrames(states, chosen.value_or(first), listed,
                          frameRateOf(input.session.lightField, *input.file));
  });
}

void keepShard(std::vector<FrameState>& states, const Shard& shard) {
  std::vector<int> frames;
  for (const FrameState& state : states)
    if (frames.empty() || frames.back() != state.frame) frames.push_back(state.frame);
  std::vector<FrameState> own;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const auto frame = std::size_t(std::ranges::find(frames, states[k].frame) - frames.begin());
    const bool isOwn =
        frames.size() < 2 ? shard.has(k) : frame * shard.count / frames.size() == shard.number - 1;
    if (isOwn) own.push_back(states[k]);
  }
  states = std::move(own);
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

void warnOfPupils(const PanelParams& display, const Session& session, const CommandLine& line) {
  for (const CameraState& state : session.cameras) {
    const Aperture aperture = apertureOf(state.pupil, state.camera, display);
    if (state.pupil.samples == 0 && aperture.wanted > Aperture::mostSamples)
      warn(line, state.camera.name + ": pupil: the display needs " +
                     std::to_string(aperture.wanted) + " samples; " +
                     std::to_string(Aperture::mostSamples) + " are taken");
  }
}

ViewSource unloadedOf(const Session& session, const LightFieldFile& lightField,
                      const CommandLine& line) {
  ProgressBar stop("", true);
  ViewSource source = unloadedViewSource(session, lightField, stop.progress());
  for (const std::string& warning : source.warnings)
    if (!line.has("quiet")) printNote("warning: " + warning);
  return source;
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
  constexpr double bytesPerMinute = 60 * 1.5e9;  // measured: docs/measurements.md
  const double minutes = double(bytesOf(file)) / bytesPerMinute;
  if (minutes < 0.2) return "";
  return ", about " + numberText(std::ceil(minutes)) + " min";
}

void announceStreaming(const LightFieldFile& file, std::size_t memory, bool isQuiet) {
  if (isQuiet || !mustStream(file, memory)) return;
  printNote(file.files().front().string() + ": has " + bytesText(bytesOf(file)) + " of pixels, " +
            bytesText(memory) + " are allowed: read from the top, all pictures made on the way" +
            readingTimeText(file));
}

}  // namespace hogelscope
