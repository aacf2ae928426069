// SPDX-License-Identifier: BSD-3-Clause
// Tests errors on part of the pixels: what is drawn, that its errors are those of the whole
// pictures there, and how often the interval has the error of all pixels.
#include "study/sampled_errors.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/parallel.h"
#include "core/engine/scaled_view.h"
#include "tests/core/random_scene.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

/// Noise whose contrast rises across the panel, so that errors differ from place to place.
std::shared_ptr<const LightField> content(Random& random) {
  auto field = std::make_shared<LightField>(LightFieldSize{60, 60, 8, 8}, StoredType::uint8);
  for (int j = 0; j < 60; ++j)
    for (int i = 0; i < 60; ++i) {
      const int contrast = i < 30 ? 4 : 4 * (i - 29);
      for (int v = 0; v < 8; ++v)
        for (int u = 0; u < 8; ++u) {
          std::array<std::uint8_t, 3> rgb{};
          for (std::uint8_t& value : rgb)
            value = std::uint8_t(128 + random.integer(-contrast, contrast));
          field->set({i, j, u, v}, rgb.data());
        }
    }
  return field;
}

RenderJob view(const std::shared_ptr<const LightField>& lightField, std::array<int, 2> res) {
  RenderJob job;
  job.lightField = lightField;
  job.display.hogels = {60, 60};
  job.display.directions = {8, 8};
  job.state.camera.res = res;
  return job;
}

/// Three sessions: a plain one of two views of different sizes, one with leakage and a lens, one
/// with a display that fills little of the picture.
std::vector<RenderJob> session(int which, Random& random) {
  const auto lightField = content(random);
  std::vector<RenderJob> views{view(lightField, {400, 300})};
  if (which == 0) {
    views.push_back(view(lightField, {200, 330}));
    views.back().state.camera.eye = {0.1, 0.05, 0.5};
  } else if (which == 1) {
    views[0].state.psf = {0.67, 5};
    views[0].state.distortion = {0.6, 0.4, 0, 0, 0.3};
  } else {
    views[0].state.camera.eye = {0.2, 0.1, 2};
  }
  return views;
}

double pixelsOf(const std::vector<RenderJob>& views) {
  double sum = 0;
  for (const RenderJob& job : views) sum += hogelscope::pixelsOf(job);
  return sum;
}

SampledErrors sampled(const std::vector<RenderJob>& views, std::vector<NamedMethod> methods,
                      Question question, std::uint64_t seed, int rounds) {
  SampledErrors errors(std::move(methods), {question}, pixelsOf(views), seed, parallelRows, {});
  for (const RenderJob& job : views) errors.add(job);
  errors.draw(std::max(rounds - errors.rounds(), 0));
  return errors;
}

/// Returns some methods of every kind, for the many repetitions.
std::vector<NamedMethod> fewMethods(const std::vector<RenderJob>& views) {
  std::vector<NamedMethod> few;
  for (const NamedMethod& method : methodsFor(views))
    for (const char* name :
         {"direct", "fixed point 2", "table 16 px", "PSF off", "bilinear", "half size"})
      if (method.name == name) few.push_back(method);
  return few;
}

}  // namespace

