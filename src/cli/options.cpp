// SPDX-License-Identifier: BSD-3-Clause
// Words of the command line become options; what the job does not use is refused.
#include "cli/options.h"

#include <algorithm>

#include "cli/flags.h"
#include "cli/jobs.h"
#include "core/base/error.h"
#include "core/base/parameters.h"

namespace hogelscope {

namespace {

/// An option as it was given: one of a job, or one of the table of flags.
struct Given {
  std::string name;
  std::string value;
  const Job* job = nullptr;  ///< one of the two
  const Flag* flag = nullptr;

  [[nodiscard]] std::string_view wants() const { return job != nullptr ? job->value : flag->value; }
};

std::string dashed(std::string_view name) {
  return "--" + std::string(name);
}

Given findOption(const std::string& name) {
  std::vector<std::string_view> names;
  for (const Job& job : jobs()) {
    if (job.name == name) return {name, {}, &job, nullptr};
    names.push_back(job.name);
  }
  for (const FlagGroup& group : flagGroups())
    for (const Flag& flag : group.flags) {
      if (flag.name == name) return {name, {}, nullptr, &flag};
      names.push_back(flag.name);
    }
  const std::string_view nearest = nearestName(name, names);
  throw InputError(dashed(name), nearest.empty()
                                     ? "unknown option; see --help"
                                     : "unknown option; did you mean " + dashed(nearest) + "?");
}

using Word = std::vector<std::string>::const_iterator;

/// `at` moves to the last word of the option.
Given optionAt(Word& at, Word end) {
  if (!at->starts_with("--") && *at != "-h")
    throw InputError(*at, "unknown option; options begin with two dashes, see --help");
  const std::size_t equals = at->find('=');
  Given given = findOption(*at == "-h" ? "help" : at->substr(2, equals - 2));
  if (given.wants().empty()) {
    if (equals != std::string::npos) throw InputError(dashed(given.name), "takes no value");
    return given;
  }
  if (equals != std::string::npos)
    given.value = at->substr(equals + 1);
  else if (at + 1 != end)
    given.value = *++at;
  if (given.value.empty() || given.value.starts_with("--"))
    throw InputError(dashed(given.name), "needs a value: " + std::string(given.wants()));
  return given;
}

void refuseRepeated(const std::vector<Given>& all) {
  for (auto one = all.begin(); one != all.end(); ++one)
    for (auto other = all.begin(); other != one; ++other)
      if (other->name == one->name &&
          (one->flag == nullptr || !one->flag->mayRepeat || other->value == one->value))
        throw InputError(
            dashed(one->name) + (one->value.empty() ? "" : " " + one->value),
            "is given twice" + (other->value == one->value ? "" : ", before as " + other->value));
}

/// --help beside a job asks for the help on it.
void chooseJob(const std::vector<Given>& all, Options& options) {
  const Job* chosen = nullptr;
  bool isHelp = false;
  for (const Given& given : all) {
    if (given.job == nullptr) continue;
    if (given.job->command == Command::help) {
      isHelp = true;
    } else if (chosen != nullptr) {
      throw InputError(dashed(given.name),
                       "is a second job beside " + dashed(chosen->name) + "; give one of them");
    } else {
      chosen = given.job;
      options.subject = given.value;
    }
  }
  if (chosen != nullptr) options.command = chosen->command;
  if (!isHelp) return;
  options.command = Command::help;
  options.subject = chosen != nullptr ? chosen->name : "";
}

void refuseForeign(const Flag& flag, Command command) {
  if (isOneOf(flag.jobs, command)) return;
  const std::string owners = optionsOf(flag.jobs);
  if (command == Command::window)
    throw InputError(dashed(flag.name),
                     "belongs to " + owners + "; without a job the window opens");
  throw InputError(dashed(flag.name), "is not an option of " + dashed(jobOf(command).name) +
                                          "; it belongs to " + owners);
}

void refuseMissing(const std::vector<Given>& all, Command command) {
  for (const FlagGroup& group : flagGroups())
    for (const Flag& flag : group.flags)
      if (isOneOf(flag.neededBy, command) &&
          std::ranges::find(all, &flag, &Given::flag) == all.end()) {
        const std::string job = dashed(jobOf(command).name);
        throw InputError(dashed(flag.name), "is missing; " + job + " needs " + dashed(flag.name) +
                                                " " + std::string(flag.value) + ", see --help " +
                                                job.substr(2));
      }
}

/// The window opens files, --help has a topic; jobs read what their options name.
void takeLooseWords(std::vector<std::string> words, Options& options) {
  if (options.command == Command::window) {
    options.files = std::move(words);
  } else if (options.command == Command::help && options.subject.empty() && words.size() == 1) {
    options.subject = words.front();
  } else if (!words.empty()) {
    const std::string job(jobOf(options.command).name);
    throw InputError(words.front(), "unexpected argument of --" + job + "; see --help " + job);
  }
}

/// Those of the job's own sections are put apart; each parameter is set once.
void sortOverrides(Options& options) {
  std::vector<std::string> known;
  std::vector<std::string> ofSession;
  for (const std::string& text : options.overrides) {
    const std::string name = text.substr(0, text.find('='));
    if (std::ranges::find(known, name) != known.end())
      throw InputError("--set " + text, "sets " + name + " a second time");
    known.push_back(name);
    const std::string section = name.substr(0, name.find('.'));
    const auto owner = std::ranges::find_if(jobs(), [&section](const Job& job) {
      return std::ranges::find(job.sections, section) != job.sections.end();
    });
    if (owner == jobs().end())
      ofSession.push_back(text);
    else if (owner->command == options.command)
      options.jobOverrides.push_back(text);
    else
      throw InputError("--set " + text, "belongs to " + dashed(owner->name));
  }
  options.overrides = std::move(ofSession);
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
  std::vector<Given> all;
  std::vector<std::string> words;
  for (auto at = arguments.begin(); at != arguments.end(); ++at)
    if (at->starts_with("-") && *at != "-")
      all.push_back(optionAt(at, arguments.end()));
    else
      words.push_back(*at);
  chooseJob(all, options);
  takeLooseWords(std::move(words), options);
  if (options.command == Command::help) return options;
  refuseRepeated(all);
  for (const Given& given : all) {
    if (given.flag == nullptr) continue;
    refuseForeign(*given.flag, options.command);
    given.flag->apply(options, given.value);
  }
  refuseMissing(all, options.command);
  sortOverrides(options);
  return options;
}

}  // namespace hogelscope
