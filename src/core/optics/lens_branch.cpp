// SPDX-License-Identifier: BSD-3-Clause
// The branch of a lens' inverse that grows from the centre: steps that the Newton–Kantorovich
// theorem certifies, in a norm that knows which way the lens folds, and a proof that a fold is met.
#include "core/optics/lens_branch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hogelscope {

namespace {

/// Kantorovich's h = ω η has to stay at or below 1/2.
constexpr double certain = 0.45;

/// The ball, in units of η, that then holds the root: (1 − √(1 − 2h)) / h.
constexpr double ball = 1.52;

Vec2 times(double s, const Vec2& a) {
  return {s * a.x, s * a.y};
}

double norm(const Vec2& a) {
  return std::sqrt(a.x * a.x + a.y * a.y);  // nothing here is near to overflow
}

/// The lens near an ideal point, along the eigenvectors of its Jacobian, which is symmetric: along
/// v, the direction in which the lens folds, and along w. Vectors here have these coordinates, x
/// along v.
class Place {
 public:
  Place(const Distortion& lens, const Vec2& ideal) : m_lens(lens), m_radius(norm(ideal)) {
    const Jacobian j = lens.jacobian(ideal);
    const double half = (j.xx - j.yy) / 2;
    const double spread = norm({half, j.xy});
    m_most = (j.xx + j.yy) / 2 + spread;
    m_least = (j.xx * j.yy - j.xy * j.xy) / m_most;
    if (spread > 0) {
      // w is at half the angle of (half, xy).
      const double larger = std::sqrt((1 + std::abs(half) / spread) / 2);
      const double smaller = j.xy / spread / (2 * larger);
      m_w = half >= 0 ? Vec2{larger, smaller} : Vec2{smaller, larger};
    }
    m_stretch = std::sqrt(std::max(1.0, m_most / m_least));
    setThird(ideal);
  }

  /// False on a fold and beyond it.
  [[nodiscard]] bool isRegular() const { return m_least > 0 && std::isfinite(m_stretch); }

  [[nodiscard]] Vec2 turned(const Vec2& a) const {
    return {a.x * m_w.y - a.y * m_w.x, a.x * m_w.x + a.y * m_w.y};
  }
  /// Returns J⁻¹ a.
  [[nodiscard]] Vec2 solved(const Vec2& a) const { return {a.x / m_least, a.y / m_most}; }

  /// Returns the direction in which the lens folds, of the two the one with a positive `a`.
  [[nodiscard]] Vec2 foldAlong(const Vec2& a) const {
    const Vec2 v{m_w.y, -m_w.x};
    return a.x * v.x + a.y * v.y < 0 ? Vec2{-v.x, -v.y} : v;
  }

  /// Returns the norm in which steps are certified: across the fold's direction a length counts
  /// √(μ/λ) times, since the lens bends little there compared with how far it is from folding.
  [[nodiscard]] double size(const Vec2& a) const {
    return std::max(std::abs(a.x), m_stretch * std::abs(a.y));
  }
  /// Returns the largest plain length of a vector of size 1.
  [[nodiscard]] double longest() const { return std::sqrt(1 + 1 / (m_stretch * m_stretch)); }
  /// Returns the largest such size of J⁻¹ a over all a of length 1.
  [[nodiscard]] double largestSolved() const { return std::max(1 / m_least, m_stretch / m_most); }

  /// Is there exactly one root, and no fold, for all targets that Newton's first move, of size
  /// `eta`, leads to? ω bounds J⁻¹ D²F over the ball.
  [[nodiscard]] bool isCertain(double eta) const {
    const double across = 1 / m_stretch;
    const double change =
        longest() * longest() * m_lens.derivativeBounds(m_radius, ball * eta * longest()).change;
    const double alongV =
        (std::abs(m_vvv) + across * (2 * std::abs(m_vvw) + across * std::abs(m_vww)) + change) /
        m_least;
    const double alongW =
        (std::abs(m_vvw) + across * (2 * std::abs(m_vww) + across * std::abs(m_www)) + change) *
        m_stretch / m_most;
    return std::max(alongV, alongW) * eta <= certain;
  }

