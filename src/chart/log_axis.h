// SPDX-License-Identifier: BSD-3-Clause
// A logarithmic axis of a chart: values to places, and ticks.
#pragma once

#include <vector>

namespace hogelscope {

struct Tick {
  double value = 0;
  double place = 0;         ///< points
  bool isLabelled = false;  ///< a minor one is not
};

class LogAxis {
 public:
  /// `least` and `most`, both > 0 and finite, lie at `from` and `to`, points. A range of less than
  /// a decade is widened to one, so that ticks tell.
  LogAxis(double least, double most, double from, double to);

  /// log10 of the values at the ends: the values may be near the end of what doubles hold.
  double leastLog() const { return m_least; }
  double mostLog() const { return m_most; }
  double place(double value) const;
  bool holds(double value) const;
  /// Labelled ones are at least `room` points apart.
  std::vector<Tick> ticks(double room) const;

 private:
  bool isLabelled(int decade, int digit, double room) const;

  double m_least;
  double m_most;
  double m_from;
  double m_to;
};

}  // namespace hogelscope
