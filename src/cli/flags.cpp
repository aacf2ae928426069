// SPDX-License-Identifier: BSD-3-Clause
// The options of the command line.
#include "cli/flags.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "core/base/error.h"
#include "core/base/text.h"

namespace hogelscope {

namespace {

using enum Command;

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Those that work on a session's camera states.
const std::vector<Command> onStates{render, report, makeCameras, tradeoff};
/// Those that write files.
const std::vector<Command> writing{render, report,   makeCameras, generate,
                                   pack,   tradeoff, stability};

template <class Number>
Number number(const std::string& text, const char* flag, double least, double most) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool isNumber = error == std::errc() && end == text.data() + text.size();
  if (!isNumber || !(double(value) >= least && double(value) <= most))
    throw InputError(flag, "\"" + text + "\" is not a number from " + numberText(least) +
                               (most == unlimited ? " on" : " to " + numberText(most)));
  return value;
}

std::string oneOf(const std::string& text, const char* flag,
                  const std::vector<std::string_view>& names) {
  if (std::find(names.begin(), names.end(), text) != names.end()) return text;
  std::string known;
  for (const std::string_view name : names)
    known += (known.empty() ? "" : ", ") + std::string(name);
  throw InputError(flag, "\"" + text + "\" is not one of " + known);
}

using Apply = std::function<void(Options&, const std::string&)>;

Apply into(std::string Options::*member) {
  return [member](Options& options, const std::string& value) { options.*member = value; };
}

Apply addedTo(std::vector<std::string> Options::*member) {
  return
      [member](Options& options, const std::string& value) { (options.*member).push_back(value); };
}

Apply raising(bool Options::*member) {
  return [member](Options& options, const std::string&) { options.*member = true; };
}

/// For --set.
Apply shortFor(const std::string& parameter) {
  return [parameter](Options& options, const std::string& value) {
    options.overrides.push_back(parameter + "=" + value);
  };
}

void takeSeed(Options& options, const std::string& value) {
  const int seed = number<int>(value, "--seed", 0, unlimited);
  if (options.command == makeCameras)
    options.overrides.push_back("cameraSet.seed=" + value);
  else
    options.seed = seed;
}

FlagGroup inputs() {
  return {
      "What is read",
      {{.name = "session",
        .value = "FILE",
        .jobs = {render, report, makeCameras, generate, pack, tradeoff},
        .neededBy = {render, report, makeCameras, generate, tradeoff},
        .help = "The session document: display, light field and camera states.",
        .apply = into(&Options::session)},
       {.name = "set",
        .value = "S.F=VALUE",
        .jobs = {render, report, makeCameras, generate, pack, tradeoff, info},
        .mayRepeat = true,
        .help = "Overrides a parameter of the session, such as psf.sigma=0.9 or "
                "camera.res=[300,300]; camera, intrinsics, distortion and psf go to every state. "
                "Repeat it for more.",
        .apply = addedTo(&Options::overrides)},
       {.name = "states",
        .value = "GLOB",
        .jobs = onStates,
        .help = "Only the states whose name fits, such as 'Fig*'.",
        .apply = into(&Options::states)},
       {.name = "calibration",
        .value = "FILE",
        .jobs = onStates,
        .help = "Takes lens, intrinsics and picture size of every state from an OpenCV calibration "
                "(.yml, .json).",
        .apply = into(&Options::calibration)},
       {.name = "calibrations",
        .value = "FILE",
        .jobs = {stability},
        .help = "Adds lenses: a JSON list of cameras, or one OpenCV calibration.",
        .apply = into(&Options::calibrations)}}};
}

FlagGroup outputs() {
  return {"What is written",
          {{.name = "output",
            .value = "PATH",
            .jobs = writing,
            .neededBy = writing,
            .help = "The folder for the results; for --make-cameras, --generate and --pack the "
                    "file. Folders are made if missing.",
            .apply = into(&Options::output)},
           {.name = "format",
            .value = "png|exr|tif",
            .jobs = {render},
            .help = "Of the pictures: EXR holds the unrounded values, TIFF 16 bits.",
            .apply =
                [](Options& o, const std::string& v) {
                  o.format = oneOf(v, "--format", {"png", "exr", "tif"});
                }},
           {.name = "masks",
            .jobs = {render},
            .help = "Also DIR/<name>.mask.png, white where the display is seen.",
            .apply = raising(&Options::masks)},
           {.name = "images",
            .jobs = {report},
            .help = "Also the pictures, DIR/reference and DIR/test1, test2, …",
            .apply = raising(&Options::images)},
           {.name = "explain",
            .jobs = {render, report},
            .help = "Prints for each state what is modelled, what is left out and why, and how far "
                    "its lens can be trusted.",
            .apply = raising(&Options::explain)}}};
}

FlagGroup comparison() {
  return {
      "Comparing light fields",
      {{.name = "test",
        .value = "LF",
        .jobs = {report},
        .neededBy = {report},
        .mayRepeat = true,
        .help = "A light field to compare with the session's: an image, a folder, a store, or a "
                "session, whose display comes with it. Repeat it for more.",
        .apply = addedTo(&Options::tests)},
       {.name = "fail-below",
        .value = "DB",
        .jobs = {report},
        .help = "Exit status 1 if any PSNR is below.",
        .apply =
            [](Options& o, const std::string& v) {
              o.failBelow = number<double>(v, "--fail-below", 0, unlimited);
            }},
       {.name = "group",
        .value = "NAME=LF,LF,…",
        .jobs = {report},
        .mayRepeat = true,
        .help = "Tests that make one rate-distortion curve, four or more. Each further group is "
                "compared with the first: BD-rate and BD-PSNR in DIR/bd.csv.",
        .apply = addedTo(&Options::groups)},
       {.name = "rate",
        .value = "LF=BITS",
        .jobs = {report},
        .mayRepeat = true,
        .help = "Of a --group's test: bits per directional pixel, if not those of its file's size.",
        .apply = addedTo(&Options::rates)}}};
}

FlagGroup content() {
  return {"Making camera states and test light fields",
          {{.name = "count",
            .value = "N",
            .jobs = {makeCameras},
            .help = "States to add; short for --set cameraSet.count=N.",
            .apply = shortFor("cameraSet.count")},
           {.name = "region",
            .value = "box|plane|arc",
            .jobs = {makeCameras},
            .help = "Where the cameras stand; short for --set cameraRegion.region=….",
            .apply = shortFor("cameraRegion.region")},
           {.name = "seed",
            .value = "K",
            .jobs = {makeCameras, generate},
            .help = "Of the random numbers, short for --set cameraSet.seed=K; for --generate of "
                    "--degrade noise:SIGMA.",
            .apply = takeSeed},
           {.name = "degrade",
            .value = "HOW",
            .jobs = {generate},
            .help = "Makes a worse copy: jpeg:QUALITY, noise:SIGMA in code values, or blur:SIGMA "
                    "in directional pixels.",
            .apply = into(&Options::degrade)}}};
}

FlagGroup resources() {
  return {"How the work is done",
          {{.name = "memory",
            .value = "MB",
            .jobs = {window, render, report, pack, tradeoff},
            .help = "Megabytes for light fields, a quarter of the machine's by default; the window "
                    "takes it too. What needs more is read piece by piece, or from the top once.",
            .apply =
                [](Options& o, const std::string& v) {
                  o.memory = std::size_t(1e6 * number<double>(v, "--memory", 0.001, 1e9));
                }},
           {.name = "threads",
            .value = "N",
            .jobs = {render, report, generate, pack, tradeoff, stability},
            .help = "Threads to work with; all by default.",
            .apply =
                [](Options& o, const std::string& v) {
                  o.threads = number<int>(v, "--threads", 1, unlimited);
                }},
           {.name = "quiet",
            .jobs = writing,
            .help = "Prints nothing but errors.",
            .apply = raising(&Options::quiet)}}};
}

}  // namespace

const std::vector<FlagGroup>& flagGroups() {
  static const std::vector<FlagGroup> groups{inputs(), outputs(), comparison(), content(),
                                             resources()};
  return groups;
}

}  // namespace hogelscope
