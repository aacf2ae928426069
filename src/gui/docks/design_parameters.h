// SPDX-License-Identifier: BSD-3-Clause
// The quantities of a design that the Measure workspace varies, by sliders and in a sweep.
#pragma once

#include <QString>
#include <vector>

#include "core/optics/session.h"

namespace hogelscope {

/// Says what stays as it is when the number of hogels, or the panel's size, changes.
enum class Hold { size, pitch, pixels };

/// A quantity of the display, or of a state. Of a pair it is the value across; the value down keeps
/// its ratio to it, and one direction down stays one.
struct DesignParameter {
  const char* name;  ///< of its widgets
  QString label;
  QString unit;
  double least;
  double most;
  bool isLogarithmic;
  bool isWhole;
  double (*get)(const Session& session, std::size_t state);
  void (*set)(Session& session, std::size_t state, double value);

  /// Returns the place of a value between `least` and `most`, 0 … 1, and the value at a place,
  /// rounded to three digits.
  [[nodiscard]] double shareOf(double value) const;
  [[nodiscard]] double at(double share) const;
  /// Returns "64" or "0.56 m".
  [[nodiscard]] QString text(double value) const;
};

const std::vector<DesignParameter>& designParameters();

/// Returns the session with another value of a parameter.
Session withValue(Session session, std::size_t state, const DesignParameter& parameter,
                  double value, Hold hold);

}  // namespace hogelscope
