// SPDX-License-Identifier: BSD-3-Clause
// The depths of what pixels show: of a live plane against its own equation, and of views against
// the plane that they were made of.
#include "measure/content_depth.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/panel/design_numbers.h"
#include "measure/depth_budget_run.h"
#include "tests/core/live_content.h"

using namespace hogelscope;

namespace {

/// A textured plane z = height + rise · y.
class Ramp : public plugin::ContentSource {
 public:
  Ramp(double height, double rise, bool knowsDepths)
      : m_height(height), m_rise(rise), m_knowsDepths(knowsDepths) {}

  void describe(ParameterVisitor& v) override { v.group("ramp", "A plane."); }
  void open(const plugin::Panel&, const plugin::Place&, const plugin::Progress&) override {}
  void depths(double& back, double& front) const override {
    back = m_height - 0.3;
    front = m_height + 0.3;
  }
  void trace(std::span<const plugin::Ray> rays, std::span<plugin::Colour> colours) const override {
    for (std::size_t k = 0; k < rays.size(); ++k) {
      const double t = reachOf(rays[k]);
      colours[k] = {1, 2, 3};  // the background
      if (t < 0 || t > rays[k].reach) continue;
      const auto cell = [](double place, double size) { return std::floor(place / size); };
      const double x = rays[k].x - rays[k].a * t;
      const double y = rays[k].y - rays[k].b * t;
      const auto noise = [](double i, double j, double seed) {
        const double value = std::sin(12.9898 * i + 78.233 * j + seed) * 43758.5453;
        return float(std::floor(255 * (value - std::floor(value))));
      };
      const double i = cell(x, 0.011);
      const double j = cell(y, 0.011);
      colours[k] = {noise(i, j, 1), noise(i, j, 2), noise(i, j, 3)};
    }
  }
  [[nodiscard]] bool traceDepths(std::span<const plugin::Ray> rays,
                                 std::span<double> depths) const override {
    if (!m_knowsDepths) return false;
    for (std::size_t k = 0; k < rays.size(); ++k) depths[k] = rays[k].z - reachOf(rays[k]);
    return true;
  }

 private:
  /// z − t = height + rise (y − b t)
  [[nodiscard]] double reachOf(const plugin::Ray& ray) const {
    return (ray.z - m_height - m_rise * ray.y) / (1 - m_rise * ray.b);
  }

  double m_height;
  double m_rise;
  bool m_knowsDepths;
};

constexpr double height = -0.06;
constexpr double rise = 0.5;

PanelParams displayOf(int hogels, int directions, double fov) {
  PanelParams display;
  display.size = {0.4, 0.3};
  display.hogels = {hogels, 3 * hogels / 4};
  display.directions = {directions, directions};
  display.fov = {fov, fov};
  return display;
}

CameraState stateAt(const Vec3& eye) {
  CameraState state;
  state.camera.eye = eye;
  state.camera.fov = 30;
  state.camera.res = {60, 45};
  return state;
}

/// The whole light field of a ramp in memory.
std::shared_ptr<const LightFieldSource> viewsOf(const PanelParams& display, double slant) {
  LiveParams smooth;
  smooth.samples = 16;
  const auto live = liveSource(std::make_shared<Ramp>(height, slant, true), display, smooth);
  const auto [nx, ny, du, dv] = live->size();
  return live->slice(readsOfRows(live->size(), {0, ny - 1}, {0, du - 1}, {0, dv - 1}), {});
}

}  // namespace

