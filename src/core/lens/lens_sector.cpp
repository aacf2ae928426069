// SPDX-License-Identifier: BSD-3-Clause
// A sector of a lens in polar coordinates, where the radial terms depend on the radius alone.
#include "core/lens/lens_sector.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hogelscope {

namespace {

constexpr double farthest = 100;     // beyond any image but those of nearly 180°
constexpr double leastStep = 1e-10;  // of a ring, relative to 1 + its radius

/// Bounds of the radial terms over the ring of width `step` that begins at the radius `from`.
struct Ring {
  double rounding;
  double leastSlope;
  double mostSlope;
  double leastAcross;

  Ring(const Distortion& lens, const RadialTerms& inner, double from, double step) {
    const RadialBounds bounds = lens.radialBounds(from, step);
    const double bend = bounds.slopeBend;
    const double acrossBend = bounds.acrossBend;
    rounding = bounds.rounding;
    const auto fall = [step](double change, double bound) {
      return std::max(0.0, -change) * step + bound * step * step / 2;
    };
    leastSlope = inner.slope - fall(inner.slopeChange, bend) - rounding;
    mostSlope = inner.slope + fall(-inner.slopeChange, bend) + rounding;
    leastAcross = inner.across - fall(inner.acrossChange, acrossBend) - rounding;
  }
};

/// The tangential terms are the gradient of r³ c(φ), c = (p2, p1)·(cos φ, sin φ). The bounds are
/// those of c and |c'| in directions within `away` of `angle`.
struct Tangential {
  double least;
  double most;
  double mostChange;

  Tangential(const Distortion& lens, double angle, double away) {
    const auto [p1, p2] = std::pair(lens.params().p1, lens.params().p2);
    const double size = std::hypot(p1, p2);
    const double value = p2 * std::cos(angle) + p1 * std::sin(angle);
    const double change = std::abs(p1 * std::cos(angle) - p2 * std::sin(angle));
    const double range = away * change + away * away / 2 * size;
    least = value - range;
    most = value + range;
    mostChange = change + away * size;
  }
};

/// Returns a bound of the angle between the directions of an ideal point and its distorted one;
/// infinite if there is none.
double mostTurn(const Distortion& lens, const Ring& ring, double r) {
  const double size = r * std::hypot(lens.params().p1, lens.params().p2);
  const double along = ring.leastAcross - 3 * size;
  return along > 0 ? size / along : std::numeric_limits<double>::infinity();
}

/// Looks for an arc beyond `from`, up to which all is regular, that no path can cross, as the model
/// does not grow along the radius there. Returns the largest distorted radius before it; infinite
/// if none is found.
double darkFrom(const Distortion& lens, double angle, double halfWidth, double away, double from) {
  const RadialTerms inner = lens.radial(from);
  for (int doublings = 0; doublings < 30; ++doublings) {
    const double step = std::ldexp(leastStep * (1 + from), doublings);
    const double r = from + step;
    const Ring ring(lens, inner, from, step);
    const double turned = std::max(away, halfWidth + mostTurn(lens, ring, r));
    if (!std::isfinite(turned)) break;
    const Tangential c(lens, angle, turned);
    if (lens.radial(r).slope + 6 * r * c.most + ring.rounding > 0) continue;
    const double growth = std::max(0.0, ring.mostSlope + 6 * r * std::max(0.0, c.most));
    const double along = inner.value + 3 * from * from * c.most + step * growth;
    return std::hypot(along, r * r * c.mostChange) + r * ring.rounding;
  }
  return std::numeric_limits<double>::infinity();
}

/// Marches outwards. A path of the sector is never farther from its direction than `m_away`, and
/// where the Jacobian's rows (f' + 6 r c, 2 r c') and (2 r c', f / r + 2 r c), along and across the
/// radius, are positive definite for all directions so near, it goes on to the end of the ring.
class March {
 public:
  March(const Distortion& lens, double angle, double halfWidth)
      : m_lens(lens), m_angle(angle), m_halfWidth(halfWidth), m_away(halfWidth) {}

  LensSector run() {
    double step = 0.05;
    while (m_sector.ideal < farthest) {
      const double r = m_sector.ideal;
      const RadialTerms inner = m_lens.radial(r);
      step = std::min({2 * step, 0.2 * r + 0.05, farthest - r});
      while (!extend(inner, step)) {
        step /= 2;
        if (step > leastStep * (1 + r)) continue;
        m_sector.dark = darkFrom(m_lens, m_angle, m_halfWidth, m_away, r);
        return m_sector;
      }
    }
    return m_sector;
  }

 private:
  /// Returns whether the ring of this width is certain, and adds it then.
  bool extend(const RadialTerms& inner, double step) {
    const double r = m_sector.ideal;
    const double end = r + step;
    const Ring ring(m_lens, inner, r, step);
    const double turn = mostTurn(m_lens, ring, end);
    if (!std::isfinite(turn)) return false;
    const double turned = std::max(m_away, m_halfWidth + turn);
    const Tangential c(m_lens, m_angle, turned);
    const double most = 6 * end * std::min(0.0, c.least);
    const double along = ring.leastSlope + (c.least > 0 ? 6 * r * c.least : most);
    const double across = ring.leastAcross + 2 * end * std::min(0.0, c.least);
    const double mixed = 2 * end * c.mostChange;
    if (!(along > 0 && across > 0 && along * across > mixed * mixed)) return false;
    m_away = turned;
    m_sector.ideal = end;
    m_sector.distorted = m_lens.radial(end).value + 3 * end * end * c.least - end * ring.rounding;
    return true;
  }

  const Distortion& m_lens;
  double m_angle;
  double m_halfWidth;
  double m_away;
  LensSector m_sector;
};

}  // namespace

LensSector certifySector(const Distortion& lens, double angle, double halfWidth) {
  return March(lens, angle, halfWidth).run();
}

/// Uses Newton's method along the radius, within bounds that contain the root.
Vec2 guessInSector(const Distortion& lens, const LensSector& sector, const Vec2& distorted) {
  const double length = std::hypot(distorted.x, distorted.y);
  const auto [p1, p2] = std::pair(lens.params().p1, lens.params().p2);
  const double c = (p2 * distorted.x + p1 * distorted.y) / length;
  double low = 0;
  double high = sector.ideal;
  double r = std::min(length, high / 2);
  for (int step = 0; step < 60; ++step) {
    const RadialTerms at = lens.radial(r);
    const double error = at.value + 3 * r * r * c - length;
    (error < 0 ? low : high) = r;
    double next = r - error / (at.slope + 6 * r * c);
    if (!(next > low && next < high)) next = (low + high) / 2;
    const bool isNear = std::abs(next - r) < 1e-9 * r;
    r = next;
    if (isNear) break;
  }
  return {r * distorted.x / length, r * distorted.y / length};
}

}  // namespace hogelscope
