// SPDX-License-Identifier: BSD-3-Clause
// The command line, as a value.
#include "cli/options.h"

#include <algorithm>

#include "cli/flags.h"
#include "core/error.h"

namespace hogelscope {

namespace {

bool isOneOf(Command command, std::initializer_list<Command> commands) {
  return std::find(commands.begin(), commands.end(), command) != commands.end();
}

bool hasSession(Command command) {
  return isOneOf(command, {Command::render, Command::report, Command::makeCameras,
                           Command::generate, Command::tradeoff});
}

bool isJob(Command command) {
  return hasSession(command) || isOneOf(command, {Command::stability, Command::pack});
}

void refuseLooseWords(const Options& options) {
  if ((isJob(options.command) || options.command == Command::info) && !options.files.empty())
    throw InputError(options.files.front(),
                     "stands alone on the command line; a session is given "
                     "as --session FILE");
  if (options.command == Command::window &&
      !(options.session.empty() && options.output.empty() && options.calibration.empty() &&
        options.calibrations.empty()))
    throw InputError("command line",
                     "has settings but no job; give one of --render, --report, "
                     "--make-cameras, --generate, --pack, --tradeoff, --stability, or only a "
                     "session to open it");
}

void refuseOfOtherJobs(const Options& options) {
  for (const std::string& text : options.overrides)
    if (isOfCameraSet(text) && options.command != Command::makeCameras)
      throw InputError("--set " + text, "belongs to --make-cameras SET");
    else if (isOfPattern(text) && options.command != Command::generate)
      throw InputError("--set " + text, "belongs to --generate PATTERN");
  if (!options.degrade.empty() && options.command != Command::generate)
    throw InputError("--degrade", "belongs to --generate PATTERN");
  if (options.seed && !isOneOf(options.command, {Command::makeCameras, Command::generate}))
    throw InputError("--seed", "belongs to --make-cameras SET or --generate PATTERN");
  if (options.command != Command::report && !(options.groups.empty() && options.rates.empty()))
    throw InputError(options.groups.empty() ? "--rate" : "--group", "belongs to --report");
  if (!options.calibrations.empty() && options.command != Command::stability)
    throw InputError("--calibrations",
                     "belongs to --stability; the cameras of other jobs change by "
                     "--calibration FILE");
}

void refuseForStability(const Options& options) {
  if (options.command != Command::stability) return;
  if (!options.session.empty())
    throw InputError("--session",
                     "is not for --stability, whose lenses are its own and those of "
                     "--calibrations FILE");
  if (!options.calibration.empty() || !options.overrides.empty() || options.states != "*")
    throw InputError("--stability",
                     "has no states: --calibration, --set and --states are not for it; lenses come "
                     "from --calibrations FILE");
}

void refuseMissing(const Options& options) {
  if (!isJob(options.command)) return;
  const auto need = [](const std::string& value, const char* flag, const char* what) {
    if (value.empty()) throw InputError(flag, std::string("is missing: ") + what);
  };
  if (hasSession(options.command)) need(options.session, "--session", "name the session document");
  need(options.output, "--output", "name where the results go");
  if (options.command == Command::report && options.tests.empty())
    throw InputError("--test", "is missing: name a light field to compare with the session's");
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
  refuseLooseWords(options);
  refuseOfOtherJobs(options);
  refuseForStability(options);
  refuseMissing(options);
  return options;
}

bool isOfCameraSet(const std::string& override) {
  return override.starts_with("cameraSet.") || override.starts_with("cameraRegion.");
}

bool isOfPattern(const std::string& override) {
  return override.starts_with("pattern.");
}

}  // namespace hogelscope