  /// Returns a time in which every path meets a fold that starts where size() from here is at most
  /// `start`, with dp/dt = J⁻¹ q' for a q' within `radius` of q; infinite if nothing is certain. In
  /// a box of the coordinates a along v, b along w, where n = J_ww q'_v − J_vw q'_w is positive, a
  /// grows all the way, by da/dt = n / det J, and b changes by at most a slope times as much. So a
  /// path leaves the box at its end, where J_vv, and with it det J, is no longer positive: it has
  /// met the fold.
  [[nodiscard]] double timeToFold(double start, const Vec2& q, double radius) const {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    const double sign = q.x < 0 ? -1 : 1;
    const double fall = -sign * m_vvv;
    const double third = m_lens.derivativeBounds(m_radius, 0).third;
    const double root = fall * fall - 2 * m_least * third;  // of λ − fall a + third a²/2
    if (!(fall > 0 && root > 0)) return unknown;
    const double end = std::min(3 * m_least / (fall + std::sqrt(root)), fall / third);
    const double startW = start / m_stretch;
    const double acrossQ = std::abs(q.y) + radius;
    double halfWidth = startW;
    for (int attempt = 0; attempt < 3; ++attempt) {
      const double longest = std::max(end, start);
      const double reach = norm({longest, halfWidth});
      const double rest = m_lens.derivativeBounds(m_radius, reach).third * reach * reach / 2;
      const double mixed = std::abs(m_vvw) * longest + std::abs(m_vww) * halfWidth + rest;
      const double bend = std::abs(m_vww) * longest + std::abs(m_www) * halfWidth + rest;
      const double most = m_least + std::abs(m_vvw) * halfWidth + rest + fall * start;
      const double atEnd = m_least + std::abs(m_vvw) * halfWidth + rest - fall * end;
      const double n = (m_most - bend) * (std::abs(q.x) - radius) - mixed * acrossQ;
      if (!(atEnd <= 0 && bend < m_most && n > 0)) return unknown;
      const double slope = (most * acrossQ + mixed * (std::abs(q.x) + radius)) / n;
      const double needed = startW + slope * (end + start);
      if (needed <= halfWidth) return (end + start) * most * (m_most + bend) / n;
      halfWidth = 1.5 * needed;
    }
    return unknown;
  }

 private:
  /// Sets the second derivative: with h' the radial factor as a function of r²/2 it is h''' p p p,
  /// and the symmetric product of the unit matrix with h'' p + 2 (p2, p1).
  void setThird(const Vec2& ideal) {
    const auto& [k1, k2, p1, p2, k3] = m_lens.params();
    const double r2 = m_radius * m_radius;
    const double h2 = 2 * k1 + r2 * (4 * k2 + r2 * 6 * k3);
    const double h3 = 8 * k2 + r2 * 24 * k3;
    const Vec2 p = turned(ideal);
    const Vec2 z = turned({h2 * ideal.x + 2 * p2, h2 * ideal.y + 2 * p1});
    m_vvv = h3 * p.x * p.x * p.x + 3 * z.x;
    m_vvw = h3 * p.x * p.x * p.y + z.y;
    m_vww = h3 * p.x * p.y * p.y + z.x;
    m_www = h3 * p.y * p.y * p.y + 3 * z.y;
  }

  const Distortion& m_lens;
  double m_radius;
  double m_least = 1;  ///< λ, eigenvalue along v
  double m_most = 1;   ///< μ
  Vec2 m_w{0, 1};
  double m_stretch = 1;
  double m_vvv = 0;
  double m_vvw = 0;
  double m_vww = 0;
  double m_www = 0;
};

/// Makes Newton steps from `ideal`, in whose basin `place` knows the root to be, until one is at
/// most `part` of the first. The certificate says that each is shorter than half the one before,
/// but for rounding; the residual may grow.
Vec2 polished(const Distortion& lens, const Place& place, Vec2 ideal, const Vec2& distorted,
              double part) {
  double shortest = std::numeric_limits<double>::infinity();
  double enough = 0;
  while (shortest > enough) {
    const Vec2 d = lens.distort(ideal);
    const Vec2 residual{distorted.x - d.x, distorted.y - d.y};
    const Jacobian j = lens.jacobian(ideal);
    const double det = j.xx * j.yy - j.xy * j.yx;
    const Vec2 step{(j.yy * residual.x - j.xy * residual.y) / det,
                    (j.xx * residual.y - j.yx * residual.x) / det};
    const double size = place.size(place.turned(step));
    if (!(size < shortest / 2)) break;
    if (enough == 0) enough = part * size;
    shortest = size;
    ideal = {ideal.x + step.x, ideal.y + step.y};
  }
  return ideal;
}

}  // namespace

namespace {

double dot(const Vec2& a, const Vec2& b) {
  return a.x * b.x + a.y * b.y;
}

/// The segments to a disc cut by lines of one direction, since near a fold the lens allows less
/// along the segments than across them: at t they cut the line through t·centre over a length of
/// 2·t·halfWidth.
struct Fan {
  Vec2 normal;
  Vec2 along;  ///< the lines' direction
  double halfWidth = 0;
  double nearest = 1;  ///< the t before which no line meets the disc

  Fan(const Disc& disc, const Vec2& lineNormal)
      : normal(lineNormal), along{-lineNormal.y, lineNormal.x} {
    const double distance = dot(disc.centre, normal);
    halfWidth = norm(disc.centre) * disc.radius / (distance - disc.radius);
    nearest = 1 - disc.radius / distance;
  }
};

}  // namespace

