// SPDX-License-Identifier: BSD-3-Clause
// Tests live light fields: the image of a view is that of the whole light field, only what it reads
// is traced, and the closed forms of what a display does to a scene hold.
#include "core/content/live_source.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/content/scene_content.h"
#include "core/engine/renderer.h"
#include "tests/core/live_content.h"
#include "tests/core/random_scene.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

constexpr double pi = std::numbers::pi;

/// A display whose hogels are not square, with more directions across than down.
PanelParams displayOf(int hogels, int directions) {
  PanelParams display;
  display.size = {0.5, 0.5};
  display.hogels = {hogels, hogels};
  display.directions = {directions, directions};
  return display;
}

double pitchOf(const PanelParams& display) {
  return display.size[0] / display.hogels[0];
}
double slopeStepOf(const PanelParams& display) {
  return 2 * std::tan(display.fov[0] * pi / 360) / display.directions[0];
}

std::shared_ptr<SceneContent> openScene(const PanelParams& display) {
  class Silent : public plugin::Progress {
   public:
    [[nodiscard]] bool go(double) const override { return true; }
  };
  auto scene = std::make_shared<SceneContent>();
  scene->open({{display.size[0], display.size[1]},
               {display.hogels[0], display.hogels[1]},
               {display.directions[0], display.directions[1]},
               {0, 0}},
              {".", 1}, Silent());
  return scene;
}

/// A camera on the panel's axis, all of whose image plane is the panel from distance `d`.
CameraState cameraAt(double d, const Vec3& eye, int pixels, const PanelParams& display) {
  CameraState state;
  state.camera.eye = eye;
  state.camera.lookat = {eye.x, eye.y, 0};
  state.camera.res = {pixels, pixels};
  state.intrinsics.fx = d / display.size[0] * pixels;
  return state;
}

RenderJob jobOf(std::shared_ptr<const LightFieldSource> source, const PanelParams& display,
                const CameraState& state) {
  RenderJob job;
  job.lightField = std::move(source);
  job.display = display;
  job.state = state;
  return job;
}

/// The light field in memory.
std::shared_ptr<const LightField> wholeOf(const LiveSource& source) {
  const auto [nx, ny, du, dv] = source.size();
  const auto all =
      source.slice(readsOfRows(source.size(), {0, ny - 1}, {0, du - 1}, {0, dv - 1}), {});
  auto whole = std::make_shared<LightField>(source.size(), source.type());
  for (int j = 0; j < ny; ++j)
    for (int v = 0; v < dv; ++v)
      for (int i = 0; i < nx; ++i)
        for (int u = 0; u < du; ++u)
          std::visit(
              [&, at = TexelIndex{i, j, u, v}](const auto& texels) {
                const auto& t = texels[all->layout().address(at)];
                const std::array rgb{t.r, t.g, t.b};
                whole->set(at, rgb.data());
              },
              all->texels());
  return whole;
}

/// Remembers the texels that the reference engine reads.
class Recorder : public LightFieldSource {
 public:
  explicit Recorder(const LightFieldSize& size) : m_size(size) {}
  [[nodiscard]] LightFieldSize size() const override { return m_size; }
  [[nodiscard]] StoredType type() const override { return StoredType::uint8; }
  [[nodiscard]] std::shared_ptr<const LightField> slice(const ViewReads&,
                                                        const Progress&) const override {
    return {};
  }
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override { return {}; }
  [[nodiscard]] Rgb texel(const TexelIndex& at) const override {
    read.insert({at.i, at.j, at.u, at.v});
    return {};
  }
  mutable std::set<std::array<int, 4>> read;

 private:
  LightFieldSize m_size;
};

double squaresOf(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return sum / double(values.size());
}

double sinc(double x) {
  return x == 0 ? 1 : std::sin(pi * x) / (pi * x);
}

}  // namespace

class TestLiveSource : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void viewsAreThoseOfTheWhole();
  void depthsAreTheContents();
  void tracesWhatIsRead();
  void blocksAndThreadsChangeNothing();
  void occlusionIsExact();
  void alignedEyeSeesTheScene();
  void errorHasItsBound_data();
  void errorHasItsBound();
  void contrastOfGratings_data();
  void contrastOfGratings();
  void samplesAreTheMean();
  void depthCuts();
  void contentBehindTheEye();
  void idealHasTheMaskAndTheLens();
  void overviewIsCoarse();
  void lightThatIsNoNumber();
  void memoryAndStop();
};

