// SPDX-License-Identifier: BSD-3-Clause
// LDR-FLIP of Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", HPG 2020:
// the difference that an eye sees when it alternates between two pictures at a known distance.
//
// Each picture is filtered by the contrast sensitivity of the eye in the colour space YCxCz, then
// compared in L*a*b* with Hunt's adjustment by the HyAB distance (the colour difference); edges and
// points of the unfiltered luminance give the feature difference.
//
//   FLIP = (mean over the pixels of) colour^(1 − feature), 0 for equal pictures, 1 at most
//
// Widths of filters are in degrees, so that it needs the pixels per degree of the pictures.
#include <hogelscope/plugin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace {

using namespace hogelscope;

/// A value of each pixel, row by row.
using Plane = std::vector<double>;
using Colour = std::array<double, 3>;
using Colours = std::array<Plane, 3>;

struct Size {
  std::size_t width = 0;
  std::size_t height = 0;
};

constexpr double square(double x) {
  return x * x;
}

/// The matrix of linear sRGB to XYZ; its rows' sums are the white D65.
constexpr std::array<Colour, 3> xyzOfRgb{
    {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
     {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
     {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}}};

double sumOf(const Colour& colour) {
  return colour[0] + colour[1] + colour[2];
}

Colour product(const std::array<Colour, 3>& matrix, const Colour& of) {
  Colour result{};
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = matrix[k][0] * of[0] + matrix[k][1] * of[1] + matrix[k][2] * of[2];
  return result;
}

std::array<Colour, 3> inverseOf(const std::array<Colour, 3>& m) {
  std::array<Colour, 3> adjugate{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column) {
      const std::size_t a = (column + 1) % 3, b = (column + 2) % 3;
      const std::size_t c = (row + 1) % 3, d = (row + 2) % 3;
      adjugate[row][column] = m[a][c] * m[b][d] - m[a][d] * m[b][c];
    }
  const double determinant =
      m[0][0] * adjugate[0][0] + m[0][1] * adjugate[1][0] + m[0][2] * adjugate[2][0];
  for (Colour& row : adjugate)
    for (double& value : row) value /= determinant;
  return adjugate;
}

double linearOf(std::uint8_t code) {
  const double s = code / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

/// Returns XYZ relative to white.
Colour relativeXyz(const Colour& rgb) {
  Colour xyz = product(xyzOfRgb, rgb);
  for (std::size_t k = 0; k < 3; ++k) xyz[k] /= sumOf(xyzOfRgb[k]);
  return xyz;
}

/// Returns YCxCz, the linear opponent space in which contrast sensitivity is known.
Colour opponentOf(const Colour& rgb) {
  const auto [x, y, z] = relativeXyz(rgb);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Colour rgbOfOpponent(const Colour& opponent) {
  static const std::array<Colour, 3> rgbOfXyz = inverseOf(xyzOfRgb);
  const double y = (opponent[0] + 16) / 116;
  Colour xyz{opponent[1] / 500 + y, y, y - opponent[2] / 200};
  for (std::size_t k = 0; k < 3; ++k) xyz[k] *= sumOf(xyzOfRgb[k]);
  return product(rgbOfXyz, xyz);
}

/// Returns CIE L*a*b* with chroma in proportion to lightness (Hunt's effect).
Colour huntLabOf(const Colour& rgb) {
  constexpr double delta = 6.0 / 29;
  Colour f = relativeXyz(rgb);
  for (double& t : f)
    t = t > delta * delta * delta ? std::cbrt(t) : t / square(delta) / 3 + 4.0 / 29;
  const double lightness = 116 * f[1] - 16;
  return {lightness, 5 * lightness * (f[0] - f[1]), 2 * lightness * (f[1] - f[2])};
}

double hyAb(const Colour& a, const Colour& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

Colours opponentPlanes(const plugin::View& view) {
  static const std::array<double, 256> linear = [] {
    std::array<double, 256> table{};
    for (std::size_t code = 0; code < table.size(); ++code)
      table[code] = linearOf(static_cast<std::uint8_t>(code));
    return table;
  }();
  const std::size_t pixels = view.rgb.size() / 3;
  Colours planes{Plane(pixels), Plane(pixels), Plane(pixels)};
  for (std::size_t p = 0; p < pixels; ++p) {
    const std::uint8_t* code = &view.rgb[3 * p];
    const Colour colour = opponentOf({linear[code[0]], linear[code[1]], linear[code[2]]});
    for (std::size_t k = 0; k < 3; ++k) planes[k][p] = colour[k];
  }
  return planes;
}

/// The weights of a filter along one axis, of 2 radius + 1 pixels.
using Weights = std::vector<double>;

template <class Function>
Weights weightsOf(double radius, Function function) {
  const int reach = int(std::ceil(radius));
  Weights weights;
  for (int x = -reach; x <= reach; ++x) weights.push_back(function(double(x)));
  return weights;
}

double sumOf(const Weights& weights) {
  double sum = 0;
  for (const double weight : weights) sum += weight;
  return sum;
}

Weights normalised(Weights weights) {
  const double sum = sumOf(weights);
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// Scales the weights above 0 to a sum of 1, and those below 0 to −1.
Weights balanced(Weights weights) {
  std::array<double, 2> sums{};
  for (const double weight : weights) sums[weight < 0 ? 1 : 0] += std::abs(weight);
  for (double& weight : weights) weight /= sums[weight < 0 ? 1 : 0];
  return weights;
}

/// Correlates rows with `across`, then columns with `down`; pixels of the edge go on outside.
Plane filtered(const Plane& from, const Size& size, const Weights& across, const Weights& down) {
  const auto [width, height] = size;
  const std::size_t beside = across.size() / 2;
  Plane rows(from.size(), 0.0);
  Plane padded(width + 2 * beside);
  for (std::size_t y = 0; y < height; ++y) {
    const double* row = &from[y * width];
    std::fill_n(padded.begin(), beside, row[0]);
    std::copy_n(row, width, padded.begin() + std::ptrdiff_t(beside));
    std::fill_n(padded.end() - std::ptrdiff_t(beside), beside, row[width - 1]);
    for (std::size_t k = 0; k < across.size(); ++k)
      for (std::size_t x = 0; x < width; ++x) rows[y * width + x] += across[k] * padded[x + k];
  }
  const auto above = std::ptrdiff_t(down.size() / 2);
  Plane result(from.size(), 0.0);
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t k = 0; k < down.size(); ++k) {
      const std::ptrdiff_t at = std::ptrdiff_t(y + k) - above;
      const auto line = std::size_t(std::clamp<std::ptrdiff_t>(at, 0, std::ptrdiff_t(height) - 1));
      for (std::size_t x = 0; x < width; ++x)
        result[y * width + x] += down[k] * rows[line * width + x];
    }
  return result;
}

/// A Gaussian of contrast sensitivity, a √(π/b) exp(−π² x²/b) with x in degrees.
struct Sensitivity {
  double a = 0;
  double b = 0;
};

/// Contrast sensitivities of luminance, red–green and blue–yellow: sums of two Gaussians at most.
constexpr std::array<std::array<Sensitivity, 2>, 3> sensitivities{
    {{{{1, 0.0047}, {0, 1e-5}}}, {{{1, 0.0053}, {0, 1e-5}}}, {{{34.1, 0.04}, {13.5, 0.025}}}}};

/// Filters a channel by its contrast sensitivity. A sum of two Gaussians is not the product of an
/// axis' weights, so each of them is filtered by itself.
Plane seenByTheEye(const Plane& channel, const Size& size, double perDegree,
                   const std::array<Sensitivity, 2>& sensitivity) {
  constexpr double widest = 0.04;
  const double radius = 3 * std::sqrt(widest / 2) / std::numbers::pi * perDegree;
  Plane sum(channel.size(), 0.0);
  double whole = 0;
  for (const auto& [a, b] : sensitivity) {
    if (a == 0) continue;
    const Weights weights = weightsOf(radius, [&, b = b](double x) {
      return std::exp(-square(std::numbers::pi * x / perDegree) / b);
    });
    const double height = a * std::sqrt(std::numbers::pi / b);
    const Plane part = filtered(channel, size, weights, weights);
    for (std::size_t p = 0; p < sum.size(); ++p) sum[p] += height * part[p];
    whole += height * square(sumOf(weights));
  }
  for (double& value : sum) value /= whole;
  return sum;
}

/// Returns the colours that are compared, in L*a*b*.
Colours perceived(const Colours& opponent, const Size& size, double perDegree) {
  Colours planes;
  for (std::size_t k = 0; k < 3; ++k)
    planes[k] = seenByTheEye(opponent[k], size, perDegree, sensitivities[k]);
  for (std::size_t p = 0; p < planes[0].size(); ++p) {
    Colour rgb = rgbOfOpponent({planes[0][p], planes[1][p], planes[2][p]});
    for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
    const Colour lab = huntLabOf(rgb);
    for (std::size_t k = 0; k < 3; ++k) planes[k][p] = lab[k];
  }
  return planes;
}

/// How strong edges and points are at each pixel.
struct Features {
  Plane edges;
  Plane points;
};

Features featuresOf(const Plane& luminance, const Size& size, double perDegree) {
  constexpr double width = 0.082;  // degrees
  const double deviation = width / 2 * perDegree;
  const auto gauss = [deviation](double x) { return std::exp(-square(x / deviation) / 2); };
  const Weights smooth = normalised(weightsOf(3 * deviation, gauss));
  const auto strengths = [&](const Weights& weights) {
    Plane across = filtered(luminance, size, weights, smooth);
    const Plane down = filtered(luminance, size, smooth, weights);
    for (std::size_t p = 0; p < across.size(); ++p) across[p] = std::hypot(across[p], down[p]);
    return across;
  };
  const Weights edge = balanced(weightsOf(3 * deviation, [&](double x) { return -x * gauss(x); }));
  const Weights point = balanced(
      weightsOf(3 * deviation, [&](double x) { return (square(x / deviation) - 1) * gauss(x); }));
  return {strengths(edge), strengths(point)};
}

/// Returns the colour difference within 0 … 1: up to 40 % of the largest one (green to blue), it
/// takes 95 % of the range.
double redistributed(double distance) {
  constexpr double exponent = 0.7;
  constexpr double knee = 0.4;
  constexpr double kneeValue = 0.95;
  static const double largest =
      std::pow(hyAb(huntLabOf({0, 1, 0}), huntLabOf({0, 0, 1})), exponent);
  const double share = std::pow(distance, exponent) / largest;
  return share < knee ? share * kneeValue / knee
                      : kneeValue + (share - knee) / (1 - knee) * (1 - kneeValue);
}

/// Returns FLIP of each pixel.
Plane differenceMap(const plugin::View& reference, const plugin::View& test, double perDegree) {
  const Size size{std::size_t(reference.width), std::size_t(reference.height)};
  const std::array opponents{opponentPlanes(reference), opponentPlanes(test)};
  std::array<Features, 2> features;
  std::array<Colours, 2> colours;
  for (std::size_t k = 0; k < 2; ++k) {
    Plane luminance = opponents[k][0];
    for (double& value : luminance) value = (value + 16) / 116;
    features[k] = featuresOf(luminance, size, perDegree);
    colours[k] = perceived(opponents[k], size, perDegree);
  }
  Plane map(size.width * size.height);
  for (std::size_t p = 0; p < map.size(); ++p) {
    const auto colourOf = [&](std::size_t k) {
      return Colour{colours[k][0][p], colours[k][1][p], colours[k][2][p]};
    };
    const double feature = std::max(std::abs(features[0].edges[p] - features[1].edges[p]),
                                    std::abs(features[0].points[p] - features[1].points[p]));
    map[p] = std::pow(redistributed(hyAb(colourOf(0), colourOf(1))),
                      1 - std::sqrt(feature / std::numbers::sqrt2));
  }
  return map;
}

class Flip final : public plugin::Metric {
 public:
  [[nodiscard]] const char* title() const override { return "FLIP"; }
  [[nodiscard]] std::int32_t decimals() const override { return 4; }
  [[nodiscard]] bool hasSeen() const override { return true; }

  [[nodiscard]] double compare(const plugin::View& reference, const plugin::View& test,
                               const plugin::Viewing& viewing) const override {
    return compareBoth(reference, test, viewing).frame;
  }
  /// Returns NaN for pixels that are unknown, larger than a degree, or less than 1/2000 of one:
  /// what the filters were measured for is far inside.
  [[nodiscard]] plugin::Figures compareBoth(const plugin::View& reference, const plugin::View& test,
                                            const plugin::Viewing& viewing) const override {
    plugin::Figures figures;
    const double perDegree = viewing.pixelsPerDegree;
    if (!(perDegree >= 1 && perDegree <= 2000)) return figures;
    const Plane map = differenceMap(reference, test, perDegree);
    double frame = 0, seen = 0;
    std::size_t count = 0;
    for (std::size_t p = 0; p < map.size(); ++p) {
      frame += map[p];
      if (reference.seen.empty() || (reference.seen[p] & test.seen[p]) == 0) continue;
      seen += map[p];
      ++count;
    }
    figures.frame = frame / double(map.size());
    if (count > 0) figures.seen = seen / double(count);
    return figures;
  }
};

plugin::Metric* makeFlip() {
  return new Flip;
}

}  // namespace

HOGELSCOPE_PLUGIN("flip", "1.0", nullptr, nullptr, makeFlip);
