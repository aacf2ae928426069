// SPDX-License-Identifier: BSD-3-Clause
// The flags of the command line.
#include "cli/flags.h"

#include <algorithm>
#include <charconv>

#include "core/error.h"
#include "core/parameters.h"
#include "core/pattern.h"

namespace hogelscope {

namespace {

void choose(Options& options, Command command) {
  if (options.command == Command::help || options.command == Command::version) return;
  if (options.command != Command::window && options.command != command)
    throw InputError("command line",
                     "asks for two jobs at once; give one of --render, --report, "
                     "--make-cameras, --generate, --pack, --tradeoff, --stability, --info");
  options.command = command;
}

template <class Number>
Number number(const std::string& text, const char* flag, Number least) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= least))
    throw InputError(flag,
                     "\"" + text + "\" is not a number from " + std::to_string(int(least)) + " on");
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

std::string_view generateHelp() {
  static const std::string help = [] {
    std::string text = "Writes a test light field of the session's display, of any size: ";
    for (const PatternName& pattern : patternNames())
      text += std::string(&pattern == &patternNames().front() ? "" : "; ") +
              std::string(pattern.name) + " (" + std::string(pattern.help) + ")";
    return text + ".";
  }();
  return help;
}

}  // namespace

const std::vector<Flag>& jobs() {
  static const std::vector<Flag> flags{
      {"render", "", "One picture for each camera state: DIR/<name>.png.",
       [](Options& o, const std::string&) { choose(o, Command::render); }},
      {"report", "",
       "Renders every state from the session's light field and from each test light "
       "field, and compares them: DIR/report.csv, metrics.csv, summary.csv, report.html.",
       [](Options& o, const std::string&) { choose(o, Command::report); }},
      {"make-cameras", "SET",
       "Adds camera states to a copy of the session, --output FILE: uniform (a grid), random or "
       "normal over a region, a user's distribution FILE.json, or a viewer's trace FILE.csv.",
       [](Options& o, const std::string& v) {
         choose(o, Command::makeCameras);
         o.cameras = v;
       }},
      {"generate", "PATTERN", generateHelp(),
       [](Options& o, const std::string& v) {
         choose(o, Command::generate);
         std::vector<std::string_view> names;
         for (const PatternName& pattern : patternNames()) names.push_back(pattern.name);
         o.pattern = oneOf(v, "--generate", names);
       }},
      {"pack", "LF",
       "Writes a light field (an image, a quilt, a folder of views) as a store, --output FILE: a "
       "tiled TIFF of which a view reads only what it sees, so that it need not fit into memory. "
       "Run it again after a stop: it goes on. --session says what an image of hogels does not: "
       "display.hogels and display.directions.",
       [](Options& o, const std::string& v) {
         choose(o, Command::pack);
         o.packed = v;
       }},
      {"tradeoff", "",
       "Speed against accuracy of every method on the session's own states: DIR/tradeoff.csv, "
       ".png, "
       ".svg. Nearest with one ray a pixel asks for the display as built, any other sampling for "
       "the ideal picture.",
       [](Options& o, const std::string&) { choose(o, Command::tradeoff); }},
      {"stability", "",
       "Where methods fail: which ways to invert a lens find the right ray, which a wrong one or "
       "none, and the other unstable places: DIR/stability.csv, DIR/stability.png.",
       [](Options& o, const std::string&) { choose(o, Command::stability); }},
      {"info", "FILE",
       "Says what a session, a light field's image, a folder of views or a store is.",
       [](Options& o, const std::string& v) {
         choose(o, Command::info);
         o.infoFile = v;
       }},
      {"help", "", "This text; --help parameters lists every parameter of a session.",
       [](Options& o, const std::string&) { o.command = Command::help; }},
      {"version", "", "The version.",
       [](Options& o, const std::string&) { o.command = Command::version; }},
  };
  return flags;
}

