// SPDX-License-Identifier: BSD-3-Clause
#include "cli/help.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iostream>

#include "cli/flags.h"
#include "cli/jobs.h"
#include "core/base/error.h"
#include "core/base/parameters.h"
#include "core/base/version.h"

namespace hogelscope {

namespace {

constexpr std::size_t indent = 26;

/// Returns the number of UTF-8 characters, whose continuation bytes begin with the bits 10.
std::size_t columnsOf(std::string_view text) {
  return std::size_t(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// Breaks `text` at spaces into lines of at most 100 columns, the later ones indented.
std::string wrapped(std::string_view text, std::size_t from) {
  constexpr std::size_t width = 100;
  std::string out;
  std::size_t column = from;
  while (!text.empty()) {
    const std::string_view wordText = text.substr(0, text.find(' '));
    if (column + columnsOf(wordText) > width) {
      out.back() = '\n';
      out += std::string(from, ' ');
      column = from;
    }
    out += std::string(wordText) + " ";
    column += columnsOf(wordText) + 1;
    text.remove_prefix(std::min(text.size(), wordText.size() + 1));
  }
  out.pop_back();
  return out + "\n";
}

std::string entry(std::string_view name, std::string_view value, std::string_view help) {
  std::string head = "  --" + std::string(name);
  if (!value.empty()) head += " " + std::string(value);
  const std::size_t columns = columnsOf(head);
  head +=
      columns + 2 > indent ? "\n" + std::string(indent, ' ') : std::string(indent - columns, ' ');
  return head + wrapped(help, indent);
}

/// Returns an option's help with its jobs in front, or with the jobs that lack it behind.
std::string helpWithJobs(const Flag& flag) {
  constexpr std::size_t few = 4;
  const std::vector<const Job*> owners = jobsOf(flag);
  std::vector<const Job*> others;
  for (const Job& job : jobs())
    if (job.name != "help" && job.name != "version" && !accepts(&job, flag)) others.push_back(&job);
  std::string help(flag.help);
  if (owners.size() <= few) {
    const bool isAcronym = std::isupper(static_cast<unsigned char>(help[1])) != 0;
    if (!isAcronym) help[0] = char(std::tolower(static_cast<unsigned char>(help[0])));
    return optionsOf(owners) + ": " + help;
  }
  return others.empty() ? help : help + " Not for " + optionsOf(others) + ".";
}

std::string overview() {
  std::string text =
      "hogelscope: what a viewer or a camera would see on a light field display\n"
      "\n"
      "  hogelscope [FILE ...]            opens the window, with a session or a light field\n"
      "  hogelscope --JOB [OPTION ...]    does a job without a window\n"
      "  hogelscope --help JOB            explains one job: its options, examples\n"
      "  hogelscope --help parameters     lists every parameter that --set knows\n"
      "  hogelscope --help man            prints the man page; \"completion\" that of bash\n"
      "\n"
      "Try it on the paper's six camera states, from the folder of the sources:\n"
      "  hogelscope --render --session data/table1.json --output out --masks\n"
      "  hogelscope --render --session data/table1.json --output out --states 'Fig 1' \\\n"
      "             --set sampling.mapping=direct --set psf.windowSize=1\n"
      "  hogelscope --info data/table1.json\n"
      "\n"
      "Jobs, of which a command line has one (LF: a light field, which is an image of hogels, a\n"
      "quilt, a mosaic, a folder of views, or a store):\n";
  for (const Job& job : jobs()) text += entry(job.name, job.value, job.help);
  for (const Flag& flag : allFlags()) {
    if (!flag.heading.empty()) text += "\n" + std::string(flag.heading) + ":\n";
    text += entry(flag.name, flag.value, helpWithJobs(flag));
  }
  return text +
         "\n"
         "An option that the job does not use is refused, and so is one that is given twice.\n"
         "Exit status: 0 done, 1 a gate failed (--fail-below), 2 bad input, 3 internal error.\n"
         "Errors go to stderr as hogelscope: FILE: WHAT: WHY.\n";
}

/// Returns the entries of the options that a job requires, or of its optional ones.
std::string entriesFor(const Job& job, bool areNeeded) {
  std::string text;
  for (const Flag& flag : allFlags())
    if (accepts(&job, flag) && needs(&job, flag) == areNeeded)
      text += entry(flag.name, flag.value, flag.help);
  return text;
}

std::string explained(const Job& job) {
  std::string text = "hogelscope --" + std::string(job.name);
  if (!job.value.empty()) text += " " + std::string(job.value);
  for (const Flag& flag : allFlags())
    if (needs(&job, flag)) text += " --" + std::string(flag.name) + " " + std::string(flag.value);
  text += "\n\n" + wrapped(job.help, 0);
  if (!job.details.empty()) text += "\n" + wrapped(job.details, 0);
  const std::string needed = entriesFor(job, true);
  if (!needed.empty()) text += "\nIt needs:\n" + needed;
  const std::string others = entriesFor(job, false);
  if (!others.empty()) text += "\nIt also takes:\n" + others;
  if (!job.sections.empty()) {
    text += "\nWith --set it also knows the parameters of";
    for (const std::string_view section : job.sections)
      text += (section == job.sections.front()  ? " "
               : section == job.sections.back() ? " and "
                                                : ", ") +
              std::string(section);
    text += "; see --help parameters.\n";
  }
  if (!job.examples.empty()) text += "\nExamples:\n" + std::string(job.examples);
  return text;
}

/// A topic of --help whose text is for other programs.
struct Topic {
  std::string_view name;
  std::string (*text)();
};

constexpr std::array topics{Topic{"parameters", parameterManual}, Topic{"man", manPage},
                            Topic{"completion", bashCompletion}};

}  // namespace

std::vector<std::string_view> helpTopics() {
  std::vector<std::string_view> names;
  for (const Topic& topic : topics) names.push_back(topic.name);
  for (const Job& job : jobs()) names.push_back(job.name);
  return names;
}

std::string helpText(const std::string& topic) {
  if (topic.empty()) return overview();
  for (const auto& [name, text] : topics)
    if (topic == name) return text();
  for (const Job& job : jobs())
    if (topic == job.name) return explained(job);
  const std::string_view nearest = nearestName(topic, helpTopics());
  throw InputError("--help " + topic,
                   nearest.empty() ? "there is no such topic; a topic is a job, \"parameters\", "
                                     "\"man\" or \"completion\""
                                   : "there is no such topic; did you mean --help " +
                                         std::string(nearest) + "?");
}

Job helpJob() {
  return {.name = "help",
          .help =
              "This text; with a job, or \"parameters\", more of it; with \"man\" or "
              "\"completion\" what man and bash read.",
          .run = [](const CommandLine& line) {
            std::cout << helpText(line.subject);
            return 0;
          }};
}

Job versionJob() {
  return {.name = "version", .help = "The version.", .run = [](const CommandLine& /*line*/) {
            std::cout << "hogelscope " << programVersion() << "\n";
            return 0;
          }};
}

}  // namespace hogelscope
