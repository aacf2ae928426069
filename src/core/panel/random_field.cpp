// SPDX-License-Identifier: BSD-3-Clause
#include "core/panel/random_field.h"

#include <cmath>
#include <numbers>

namespace hogelscope {

namespace {

/// The finaliser of splitmix64 (Steele, Lea, Flood, OOPSLA 2014).
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31U);
}

/// Uniform in (0, 1).
double uniform(std::uint64_t bits) {
  return (double(bits >> 11U) + 0.5) * 0x1p-53;
}

/// Returns the weights of distances 0, 1, … of a Gaussian along one axis, as parts of √Σw².
std::vector<double> weightsOf(double length) {
  const double s = length / 2;
  const int reach = static_cast<int>(std::ceil(5 * s));
  std::vector<double> weights;
  double squares = 0;
  for (int k = 0; k <= reach; ++k) {
    weights.push_back(std::exp(-k * k / (2 * s * s)));
    squares += (k == 0 ? 1 : 2) * weights.back() * weights.back();
  }
  for (double& weight : weights) weight /= std::sqrt(squares);
  return weights;
}

/// Filters `count` values of a line that begins `weights.size() - 1` before them.
void filterLine(const double* line, std::size_t step, int count, const std::vector<double>& weights,
                double* filtered) {
  const std::size_t reach = weights.size() - 1;
  for (std::size_t k = 0; k < std::size_t(count); ++k) {
    double sum = weights[0] * line[(k + reach) * step];
    for (std::size_t away = 1; away <= reach; ++away)
      sum += weights[away] * (line[(k + reach - away) * step] + line[(k + reach + away) * step]);
    filtered[k * step] = sum;
  }
}

}  // namespace

/// Box and Muller, Annals of Mathematical Statistics 29, 1958.
double normalAt(std::uint32_t seed, std::uint32_t what, int i, int j) {
  const auto cell = std::uint64_t(std::uint32_t(i)) << 32U | std::uint32_t(j);
  const std::uint64_t first = mixed(mixed(std::uint64_t(seed) << 32U | what) ^ cell);
  return std::sqrt(-2 * std::log(uniform(first))) *
         std::cos(2 * std::numbers::pi * uniform(mixed(first)));
}

std::vector<float> randomField(std::uint32_t seed, std::uint32_t what, double length,
                               const GridPart& part, const Progress& progress) {
  const std::vector<double> weights = length > 0 ? weightsOf(length) : std::vector<double>{1};
  const int reach = static_cast<int>(weights.size()) - 1;
  const auto width = std::size_t(part.width) + 2 * std::size_t(reach);
  const auto height = std::size_t(part.height) + 2 * std::size_t(reach);
  std::vector<double> draws;
  draws.reserve(width * height);
  for (int j = part.j - reach; j < part.j + part.height + reach; ++j) {
    throwIfCancelled(progress);
    for (int i = part.i - reach; i < part.i + part.width + reach; ++i)
      draws.push_back(normalAt(seed, what, i, j));
  }
  std::vector<double> rows(draws.size());
  for (std::size_t j = 0; j < height; ++j) {
    throwIfCancelled(progress);
    filterLine(&draws[j * width], 1, part.width, weights, &rows[j * width]);
  }
  for (std::size_t i = 0; i < std::size_t(part.width); ++i) {
    throwIfCancelled(progress);
    filterLine(&rows[i], width, part.height, weights, &draws[i]);
  }
  std::vector<float> field;
  field.reserve(std::size_t(part.width) * std::size_t(part.height));
  for (int j = 0; j < part.height; ++j)
    for (int i = 0; i < part.width; ++i)
      field.push_back(static_cast<float>(draws[std::size_t(j) * width + std::size_t(i)]));
  return field;
}

}  // namespace hogelscope
