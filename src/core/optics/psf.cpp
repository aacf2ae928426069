// SPDX-License-Identifier: BSD-3-Clause
// The point spread function, written as the sum in docs/formulas.md, Light leakage.
#include "core/optics/psf.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace hogelscope {

namespace {
constexpr std::array<std::string_view, 3> borderNames{"renormalise", "clamp", "black"};
constexpr std::array<std::string_view, 2> lightNames{"encoded", "linear"};
constexpr Range sigmaRange{0, 20, 0.01, false, 0, 3};
constexpr Range windowRange{1, 99, 2, false, 1, 25};
}  // namespace

void describe(ParameterVisitor& v, PsfParams& p) {
  auto& [sigma, windowSize, border, light] = p;
  v.group("psf", "Light leakage between the directional pixels of a hogel: a Gaussian window.");
  v.field("sigma", sigma, sigmaRange, "px", "Standard deviation; above 0 unless windowSize is 1.");
  v.field("windowSize", windowSize, windowRange, "px",
          "Full width of the window, odd: 1, 3, 5, …; 1 is no leakage.");
  v.field("border", border, borderNames,
          "At the hogel's edge: weigh what is inside, repeat the edge pixel, or lose the light.");
  v.field({"light", "Light is added"}, light, lightNames,
          "Sum the stored values, as the paper does, or sum linear light (decoded from sRGB).");
}

double steppedSigma(double sigma, int steps) {
  constexpr double step = 0.05;
  constexpr double rounding = 1e9;  // keeps sums of steps short in the document
  const double wanted = std::round((sigma + steps * step) * rounding) / rounding;
  return wanted > sigmaRange.min ? std::min(wanted, sigmaRange.max) : sigma;
}

int steppedWindow(int windowSize, int steps) {
  return int(std::clamp(windowSize + steps * windowRange.step, windowRange.min, windowRange.max));
}

double energyInWindow(const PsfParams& params) {
  if (params.windowSize == 1) return 1;
  const double axis = std::erf(params.windowSize / (2 * std::numbers::sqrt2 * params.sigma));
  return axis * axis;
}

int tapsAt(const PsfParams& params, const LightFieldSize& size, int u, int v) {
  const int reach = (params.windowSize - 1) / 2;
  const auto along = [&](int at, int count) {
    return std::min(at + reach, count - 1) - std::max(at - reach, 0) + 1;
  };
  return along(u, size.du) * along(v, size.dv);
}

bool cutsTooMuch(const PsfParams& params) {
  return energyInWindow(params) < 0.99;
}

std::vector<double> gaussianWeights(double sigma, int reach) {
  std::vector<double> weights;
  for (int x = -reach; x <= reach; ++x) {
    const double s = reach > 0 ? x / sigma : 0;
    weights.push_back(std::exp(-s * s / 2));
  }
  return weights;
}

std::vector<double> psfKernel(const PsfParams& params) {
  std::vector<double> weights = Psf(params).weights();
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
  return weights;
}

double linearFromEncoded(double codeValue) {
  const double s = codeValue / 255;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

double encodedFromLinear(double linear) {
  const double s = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return 255 * s;
}

double panelLight(const LightErrors& panel, double codeValue) {
  double code = codeValue / 255;
  if (panel.bits > 0) {
    const double most = (1 << panel.bits) - 1;
    code = std::floor(std::clamp(code, 0.0, 1.0) * most + 0.5) / most;
  }
  switch (panel.eotf) {
    case Eotf::gamma22:
      return std::pow(std::max(code, 0.0), 2.2);
    case Eotf::gamma24:
      return std::pow(std::max(code, 0.0), 2.4);
    case Eotf::linear:
      return code;
    default:
      return linearFromEncoded(255 * code);
  }
}

double luminance(const Rgb& linear) {
  return 0.2126 * linear.r + 0.7152 * linear.g + 0.0722 * linear.b;
}

Rgb decoded(LightModel light, const Rgb& c) {
  if (light == LightModel::encoded) return c;
  return {linearFromEncoded(c.r), linearFromEncoded(c.g), linearFromEncoded(c.b)};
}

Rgb encoded(LightModel light, const Rgb& c) {
  if (light == LightModel::encoded) return c;
  return {encodedFromLinear(c.r), encodedFromLinear(c.g), encodedFromLinear(c.b)};
}

Psf::Psf(const PsfParams& params) : m_params(params), m_reach((params.windowSize - 1) / 2) {
  for (int y = -m_reach; y <= m_reach; ++y)
    for (int x = -m_reach; x <= m_reach; ++x) m_weights.push_back(weight(x, y));
}

/// Returns W(x, y). It squares after the division, so that a tiny sigma gives 0 and not NaN.
double Psf::weight(int x, int y) const {
  if (m_reach == 0) return 1;
  const double sx = x / m_params.sigma;
  const double sy = y / m_params.sigma;
  return std::exp(-(sx * sx + sy * sy) / 2);
}

Rgb Psf::leaked(const LightFieldSource& lightField, const TexelIndex& at) const {
  const auto [nx, ny, du, dv] = lightField.size();
  Rgb sum;
  double total = 0;
  auto w = m_weights.begin();
  for (int y = -m_reach; y <= m_reach; ++y) {
    for (int x = -m_reach; x <= m_reach; ++x, ++w) {
      TexelIndex tap{at.i, at.j, at.u + x, at.v + y};
      if (m_params.border == PsfBorder::clamp) {
        tap.u = std::clamp(tap.u, 0, du - 1);
        tap.v = std::clamp(tap.v, 0, dv - 1);
      }
      const bool inside = tap.u >= 0 && tap.u < du && tap.v >= 0 && tap.v < dv;
      if (inside) sum = sum + *w * decoded(m_params.light, lightField.texel(tap));
      if (inside || m_params.border == PsfBorder::black) total += *w;
    }
  }
  return {sum.r / total, sum.g / total, sum.b / total};
}

}  // namespace hogelscope
