// SPDX-License-Identifier: BSD-3-Clause
#include "optimise/judged_eyes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "core/metrics/metric.h"
#include "core/panel/design_numbers.h"
#include "io/images/image_file.h"
#include "runs/state_images.h"

namespace hogelscope {

namespace {

/// Returns a picture in code values.
Image readPicture(const std::filesystem::path& path, const std::vector<std::uint8_t>& seen,
                  const Progress& progress) {
  ImageFile file(path);
  FloatImage image(int(file.width()), int(file.height()));
  image.seen = seen;
  file.readRows(
      [&](std::size_t y, const float* rgb) {
        const std::size_t count = 3 * file.width();
        std::transform(rgb, rgb + count, &image.rgb[y * count],
                       [](float value) { return 255 * value; });
      },
      progress);
  return rounded(std::move(image), 8, true);
}

/// Takes from a view with its unrounded values the contrast that the optimised content gives away.
Image lifted(const Image& image, const std::array<double, 2>& lift, LightModel light) {
  const auto [black, white] = lift;
  if (black == 0 && white == 0) return image;
  FloatImage result(image.width, image.height);
  result.seen = image.seen;
  const bool isLinear = light == LightModel::linear;
  for (std::size_t k = 0; k < image.unrounded.size(); ++k) {
    const auto code = double(image.unrounded[k]);
    const double part = isLinear ? linearFromEncoded(code) : code / 255;
    const double less = black + (1 - black - white) * part;
    result.rgb[k] = float(isLinear ? encodedFromLinear(less) : 255 * less);
  }
  return rounded(std::move(result));
}

/// The states that are judged, and the same with what the display may be in truth.
struct JudgedStates {
  std::vector<CameraState> shown;           ///< those of the session, then the held-out eyes
  std::vector<CameraState> withoutLeakage;  ///< the same without leakage
  std::vector<CameraState> narrower;        ///< the held-out eyes with less leakage
};

JudgedStates judgedStates(const Session& session, const PanelParams& display) {
  JudgedStates states{session.cameras, {}, {}};
  for (CameraState& eye : heldOutEyes(session, display, session.optimise)) {
    states.shown.push_back(eye);
    eye.psf.sigma *= Judgement::narrower;
    states.narrower.push_back(std::move(eye));
  }
  states.withoutLeakage = states.shown;
  for (CameraState& state : states.withoutLeakage) state.psf.windowSize = 1;
  return states;
}

/// The views of a light field for some states, also of one that must be streamed.
class JudgedViews {
 public:
  /// `session` says what is shown; without its twin the display is as designed.
  JudgedViews(Session session, const std::vector<CameraState>& states, const Progress& progress)
      : m_file(openLightField(session.lightField, session.display, progress)),
        m_images(unloadedViewSource(session, *m_file, progress), *m_file, states,
                 {.use = {.memory = allowedMemory() / 2}, .keepsUnrounded = true}, progress) {}

  [[nodiscard]] Image image(std::size_t state, Renderer& renderer) const {
    return m_images.render(state, renderer, {});
  }
  [[nodiscard]] Image ideal(std::size_t state, Renderer& renderer) const {
    RenderJob job = m_images.job(state);
    job.isIdeal = true;
    job.keepsUnrounded = true;
    return renderer.render(job);
  }

