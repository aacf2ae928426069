// SPDX-License-Identifier: BSD-3-Clause
#include "core/cameras/focus_stack.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.h"
#include "core/panel/design_numbers.h"

namespace hogelscope {

std::vector<double> focusDistances(const CameraState& state, const PanelParams& display,
                                   int count) {
  constexpr double nearest = 0.1;
  constexpr double farthest = 10;
  if (!(state.pupil.diameter > 0))
    throw InputError("pupil.diameter",
                     "is 0, a pinhole, which sees everything sharp: give metres, such as 0.004");
  const DesignNumbers numbers = designNumbers(display, state.camera.eye);
  if (!(numbers.distance > 0))
    throw InputError("eye", "is not in front of the panel: there is no depth to focus on");
  const double along = axisDistance(state.camera, display);
  // Depths are on the panel's normal; the axis meets them farther away, as it does the panel.
  const double stretch = along > 0 ? along / numbers.distance : 1;
  const auto cut = [&](double distance) {
    return std::clamp(stretch * distance, nearest, farthest);
  };
  const double first = 1 / cut(numbers.distance - numbers.depthFront);
  const double last = 1 / cut(numbers.distance + numbers.depthBehind);
  if (!(first > last))
    throw InputError("pupil.focus",
                     "has no range: the depths that the display can show are not between 0.1 and "
                     "10 m from the eye");
  std::vector<double> distances;
  distances.reserve(std::size_t(count));
  for (int k = 0; k < count; ++k)
    distances.push_back(1 / std::lerp(first, last, double(k) / (count - 1)));
  return distances;
}

std::vector<CameraState> focusStack(const CameraState& state,
                                    const std::vector<double>& distances) {
  const std::size_t digits = std::max<std::size_t>(2, std::to_string(distances.size()).size());
  std::vector<CameraState> states(distances.size(), state);
  for (std::size_t k = 0; k < states.size(); ++k) {
    const std::string number = std::to_string(k + 1);
    states[k].camera.name += ".focus" + std::string(digits - number.size(), '0') + number;
    states[k].pupil.focus = distances[k];
  }
  return states;
}

}  // namespace hogelscope