/// What is cut is not told of.
void TestLiveSource::depthsAreTheContents() {
  const auto content = std::make_shared<LivePlanes>(std::vector<LivePlane>{
      {0.2, [](double, double) { return 1; }}, {-0.4, [](double, double) { return 2; }}});
  PanelParams display;
  display.hogels = display.directions = {4, 4};
  QCOMPARE(liveSource(content, display)->depths(), (std::array{-0.4, 0.2}));
  LiveParams cut;
  cut.depth = {-0.1, 3};
  QCOMPARE(liveSource(content, display, cut)->depths(), (std::array{-0.1, 0.2}));
}

/// All options of a view: any lens, leakage, reconstruction, samples, hogel lens.
void TestLiveSource::viewsAreThoseOfTheWhole() {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    RenderJob job = randomSampledScene(random).job;
    const LiveParams params{random.flip() ? 1 : 3, {1, 0.5}, {-10, 10}};
    const auto live = liveSource(openScene(job.display), job.display, params,
                                 random.flip() ? StoredType::uint8 : StoredType::real);
    job.lightField = wholeOf(*live);
    const Image whole = rendered(job);
    job.lightField = live;
    QVERIFY2(rendered(job) == whole, std::to_string(seed).c_str());
  }
}

/// Texels of a footprint that the view does not read are not traced.
void TestLiveSource::tracesWhatIsRead() {
  double most = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    RenderJob job = randomSampledScene(random).job;
    job.display.hogels = {40, 30};
    job.display.directions = {24, 20};
    job.method.droppedTaps = 0;
    const auto content =
        std::make_shared<LivePlanes>(std::vector<LivePlane>{{0, [](double, double) { return 9; }}});
    job.lightField = liveSource(content, job.display);
    (void)rendered(job);
    const auto recorder = std::make_shared<Recorder>(job.lightField->size());
    job.lightField = recorder;
    (void)simulate(job);
    if (recorder->read.empty()) continue;
    most = std::max(most, double(content->traced) / double(recorder->read.size()));
  }
  QVERIFY2(most > 0.9 && most < 1.2, std::to_string(most).c_str());
}

void TestLiveSource::blocksAndThreadsChangeNothing() {
  const PanelParams display = displayOf(30, 12);
  const LiveSource source(openScene(display), display, {8, {1, 1}, {-10, 10}}, StoredType::uint8,
                          std::size_t{1} << 30, parallelRows);
  const auto whole = wholeOf(source);
  for (const TexelIndex& at :
       {TexelIndex{0, 0, 0, 0}, {29, 29, 11, 11}, {7, 20, 3, 10}, {16, 3, 6, 5}})
    QVERIFY(source.texel(at) == whole->texel(at));
  QVERIFY(
      wholeOf(*liveSource(openScene(display), display, {8, {1, 1}, {-10, 10}}, StoredType::uint8))
          ->texel({7, 20, 3, 10}) == whole->texel({7, 20, 3, 10}));
}

/// A card before a wall: which of them a texel shows, from the line's own equation.
void TestLiveSource::occlusionIsExact() {
  const PanelParams display = displayOf(24, 18);
  for (const double z : {0.11, 0.0, -0.2}) {
    const auto card = [](double x, double) { return std::abs(x - 0.013) < 0.04 ? 200.0 : -1.0; };
    const auto wall = [](double x, double y) { return 90 + 30 * (std::sin(37 * x) + y); };
    const auto source = liveSource(
        std::make_shared<LivePlanes>(std::vector<LivePlane>{{z, card}, {-0.3, wall}}), display);
    const auto whole = wholeOf(*source);
    const Display panel(display);
    int cards = 0;
    for (int k = 0; k < 24 * 24 * 18 * 18; k += 7) {
      const TexelIndex at{k % 24, k / 24 % 24, k / 576 % 18, k / 576 / 18};
      const auto [p, s] = panel.rayOf(at);
      const bool isCard = std::abs(p.x + z * s.x - 0.013) < 0.04;
      const double expected = isCard ? 200 : wall(p.x - 0.3 * s.x, p.y - 0.3 * s.y);
      QVERIFY(std::abs(whole->texel(at).r - expected) < 1e-3);
      cards += int(isCard);
    }
    QVERIFY(cards > 1000);
  }
}

