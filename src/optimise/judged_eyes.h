// SPDX-License-Identifier: BSD-3-Clause
// Measures what optimised content is worth: the views of the states, and of eyes that it was not
// optimised for, before and after, against what they should be.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/engine/renderer.h"
#include "io/scene/view_source.h"

namespace hogelscope {

/// The contents that are compared: the light field as it is; prefiltered, of a live scene alone;
/// optimised.
enum JudgedContent { beforeContent, prefilteredContent, afterContent, judgedContents };

struct ViewScore {
  double psnr = std::numeric_limits<double>::quiet_NaN();  ///< dB, over the seen pixels
  double ssim = psnr;
  double mse = psnr;
};

/// A view's scores against one reference: "display", the own (of a live scene the prefiltered)
/// light on the display as designed and without leakage; "ideal", the ideal view; "views", the
/// state's picture. What the content gives away (GivenAway) is taken from all but the optimised
/// view.
struct JudgedView {
  std::string state;
  bool isHeldOut = false;
  std::string reference;
  std::array<ViewScore, judgedContents> scores;
};

/// The middle of the first state's view, 8-bit RGB row by row.
struct ViewDetail {
  std::string title;
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

struct Judgement {
  std::vector<JudgedView> views;
  std::vector<ViewDetail> details;  ///< what the first state should see, sees before and after
  /// Mean scores of the held-out eyes if the display leaks less than the session says: by
  /// `narrower` times its sigma.
  static constexpr double narrower = 0.8;
  std::array<ViewScore, judgedContents> ifNarrower;
};

/// Returns `count` states with eyes drawn from the box around those of the session's states, which
/// is at least two steps of direction wide across and down. Each looks as a state does.
std::vector<CameraState> heldOutEyes(const Session& session, const PanelParams& display,
                                     const OptimiseParams& params);

/// Returns the distance across between two eyes in neighbouring directions of a hogel, metres, of
/// the mean distance from the panel of the states' eyes; the lesser one across and down.
double stepOfDirections(const Session& session, const PanelParams& display);

/// Returns the mean over the views with this reference: PSNR is that of the mean MSE.
ViewScore meanOf(const std::vector<JudgedView>& views, const std::string& reference, bool isHeldOut,
                 JudgedContent content);

/// Whether the own light of directional pixels is prefiltered: that of a live scene on the display
/// as designed. For a unit it is that of the unit's own middle rays.
inline bool hasPrefilter(const Session& session) {
  return session.lightField.isLive() && session.twin.isZero();
}

/// Returns a session's light field with the prefilter for its directional pixels, of a live scene.
Session prefiltered(Session session);

/// Says what the optimised content gives away; all other views are compared with that taken from
/// them.
struct GivenAway {
  LightModel light = LightModel::encoded;  ///< in which contrast is given away
  std::array<double, 2> lift{};            ///< OptimiseParams::lift
  double dimming = 1;                      ///< of a unit with gains: its dimmest hogel is white
};

/// Judges the light field `optimised` of a session. `pictures` are those of its states for
/// OptimiseTarget::views, else empty. Throws InputError, Cancelled.
Judgement judge(const Session& session, const LightFieldParams& optimised,
                const std::vector<std::filesystem::path>& pictures, const GivenAway& away,
                const Progress& progress);

}  // namespace hogelscope
