// SPDX-License-Identifier: BSD-3-Clause
// The point spread function: a directional pixel's light leaks into the directions around it.
#pragma once

#include <vector>

#include "core/base/parameters.h"
#include "core/light_field/light_field_source.h"
#include "core/panel/twin_params.h"

namespace hogelscope {

enum class PsfBorder { renormalise, clamp, black };
enum class LightModel { encoded, linear };

/// A state's `psf`. `sigma` is in directional pixels; `windowSize` is the odd full width, 1 = none.
struct PsfParams {
  double sigma = 0.67;
  int windowSize = 1;
  PsfBorder border = PsfBorder::renormalise;
  LightModel light = LightModel::encoded;
  bool operator==(const PsfParams&) const = default;
};

void describe(ParameterVisitor& v, PsfParams& p);

/// Return sigma after steps of 0.05 px, and the window's size after steps of 2 px, both in their
/// ranges; a sigma that would become 0, which is no Gaussian, stays.
double steppedSigma(double sigma, int steps);
int steppedWindow(int windowSize, int steps);

/// Returns the fraction of the Gaussian's energy in the window: erf(windowSize / (2√2 σ))²; 1 for
/// windowSize 1.
double energyInWindow(const PsfParams& params);
/// Whether the window cuts off more than 1 % of the energy.
bool cutsTooMuch(const PsfParams& params);

/// Returns exp(-x²/2σ²) for x = -reach … reach; 1 if reach is 0.
std::vector<double> gaussianWeights(double sigma, int reach);

/// Returns the window's weights, row by row, as fractions of their sum. `params.sigma` must be
/// above 0 if windowSize > 1.
std::vector<double> psfKernel(const PsfParams& params);

/// Returns the number of directional pixels that contribute to direction (u, v) of a hogel.
int tapsAt(const PsfParams& params, const LightFieldSize& size, int u, int v);

/// Apply the sRGB transfer function (IEC 61966-2-1), code values to linear 0 … 1, and its inverse.
double linearFromEncoded(double codeValue);
double encodedFromLinear(double linear);
/// Returns the linear light 0 … 1 of a code value on a panel with its own bits and transfer
/// function.
double panelLight(const LightErrors& panel, double codeValue);
/// Returns the luminance of linear light (ITU-R BT.709).
double luminance(const Rgb& linear);
/// Apply the same to three channels; `encoded` light is returned unchanged.
Rgb decoded(LightModel light, const Rgb& codeValues);
Rgb encoded(LightModel light, const Rgb& summed);

class Psf {
 public:
  /// `params.sigma` must be above 0 if windowSize > 1.
  explicit Psf(const PsfParams& params);

  /// Returns P'(u, v) of docs/formulas.md, Light leakage, for one directional pixel, in the light
  /// that is summed: code values, or linear 0 … 1, to be passed to encoded().
  [[nodiscard]] Rgb leaked(const LightFieldSource& lightField, const TexelIndex& at) const;
  /// Returns W(x, y), windowSize² weights, row by row.
  [[nodiscard]] const std::vector<double>& weights() const { return m_weights; }

 private:
  [[nodiscard]] double weight(int x, int y) const;

  PsfParams m_params;
  int m_reach;  ///< n = (windowSize - 1) / 2
  std::vector<double> m_weights;
};

}  // namespace hogelscope