/// From the distance pitch / slope step, over a hogel's corner, every camera ray through a hogel's
/// middle is a ray of the display: the view is the scene at every depth.
void TestLiveSource::alignedEyeSeesTheScene() {
  const PanelParams display = displayOf(64, 40);
  const double d = pitchOf(display) / slopeStepOf(display);
  const auto source = liveSource(openScene(display), display, {}, StoredType::uint8);
  RenderJob job = jobOf(source, display, cameraAt(d, {0, 0, d}, 64, display));
  const Image shown = rendered(job);
  job.isIdeal = true;
  const Image ideal = rendered(job);
  QVERIFY(shown.seen == ideal.seen);
  QVERIFY(std::ranges::count(shown.seen, 255) > 500);
  QCOMPARE(shown.rgb == ideal.rgb, true);
  const Vec3 beside{pitchOf(display) / 4, 0, d};
  job.state = cameraAt(d, beside, 64, display);
  const Image idealBeside = rendered(job);
  job.isIdeal = false;
  QVERIFY(rendered(job).rgb != idealBeside.rgb);
}

void TestLiveSource::errorHasItsBound_data() {
  QTest::addColumn<double>("z");
  for (const double z : {-1.2, -0.5, -0.2, -0.05, 0.0, 0.04, 0.1, 0.2, 0.3})
    QTest::newRow(qPrintable(QString::number(z))) << z;
}

/// A ramp at depth z: the shown place differs from the true one by at most p/2 + |z| δ/2, with an
/// rms of √((p² + z² δ²)/12).
void TestLiveSource::errorHasItsBound() {
  QFETCH(const double, z);
  const PanelParams display = displayOf(256, 150);
  const double p = pitchOf(display), step = slopeStepOf(display);
  constexpr double gain = 50;  // code values a metre
  const auto ramp = [](double x, double) { return 128 + gain * x; };
  RenderJob job =
      jobOf(liveSource(std::make_shared<LivePlanes>(std::vector<LivePlane>{{z, ramp}}), display),
            display, cameraAt(0.7, {0.0123, 0.0217, 0.7123}, 401, display));
  Renderer renderer(serialRows);
  const FloatImage shown = renderer.renderFloat(job);
  job.isIdeal = true;
  const FloatImage ideal = renderer.renderFloat(job);
  std::vector<double> errors;
  for (std::size_t k = 0; k < shown.seen.size(); ++k)
    if (shown.seen[k] != 0) errors.push_back(double(shown.rgb[3 * k] - ideal.rgb[3 * k]) / gain);
  QVERIFY(errors.size() > 20000);
  const double bound = p / 2 + std::abs(z) * step / 2;
  for (const double error : errors) QVERIFY(std::abs(error) <= bound + 1e-6);
  const double rms = std::sqrt((p * p + z * z * step * step) / 12);
  QVERIFY2(std::abs(std::sqrt(squaresOf(errors)) / rms - 1) < 0.02,
           std::to_string(std::sqrt(squaresOf(errors)) / rms).c_str());
}

void TestLiveSource::contrastOfGratings_data() {
  QTest::addColumn<double>("z");
  QTest::addColumn<double>("cycles");  // in the larger of pitch and |z| · slope step
  for (const double z : {-0.4, -0.1, 0.0, 0.08, 0.18})  // at p/δ = 0.254 both steps are one
    for (const double cycles : {0.1, 0.25, 0.4, 0.5, 0.7})
      if (z != 0 || cycles != 0.5)  // the phases lock
        QTest::addRow("%g at %g", cycles, z) << z << cycles;
}

