// SPDX-License-Identifier: BSD-3-Clause
// --explain: the plan and the lens' certificate in words.
#include "cli/explain.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/plan.h"

namespace hogelscope {

namespace {

std::string certificateText(const LensCertificate& lens) {
  std::array<char, 200> text{};
  std::snprintf(text.data(), text.size(),
                "rays out to r = %.4g (%.4g° off the axis), worst residual %.2g px, %zu of %zu "
                "pixels without a ray",
                lens.validRadius, std::atan(lens.validRadius) / radians(1), lens.worstResidual,
                lens.withoutRay, lens.pixels);
  return text.data();
}

}  // namespace

std::string explanation(const View& view) {
  const Plan made = plan(view);
  std::string text = view.state.camera.name + "\n";
  for (const auto& [what, why] : made.decisions)
    text.append("  ").append(what).append(": ").append(why).append("\n");
  if (made.isTableKept)
    text += "  certificate of the lens: " +
            certificateText(LensTable(lensKeyOf(view), serialRows).certificate()) + "\n";
  return text;
}

}  // namespace hogelscope