const std::vector<Flag>& settings() {
  static const std::vector<Flag> flags{
      {"session", "FILE", "The session document.",
       [](Options& o, const std::string& v) { o.session = v; }},
      {"output", "PATH",
       "The folder to write, for --generate, --pack and --make-cameras the file; it is made if "
       "missing.",
       [](Options& o, const std::string& v) { o.output = v; }},
      {"test", "LF",
       "--report: a light field to compare: an image, a folder or a session (its "
       "display and light field). Repeat it for more.",
       [](Options& o, const std::string& v) { o.tests.push_back(v); }},
      {"group", "NAME=LF,LF,…",
       "--report: tests that make one rate-distortion curve, four or more. Each further group is "
       "compared with the first: BD-rate and BD-PSNR in DIR/bd.csv.",
       [](Options& o, const std::string& v) { o.groups.push_back(v); }},
      {"rate", "LF=BITS",
       "--group: a test's bits per directional pixel, if it is not its file's size.",
       [](Options& o, const std::string& v) { o.rates.push_back(v); }},
      {"count", "N", "--make-cameras: states to add; --set cameraSet.count=N.",
       [](Options& o, const std::string& v) { o.overrides.push_back("cameraSet.count=" + v); }},
      {"seed", "K",
       "--make-cameras: of the random numbers, --set cameraSet.seed=K; --degrade: of the noise.",
       [](Options& o, const std::string& v) { o.seed = number(v, "--seed", 0); }},
      {"degrade", "HOW",
       "--generate: a worse copy: jpeg:QUALITY, noise:SIGMA in code values, or blur:SIGMA in "
       "directional pixels.",
       [](Options& o, const std::string& v) { o.degrade = v; }},
      {"region", "box|plane|arc",
       "--make-cameras: where the cameras stand; --set cameraRegion.region=….",
       [](Options& o, const std::string& v) { o.overrides.push_back("cameraRegion.region=" + v); }},
      {"states", "GLOB", "Only the states whose name fits, such as 'Fig*'.",
       [](Options& o, const std::string& v) { o.states = v; }},
      {"calibration", "FILE",
       "Takes lens, intrinsics and picture size of every state from an OpenCV calibration (.yml, "
       ".json).",
       [](Options& o, const std::string& v) { o.calibration = v; }},
      {"calibrations", "FILE",
       "--stability: also these lenses: a JSON list of cameras, or one OpenCV calibration.",
       [](Options& o, const std::string& v) { o.calibrations = v; }},
      {"set", "S.F=VALUE",
       "Overrides a parameter, such as psf.sigma=0.9 or camera.res=[300,300]; "
       "camera, intrinsics, distortion and psf go to every state. Repeat it for more.",
       [](Options& o, const std::string& v) { o.overrides.push_back(v); }},
      {"format", "png|exr|tif", "--render: EXR holds the unrounded values, TIFF 16 bits.",
       [](Options& o, const std::string& v) {
         o.format = oneOf(v, "--format", {"png", "exr", "tif"});
       }},
      {"masks", "", "--render: also DIR/<name>.mask.png, white where the display is seen.",
       [](Options& o, const std::string&) { o.masks = true; }},
      {"images", "", "--report: also the pictures, DIR/reference and DIR/test1, test2, …",
       [](Options& o, const std::string&) { o.images = true; }},
      {"explain", "",
       "--render, --report: says for each state what is modelled, what is left out and why, and "
       "how "
       "far its lens can be trusted.",
       [](Options& o, const std::string&) { o.explain = true; }},
      {"fail-below", "DB", "--report: exit status 1 if any PSNR is below.",
       [](Options& o, const std::string& v) { o.failBelow = number(v, "--fail-below", 0.0); }},
      {"memory", "MB",
       "Megabytes for light fields, a quarter of the machine's by default. --render, --report: a "
       "light field that needs more is read from the top once, and all pictures are made on the "
       "way; of a store each view reads what it needs. --pack: for the rows of the hogel image.",
       [](Options& o, const std::string& v) {
         const double megabytes = std::clamp(number(v, "--memory", 0.0), 1e-6, 1e12);
         o.memory = std::size_t(1e6 * megabytes);
       }},
      {"threads", "N", "Threads to work with; all by default.",
       [](Options& o, const std::string& v) { o.threads = number(v, "--threads", 1); }},
      {"quiet", "", "Only errors.", [](Options& o, const std::string&) { o.quiet = true; }},
  };
  return flags;
}

const Flag& findFlag(const std::string& name) {
  std::vector<std::string_view> names;
  for (const auto* table : {&jobs(), &settings()}) {
    for (const Flag& flag : *table) {
      if (flag.name == name) return flag;
      names.push_back(flag.name);
    }
  }
  const std::string_view nearest = nearestName(name, names);
  throw InputError("--" + name, nearest.empty() ? "is not a flag of ours; see --help"
                                                : "is not a flag of ours; did you mean --" +
                                                      std::string(nearest) + "?");
}

}  // namespace hogelscope
