// SPDX-License-Identifier: BSD-3-Clause
// A view from a slice of the light field, fetched or kept while the light field passes, is the view
// from all of it, over random scenes with all options.
#include "core/light_field/footprint.h"

#include <QTest>
#include <algorithm>

#include "core/engine/scaled_view.h"
#include "core/engine/streaming_renderer.h"
#include "tests/core/random_twin.h"
#include "tests/core/rendered.h"

using namespace hogelscope;

namespace {

/// Displays with enough rows of hogels for some to be given up while others come; twins from 31 on.
RandomScene sceneOf(std::uint64_t seed) {
  Random random(seed);
  RandomScene scene = randomSampledScene(random);
  scene.job.display.hogels = {random.integer(1, 30), random.integer(1, 60)};
  fillDisplay(random, scene);
  scene.job.state.camera.res = {random.integer(20, 300), random.integer(10, 40)};
  if (seed > 30) addTwin(random, scene);
  return scene;
}

/// The rows of the hogel image in their order, each to `row(j, v, values)`.
template <class Row>
void pass(const LightField& lightField, Row row) {
  const auto [nx, ny, du, dv] = lightField.size();
  std::visit(
      [&, nx = nx, ny = ny, du = du, dv = dv](const auto& texels) {
        using T = std::decay_t<decltype(texels[0].r)>;
        for (int y = 0; y < ny * dv; ++y) {
          std::vector<T> values;
          for (int x = 0; x < nx * du; ++x) {
            const auto& t = texels[lightField.layout().address({x / du, y / dv, x % du, y % dv})];
            values.insert(values.end(), {t.r, t.g, t.b});
          }
          row(y / dv, y % dv, values.data());
        }
      },
      lightField.texels());
}

/// Hands out slices with exactly the texels that are asked for.
class Cutter : public LightFieldSource {
 public:
  explicit Cutter(const LightFieldSource& whole) : m_whole(whole.slice({}, {})) {}

  [[nodiscard]] LightFieldSize size() const override { return m_whole->size(); }
  [[nodiscard]] StoredType type() const override { return m_whole->type(); }

  [[nodiscard]] std::shared_ptr<const LightField> slice(const ViewReads& reads,
                                                        const Progress&) const override {
    const Footprint footprint = reads.footprint();
    auto slice =
        std::make_shared<LightField>(m_whole->size(), m_whole->type(), sliceLayout(footprint));
    pass(*m_whole, [&](int j, int v, const auto* rgb) {
      const CellRange& needed = footprint.v[std::size_t(j)];
      if (needed.first <= v && v <= needed.last) slice->takeRow(j, v, rgb);
    });
    texels += footprint.texels();
    return slice;
  }

  /// Every third hogel and direction.
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override {
    const auto third = [](int cells) { return (cells + 2) / 3; };
    const auto [nx, ny, du, dv] = m_whole->size();
    const LightFieldSize size{third(nx), third(ny), third(du), third(dv)};
    LightField::Values values;
    std::visit(
        [&](const auto& from) {
          std::vector<std::decay_t<decltype(from[0].r)>> list;
          for (int y = 0; y < size.ny * size.dv; ++y)
            for (int x = 0; x < size.nx * size.du; ++x) {
              const auto& t = from[m_whole->layout().address(
                  {3 * (x / size.du), 3 * (y / size.dv), 3 * (x % size.du), 3 * (y % size.dv)})];
              list.insert(list.end(), {t.r, t.g, t.b});
            }
          values = std::move(list);
        },
        m_whole->texels());
    return std::make_shared<const LightField>(size, values);
  }

  mutable std::size_t texels = 0;

 private:
  std::shared_ptr<const LightField> m_whole;
};

RenderJob with(RenderJob job, std::shared_ptr<const LightFieldSource> lightField) {
  job.lightField = std::move(lightField);
  return job;
}

RenderJob streamed(const RenderJob& job) {
  return with(job, std::make_shared<const StreamedLightField>(job.lightField->size(),
                                                              job.lightField->type()));
}

}  // namespace

class TestFootprint : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aFetchedViewIsTheView();
  void aPassingViewIsTheView();
  void aViewNeedsLittle();
  void placesAreTakenAgainOnlyWhenTheyAreFree();
  void singleTexelsAreFetched();
  void aFirstLookIsAtTheOverview();
};

void TestFootprint::aFetchedViewIsTheView() {
  int seen = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const RandomScene scene = sceneOf(seed);
    const Image whole = rendered(scene.job);
    const RenderJob job = with(scene.job, std::make_shared<Cutter>(*scene.job.lightField));
    QVERIFY2(rendered(job) == whole, qPrintable(QString("scene %1").arg(seed)));
    seen += int(std::count(whole.seen.begin(), whole.seen.end(), 255));
  }
  QVERIFY2(seen > 3000, qPrintable(QString::number(seen)));
}

void TestFootprint::aPassingViewIsTheView() {
  std::size_t kept = 0;
  std::size_t all = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const RandomScene scene = sceneOf(seed);
    LensTables tables;
    StreamingRenderer passing(streamed(scene.job), tables, serialRows);
    passing.begin(tables, serialRows);
    pass(*scene.job.lightField->overview(), [&](int j, int v, const auto* rgb) {
      if (v == 0 && j > 0) passing.finish(j - 1);
      passing.take(j, v, rgb);
    });
    passing.finish(scene.job.lightField->size().ny - 1);
    all += passing.footprint().texels() * memoryBytes(scene.job.lightField->type());
    kept += passing.bytes();
    QVERIFY2(passing.takeImage() == rendered(scene.job), qPrintable(QString("scene %1").arg(seed)));
  }
  QVERIFY2(kept < all, qPrintable(QString("%1 of %2 bytes").arg(kept).arg(all)));
}

