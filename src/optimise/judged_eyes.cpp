// SPDX-License-Identifier: BSD-3-Clause
#include "optimise/judged_eyes.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/metrics/metric.h"
#include "core/panel/design_numbers.h"
#include "io/images/image_file.h"

namespace hogelscope {

namespace {

/// Returns a picture in code values.
FloatImage readPicture(const std::filesystem::path& path, const std::vector<std::uint8_t>& seen,
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
  return image;
}

/// Scores views of the contents of one session.
class Judge {
 public:
  Judge(const Session& session, const LightFieldParams& optimised, const Progress& progress)
      : m_lift(session.optimise.lift) {
    const SourceUse use{.memory = allowedMemory() / 2};
    Session after = session;
    after.lightField = optimised;
    m_sources[beforeContent] = loadViewSource(session, part(progress, 0, 0.4), use);
    m_sources[afterContent] = loadViewSource(after, part(progress, 0.4, 0.8), use);
    m_isLive = session.lightField.isLive();
    if (m_isLive)
      m_sources[prefilteredContent] =
          loadViewSource(prefiltered(session), part(progress, 0.8, 1), use);
  }

  [[nodiscard]] bool has(int content) const { return content != prefilteredContent || m_isLive; }
  [[nodiscard]] bool isLive() const { return m_isLive; }
  [[nodiscard]] const PanelParams& display() const { return m_sources[beforeContent].display; }

  [[nodiscard]] Image shown(JudgedContent content, const CameraState& state) {
    FloatImage image = m_renderer.renderFloat(m_sources[content].job(state));
    if (content != afterContent) lift(image, state.psf.light);
    return rounded(std::move(image));
  }
  /// Returns the view on the display as designed and without leakage.
  [[nodiscard]] Image ofDisplay(CameraState state) {
    state.psf.windowSize = 1;
    RenderJob job = m_sources[m_isLive ? prefilteredContent : beforeContent].job(state);
    job.twin = nullptr;
    return reference(m_renderer.renderFloat(job), state);
  }
  [[nodiscard]] Image ideal(const CameraState& state) {
    RenderJob job = m_sources[beforeContent].job(state);
    job.isIdeal = true;
    job.twin = nullptr;
    return reference(m_renderer.renderFloat(job), state);
  }
  [[nodiscard]] Image reference(FloatImage image, const CameraState& state) const {
    lift(image, state.psf.light);
    return rounded(std::move(image));
  }
  [[nodiscard]] ViewScore score(const Image& reference, const Image& test) const {
    const std::vector<double> values = m_metrics.compare(reference, test, parallelRows);
    return {values[psnrSeenColumn], values[ssimSeenColumn], values[mseSeenColumn]};
  }

 private:
  /// Takes from a view the contrast that the optimised content gives away.
  void lift(FloatImage& image, LightModel light) const {
    const auto [black, white] = m_lift;
    if (black == 0 && white == 0) return;
    for (float& value : image.rgb) {
      const bool isLinear = light == LightModel::linear;
      const double part = isLinear ? linearFromEncoded(double(value)) : double(value) / 255;
      const double lifted = black + (1 - black - white) * part;
      value = float(isLinear ? encodedFromLinear(lifted) : 255 * lifted);
    }
  }

  std::array<double, 2> m_lift;
  std::array<ViewSource, judgedContents> m_sources;
  bool m_isLive = false;
  Renderer m_renderer;
  MetricSet m_metrics;
};

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

/// Returns what the states' views should look like.
const Image& wanted(OptimiseTarget target,
                    const std::vector<std::pair<std::string, Image>>& references) {
  return target == OptimiseTarget::light ? references.front().second : references.back().second;
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
  Judge judge(session, optimised, part(progress, 0, 0.3));
  const PanelParams display = judge.display();
  std::vector<CameraState> states = session.cameras;
  std::ranges::copy(heldOutEyes(session, display, session.optimise), std::back_inserter(states));
  Judgement result;
  std::array<std::vector<ViewScore>, judgedContents> narrower;
  for (std::size_t k = 0; k < states.size(); ++k) {
    reportProgress(progress, 0.3 + 0.7 * double(k) / double(states.size()));
    const CameraState& state = states[k];
    const bool isHeldOut = k >= session.cameras.size();
    std::array<Image, judgedContents> shown;
    for (const JudgedContent content : {beforeContent, prefilteredContent, afterContent})
      if (judge.has(content)) shown[content] = judge.shown(content, state);
    std::vector<std::pair<std::string, Image>> references{{"display", judge.ofDisplay(state)}};
    if (judge.isLive()) references.emplace_back("ideal", judge.ideal(state));
    if (!isHeldOut && !pictures.empty())
      references.emplace_back(
          "views",
          judge.reference(readPicture(pictures[k], shown[afterContent].seen, progress), state));
    for (const auto& [name, reference] : references) {
      JudgedView view{state.camera.name, isHeldOut, name, {}};
      for (const JudgedContent content : {beforeContent, prefilteredContent, afterContent})
        if (judge.has(content)) view.scores[content] = judge.score(reference, shown[content]);
      result.views.push_back(std::move(view));
    }
    if (k == 0)
      result.details = {detailOf("should be seen", wanted(session.optimise.target, references)),
                        detailOf("before", shown[beforeContent]),
                        detailOf("after", shown[afterContent])};
    if (!isHeldOut || state.psf.windowSize == 1) continue;
    CameraState less = state;
    less.psf.sigma *= Judgement::narrower;
    for (const JudgedContent content : {beforeContent, prefilteredContent, afterContent})
      if (judge.has(content))
        narrower[content].push_back(
            judge.score(references.front().second, judge.shown(content, less)));
  }
  for (std::size_t k = 0; k < narrower.size(); ++k) result.ifNarrower[k] = meanOf(narrower[k]);
  return result;
}

}  // namespace hogelscope
