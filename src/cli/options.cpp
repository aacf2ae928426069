// SPDX-License-Identifier: BSD-3-Clause
// The command line: one table of flags, from which parsing and help come.
#include "cli/options.h"

#include <algorithm>
#include <charconv>
#include <functional>

#include "cli/manual.h"
#include "core/error.h"
#include "core/parameters.h"
#include "core/pattern.h"

namespace hogelscope {

namespace {

/// One flag: what follows it, and what it does to the options. A command is a flag too.
struct Flag {
  std::string_view name;
  std::string_view value;  ///< "" if none follows
  std::string_view help;
  std::function<void(Options&, const std::string&)> apply;
};

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

void refuseMissing(const Options& options) {
  const auto need = [](const std::string& value, const char* flag, const char* what) {
    if (value.empty()) throw InputError(flag, std::string("is missing: ") + what);
  };
  const bool hasSession =
      options.command == Command::render || options.command == Command::report ||
      options.command == Command::makeCameras || options.command == Command::generate ||
      options.command == Command::tradeoff;
  const bool isJob =
      hasSession || options.command == Command::stability || options.command == Command::pack;
  if (isJob || options.command == Command::info) {
    if (!options.files.empty())
      throw InputError(options.files.front(),
                       "stands alone on the command line; a session is given "
                       "as --session FILE");
  }
  if (options.command == Command::window &&
      !(options.session.empty() && options.output.empty() && options.calibration.empty() &&
        options.calibrations.empty()))
    throw InputError("command line",
                     "has settings but no job; give one of --render, --report, "
                     "--make-cameras, --generate, --pack, --tradeoff, --stability, or only a "
                     "session to open it");
  for (const std::string& text : options.overrides)
    if (isOfCameraSet(text) && options.command != Command::makeCameras)
      throw InputError("--set " + text, "belongs to --make-cameras SET");
    else if (isOfPattern(text) && options.command != Command::generate)
      throw InputError("--set " + text, "belongs to --generate PATTERN");
  if (!options.degrade.empty() && options.command != Command::generate)
    throw InputError("--degrade", "belongs to --generate PATTERN");
  if (options.seed && options.command != Command::makeCameras &&
      options.command != Command::generate)
    throw InputError("--seed", "belongs to --make-cameras SET or --generate PATTERN");
  if (options.command != Command::report && !(options.groups.empty() && options.rates.empty()))
    throw InputError(options.groups.empty() ? "--rate" : "--group", "belongs to --report");
  const bool isStability = options.command == Command::stability;
  if (!options.calibrations.empty() && !isStability)
    throw InputError("--calibrations",
                     "belongs to --stability; the cameras of other jobs change by "
                     "--calibration FILE");
  if (!options.session.empty() && isStability)
    throw InputError("--session",
                     "is not for --stability, whose lenses are its own and those of "
                     "--calibrations FILE");
  const bool touchesStates =
      !options.calibration.empty() || !options.overrides.empty() || options.states != "*";
  if (isStability && touchesStates)
    throw InputError("--stability",
                     "has no states: --calibration, --set and --states are not for it; lenses come "
                     "from --calibrations FILE");
  if (!isJob) return;
  if (hasSession) need(options.session, "--session", "name the session document");
  need(options.output, "--output", "name where the results go");
  if (options.command == Command::report && options.tests.empty())
    throw InputError("--test", "is missing: name a light field to compare with the session's");
}

/// `text`, broken at spaces to lines of at most 100 columns, the later ones indented.
std::string wrapped(std::string_view text, std::size_t indent) {
  constexpr std::size_t width = 100;
  std::string out;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::string_view wordText = text.substr(0, text.find(' '));
    if (column + wordText.size() > width) {
      out.back() = '\n';
      out += std::string(indent, ' ');
      column = indent;
    }
    out += std::string(wordText) + " ";
    column += wordText.size() + 1;
    text.remove_prefix(std::min(text.size(), wordText.size() + 1));
  }
  out.pop_back();
  return out + "\n";
}

std::string flagTable(const std::vector<Flag>& flags) {
  constexpr std::size_t indent = 26;
  std::string text;
  for (const Flag& flag : flags) {
    std::string head = "  --" + std::string(flag.name);
    if (!flag.value.empty()) head += " " + std::string(flag.value);
    head.resize(std::max(head.size() + 2, indent), ' ');
    text += head + wrapped(flag.help, indent);
  }
  return text;
}

/// As one word of a shell's command line.
std::string quoted(const std::string& word) {
  constexpr const char* plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

Options parseOptions(const std::vector<std::string>& arguments) {
  Options options;
  options.commandLine = "hogelscope";
  for (const std::string& word : arguments) options.commandLine += " " + quoted(word);
  for (auto at = arguments.begin(); at != arguments.end(); ++at) {
    if (!at->starts_with("-") || *at == "-") {
      options.files.push_back(*at);
      continue;
    }
    if (!at->starts_with("--") && *at != "-h")
      throw InputError(*at, "is not a flag of ours; flags begin with two dashes, see --help");
    const std::size_t equals = at->find('=');
    const std::string name = *at == "-h" ? "help" : at->substr(2, equals - 2);
    const Flag& flag = findFlag(name);
    std::string value;
    if (flag.value.empty()) {
      if (equals != std::string::npos) throw InputError("--" + name, "takes no value");
    } else if (equals != std::string::npos) {
      value = at->substr(equals + 1);
    } else {
      if (at + 1 == arguments.end())
        throw InputError("--" + name, "needs a value: " + std::string(flag.value));
      value = *++at;
    }
    if (!flag.value.empty() && (value.empty() || value.starts_with("--")))
      throw InputError("--" + name, "needs a value: " + std::string(flag.value));
    flag.apply(options, value);
  }
  refuseMissing(options);
  return options;
}

bool isOfCameraSet(const std::string& override) {
  return override.starts_with("cameraSet.") || override.starts_with("cameraRegion.");
}

bool isOfPattern(const std::string& override) {
  return override.starts_with("pattern.");
}

std::string helpText(const std::string& topic) {
  if (topic == "parameters") return parameterManual();
  if (!topic.empty())
    throw InputError("--help " + topic, "there is no such topic; there is --help parameters");
  return "hogelscope: what a viewer would see on a light field display that need not exist yet\n"
         "\n"
         "  hogelscope [SESSION.json]                                  opens the window\n"
         "  hogelscope --render --session S.json --output DIR          one picture per camera "
         "state\n"
         "  hogelscope --report --session S.json --test LF --output DIR\n"
         "                                                             compares light fields\n"
         "\n"
         "Try it on the paper's six camera states, from the folder of the sources:\n"
         "  hogelscope --render --session data/table1.json --output out --masks\n"
         "  hogelscope --render --session data/table1.json --output out --states 'Fig 1' \\\n"
         "             --set sampling.mapping=direct --set psf.windowSize=1\n"
         "  hogelscope --info data/table1.json\n"
         "\n"
         "Jobs:\n" +
         flagTable(jobs()) + "\nSettings:\n" + flagTable(settings()) +
         "\n"
         "Exit status: 0 done, 1 a gate failed (--fail-below), 2 bad input, 3 internal error.\n"
         "Errors go to stderr as hogelscope: FILE: WHAT: WHY.\n";
}

}  // namespace hogelscope
