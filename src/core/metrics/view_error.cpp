// SPDX-License-Identifier: BSD-3-Clause
#include "core/metrics/view_error.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "core/base/text.h"
#include "core/metrics/panel_error_figures.h"
#include "core/metrics/squared_error.h"
#include "core/metrics/statistics.h"

namespace hogelscope {

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

template <class T>
constexpr double codeValue(T value) {
  if constexpr (std::is_same_v<T, std::uint8_t>) return value;
  if constexpr (std::is_same_v<T, std::uint16_t>) return value / 257.0;
  if constexpr (std::is_same_v<T, float>) return 255.0 * double(value);
}

template <class A, class B>
double squaredDifference(const Texel<A>& a, const Texel<B>& b) {
  const double r = codeValue(a.r) - codeValue(b.r);
  const double g = codeValue(a.g) - codeValue(b.g);
  const double blue = codeValue(a.b) - codeValue(b.b);
  return r * r + g * g + blue * blue;
}

/// Adds hogels (·, j) to the errors of the views (·, v), along u first, as texels lie in memory.
template <class A, class B>
void addHogels(const LightField& reference, const TexelArray<A>& a, const LightField& test,
               const TexelArray<B>& b, int j, int v, double* squares) {
  const auto [nx, ny, du, dv] = reference.size();
  for (int i = 0; i < nx; ++i)
    for (int u = 0; u < du; ++u) {
      const TexelIndex at{i, j, u, v};
      squares[u] +=
          squaredDifference(a[reference.layout().address(at)], b[test.layout().address(at)]);
    }
}

}  // namespace

std::vector<double> viewErrors(const LightField& reference, const LightField& test,
                               const ParallelRows& parallelRows, const Progress& progress) {
  const LightFieldSize size = reference.size();
  if (test.size() != size) throw std::invalid_argument("viewErrors: light fields differ in size");
  std::vector<double> errors(std::size_t(size.du) * std::size_t(size.dv));
  std::atomic<int> rows = 0;
  parallelRows(size.dv, [&](int begin, int end) {
    for (int v = begin; v < end; ++v) {
      double* squares = &errors[std::size_t(v) * std::size_t(size.du)];
      for (int j = 0; j < size.ny; ++j) {
        reportProgress(progress, double(rows++) / (double(size.ny) * size.dv));
        std::visit(
            [&](const auto& a, const auto& b) { addHogels(reference, a, test, b, j, v, squares); },
            reference.texels(), test.texels());
      }
    }
  });
  for (double& error : errors) error /= 3.0 * size.nx * size.ny;
  return errors;
}

ViewAgreement agreementOf(const std::vector<double>& viewErrors, const PanelError& perceived) {
  const std::vector<PanelError::Cell>& cells = perceived.directions();
  if (viewErrors.size() != cells.size())
    throw std::invalid_argument("agreementOf: another number of directions");
  ViewAgreement agreement;
  double sum = 0;
  int finite = 0;
  for (const double error : viewErrors)
    if (const double db = psnr(error); std::isfinite(db)) {
      sum += db;
      ++finite;
    }
  agreement.meanPsnr = sum / finite;  // 0/0 is NaN

  std::vector<std::size_t> seen;
  std::vector<double> own;
  std::vector<double> seenErrors;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const double mean = meanSquare(cells[k], perceived.perCode());
    if (std::isnan(mean) || std::isnan(viewErrors[k])) continue;
    seen.push_back(k);
    own.push_back(viewErrors[k]);
    seenErrors.push_back(mean);
  }
  agreement.seen = int(seen.size());
  agreement.rankCorrelation = rankCorrelation(own, seenErrors);
  agreement.rankDifferences.assign(cells.size(), notANumber);
  const std::vector<double> ownRanks = ranksOf(own);
  const std::vector<double> seenRanks = ranksOf(seenErrors);
  double most = 0;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    const double difference = (seenRanks[k] - ownRanks[k]) / double(seen.size());
    agreement.rankDifferences[seen[k]] = difference;
    if (difference <= most) continue;
    most = difference;
    const int du = perceived.size().du;
    agreement.underrated = {int(seen[k]) % du, int(seen[k]) / du};
  }
  return agreement;
}

std::string agreementText(const ViewAgreement& agreement) {
  std::string text =
      "Mean PSNR of the light field's own views: " + rounded(agreement.meanPsnr, 2) + " dB. ";
  if (std::isnan(agreement.rankCorrelation))
    return text + "Too few directions differ for a rank correlation with the perceived error.";
  text += "Over the " + std::to_string(agreement.seen) +
          " directions seen, the rank correlation (Spearman) of a view's own error and the "
          "perceived one is " +
          rounded(agreement.rankCorrelation, 2);
  const auto [u, v] = agreement.underrated;
  if (agreement.rankCorrelation < 1)
    text += "; the perceived error exceeds the view's own rank the most in view (" +
            std::to_string(u) + ", " + std::to_string(v) + ")";
  return text + ".";
}

}  // namespace hogelscope
