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
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "core/base/multiversioned.h"

namespace {

using namespace hogelscope;

/// A value of each pixel, row by row; rows have more room than pixels, for whole vectors.
using Plane = std::vector<float>;
using Colour = std::array<double, 3>;
using Colours = std::array<Plane, 3>;

constexpr std::size_t block = 32;  ///< pixels whose sums stay in registers

struct Size {
  std::size_t width = 0;
  std::size_t height = 0;
  /// Returns the distance of two rows.
  [[nodiscard]] std::size_t stride() const { return (width + block - 1) / block * block; }
  [[nodiscard]] std::size_t values() const { return stride() * height; }
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

/// Returns the planes of a picture in YCxCz.
Colours opponentPlanes(const plugin::View& view, const Size& size) {
  static const std::array<std::array<float, 3>, 3> matrix = [] {
    std::array<std::array<float, 3>, 3> result{};
    const Colour black = opponentOf({0, 0, 0});
    for (std::size_t column = 0; column < 3; ++column) {
      Colour primary{};
      primary[column] = 1;
      const Colour opponent = opponentOf(primary);
      for (std::size_t row = 0; row < 3; ++row)
        result[row][column] = float(opponent[row] - black[row]);
    }
    return result;
  }();
  static const std::array<float, 256> linear = [] {
    std::array<float, 256> table{};
    for (std::size_t code = 0; code < table.size(); ++code)
      table[code] = float(linearOf(static_cast<std::uint8_t>(code)));
    return table;
  }();
  Colours planes{Plane(size.values()), Plane(size.values()), Plane(size.values())};
  for (std::size_t y = 0; y < size.height; ++y)
    for (std::size_t x = 0; x < size.width; ++x) {
      const std::uint8_t* code = &view.rgb[3 * (y * size.width + x)];
      const std::array rgb{linear[code[0]], linear[code[1]], linear[code[2]]};
      for (std::size_t k = 0; k < 3; ++k)
        planes[k][y * size.stride() + x] = matrix[k][0] * rgb[0] + matrix[k][1] * rgb[1] +
                                           matrix[k][2] * rgb[2] - (k == 0 ? 16.0F : 0.0F);
    }
  return planes;
}

/// The weights of a filter along one axis, of 2 radius + 1 pixels.
using Weights = std::vector<float>;

/// Scales the weights above 0 to a sum of 1, and those below 0 to −1.
template <class Function>
Weights weightsOf(double radius, Function function) {
  const int reach = int(std::ceil(radius));
  std::vector<double> weights;
  for (int x = -reach; x <= reach; ++x) weights.push_back(function(double(x)));
  std::array<double, 2> sums{};
  for (const double weight : weights) sums[weight < 0 ? 1 : 0] += std::abs(weight);
  Weights balanced;
  for (const double weight : weights) balanced.push_back(float(weight / sums[weight < 0 ? 1 : 0]));
  return balanced;
}

/// Correlates a row, which begins half a filter before `to`.
MULTIVERSIONED void correlateRow(const float* from, const Weights& weights, std::size_t count,
                                 float* to) {
  for (std::size_t x = 0; x < count; x += block) {
    std::array<float, block> sums{};
    for (std::size_t k = 0; k < weights.size(); ++k)
      for (std::size_t i = 0; i < block; ++i) sums[i] += weights[k] * from[x + k + i];
    std::copy_n(sums.begin(), block, to + x);
  }
}

/// Sums rows, each with its weight.
MULTIVERSIONED void sumRows(const float* const* rows, const Weights& weights, std::size_t count,
                            float* to) {
  for (std::size_t x = 0; x < count; x += block) {
    std::array<float, block> sums{};
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const float weight = weights[k];
      const float* const row = rows[k] + x;
      for (std::size_t i = 0; i < block; ++i) sums[i] += weight * row[i];
    }
    std::copy_n(sums.begin(), block, to + x);
  }
}

/// Correlates rows; pixels of the edge go on outside.
Plane filteredAcross(const Plane& from, const Size& size, const Weights& weights) {
  const std::size_t beside = weights.size() / 2;
  Plane result(size.values());
  std::vector<float> padded(size.stride() + 2 * beside);
  for (std::size_t y = 0; y < size.height; ++y) {
    const float* row = &from[y * size.stride()];
    std::fill_n(padded.begin(), beside, row[0]);
    std::copy_n(row, size.width, padded.begin() + std::ptrdiff_t(beside));
    std::fill(padded.begin() + std::ptrdiff_t(beside + size.width), padded.end(),
              row[size.width - 1]);
    correlateRow(padded.data(), weights, size.stride(), &result[y * size.stride()]);
  }
  return result;
}

/// Correlates columns; pixels of the edge go on outside.
Plane filteredDown(const Plane& from, const Size& size, const Weights& weights) {
  const auto above = std::ptrdiff_t(weights.size() / 2);
  const auto last = std::ptrdiff_t(size.height) - 1;
  Plane result(size.values());
  std::vector<const float*> rows(weights.size());
  for (std::size_t y = 0; y < size.height; ++y) {
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const std::ptrdiff_t line = std::ptrdiff_t(y + k) - above;
      rows[k] = &from[std::size_t(std::clamp<std::ptrdiff_t>(line, 0, last)) * size.stride()];
    }
    sumRows(rows.data(), weights, size.stride(), &result[y * size.stride()]);
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

MULTIVERSIONED void addScaled(Plane& sum, float scale, const Plane& part) {
  for (std::size_t p = 0; p < sum.size(); ++p) sum[p] += scale * part[p];
}

/// Filters a channel by its contrast sensitivity. A sum of two Gaussians is not the product of an
/// axis' weights, so each of them is filtered by itself.
Plane seenByTheEye(const Plane& channel, const Size& size, double perDegree,
                   const std::array<Sensitivity, 2>& sensitivity) {
  constexpr double widest = 0.04;
  const double radius = 3 * std::sqrt(widest / 2) / std::numbers::pi * perDegree;
  std::array<double, 2> shares{};  // of the whole filter's sum
  std::array<Plane, 2> parts;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto [a, b] = sensitivity[k];
    if (a == 0) continue;
    double sum = 0;
    const Weights weights = weightsOf(radius, [&, b = b](double x) {
      const double weight = std::exp(-square(std::numbers::pi * x / perDegree) / b);
      sum += weight;
      return weight;
    });
    parts[k] = filteredDown(filteredAcross(channel, size, weights), size, weights);
    shares[k] = a * std::sqrt(std::numbers::pi / b) * square(sum);
  }
  if (parts[1].empty()) return std::move(parts[0]);
  const double whole = shares[0] + shares[1];
  Plane result(size.values());
  for (std::size_t k = 0; k < 2; ++k) addScaled(result, float(shares[k] / whole), parts[k]);
  return result;
}

/// Returns t^(1/3) of 0.008 … 1 by two of Halley's steps, each of which triples the digits. The
/// loops below use it and powerOf() in place of the library's, which work on one value at a time.
inline float cubeRootOf(float t) {
  float root = std::bit_cast<float>(std::bit_cast<std::int32_t>(t) / 3 + 0x2a5137a0);
  for (int step = 0; step < 2; ++step) {
    const float cube = root * root * root;
    root *= (cube + 2 * t) / (2 * cube + t);
  }
  return root;
}

/// Returns x^y of x from 0 to 1e30 and y from 0 to 1, to 1e-6: 2^(y log2 x) by series of the
/// mantissa's logarithm and of the exponential.
inline float powerOf(float x, float y) {
  constexpr auto perLog2 = float(2 / std::numbers::ln2);
  constexpr auto ln2 = float(std::numbers::ln2);
  constexpr std::int32_t one = 0x3f800000;
  constexpr std::int32_t middle = 0x3f3504f3;  // sqrt(1/2): mantissas from there to sqrt(2)
  constexpr int mantissaBits = 23;
  const std::int32_t bits = std::bit_cast<std::int32_t>(x) - middle;
  const auto exponent = float(bits >> mantissaBits);
  const auto mantissa = std::bit_cast<float>((bits & ((1 << mantissaBits) - 1)) + middle);
  const float s = (mantissa - 1) / (mantissa + 1);
  const float t = s * s;
  const float log2 =
      exponent + perLog2 * s * (1 + t * (1.0F / 3 + t * (1.0F / 5 + t * (1.0F / 7))));
  const float power = y * log2;
  const auto whole = std::int32_t(power + 200.5F) - 200;  // nearest; -200 < power < 200
  const float r = (power - float(whole)) * ln2;
  const float series =
      1 + r * (1 + r * (1.0F / 2 +
                        r * (1.0F / 6 + r * (1.0F / 24 + r * (1.0F / 120 + r * (1.0F / 720))))));
  const auto scale = std::bit_cast<float>((std::max(whole, -126) << mantissaBits) + one);
  constexpr float zero = 1e-30F;
  return x < zero ? (y > 0 ? 0.0F : 1.0F) : series * scale;
}

using Matrix = std::array<std::array<float, 3>, 3>;

Matrix rgbOfRelativeXyz() {
  const std::array<Colour, 3> inverse = inverseOf(xyzOfRgb);
  Matrix result{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      result[row][column] = float(inverse[row][column] * sumOf(xyzOfRgb[column]));
  return result;
}

Matrix relativeXyzOfRgb() {
  Matrix result{};
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 3; ++column)
      result[row][column] = float(xyzOfRgb[row][column] / sumOf(xyzOfRgb[row]));
  return result;
}

inline float rowOf(const std::array<float, 3>& row, float a, float b, float c) {
  return row[0] * a + row[1] * b + row[2] * c;
}

/// The function of L*a*b*.
inline float labShareOf(float t) {
  constexpr float delta = 6.0F / 29;
  const float root = cubeRootOf(std::max(t, delta * delta * delta));
  const float line = t * (1 / (3 * delta * delta)) + 4.0F / 29;
  return t > delta * delta * delta ? root : line;
}

/// Replaces YCxCz by L*a*b* with Hunt's adjustment, of colours limited to those of sRGB.
MULTIVERSIONED void makeHuntLab(Colours& planes, const Matrix& toRgb, const Matrix& toXyz) {
  float* const first = planes[0].data();
  float* const second = planes[1].data();
  float* const third = planes[2].data();
  for (std::size_t p = 0; p < planes[0].size(); ++p) {
    const float y = (first[p] + 16) * (1.0F / 116);
    const float x = second[p] * (1.0F / 500) + y;
    const float z = y - third[p] * (1.0F / 200);
    const float r = std::clamp(rowOf(toRgb[0], x, y, z), 0.0F, 1.0F);
    const float g = std::clamp(rowOf(toRgb[1], x, y, z), 0.0F, 1.0F);
    const float b = std::clamp(rowOf(toRgb[2], x, y, z), 0.0F, 1.0F);
    const float fx = labShareOf(rowOf(toXyz[0], r, g, b));
    const float fy = labShareOf(rowOf(toXyz[1], r, g, b));
    const float fz = labShareOf(rowOf(toXyz[2], r, g, b));
    const float lightness = 116 * fy - 16;
    first[p] = lightness;
    second[p] = 5 * lightness * (fx - fy);
    third[p] = 2 * lightness * (fy - fz);
  }
}

/// Returns the colours that are compared, in L*a*b*.
Colours perceived(const Colours& opponent, const Size& size, double perDegree) {
  static const Matrix toRgb = rgbOfRelativeXyz();
  static const Matrix toXyz = relativeXyzOfRgb();
  Colours planes;
  for (std::size_t k = 0; k < 3; ++k)
    planes[k] = seenByTheEye(opponent[k], size, perDegree, sensitivities[k]);
  makeHuntLab(planes, toRgb, toXyz);
  return planes;
}

/// How strong edges and points are at each pixel.
struct Features {
  Plane edges;
  Plane points;
};

/// Replaces the first plane by the length of both.
MULTIVERSIONED void makeLengths(Plane& across, const Plane& down) {
  for (std::size_t p = 0; p < across.size(); ++p)
    across[p] = std::sqrt(across[p] * across[p] + down[p] * down[p]);
}

Features featuresOf(const Plane& luminance, const Size& size, double perDegree) {
  constexpr double width = 0.082;  // degrees
  const double deviation = width / 2 * perDegree;
  const auto gauss = [deviation](double x) { return std::exp(-square(x / deviation) / 2); };
  const Weights smooth = weightsOf(3 * deviation, gauss);
  const Plane smoothAcross = filteredAcross(luminance, size, smooth);
  const auto strengths = [&](const Weights& weights) {
    Plane across = filteredDown(filteredAcross(luminance, size, weights), size, smooth);
    makeLengths(across, filteredDown(smoothAcross, size, weights));
    return across;
  };
  return {strengths(weightsOf(3 * deviation, [&](double x) { return -x * gauss(x); })),
          strengths(weightsOf(3 * deviation,
                              [&](double x) { return (square(x / deviation) - 1) * gauss(x); }))};
}

constexpr float hyAbExponent = 0.7F;

/// Writes FLIP of each pixel into the first edges. Up to 40 % of the largest colour difference
/// (green to blue) take 95 % of the range.
MULTIVERSIONED void makeDifferences(std::array<Features, 2>& features,
                                    const std::array<Colours, 2>& lab, float largest) {
  constexpr float knee = 0.4F;
  constexpr float kneeValue = 0.95F;
  constexpr float above = (1 - kneeValue) / (1 - knee);
  const float scale = 1 / largest;
  constexpr auto perSqrt2 = float(1 / std::numbers::sqrt2);
  float* const edges = features[0].edges.data();
  const float* const otherEdges = features[1].edges.data();
  const float* const points = features[0].points.data();
  const float* const otherPoints = features[1].points.data();
  std::array<const float*, 6> labs{};
  for (std::size_t k = 0; k < labs.size(); ++k) labs[k] = lab[k / 3][k % 3].data();
  for (std::size_t first = 0; first < features[0].edges.size(); first += block) {
    std::array<float, block> flip;  // of its own, so that the compiler knows what it overlaps
    for (std::size_t i = 0; i < block; ++i) {
      const std::size_t p = first + i;
      const float a = labs[1][p] - labs[4][p];
      const float b = labs[2][p] - labs[5][p];
      const float hyAb = std::abs(labs[0][p] - labs[3][p]) + std::sqrt(a * a + b * b);
      const float share = powerOf(hyAb, hyAbExponent) * scale;
      const float colour =
          share < knee ? share * (kneeValue / knee) : kneeValue + (share - knee) * above;
      const float feature =
          std::max(std::abs(edges[p] - otherEdges[p]), std::abs(points[p] - otherPoints[p]));
      flip[i] = powerOf(colour, std::max(1 - std::sqrt(feature * perSqrt2), 0.0F));
    }
    std::copy_n(flip.begin(), block, edges + first);
  }
}

/// Returns FLIP of each pixel.
Plane differenceMap(const plugin::View& reference, const plugin::View& test, const Size& size,
                    double perDegree) {
  static const double largest =
      std::pow(hyAb(huntLabOf({0, 1, 0}), huntLabOf({0, 0, 1})), double(hyAbExponent));
  std::array<Features, 2> features;
  std::array<Colours, 2> colours;
  for (std::size_t k = 0; k < 2; ++k) {
    const Colours opponent = opponentPlanes(k == 0 ? reference : test, size);
    Plane luminance = opponent[0];
    for (float& value : luminance) value = (value + 16) / 116;
    features[k] = featuresOf(luminance, size, perDegree);
    colours[k] = perceived(opponent, size, perDegree);
  }
  makeDifferences(features, colours, float(largest));
  return std::move(features[0].edges);
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
    const Size size{std::size_t(reference.width), std::size_t(reference.height)};
    const Plane map = differenceMap(reference, test, size, perDegree);
    double frame = 0, seen = 0;
    std::size_t count = 0;
    for (std::size_t y = 0, p = 0; y < size.height; ++y)
      for (std::size_t x = 0; x < size.width; ++x, ++p) {
        const double value = map[y * size.stride() + x];
        frame += value;
        if (reference.seen.empty() || (reference.seen[p] & test.seen[p]) == 0) continue;
        seen += value;
        ++count;
      }
    figures.frame = frame / double(size.width * size.height);
    if (count > 0) figures.seen = seen / double(count);
    return figures;
  }
};

plugin::Metric* makeFlip() {
  return new Flip;
}

}  // namespace

HOGELSCOPE_PLUGIN("flip", "1.0", nullptr, nullptr, makeFlip);