class TestSampledErrors : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Every pixel once, in rounds that are spread over the picture; other seeds, other blocks.
  void whatIsDrawn() {
    for (const std::array<int, 2> res : {std::array{1, 1}, {31, 5}, {600, 600}, {1000, 129}}) {
      const auto rounds = drawnBlocks(res, 7);
      QCOMPARE(int(rounds.size()), drawRounds);
      QVERIFY(!rounds.front().empty());
      std::vector<int> times(std::size_t(res[0]) * std::size_t(res[1]));
      const double share = double(times.size()) / drawRounds;
      double drawn = 0;
      for (std::size_t round = 0; round < rounds.size(); ++round) {
        for (const PixelBlock& block : rounds[round]) {
          for (int y = block.y0; y < block.y1; ++y)
            for (int x = block.x0; x < block.x1; ++x)
              ++times[std::size_t(y) * std::size_t(res[0]) + std::size_t(x)];
          drawn += block.pixels();
        }
        const double areas = std::ceil(res[0] / 64.0) * std::ceil(res[1] / 128.0);
        QVERIFY(std::abs(drawn - share * double(round + 1)) <= 128 * areas);
      }
      QVERIFY(std::ranges::all_of(times, [](int count) { return count == 1; }));
    }
    const auto first = [](std::uint64_t seed) { return drawnBlocks({600, 600}, seed)[0][3]; };
    std::set<std::pair<int, int>> places;
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
      places.insert({first(seed).x0, first(seed).y0});
    QVERIFY(places.size() > 10);
  }

  /// Each method's error on the drawn pixels is that of its whole picture there.
  void errorsAreThoseOfThePictures() {
    Random random(2);
    const std::vector<RenderJob> views = session(1, random);
    const RenderJob& job = views.front();
    const auto methods = methodsFor(views);
    for (const Question question : {Question::displayAsBuilt, Question::idealPicture}) {
      const auto few = std::vector(methods.begin(), methods.end());
      const SampledErrors drawn = sampled(views, few, question, 1, 0);
      const auto errors = drawn.errors(question);
      QVERIFY(drawn.rounds() < drawRounds);
      RenderJob ideal = job;
      if (question == Question::idealPicture)
        ideal.sampling = {.reconstruction = Reconstruction::quadrilinear, .samplesPerPixel = 8};
      const Image expected = question == Question::displayAsBuilt ? simulate(job) : rendered(ideal);
      for (std::size_t m = 0; m < few.size(); ++m) {
        const Image image = Renderer().render(applyMethod(few[m], job));
        double squares = 0, values = 0;
        const auto rounds = drawnBlocks(job.state.camera.res, 1);
        for (int round = 0; round < drawn.rounds(); ++round)
          for (const PixelBlock& block : rounds[std::size_t(round)])
            for (int y = block.y0; y < block.y1; ++y)
              for (int k = 3 * (y * 400 + block.x0); k < 3 * (y * 400 + block.x1); ++k, ++values)
                squares += std::pow(image.rgb[std::size_t(k)] - expected.rgb[std::size_t(k)], 2);
        QVERIFY2(std::abs(errors[m].square - squares / values) < 1e-9 * (1 + squares / values),
                 few[m].name.c_str());
        QVERIFY(errors[m].low <= errors[m].square && errors[m].high > errors[m].square);
      }
    }
  }

  /// In 95 of 100 repetitions, at least, on as few pixels as are ever drawn; and on half of them.
  void intervalsHaveTheTruth() {
    Random random(3);
    for (int which = 0; which < 3; ++which) {
      const std::vector<RenderJob> views = session(which, random);
      const auto methods = fewMethods(views);
      const Question question = Question::displayAsBuilt;
      const auto truth = sampled(views, methods, question, 1, drawRounds).errors(question);
      for (const int rounds : {0, drawRounds / 2}) {
        std::vector<int> hits(methods.size());
        double width = 0;
        const int seeds = rounds == 0 ? 100 : 10;
        for (int seed = 1; seed <= seeds; ++seed) {
          const auto found = sampled(views, methods, question, std::uint64_t(1000 * seed), rounds)
                                 .errors(question);
          for (std::size_t m = 0; m < methods.size(); ++m) {
            if (found[m].low <= truth[m].square && truth[m].square <= found[m].high) ++hits[m];
            if (found[m].low > 0)
              width +=
                  10 * std::log10(found[m].high / found[m].low) / seeds / double(methods.size());
          }
        }
        for (std::size_t m = 0; m < methods.size(); ++m) {
          qInfo("session %d, %d rounds, %s: %d of %d, %.2f dB wide on average", which, rounds,
                methods[m].name.c_str(), hits[m], seeds, width);
          QVERIFY2(hits[m] >= seeds * 95 / 100, methods[m].name.c_str());
        }
      }
    }
  }

  /// Errors of very few pixels may not be met: the interval says so.
  void rareErrors() {
    Random random(4);
    const auto lightField =
        std::make_shared<LightField>(LightFieldSize{60, 60, 8, 8}, StoredType::uint8);
    const std::array<std::uint8_t, 3> white{255, 255, 255};
    for (int v = 0; v < 8; ++v)
      for (int u = 0; u < 8; ++u) lightField->set({30, 30, u, v}, white.data());
    const std::vector<RenderJob> views{view(lightField, {400, 300})};
    const std::vector<NamedMethod> methods{
        {"half size", Reconstruction::nearest, 1, LensMapping::exact, {.scale = 2}}, {"PSF off"}};
    const Question question = Question::displayAsBuilt;
    const auto truth = sampled(views, methods, question, 1, drawRounds).errors(question);
    QVERIFY(truth[0].square > 0 && truth[1].square == 0);
    QCOMPARE(truth[0].low, truth[0].high);
    int hits = 0;
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      const SampledErrors errors = sampled(views, methods, question, seed, 0);
      QVERIFY(!errors.areKnown(0.3));
      const auto found = errors.errors(question);
      QCOMPARE(found[1].square, 0.0);
      QVERIFY(found[1].low == 0 && (found[1].high > 0 || found[0].square == 0));
      if (found[0].low <= truth[0].square && truth[0].square <= found[0].high) ++hits;
    }
    qInfo("%d of 50", hits);
  }

  /// The same for any number of threads, and for rounds in any portions.
  void sameEveryTime() {
    Random random(5);
    const std::vector<RenderJob> views = session(0, random);
    const auto methods = fewMethods(views);
    const Question question = Question::idealPicture;
    SampledErrors serial(methods, {question}, pixelsOf(views), 9, serialRows, {});
    for (const RenderJob& job : views) serial.add(job);
    for (const int rounds : {1, 3, 2}) serial.draw(rounds);
    const auto first = serial.errors(question);
    const auto second = sampled(views, methods, question, 9, serial.rounds()).errors(question);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      QVERIFY(std::abs(first[m].square / second[m].square - 1) < 1e-12);
      QVERIFY(std::abs(first[m].high / second[m].high - 1) < 1e-9);
      QCOMPARE(first[m].largest, second[m].largest);
    }
    serial.draw(1000);
    QCOMPARE(serial.rounds(), drawRounds);
    QCOMPARE(serial.pixels(), pixelsOf(views));
    QVERIFY(serial.areKnown(1e-9));
  }
};

QTEST_APPLESS_MAIN(TestSampledErrors)
#include "test_sampled_errors.moc"
