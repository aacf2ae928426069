// SPDX-License-Identifier: BSD-3-Clause
#include "capture/lenslets/lenslet_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace hogelscope {

namespace {

using std::numbers::pi;

/// A lenslet: its place on the lattice in steps, and its middle in the image.
struct Lenslet {
  PicturePoint steps;
  PicturePoint middle;
  double contrast = 0;  ///< of the weaker of the two waves
};

/// Returns the two waves whose crests form a lattice, in cycles per pixel along x and y.
std::array<PicturePoint, 2> wavesOf(const LensletLattice& lattice) {
  // They have a whole number of cycles along both steps of the lattice.
  const PicturePoint a = lattice.step;
  const PicturePoint b = lattice.step * lattice.rowStep();
  const double area = a.real() * b.imag() - a.imag() * b.real();
  return {PicturePoint(b.imag(), -b.real()) / area, PicturePoint(-a.imag(), a.real()) / area};
}

/// Finds the crests of a lattice's waves near a guess by their phases under a Hann window.
class Crests {
 public:
  /// Uses a window that extends `reach` pitches to both sides.
  Crests(const LensletPlane& picture, const LensletLattice& lattice, double reach)
      : m_picture(picture),
        m_lattice(lattice),
        m_waves(wavesOf(lattice)),
        m_reach(reach * lattice.pitch()) {}

  [[nodiscard]] bool isInside(const PicturePoint& guess) const {
    return guess.real() >= m_reach && guess.real() <= m_picture.width - 1 - m_reach &&
           guess.imag() >= m_reach && guess.imag() <= m_picture.height - 1 - m_reach;
  }

  [[nodiscard]] Lenslet crestNear(const PicturePoint& guess) const {
    const Axis x = axis(guess.real(), 0);
    const Axis y = axis(guess.imag(), 1);
    std::array<PicturePoint, 2> sums{};
    std::array<PicturePoint, 2> flat{};  // those of an image of value 1
    double light = 0;
    double weights = 0;
    for (std::size_t row = 0; row < y.weight.size(); ++row) {
      const float* values =
          &m_picture.values[std::size_t(y.first + int(row)) * std::size_t(m_picture.width) +
                            std::size_t(x.first)];
      std::array<PicturePoint, 2> rowSums{};
      double rowLight = 0;
      for (std::size_t k = 0; k < x.weight.size(); ++k) {
        const double value = x.weight[k] * double(values[k]);
        rowLight += value;
        rowSums[0] += value * x.turns[0][k];
        rowSums[1] += value * x.turns[1][k];
      }
      light += y.weight[row] * rowLight;
      weights += y.weight[row] * x.sum;
      for (const std::size_t wave : {0, 1}) {
        sums[wave] += y.weight[row] * y.turns[wave][row] * rowSums[wave];
        flat[wave] += y.weight[row] * y.turns[wave][row] * x.flat[wave];
      }
    }
    for (const std::size_t wave : {0, 1}) sums[wave] -= light / weights * flat[wave];
    return lensletAt(guess, sums);
  }

 private:
  struct Axis {
    int first = 0;
    std::vector<double> weight;
    double sum = 0;
    std::array<std::vector<PicturePoint>, 2> turns;
    std::array<PicturePoint, 2> flat{};
  };

  [[nodiscard]] Axis axis(double at, int which) const {
    Axis result;
    result.first = int(std::ceil(at - m_reach));
    const int last = int(std::floor(at + m_reach));
    for (int k = result.first; k <= last; ++k) {
      const double weight = 0.5 + 0.5 * std::cos(pi * (k - at) / m_reach);
      result.weight.push_back(weight);
      result.sum += weight;
      for (const std::size_t wave : {0, 1}) {
        const double cycles = which == 0 ? m_waves[wave].real() : m_waves[wave].imag();
        const PicturePoint turn = std::polar(1.0, -2 * pi * cycles * (k - at));
        result.turns[wave].push_back(turn);
        result.flat[wave] += weight * turn;
      }
    }
    return result;
  }

  /// Returns the lenslet: a crest at distance d has the phases −2π k·d, and d is a sum of steps
  /// with the factors k·d.
  [[nodiscard]] Lenslet lensletAt(const PicturePoint& guess,
                                  const std::array<PicturePoint, 2>& sums) const {
    const double along = -std::arg(sums[0]) / (2 * pi);
    const double down = -std::arg(sums[1]) / (2 * pi);
    return {{},
            guess + m_lattice.step * (along + down * m_lattice.rowStep()),
            std::min(std::abs(sums[0]), std::abs(sums[1]))};
  }

