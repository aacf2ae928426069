// SPDX-License-Identifier: BSD-3-Clause
// The command line, as a value.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace hogelscope {

enum class Command {
  window,
  render,
  report,
  makeCameras,
  generate,
  pack,
  tradeoff,
  stability,
  info,
  help,
  version
};

struct Options {
  Command command = Command::window;
  std::string commandLine;  ///< as a shell would take it
  /// What follows the job's own option: a camera set, a pattern, a light field, a file, or the
  /// topic of --help.
  std::string subject;
  std::string session;
  std::string output;
  std::string calibration;
  std::string calibrations;
  std::string degrade;             ///< "jpeg:60"
  std::vector<std::string> files;  ///< to open in the window
  std::vector<std::string> tests;
  std::vector<std::string> overrides;     ///< --set of the session
  std::vector<std::string> jobOverrides;  ///< --set of the job's own sections, such as pattern
  std::vector<std::string> rates;         ///< FILE=bpp
  std::vector<std::string> groups;        ///< NAME=FILE,FILE,…
  std::string states = "*";
  std::string format = "png";
  std::optional<double> failBelow;  ///< dB
  std::optional<int> seed;
  int threads = 0;                    ///< 0: all
  std::optional<std::size_t> memory;  ///< bytes for light fields
  bool masks = false;
  bool images = false;
  bool explain = false;
  bool quiet = false;
};

/// Throws InputError: an unknown option (with the nearest one), one that the job does not use, one
/// given twice, a missing or a wrong value.
Options parseOptions(const std::vector<std::string>& arguments);

/// What --help prints; `topic` is "", "parameters" or a job's name. Throws InputError.
std::string helpText(const std::string& topic);

}  // namespace hogelscope
