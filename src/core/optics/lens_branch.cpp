// SPDX-License-Identifier: BSD-3-Clause
// The branch of a lens' inverse that grows from the centre: steps that the Newton–Kantorovich
// theorem certifies, in a norm that depends on the direction in which the lens folds, and a proof
// that a fold is met.
#include "core/optics/lens_branch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hogelscope {

namespace {

/// The largest allowed h = ω η. Kantorovich's theorem requires at most 1/2.
constexpr double certain = 0.45;

/// The radius, in units of η, of the ball that then contains the root: (1 − √(1 − 2h)) / h.
constexpr double ball = 1.52;

Vec2 times(double s, const Vec2& a) {
  return {s * a.x, s * a.y};
}

double norm(const Vec2& a) {
  return std::sqrt(a.x * a.x + a.y * a.y);  // nothing here is near to overflow
}

/// Bounds of a vector's coordinates along v and w.
struct Extent {
  double v = 0;
  double w = 0;
  friend Extent operator+(const Extent& a, const Extent& b) { return {a.v + b.v, a.w + b.w}; }
  friend Extent operator*(double s, const Extent& a) { return {s * a.v, s * a.w}; }
};

using Sizes = std::array<double, 3>;

/// Whether each of the sizes is less than this part of the other one.
bool areBelow(const Sizes& a, double part, const Sizes& b) {
  return a[0] < part * b[0] && a[1] < part * b[1] && a[2] < part * b[2];
}

/// Whether any of the sizes is less than this part of the other one.
bool isOneBelow(const Sizes& a, double part, const Sizes& b) {
  return a[0] < part * b[0] || a[1] < part * b[1] || a[2] < part * b[2];
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
    const double stretch = std::sqrt(std::max(1.0, m_most / m_least));
    m_stretch = {stretch, std::cbrt(stretch), 1};
    setThird(ideal);
  }

  /// Returns false on a fold and beyond it.
  [[nodiscard]] bool isRegular() const { return m_least > 0 && std::isfinite(m_stretch[0]); }

  [[nodiscard]] Vec2 turned(const Vec2& a) const {
    return {a.x * m_w.y - a.y * m_w.x, a.x * m_w.x + a.y * m_w.y};
  }
  /// Returns the extent of J⁻¹ a.
  [[nodiscard]] Extent solved(const Vec2& a) const {
    return {std::abs(a.x) / m_least, std::abs(a.y) / m_most};
  }
  /// Returns the extent of J⁻¹ a over all a of this length.
  [[nodiscard]] Extent solved(double length) const { return {length / m_least, length / m_most}; }

  /// Returns the direction in which the lens folds, of the two the one with a positive `a`.
  [[nodiscard]] Vec2 foldAlong(const Vec2& a) const {
    const Vec2 v{m_w.y, -m_w.x};
    return a.x * v.x + a.y * v.y < 0 ? Vec2{-v.x, -v.y} : v;
  }

  /// Returns the sizes of an extent in the norms in which steps are certified: a length across the
  /// fold's direction counts √(μ/λ) times, since the lens bends little there compared with its
  /// distance from folding, or fewer times, for extents that are long across it.
  [[nodiscard]] Sizes sizes(const Extent& e) const {
    Sizes sizes{};
    for (std::size_t k = 0; k < sizes.size(); ++k) sizes[k] = std::max(e.v, m_stretch[k] * e.w);
    return sizes;
  }

  /// Whether there is exactly one root, and no fold, for all targets to which Newton's first move,
  /// within `extent`, leads.
  [[nodiscard]] bool isCertain(const Extent& extent) const {
    const Sizes eta = sizes(extent);
    for (std::size_t k = 0; k < eta.size(); ++k)
      if (isCertain(m_stretch[k], eta[k])) return true;
    return false;
  }

