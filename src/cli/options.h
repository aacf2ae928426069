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
  std::string session;
  std::string output;
  std::string calibration;
  std::string calibrations;        ///< --stability
  std::string cameras;             ///< --make-cameras: a distribution or a file
  std::string pattern;             ///< --generate
  std::string packed;              ///< --pack: a light field
  std::string degrade;             ///< --generate: "jpeg:60"
  std::string infoFile;            ///< --info
  std::vector<std::string> files;  ///< without a flag: to open, or a topic of --help
  std::vector<std::string> tests;
  std::vector<std::string> overrides;  ///< --set
  std::vector<std::string> rates;      ///< FILE=bpp
  std::vector<std::string> groups;     ///< NAME=FILE,FILE,…
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

/// Throws InputError: an unknown flag (with the nearest one), a missing or a wrong value.
Options parseOptions(const std::vector<std::string>& arguments);

/// Is it a --set of a camera set (cameraSet or cameraRegion) and not of the session?
bool isOfCameraSet(const std::string& override);

/// Is it one of a pattern (pattern)?
bool isOfPattern(const std::string& override);

/// What --help prints; `topic` is "" or "parameters".
std::string helpText(const std::string& topic);

}  // namespace hogelscope
