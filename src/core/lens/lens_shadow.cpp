// SPDX-License-Identifier: BSD-3-Clause
// What is known of the directions of distorted points, in sectors around the centre.
#include "core/lens/lens_shadow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/optics/lens_branch.h"

namespace hogelscope {

namespace {

double norm(const Vec2& a) {
  return std::hypot(a.x, a.y);
}

}  // namespace

/// A lens without tangential terms is the same in all directions.
LensShadow::LensShadow(const Distortion& distortion)
    : m_distortion(distortion),
      m_isRound(distortion.params().p1 == 0 && distortion.params().p2 == 0) {}

int LensShadow::sectorOf(const Vec2& distorted) const {
  if (m_isRound) return 0;
  const double turns = std::atan2(distorted.y, distorted.x) / (2 * std::numbers::pi) + 0.5;
  return std::clamp(int(turns * sectorCount), 0, sectorCount - 1);
}

double LensShadow::halfWidth() const {
  return m_isRound ? 0 : std::numbers::pi / sectorCount * (1 + 1e-9);
}

double LensShadow::middleOf(int index) {
  return (2 * index + 1 - sectorCount) * std::numbers::pi / sectorCount;
}

/// Two threads may certify a sector at once: they write the same, but for what one has learnt
/// since.
LensSector LensShadow::sector(const Vec2& distorted) const {
  const int index = sectorOf(distorted);
  Sector& sector = m_sectors[std::size_t(index)];
  if (!sector.isKnown.load(std::memory_order_acquire)) {
    const LensSector certain = certifySector(m_distortion.params(), middleOf(index), halfWidth());
    sector.ideal.store(certain.ideal, std::memory_order_relaxed);
    sector.distorted.store(certain.distorted, std::memory_order_relaxed);
    sector.dark.store(certain.dark, std::memory_order_relaxed);
    sector.isKnown.store(true, std::memory_order_release);
  }
  return {sector.ideal.load(std::memory_order_relaxed),
          sector.distorted.load(std::memory_order_relaxed),
          sector.dark.load(std::memory_order_relaxed)};
}

bool LensShadow::holds(const Vec2& distorted) const {
  return std::isfinite(distorted.x + distorted.y) && norm(distorted) >= sector(distorted).dark;
}

/// The segments to the points of a disc that touches both sides of the sector fill all of it.
void LensShadow::learn(const Vec2& distorted, const Progress& progress) {
  if (!std::isfinite(distorted.x + distorted.y)) return;
  const int index = sectorOf(distorted);
  Sector& sector = m_sectors[std::size_t(index)];
  const double distance = norm(distorted);
  if (distance <= sector.failed.load(std::memory_order_relaxed)) return;
  const double half = halfWidth();
  const double angle = middleOf(index);
  // The disc's farthest point of each direction is at most at `distance`.
  const double middle = distance / (1 + std::sin(half));
  const Branch branch = followBranch(
      m_distortion, {{middle * std::cos(angle), middle * std::sin(angle)}, middle * std::sin(half)},
      progress);
  if (branch.kind == Branch::Kind::none)
    sector.dark.store(branch.end * distance, std::memory_order_relaxed);
  else
    sector.failed.store(distance, std::memory_order_relaxed);
}

}  // namespace hogelscope
