// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/twin_plane.h"

#include <algorithm>
#include <cmath>

namespace hogelscope {

PlanePlace planePlaceOf(double place, int count) {
  if (count == 1) return {0, 0};
  const double at = place * count - 0.5;
  const int first = static_cast<int>(std::clamp(std::floor(at), 0.0, double(count - 2)));
  return {first, at - first};
}

PlanePlace within(PlanePlace place) {
  place.share = std::clamp(place.share, 0.0, 1.0);
  return place;
}

Bilinear::Bilinear(const TwinPlane& plane, const PlanePlace& i, const PlanePlace& j) {
  const int right = std::min(i.first + 1, plane.width - 1);
  const int below = std::min(j.first + 1, plane.height - 1);
  const auto at = [&](int column, int row) {
    return double(plane.values[std::size_t(row) * std::size_t(plane.width) + std::size_t(column)]);
  };
  const double top = at(i.first, j.first);
  const double bottom = at(i.first, below);
  const double alongTop = at(right, j.first) - top;
  const double alongBottom = at(right, below) - bottom;
  value = (1 - j.share) * (top + i.share * alongTop) + j.share * (bottom + i.share * alongBottom);
  across = (1 - j.share) * alongTop + j.share * alongBottom;
  down = bottom + i.share * alongBottom - top - i.share * alongTop;
}

double TwinPlane::at(double x, double y) const {
  return Bilinear(*this, within(planePlaceOf(x, width)), within(planePlaceOf(y, height))).value;
}

float TwinPlane::atCell(int i, int j, int nx, int ny) const {
  if (isEmpty()) return 0;
  if (width == nx && height == ny) return values[std::size_t(j) * std::size_t(nx) + std::size_t(i)];
  return static_cast<float>(at((i + 0.5) / nx, (j + 0.5) / ny));
}

}  // namespace hogelscope
