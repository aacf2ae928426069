// SPDX-License-Identifier: BSD-3-Clause
#include "cli/explain.h"

#include <cmath>

#include "core/base/parallel.h"
#include "core/base/text.h"
#include "core/engine/adaptive_method.h"
#include "core/engine/plan_words.h"
#include "core/engine/scaled_view.h"
#include "core/engine/view_rays.h"
#include "core/lens/lens_certificate.h"

namespace hogelscope {

namespace {

std::string millions(double count) {
  return numberText(std::round(count / 1e4) / 100) + " million";
}

/// Returns the number of texels that a ray reads.
int texelsPerRay(const RenderJob& view, const Plan& plan) {
  const int taps = (2 * plan.psfReach + 1) * (2 * plan.psfReach + 1);
  const Reconstruction how = view.sampling.reconstruction;
  return taps * (how == Reconstruction::quadrilinear ? 16
                 : how == Reconstruction::bilinear   ? 4
                                                     : 1);
}

std::string workText(const RenderJob& view, const Plan& plan, const Progress& progress) {
  LensTables tables;
  const ViewRays cast(reduced(view), tables, parallelRows, progress);
  const auto rays = double(cast.count());
  const auto [width, height] = view.state.camera.res;
  const int texels = texelsPerRay(view, plan);
  const std::size_t bytes = memoryBytes(view.lightField->type());
  return numberText(rays) + " rays for " + numberText(double(width) * height) + " pixels, " +
         std::to_string(texels) + " texel" + (texels > 1 ? "s" : "") +
         " each: " + millions(rays * texels) + " texels, " +
         numberText(std::round(rays * texels * double(bytes) / 1e5) / 10) + " MB";
}

std::string explanation(const RenderJob& asked, const Progress& progress) {
  LensTables tables;
  const Choice choice = chooseMethod(asked, tables, parallelRows, progress);
  const RenderJob& job = choice.job;
  const Plan made = plan(reduced(job));
  std::string text = job.state.camera.name + "\n";
  if (choice.pixels > 0)
    text += "  for a tolerance of " + numberText(asked.sampling.tolerance) +
            " code values: " + choiceText(choice) + "\n";
  for (const auto& [what, why, saves] : decisionsOf(reduced(job), made)) {
    text.append("  ").append(what).append(": ").append(why);
    if (!saves.empty()) text.append("; saves ").append(saves);
    text.append("\n");
  }
  text += "  what is read: " + workText(job, made, progress) + "\n";
  if (made.hasLens)
    text += "  the lens: " +
            certificateText(certify(lensKeyOf(job.state, job.sampling), parallelRows, progress)) +
            "\n";
  return text;
}

}  // namespace

std::string explanations(const ViewSource& source, const Session& session,
                         const Progress& progress) {
  std::string text;
  for (const CameraState& state : session.cameras) text += explanation(source.job(state), progress);
  return text;
}

}  // namespace hogelscope