  /// Returns a time in which every path meets a fold that starts within `start` from here, with
  /// dp/dt = J⁻¹ q' for a q' within `radius` of q; infinite if nothing is certain. In a box of the
  /// coordinates a along v, b along w, where n = J_ww q'_v − J_vw q'_w is positive, a grows all the
  /// way, by da/dt = n / det J, and b changes by at most a slope times as much. So a path leaves
  /// the box at its end, where J_vv, and with it det J, is no longer positive: it has met the fold.
  [[nodiscard]] double timeToFold(const Extent& start, const Vec2& q, double radius) const {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    const double sign = q.x < 0 ? -1 : 1;
    const double fall = -sign * m_vvv;
    const double third = m_lens.derivativeBounds(m_radius, 0).third;
    const double root = fall * fall - 2 * m_least * third;  // of λ − fall a + third a²/2
    if (!(fall > 0 && root > 0)) return unknown;
    const double end = std::min(3 * m_least / (fall + std::sqrt(root)), fall / third);
    const double acrossQ = std::abs(q.y) + radius;
    double halfWidth = start.w;
    for (int attempt = 0; attempt < 3; ++attempt) {
      const double longest = std::max(end, start.v);
      const double reach = norm({longest, halfWidth});
      const double rest = m_lens.derivativeBounds(m_radius, reach).third * reach * reach / 2;
      const double mixed = std::abs(m_vvw) * longest + std::abs(m_vww) * halfWidth + rest;
      const double bend = std::abs(m_vww) * longest + std::abs(m_www) * halfWidth + rest;
      const double most = m_least + std::abs(m_vvw) * halfWidth + rest + fall * start.v;
      const double atEnd = m_least + std::abs(m_vvw) * halfWidth + rest - fall * end;
      const double n = (m_most - bend) * (std::abs(q.x) - radius) - mixed * acrossQ;
      if (!(atEnd <= 0 && bend < m_most && n > 0)) return unknown;
      const double slope = (most * acrossQ + mixed * (std::abs(q.x) + radius)) / n;
      const double needed = start.w + slope * (end + start.v);
      if (needed <= halfWidth) return (end + start.v) * most * (m_most + bend) / n;
      halfWidth = 1.5 * needed;
    }
    return unknown;
  }

 private:
  /// Whether that holds in one norm, for a size η. ω bounds J⁻¹ D²F over the ball.
  [[nodiscard]] bool isCertain(double stretch, double eta) const {
    const double across = 1 / stretch;
    const double squared = 1 + across * across;  // the largest plain length of a vector of size 1
    const double change =
        squared * m_lens.derivativeBounds(m_radius, ball * eta * std::sqrt(squared)).change;
    const double alongV =
        (std::abs(m_vvv) + across * (2 * std::abs(m_vvw) + across * std::abs(m_vww)) + change) /
        m_least;
    const double alongW =
        (std::abs(m_vvw) + across * (2 * std::abs(m_vww) + across * std::abs(m_www)) + change) *
        stretch / m_most;
    return std::max(alongV, alongW) * eta <= certain;
  }

  /// Sets the second derivative: with h' the radial factor as a function of r²/2 it is h''' p p p,
  /// and the symmetric product of the unit matrix with h'' p + 2 (p2, p1).
  void setThird(const Vec2& ideal) {
    const auto [h2, h3, h4] = m_lens.bends(m_radius);
    const auto [p1, p2] = std::pair(m_lens.params().p1, m_lens.params().p2);
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
  Sizes m_stretch{};  ///< the factors of w in the norms
  double m_vvv = 0;
  double m_vvw = 0;
  double m_vww = 0;
  double m_www = 0;
};

/// Makes Newton steps from `ideal`, which `place` certifies to be in the root's basin, until one is
/// at most `part` of the first. By the certificate each is shorter than half the previous one in
/// one of the norms, except for rounding; the residual may grow.
Vec2 polished(const Distortion& lens, const Place& place, Vec2 ideal, const Vec2& distorted,
              double part) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Sizes shortest{infinite, infinite, infinite};
  Sizes enough{};
  for (;;) {
    const Vec2 d = lens.distort(ideal);
    const Vec2 residual{distorted.x - d.x, distorted.y - d.y};
    const Jacobian j = lens.jacobian(ideal);
    const double det = j.xx * j.yy - j.xy * j.yx;
    const Vec2 step{(j.yy * residual.x - j.xy * residual.y) / det,
                    (j.xx * residual.y - j.yx * residual.x) / det};
    const Vec2 turned = place.turned(step);
    const Sizes sizes = place.sizes({std::abs(turned.x), std::abs(turned.y)});
    if (!isOneBelow(sizes, 0.5, shortest)) return ideal;
    ideal = {ideal.x + step.x, ideal.y + step.y};
    if (areBelow(sizes, 1, enough)) return ideal;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      if (shortest[k] == infinite) enough[k] = part * sizes[k];
      shortest[k] = std::min(shortest[k], sizes[k]);
    }
  }
}

