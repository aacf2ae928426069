// SPDX-License-Identifier: BSD-3-Clause
// The quantities of a design or of its twin that the Measure workspace varies, by sliders and in a
// sweep.
#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "core/optics/session.h"

namespace hogelscope {

/// Says what stays as it is when the number of hogels, or the panel's size, changes.
enum class Hold { size, pitch, pixels };

/// A quantity of the display, of its twin, or of a state. Of a pair it is the value across; the
/// value down keeps its ratio to it, and one direction down stays one.
struct DesignParameter {
  const char* name;  ///< of its widgets; "" if only a sweep varies it
  QString label;
  QString unit;
  double least;
  double most;
  bool isLogarithmic;
  bool isWhole;
  std::function<double(const Session& session, std::size_t state)> get;
  std::function<void(Session& session, std::size_t state, double value)> set;
  double usualLeast = least;  ///< of the values that people use
  double usualMost = most;
  bool isOfTwin = false;

  /// Returns the place of a value between `least` and `most`, 0 … 1, and the value at a place,
  /// rounded to three digits.
  [[nodiscard]] double shareOf(double value) const;
  [[nodiscard]] double at(double share) const;
  /// Returns "64" or "0.56 m".
  [[nodiscard]] QString text(double value) const;
};

const std::vector<DesignParameter>& designParameters();
/// Returns these and all other numbers of the display and of its twin; of a list, each number.
const std::vector<DesignParameter>& sweptParameters();

/// Returns the session with another value of a parameter.
Session withValue(Session session, std::size_t state, const DesignParameter& parameter,
                  double value, Hold hold);

}  // namespace hogelscope
