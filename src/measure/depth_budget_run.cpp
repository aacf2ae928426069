// SPDX-License-Identifier: BSD-3-Clause
#include "measure/depth_budget_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/panel/design_numbers.h"
#include "io/json/json_parameters.h"

namespace hogelscope {

namespace {

double distanceOf(const CameraState& state, const PanelParams& display) {
  return Display(display).displayFromWorld().point(state.camera.eye).z;
}

DepthParams paramsOf(DepthParams params, const CameraState& state) {
  if (state.stereo.ipd > 0) params.ipd = state.stereo.ipd;
  if (state.pupil.diameter > 0) params.pupil = state.pupil.diameter;
  return params;
}

/// Moves a live scene's content. Returns false if it has no place or no scale.
bool moveContent(LightFieldParams& lightField, const DepthFit& fit) {
  ContentParams& content = lightField.content;
  const auto* const position = content.find<std::vector<double>>("position");
  const auto* const scale = content.find<std::vector<double>>("scale");
  if (position == nullptr || position->size() != 3 || scale == nullptr || scale->size() != 1)
    return false;
  std::vector<double> place = *position;
  place[2] -= fit.zero;
  for (double& value : place) value *= fit.scale;
  const std::vector<double> size{fit.scale * (*scale)[0]};
  content.set("position", place);
  content.set("scale", size);
  std::array<double, 2>& cut = lightField.live.depth;
  if (cut != LiveParams().depth)
    for (double& depth : cut) depth = fit.scale * (depth - fit.zero);
  return true;
}

/// Depths as a shear moves them, all by the same: z of views whose rays are parallel, z D/(D − z)
/// of those whose cameras stand at the viewing distance D. disparityOf() is proportional to them.
struct ShearedDepths {
  double distance;  ///< D, or notGiven

