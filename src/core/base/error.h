// SPDX-License-Identifier: BSD-3-Clause
// The exception for user-correctable input; main() prints it as one line and returns status 2.
#pragma once

#include <stdexcept>
#include <string>

namespace hogelscope {

/// An input error. Its message is "FILE: WHAT: WHY". `what` is a JSON path, a parameter or a part
/// of the file; it or the file may be empty if unknown (yet).
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

/// Returns the result of `action`. An InputError of it gets `file` as its file, as InputError::in()
/// says.
template <class Action>
decltype(auto) inFile(const std::string& file, const Action& action) {
  try {
    return action();
  } catch (const InputError& error) {
    throw error.in(file);
  }
}

/// Thrown when a user or a newer request cancels the work; not an error.
class Cancelled : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "stopped"; }
};

}  // namespace hogelscope
