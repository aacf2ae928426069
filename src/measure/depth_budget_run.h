// SPDX-License-Identifier: BSD-3-Clause
// --depth: does a session's content fit its display, and where would it? As a table and a document;
// the chart is in chart/depth_budget_chart.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/optics/image.h"
#include "io/scene/view_source.h"
#include "measure/content_depth.h"

namespace hogelscope {

/// The depths of all chosen states, and the first one's picture.
struct StatesDepths {
  std::vector<DepthFigures> states;
  PixelDepths first;  ///< of the first state
  Image picture;      ///< what its eye would see: of a live scene the ideal view
};

/// Another place for the content.
struct DepthProposal {
  Session session;
  StatesDepths depths;
};

struct DepthBudget {
  StatesDepths now;
  std::optional<DepthProposal> proposal;
  std::string obstacle;  ///< why there is no proposal
};

/// Returns the depths of all states, and the first one's picture. Throws InputError (an eye is not
/// in front of the panel; as depthsOf()), Cancelled.
StatesDepths depthsOfStates(const Session& session, const ViewSource& source,
                            const Progress& progress);

/// Returns the session itself if the content fits, or else the one that would show most of a
/// state's content within its limits, without depths; or says in `obstacle` why there is none, such
/// as that no shear of views has more of it there. `display` is resolved.
std::optional<DepthProposal> proposedFit(const Session& session, const PanelParams& display,
                                         const DepthFigures& figures, std::string& obstacle);

/// Measures a session, whose light field `file` is. Limits, interval and proposal are those of the
/// first state: the content is scaled and shifted in depth until the shortest interval that holds
/// `depth.share` of its pixels lies within the lesser limit (docs/formulas.md, Depth budget).
/// Content of a live scene that has `position` and `scale` moves about the panel's centre. Views
/// are shifted alone, by the `shear` that has most of their pixels within the lesser limit. What
/// has no more of them there than now is not proposed. Throws InputError (no state sees content
/// whose depth is known), Cancelled.
DepthBudget measureDepths(const Session& session, LightFieldFile& file, const SourceUse& use,
                          const Progress& progress);

/// Returns the place in words: "scale 0.77, position [0, 0, -0.08] m" or "shear [2, 2] px/view".
std::string placeText(const DepthProposal& proposal);

/// Returns "depth.csv": a row for each bar of each state's depthBars() that has content now or as
/// proposed.
std::string csv(const DepthBudget& budget);

/// Returns "depth.json".
std::string json(const DepthBudget& budget);

}  // namespace hogelscope