  [[nodiscard]] double of(double z) const {
    if (distance == notGiven) return z;
    if (std::isinf(z)) return -distance;
    return z < distance ? z * distance / (distance - z) : std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] double depth(double place) const {
    return distance == notGiven ? place : place * distance / (distance + place);
  }
};

/// A plane that a shear moves onto the panel, and the share of the pixels that are within both
/// limits then.
struct MovedPlane {
  double z = 0;
  double share = 0;
};

/// Returns the plane with the largest share; of equal ones that nearest to the panel.
MovedPlane bestPlane(const DepthFigures& figures, const ShearedDepths& sheared) {
  const DepthRange range = figures.limits.inMetres(figures.limits.both());
  const double behind = sheared.of(-range.behind);
  const double front = sheared.of(range.front);
  std::vector<double> places;
  for (const double dioptres : figures.dioptres)
    if (const double place = sheared.of(depthAt(dioptres, figures.limits.distance));
        std::isfinite(place))
      places.push_back(place);
  MovedPlane best;
  double nearest = 0;
  std::size_t first = 0;
  for (std::size_t last = 0; last < places.size(); ++last) {
    while (places[last] - places[first] > front - behind) ++first;
    // All shifts between these two have the pixels from the first to the last one inside.
    const double least = places[last] - front;
    const double most = places[first] - behind;
    const bool areFinite = std::isfinite(least) && std::isfinite(most);
    const double shift = areFinite ? (least + most) / 2 : std::clamp(0.0, least, most);
    const double share = double(last + 1 - first) / double(figures.dioptres.size());
    if (share < best.share || (share == best.share && std::abs(shift) >= std::abs(nearest)))
      continue;
    nearest = shift;
    best = {sheared.depth(shift), share};
  }
  return best;
}

/// Shears views so that the plane z comes to lie on the panel.
void shearViews(LightFieldParams& lightField, const PanelParams& display, double z) {
  const std::array<int, 2> middle{display.directions[0] / 2, display.directions[1] / 2};
  const auto disparity = disparityOf(z, display, middle);
  for (const std::size_t axis : {0, 1})
    if (display.directions[axis] > 1) lightField.shear[axis] -= disparity[axis];
}

std::string notBetter(const DepthFigures& figures) {
  return "no other place has more of the pixels inside both limits than the " +
         rounded(100 * figures.inside, 1) + " % of now";
}

Json jsonOf(const DepthRange& range) {
  Json object = Json::object();
  object["front"] = range.front;
  if (std::isinf(range.behind))
    object["behind"] = nullptr;
  else
    object["behind"] = range.behind;
  return object;
}

Json jsonOf(const DepthFigures& figures) {
  Json object = Json::object();
  const DepthLimits& limits = figures.limits;
  object["state"] = figures.state;
  object["distance"] = limits.distance;
  object["limits"] = jsonOf(limits.inMetres(limits.display));
  object["comfort"] = jsonOf(limits.inMetres(limits.comfort));
  object["directionsPerPupil"] = limits.directionsPerPupil;
  object["known"] = figures.known;
  object["inside"] = {{"display", figures.insideDisplay}, {"both", figures.inside}};
  object["ghosts"] = figures.ghosts;
  object["mismatch"] = limits.mismatchOf(farthestOf(figures));
  if (figures.dioptres.empty())
    object["interval"] = nullptr;
  else
    object["interval"] = {depthAt(figures.interval[0], limits.distance),
                          depthAt(figures.interval[1], limits.distance)};
  return object;
}

Json placeOf(const LightFieldParams& lightField) {
  Json object = Json::object();
  if (lightField.isLive()) {
    object["scale"] = lightField.content.find<std::vector<double>>("scale")->front();
    object["position"] = *lightField.content.find<std::vector<double>>("position");
  } else {
    object["shear"] = lightField.shear;
  }
  return object;
}

}  // namespace

StatesDepths depthsOfStates(const Session& session, const ViewSource& source,
                            const Progress& progress) {
  requireHogels(source.display, "a depth budget");
  StatesDepths result;
  Renderer renderer;
  const double count = double(session.cameras.size()) + 1;
  for (const CameraState& state : session.cameras) {
    const double done = double(result.states.size());
    const double distance = distanceOf(state, source.display);
    if (!(distance > 0))
      throw InputError(state.camera.name, "its eye is not in front of the panel");
    PixelDepths depths = depthsOf(source.job(state), renderer.tables(),
                                  part(progress, done / count, (done + 1) / count));
    const DepthParams ofState = paramsOf(session.depth, state);
    result.states.push_back(depthFigures(state.camera.name, depths,
                                         depthLimits(source.display, distance, ofState),
                                         session.depth.share));
    if (done == 0) result.first = std::move(depths);
  }
  RenderJob job = source.job(session.cameras.front());
  job.isIdeal = session.lightField.isLive();
  job.state.psf = {};
  job.state.pupil = {};
  result.picture = renderer.render(job, part(progress, 1 - 1 / count, 1));
  return result;
}

std::optional<DepthProposal> proposedFit(const Session& session, const PanelParams& display,
                                         const DepthFigures& figures, std::string& obstacle) {
  const DepthLimits& limits = figures.limits;
  const std::array<double, 2> interval{depthAt(figures.interval[0], limits.distance),
                                       depthAt(figures.interval[1], limits.distance)};
  const DepthRange range = limits.inMetres(limits.both());
  const bool fits = figures.inside >= session.depth.share;
  const DepthFit fit =
      fits ? DepthFit() : fitDepths(interval[0], interval[1], range.behind, range.front);
  DepthProposal proposal{session, {}};
  LightFieldParams& lightField = proposal.session.lightField;
  const bool endsAtInfinity = std::isinf(interval[0]);
  if (isGridOfViews(lightField.layout)) {
    if (endsAtInfinity && display.viewingDistance == notGiven) {
      obstacle = "content lies infinitely far behind the panel";
      return {};
    }
    if (fits) return proposal;
    const MovedPlane plane = bestPlane(figures, {display.viewingDistance});
    if (plane.share <= figures.inside) {
      obstacle = notBetter(figures);
      return {};
    }
    shearViews(lightField, display, plane.z);
    return proposal;
  }
  if (lightField.isLive() && !endsAtInfinity && moveContent(lightField, fit)) return proposal;
  obstacle = endsAtInfinity ? "content lies infinitely far behind the panel"
             : lightField.isLive()
                 ? "lightField.source \"" + lightField.source + "\" has no position and scale"
                 : "content of this layout cannot be moved: views and mosaic have lightField.shear";
  return {};
}

DepthBudget measureDepths(const Session& session, LightFieldFile& file, const SourceUse& use,
                          const Progress& progress) {
  DepthBudget budget;
  std::optional<ViewSource> source = loadViewSource(session, file, part(progress, 0, 0.2), use);
  budget.now = depthsOfStates(session, *source, part(progress, 0.2, 0.6));
  const DepthFigures& first = budget.now.states.front();
  if (first.dioptres.empty()) throw InputError(first.state, "sees no content whose depth is known");
  budget.proposal = proposedFit(session, source->display, first, budget.obstacle);
  if (!budget.proposal) return budget;
  const Session& moved = budget.proposal->session;
  if (moved == session) {
    budget.proposal->depths = budget.now;
    return budget;
  }
  source.reset();  // of two light fields one is in memory
  budget.proposal->depths = depthsOfStates(
      moved, loadViewSource(moved, part(progress, 0.6, 0.7), use), part(progress, 0.7, 1));
  if (budget.proposal->depths.states.front().inside > first.inside) return budget;
  budget.proposal.reset();  // what is seen from another place may differ from what was expected
  budget.obstacle = notBetter(first);
  return budget;
}

std::string placeText(const DepthProposal& proposal) {
  const LightFieldParams& lightField = proposal.session.lightField;
  const auto list = [](std::span<const double> values) {
    std::string text;
    for (const double value : values)
      text += (text.empty() ? "[" : ", ") + numberText(fourDigits(value));
    return text + "]";
  };
  if (!lightField.isLive()) return "shear " + list(lightField.shear) + " px/view";
  return "scale " +
         numberText(fourDigits(lightField.content.find<std::vector<double>>("scale")->front())) +
         ", position " + list(*lightField.content.find<std::vector<double>>("position")) + " m";
}

std::string csv(const DepthBudget& budget) {
  Table table{{"state", "z", "dioptres", "disparity", "mismatch", "share", "proposed"}};
  for (std::size_t k = 0; k < budget.now.states.size(); ++k) {
    const DepthFigures& now = budget.now.states[k];
    const DepthFigures* const later =
        budget.proposal ? &budget.proposal->depths.states[k] : nullptr;
    const double end = barsEnd(now, later);
    const DepthBars bars = depthBars(now, end);
    const DepthBars proposed = later != nullptr ? depthBars(*later, end) : DepthBars();
    for (std::size_t bar = 0; bar < bars.shares.size(); ++bar) {
      const double dioptres = bars.middle(bar);
      const double share = later != nullptr ? proposed.shares[bar] : 0;
      if (bars.shares[bar] == 0 && share == 0) continue;
      table.push_back({now.state, numberText(depthAt(dioptres, now.limits.distance)),
                       numberText(dioptres), numberText(now.limits.disparityOf(dioptres)),
                       numberText(now.limits.mismatchOf(dioptres)), numberText(bars.shares[bar]),
                       later != nullptr ? numberText(share) : ""});
    }
  }
  return csvText(table);
}

std::string json(const DepthBudget& budget) {
  Json document = jsonOf(budget.now.states.front());
  document["proposal"] = nullptr;
  document["proposed"] = nullptr;
  if (budget.proposal) {
    const DepthFigures& first = budget.proposal->depths.states.front();
    document["proposal"] = placeOf(budget.proposal->session.lightField);
    document["proposed"] = {{"display", first.insideDisplay}, {"both", first.inside}};
  }
  document["states"] = Json::array();
  for (const DepthFigures& figures : budget.now.states)
    document["states"].push_back(jsonOf(figures));
  return formatJson(document);
}

}  // namespace hogelscope
