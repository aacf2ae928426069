// SPDX-License-Identifier: BSD-3-Clause
// The numbers of a session by their names in overrides, such as "twin.lensArray.rotation": what
// sweeps vary, with units and ranges.
#pragma once

#include <string>
#include <vector>

#include "core/base/parameters.h"
#include "core/optics/session.h"

namespace hogelscope {

/// A number of a session, or one of the list of numbers that a field is.
struct SessionNumber {
  std::string name;   ///< of the field, with its section
  std::string label;  ///< of the field in forms; "" if its name says it
  std::string unit;
  Range range;
  bool isWhole = false;
  bool counts = true;     ///< false if another field makes it meaningless
  std::size_t index = 0;  ///< in the list
  std::size_t count = 1;  ///< of numbers in the list
  double value = 0;
};

/// Returns all numbers of the session and of one of its states, in the order of documents.
std::vector<SessionNumber> numbersOf(const Session& session, std::size_t state = 0);

/// Sets the number of this name and index; whole ones are rounded.
void setNumber(Session& session, std::size_t state, const SessionNumber& which, double value);

}  // namespace hogelscope
