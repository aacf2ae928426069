// SPDX-License-Identifier: BSD-3-Clause
// A tolerance: the error that results stays within what the probe said, over many scenes.
#include "core/engine/adaptive_method.h"

#include <QTest>
#include <cmath>
#include <thread>

#include "core/base/error.h"
#include "core/content/scene_pattern.h"
#include "core/engine/scaled_view.h"
#include "tests/core/random_scene.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

/// The content of the sample session, where errors gather at edges.
std::shared_ptr<const LightField> sampleContent(const PanelParams& display) {
  const ScenePattern pattern(display);
  const LightFieldSize size{display.hogels[0], display.hogels[1], display.directions[0],
                            display.directions[1]};
  auto field = std::make_shared<LightField>(size, StoredType::uint8);
  for (int i = 0; i < size.nx; ++i)
    for (int j = 0; j < size.ny; ++j)
      for (int u = 0; u < size.du; ++u)
        for (int v = 0; v < size.dv; ++v) {
          const Rgb c = pattern.texel({i, j, u, v});
          const std::array rgb{quantised(c.r), quantised(c.g), quantised(c.b)};
          field->set({i, j, u, v}, rgb.data());
        }
  return field;
}

RenderJob sampleView() {
  RenderJob job;
  job.display.hogels = {64, 64};
  job.display.directions = {16, 16};
  job.lightField = sampleContent(job.display);
  return job;
}

void vary(Random& random, RenderJob& job) {
  // Some so far away that the panel is a small part of the image.
  const double far = random.integer(0, 3) == 0 ? std::exp(random.uniform(0, 4)) : 1;
  job.state.camera.eye = {far * random.uniform(-0.2, 0.2), far * random.uniform(-0.2, 0.2),
                          far * random.uniform(0.35, 0.9)};
  job.state.camera.res = {random.integer(300, 420), random.integer(200, 300)};
  job.state.psf = {random.uniform(0.4, 1.2), 2 * random.integer(0, 3) + 1};
  job.state.distortion = {};
  if (random.flip()) job.state.distortion = {random.uniform(-0.2, 0.6), 0.1, 0.01, -0.01};
  job.sampling.reconstruction = static_cast<Reconstruction>(random.integer(0, 2));
  job.sampling.samplesPerPixel = random.integer(1, 2);
  job.sampling.tolerance = std::exp(random.uniform(std::log(0.3), std::log(25.0)));
}

double rmse(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.rgb.size(); ++k) sum += std::pow(a.rgb[k] - b.rgb[k], 2);
  return std::sqrt(sum / double(a.rgb.size()));
}

}  // namespace

