// SPDX-License-Identifier: BSD-3-Clause
// "solve" of a sweep: the largest value of a parameter with which a share of drawn units passes.
// Random numbers are common: a unit has the same draws at every value, scaled. So each unit has a
// limit of its own, up to which it passes, and the value is an order statistic of the limits.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/optics/session.h"
#include "measure/sweep_table.h"

namespace hogelscope {

/// The units of a table with "solve", at any value of its parameter.
class UnitsAtValue {
 public:
  /// Finds the parameter: a number of the session, or "P.sigma", the deviation of the parameter P,
  /// which the table draws from a normal distribution. Throws InputError (solve.…) if there is
  /// none, if it is no single real number, or if the table draws no units.
  UnitsAtValue(const SweepTable& table, const Session& session);

  [[nodiscard]] std::size_t count() const { return m_drawn.size(); }
  /// Returns the ends of the values that are looked at, and their unit.
  [[nodiscard]] double least() const { return m_least; }
  [[nodiscard]] double most() const { return m_most; }
  [[nodiscard]] const std::string& unitOfValue() const { return m_unit; }
  /// Returns the table whose designs are the units at a value.
  [[nodiscard]] SweepTable tableAt(double value) const;
  /// Returns designsOf(tableAt(value))[unit].
  [[nodiscard]] Design at(std::size_t unit, double value) const;

 private:
  SweepTable m_table;  ///< with the parameter as its last one, unless it is a deviation
  std::size_t m_parameter;
  bool m_isDeviation = false;
  std::vector<Design> m_drawn;  ///< of deviation 1 and mean 0
  double m_least = 0;
  double m_most = 0;
  std::string m_unit;
};

/// The value that was found, between UnitsAtValue::least() and most().
struct SolvedValue {
  double value = 0;     ///< NaN if too few units pass even at the least value
  bool isMost = false;  ///< whether enough units pass even at the largest value
  double low = 0;       ///< of the 95 % interval of the value; NaN: too few units to say
  double high = 0;
  std::size_t passed = 0;  ///< units that pass at the value, or at the least one if there is none
  std::size_t needed = 0;  ///< units that should
  std::size_t count = 0;
};

/// Returns the largest value that the share of the limits reaches. A unit's limit is infinite if it
/// passes at the largest value, NaN if it fails at the least one. The interval is that of the order
/// statistics of independent units, whatever their distribution (Clopper and Pearson's binomial,
/// Biometrika 26, 1934). `passed` is counted by the limits.
SolvedValue solvedValue(std::vector<double> limits, double share, double least, double most);

/// Returns a sentence such as "largest psf.sigma for a yield of 95 %: 0.0123 (0.0101 … 0.014)".
std::string solveText(const UnitsAtValue& units, const SweepSolve& solve, const SolvedValue& found);
/// Returns "sweep.json".
std::string solveJson(const UnitsAtValue& units, const SweepSolve& solve, const SolvedValue& found);

}  // namespace hogelscope
