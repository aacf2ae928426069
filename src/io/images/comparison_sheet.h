// SPDX-License-Identifier: BSD-3-Clause
// A view, its test and the map of their error side by side, with labels, for a paper.
#pragma once

#include <string>

#include "core/optics/image.h"

namespace hogelscope {

/// The texts above the pictures; letters beyond ASCII are shown as "?".
struct SheetLabels {
  std::string reference = "reference";
  std::string test;
  double psnr = 0;  ///< dB, of the pixels seen in both
};

/// Returns the sheet on white: the reference, the test, their mean absolute error over the three
/// channels in false colours, and its scale in code values. Throws std::invalid_argument if the
/// sizes differ.
Image comparisonSheet(const Image& reference, const Image& test, const SheetLabels& labels);

}  // namespace hogelscope
