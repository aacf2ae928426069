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

LensShadow::Share LensShadow::shareOf(const Vec2& distorted, int count) const {
  if (m_isRound) return {};
  const double turns = std::atan2(distorted.y, distorted.x) / (2 * std::numbers::pi) + 0.5;
  const int index = std::clamp(int(turns * count), 0, count - 1);
  const double half = std::numbers::pi / count;
  return {std::size_t(index), (2 * index + 1 - count) * half, half * (1 + 1e-9)};
}

/// Two threads may certify a sector at once: they write the same, but for what one has learnt
/// since.
const LensShadow::Sector& LensShadow::certifiedSector(const Vec2& distorted) const {
  const Share share = shareOf(distorted, sectorCount);
  Sector& sector = m_sectors[share.index];
  if (sector.isKnown.load(std::memory_order_acquire)) return sector;
  const LensSector certain = certifySector(m_distortion.params(), share.middle, share.halfWidth);
  sector.ideal.store(certain.ideal, std::memory_order_relaxed);
  sector.distorted.store(certain.distorted, std::memory_order_relaxed);
  sector.shade.dark.store(certain.dark, std::memory_order_relaxed);
  sector.isKnown.store(true, std::memory_order_release);
  return sector;
}

LensSector LensShadow::sector(const Vec2& distorted) const {
  const Sector& sector = certifiedSector(distorted);
  return {sector.ideal.load(std::memory_order_relaxed),
          sector.distorted.load(std::memory_order_relaxed),
          sector.shade.dark.load(std::memory_order_relaxed)};
}

bool LensShadow::holds(const Vec2& distorted) const {
  if (!std::isfinite(distorted.x + distorted.y)) return false;
  const double distance = norm(distorted);
  const Shade& whole = certifiedSector(distorted).shade;
  if (distance >= whole.dark.load(std::memory_order_relaxed)) return true;
  if (whole.failed.load(std::memory_order_relaxed) == 0) return false;  // its parts were not needed
  const Shade& part = m_parts[shareOf(distorted, partCount).index];
  return distance >= part.dark.load(std::memory_order_relaxed);
}

void LensShadow::learn(const Vec2& distorted, const Progress& progress) {
  if (!std::isfinite(distorted.x + distorted.y)) return;
  const double distance = norm(distorted);
  const Share sector = shareOf(distorted, sectorCount);
  if (learn(m_sectors[sector.index].shade, sector, distance, progress) || m_isRound) return;
  const Share part = shareOf(distorted, partCount);
  learn(m_parts[part.index], part, distance, progress);
}

/// The segments to the points of a disc that touches both sides of the share fill all of it.
bool LensShadow::learn(Shade& shade, const Share& share, double distance,
                       const Progress& progress) {
  if (distance <= shade.failed.load(std::memory_order_relaxed)) return false;
  // The disc's farthest point of each direction is at most at `distance`.
  const double sine = std::sin(share.halfWidth);
  const double middle = distance / (1 + sine);
  const Branch branch = followBranch(
      m_distortion,
      {{middle * std::cos(share.middle), middle * std::sin(share.middle)}, middle * sine},
      progress);
  const bool isDark = branch.kind == Branch::Kind::none;
  if (isDark)
    shade.dark.store(branch.end * distance, std::memory_order_relaxed);
  else
    shade.failed.store(distance, std::memory_order_relaxed);
  return isDark;
}

}  // namespace hogelscope
