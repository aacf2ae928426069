// SPDX-License-Identifier: BSD-3-Clause
// How long work tells where it stands.
#include "core/progress.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace hogelscope {

std::string timeLeft(double secondsSoFar, double done) {
  constexpr double least = 2;  // seconds before a guess is worth showing
  if (secondsSoFar < least || done <= 0.01 || done >= 1) return {};
  const auto seconds = std::llround(secondsSoFar * (1 - done) / done);
  std::array<char, 40> text{};
  if (seconds >= 3600)
    std::snprintf(text.data(), text.size(), "%lld:%02lld:%02lld left", seconds / 3600,
                  seconds / 60 % 60, seconds % 60);
  else
    std::snprintf(text.data(), text.size(), "%lld:%02lld left", seconds / 60, seconds % 60);
  return text.data();
}

}  // namespace hogelscope
