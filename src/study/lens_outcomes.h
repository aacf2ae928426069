// SPDX-License-Identifier: BSD-3-Clause
// The outcome of a lens' points under each method to invert it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/parallel.h"
#include "core/lens/lens_rays.h"
#include "study/inverse_methods.h"

namespace hogelscope {

/// The outcome of a point, in the order of harm. A root is an ideal point whose distorted point is
/// within a thousandth of a pixel of the wanted one.
enum class Outcome : std::uint8_t {
  right,     ///< the root on the branch that grows from the centre, within a pixel
  noRay,     ///< there is none, and the method says so
  inexact,   ///< not a root, but nearer to one than where the method began
  diverged,  ///< not a root and no nearer, NaN, or "no ray" where there is one
  wrongRoot  ///< another root, or a root where there is no ray: nothing warns of it
};

constexpr std::size_t outcomeCount = 5;
/// Returns the names in the CSV: right, no_ray, inexact, diverged, wrong_root.
const std::array<std::string, outcomeCount>& outcomeNames();

struct LensOutcomes {
  std::array<std::size_t, outcomeCount> count{};
  std::vector<Outcome> each;  ///< of all points, row by row
  double worstResidual = 0;   ///< px, over all points that the method returned; infinite for NaN
  [[nodiscard]] std::size_t operator[](Outcome o) const { return count[std::size_t(o)]; }
  [[nodiscard]] std::size_t points() const;
  /// Returns the most harmful outcome that occurs.
  [[nodiscard]] Outcome worst() const;
};

/// A camera by its lens, and the points of the plane z = 1 under a regular grid of its pixels,
/// corners included, with each point's right root by the certified inverse.
class LensTrial {
 public:
  /// `progress` is called before each point, here and by outcomes(). Throws Cancelled.
  LensTrial(const LensKey& lens, int columns, int rows, Progress progress = {});

  [[nodiscard]] LensOutcomes outcomes(const InverseMethod& method) const;

 private:
  [[nodiscard]] Outcome outcome(std::size_t at, const Vec2& ideal, bool saysNoRay) const;
  [[nodiscard]] double pixels(const Vec2& from, const Vec2& to) const;

  LensKey m_lens;
  Progress m_progress;
  std::vector<Vec2> m_distorted;
  std::vector<std::optional<Vec2>> m_right;
};

}  // namespace hogelscope
