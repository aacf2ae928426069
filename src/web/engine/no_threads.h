// SPDX-License-Identifier: BSD-3-Clause
// Completes the standard library for WebAssembly of Debian 12 and 13 (LLVM 19), which lacks locks,
// numbers from text and Bessel functions. It is included before every source.
#pragma once

#include <__mutex/lock_guard.h>
#include <__mutex/tag_types.h>
#include <__mutex/unique_lock.h>

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

namespace std {

struct mutex {
  void lock() {}
  bool try_lock() { return true; }
  void unlock() {}
};

template <class Mutex>
struct unique_lock {
  explicit unique_lock(Mutex& /*mutex*/) {}
  unique_lock(Mutex& /*mutex*/, try_to_lock_t /*how*/) {}
  bool operator!() const { return false; }
};

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const string text(first, last);
  char* end = nullptr;
  errno = 0;
  const double read = strtod(text.c_str(), &end);
  const bool isNone = end == text.c_str() || text[0] == ' ' || text[0] == '+';
  if (isNone) return {first, errc::invalid_argument};
  if (errno == ERANGE) return {first + (end - text.c_str()), errc::result_out_of_range};
  value = read;
  return {first + (end - text.c_str()), errc()};
}

/// The power series of the modified Bessel function I_n (DLMF 10.25.2), for x below 100.
inline double cyl_bessel_i(double order, double x) {
  double term = exp(order * log(x / 2) - lgamma(order + 1));
  double sum = term;
  for (int k = 1; term > 1e-17 * sum; ++k) {
    term *= x * x / 4 / (k * (k + order));
    sum += term;
  }
  return sum;
}

}  // namespace std
