// SPDX-License-Identifier: BSD-3-Clause
// The frames of a light field that changes in time. A frame is a light field; its number is the one
// in its files' names or, of a video, counts from 0 (docs/formulas.md, Frames).
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

namespace hogelscope {

/// Stands for the number of a frame, in names of files and in patterns of them.
inline constexpr std::string_view frameMark = "{T}";

/// Frames first, first + step, … up to last, which is one of them. A still has one.
struct FrameNumbers {
  int first = 0;
  int last = 0;
  int step = 1;

  [[nodiscard]] std::size_t count() const { return std::size_t((last - first) / step) + 1; }
  [[nodiscard]] int number(std::size_t index) const { return first + step * int(index); }
  [[nodiscard]] bool has(int number) const {
    return number >= first && number <= last && (number - first) % step == 0;
  }
  [[nodiscard]] bool isStill() const { return first == last; }
  /// Returns the frame that is shown at a time in seconds, which begins with the first one, if
  /// `rate` frames are shown in a second, listed or not: the last listed one at that time.
  [[nodiscard]] int shownAt(double time, double rate) const {
    constexpr double rounding = 1e-6;  // a frame's own time, k / rate, is not before it
    const double passed = std::floor(time * rate + rounding);
    if (!(passed < last - first)) return last;
    return first + int(passed) / step * step;
  }
  bool operator==(const FrameNumbers&) const = default;
};

/// Returns frames with a `last` that is one of them, from limits that may lie between two.
inline FrameNumbers framesBetween(int first, int last, int step) {
  return {first, first + (last - first) / step * step, step};
}

/// Returns the frame of another light field that is compared with one of these: that of the same
/// place if both have equally many, otherwise of the same number; with a still the first one. None
/// if there is no such frame.
inline std::optional<int> sameFrame(const FrameNumbers& ours, int frame,
                                    const FrameNumbers& others) {
  if (ours.isStill()) return others.first;
  if (ours.count() == others.count())
    return others.number(std::size_t((frame - ours.first) / ours.step));
  if (others.has(frame)) return frame;
  return std::nullopt;
}

}  // namespace hogelscope
