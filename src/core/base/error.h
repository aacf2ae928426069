// SPDX-License-Identifier: BSD-3-Clause
// The one exception for input that a user can fix; main() turns it into one line and status 2.
#pragma once

#include <stdexcept>
#include <string>

namespace hogelscope {

/// The message is "FILE: WHAT: WHY". `what` is a JSON path, a parameter or a part of the file; it
/// or the file may be empty where it is not known (yet).
class InputError : public std::runtime_error {
 public:
  InputError(std::string file, std::string what, std::string why);
  InputError(std::string what, std::string why) : InputError({}, std::move(what), std::move(why)) {}

  /// Returns the same error with `file` as its file, unless it already names one.
  [[nodiscard]] InputError in(const std::string& file) const;

 private:
  std::string m_file;
  std::string m_what;
  std::string m_why;
};

/// Thrown where a user or a newer request cancels the work; it is not an error.
class Cancelled : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "stopped"; }
};

}  // namespace hogelscope