/// Before an upright camera each column of hogels shows the same few u in all its rows, and a row
/// of pixels meets one or two rows of hogels.
void TestFootprint::aViewNeedsLittle() {
  Random random(1);
  RandomScene scene;
  scene.job.display.hogels = {60, 50};
  scene.job.display.directions = {60, 50};
  scene.job.display.fov = {90, 90};
  scene.job.display.size = {0.6, 0.5};
  scene.job.state.camera.eye = {0, 0, 1};
  scene.job.state.camera.fov = 60;
  scene.job.state.camera.res = {400, 400};
  scene.job.state.psf.windowSize = 1;
  scene.content.size = {60, 50, 60, 50};
  fillWithNoise<std::uint8_t>(random, scene, 0, 256, 1);
  const auto cutter = std::make_shared<Cutter>(*scene.job.lightField);
  QVERIFY(rendered(with(scene.job, cutter)) == rendered(scene.job));
  // u changes by 0.01·60/2 = 0.3 from column to column: at most two a column, 77 or so in all.
  const StreamingRenderer passing = [&] {
    LensTables tables;
    return StreamingRenderer(streamed(scene.job), tables, serialRows);
  }();
  QVERIFY2(passing.bytes() < 4 * cutter->texels / 10,
           qPrintable(QString("%1 of %2 bytes").arg(passing.bytes()).arg(4 * cutter->texels)));
  QVERIFY2(cutter->texels < 2 * 60 * 2 * 50 && cutter->texels >= 60 * 50,
           qPrintable(QString::number(cutter->texels)));
}

/// Brute force: at each row's coming its places are free, and they stay its own until its last use.
void TestFootprint::placesAreTakenAgainOnlyWhenTheyAreFree() {
  Random random(7);
  for (int k = 0; k < 300; ++k) {
    const int ny = random.integer(1, 40);
    Footprint footprint(1, 0);
    footprint.u[0] = {0, 0};
    std::vector<int> lastUse;
    for (int j = 0; j < ny; ++j) {
      const int first = random.integer(0, 9);
      footprint.v.push_back({first, first + random.integer(-1, 6)});
      lastUse.push_back(std::min(j + random.integer(0, random.integer(0, 9)), ny - 1));
    }
    const SliceLayout layout = rollingLayout(footprint, lastUse);
    std::vector<int> ownedUntil(layout.texels, -1);
    for (int j = 0; j < ny; ++j) {
      const auto [first, last] = footprint.v[std::size_t(j)];
      const int until = *std::max_element(lastUse.begin(), lastUse.begin() + j + 1);
      for (int v = first; v <= last; ++v) {
        const std::uint32_t at =
            layout.columnStart[0] + layout.rowStart[std::size_t(j)] + std::uint32_t(v);
        QVERIFY(at < layout.texels);
        QVERIFY(ownedUntil[at] < j);
        ownedUntil[at] = until;
      }
    }
  }
}

void TestFootprint::singleTexelsAreFetched() {
  const RandomScene scene = sceneOf(3);
  const RenderJob job = with(scene.job, std::make_shared<Cutter>(*scene.job.lightField));
  const auto [nx, ny, du, dv] = job.lightField->size();
  const TexelIndex last{nx - 1, ny - 1, du - 1, dv - 1};
  QVERIFY(job.lightField->texel(last) == scene.job.lightField->texel(last));
  QVERIFY(hogelTexels(*job.lightField, 0, 0) == hogelTexels(*scene.job.lightField, 0, 0));
}

/// Content that changes slowly over hogels and directions looks nearly the same in it.
void TestFootprint::aFirstLookIsAtTheOverview() {
  RandomScene scene;
  scene.job.display.hogels = {60, 60};
  scene.job.display.directions = {30, 30};
  scene.job.state.camera.eye = {0.05, 0.02, 0.6};
  scene.job.state.camera.res = {60, 60};
  const LightFieldSize size{60, 60, 30, 30};
  std::vector<std::uint8_t> values;
  for (int y = 0; y < 1800; ++y)
    for (int x = 0; x < 1800; ++x)
      for (const int value : {x / 30 * 4, y / 30 * 4, x % 30 * 8})
        values.push_back(std::uint8_t(value));
  scene.job.lightField = std::make_shared<const LightField>(size, values);
  QVERIFY(overview(scene.job) == scene.job);
  const auto cutter = std::make_shared<Cutter>(*scene.job.lightField);
  const Image first = rendered(overview(with(scene.job, cutter)));
  QCOMPARE(cutter->texels, std::size_t(0));
  const Image whole = rendered(scene.job);
  QVERIFY(first.seen == whole.seen);
  for (std::size_t k = 0; k < whole.rgb.size(); ++k)
    QVERIFY(std::abs(first.rgb[k] - whole.rgb[k]) <= 3 * 8);
  QVERIFY(first != whole);
}

QTEST_APPLESS_MAIN(TestFootprint)
#include "test_footprint.moc"
