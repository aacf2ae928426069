// SPDX-License-Identifier: BSD-3-Clause
// Polynomials of a lens's ideal points: the rays of a row's strips from 12 numbers each, with a
// bound of the error (docs/formulas.md, Strips of a lens).
#pragma once

#include <array>
#include <cstddef>

namespace hogelscope {

/// The ideal points of sixteen strips of 64 pixels of a row, numbered along the rows of an image,
/// as polynomials of a pixel's place in its strip, t = (k - 31.5)/32, the constant first. All are 0
/// for a strip of fewer pixels than terms, or with a pixel that has no ray.
struct LensStrips {
  static constexpr int pixels = 64;
  static constexpr int count = 16;
  static constexpr std::size_t terms = 6;
  using Each = std::array<double, count>;

  std::array<Each, terms> x{};
  std::array<Each, terms> y{};
  Each error{};  ///< no point is farther from them along x or y; infinite without polynomials

  /// Returns how many strips a row has; its last one may be shorter.
  static std::size_t inRow(int width) { return (std::size_t(width) + pixels - 1) / pixels; }
  /// Returns how many of these hold the strips of an image.
  static std::size_t inImage(const std::array<int, 2>& res) {
    return (inRow(res[0]) * std::size_t(res[1]) + count - 1) / count;
  }
};

/// Fits the strips of rows of one width.
class StripFit {
 public:
  explicit StripFit(int width);

  /// Fills the strips of an image's row `row` from its ideal points; NaN: no ray. May be called for
  /// several rows at a time.
  void row(const double* x, const double* y, int row, LensStrips* strips) const;

 private:
  using Polynomial = std::array<double, LensStrips::terms>;

  /// Polynomials through as many of a strip's pixels as they have terms, near Chebyshev's nodes.
  struct Nodes {
    explicit Nodes(int count);
    [[nodiscard]] Polynomial through(const double* points) const;
    int pixels;
    std::array<int, LensStrips::terms> at{};
    std::array<Polynomial, LensStrips::terms> shapes{};  ///< 1 at a node, 0 at the others
  };

  int m_strips;
  Nodes m_whole;
  Nodes m_last;  ///< of the last strip of a row
};

}  // namespace hogelscope
