// SPDX-License-Identifier: BSD-3-Clause
// Compares each directional pixel of a light field with its expected value.
#pragma once

#include <QString>
#include <cmath>
#include <functional>

#include "core/light_field/light_field.h"

using ExpectedTexel = std::function<hogelscope::Rgb(const hogelscope::TexelIndex&)>;

inline bool isNear(const hogelscope::Rgb& a, const hogelscope::Rgb& b, double tolerance) {
  return std::abs(a.r - b.r) <= tolerance && std::abs(a.g - b.g) <= tolerance &&
         std::abs(a.b - b.b) <= tolerance;
}

/// Returns the first wrong texel, or "".
inline QString firstWrong(const hogelscope::LightField& lightField, const ExpectedTexel& expected,
                          double tolerance = 0) {
  const auto& [nx, ny, du, dv] = lightField.size();
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      for (int v = 0; v < dv; ++v)
        for (int u = 0; u < du; ++u) {
          const hogelscope::Rgb is = lightField.texel({i, j, u, v});
          const hogelscope::Rgb should = expected({i, j, u, v});
          if (!isNear(is, should, tolerance))
            return QString("hogel (%1, %2), direction (%3, %4) is (%5, %6, %7), not (%8, %9, %10)")
                .arg(i)
                .arg(j)
                .arg(u)
                .arg(v)
                .arg(is.r)
                .arg(is.g)
                .arg(is.b)
                .arg(should.r)
                .arg(should.g)
                .arg(should.b);
        }
  return {};
}
