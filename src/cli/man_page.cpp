// SPDX-License-Identifier: BSD-3-Clause
#include "cli/help.h"

#include "cli/flags.h"
#include "cli/jobs.h"
#include "core/base/version.h"

namespace hogelscope {

namespace {

/// Escapes `text` for man(7), so that hyphens can be copied into a shell.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool isLineStart = out.empty() || out.back() == '\n';
    if (isLineStart && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

std::string bold(std::string_view text) {
  return "\\fB" + escaped(text) + "\\fR";
}

std::string option(std::string_view name, std::string_view value) {
  const std::string dashed = bold("--" + std::string(name));
  return value.empty() ? dashed : dashed + " \\fI" + escaped(value) + "\\fR";
}

/// Returns the options that the job requires, such as "--output PATH --session FILE".
std::string needsOf(const Job& job) {
  std::string text;
  for (const Flag& flag : allFlags())
    if (needs(&job, flag)) text += " " + option(flag.name, flag.value);
  return text;
}

std::string jobEntry(const Job& job) {
  std::string text =
      ".TP\n" + option(job.name, job.value) + needsOf(job) + "\n" + escaped(job.help) + "\n";
  if (!job.details.empty()) text += escaped(job.details) + "\n";
  return text;
}

std::string flagEntry(const Flag& flag) {
  return ".TP\n" + option(flag.name, flag.value) + "\n" + escaped(flag.help) + "\n.br\nFor " +
         escaped(optionsOf(jobsOf(flag))) + (flag.isForWindow ? ", and the window" : "") + ".\n";
}

std::string examples() {
  std::string text;
  for (const Job& job : jobs())
    if (!job.examples.empty())
      text +=
          ".SS " + bold("--" + std::string(job.name)) + "\n.EX\n" + escaped(job.examples) + ".EE\n";
  return text;
}

}  // namespace

std::string manPage() {
  std::string text =
      ".\\\" Made by hogelscope --help man\n"
      ".TH HOGELSCOPE 1 \"\" \"Hogelscope " +
      std::string(programVersion()) +
      "\" \"User Commands\"\n"
      ".SH NAME\nhogelscope \\- what a camera would see on a light field display\n"
      ".SH SYNOPSIS\n"
      ".B hogelscope\n[\\fIFILE\\fR ...]\n.br\n"
      ".B hogelscope\n\\fB\\-\\-\\fIJOB\\fR [\\fIOPTION\\fR ...]\n"
      ".SH DESCRIPTION\n"
      "Takes the content and geometry of a light field display, a camera with its lens distortion, "
      "and\nthe display's light leakage, gives the picture that the camera would take, and "
      "compares "
      "such\npictures over many camera positions. Without a job the window opens, with a session, "
      "a light\nfield or a scene.\n"
      ".PP\n"
      "A session is a JSON document, \\fIFILE\\fR.hogelscope or \\fIFILE\\fR.json: the display, "
      "its "
      "light\nfield, and camera states. Its parameters are listed by "
      "\\fBhogelscope \\-\\-help parameters\\fR.\n"
      ".PP\n"
      "LF is a light field: an image of hogels, a quilt, a mosaic, a folder of views, or a store.\n"
      ".SH JOBS\nA command line has one of them. Options that it cannot do without stand beside "
      "it.\n";
  for (const Job& job : jobs()) text += jobEntry(job);
  text +=
      ".SH OPTIONS\nOne that the job does not use is refused, and so is one that is given "
      "twice.\n";
  for (const Flag& flag : allFlags()) {
    if (!flag.heading.empty()) text += ".SS " + escaped(flag.heading) + "\n";
    text += flagEntry(flag);
  }
  return text + ".SH EXAMPLES\n" + examples() +
         ".SH EXIT STATUS\n"
         "0: done. 1: a gate failed (\\fB\\-\\-fail\\-below\\fR). 2: bad input. 3: internal "
         "error.\n"
         "Errors go to the standard error output, one line each.\n"
         ".SH FILES\n"
         ".TP\n.I ~/.local/lib/hogelscope/plugins\\-1\n"
         "Your own plugins, one folder each; \\fBhogelscope \\-\\-plugins\\fR lists all that are "
         "found.\n";
}

}  // namespace hogelscope