const BranchLine* lineBefore(const Vec2& distorted, const std::vector<BranchLine>& lines) {
  // Lines of one direction are in order. Others may cross within the segments: then either holds.
  std::size_t first = 0;
  std::size_t count = lines.size();
  while (count > 0) {
    const BranchLine& middle = lines[first + count / 2];
    if (dot(distorted, middle.normal) < middle.distance) {
      count /= 2;
    } else {
      first += count / 2 + 1;
      count -= count / 2 + 1;
    }
  }
  return first == 0 ? nullptr : &lines[first - 1];
}

Branch followBranch(const Distortion& lens, const Disc& disc, const Progress& progress,
                    const BranchLine& start, std::vector<BranchLine>* lines) {
  constexpr double toRounding = 1e-9;     // Newton's steps are quadratic
  constexpr double shortestStep = 1e-13;  // of `reached`: a nearer point counts as on the fold
  Branch branch;
  if (!std::isfinite(disc.centre.x + disc.centre.y + disc.radius)) return branch;
  const double length = norm(disc.centre);
  // Then its square is too small for a number, and the lens bends the centre by less.
  if (length == 0 && disc.radius == 0) return {Branch::Kind::ray, disc.centre};
  Fan fan(disc, start.distance > 0 ? start.normal : times(1 / length, disc.centre));
  if (!(fan.nearest > 0.1)) return branch;
  double distance = dot(disc.centre, fan.normal);
  // The part of the centre's segment whose preimage, with those of the line there, is known.
  double reached = start.distance / distance;
  if (reached >= 1) reached = 0;
  if (reached > 0)
    branch.ideal = polished(lens, Place(lens, start.ideal), start.ideal,
                            times(reached, disc.centre), toRounding);
  double step = 1;
  double turnedAt = 0;  // the part up to which the lines have been turned
  for (;;) {
    hearStop(progress);
    branch.reached = reached * distance;
    const Place place(lens, branch.ideal);
    if (!place.isRegular()) return branch;
    if (reached == 1) {
      // A disc of this radius holds the line and all of the disc.
      if (place.isCertain(fan.halfWidth * place.largestSolved())) branch.kind = Branch::Kind::ray;
      return branch;
    }
    const double width = fan.halfWidth * place.size(place.solved(place.turned(fan.along)));
    const Vec2 here = lens.distort(branch.ideal);
    const Vec2 q = place.turned(disc.centre);
    const double speed = place.size(place.solved(q));
    const double residual = place.size(place.solved(
        place.turned({reached * disc.centre.x - here.x, reached * disc.centre.y - here.y})));
    const double left = 1 - reached;
    const auto sizeAfter = [&](double further) {
      return residual + further * speed + (reached + further) * width;
    };
    step = std::min(4 * step, left);
    if (!place.isCertain(sizeAfter(step))) {
      const double before = sizeAfter(0);
      const double end = reached + place.timeToFold(2 * before, q, fan.halfWidth);
      if (end < fan.nearest && place.isCertain(before)) {
        branch.kind = Branch::Kind::none;
        branch.end = end / fan.nearest;
        return branch;
      }
      bool isTooWide = false;  // of lines that are wider than the step is long, parts get farther
      do {
        step /= 2;
        isTooWide = step * speed < reached * width / 4;
        if (!isTooWide && !(step > shortestStep * reached)) return branch;
      } while (!isTooWide && !place.isCertain(sizeAfter(step)));
      if (isTooWide) {
        // Along the fold the lens allows more.
        const Fan turned(disc, place.foldAlong(disc.centre));
        const double turnedWidth =
            turned.halfWidth * place.size(place.solved(place.turned(turned.along)));
        // The line of that direction that is all within what is known.
        const double back = reached * distance /
                            (distance + turned.halfWidth * std::abs(dot(fan.normal, turned.along)));
        const BranchLine* line =
            lines == nullptr ? nullptr : lineBefore(times(back, disc.centre), *lines);
        if (line == nullptr ||
            !(reached > turnedAt && turned.nearest > 0.1 && turnedWidth < width / 2))
          return branch;
        turnedAt = reached;
        reached = back;
        fan = turned;
        distance = dot(disc.centre, fan.normal);
        branch.ideal = polished(lens, Place(lens, line->ideal), line->ideal,
                                times(reached, disc.centre), toRounding);
        continue;
      }
    }
    if (lines != nullptr) lines->push_back({fan.normal, branch.reached, branch.ideal});
    reached = step == left ? 1 : reached + step;
    // A root on the way may be off by a thousandth of the step.
    branch.ideal = polished(lens, place, branch.ideal, times(reached, disc.centre),
                            reached == 1 ? toRounding : 0.05);
  }
}

}  // namespace hogelscope