class TestTolerance : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void noToleranceChangesNothing() {
    LensTables tables;
    RenderJob job = sampleView();
    job.state.psf.windowSize = 5;
    Choice choice = chooseMethod(job, tables, serialRows);
    QVERIFY(choice.job == job);
    QCOMPARE(choice.pixels, 0);
    job.sampling.tolerance = 5;
    job.method.scale = 2;  // somebody chose already
    choice = chooseMethod(job, tables, serialRows);
    QVERIFY(choice.job == job);
  }

  /// Counted automatically, the samples of a pupil may be fewer; given, they stay.
  void takesFewerSamplesOfAPupil() {
    RenderJob job = sampleView();
    job.state.psf.windowSize = 1;
    job.state.pupil.diameter = 0.1;
    job.sampling.tolerance = 3;
    LensTables tables;
    const Choice fewer = chooseMethod(job, tables, serialRows);
    const auto points = [](const RenderJob& view) { return plan(view).aperture.points.size(); };
    QVERIFY2(points(fewer.job) < points(job), qPrintable(QString::number(points(fewer.job))));
    QVERIFY(rmse(rendered(fewer.job), rendered(job)) < fewer.limit + 0.02);
    QVERIFY(fewer.limit <= 3);
    job.state.pupil.samples = int(points(job));
    QCOMPARE(chooseMethod(job, tables, serialRows).job.state.pupil, job.state.pupil);
  }

  void theErrorStaysWithinTheLimit() {
    Random random(9);
    RenderJob job = sampleView();
    constexpr int scenes = 120;
    int cheaper = 0;
    int beyondLimit = 0;
    for (int repeat = 0; repeat < scenes; ++repeat) {
      vary(random, job);
      LensTables tables;
      const Choice choice = chooseMethod(job, tables, serialRows);
      const double error = rmse(rendered(choice.job), rendered(job));
      cheaper += choice.job.method != Method{} || choice.job.sampling != job.sampling ? 1 : 0;
      beyondLimit += error > choice.limit + 0.02 ? 1 : 0;
      QVERIFY(choice.limit <= job.sampling.tolerance);
      const int pixels = job.state.camera.res[0] * job.state.camera.res[1];
      QVERIFY(choice.pixels == 0 || (choice.pixels > pixels / 50 && choice.pixels < pixels / 8));
    }
    qInfo("%d of %d scenes beyond the limit, %d rendered cheaper", beyondLimit, scenes, cheaper);
    QVERIFY(beyondLimit <= scenes / 50);  // 99 % confidence, and what chance allows
    QVERIFY(cheaper > scenes / 4);
  }

  /// Against the reference engine itself.
  void theReferenceAgrees() {
    Random random(10);
    RenderJob job = sampleView();
    for (int repeat = 0; repeat < 6; ++repeat) {
      vary(random, job);
      job.state.camera.res = {150, 100};
      LensTables tables;
      const Choice choice = chooseMethod(job, tables, serialRows);
      QVERIFY(rmse(rendered(choice.job), simulate(job)) <= choice.limit + 0.05);
    }
  }

  void smallPicturesAreProbedWhole() {
    Random random(11);
    RenderJob job = sampleView();
    for (int repeat = 0; repeat < 20; ++repeat) {
      vary(random, job);
      job.state.camera.res = {random.integer(20, 45), random.integer(15, 30)};
      LensTables tables;
      const Choice choice = chooseMethod(job, tables, serialRows);
      if (choice.pixels == 0) continue;  // nothing was cheaper
      QCOMPARE(choice.pixels, job.state.camera.res[0] * job.state.camera.res[1]);
      QVERIFY(std::abs(rmse(rendered(choice.job), rendered(job)) - choice.rmse) < 0.02);
      QCOMPARE(choice.limit, choice.rmse);
    }
  }

  /// A larger tolerance is never dearer, and a huge one takes the cheapest there is: texels copied.
  void moreToleranceCostsLess() {
    RenderJob job = sampleView();
    job.state.psf = {0.9, 5};
    job.sampling.reconstruction = Reconstruction::quadrilinear;
    job.sampling.samplesPerPixel = 2;
    LensTables tables;
    const auto texels = [&](double tolerance) {
      job.sampling.tolerance = tolerance;
      const RenderJob chosen = chooseMethod(job, tables, serialRows).job;
      const int window = 2 * plan(chosen).psfReach + 1;
      const int corners = 1 << 2 * int(chosen.sampling.reconstruction);
      const int n = chosen.sampling.samplesPerPixel;
      return double(corners) * window * window * n * n / std::pow(chosen.method.scale, 2);
    };
    QCOMPARE(texels(0.01), 16.0 * 25 * 4);
    QVERIFY(texels(5) < 16.0 * 25 * 4);
    QCOMPARE(texels(100), 1.0);
    job.state.psf.windowSize = 1;
    job.sampling = {};
    job.sampling.tolerance = 100;  // texels are copied already
    QCOMPARE(chooseMethod(job, tables, serialRows).pixels, 0);
  }

  void threadsDoNotMatterAndStopIsHeard() {
    RenderJob job = sampleView();
    job.state.psf = {0.8, 7};
    job.sampling.tolerance = 5;
    LensTables tables;
    const ParallelRows threads = [](int count, const std::function<void(int, int)>& rows) {
      std::thread other([&] { rows(count / 2, count); });
      rows(0, count / 2);
      other.join();
    };
    const Choice one = chooseMethod(job, tables, serialRows);
    const Choice two = chooseMethod(job, tables, threads);
    QVERIFY(one.job == two.job && one.job.method != Method{});
    QCOMPARE(two.rmse, one.rmse);
    QCOMPARE(two.limit, one.limit);
    QVERIFY_THROWS_EXCEPTION(
        Cancelled, (void)chooseMethod(job, tables, serialRows, [](double) { return false; }));
  }

  void isTheSameEveryTime() {
    RenderJob job = sampleView();
    job.state.psf = {0.67, 5};
    job.sampling.tolerance = 6;
    LensTables tables;
    const Choice first = chooseMethod(job, tables, serialRows);
    const Choice second = chooseMethod(job, tables, serialRows);
    QVERIFY(first.job == second.job);
    QCOMPARE(first.rmse, second.rmse);
    QVERIFY(choiceText(first).find("with 99 % confidence") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(TestTolerance)
#include "test_adaptive_method.moc"
