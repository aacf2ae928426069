// SPDX-License-Identifier: BSD-3-Clause
// Tests that all work of core which may take long asks whether to stop while it is at it. Each row
// of an image here takes seconds or more, so what asks before and between rows only does not pass.
#include <QTest>
#include <algorithm>

#include "core/engine/adaptive_method.h"
#include "core/engine/renderer.h"
#include "core/engine/streaming_renderer.h"
#include "core/lens/lens_certificate.h"
#include "core/lens/lens_grid.h"
#include "core/metrics/panel_error.h"
#include "core/metrics/squared_error.h"
#include "core/metrics/ssim.h"

using namespace hogelscope;

namespace {

/// Says stop when it is asked again, which forThreads() does after 20 ms: the work goes on then.
class SecondTime {
 public:
  Progress progress() {
    return [this](double) { return ++m_calls < 2; };
  }

 private:
  int m_calls = 0;
};

/// All pixels of this one row are in one direction, which touches the fold so nearly that each
/// needs some hundred steps of the certified inverse.
LensKey nearADoubleFold() {
  LensKey lens;
  lens.distortion = {3.2161829187638151, -7.6176025310617304, 0.01, -0.00011541482921920224,
                     4.5926169078102079};
  lens.res = {16384, 1};
  lens.focalLength = {1e3, 1e3};
  lens.centre = {20000, 0};
  return lens;
}

LightField noise(const LightFieldSize& size) {
  std::vector<std::uint8_t> values(3 * size.width() * size.height());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::uint8_t(k * 37 % 251);
  return {size, LightField::Values(values)};
}

RenderJob viewOf(const std::array<int, 2>& res) {
  RenderJob job;
  job.display.hogels = {8, 8};
  job.display.directions = {8, 8};
  job.lightField = std::make_shared<const LightField>(noise({8, 8, 8, 8}));
  job.state.camera.eye = {0, 0, 0.5};
  job.state.camera.res = res;
  return job;
}

RenderJob throughHardLens() {
  const LensKey lens = nearADoubleFold();
  RenderJob job = viewOf(lens.res);
  job.state.distortion = lens.distortion;
  job.state.intrinsics = {lens.focalLength.x, lens.focalLength.y, lens.centre.x, lens.centre.y};
  return job;
}

/// So many that no table of them is kept.
RenderJob withManyRays(RenderJob job) {
  job.sampling.samplesPerPixel = 64;
  return job;
}

void renderRow(const RenderJob& job, const Progress& progress) {
  LensTables tables;
  const FastSimulation simulation(job, tables, serialRows, progress);
  const auto width = std::size_t(job.state.camera.res[0]);
  std::vector<std::uint8_t> rgb(3 * width);
  std::vector<std::uint8_t> seen(width);
  simulation.rows(0, 1, 0, int(width), rgb.data(), seen.data());
}

}  // namespace

class TestStop : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tableOfAHardLens() {
    SecondTime stop;
    LensTables tables;
    QVERIFY_EXCEPTION_THROWN((void)tables.get(nearADoubleFold(), serialRows, stop.progress()),
                             Cancelled);
  }

  void nodesOfAHardLens() {
    LensKey lens = nearADoubleFold();
    lens.inverse = LensInverse::table;
    lens.steps = 1;
    SecondTime stop;
    QVERIFY_EXCEPTION_THROWN(LensRays(lens, forThreads(stop.progress())), Cancelled);
  }

  void certificateOfAHardLens() {
    SecondTime stop;
    QVERIFY_EXCEPTION_THROWN((void)certify(nearADoubleFold(), serialRows, stop.progress()),
                             Cancelled);
  }

  void gridOfAHardLens() {
    SecondTime stop;
    QVERIFY_EXCEPTION_THROWN((void)lensGrid(nearADoubleFold(), forThreads(stop.progress())),
                             Cancelled);
  }

  void raysOfAHardLensWithoutATable() {
    SecondTime stop;
    QVERIFY_EXCEPTION_THROWN(renderRow(withManyRays(throughHardLens()), stop.progress()),
                             Cancelled);
  }

  void manyRaysAndTaps() {
    RenderJob job = withManyRays(viewOf({128, 1}));
    job.sampling.reconstruction = Reconstruction::quadrilinear;
    job.state.psf = {20, 99, PsfBorder::clamp, LightModel::linear};
    SecondTime stop;
    QVERIFY_EXCEPTION_THROWN(renderRow(job, stop.progress()), Cancelled);
  }

  void manyPicturesRows() {
    SecondTime stop;
    QVERIFY_EXCEPTION_THROWN(
        (void)Renderer(serialRows).render(withManyRays(viewOf({16384, 64})), stop.progress()),
        Cancelled);
  }

  void probeForATolerance() {
    RenderJob job = throughHardLens();
    job.sampling.tolerance = 1;
    job.sampling.reconstruction = Reconstruction::bilinear;
    SecondTime stop;
    LensTables tables;
    QVERIFY_EXCEPTION_THROWN((void)chooseMethod(job, tables, serialRows, stop.progress()),
                             Cancelled);
  }

  /// And then nothing is added.
  void errorOnThePanel() {
    const RenderJob job = throughHardLens();
    Image picture(job.state.camera.res[0], job.state.camera.res[1]);
    std::fill(picture.seen.begin(), picture.seen.end(), std::uint8_t{255});
    const PanelError none({8, 8, 8, 8});
    PanelError error = none;
    SecondTime stop;
    LensTables tables;
    QVERIFY_EXCEPTION_THROWN(error.add(job, tables, serialRows, picture, picture, stop.progress()),
                             Cancelled);
    QVERIFY(error.hogels() == none.hogels() && error.directions() == none.directions());
  }

  void raysOfAPassingView() {
    RenderJob job = throughHardLens();
    job.lightField =
        std::make_shared<const StreamedLightField>(LightFieldSize{8, 8, 8, 8}, StoredType::uint8);
    SecondTime stop;
    LensTables tables;
    QVERIFY_EXCEPTION_THROWN(StreamingRenderer(job, tables, serialRows, stop.progress()),
                             Cancelled);
  }

  void metricsOfLargeImages() {
    const Image large(12000, 6000);
    SecondTime stop;
    QVERIFY_EXCEPTION_THROWN((void)squaredError(large, large, stop.progress()), Cancelled);
    SecondTime again;
    QVERIFY_EXCEPTION_THROWN((void)ssim(large, large, serialRows, again.progress()), Cancelled);
  }
};

QTEST_APPLESS_MAIN(TestStop)
#include "test_stop.moc"