class TestContentDepth : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void ofALivePlane_data() {
    QTest::addColumn<bool>("knowsDepths");
    QTest::newRow("content that knows its depths") << true;
    QTest::newRow("content that is cut") << false;
  }

  void ofALivePlane() {
    QFETCH(bool, knowsDepths);
    const PanelParams display = displayOf(48, 16, 54);
    CameraState state = stateAt({0.03, 0.02, 0.6});
    state.pupil.diameter = 0.01;  // the middle of the pupil counts
    RenderJob job{
        liveSource(std::make_shared<Ramp>(height, rise, knowsDepths), display), display, {}, state};
    LensTables tables;
    const PixelDepths depths = depthsOf(job, tables, {});
    const Camera camera(state.camera);
    const auto [width, high] = state.camera.res;
    std::size_t seen = 0;
    for (int y = 0; y < high; ++y)
      for (int x = 0; x < width; ++x) {
        const auto at = std::size_t(y * width + x);
        if (depths.seen[at] == 0) {
          QVERIFY(std::isnan(depths.z[at]));
          continue;
        }
        ++seen;
        const Vec2 p = camera.normalised(x, y);
        const Vec3 d = camera.worldFromCamera().direction({p.x, p.y, 1});
        const Vec3& eye = state.camera.eye;
        const double t = (height + rise * eye.y - eye.z) / (d.z - rise * d.y);
        const double exact = eye.z + t * d.z;
        const double tolerance = knowsDepths ? 1e-9 : 0.6 * 1.02 / 1024;
        QVERIFY2(std::abs(depths.z[at] - exact) < tolerance,
                 qPrintable(QString::number(depths.z[at]) + " " + QString::number(exact)));
      }
    QVERIFY(seen > 1000);
  }

  void ofBackground() {
    const PanelParams display = displayOf(48, 16, 54);
    const std::vector<LivePlane> planes{{-0.1, [](double x, double) { return x < 0 ? 200 : -1; }}};
    LensTables tables;
    const PixelDepths depths = depthsOf({liveSource(std::make_shared<LivePlanes>(planes), display),
                                         display,
                                         {},
                                         stateAt({0, 0, 0.6})},
                                        tables, {});
    QVERIFY(std::abs(depths.z[45 / 2 * 60 + 20] + 0.1) < 1e-3);
    QVERIFY(std::isnan(depths.z[45 / 2 * 60 + 40]));
    QCOMPARE(depths.seen[45 / 2 * 60 + 40], std::uint8_t(1));
  }

  void ofViews_data() {
    QTest::addColumn<double>("viewingDistance");
    QTest::addColumn<int>("rows");
    QTest::newRow("parallel") << notGiven << 9;
    QTest::newRow("converging") << 0.6 << 9;
    QTest::newRow("one row of cameras") << notGiven << 1;
  }

  /// The shift of a ramp's texture from view to view, in every hogel; the scene is rendered by the
  /// live light field, which knows nothing of disparities.
  void ofViews() {
    QFETCH(double, viewingDistance);
    QFETCH(int, rows);
    PanelParams display = displayOf(160, 9, 12);
    display.directions[1] = rows;
    if (rows == 1) display.fov[1] = 1;
    display.viewingDistance = viewingDistance;
    const auto views = viewsOf(display, rise);
    const HogelDepths depths = depthsByDisparity(*views, display, {4, rows / 2}, {});
    QCOMPARE(depths.scale, 1);
    const Display panel(display);
    std::vector<double> errors;
    std::size_t known = 0;
    for (int j = 8; j < 112; ++j)
      for (int i = 8; i < 152; ++i) {
        const double z = depths.at(i, j);
        if (std::isnan(z)) continue;
        ++known;
        const auto [place, slopes] = panel.rayOf({i, j, 4, rows / 2});
        const double exact = (height + rise * place.y) / (1 - rise * slopes.y);
        errors.push_back(std::abs(disparityOf(z, display, {4, rows / 2})[0] -
                                  disparityOf(exact, display, {4, rows / 2})[0]));
      }
    std::ranges::sort(errors);
    QVERIFY2(known > 0.8 * 104 * 144, qPrintable(QString::number(known)));
    const double nine = errors[errors.size() * 9 / 10];
    QVERIFY2(nine < (rows == 1 ? 0.08 : 0.05), qPrintable(QString::number(nine)));
  }

  void ofLargeViews() {
    const PanelParams display = displayOf(600, 5, 12);
    const auto views = viewsOf(display, 0);
    const HogelDepths depths = depthsByDisparity(*views, display, {2, 2}, {});
    QCOMPARE(depths.scale, 3);
    QCOMPARE(depths.width, 200);
    std::vector<double> z = depths.z;
    std::erase_if(z, [](double value) { return std::isnan(value); });
    QVERIFY(z.size() > depths.z.size() / 2);
    std::ranges::sort(z);
    QVERIFY(std::abs(z[z.size() / 2] - height) < 0.002);
    QCOMPARE(depths.at(599, 449), depths.z.back());
  }

  void withoutTexture() {
    const PanelParams display = displayOf(64, 5, 12);
    const LightField black(Display(display).size(), StoredType::uint8);
    const auto shared = std::make_shared<LightField>(black);
    const HogelDepths depths = depthsByDisparity(*shared, display, {2, 2}, {});
    QVERIFY(std::ranges::all_of(depths.z, [](double z) { return std::isnan(z); }));
    PanelParams one = displayOf(64, 1, 12);
    const auto single = std::make_shared<LightField>(Display(one).size(), StoredType::uint8);
    QVERIFY_EXCEPTION_THROWN((void)depthsByDisparity(*single, one, {0, 0}, {}), InputError);
  }

  void figures() {
    PixelDepths depths;
    const DepthLimits limits{0.3, 1, 0.5, 0.3};
    for (const double dioptres : {-2.5, -0.9, -0.4, 0.0, 0.1, 0.2, 0.3, 0.6, 2.1, 0.4})
      depths.z.push_back(depthAt(dioptres, limits.distance));
    depths.z.insert(depths.z.end(), {std::nan(""), 0.7, std::nan("")});  // 0.7: behind the eye
    depths.seen.assign(13, 1);
    depths.seen.back() = 0;
    const DepthFigures figures = depthFigures("a", depths, limits, 0.6);
    QCOMPARE(figures.known, 10.0 / 12);
    QCOMPARE(figures.insideDisplay, 0.8);
    QCOMPARE(figures.inside, 0.6);
    QCOMPARE(figures.ghosts, 0.2);
    QVERIFY(std::abs(figures.interval[0]) < 1e-12);
    QVERIFY(std::abs(figures.interval[1] - 0.6) < 1e-12);
    const DepthBars bars = depthBars(figures, 2);
    QVERIFY(std::abs(std::accumulate(bars.shares.begin(), bars.shares.end(), 0.0) - 1) < 1e-12);
    QCOMPARE(bars.shares.back(), 0.1);
    QCOMPARE(bars.shares.front(), 0.1);
    QVERIFY(std::abs(bars.middle(80) - 0.0125) < 1e-12);
  }

  void shearOfMostPixels_data() {
    QTest::addColumn<double>("viewingDistance");
    QTest::addColumn<double>("eye");
    QTest::newRow("parallel rays") << notGiven << 0.6;
    QTest::newRow("cameras beyond the eye") << 0.8 << 0.6;
    QTest::newRow("an eye beyond the cameras") << 0.5 << 3.0;
  }

  /// Brute force over all shears: none has more pixels inside than the proposed one.
  void shearOfMostPixels() {
    QFETCH(double, viewingDistance);
    QFETCH(double, eye);
    Session session;
    session.lightField.layout = Layout::views;
    session.lightField.viewingDistance = viewingDistance;
    PanelParams display = displayOf(48, 9, 30);
    display.viewingDistance = viewingDistance;
    const DepthLimits limits{eye, 0.25, 0.5, 0.3};
    DepthFigures figures{"a", limits, {}, {}};
    for (int k = 0; k < 40; ++k) figures.dioptres.push_back(-0.3 - 0.0008 * k);  // just outside
    for (int k = 0; k < 30; ++k) figures.dioptres.push_back(-0.2 + 0.015 * k);
    std::ranges::sort(figures.dioptres);
    const auto shareAt = [&](double shift) {
      int inside = 0;
      for (const double dioptres : figures.dioptres) {
        const double z = depthAt(dioptres, eye);
        if (viewingDistance != notGiven && z >= viewingDistance) continue;
        const double place = disparityOf(z, display, {4, 4})[0] + shift;
        // The depth at which disparityOf() is that.
        const double unit = disparityOf(1e-6, display, {4, 4})[0] / 1e-6;
        const double t = place / unit;
        const double moved =
            viewingDistance == notGiven ? t : t * viewingDistance / (viewingDistance + t);
        const double seen = 1 / (eye - moved) - 1 / eye;
        inside += moved < eye && std::abs(seen) <= 0.25 * (1 + 1e-6) ? 1 : 0;
      }
      return inside / 70.0;
    };
    figures.inside = shareAt(0);
    figures.interval = {figures.dioptres.front(), figures.dioptres.back()};
    std::string obstacle;
    const auto proposal = proposedFit(session, display, figures, obstacle);
    QVERIFY2(proposal, obstacle.c_str());
    const double shear = proposal->session.lightField.shear[0];
    const double own = shareAt(shear);
    double best = 0;
    for (int k = -4000; k <= 4000; ++k) best = std::max(best, shareAt(0.002 * k));
    const std::string text = std::to_string(figures.inside) + " " + std::to_string(own) + " " +
                             std::to_string(best) + " " + std::to_string(shear);
    QVERIFY2(own >= best && own > figures.inside, text.c_str());
  }
};

QTEST_GUILESS_MAIN(TestContentDepth)
#include "test_content_depth.moc"
