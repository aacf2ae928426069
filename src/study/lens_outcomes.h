// SPDX-License-Identifier: BSD-3-Clause
// What becomes of a lens' points under each way to invert it.
#pragma once

#include <array>

#include "core/base/parallel.h"
#include "core/lens/lens_rays.h"
#include "study/inverse_methods.h"

namespace hogelscope {

/// In the order of harm. A root is an ideal point whose distorted place is within a thousandth of a
/// pixel of the one asked for.
enum class Outcome {
  right,     ///< the root on the branch that grows from the centre, within a pixel
  noRay,     ///< there is none, and the method says so
  inexact,   ///< not a root, but nearer to one than where the method began
  diverged,  ///< not a root and no nearer, not a number, or "no ray" where there is one
  wrongRoot  ///< another root, or a root where there is no ray: nothing warns of it
};

constexpr std::size_t outcomeCount = 5;
/// As in the CSV: right, no_ray, inexact, diverged, wrong_root.
const std::array<std::string, outcomeCount>& outcomeNames();

struct LensOutcomes {
  std::array<std::size_t, outcomeCount> count{};
  double worstResidual = 0;  ///< px, over all points that the method gave; infinite: not a number
  [[nodiscard]] std::size_t operator[](Outcome o) const { return count[std::size_t(o)]; }
  [[nodiscard]] std::size_t points() const;
  /// The most harmful one that occurs.
  [[nodiscard]] Outcome worst() const;
};

/// A camera by its lens, and the points of the plane z = 1 under a regular grid of its pixels,
/// corners included. Keeps each point's right root, by the certified inverse.
class LensTrial {
 public:
  /// `progress` is asked before each point, here and by outcomes(). Throws Cancelled.
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
