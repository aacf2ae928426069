// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/error_map.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <numeric>
#include <stdexcept>

#include "core/base/colour_map.h"

namespace hogelscope {

namespace {

double raised(double share, double gamma) {
  return gamma == 1 ? share : std::pow(share, 1 / gamma);
}

double fullOf(const ErrorMap::Params& params) {
  const double largest = errorOf(params.kind, 0, 255 / params.tone.gain);
  return params.kind == ErrorKind::relative ? 100 / params.tone.gain : largest;
}

/// Returns the gain for the `counts` of the values 0 … 255.
int gainFor(const std::array<std::size_t, 256>& counts) {
  std::size_t above = 0;  // values larger than `largest`
  const std::size_t all = std::accumulate(counts.begin() + 1, counts.end(), std::size_t{0});
  std::size_t largest = 255;
  while (largest > 0 && 1000 * (above + counts[largest]) <= all) above += counts[largest--];
  int gain = 1;
  while (largest > 0 && 2 * gain * static_cast<int>(largest) <= 255) gain *= 2;
  return gain;
}

/// Writes |a − b| in unrounded code values into `rgb`, multiplied by the gain and rounded. Returns
/// the gain.
int writeDeepDifference(const Image& a, const Image& b, std::span<std::uint8_t> rgb) {
  std::vector<double> differences(rgb.size());
  std::vector<double> others(rgb.size());
  readCodeValues(a, 0, differences);
  readCodeValues(b, 0, others);
  std::ranges::transform(differences, others, differences.begin(),
                         [](double p, double q) { return std::abs(p - q); });
  std::vector<double> sorted;
  std::ranges::copy_if(differences, std::back_inserter(sorted), [](double d) { return d > 0; });
  std::ranges::sort(sorted);
  int gain = 1;
  if (!sorted.empty()) {
    const double largest = sorted[sorted.size() - 1 - sorted.size() / 1000];
    while (gain < 65536 && 2 * gain * largest <= 255) gain *= 2;
  }
  std::ranges::transform(differences, rgb.begin(),
                         [gain](double d) { return quantised(gain * d); });
  return gain;
}

}  // namespace

double errorOf(ErrorKind kind, double reference, double test) {
  const double difference = test - reference;
  switch (kind) {
    case ErrorKind::signedError:
      return difference;
    case ErrorKind::squared:
      return difference * difference;
    case ErrorKind::relative:
      return 100 * std::abs(difference) / std::max(reference, 1.0);
    case ErrorKind::absolute:
    case ErrorKind::luma:
      break;
  }
  return std::abs(difference);
}

double pixelError(ErrorKind kind, std::span<const std::uint8_t, 3> reference,
                  std::span<const std::uint8_t, 3> test) {
  if (kind == ErrorKind::luma) {
    constexpr std::array weights{0.2126, 0.7152, 0.0722};
    double difference = 0;
    for (std::size_t k = 0; k < 3; ++k) difference += weights[k] * (test[k] - reference[k]);
    return std::abs(difference);
  }
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += errorOf(kind, reference[k], test[k]);
  return sum / 3;
}

std::array<std::uint8_t, 256> toneTable(const Tone& tone) {
  std::array<std::uint8_t, 256> table{};
  for (std::size_t k = 0; k < table.size(); ++k)
    table[k] = quantised(255 * raised(std::min(tone.gain * double(k) / 255, 1.0), tone.gamma));
  return table;
}

ErrorMap::ErrorMap(const Params& params) : m_params(params), m_full(fullOf(params)) {
  for (std::size_t k = 0; k < m_colours.size(); ++k) {
    const auto grey = static_cast<std::uint8_t>(k);
    m_colours[k] =
        params.hasFalseColour ? falseColour(double(k) / 255) : std::array{grey, grey, grey};
  }
  if (params.hasFalseColour || params.kind == ErrorKind::luma) return;
  m_channels.reserve(std::size_t{256} * 256);
  for (int reference = 0; reference < 256; ++reference)
    for (int test = 0; test < 256; ++test)
      m_channels.push_back(quantised(255 * placeOf(errorOf(params.kind, reference, test))));
}

double ErrorMap::placeOf(double error) const {
  const double share = raised(std::min(std::abs(error) / m_full, 1.0), m_params.tone.gamma);
  if (m_params.kind != ErrorKind::signedError) return share;
  return 0.5 + std::copysign(0.5 * share, error);
}

double ErrorMap::errorAt(double place) const {
  const bool isSigned = m_params.kind == ErrorKind::signedError;
  const double shown = isSigned ? 2 * place - 1 : place;
  return std::copysign(std::pow(std::abs(shown), m_params.tone.gamma) * m_full, shown);
}

std::array<std::uint8_t, 3> ErrorMap::colourAt(double place) const {
  return m_colours[quantised(255 * place)];
}

void ErrorMap::write(std::span<const std::uint8_t> reference, std::span<const std::uint8_t> test,
                     std::span<std::uint8_t> result) const {
  if (!m_channels.empty()) {
    for (std::size_t k = 0; k < result.size(); ++k)
      result[k] = m_channels[256 * std::size_t(reference[k]) + test[k]];
    return;
  }
  for (std::size_t k = 0; k + 2 < result.size(); k += 3)
    std::ranges::copy(colourAt(placeOf(pixelError(m_params.kind, reference.subspan(k).first<3>(),
                                                  test.subspan(k).first<3>()))),
                      result.begin() + std::ptrdiff_t(k));
}

void writeDifference(std::span<const std::uint8_t> a, std::span<const std::uint8_t> b, int gain,
                     std::span<std::uint8_t> result) {
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = static_cast<std::uint8_t>(std::min(gain * std::abs(a[k] - b[k]), 255));
}

DifferenceImage differenceImage(const Image& reference, const Image& test) {
  if (reference.width != test.width || reference.height != test.height)
    throw std::invalid_argument("differenceImage: pictures of different sizes");
  DifferenceImage result{Image(reference.width, reference.height)};
  Image& image = result.image;
  for (std::size_t k = 0; k < image.seen.size(); ++k)
    image.seen[k] = std::min(reference.seen[k], test.seen[k]);
  if (reference.bits > 8 || test.bits > 8) {
    result.gain = writeDeepDifference(reference, test, image.rgb);
    return result;
  }
  writeDifference(reference.rgb, test.rgb, 1, image.rgb);
  std::array<std::size_t, 256> counts{};
  for (const std::uint8_t value : image.rgb) ++counts[value];
  result.gain = gainFor(counts);
  writeDifference(reference.rgb, test.rgb, result.gain, image.rgb);
  return result;
}

}  // namespace hogelscope
