// SPDX-License-Identifier: BSD-3-Clause
// The table of a sweep: which parameters vary, how their values are combined into designs, and
// which figures are measured of each.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hogelscope {

/// A parameter of a sweep, such as "display.directions": its values as JSON, or a range.
struct SweepParameter {
  enum class Kind { list, range, normal };

  std::string name;
  Kind kind = Kind::list;
  std::vector<std::string> values;  ///< of a list
  double from = 0;                  ///< of a range; of a normal distribution, its mean
  double to = 0;                    ///< of a range; of a normal distribution, its deviation
  int count = 0;                    ///< of a range's values; 0: not given
  bool isWhole = false;             ///< whether its values are whole numbers

  /// Returns the value at a share 0 … 1 of the list, the range or the distribution, as JSON.
  [[nodiscard]] std::string at(double share) const;
};

/// A figure that designs are compared by; `goal` +1: more is better, −1: less is.
struct SweepGoal {
  std::string figure;
  int goal = 1;
};

/// Bounds a figure of a good unit; infinite where there is no limit.
struct SweepLimit {
  std::string figure;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool allows(double value) const { return value >= least && value <= most; }
};

/// "solve": the largest value of a parameter with which at least this share of units passes. The
/// limits of good units are those of the table.
struct SweepSolve {
  std::string parameter;
  double yield = 0;            ///< above 0, below 1
  std::optional<double> from;  ///< of the values that are looked at; none: of the parameter's own
  std::optional<double> to;
};

enum class SweepSampling { grid, latinHypercube };

struct SweepTable {
  std::vector<SweepParameter> parameters;
  SweepSampling sampling = SweepSampling::grid;
  int count = 0;  ///< of designs, for a Latin hypercube
  std::uint64_t seed = 1;
  std::vector<std::string> figures;
  std::vector<SweepGoal> pareto;
  std::vector<SweepLimit> pass;
  std::optional<SweepSolve> solve;
};

/// The most designs of a sweep.
constexpr std::size_t mostDesigns = 1000000;

/// Reads a table. Throws InputError that begins with the file's name.
SweepTable loadSweepTable(const std::filesystem::path& file);
/// Parses it. Throws InputError.
SweepTable parseSweepTable(const std::string& text);

/// A design: the value of each parameter as JSON.
using Design = std::vector<std::string>;
/// Returns all designs: every combination, the last parameter changing first, or a Latin hypercube
/// (McKay, Beckman and Conover 1979), in which each parameter's values are even over its range.
std::vector<Design> designsOf(const SweepTable& table);

/// Returns the overrides of a session that make a design, as --set takes them.
std::vector<std::string> overridesOf(const SweepTable& table, const Design& design);

/// Whether the designs are units that were drawn, whose share that passes is a yield: by normal
/// distributions or seeds, or errors of a twin in a Latin hypercube.
bool areUnits(const SweepTable& table);

}  // namespace hogelscope
