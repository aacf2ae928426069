// SPDX-License-Identifier: BSD-3-Clause
#include "core/cameras/frame_states.h"

#include <algorithm>
#include <charconv>

#include "core/base/error.h"

namespace hogelscope {

namespace {

/// Returns the numbers of "0:99:10"; none if the text is anything else.
std::vector<int> numbersOf(const std::string& text) {
  std::vector<int> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (;;) {
    int number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc() || number < 0) return {};
    numbers.push_back(number);
    if (next == end) return numbers;
    if (*next != ':') return {};
    at = next + 1;
  }
}

std::string textOf(const FrameNumbers& frames) {
  const auto [first, last, step] = frames;
  return std::to_string(first) + ":" + std::to_string(last) +
         (step == 1 ? "" : ":" + std::to_string(step));
}

}  // namespace

std::vector<FrameState> statesAtFrames(const std::vector<CameraState>& states,
                                       const FrameNumbers& wanted, const FrameNumbers& listed,
                                       double rate) {
  std::vector<FrameState> result;
  for (const CameraState& state : states) {
    const double time = state.camera.time;
    if (time == notGiven || listed.isStill()) {
      for (std::size_t k = 0; k < wanted.count(); ++k) result.push_back({state, wanted.number(k)});
      continue;
    }
    if (!(rate > 0))
      throw InputError(state.camera.name + ": time",
                       "needs lightField.fps: the light field does not say its frame rate");
    result.push_back({state, listed.shownAt(time, rate)});
  }
  std::ranges::stable_sort(result, {}, &FrameState::frame);
  return result;
}

std::string frameDigits(int frame, const FrameNumbers& listed) {
  constexpr std::size_t usual = 4;
  const std::size_t digits = std::max(usual, std::to_string(listed.last).size());
  const std::string number = std::to_string(frame);
  return std::string(digits - std::min(digits, number.size()), '0') + number;
}

FrameNumbers framesFrom(const std::string& name, const std::string& text,
                        const FrameNumbers& listed) {
  if (text == "all") return listed;
  const std::vector<int> numbers = numbersOf(text);
  const bool isRange = !numbers.empty() && numbers.size() < 4;
  const int step = numbers.size() > 2 ? numbers[2] : numbers.size() > 1 ? listed.step : 1;
  if (!isRange || step < 1 || (numbers.size() > 1 && numbers[1] < numbers[0]))
    throw InputError(name + " " + text,
                     "must be all, a frame, or FIRST:LAST:STEP, such as 0:99:10");
  const FrameNumbers frames =
      framesBetween(numbers[0], numbers.size() > 1 ? numbers[1] : numbers[0], step);
  for (std::size_t k = 0; k < frames.count(); ++k)
    if (const int frame = frames.number(k); !listed.has(frame))
      throw InputError(name + " " + text, "has frame " + std::to_string(frame) +
                                              ", but the light field's are " + textOf(listed));
  return frames;
}

}  // namespace hogelscope
