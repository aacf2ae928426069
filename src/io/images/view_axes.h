// SPDX-License-Identifier: BSD-3-Clause
// Which axes of an array of numbers are views, height, width and colours, by their lengths.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace hogelscope {

struct ViewAxes {
  std::vector<std::size_t> views;  ///< rows of views, then columns; or one axis for all views
  std::size_t height = 0;
  std::size_t width = 0;
  std::optional<std::size_t>
      colours;          ///< red, green, blue, and maybe a weight or alpha; grey: none
  bool isUsual = true;  ///< rows × columns × height × width (× colours), or a known program's
  bool areViewsLast = false;  ///< neighbouring numbers are of different views
  std::string text{};         ///< the meaning of the axes in their order
};

/// Returns the axes of an array of these lengths, of which the last is the fastest. rows × columns
/// × height × width with or without colours is preferred where it fits. Otherwise one axis of 3 or
/// 4 is colours, wherever it stands, the two longest others are height and width, and one or two
/// that remain count the views; axes of length 1 mean nothing. Colours before height and width
/// before views, and `isMatlab`, mean the reversed order. None if that is not unique.
std::optional<ViewAxes> viewAxesOf(const std::vector<std::size_t>& lengths, bool isMatlab);

}  // namespace hogelscope
