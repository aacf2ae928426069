// SPDX-License-Identifier: BSD-3-Clause
// Finds the states whose lines pass a position on the screen. It projects every line, which takes a
// fraction of a millisecond for a few thousand, and also finds lines exactly behind others.
#include "line_picker.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace hogelscope
{

namespace
{
using Clip = std::array<double, 4>;

Clip clipOf(vtkPolyData* lines, vtkIdType point, vtkMatrix4x4* clipFromWorld)
{
  Clip p{};
  lines->GetPoint(point, p.data());
  p[3] = 1;
  clipFromWorld->MultiplyPoint(p.data(), p.data());
  return p;
}

/// Moves `behind` along the line to the eye's plane.
Clip atEyePlane(const Clip& behind, const Clip& before, double w)
{
  const double share = (w - behind[3]) / (before[3] - behind[3]);
  Clip p{};
  for (std::size_t k = 0; k < 4; ++k)
  {
    p[k] = behind[k] + share * (before[k] - behind[k]);
  }
  return p;
}

double distanceOnScreen(Clip a, Clip b, const ScreenPlace& place)
{
  constexpr double least = 1e-9; // the least w for a line that reaches behind the eye
  if (a[3] < least && b[3] < least)
  {
    return HUGE_VAL;
  }
  a = a[3] < least ? atEyePlane(a, b, least) : a;
  b = b[3] < least ? atEyePlane(b, a, least) : b;
  // Relative to the position, in pixels.
  const auto x = [&](const Clip& p) { return (p[0] / p[3] + 1) / 2 * place.Width - place.X; };
  const auto y = [&](const Clip& p) { return (p[1] / p[3] + 1) / 2 * place.Height - place.Y; };
  const double dx = x(b) - x(a);
  const double dy = y(b) - y(a);
  const double square = dx * dx + dy * dy;
  const double along = square > 0 ? std::clamp(-(x(a) * dx + y(a) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(x(a) + along * dx, y(a) + along * dy);
}
}

std::vector<int> statesAt(vtkPolyData* lines, vtkMatrix4x4* clipFromWorld, const ScreenPlace& place)
{
  std::set<int> states;
  vtkDataArray* numbers = lines->GetCellData()->GetArray("State");
  for (vtkIdType cell = 0; numbers != nullptr && cell < lines->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ends = nullptr;
    lines->GetCellPoints(cell, count, ends);
    if (count != 2 || ends == nullptr)
    {
      continue;
    }
    const Clip a = clipOf(lines, ends[0], clipFromWorld);
    const Clip b = clipOf(lines, ends[1], clipFromWorld);
    if (distanceOnScreen(a, b, place) <= place.Tolerance)
    {
      states.insert(static_cast<int>(numbers->GetTuple1(cell)));
    }
  }
  return { states.begin(), states.end() };
}

} // namespace hogelscope