/// The first harmonic of a grating of frequency ν is sinc(ν p) sinc(ν z δ) of the true one.
void TestLiveSource::contrastOfGratings() {
  QFETCH(const double, z);
  QFETCH(const double, cycles);
  const PanelParams display = displayOf(256, 150);
  const double p = pitchOf(display), step = slopeStepOf(display);
  const double frequency = cycles / std::max(p, std::abs(z) * step);
  const auto grating = [=](double x, double) {
    return 128 + 100 * std::cos(2 * pi * frequency * x);
  };
  const auto phase = [=](double x, double) { return 128 + 100 * std::sin(2 * pi * frequency * x); };
  Renderer renderer(serialRows);
  // Least squares of shown = 128 + a cos + b sin, over several eyes, so that no phase is preferred.
  double cc = 0, ss = 0, cs = 0, sc = 0, sn = 0;
  Random random(1);
  for (int k = 0; k < 24; ++k) {
    const Vec3 eye{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(0.6, 0.9)};
    const auto image = [&](const auto& light, bool isIdeal) {
      RenderJob job = jobOf(
          liveSource(std::make_shared<LivePlanes>(std::vector<LivePlane>{{z, light}}), display),
          display, cameraAt(0.7, eye, 301, display));
      job.state.camera.res = {301, 1};
      job.isIdeal = isIdeal;
      return renderer.renderFloat(job);
    };
    const FloatImage shown = image(grating, false);
    const FloatImage cosine = image(grating, true);
    const FloatImage sine = image(phase, true);
    for (std::size_t at = 0; at < shown.seen.size(); ++at) {
      if (shown.seen[at] == 0) continue;
      const double value = double(shown.rgb[3 * at]) - 128;
      const double c = double(cosine.rgb[3 * at]) - 128, s = double(sine.rgb[3 * at]) - 128;
      cc += c * c, ss += s * s, cs += c * s, sc += value * c, sn += value * s;
    }
  }
  const double contrast = (sc * ss - sn * cs) / (cc * ss - cs * cs);
  const double expected = sinc(frequency * p) * sinc(frequency * z * step);
  QVERIFY2(std::abs(contrast - expected) < 0.03,
           qPrintable(QString("%1, not %2").arg(contrast).arg(expected)));
}

/// The mean of a plane's light over a hogel and a direction, by a brute-force lattice.
void TestLiveSource::samplesAreTheMean() {
  const PanelParams display = displayOf(8, 6);
  const Display panel(display);
  const auto light = [](double x, double y) { return 100 + 80 * x + 300 * x * y; };
  const auto content = std::make_shared<LivePlanes>(std::vector<LivePlane>{{-0.2, light}});
  for (const int n : {1, 4, 8, 64}) {
    const LiveParams params{n, {0.8, 0.6}, {-10, 10}};
    const auto source = liveSource(content, display, params);
    for (const TexelIndex& at : {TexelIndex{1, 2, 3, 4}, {7, 0, 0, 5}}) {
      double sum = 0;
      constexpr std::array<int, 4> generator{1, 3, 5, 7};
      for (int k = 0; k < n; ++k) {
        const auto o = [&](std::size_t axis) {
          return n == 1 ? 0 : (k * generator[axis] % n + 0.5) / n - 0.5;
        };
        const Vec2 p = panel.position(at.i + 0.5 + 0.8 * o(0), at.j + 0.5 - 0.8 * o(1));
        const Vec2 s = panel.slopes(at.u + 0.5 + 0.6 * o(2), at.v + 0.5 + 0.6 * o(3));
        sum += light(p.x - 0.2 * s.x, p.y - 0.2 * s.y);
      }
      QVERIFY(std::abs(source->texel(at).r - sum / n) < 1e-3);
    }
  }
}

void TestLiveSource::depthCuts() {
  const PanelParams display = displayOf(8, 6);
  const auto flat = [](double value) { return [value](double, double) { return value; }; };
  const auto content = std::make_shared<LivePlanes>(
      std::vector<LivePlane>{{0.1, flat(10)}, {0, flat(20)}, {-0.1, flat(30)}});
  const auto seen = [&](double back, double front) {
    return liveSource(content, display, {1, {1, 1}, {back, front}})->texel({3, 3, 3, 3}).r;
  };
  QVERIFY(std::abs(seen(-1, 1) - 10) < 1e-3);
  QVERIFY(std::abs(seen(-1, 0.05) - 20) < 1e-3);
  QVERIFY(std::abs(seen(-1, -0.05) - 30) < 1e-3);
  QVERIFY(std::abs(seen(-0.05, -0.01)) < 1e-3);
  QVERIFY(std::abs(seen(0.5, 1)) < 1e-3);    // all content is behind
  QVERIFY(std::abs(seen(-1, -0.5)) < 1e-3);  // in front
}

/// A ray of the display meets content behind the eye; the eye does not.
void TestLiveSource::contentBehindTheEye() {
  const PanelParams display = displayOf(32, 20);
  const auto flat = [](double value) { return [value](double, double) { return value; }; };
  RenderJob job = jobOf(liveSource(std::make_shared<LivePlanes>(
                                       std::vector<LivePlane>{{0.9, flat(200)}, {-0.1, flat(50)}}),
                                   display),
                        display, cameraAt(0.5, {0, 0, 0.5}, 31, display));
  QCOMPARE(int(rendered(job).rgb[3 * (15 * 31 + 15)]), 200);
  job.isIdeal = true;
  QCOMPARE(int(rendered(job).rgb[3 * (15 * 31 + 15)]), 50);
}

