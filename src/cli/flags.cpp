// SPDX-License-Identifier: BSD-3-Clause
#include "cli/flags.h"

#include <algorithm>
#include <charconv>

#include "cli/jobs.h"
#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

template <class Number>
bool isNumberIn(const NumberRange& range, const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && double(value) >= range.min &&
         double(value) <= range.max;
}

/// The options that several jobs take.
std::vector<Flag> sharedFlags() {
  return {
      {.name = "session",
       .value = "FILE",
       .heading = "What is read",
       .unless = {"campaign"},
       .isInput = true,
       .help = "The session document: display, light field and camera states. A folder of views, "
               "a picture or a mesh makes one around it."},
      {.name = "set",
       .value = "S.F=VALUE",
       .mayRepeat = true,
       .help = "Overrides a parameter of the session, such as psf.sigma=0.9 or "
               "camera.res=[300,300]; camera, intrinsics, pupil, stereo, distortion and psf go to "
               "every state. Repeat it for more."},
      {.name = "states",
       .value = "GLOB",
       .help = "Only the states whose name fits, such as 'Fig*'."},
      {.name = "calibration",
       .value = "FILE",
       .isInput = true,
       .help = "Takes lens, intrinsics and picture size of every state from a camera's file: "
               "OpenCV's YAML, XML or JSON, ROS camera_info, Kalibr, COLMAP, transforms.json …"},
      {.name = "camera",
       .value = "NAME",
       .with = "calibration",
       .help = "The camera of a file of several: of --calibration, or else of --make-cameras."},
      {.name = "twin",
       .value = "FILE",
       .isInput = true,
       .mayRepeat = true,
       .help = "The unit that is seen, in place of the session's own twin or of the display as "
               "designed. With --report --against design, repeat it for more: each is a test."},
      {.name = "plugins-path",
       .value = "DIR",
       .mayRepeat = true,
       .isForWindow = true,
       .help = "A folder of plugins, which is searched before the others; the window takes it "
               "too. Repeat it for more."},
      {.name = "output",
       .value = "PATH",
       .heading = "What is written",
       .help =
           "The folder for the results; for --make-cameras, --make-twin, --generate, --pack, "
           "--export and --optimise the file (views: the folder). Folders are made if missing."},
      {.name = "save-session",
       .value = "FILE",
       .lastJob = "export",
       .help = "Also writes the session as it is used, with --set applied: with a folder or a "
               "picture as --session, the session that was made around it."},
      {.name = "shard",
       .value = "K/N",
       .help = "Does every N-th state, from the K-th on, for one of N processes, with --optimise "
               "every N-th row of hogels; of a report only their figures, for the command without "
               "--shard."},
      {.name = "frames",
       .value = "FIRST:LAST:STEP",
       .help =
           "Of a light field in time: all, one frame, or those from FIRST to LAST, both of which "
           "count. States with a time keep the frame of that time."},
      {.name = "explain",
       .help = "Prints for each state what is modelled, what is left out and why, and how far "
               "its lens can be trusted."},
      {.name = "seed",
       .value = "K",
       .range = NumberRange{.isInteger = true},
       .shortFor = "cameraSet.seed",
       .help = "Of the random numbers, short for --set cameraSet.seed=K; for --generate of "
               "--degrade noise:SIGMA."},
      {.name = "memory",
       .value = "MB",
       .heading = "How the work is done",
       .isForWindow = true,
       .range = NumberRange{.min = 0.001, .max = 1e9},
       .help = "Megabytes for light fields and units, a quarter of the machine's by default, or "
               "of its container's; the window takes it too. What needs more is read piece by "
               "piece, or from the top once, or refused."},
      {.name = "threads",
       .value = "N",
       .range = NumberRange{.min = 1, .isInteger = true},
       .help = "Threads to work with; all by default."},
      {.name = "quiet", .help = "Prints nothing but errors."}};
}

/// Puts the options of each job where they say.
std::vector<Flag> withOwn(std::vector<Flag> flags) {
  for (const Job& job : jobs()) {
    std::string_view before;
    for (const Flag& flag : job.own) {
      const auto found =
          std::ranges::find(flags, flag.after.empty() ? before : flag.after, &Flag::name);
      flags.insert(found == flags.end() ? found : found + 1, flag);
      before = flag.name;
    }
  }
  return flags;
}

}  // namespace

const std::vector<Flag>& allFlags() {
  static const std::vector<Flag> all = withOwn(sharedFlags());
  return all;
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
