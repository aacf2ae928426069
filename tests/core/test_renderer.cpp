// SPDX-License-Identifier: BSD-3-Clause
// Tests that the renderer alone resolves tolerance, method and scale, into images of the camera's
// size, and that it asks for no more texels than a view reads.
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/engine/renderer.h"
#include "core/engine/scaled_view.h"
#include "core/engine/view_rays.h"
#include "core/light_field/light_field.h"
#include "tests/core/sample_view.h"

using namespace hogelscope;

namespace {

/// A source that counts what is asked for, and says that nothing is in memory.
class CountingSource : public LightFieldSource {
 public:
  explicit CountingSource(std::shared_ptr<const LightFieldSource> source)
      : m_source(std::move(source)) {}

  [[nodiscard]] LightFieldSize size() const override { return m_source->size(); }
  [[nodiscard]] StoredType type() const override { return m_source->type(); }
  [[nodiscard]] std::shared_ptr<const LightField> slice(const ViewReads& reads,
                                                        const Progress& progress) const override {
    asked = reads.footprint();
    ++slices;
    return m_source->slice(reads, progress);
  }
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override {
    return m_source->overview();
  }

  mutable Footprint asked;
  mutable int slices = 0;

 private:
  std::shared_ptr<const LightFieldSource> m_source;
};

}  // namespace

class TestRenderer : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isTheReference() {
    RenderJob job = sampleView();
    QVERIFY(Renderer().render(job) == simulate(job));
    job.state.psf.windowSize = 3;
    job.state.distortion.k1 = 0.1;
    QVERIFY(Renderer(serialRows).render(job) == Renderer().render(job));
  }

  /// Each texel's own value where nothing is summed, and the 8-bit image beside it.
  void sixteenBitsAreKept() {
    RenderJob job = sampleView();
    const LightFieldSize size = job.lightField->size();
    std::vector<std::uint16_t> values(3 * size.width() * size.height());
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = static_cast<std::uint16_t>(k * 40503 % 65536);
    job.lightField = std::make_shared<const LightField>(size, values);
    const Image plain = Renderer().render(job);
    QVERIFY(plain.bits == 8 && plain.deep.empty());
    job.bits = 16;
    const Image deep = Renderer().render(job);
    QVERIFY(deep.rgb == plain.rgb && deep.seen == plain.seen);
    const Simulation simulation(job);
    for (int y = 0; y < deep.height; ++y)
      for (int x = 0; x < deep.width; ++x) {
        const std::size_t at = 3 * (std::size_t(y) * std::size_t(deep.width) + std::size_t(x));
        const Rgb light = simulation.pixel(x, y).value_or(PixelLight{});
        QCOMPARE(int(deep.deep[at]), int(std::lround(257 * light.r)));
        QCOMPARE(int(deep.deep[at + 2]), int(std::lround(257 * light.b)));
      }
  }

  void toleranceIsTheChoices() {
    RenderJob job = sampleView();
    job.state.camera.res = {300, 220};
    job.state.psf.windowSize = 5;
    job.sampling.samplesPerPixel = 3;
    const Image exact = Renderer().render(job);
    job.sampling.tolerance = 40;
    Renderer renderer;
    const Choice choice = renderer.chooseMethod(job);
    QVERIFY(choice.pixels > 0 && choice.job.method != job.method);
    QCOMPARE(choice.job.sampling.tolerance, 0.0);
    const Image image = renderer.render(job);
    QVERIFY(image == renderer.render(choice.job));
    QVERIFY(image != exact);
    QCOMPARE(image.width, 300);
  }

  void scaleIsEnlarged() {
    RenderJob job = sampleView();
    job.method.scale = 4;
    QVERIFY(Renderer().render(job) == enlarged(simulate(reduced(job)), 4, {70, 50}));
  }

  /// The borders of the image are at -1/2.
  void anotherSizeHasTheSameField() {
    CameraState state = sampleView().state;
    QCOMPARE(resized(state, state.camera.res), state);
    for (const IntrinsicsParams& intrinsics : {IntrinsicsParams{}, {90, 80, 30, 27}}) {
      state.intrinsics = intrinsics;
      const CameraState other = resized(state, {210, 25});
      const Camera before(state.camera, state.intrinsics);
      const Camera after(other.camera, other.intrinsics);
      for (const double x : {0.0, 0.3, 1.0})
        for (const double y : {0.0, 0.8, 1.0}) {
          const Vec2 a = before.normalised(70 * x - 0.5, 50 * y - 0.5);
          const Vec2 b = after.normalised(210 * x - 0.5, 25 * y - 0.5);
          QVERIFY(std::abs(a.x - b.x) < 1e-12 && std::abs(a.y - b.y) < 1e-12);
        }
      QVERIFY(other.distortion == state.distortion && other.psf == state.psf);
    }
  }

  void floatsRoundToTheImage() {
    RenderJob job = sampleView();
    job.state.psf.windowSize = 3;
    for (const int scale : {1, 2}) {
      job.method.scale = scale;
      const Image image = Renderer().render(job);
      const FloatImage floats = Renderer().renderFloat(job);
      QVERIFY(floats.seen == image.seen);
      QCOMPARE(floats.rgb.size(), image.rgb.size());
      bool hasFraction = false;
      for (std::size_t k = 0; k < image.rgb.size(); ++k) {
        QVERIFY(std::abs(double(floats.rgb[k]) - image.rgb[k]) <= 0.5 * scale + 0.001);
        hasFraction = hasFraction || floats.rgb[k] != std::floor(floats.rgb[k]);
      }
      QVERIFY(hasFraction);
    }
  }

  /// One slice for a view: all that its rays, its leakage and its interpolation read.
  void asksForItsFootprintOnce() {
    RenderJob job = sampleView();
    job.state.psf.windowSize = 3;
    const Image expected = Renderer().render(job);
    const auto source = std::make_shared<const CountingSource>(job.lightField);
    job.lightField = source;
    QVERIFY(Renderer().render(job) == expected);
    QCOMPARE(source->slices, 1);
    LensTables tables;
    QVERIFY(source->asked == ViewRays(job, tables, serialRows).footprint(serialRows));
    QVERIFY(source->asked.texels() <
            job.lightField->size().width() * job.lightField->size().height());
  }

  void cancels() {
    QVERIFY_THROWS_EXCEPTION(Cancelled,
                             (void)Renderer().render(sampleView(), [](double) { return false; }));
    QVERIFY_THROWS_EXCEPTION(
        Cancelled, (void)Renderer().renderFloat(sampleView(), [](double) { return false; }));
  }

  void withoutALightFieldItThrows() {
    RenderJob job = sampleView();
    job.lightField = nullptr;
    QVERIFY_THROWS_EXCEPTION(InputError, (void)Renderer().render(job));
    job.sampling.tolerance = 1;
    QVERIFY_THROWS_EXCEPTION(InputError, (void)Renderer().render(job));
  }
};

QTEST_APPLESS_MAIN(TestRenderer)
#include "test_renderer.moc"
