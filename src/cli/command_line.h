// SPDX-License-Identifier: BSD-3-Clause
// The command line as a value.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hogelscope {

struct Job;

/// A job and its options, with checked values. Reading an option that the job does not have throws
/// std::logic_error.
struct CommandLine {
  const Job* job = nullptr;  ///< null: the window
  /// The value of the job's own option: a camera set, a pattern, a light field or a file; the topic
  /// for --help.
  std::string subject;
  std::vector<std::string> subjects;      ///< all values, if the job's option may be repeated
  std::string shellText;                  ///< the whole command line, quoted for a shell
  std::vector<std::string> files;         ///< opened in the window
  std::vector<std::string> jobOverrides;  ///< --set of the job's own sections, such as pattern
  /// The values of each option that the job may have; empty if the option is not given. Those of
  /// --set are for the session.
  std::map<std::string_view, std::vector<std::string>> options;

  [[nodiscard]] bool mayHave(std::string_view option) const { return options.contains(option); }
  [[nodiscard]] bool has(std::string_view option) const { return !texts(option).empty(); }
  [[nodiscard]] const std::vector<std::string>& texts(std::string_view option) const;
  [[nodiscard]] std::string text(std::string_view option, const char* otherwise = "") const;
  [[nodiscard]] std::optional<double> number(std::string_view option) const;
};

/// Parses the arguments by the tables of jobs and options. Throws InputError for an unknown option
/// (with the nearest known one), one that the job does not use, one given twice, a missing or an
/// invalid value.
CommandLine parseCommandLine(const std::vector<std::string>& arguments);

}  // namespace hogelscope