void TestLiveSource::idealHasTheMaskAndTheLens() {
  for (std::uint64_t seed = 100; seed < 140; ++seed) {
    Random random(seed);
    RenderJob job = randomSampledScene(random).job;
    job.state.psf = {};
    // Light by place alone: what the reference engine finds for the panel's plane.
    const auto byPlace = [](double x, double y) { return 120 + 90 * x + 60 * y; };
    job.lightField =
        liveSource(std::make_shared<LivePlanes>(std::vector<LivePlane>{{0, byPlace}}), job.display);
    const Image shown = rendered(job);
    job.isIdeal = true;
    Renderer renderer(serialRows);
    const FloatImage ideal = renderer.renderFloat(job);
    QVERIFY(ideal.seen == shown.seen);
    const Camera camera(job.state.camera, job.state.intrinsics);
    const Display display(job.display);
    const RigidTransform displayFromCamera = display.displayFromWorld() * camera.worldFromCamera();
    const Vec3 eye = displayFromCamera.origin;
    const auto [width, height] = job.state.camera.res;
    if (job.sampling.samplesPerPixel != 1) continue;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const std::size_t at = std::size_t(y * width + x);
        if (ideal.seen[at] == 0) continue;
        const auto p = idealPoint(Distortion(job.state.distortion), job.sampling.mapping,
                                  camera.normalised(x, y));
        const Vec3 way = displayFromCamera.direction({p->x, p->y, 1});
        const double expected =
            byPlace(eye.x - eye.z * way.x / way.z, eye.y - eye.z * way.y / way.z);
        QVERIFY(std::abs(double(ideal.rgb[3 * at]) - expected) < 1e-3);
      }
  }
}

void TestLiveSource::overviewIsCoarse() {
  const PanelParams display = displayOf(100, 20);
  const auto source = liveSource(openScene(display), display);
  const LightFieldSize size = source->overview()->size();
  QVERIFY((size == LightFieldSize{64, 64, 16, 16}));
  PanelParams coarse = display;
  coarse.hogels = {64, 64};
  coarse.directions = {16, 16};
  QVERIFY(source->overview()->texel({20, 40, 3, 9}) ==
          liveSource(openScene(coarse), coarse)->texel({20, 40, 3, 9}));
}

/// A plugin's mistake is no black pixel.
void TestLiveSource::lightThatIsNoNumber() {
  const PanelParams display = displayOf(16, 8);
  const auto bad = [](double x, double) { return x > 0.1 ? INFINITY : 9.0; };
  RenderJob job =
      jobOf(liveSource(std::make_shared<LivePlanes>(std::vector<LivePlane>{{0, bad}}), display),
            display, cameraAt(0.6, {0, 0, 0.6}, 40, display));
  QVERIFY_THROWS_EXCEPTION(InputError, (void)rendered(job));
  job.isIdeal = true;
  QVERIFY_THROWS_EXCEPTION(InputError, (void)rendered(job));
}

void TestLiveSource::memoryAndStop() {
  const PanelParams display = displayOf(64, 40);
  const CameraState camera = cameraAt(0.6, {0, 0, 0.6}, 200, display);
  const LiveSource small(openScene(display), display, {}, StoredType::uint8, 1000, serialRows);
  RenderJob job = jobOf({std::shared_ptr<void>(), &small}, display, camera);
  QVERIFY_THROWS_EXCEPTION(InputError, (void)rendered(job));
  job.lightField = liveSource(openScene(display), display);
  Renderer renderer(serialRows);
  QVERIFY_THROWS_EXCEPTION(Cancelled, (void)renderer.render(job, [](double) { return false; }));
  job.isIdeal = true;
  QVERIFY_THROWS_EXCEPTION(Cancelled, (void)renderer.render(job, [](double) { return false; }));
  job.lightField = wholeOf(*liveSource(openScene(display), display));
  QVERIFY_THROWS_EXCEPTION(InputError, (void)renderer.render(job));
}

QTEST_APPLESS_MAIN(TestLiveSource)
#include "test_live_source.moc"