double dot(const Vec2& a, const Vec2& b) {
  return a.x * b.x + a.y * b.y;
}

/// Lines of one direction that cut the segments to a disc, since near a fold the lens allows less
/// along the segments than across them: at t they cut the line through t·centre over a length of
/// 2·t·halfWidth.
struct Lines {
  Vec2 normal;
  Vec2 along;        ///< their direction
  double distance;   ///< from the image's centre to the line through the disc's
  double halfWidth;  ///< half the length of that line
  double nearest;    ///< the t before which no line meets the disc

  Lines(const Disc& disc, const Vec2& lineNormal)
      : normal(lineNormal),
        along{-lineNormal.y, lineNormal.x},
        distance(dot(disc.centre, normal)),
        halfWidth(norm(disc.centre) * disc.radius / (distance - disc.radius)),
        nearest(1 - disc.radius / distance) {}

  /// Returns false for a disc that is too near to the image's centre, or seen from there along the
  /// lines.
  [[nodiscard]] bool canBeFollowed() const { return nearest > 0.1; }
};

/// The extents of Newton's first moves from a place on the way: to the point of the centre's
/// segment, per part of the segment, and to the end of the line through the disc's centre.
struct Moves {
  double reached;
  Extent residual;
  Extent speed;
  Extent width;

  /// Returns the extent of the moves to all points up to the line that is further by this part of
  /// the segment.
  [[nodiscard]] Extent after(double further) const {
    return residual + further * speed + (reached + further) * width;
  }
};

/// Follows the branch from line to line.
class Walk {
 public:
  Walk(const Distortion& lens, const Disc& disc, const BranchLine& start,
       std::vector<BranchLine>* lines)
      : m_lens(lens),
        m_disc(disc),
        m_known(lines),
        m_lines(disc,
                start.distance > 0 ? start.normal : times(1 / norm(disc.centre), disc.centre)) {
    const double part = start.distance / m_lines.distance;
    if (part > 0 && part < 1) restart(part, start.ideal);
  }

  Branch run(const Progress& progress) {
    if (!m_lines.canBeFollowed()) return m_branch;
    while (m_reached < 1) {
      throwIfCancelled(progress);
      const Place place(m_lens, m_branch.ideal);
      if (!place.isRegular()) return m_branch;
      const Moves moves = movesAt(place);
      m_step = std::min(2 * m_step, 1 - m_reached);
      const bool isCertain = place.isCertain(moves.after(m_step));
      if (!isCertain && isDark(place, moves)) return m_branch;
      if (isCertain || shorten(place, moves))
        advance(place);
      else if (!turn(place, moves))
        return m_branch;
    }
    const Place place(m_lens, m_branch.ideal);
    // A disc of this radius holds the line and all of the disc.
    if (place.isRegular() && place.isCertain(place.solved(m_lines.halfWidth)))
      m_branch.kind = Branch::Kind::ray;
    return m_branch;
  }

 private:
  /// Goes to a part of the centre's segment, whose root Newton finds from an ideal point.
  void restart(double part, const Vec2& ideal) {
    m_reached = part;
    m_branch.ideal =
        polished(m_lens, Place(m_lens, ideal), ideal, times(part, m_disc.centre), toRounding);
  }