  const LensletPlane& m_picture;
  LensletLattice m_lattice;
  std::array<PicturePoint, 2> m_waves;
  double m_reach;
};

/// Returns the lenslets of a lattice within `radius` of the image's middle at the places that the
/// lattice gives, at most some ten thousand, evenly spread.
std::vector<Lenslet> guessesWithin(double radius, const LensletPlane& picture,
                                   const LensletLattice& lattice, const Crests& crests) {
  constexpr double most = 1e4;
  const PicturePoint centre((picture.width - 1) / 2.0, (picture.height - 1) / 2.0);
  const double reach = std::min(radius, std::abs(centre)) / lattice.pitch();
  const int stride = std::max(1, int(std::sqrt(4 * reach * reach / most)));
  const PicturePoint at = (centre - lattice.origin) / lattice.step;
  const PicturePoint row = lattice.rowStep();
  const int middleRow = int(std::lround(at.imag() / row.imag()));
  const int rows = int(reach / row.imag()) + 1;
  std::vector<Lenslet> lenslets;
  for (int j = middleRow - rows; j <= middleRow + rows; j += stride) {
    const int middle = int(std::lround(at.real() - j * row.real()));
    for (int n = middle - int(reach) - 1; n <= middle + int(reach) + 1; n += stride) {
      const PicturePoint guess = lattice.middle(n, j);
      if (std::abs(guess - centre) <= radius && crests.isInside(guess))
        lenslets.push_back({double(n) + double(j) * row, guess, 0});
    }
  }
  return lenslets;
}

/// Returns these lenslets at their measured places, without those of low contrast.
std::vector<Lenslet> lensletsWithin(double radius, const LensletPlane& picture,
                                    const LensletLattice& lattice) {
  const Crests crests(picture, lattice, 1);
  std::vector<Lenslet> lenslets = guessesWithin(radius, picture, lattice, crests);
  parallelRows(int(lenslets.size()), [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      Lenslet& lenslet = lenslets[std::size_t(k)];
      const PicturePoint steps = lenslet.steps;
      lenslet = crests.crestNear(lenslet.middle);
      lenslet.steps = steps;
    }
  });
  if (lenslets.empty()) return {};
  std::vector<double> contrasts;
  contrasts.reserve(lenslets.size());
  for (const Lenslet& lenslet : lenslets) contrasts.push_back(lenslet.contrast);
  const auto median = contrasts.begin() + std::ptrdiff_t(contrasts.size() / 2);
  std::nth_element(contrasts.begin(), median, contrasts.end());
  std::erase_if(lenslets, [limit = *median / 5](const Lenslet& l) { return l.contrast < limit; });
  return lenslets;
}

/// Fits origin + step · steps to the middles by least squares; given figures are kept.
LensletLattice fitted(LensletLattice lattice, const std::vector<Lenslet>& lenslets,
                      const LensletParams& params, bool isOriginGiven) {
  PicturePoint middle = lattice.origin;
  PicturePoint steps = 0;
  if (!isOriginGiven) {
    middle = 0;
    for (const Lenslet& lenslet : lenslets) {
      middle += lenslet.middle / double(lenslets.size());
      steps += lenslet.steps / double(lenslets.size());
    }
  }
  PicturePoint product = 0;
  double squares = 0;
  for (const Lenslet& lenslet : lenslets) {
    product += std::conj(lenslet.steps - steps) * (lenslet.middle - middle);
    squares += std::norm(lenslet.steps - steps);
  }
  if (squares > 0) {
    const double angle =
        params.rotation == notGiven ? std::arg(product) : params.rotation / 180 * pi;
    const double pitch = params.pitch == notGiven
                             ? (product * std::polar(1.0, -angle)).real() / squares
                             : params.pitch;
    lattice.step = std::polar(pitch, angle);
  }
  lattice.origin = middle - lattice.step * steps;
  return lattice;
}

double rmsDistance(const LensletLattice& lattice, const std::vector<Lenslet>& lenslets) {
  double sum = 0;
  for (const Lenslet& lenslet : lenslets)
    sum += std::norm(lenslet.middle - lattice.origin - lattice.step * lenslet.steps);
  return std::sqrt(sum / double(lenslets.size()));
}

[[noreturn]] void refuse(const LensletParams& params) {
  const bool isSquare = params.grid == LensletGrid::square;
  const bool isOneGiven =
      params.pitch != notGiven || params.rotation != notGiven || params.isOriginGiven();
  throw InputError(
      "", "lenslets",
      std::string("are not found: it has no regular ") + (isSquare ? "square" : "hexagonal") +
          " grid of bright spots" +
          (isOneGiven ? " with the given pitch, rotation or origin" : "") + "; give " +
          (params.white.empty() ? "lightField.white" : "another lightField.white") + ", grid " +
          (isSquare ? "hexagonal" : "square") +
          (isOneGiven ? ", or other figures, or none" : ", or pitch, rotation and origin"));
}

