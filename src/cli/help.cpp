// SPDX-License-Identifier: BSD-3-Clause
// What --help prints.
#include <algorithm>

#include "cli/flags.h"
#include "cli/manual.h"
#include "core/error.h"

namespace hogelscope {

namespace {

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

}  // namespace

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
