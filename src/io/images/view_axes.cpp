// SPDX-License-Identifier: BSD-3-Clause
#include "io/images/view_axes.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace hogelscope {

namespace {

bool isColour(std::size_t length) {
  return length == 3 || length == 4;
}

/// Reads rows × columns × height × width with or without colours, if pictures are not smaller than
/// the grid. Where rows or columns may be colours too, the grid must be a small one.
std::optional<ViewAxes> asGrid(const std::vector<std::size_t>& lengths) {
  const bool hasColours = lengths.size() == 5;
  if (!hasColours && lengths.size() != 4) return std::nullopt;
  if (hasColours && !isColour(lengths[4]) && lengths[4] != 1) return std::nullopt;
  const auto [grid, most] = std::minmax({lengths[0], lengths[1]});
  constexpr std::size_t smallGrid = 4;
  if (!hasColours && (isColour(lengths[0]) || isColour(lengths[1])) && most > smallGrid)
    return std::nullopt;
  if (most > std::min(lengths[2], lengths[3])) return std::nullopt;
  ViewAxes axes{{0, 1}, 2, 3, std::nullopt};
  if (hasColours && isColour(lengths[4])) axes.colours = 4;
  return axes;
}

/// Returns the axis of colours: the only one of 3 or 4, else the last one if it is of 3; none if it
/// is unclear. `isKnown` says whether it is clear.
std::optional<std::size_t> coloursOf(const std::vector<std::size_t>& lengths,
                                     const std::vector<std::size_t>& axes, bool& isKnown) {
  std::vector<std::size_t> found;
  for (const std::size_t axis : axes)
    if (isColour(lengths[axis])) found.push_back(axis);
  isKnown = found.size() <= 1 || (found.back() == axes.back() && lengths[found.back()] == 3);
  if (found.empty() || !isKnown) return std::nullopt;
  return found.back();
}

std::optional<ViewAxes> byLengths(const std::vector<std::size_t>& lengths) {
  std::vector<std::size_t> axes;
  for (std::size_t axis = 0; axis < lengths.size(); ++axis)
    if (lengths[axis] > 1) axes.push_back(axis);
  bool isKnown = false;
  ViewAxes found;
  if (axes.empty()) return std::nullopt;
  found.colours = coloursOf(lengths, axes, isKnown);
  std::erase_if(axes, [&](std::size_t axis) { return axis == found.colours; });
  if (!isKnown || axes.size() < 3 || axes.size() > 4) return std::nullopt;
  std::vector<std::size_t> byLength = axes;
  std::ranges::stable_sort(byLength, std::greater(),
                           [&](std::size_t axis) { return lengths[axis]; });
  if (lengths[byLength[1]] == lengths[byLength[2]]) return std::nullopt;
  found.height = std::min(byLength[0], byLength[1]);
  found.width = std::max(byLength[0], byLength[1]);
  for (const std::size_t axis : axes)
    if (axis != found.height && axis != found.width) found.views.push_back(axis);
  found.isUsual = false;
  return found;
}

/// Returns the axes of an array whose axes stand in the opposite order.
ViewAxes reversed(ViewAxes axes, std::size_t count) {
  const auto turn = [count](std::size_t& axis) { axis = count - 1 - axis; };
  for (std::size_t& axis : axes.views) turn(axis);
  turn(axes.height);
  turn(axes.width);
  if (axes.colours) turn(*axes.colours);
  return axes;
}

std::string textOf(const ViewAxes& axes, const std::vector<std::size_t>& lengths) {
  std::string text;
  for (std::size_t axis = 0; axis < lengths.size(); ++axis) {
    const char* name = axis == axes.height    ? "height"
                       : axis == axes.width   ? "width"
                       : axis == axes.colours ? "colours"
                                              : "1";
    for (std::size_t k = 0; k < axes.views.size(); ++k)
      if (axis == axes.views[k])
        name = axes.views.size() == 1 ? "views" : k == 0 ? "rows of views" : "columns";
    text += (text.empty() ? "" : " × ") + std::string(name);
  }
  return text;
}

}  // namespace

std::optional<ViewAxes> viewAxesOf(const std::vector<std::size_t>& lengths, bool isMatlab) {
  std::vector<std::size_t> ordered = lengths;
  if (isMatlab) std::ranges::reverse(ordered);
  std::optional<ViewAxes> axes = asGrid(ordered);
  if (!axes) axes = byLengths(ordered);
  if (!axes) return std::nullopt;
  if (isMatlab) axes = reversed(*axes, lengths.size());
  const auto areAfter = [&] {
    return std::ranges::min(axes->views) > std::max(axes->height, axes->width);
  };
  if (!isMatlab && areAfter() && axes->colours &&
      *axes->colours < std::min(axes->height, axes->width)) {
    std::swap(axes->height, axes->width);
    std::ranges::reverse(axes->views);
  }
  axes->areViewsLast = areAfter();
  axes->text = textOf(*axes, lengths);
  return axes;
}

}  // namespace hogelscope