  [[nodiscard]] Moves movesAt(const Place& place) const {
    const Vec2 here = m_lens.distort(m_branch.ideal);
    const Vec2 target = times(m_reached, m_disc.centre);
    return {m_reached, place.solved(place.turned({target.x - here.x, target.y - here.y})),
            place.solved(place.turned(m_disc.centre)),
            m_lines.halfWidth * place.solved(place.turned(m_lines.along))};
  }

  /// Whether all segments meet a fold soon, and before the disc; the branch then ends here.
  bool isDark(const Place& place, const Moves& moves) {
    const Extent here = moves.after(0);
    const double end =
        m_reached + place.timeToFold(2.0 * here, place.turned(m_disc.centre), m_lines.halfWidth);
    if (!(end < m_lines.nearest && place.isCertain(here))) return false;
    m_branch.kind = Branch::Kind::none;
    m_branch.end = end / m_lines.nearest;
    return true;
  }

  /// Shortens the step until it is certain. Returns whether that is useful: parts of lines
  /// that are wider than the step is long get farther.
  bool shorten(const Place& place, const Moves& moves) {
    constexpr double shortestStep = 1e-13;  // of the reached part; a nearer point is on the fold
    do {
      m_step /= 2;
      if (areBelow(place.sizes(m_step * moves.speed), 0.25, place.sizes(m_reached * moves.width)) ||
          !(m_step > shortestStep * m_reached))
        return false;
    } while (!place.isCertain(moves.after(m_step)));
    return true;
  }

  void advance(const Place& place) {
    if (m_known != nullptr)
      m_known->push_back({m_lines.normal, m_reached * m_lines.distance, m_branch.ideal});
    m_reached = m_step == 1 - m_reached ? 1 : m_reached + m_step;
    m_branch.reached = m_reached * m_lines.distance;
    // A root on the way may be off by a thousandth of the step.
    m_branch.ideal = polished(m_lens, place, m_branch.ideal, times(m_reached, m_disc.centre),
                              m_reached == 1 ? toRounding : 0.05);
  }

  /// Continues with lines along which the lens bends least here, if these are much narrower, from
  /// the last one that is entirely within the known part. Returns whether it does, once for each
  /// place.
  bool turn(const Place& place, const Moves& moves) {
    const Lines turned(m_disc, place.foldAlong(m_disc.centre));
    if (m_known == nullptr || !turned.canBeFollowed() || !(m_reached > m_turnedAt)) return false;
    const Extent width = turned.halfWidth * place.solved(place.turned(turned.along));
    if (!isOneBelow(place.sizes(width), 0.5, place.sizes(moves.width))) return false;
    const double part =
        m_reached * m_lines.distance /
        (m_lines.distance + turned.halfWidth * std::abs(dot(m_lines.normal, turned.along)));
    const BranchLine* line = lineBefore(times(part, m_disc.centre), *m_known);
    if (line == nullptr) return false;
    m_turnedAt = m_reached;
    m_lines = turned;
    restart(part, line->ideal);
    return true;
  }

  static constexpr double toRounding = 1e-9;  // Newton's steps are quadratic

  const Distortion& m_lens;
  const Disc& m_disc;
  std::vector<BranchLine>* m_known;
  Lines m_lines;
  Branch m_branch;        ///< its `ideal` is the walk's position
  double m_reached = 0;   ///< the known part of the centre's segment
  double m_step = 1;      ///< the next step, a part of the same segment
  double m_turnedAt = 0;  ///< the last part at which the lines were turned
};

}  // namespace

const BranchLine* lineBefore(const Vec2& distorted, const std::vector<BranchLine>& lines) {
  // Lines of one direction are in order. Others may cross within the segments; then either one is
  // valid.
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
  if (!std::isfinite(disc.centre.x + disc.centre.y + disc.radius)) return {};
  // The square of the distance is then too small for a number, and the lens bends by less.
  if (norm(disc.centre) == 0 && disc.radius == 0) return {Branch::Kind::ray, disc.centre};
  return Walk(lens, disc, start, lines).run(progress);
}

}  // namespace hogelscope
