// SPDX-License-Identifier: BSD-3-Clause
#include "cli/help.h"

#include <ranges>

#include "cli/flags.h"
#include "cli/jobs.h"
#include "core/content/pattern_list.h"

namespace hogelscope {

namespace {

/// The proposals for a value that --help shows as `value`: words, and "files" or "folders".
struct Proposal {
  std::string words;
  std::string paths;
};

Proposal proposalFor(std::string_view value) {
  Proposal proposal;
  if (value == "PATTERN") {
    for (const NamedPattern& pattern : patterns())
      proposal.words += std::string(pattern.name) + " ";
  } else if (value == "TOPIC") {
    for (const std::string_view topic : helpTopics()) proposal.words += std::string(topic) + " ";
  } else {
    if (mayNameFile(value)) proposal.paths = "files";
    for (const auto part : std::views::split(value, '|')) {
      const std::string_view word(part.begin(), part.end());
      if (mayNameFile(word)) continue;
      if (word == "DIR")
        proposal.paths = "folders";
      else if (value.find('|') != std::string_view::npos)
        proposal.words += std::string(word) + " ";
    }
  }
  return proposal;
}

std::string valueCase(std::string_view name, std::string_view value) {
  const auto [words, paths] = proposalFor(value);
  return "    --" + std::string(name) + ") words='" + words + "' paths='" + paths + "' ;;\n";
}

/// Returns the choices as in --help, also if there is only one.
std::string choicesOf(const Flag& flag) {
  if (flag.choices.size() == 1) return std::string(flag.choices.front()) + "|";
  return std::string(flag.value);
}

std::string valueCases() {
  std::string text;
  for (const Job& job : jobs())
    if (!job.value.empty()) text += valueCase(job.name, job.value);
  for (const Flag& flag : allFlags())
    if (!flag.value.empty()) text += valueCase(flag.name, choicesOf(flag));
  return text + valueCase("help", "TOPIC");
}

std::string flagsOf(const Job* job) {
  std::string text;
  for (const Flag& flag : allFlags())
    if (accepts(job, flag)) text += "--" + std::string(flag.name) + " ";
  return text;
}

std::string jobCases() {
  std::string text;
  for (const Job& job : jobs())
    text += "      --" + std::string(job.name) + ") options='" + flagsOf(&job) + "' ;;\n";
  return text;
}

std::string jobOptions() {
  std::string text;
  for (const Job& job : jobs()) text += "--" + std::string(job.name) + " ";
  return text;
}

std::string repeatable() {
  std::string text = " ";
  for (const Flag& flag : allFlags())
    if (flag.mayRepeat) text += "--" + std::string(flag.name) + " ";
  return text;
}

}  // namespace

std::string bashCompletion() {
  return "# Completion of hogelscope in bash. Made by hogelscope --help completion\n"
         "_hogelscope() {\n"
         "  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]}\n"
         "  local words='' paths='' options='' word\n"
         "  # --NAME=VALUE comes as three words.\n"
         "  if [[ $cur == = ]]; then\n"
         "    cur=\n"
         "  elif [[ $prev == = ]] && ((COMP_CWORD > 1)); then\n"
         "    prev=${COMP_WORDS[COMP_CWORD - 2]}\n"
         "  fi\n"
         "  case $prev in\n" +
         valueCases() +
         "    *) paths=files\n"
         "       [[ $cur == -* ]] && paths=options ;;\n"
         "  esac\n"
         "  if [[ $paths == options ]]; then\n"
         "    options='" +
         jobOptions() + flagsOf(nullptr) +
         "'\n"
         "    for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "      case $word in\n" +
         jobCases() +
         "      esac\n"
         "    done\n"
         "    for word in $options; do  # one that is given already is not proposed again\n"
         "      [[ '" +
         repeatable() +
         "' != *\" $word \"* && \" ${COMP_WORDS[*]:1:COMP_CWORD-1} \" == *\" $word \"* ]] ||\n"
         "        words+=\" $word\"\n"
         "    done\n"
         "  fi\n"
         "  mapfile -t COMPREPLY < <(\n"
         "    compgen -W \"$words\" -- \"$cur\"\n"
         "    [[ $paths != files ]] || compgen -f -- \"$cur\"\n"
         "    [[ $paths != folders ]] || compgen -d -- \"$cur\"\n"
         "  )\n"
         "  [[ $paths != files && $paths != folders ]] || compopt -o filenames 2>/dev/null\n"
         "}\n"
         "complete -F _hogelscope hogelscope\n";
}

}  // namespace hogelscope
