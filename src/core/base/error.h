// SPDX-License-Identifier: BSD-3-Clause
// The one exception for input that a user can mend; main() turns it into one line and status 2.
#pragma once

#include <stdexcept>
#include <string>

namespace hogelscope {

/// Reads as "FILE: WHAT: WHY". `what` is a JSON path, an option or a part of the file; it or the
/// file may be empty where none is known (yet).
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, std::string what, std::string why);
  InputError(std::string what, std::string why) : InputError({}, std::move(what), std::move(why)) {}

  /// The same error, in `file`, unless it already names one.
  [[nodiscard]] InputError in(const std::string& file) const;

 private:
  std::string m_file;
  std::string m_what;
  std::string m_why;
};

/// A user or a newer request said stop; nothing is wrong.
class Cancelled : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "stopped"; }
};

}  // namespace hogelscope