/// Returns a lattice with a first estimate of the step; its origin is a crest near the image's
/// middle.
LensletLattice firstLattice(const LensletPlane& picture, const LensletParams& params) {
  const auto guess = stepFromSpectrum(picture, params);
  if (!guess) refuse(params);
  const PicturePoint centre((picture.width - 1) / 2.0, (picture.height - 1) / 2.0);
  const double pitch = params.pitch == notGiven ? std::abs(*guess) : params.pitch;
  const double angle = params.rotation == notGiven ? std::arg(*guess) : params.rotation / 180 * pi;
  LensletLattice lattice{params.grid, centre, std::polar(pitch, angle)};
  const Crests wide(picture, lattice,
                    std::min(picture.width, picture.height) > 7 * lattice.pitch() ? 3 : 1);
  if (wide.isInside(centre)) lattice.origin = wide.crestNear(centre).middle;
  return lattice;
}

/// Whether nearly all places of a lattice are brighter in the middle than at the points that are
/// farthest from it, and much brighter on the whole.
bool areSpots(const LensletPlane& picture, const FoundLenslets& found) {
  const LensletLattice& lattice = found.lattice;
  const auto valueAt = [&picture](const PicturePoint& at) {
    const auto x = std::size_t(std::lround(at.real())), y = std::size_t(std::lround(at.imag()));
    return double(picture.values[y * std::size_t(picture.width) + x]);
  };
  const PicturePoint hole =
      lattice.step * (1.0 + lattice.rowStep()) / (lattice.grid == LensletGrid::square ? 2.0 : 3.0);
  double spots = 0, holes = 0;
  int brighter = 0, count = 0;
  const Crests crests(picture, lattice, 1);
  const double whole = std::hypot(picture.width, picture.height);
  for (const Lenslet& lenslet : guessesWithin(whole, picture, lattice, crests)) {
    const double spot = valueAt(lenslet.middle);
    const double gap = std::max(valueAt(lenslet.middle + hole), valueAt(lenslet.middle - hole));
    spots += spot;
    holes += gap;
    brighter += int(spot > gap);
    ++count;
  }
  constexpr int least = 50;
  constexpr double share = 0.9, times = 1.5;
  return count >= least && brighter > share * count && spots > times * holes;
}

}  // namespace

std::optional<FoundLenslets> recognisedLenslets(const LensletPlane& picture,
                                                const Progress& progress) {
  constexpr double leastPitch = 5;      // pixels
  constexpr double mostResidual = 0.1;  // pitches
  constexpr double mostDegrees = 10;
  std::optional<FoundLenslets> best;
  for (const LensletGrid grid : {LensletGrid::square, LensletGrid::hexagonal}) {
    LensletParams params;
    params.grid = grid;
    try {
      const FoundLenslets found = findLenslets(picture, params, progress);
      const double pitch = found.lattice.pitch();
      if (pitch >= leastPitch && found.residual < mostResidual * pitch &&
          std::abs(found.lattice.rotation()) < mostDegrees && areSpots(picture, found) &&
          (!best || found.residual < best->residual))
        best = found;
    } catch (const InputError&) {  // it has no such grid
    }
  }
  return best;
}

FoundLenslets findLenslets(const LensletPlane& picture, const LensletParams& params,
                           const Progress& progress) {
  const bool isOriginGiven = params.isOriginGiven();
  if (isOriginGiven && params.pitch != notGiven && params.rotation != notGiven)
    return {latticeOf(params), 0, 0};
  LensletLattice lattice = firstLattice(picture, params);
  const double whole = std::hypot(picture.width, picture.height);
  double radius = 4 * lattice.pitch();
  std::vector<Lenslet> lenslets;
  for (int more = 2; more > 0; radius *= 2) {  // twice with all lenslets
    throwIfCancelled(progress);
    if (radius > whole) --more;
    lenslets = lensletsWithin(radius, picture, lattice);
    if (lenslets.size() < 4) refuse(params);
    lattice = fitted(lattice, lenslets, params, false);
  }
  if (isOriginGiven) {
    const PicturePoint given(params.origin[0], params.origin[1]);
    const auto [n, row] = lattice.nearestTo(given);
    for (Lenslet& lenslet : lenslets) lenslet.steps -= double(n) + double(row) * lattice.rowStep();
    lattice.origin = given;
    lattice = fitted(lattice, lenslets, params, true);
  }
  const double residual = rmsDistance(lattice, lenslets);
  if (!(residual < lattice.pitch() / 5)) refuse(params);
  return {lattice, int(lenslets.size()), residual};
}

}  // namespace hogelscope