 private:
  std::unique_ptr<LightFieldFile> m_file;
  StateImages m_images;
};

ViewScore scoreOf(const Image& reference, const Image& test) {
  static const MetricSet metrics;
  const std::vector<double> values = metrics.compare(reference, test, parallelRows);
  return {values[psnrSeenColumn], values[ssimSeenColumn], values[mseSeenColumn]};
}

/// Returns the middle of an image.
ViewDetail detailOf(const std::string& title, const Image& image) {
  constexpr int most = 320;
  ViewDetail detail{title, std::min(image.width, most), std::min(image.height, most), {}};
  const int x0 = (image.width - detail.width) / 2, y0 = (image.height - detail.height) / 2;
  for (int y = 0; y < detail.height; ++y) {
    const auto from =
        image.rgb.begin() + 3 * (std::ptrdiff_t(y0 + y) * image.width + std::ptrdiff_t(x0));
    detail.rgb.insert(detail.rgb.end(), from, from + 3 * std::ptrdiff_t(detail.width));
  }
  return detail;
}

/// Returns a number from 0 to below 1 that is the same on all machines.
double drawn(std::mt19937_64& engine) {
  return double(engine() >> 11) * 0x1p-53;
}

Vec3 inDisplay(const Vec3& eye, const PanelParams& display) {
  return Display(display).displayFromWorld().point(eye);
}

/// Returns the mean over scores: PSNR of the mean MSE, since some views are seen better.
ViewScore meanOf(const std::vector<ViewScore>& scores) {
  ViewScore sum{0, 0, 0};
  double count = 0;
  for (const ViewScore& one : scores) {
    if (std::isnan(one.mse)) continue;
    sum.mse += one.mse;
    sum.ssim += one.ssim;
    ++count;
  }
  if (count == 0) return {};
  const double mse = sum.mse / count;
  return {10 * std::log10(255.0 * 255.0 / mse), sum.ssim / count, mse};
}

}  // namespace

double stepOfDirections(const Session& session, const PanelParams& display) {
  double distance = 0;
  for (const CameraState& state : session.cameras)
    distance += inDisplay(state.camera.eye, display).z / double(session.cameras.size());
  const DesignNumbers numbers = designNumbers(display, session.cameras.front().camera.eye);
  double step = 0;
  for (const std::size_t axis : {0, 1})
    if (display.directions[axis] > 1 && (step == 0 || numbers.slopeStep[axis] < step))
      step = numbers.slopeStep[axis];
  return step * distance;
}

std::vector<CameraState> heldOutEyes(const Session& session, const PanelParams& display,
                                     const OptimiseParams& params) {
  std::array<Vec3, 2> box{inDisplay(session.cameras.front().camera.eye, display), {}};
  box[1] = box[0];
  for (const CameraState& state : session.cameras) {
    const Vec3 eye = inDisplay(state.camera.eye, display);
    box[0] = {std::min(box[0].x, eye.x), std::min(box[0].y, eye.y), std::min(box[0].z, eye.z)};
    box[1] = {std::max(box[1].x, eye.x), std::max(box[1].y, eye.y), std::max(box[1].z, eye.z)};
  }
  const double step = stepOfDirections(session, display);
  const auto widen = [&](double& least, double& most) {
    const double missing = std::max(0.0, 2 * step - (most - least));
    least -= missing / 2;
    most += missing / 2;
  };
  widen(box[0].x, box[1].x);
  widen(box[0].y, box[1].y);
  const RigidTransform worldFromDisplay = Display(display).displayFromWorld().inverse();
  std::mt19937_64 engine(std::uint64_t(params.seed));
  std::vector<CameraState> eyes;
  for (int k = 0; k < params.heldOut; ++k) {
    const auto between = [&](double least, double most) {
      return least + (most - least) * drawn(engine);
    };
    Vec3 eye;
    eye.x = between(box[0].x, box[1].x);
    eye.y = between(box[0].y, box[1].y);
    eye.z = between(box[0].z, box[1].z);
    CameraState state = session.cameras[std::size_t(k) % session.cameras.size()];
    state.camera.name = "held-out " + std::to_string(k + 1);
    state.camera.eye = worldFromDisplay.point(eye);
    eyes.push_back(std::move(state));
  }
  return eyes;
}

ViewScore meanOf(const std::vector<JudgedView>& views, const std::string& reference, bool isHeldOut,
                 JudgedContent content) {
  std::vector<ViewScore> scores;
  for (const JudgedView& view : views)
    if (view.reference == reference && view.isHeldOut == isHeldOut)
      scores.push_back(view.scores[content]);
  return meanOf(scores);
}

Session prefiltered(Session session) {
  session.lightField.live.samples = session.optimise.samples;
  session.lightField.live.fill = {1, 1};
  return session;
}

Judgement judge(const Session& session, const LightFieldParams& optimised,
                const std::vector<std::filesystem::path>& pictures, const Progress& progress) {
  const JudgedStates states = judgedStates(session, displayOf(session));
  std::vector<CameraState> all = states.shown;
  std::ranges::copy(states.narrower, std::back_inserter(all));
  const bool isLive = session.lightField.isLive();
  const Session own = isLive ? prefiltered(session) : session;
  Session designed = own, after = session;
  designed.twin = {};
  after.lightField = optimised;
  const JudgedViews references(designed, states.withoutLeakage, part(progress, 0, 0.1));
  std::array<std::optional<JudgedViews>, judgedContents> contents;
  contents[beforeContent].emplace(session, all, part(progress, 0.1, 0.2));
  if (isLive) contents[prefilteredContent].emplace(own, all, part(progress, 0.2, 0.3));
  contents[afterContent].emplace(after, all, part(progress, 0.3, 0.4));
  Renderer renderer;
  const auto lift = [&](const Image& image, std::size_t state) {
    return lifted(image, session.optimise.lift, all[state].psf.light);
  };
  const auto shown = [&](std::size_t content, std::size_t state) {
    const Image image = contents[content]->image(state, renderer);
    return content == afterContent ? image : lift(image, state);
  };

  Judgement result;
  std::array<std::vector<ViewScore>, judgedContents> narrower;
  const std::size_t heldOut = session.cameras.size();
  for (std::size_t k = 0; k < states.shown.size(); ++k) {
    reportProgress(progress, 0.4 + 0.6 * double(k) / double(states.shown.size()));
    std::array<Image, judgedContents> images;
    for (std::size_t content = 0; content < judgedContents; ++content)
      if (contents[content]) images[content] = shown(content, k);
    std::vector<std::pair<std::string, Image>> wanted{
        {"display", lift(references.image(k, renderer), k)}};
    if (isLive) wanted.emplace_back("ideal", lift(references.ideal(k, renderer), k));
    if (k < pictures.size())
      wanted.emplace_back("views",
                          lift(readPicture(pictures[k], images[afterContent].seen, progress), k));
    for (const auto& [name, reference] : wanted) {
      JudgedView view{states.shown[k].camera.name, k >= heldOut, name, {}};
      for (std::size_t content = 0; content < judgedContents; ++content)
        if (contents[content]) view.scores[content] = scoreOf(reference, images[content]);
      result.views.push_back(std::move(view));
    }
    if (k == 0)
      result.details = {detailOf("should be seen", session.optimise.target == OptimiseTarget::light
                                                       ? wanted.front().second
                                                       : wanted.back().second),
                        detailOf("before", images[beforeContent]),
                        detailOf("after", images[afterContent])};
    if (k < heldOut) continue;
    for (std::size_t content = 0; content < judgedContents; ++content)
      if (contents[content])
        narrower[content].push_back(
            scoreOf(wanted.front().second, shown(content, states.shown.size() + (k - heldOut))));
  }
  for (std::size_t k = 0; k < narrower.size(); ++k) result.ifNarrower[k] = meanOf(narrower[k]);
  return result;
}

}  // namespace hogelscope
