// SPDX-License-Identifier: BSD-3-Clause
// A first estimate of the lenslets' step from the peaks of an image's spectrum.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>

#include "capture/lenslets/lenslet_search.h"

namespace hogelscope {

namespace {

using std::numbers::pi;

/// A wave in cycles per pixel, along x and y.
using Wave = std::complex<double>;

/// The spectrum of the image's middle, at most 1024×1024 pixels under a Hann window.
class Spectrum {
 public:
  explicit Spectrum(const LensletPlane& picture)
      : m_width(std::min(picture.width, 1024)), m_height(std::min(picture.height, 1024)) {
    const int left = (picture.width - m_width) / 2;
    const int top = (picture.height - m_height) / 2;
    cv::Mat pixels(m_height, m_width, CV_32F);
    for (int y = 0; y < m_height; ++y)
      std::copy_n(picture.values.begin() + std::ptrdiff_t(top + y) * picture.width + left, m_width,
                  pixels.ptr<float>(y));
    pixels -= cv::mean(pixels)[0];
    for (int y = 0; y < m_height; ++y)
      for (int x = 0; x < m_width; ++x)
        pixels.at<float>(y, x) *= float(hann(x, m_width) * hann(y, m_height));
    cv::Mat waves;
    cv::dft(pixels, waves, cv::DFT_COMPLEX_OUTPUT);
    std::array<cv::Mat, 2> parts;
    cv::split(waves, parts.data());
    cv::magnitude(parts[0], parts[1], m_magnitude);
  }

  [[nodiscard]] int width() const { return m_width; }
  [[nodiscard]] int height() const { return m_height; }
  [[nodiscard]] Wave waveOf(double x, double y) const { return {x / m_width, y / m_height}; }
  [[nodiscard]] float at(int x, int y) const {
    return m_magnitude.at<float>((y % m_height + m_height) % m_height,
                                 (x % m_width + m_width) % m_width);
  }
  [[nodiscard]] bool isPeak(int x, int y) const {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (at(x + dx, y + dy) > at(x, y)) return false;
    return at(x, y) > 0;
  }

  /// Returns how far a cell exceeds its surroundings; other content has no sharp peaks.
  [[nodiscard]] double prominence(const std::array<int, 2>& cell) const {
    constexpr int inner = 3;
    constexpr int outer = 6;
    double sum = 0;
    int count = 0;
    for (int dy = -outer; dy <= outer; ++dy)
      for (int dx = -outer; dx <= outer; ++dx) {
        if (std::abs(dx) <= inner && std::abs(dy) <= inner) continue;
        sum += double(at(cell[0] + dx, cell[1] + dy));
        ++count;
      }
    return double(at(cell[0], cell[1])) - 3 * sum / count;
  }

  /// Returns the strongest cell within one cell of a wave.
  [[nodiscard]] std::array<int, 2> cellNear(const Wave& wave) const {
    const int cx = int(std::lround(wave.real() * m_width));
    const int cy = int(std::lround(wave.imag() * m_height));
    std::array<int, 2> best{cx, cy};
    for (int y = cy - 1; y <= cy + 1; ++y)
      for (int x = cx - 1; x <= cx + 1; ++x)
        if (at(x, y) > at(best[0], best[1])) best = {x, y};
    return best;
  }

  /// Returns the place between the cells: the top of a parabola through the logarithms, along x and
  /// y.
  [[nodiscard]] Wave refined(const std::array<int, 2>& cell) const {
    const auto [x, y] = cell;
    return waveOf(x + top(at(x - 1, y), at(x, y), at(x + 1, y)),
                  y + top(at(x, y - 1), at(x, y), at(x, y + 1)));
  }

 private:
  static double hann(int k, int count) { return 0.5 - 0.5 * std::cos(2 * pi * (k + 0.5) / count); }

  static double top(float before, float middle, float after) {
    if (!(before > 0 && middle > 0 && after > 0)) return 0;
    const double a = std::log(before);
    const double b = std::log(middle);
    const double c = std::log(after);
    const double curvature = a - 2 * b + c;
    return curvature < 0 ? std::clamp((a - c) / 2 / curvature, -0.5, 0.5) : 0;
  }

  int m_width;
  int m_height;
  cv::Mat m_magnitude;
};

/// Returns the angle between the waves of a grid, which have equal lengths.
double symmetryOf(LensletGrid grid) {
  return grid == LensletGrid::square ? pi / 2 : pi / 3;
}

/// Returns the step of a row from one of the grid's waves, with the smallest rotation. The waves of
/// a hexagonal grid lie between its rows, and are 2/√3 as long as those of a square one.
PicturePoint stepOf(LensletGrid grid, const Wave& wave) {
  const bool isSquare = grid == LensletGrid::square;
  const double angle = std::arg(wave) - (isSquare ? 0 : pi / 6);
  const double pitch = (isSquare ? 1 : 2 / std::numbers::sqrt3) / std::abs(wave);
  return std::polar(pitch, std::remainder(angle, symmetryOf(grid)));
}

/// Whether a step is near the given figures, and the image is at least three lenslets wide and
/// high.
bool isPossible(const PicturePoint& step, const LensletParams& params, const Spectrum& spectrum) {
  const double pitch = std::abs(step);
  if (pitch < 2.5 || 3 * pitch > std::min(spectrum.width(), spectrum.height())) return false;
  if (params.pitch != notGiven && std::abs(pitch / params.pitch - 1) > 0.05) return false;
  const double given = params.rotation / 180 * pi;
  return params.rotation == notGiven ||
         std::abs(std::remainder(std::arg(step) - given, symmetryOf(params.grid))) < 0.05;
}

}  // namespace

std::optional<PicturePoint> stepFromSpectrum(const LensletPlane& picture,
                                             const LensletParams& params) {
  const Spectrum spectrum(picture);
  const Wave turn = std::polar(1.0, symmetryOf(params.grid));
  const int waves = params.grid == LensletGrid::square ? 2 : 3;
  double best = 0;
  std::optional<PicturePoint> found;
  for (int y = -spectrum.height() / 2; y < spectrum.height() / 2; ++y)
    for (int x = 0; x < spectrum.width() / 2; ++x) {
      if ((x == 0 && y <= 0) || double(spectrum.at(x, y)) <= best || !spectrum.isPeak(x, y))
        continue;
      Wave wave = spectrum.refined({x, y});
      if (!isPossible(stepOf(params.grid, wave), params, spectrum)) continue;
      double weakest = spectrum.prominence({x, y});
      Wave sum = wave;
      Wave back = 1;
      for (int k = 1; k < waves; ++k) {
        wave *= turn;
        back /= turn;
        const auto cell = spectrum.cellNear(wave);
        weakest = std::min(weakest, spectrum.prominence(cell));
        sum += spectrum.refined(cell) * back;
      }
      if (weakest <= best) continue;
      best = weakest;
      found = stepOf(params.grid, sum / double(waves));
    }
  return found;
}

}  // namespace hogelscope
