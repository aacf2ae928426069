// SPDX-License-Identifier: BSD-3-Clause
// Polynomials of a lens's strips lie within their error of the lens's points, and the kernel that
// finds cells from them finds those of the points, in every ray.
#include "core/lens/lens_strips.h"

#include <QTest>
#include <cmath>

#include "core/base/parallel.h"
#include "core/engine/fast_simulation.h"
#include "core/engine/lens_kernels.h"
#include "core/engine/row_kernels.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

const DistortionParams paperLens{0.6, 0.3, 0.2, 0.01, 0.2};  // its Fig. 3

LensKey keyOf(const DistortionParams& lens, int width, double fov) {
  CameraState state;
  state.distortion = lens;
  state.camera.res = {width, width};
  state.camera.fov = fov;
  LensKey key = lensKeyOf(state, {});
  key.hasStrips = true;
  return key;
}

/// Returns how far a point is from a strip's polynomial, less the rounding of this sum.
double distance(const std::array<LensStrips::Each, LensStrips::terms>& polynomials,
                std::size_t strip, double t, double point) {
  double sum = 0;
  double rounding = 0;
  for (std::size_t power = 0; power < LensStrips::terms; ++power) {
    const double term = polynomials[power][strip] * std::pow(t, double(power));
    sum += term;
    rounding += 1e-15 * std::abs(term);
  }
  return std::abs(sum - point) - rounding;
}

/// A display of which neighbouring texels differ.
RenderJob jobOf(const LightFieldSize& size) {
  RenderJob job;
  auto field = std::make_shared<LightField>(size, StoredType::uint8, LightField::standardBlock);
  for (int j = 0; j < size.ny; ++j)
    for (int v = 0; v < size.dv; ++v)
      for (int i = 0; i < size.nx; ++i)
        for (int u = 0; u < size.du; ++u) {
          const std::array<std::uint8_t, 3> rgb{std::uint8_t(i), std::uint8_t(j + 37 * v),
                                                std::uint8_t(u + i / 256)};
          field->set({i, j, u, v}, rgb.data());
        }
  job.lightField = field;
  job.display.hogels = {size.nx, size.ny};
  job.display.directions = {size.du, size.dv};
  return job;
}

/// The camera turns, moves and has another lens for each number.
RenderJob randomJob(std::uint64_t seed) {
  Random random(seed);
  RenderJob job = jobOf({random.integer(1, 400), 30, random.integer(1, 9), 5});
  job.display.size = {random.uniform(0.1, 0.8), random.uniform(0.1, 0.5)};
  job.display.fov = {random.uniform(10, 120), random.uniform(10, 120)};
  CameraState& state = job.state;
  state.camera.eye = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3),
                      random.uniform(0.05, 1)};
  state.camera.lookat = {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0};
  // Straight ahead all is exact but for rounding and the points.
  if (random.flip()) state.camera.lookat = {state.camera.eye.x, state.camera.eye.y, 0};
  state.camera.fov = random.uniform(5, 100);
  // Strips of some hundred pixels' width are as far from their points as is allowed.
  state.camera.res.fill(random.flip() ? random.integer(200, 450) : random.integer(60, 1100));
  const auto part = [&](double most) { return random.uniform(-most, most); };
  state.distortion = {part(0.3), part(0.1), part(0.1), part(0.01), part(0.01)};
  return job;
}

/// The strips that have a pixel's strip, and which of them it is.
std::pair<const LensStrips&, std::size_t> stripOf(const LensTable& table, int width, int x, int y) {
  const std::size_t strip = LensStrips::inRow(width) * std::size_t(y) + std::size_t(x / 64);
  return {table.strips()[strip / LensStrips::count], strip % LensStrips::count};
}

struct Counts {
  std::int64_t rays = 0;
  std::int64_t seen = 0;
};

