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

/// Takes from a view with its unrounded values what the optimised content gives away.
Image without(const GivenAway& away, const Image& image) {
  const auto& [light, lift, dimming] = away;
  if (lift[0] == 0 && lift[1] == 0 && dimming == 1) return image;
  FloatImage result(image.width, image.height);
  result.seen = image.seen;
  const bool isLinear = light == LightModel::linear;
  for (std::size_t k = 0; k < image.unrounded.size(); ++k) {
    const auto code = double(image.unrounded[k]);
    const double part = dimming * (isLinear ? linearFromEncoded(code) : code / 255);
    const double less = lift[0] + (1 - lift[0] - lift[1]) * part;
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

/// The views of one eye, by JudgedContent, and what they should be, by the reference's name.
using ShownViews = std::array<std::optional<Image>, judgedContents>;
using WantedViews = std::vector<std::pair<std::string, Image>>;

class Judge {
 public:
  Judge(const Session& session, const LightFieldParams& optimised,
        const std::vector<std::filesystem::path>& pictures, const GivenAway& away,
        const Progress& progress)
      : m_session(session),
        m_pictures(pictures),
        m_away(away),
        m_isLive(session.lightField.isLive()),
        m_states(judgedStates(session, displayOf(session))),
        m_all(m_states.shown) {
    std::ranges::copy(m_states.narrower, std::back_inserter(m_all));
    const Session own = hasPrefilter(session) ? prefiltered(session) : session;
    Session designed = own, after = session;
    designed.twin = {};
    after.lightField = optimised;
    m_references.emplace(designed, m_states.withoutLeakage, part(progress, 0, 0.25));
    m_contents[beforeContent].emplace(session, m_all, part(progress, 0.25, 0.5));
    if (hasPrefilter(session))
      m_contents[prefilteredContent].emplace(own, m_all, part(progress, 0.5, 0.75));
    m_contents[afterContent].emplace(after, m_all, part(progress, 0.75, 1));
  }

  /// Returns the number of eyes.
  [[nodiscard]] std::size_t count() const { return m_states.shown.size(); }
  [[nodiscard]] bool isHeldOut(std::size_t eye) const { return eye >= m_session.cameras.size(); }
  /// Returns the state of a held-out eye for which the display leaks less.
  [[nodiscard]] std::size_t narrowerOf(std::size_t eye) const {
    return count() + eye - m_session.cameras.size();
  }

  [[nodiscard]] ShownViews shown(std::size_t state) {
    ShownViews views;
    for (std::size_t content = 0; content < judgedContents; ++content)
      if (m_contents[content]) {
        views[content] = m_contents[content]->image(state, m_renderer);
        if (content != afterContent) views[content] = without(m_away, *views[content]);
      }
    return views;
  }

  [[nodiscard]] WantedViews wanted(std::size_t eye, const Progress& progress) {
    const Image onDisplay = m_references->image(eye, m_renderer);
    WantedViews views{{"display", without(m_away, onDisplay)}};
    if (m_isLive)
      views.emplace_back("ideal", without(m_away, m_references->ideal(eye, m_renderer)));
    if (eye < m_pictures.size())
      views.emplace_back("views",
                         without(m_away, readPicture(m_pictures[eye], onDisplay.seen, progress)));
    return views;
  }

  void addScores(std::size_t eye, const ShownViews& shown, const WantedViews& wanted,
                 std::vector<JudgedView>& views) const {
    for (const auto& [name, reference] : wanted) {
      JudgedView view{m_all[eye].camera.name, isHeldOut(eye), name, {}};
      for (std::size_t content = 0; content < judgedContents; ++content)
        if (shown[content]) view.scores[content] = scoreOf(reference, *shown[content]);
      views.push_back(std::move(view));
    }
  }

  [[nodiscard]] std::vector<ViewDetail> details(const ShownViews& shown,
                                                const WantedViews& wanted) const {
    const bool isOwnLight = m_session.optimise.target == OptimiseTarget::light;
    return {detailOf("should be seen", (isOwnLight ? wanted.front() : wanted.back()).second),
            detailOf("before", *shown[beforeContent]), detailOf("after", *shown[afterContent])};
  }

 private:
  const Session& m_session;
  const std::vector<std::filesystem::path>& m_pictures;
  GivenAway m_away;
  bool m_isLive;
  JudgedStates m_states;
  std::vector<CameraState> m_all;  ///< those that are shown, then those with less leakage
  std::optional<JudgedViews> m_references;
  std::array<std::optional<JudgedViews>, judgedContents> m_contents;
  Renderer m_renderer;
};

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
                const std::vector<std::filesystem::path>& pictures, const GivenAway& away,
                const Progress& progress) {
  Judge judge(session, optimised, pictures, away, part(progress, 0, 0.4));
  Judgement result;
  std::array<std::vector<ViewScore>, judgedContents> narrower;
  for (std::size_t k = 0; k < judge.count(); ++k) {
    reportProgress(progress, 0.4 + 0.6 * double(k) / double(judge.count()));
    const ShownViews images = judge.shown(k);
    const WantedViews wanted = judge.wanted(k, progress);
    judge.addScores(k, images, wanted, result.views);
    if (k == 0) result.details = judge.details(images, wanted);
    if (!judge.isHeldOut(k)) continue;
    const ShownViews less = judge.shown(judge.narrowerOf(k));
    for (std::size_t content = 0; content < judgedContents; ++content)
      if (less[content])
        narrower[content].push_back(scoreOf(wanted.front().second, *less[content]));
  }
  for (std::size_t k = 0; k < narrower.size(); ++k) result.ifNarrower[k] = meanOf(narrower[k]);
  return result;
}

}  // namespace hogelscope
