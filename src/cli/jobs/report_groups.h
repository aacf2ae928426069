// SPDX-License-Identifier: BSD-3-Clause
// --rate and --group: the tests of each rate-distortion curve, and their rates.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/command_line.h"
#include "core/metrics/summary.h"

namespace hogelscope {

/// A test light field on disk.
struct TestSize {
  std::string test;                          ///< as given by --test
  std::vector<std::filesystem::path> files;  ///< with pixels; other files of a folder do not count
  double directionalPixels = 0;
};

/// Returns each --group with its tests' rates: those of --rate, else from the file sizes; none
/// without
/// --group. Throws InputError for a test that was not given, fewer than two groups or four tests,
/// or a
/// rate that is not a positive number.
std::vector<RateGroup> rateGroups(const CommandLine& line, const std::vector<TestSize>& tests);

}  // namespace hogelscope
