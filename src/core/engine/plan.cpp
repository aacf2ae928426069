// SPDX-License-Identifier: BSD-3-Clause
#include "core/engine/plan.h"

#include <algorithm>
#include <numeric>

#include "core/optics/field_leakage.h"
#include "core/panel/twin.h"

namespace hogelscope {

namespace {

/// Returns the sum of the window's weights, of which the middle one is 1.
double weightWithin(const PsfParams& psf, int reach) {
  const std::vector<double> weights = gaussianWeights(psf.sigma, reach);
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  return sum * sum;
}

int neededReach(const PsfParams& psf, double dropped) {
  int reach = (psf.windowSize - 1) / 2;
  while (reach > 0 && leakageLoss(psf, reach - 1) < dropped) --reach;
  return reach;
}

/// Whether no point of the aperture is in front of the panel.
bool isBehind(const Aperture& aperture, const CameraState& state, const Display& display) {
  const RigidTransform camera = Camera(state.camera, state.intrinsics).worldFromCamera();
  return std::ranges::none_of(aperture.points, [&](const AperturePoint& point) {
    return display.displayFromWorld().point(fromPoint(camera, point).origin).z > 0;
  });
}

}  // namespace

LensKey lensKeyOf(const CameraState& state, const SamplingParams& sampling, const Method& method) {
  return lensKeyOf(Camera(state.camera, state.intrinsics), state, sampling, method);
}

LensKey lensKeyOf(const Camera& camera, const CameraState& state, const SamplingParams& sampling,
                  const Method& method) {
  return {state.distortion, sampling.mapping,         state.camera.res, camera.focalLength(),
          camera.centre(),  sampling.samplesPerPixel, method.lens,      method.lensSteps};
}

/// The middle tap always lies inside the hogel, so the weights that are left add up to 1 or more,
/// and leaving out taps of weight d changes their mean by at most 2·d of its range: 2·255·d code
/// values, times 12.92 where linear light is summed, since encoding is that steep at black.
double leakageLoss(const PsfParams& psf, int reach) {
  const double steepest = psf.light == LightModel::linear ? 12.92 : 1;
  return 2 * 255 * steepest *
         (weightWithin(psf, (psf.windowSize - 1) / 2) - weightWithin(psf, reach));
}

Plan plan(const RenderJob& job) {
  return plan(job, Display(job.display, job.twin));
}

Plan plan(const RenderJob& job, const Display& display) {
  const SamplingParams& sampling = job.sampling;
  const PsfParams& psf = job.state.psf;
  Plan plan;
  plan.aperture = apertureOf(job.state.pupil, job.state.camera, job.display, job.method.aperture);
  const bool isPinhole = plan.aperture.isPinhole;
  plan.hasLens = !Distortion(job.state.distortion).isIdentity();
  plan.isTableKept =
      plan.hasLens &&
      LensTable::bytes(job.state.camera.res, sampling.samplesPerPixel) <= LensTables::largestBytes;
  plan.hasLinearHogels = display.lens(0).isLinear() && display.lens(1).isLinear();
  plan.isBehind = isBehind(plan.aperture, job.state, display);
  const DisplayTraits& traits = display.traits();
  plan.movesRays = traits.movesRays;
  plan.splitsColours = traits.splitsColours;
  plan.changesLight = traits.changesLight;
  plan.drivesTexels = traits.drivesTexels;
  plan.knowsOutline = !plan.hasLens && !plan.movesRays && isPinhole &&
                      sampling.samplesPerPixel == 1 && plan.hasLinearHogels && !plan.isBehind;
  plan.psfReach = psf.windowSize > 1 ? neededReach(psf, job.method.droppedTaps) : 0;
  plan.leaksOverField = FieldLeakage::isNeeded(job.twin.get(), psf);
  if (plan.leaksOverField) plan.psfReach = FieldLeakage(*job.twin, psf).reach();
  plan.sumsTexels = plan.psfReach > 0 || sampling.samplesPerPixel > 1 || plan.changesLight ||
                    plan.drivesTexels || plan.splitsColours || plan.leaksOverField ||
                    sampling.reconstruction != Reconstruction::nearest;
  plan.sumsLinear = plan.sumsTexels && psf.light == LightModel::linear;
  plan.copiesTexels = isPinhole && !plan.sumsTexels &&
                      job.lightField->type() == StoredType::uint8 && job.lightField->isInMemory();
  plan.usesStrips = plan.copiesTexels && plan.isTableKept && plan.hasLinearHogels &&
                    !plan.movesRays && !plan.isBehind && !job.method.isSingle;
  plan.spotReach = static_cast<int>(traits.spot.size() / 2);
  plan.copiesPixels = !traits.hasDirections && traits.spot.empty() && isPinhole &&
                      sampling.samplesPerPixel == 1 &&
                      job.lightField->type() == StoredType::uint8 && job.lightField->isInMemory();
  return plan;
}

}  // namespace hogelscope
