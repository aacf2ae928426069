// SPDX-License-Identifier: BSD-3-Clause
// --rate and --group: which tests make a rate-distortion curve, and what they cost.
#pragma once

#include <filesystem>
#include <vector>

#include "cli/command_line.h"
#include "core/metrics/summary.h"

namespace hogelscope {

/// A test light field on disk.
struct TestSize {
  std::string test;                          ///< as --test names it
  std::vector<std::filesystem::path> files;  ///< of its pixels; a folder's others do not count
  double directionalPixels = 0;
};

/// Each --group with its tests' rates: those of --rate, else the sizes of its files. None without
/// --group. Throws InputError: a test that was not given, fewer than two groups or four tests, a
/// rate that is not a positive number.
std::vector<RateGroup> rateGroups(const CommandLine& line, const std::vector<TestSize>& tests);

}  // namespace hogelscope
