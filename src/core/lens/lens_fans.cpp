// SPDX-License-Identifier: BSD-3-Clause
// The certified parts of the directions of distorted points, in sectors around the centre.
#include "core/lens/lens_fans.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hogelscope {

namespace {

/// Returns the direction of a point in turns, 0 to 1.
double turnsOf(const Vec2& distorted) {
  return std::atan2(distorted.y, distorted.x) / (2 * std::numbers::pi) + 0.5;
}

/// One of `count` equal shares of a turn.
struct Share {
  int index;
  double middle;  ///< angles
  double halfWidth;

  Share(double turns, int count)
      : index(std::clamp(int(turns * count), 0, count - 1)),
        middle((2 * index + 1 - count) * std::numbers::pi / count),
        halfWidth(std::numbers::pi / count * (1 + 1e-9)) {}

  /// Returns a disc far away that touches both sides: segments to its points fill the share.
  [[nodiscard]] Disc disc() const {
    constexpr double away = 100;  // beyond any image but those of nearly 180°
    return {{away * std::cos(middle), away * std::sin(middle)}, away * std::sin(halfWidth)};
  }
};

}  // namespace

LensFans::LensFans(const Distortion& distortion)
    : m_distortion(distortion), m_isRound(distortion.isRound()) {}

const LensSector& LensFans::sector(const Vec2& distorted) const {
  const Share share(m_isRound ? 0 : turnsOf(distorted), sectorCount);
  Sector& sector = m_sectors[std::size_t(share.index)];
  std::call_once(sector.isCertified, [&] {
    sector.certain = certifySector(m_distortion, share.middle, m_isRound ? 0 : share.halfWidth);
  });
  return sector.certain;
}

LensFans::Place LensFans::find(const Vec2& distorted, const Progress& progress) const {
  BranchLine line;
  if (m_isRound) return {Place::Kind::unclear, line};  // its sector has all certified facts
  const double turns = turnsOf(distorted);
  int count = fanCount;
  Fan* fan = &m_fans[std::size_t(Share(turns, count).index)];
  for (;;) {
    if (!fan->isFollowed) {
      // Not std::call_once: a cancelled run throws here, which the thread sanitizer's does not
      // bear.
      const std::lock_guard lock(fan->following);
      if (!fan->isFollowed) {
        follow(*fan, Share(turns, count).disc(), line, count < mostParts, progress);
        fan->isFollowed = true;
      }
    }
    if (std::hypot(distorted.x, distorted.y) >= fan->dark) return {Place::Kind::none, line};
    const BranchLine* before = lineBefore(distorted, fan->lines);
    if (before != nullptr) {
      line = *before;
      const bool isLast = before == &fan->lines.back();
      const double distance = distorted.x * line.normal.x + distorted.y * line.normal.y;
      if (!isLast || distance < fan->reached) return {Place::Kind::ray, line};
    }
    if (!fan->parts) return {Place::Kind::unclear, line};
    count *= partCount;
    fan = &(*fan->parts)[std::size_t(Share(turns, count).index % partCount)];
  }
}

void LensFans::follow(Fan& fan, const Disc& disc, const BranchLine& start, bool hasParts,
                      const Progress& progress) const {
  std::vector<BranchLine> lines;
  const Branch branch = followBranch(m_distortion, disc, progress, start, &lines);
  fan.lines = std::move(lines);
  fan.reached = branch.reached;
  // The disc's farthest point.
  const double distance = std::hypot(disc.centre.x, disc.centre.y) + disc.radius;
  if (branch.kind == Branch::Kind::none)
    fan.dark = branch.end * distance;
  else if (branch.kind == Branch::Kind::unclear && hasParts)
    fan.parts = std::make_unique<std::array<Fan, partCount>>();
}

}  // namespace hogelscope
