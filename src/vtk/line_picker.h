// SPDX-License-Identifier: BSD-3-Clause
// Finds the states whose lines pass a position on the screen.
#pragma once

#include <vector>

class vtkMatrix4x4;
class vtkPolyData;

namespace hogelscope
{

/// A position in pixels from the viewport's lower left.
struct ScreenPlace
{
  double X = 0;
  double Y = 0;
  double Tolerance = 4;
  int Width = 1; ///< size of the viewport
  int Height = 1;
};

/// Returns the "State" of every line within the tolerance, each once, in ascending order.
/// `clipFromWorld` is the camera's composite projection, x and y from -1 to 1 over the viewport.
std::vector<int> statesAt(
  vtkPolyData* lines, vtkMatrix4x4* clipFromWorld, const ScreenPlace& place);

} // namespace hogelscope
