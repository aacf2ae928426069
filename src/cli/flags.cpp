// SPDX-License-Identifier: BSD-3-Clause
#include "cli/flags.h"

#include <algorithm>
#include <charconv>
#include <iterator>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/optics/stereo_image.h"

namespace hogelscope {

namespace {

template <class Number>
bool isNumberIn(const NumberRange& range, const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && double(value) >= range.min &&
         double(value) <= range.max;
}

using enum Command;

/// The jobs that use a session's camera states.
const std::vector<Command> onStates{render, report, makeCameras, tradeoff, measure, sweep, depth};
/// The jobs that write files.
const std::vector<Command> writing{render,   report,   makeCameras, makeTwin, generate, pack,
                                   exportAs, tradeoff, stability,   measure,  sweep,    depth};

FlagGroup inputs() {
  return {
      "What is read",
      {{.name = "session",
        .value = "FILE",
        .jobs = {render, report, makeCameras, makeTwin, generate, pack, exportAs, tradeoff, measure,
                 sweep, depth},
        .neededBy = {render, report, makeCameras, makeTwin, generate, exportAs, tradeoff, measure,
                     sweep, depth},
        .isInput = true,
        .help = "The session document: display, light field and camera states. A folder of views, "
                "a picture or a mesh makes one around it."},
       {.name = "set",
        .value = "S.F=VALUE",
        .jobs = {render, report, makeCameras, makeTwin, generate, pack, exportAs, tradeoff, measure,
                 sweep, depth, info},
        .mayRepeat = true,
        .help = "Overrides a parameter of the session, such as psf.sigma=0.9 or "
                "camera.res=[300,300]; camera, intrinsics, pupil, stereo, distortion and psf go to "
                "every state. Repeat it for more."},
       {.name = "states",
        .value = "GLOB",
        .jobs = onStates,
        .help = "Only the states whose name fits, such as 'Fig*'."},
       {.name = "calibration",
        .value = "FILE",
        .jobs = onStates,
        .isInput = true,
        .help = "Takes lens, intrinsics and picture size of every state from an OpenCV calibration "
                "(.yml, .json)."},
       {.name = "calibrations",
        .value = "FILE",
        .jobs = {stability},
        .isInput = true,
        .help = "Adds lenses: a JSON list of cameras, or one OpenCV calibration."},
       {.name = "twin",
        .value = "FILE",
        .jobs = {render, report, makeTwin, exportAs},
        .isInput = true,
        .mayRepeat = true,
        .help = "The unit that is seen, in place of the session's own twin or of the display as "
                "designed. With --report --against design, repeat it for more: each is a test."},
       {.name = "plugins-path",
        .value = "DIR",
        .jobs = {window, render, report, makeCameras, makeTwin, generate, pack, exportAs, tradeoff,
                 measure, sweep, depth, info, plugins},
        .mayRepeat = true,
        .help = "A folder of plugins, which is searched before the others; the window takes it "
                "too. Repeat it for more."}}};
}

/// Returns the flags that choose what a session's states give.
std::vector<Flag> outputsOfStates() {
  return {{.name = "format",
           .value = "png|exr|tif",
           .jobs = {render},
           .choices = {"png", "exr", "tif"},
           .help = "Of the pictures: EXR holds the unrounded values, TIFF 16 bits."},
          {.name = "ideal",
           .jobs = {render},
           .help = "In place of what the display shows: what the eye would see of the session's "
                   "live scene itself through the panel."},
          {.name = "undistort",
           .jobs = {render},
           .help = "Of each state with a distortion also DIR/<name>.undistorted.png, its view "
                   "without the lens, <name>.undistorted-opencv.png, its picture straightened by "
                   "OpenCV, and <name>.undistortion.png, the difference of the two."},
          {.name = "stereo",
           .value = "MODE",
           .jobs = {render},
           .choices = {stereoModeNames().begin(), stereoModeNames().end()},
           .help = "One picture for both eyes, DIR/<name>.png, of states with stereo.ipd, in "
                   "place of one for each: side-by-side, anaglyph, anaglyph-grey (red on the left "
                   "and cyan on the right), cross-eyed."},
          {.name = "focus-stack",
           .value = "N",
           .jobs = {render},
           .range = NumberRange{.min = 2, .max = 9999, .isInteger = true},
           .help = "Of each state with a pupil N pictures, focused evenly in dioptres over the "
                   "depths that the display can show: DIR/<name>.focus01.png and so on, and their "
                   "distances in DIR/<name>.focus.csv."},
          {.name = "between",
           .value = "N",
           .jobs = {render},
           .range = NumberRange{.min = 1, .max = 9999, .isInteger = true},
           .help = "The path through the states in place of them: N pictures between each two, "
                   "and the states' own, DIR/frame_0001 and so on."},
          {.name = "video",
           .value = "FILE.mp4",
           .jobs = {render},
           .help = "Also a video of the pictures, made by the program ffmpeg."},
          {.name = "fps",
           .value = "F",
           .jobs = {render},
           .range = NumberRange{.min = 0.1, .max = 240},
           .help = "Pictures that the video shows in a second, 30 by default."},
          {.name = "masks",
           .jobs = {render},
           .help = "Also DIR/<name>.mask.png, white where the display is seen."},
          {.name = "images",
           .jobs = {report},
           .help = "Also the pictures, DIR/reference and DIR/test1, test2, …"},
          {.name = "shard",
           .value = "K/N",
           .jobs = {render, report, measure, sweep},
           .help = "Does every N-th state, from the K-th on, for one of N processes; of a report "
                   "only their figures, for the command without --shard."},
          {.name = "explain",
           .jobs = {render, report},
           .help = "Prints for each state what is modelled, what is left out and why, and how far "
                   "its lens can be trusted."}};
}

FlagGroup outputs() {
  std::vector<Command> andInfo = writing;
  andInfo.push_back(info);
  FlagGroup group{
      "What is written",
      {{.name = "output",
        .value = "PATH",
        .jobs = andInfo,
        .neededBy = writing,
        .help = "The folder for the results; for --make-cameras, --make-twin, --generate, --pack "
                "and --export the file (views: the folder). Folders are made if missing."},
       {.name = "save-session",
        .value = "FILE",
        .jobs = {render, report, tradeoff, measure, sweep, depth, exportAs},
        .help = "Also writes the session as it is used, with --set applied: with a folder or a "
                "picture as --session, the session that was made around it."},
       {.name = "fit",
        .value = "FILE",
        .jobs = {depth},
        .help = "Also writes the session with its content at the proposed scale and place, or with "
                "its views sheared."},
       {.name = "for-twin",
        .jobs = {exportAs},
        .help = "Content that is corrected for the session's twin, or --twin: seen through it, it "
                "looks as the session's own does through the display as designed."},
       {.name = "json",
        .jobs = {info},
        .help = "Prints order, shear and size of a light field for programs."}}};
  std::ranges::move(outputsOfStates(), std::back_inserter(group.flags));
  return group;
}

FlagGroup comparison() {
  return {
      "Comparing light fields",
      {{.name = "test",
        .value = "LF",
        .jobs = {report},
        .neededBy = {report},
        .unless = "against",
        .isInput = true,
        .mayRepeat = true,
        .help = "A light field to compare with the session's: an image, a folder, a store, or a "
                "session, whose display comes with it. Repeat it for more."},
       {.name = "against",
        .value = "ideal|design",
        .jobs = {report},
        .choices = {"ideal", "design"},
        .help = "ideal: the reference is the ideal view of the session's live scene, what the eye "
                "would see of it without the display; the display is then the first test. design: "
                "the reference is the display as designed, and each --twin is a test."},
       {.name = "fail-below",
        .value = "DB",
        .jobs = {report},
        .range = NumberRange{},
        .help = "Exit status 1 if any PSNR over the pixels seen is below."},
       {.name = "group",
        .value = "NAME=LF,LF,…",
        .jobs = {report},
        .mayRepeat = true,
        .help = "Tests that make one rate-distortion curve, four or more. Every pair of groups is "
                "compared: BD-rates and BD-qualities in DIR/bd.csv."},
       {.name = "rate",
        .value = "LF=BITS",
        .jobs = {report},
        .mayRepeat = true,
        .help =
            "Of a --group's test: bits per directional pixel, if not those of its file's size."}}};
}

FlagGroup content() {
  return {"Making camera states and test light fields",
          {{.name = "count",
            .value = "N",
            .jobs = {makeCameras},
            .shortFor = "cameraSet.count",
            .help = "States to add; short for --set cameraSet.count=N."},
           {.name = "region",
            .value = "box|plane|arc",
            .jobs = {makeCameras},
            .shortFor = "cameraRegion.region",
            .help = "Where the cameras stand; short for --set cameraRegion.region=…."},
           {.name = "seed",
            .value = "K",
            .jobs = {makeCameras, generate},
            .range = NumberRange{.isInteger = true},
            .shortFor = "cameraSet.seed",
            .help = "Of the random numbers, short for --set cameraSet.seed=K; for --generate of "
                    "--degrade noise:SIGMA."},
           {.name = "degrade",
            .value = "HOW",
            .jobs = {generate},
            .help = "Makes a worse copy: jpeg:QUALITY, noise:SIGMA in code values, or blur:SIGMA "
                    "in directional pixels."}}};
}

FlagGroup resources() {
  return {
      "How the work is done",
      {{.name = "memory",
        .value = "MB",
        .jobs = {window, render, report, makeTwin, pack, exportAs, tradeoff, measure, sweep, depth},
        .range = NumberRange{.min = 0.001, .max = 1e9},
        .help = "Megabytes for light fields and units, a quarter of the machine's by default, or "
                "of its container's; the window takes it too. What needs more is read piece by "
                "piece, or from the top once, or refused."},
       {.name = "threads",
        .value = "N",
        .jobs = {render, report, generate, pack, exportAs, tradeoff, stability, measure, sweep,
                 depth},
        .range = NumberRange{.min = 1, .isInteger = true},
        .help = "Threads to work with; all by default."},
       {.name = "budget",
        .value = "SECONDS",
        .jobs = {tradeoff},
        .range = NumberRange{.min = 0.001, .max = 1e6},
        .help = "How long the job may take, 60 by default: what is slow is measured once and "
                "on fewer pixels, what is fast until its time is known to two per cent."},
       {.name = "quiet", .jobs = writing, .help = "Prints nothing but errors."}}};
}

}  // namespace

const std::vector<FlagGroup>& flagGroups() {
  static const std::vector<FlagGroup> groups{inputs(), outputs(), comparison(), content(),
                                             resources()};
  return groups;
}

void checkValue(const Flag& flag, const std::string& text) {
  const std::optional<NumberRange>& range = flag.range;
  if (range &&
      !(range->isInteger ? isNumberIn<int>(*range, text) : isNumberIn<double>(*range, text)))
    throw InputError(
        "--" + std::string(flag.name),
        "\"" + text + "\" is not a number from " + numberText(range->min) +
            (range->max == NumberRange{}.max ? " on" : " to " + numberText(range->max)));
  if (flag.choices.empty() || std::ranges::find(flag.choices, text) != flag.choices.end()) return;
  std::string known;
  for (const std::string_view name : flag.choices)
    known += (known.empty() ? "" : ", ") + std::string(name);
  throw InputError("--" + std::string(flag.name), "\"" + text + "\" is not one of " + known);
}

}  // namespace hogelscope
