// SPDX-License-Identifier: BSD-3-Clause
// Parsing of the command line; options that the job does not use are rejected.
#include <algorithm>
#include <iterator>
#include <set>

#include "cli/command_line.h"
#include "cli/flags.h"
#include "cli/jobs.h"
#include "core/base/error.h"
#include "core/base/parameters.h"

namespace hogelscope {

namespace {

/// An option as given: it selects a job or is in the table of flags.
struct Given {
  std::string_view name;
  std::string_view valueName;  ///< "" if the option has no value
  const Job* job = nullptr;    ///< either the job or the flag
  const Flag* flag = nullptr;
  std::string value = {};
};

std::string dashed(std::string_view name) {
  return "--" + std::string(name);
}

Given findOption(const std::string& name) {
  std::vector<std::string_view> names;
  for (const Job& job : jobs()) {
    if (job.name == name) return {job.name, job.value, &job, nullptr};
    names.push_back(job.name);
  }
  for (const Flag& flag : allFlags()) {
    if (flag.name == name) return {flag.name, flag.value, nullptr, &flag};
    names.push_back(flag.name);
  }
  const std::string_view nearest = nearestName(name, names);
  throw InputError(dashed(name), nearest.empty()
                                     ? "unknown option; see --help"
                                     : "unknown option; did you mean " + dashed(nearest) + "?");
}

using Word = std::vector<std::string>::const_iterator;

/// Parses an option, and moves `at` to its last word.
Given parseOption(Word& at, Word end) {
  if (!at->starts_with("--") && *at != "-h")
    throw InputError(*at, "unknown option; options begin with two dashes, see --help");
  const std::size_t equals = at->find('=');
  Given given = findOption(*at == "-h" ? "help" : at->substr(2, equals - 2));
  if (given.valueName.empty()) {
    if (equals != std::string::npos) throw InputError(dashed(given.name), "takes no value");
    return given;
  }
  if (equals != std::string::npos)
    given.value = at->substr(equals + 1);
  else if (at + 1 != end)
    given.value = *++at;
  if (given.value.empty() || given.value.starts_with("--"))
    throw InputError(dashed(given.name), "needs a value: " + std::string(given.valueName));
  return given;
}

bool mayRepeat(const Given& given) {
  return given.flag != nullptr ? given.flag->mayRepeat : given.job->mayRepeat;
}

void refuseRepeated(const std::vector<Given>& all) {
  for (auto one = all.begin(); one != all.end(); ++one)
    for (auto other = all.begin(); other != one; ++other)
      if (other->name == one->name && (!mayRepeat(*one) || other->value == one->value))
        throw InputError(
            dashed(one->name) + (one->value.empty() ? "" : " " + one->value),
            "is given twice" + (other->value == one->value ? "" : ", before as " + other->value));
}

bool isHelp(const Job* job) {
  return job != nullptr && job->name == "help";
}

/// Chooses the job. --help with a job shows the help on it.
void chooseJob(const std::vector<Given>& all, CommandLine& line) {
  const Job* chosen = nullptr;
  const Job* help = nullptr;
  for (const Given& given : all) {
    if (given.job == nullptr) continue;
    if (isHelp(given.job)) {
      help = given.job;
    } else if (chosen != nullptr && !(chosen == given.job && chosen->mayRepeat)) {
      throw InputError(dashed(given.name),
                       "is a second job beside " + dashed(chosen->name) + "; give one of them");
    } else {
      if (chosen == nullptr) line.subject = given.value;
      chosen = given.job;
      if (chosen->mayRepeat) line.subjects.push_back(given.value);
    }
  }
  line.job = help != nullptr ? help : chosen;
  if (help == nullptr) return;
  line.subject = chosen != nullptr ? chosen->name : "";
}

void refuseForeign(const Flag& flag, const Job* job) {
  if (accepts(job, flag)) return;
  const std::string owners = optionsOf(jobsOf(flag));
  if (job == nullptr)
    throw InputError(dashed(flag.name),
                     "belongs to " + owners + "; without a job the window opens");
  throw InputError(dashed(flag.name),
                   "is not an option of " + dashed(job->name) + "; it belongs to " + owners);
}

void refuseMissing(const Flag& flag, const CommandLine& line) {
  if (!needs(line.job, flag) || line.has(flag.name)) return;
  const auto isGiven = [&line](std::string_view option) {
    return line.mayHave(option) && line.has(option);
  };
  if (std::ranges::any_of(flag.unless, isGiven)) return;
  const std::string job = dashed(line.job->name);
  throw InputError(dashed(flag.name), "is missing; " + job + " needs " + dashed(flag.name) + " " +
                                          std::string(flag.value) + ", see --help " +
                                          job.substr(2));
}

void addOptions(const std::vector<Given>& all, CommandLine& line) {
  for (const Flag& flag : allFlags())
    if (accepts(line.job, flag)) line.options[flag.name];
  for (const Given& given : all) {
    if (given.flag == nullptr) continue;
    refuseForeign(*given.flag, line.job);
    checkValue(*given.flag, given.value);
    line.options[given.flag->name].push_back(given.value);
  }
  for (const Flag& flag : allFlags()) refuseMissing(flag, line);
}

/// Quotes a word for a shell, if necessary.
std::string quoted(const std::string& word) {
  constexpr const char* plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// Returns what is wrong with a word that no option has.
std::string looseWordText(const std::vector<Given>& all, const std::string& word, const Job& of) {
  const std::string job = dashed(of.name);
  const auto isSession = [](const Given& given) { return given.name == "session"; };
  const bool isNeeded = std::ranges::find(of.needs, "session") != of.needs.end();
  const std::string help = "see --help " + job.substr(2);
  if (!isNeeded || std::ranges::any_of(all, isSession))
    return "unexpected argument of " + job + "; " + help;
  return "is no option: " + job + " reads it if you give --session " + quoted(word) + "; " + help;
}

/// Assigns words without an option: files for the window, the topic for --help, further values of a
/// job's own option; other jobs accept none.
void addLooseWords(const std::vector<Given>& all, std::vector<std::string> words,
                   CommandLine& line) {
  if (line.job == nullptr) {
    line.files = std::move(words);
  } else if (isHelp(line.job) && line.subject.empty() && words.size() == 1) {
    line.subject = words.front();
  } else if (!line.subjects.empty()) {
    std::ranges::move(words, std::back_inserter(line.subjects));
  } else if (!words.empty()) {
    throw InputError(words.front(), looseWordText(all, words.front(), *line.job));
  }
}

/// Returns the job that owns the parameter; null for a parameter of the session.
const Job* ownerOf(std::string_view parameter) {
  const std::string_view section = parameter.substr(0, parameter.find('.'));
  for (const Job& job : jobs())
    if (std::ranges::find(job.sections, section) != job.sections.end()) return &job;
  return nullptr;
}

/// Returns "section.field=value" of --set, or of a flag that sets a parameter of this job; else "".
std::string overrideBy(const Given& given, const Job* job) {
  if (given.flag == nullptr) return {};
  if (given.name == "set") return given.value;
  const Job* owner = ownerOf(given.flag->shortFor);
  if (owner == nullptr || owner != job) return {};
  return std::string(given.flag->shortFor) + "=" + given.value;
}

/// Separates the overrides of the job's own sections from the session's. Each parameter may be set
/// once.
void sortOverrides(const std::vector<Given>& all, CommandLine& line) {
  std::set<std::string> known;
  for (const Given& given : all) {
    const std::string text = overrideBy(given, line.job);
    if (text.empty()) continue;
    const std::string name = text.substr(0, text.find('='));
    if (!known.insert(name).second)
      throw InputError("--set " + text, "sets " + name + " a second time");
    const Job* owner = ownerOf(name);
    if (owner == nullptr) continue;
    if (owner != line.job) throw InputError("--set " + text, "belongs to " + dashed(owner->name));
    line.jobOverrides.push_back(text);
    std::erase(line.options["set"], text);
  }
}

/// Returns the program with its arguments, quoted for a shell.
std::string shellText(const std::vector<std::string>& arguments) {
  std::string text = "hogelscope";
  for (const std::string& word : arguments) text += " " + quoted(word);
  return text;
}

}  // namespace

CommandLine parseCommandLine(const std::vector<std::string>& arguments) {
  CommandLine line;
  line.shellText = shellText(arguments);
  std::vector<Given> all;
  std::vector<std::string> words;
  for (auto at = arguments.begin(); at != arguments.end(); ++at)
    if (at->starts_with("-") && *at != "-")
      all.push_back(parseOption(at, arguments.end()));
    else
      words.push_back(*at);
  chooseJob(all, line);
  addLooseWords(all, std::move(words), line);
  if (isHelp(line.job)) return line;
  refuseRepeated(all);
  addOptions(all, line);
  sortOverrides(all, line);
  return line;
}

}  // namespace hogelscope