/// Compares the texels that are copied by strips with those of the points.
QByteArray difference(const RenderJob& job, Counts& counts) {
  LensTables tables;
  const ViewRays view(job, tables, serialRows);
  if (view.lens() == nullptr || view.seesNothing()) return {};
  const auto& field = static_cast<const LightField&>(*job.lightField);
  const Texel<std::uint8_t>* texels = std::get<TexelArray<std::uint8_t>>(field.texels()).data();
  const std::optional<FixedMap> map = FixedMap::of(view.map(0));
  if (!map) return "no map";
  const int width = job.state.camera.res[0];
  const int height = job.state.camera.res[1];
  const auto pixels = std::size_t(width) * std::size_t(height);
  constexpr std::uint8_t notWritten = 77;
  std::vector<std::uint8_t> rgb(3 * pixels, notWritten), seen(pixels, notWritten);
  std::vector<std::uint8_t> expected = rgb, expectedSeen = seen;
  std::vector<RayRow> points, rows;
  for (int y = 0; y < height; y += std::max(1, height / 300)) {
    const double* xs = view.lens()->x(y, {});
    const double* ys = view.lens()->y(y, {});
    const std::size_t at = std::size_t(y) * std::size_t(width);
    points.push_back({xs, ys, width, &expected[3 * at], &expectedSeen[at]});
    rows.push_back(
        {xs, ys, width, &rgb[3 * at], &seen[at], {}, LensStrips::inRow(width) * std::size_t(y)});
  }
  copyRays(view.map(0), field.layout(), texels, false, points);
  copyLensRays(*map, field.layout(), texels, view.lens()->strips(), rows);
  if (seen != expectedSeen || rgb != expected) return "other pixels";
  counts.rays += std::int64_t(rows.size()) * width;
  counts.seen += std::ranges::count(seen, std::uint8_t{255});
  return {};
}

}  // namespace

class TestLensStrips : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pointsAreWithinTheError_data();
  void pointsAreWithinTheError();
  void withoutRaysThereIsNone();
  void cellsAreThoseOfThePoints();
  void bordersAreThoseOfThePoints();
};

void TestLensStrips::pointsAreWithinTheError_data() {
  QTest::addColumn<int>("width");
  for (const int width : {6, 63, 64, 65, 70, 600, 1024, 1030}) QTest::addRow("%d", width) << width;
}

void TestLensStrips::pointsAreWithinTheError() {
  QFETCH(int, width);
  const LensTable table(keyOf(paperLens, width, 60), serialRows);
  for (int y = 0; y < width; y += std::max(1, width / 20))
    for (int x = 0; x < width; ++x) {
      const auto [strips, strip] = stripOf(table, width, x, y);
      const double error = strips.error[strip];
      if (width - x / 64 * 64 < int(LensStrips::terms)) {
        QVERIFY(std::isinf(error));
        continue;
      }
      const double t = (x % 64 - 31.5) / 32;
      QVERIFY(distance(strips.x, strip, t, table.x(y, {})[x]) <= error);
      QVERIFY(distance(strips.y, strip, t, table.y(y, {})[x]) <= error);
      QVERIFY2(error < (width < 600 ? 1e-2 : 1e-8), qPrintable(QString::number(error)));
    }
}

/// Beyond the fold of a lens, whose pixels have no rays, its polynomials are 0.
void TestLensStrips::withoutRaysThereIsNone() {
  const LensTable table(keyOf({-0.5, 0, 0, 0, 0}, 600, 100), serialRows);
  int without = 0;
  for (int x = 0; x < 600; x += 64) {
    const auto [strips, strip] = stripOf(table, 600, x, 300);
    bool hasRays = true;
    for (int k = x; k < std::min(x + 64, 600); ++k) hasRays &= !std::isnan(table.x(300, {})[k]);
    QCOMPARE(std::isinf(strips.error[strip]), !hasRays);
    if (hasRays) continue;
    ++without;
    for (const LensStrips::Each& power : strips.x) QCOMPARE(power[strip], 0.0);
  }
  QVERIFY(without >= 2 && without < 10);
}

void TestLensStrips::cellsAreThoseOfThePoints() {
  Counts counts;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const QByteArray problem = difference(randomJob(seed), counts);
    QVERIFY2(problem.isEmpty(), QString("scene %1, ").arg(seed).toUtf8() + problem);
  }
  const double share = double(counts.seen) / double(counts.rays);
  QVERIFY2(counts.rays > 10'000'000 && share > 0.1, qPrintable(QString::number(share)));
}

/// Every second pixel's ray ends on a border of hogels, whose rounding the points decide.
void TestLensStrips::bordersAreThoseOfThePoints() {
  RenderJob job = jobOf({64, 64, 8, 8});
  job.display.size = {1, 1};
  job.display.fov = {90, 90};
  job.state.camera.eye = {0, 0, 0.5};
  job.state.camera.lookat = {0, 0, 0};
  job.state.camera.fov = 90;
  job.state.camera.res = {129, 129};
  job.state.distortion.k1 = 1e-17;
  Counts counts;
  QCOMPARE(difference(job, counts), QByteArray());
  QVERIFY(counts.seen > 120 * 120);
}

QTEST_GUILESS_MAIN(TestLensStrips)
#include "test_lens_strips.moc"
