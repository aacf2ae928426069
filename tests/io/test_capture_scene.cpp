// SPDX-License-Identifier: BSD-3-Clause
// Tests captures as scenes: on their own display they give their own bytes, on others what a
// brute-force loop finds along each ray.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/content/capture_content.h"
#include "io/documents/session_file.h"
#include "io/scene/live_file.h"
#include "io/scene/view_source.h"
#include "tests/core/rendered.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

using namespace hogelscope;

namespace {

constexpr int nx = 12, ny = 10, du = 6, dv = 4;

/// Writes capture.json with hogels.png, of which channel c of texel (i, j, u, v) is `value`.
template <class Value>
void writeCapture(Value value, const QByteArray& more = {}) {
  writeImageFile("hogels.png", nx * du, ny * dv, [&](int x, int y, int c) {
    return float(value(x / du, y / dv, x % du, y % dv, c)) / 255;
  });
  writeFile("capture.json", R"({"hogelscope": 1,
    "display": {"size": [0.24, 0.2], "hogels": [12, 10], "directions": [6, 4], "fov": [50, 40]},
    "lightField": {"file": "hogels.png")" +
                                more + R"(},
    "cameras": [{"name": "a", "eye": [0.03, -0.02, 0.4], "res": [90, 80], "fov": 35},
                {"name": "leaks", "eye": [0, 0.05, 0.5], "res": [90, 80], "fov": 30,
                 "psf": {"sigma": 0.8, "windowSize": 3}},
                {"name": "pupil", "eye": [0, 0, 0.4], "res": [60, 50], "fov": 35,
                 "pupil": {"diameter": 0.01}}]})");
}

int noise(int i, int j, int u, int v, int c) {
  return (i * 7919 + j * 104729 + u * 1299709 + v * 15485863 + c * 31 + i * j * u * v) % 256;
}

/// Returns the capture's session with the capture shown as a scene on its own display.
Session asScene(const std::vector<std::string>& overrides = {}) {
  Session session = loadSession("capture.json");
  writeFile("scene.json", contentOf("capture.json")
                              .replace(R"("file": "hogels.png")",
                                       R"("layout": "live", "source": "session", "type": "real",
                                 "session": {"file": "capture.json"})"));
  return loadSession("scene.json", overrides);
}

/// Returns the light along a ray by the contract's sentences, with texels as `value` says.
template <class Value>
double bruteForce(const Value& value, double x, double y, double a, double b, double focus) {
  const double width = 0.24, height = 0.2;
  const double most[2] = {std::tan(25 * M_PI / 180), std::tan(20 * M_PI / 180)};
  const double u = (a / most[0] + 1) / 2 * du, v = (1 - b / most[1]) / 2 * dv;
  const auto isIn = [&](double px, double py) {
    return std::abs(px) < width / 2 && std::abs(py) < height / 2;
  };
  if (u < 0 || u >= du || v < 0 || v >= dv || !isIn(x, y)) return 0;
  const auto cell = [](double k, int count) { return std::clamp(int(k), 0, count - 1); };
  double sum = 0;
  for (int ku = 0; ku < 2; ++ku)
    for (int kv = 0; kv < 2; ++kv) {
      const double u0 = std::floor(u - 0.5), v0 = std::floor(v - 0.5);
      const double wu = ku ? u - 0.5 - u0 : 1 - (u - 0.5 - u0);
      const double wv = kv ? v - 0.5 - v0 : 1 - (v - 0.5 - v0);
      const int uk = cell(std::max(u0 + ku, 0.0), du), vk = cell(std::max(v0 + kv, 0.0), dv);
      const double ak = (2 * (uk + 0.5) / du - 1) * most[0];
      const double bk = (1 - 2 * (vk + 0.5) / dv) * most[1];
      const double xk = x + focus * a - focus * ak, yk = y + focus * b - focus * bk;
      if (!isIn(xk, yk)) continue;
      const double i = (xk / width + 0.5) * nx, j = (0.5 - yk / height) * ny;
      for (int ki = 0; ki < 2; ++ki)
        for (int kj = 0; kj < 2; ++kj) {
          const double i0 = std::floor(i - 0.5), j0 = std::floor(j - 0.5);
          const double wi = ki ? i - 0.5 - i0 : 1 - (i - 0.5 - i0);
          const double wj = kj ? j - 0.5 - j0 : 1 - (j - 0.5 - j0);
          sum +=
              wu * wv * wi * wj *
              value(cell(std::max(i0 + ki, 0.0), nx), cell(std::max(j0 + kj, 0.0), ny), uk, vk, 0);
        }
    }
  return sum;
}

}  // namespace

class TestCaptureScene : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QVERIFY(QDir::setCurrent(m_folder.path())); }

  /// Views, light leakage and pupils of its own display are those of the capture, to the byte.
  void itsOwnDisplayShowsItsBytes() {
    writeCapture(noise);
    for (const char* interpolates : {"false", "true"}) {
      const Session scene =
          asScene({std::string("lightField.session.interpolate=") + interpolates});
      const ViewSource shown = loadViewSource(scene, {});
      const ViewSource stored = loadViewSource(loadSession("capture.json"), {});
      for (const CameraState& state : scene.cameras)
        QVERIFY2(rendered(shown.job(state)).rgb == rendered(stored.job(state)).rgb,
                 state.camera.name.c_str());
    }
  }

  void raysAreThoseOfABruteForceLoop_data() {
    QTest::addColumn<double>("focus");
    QTest::newRow("panel") << 0.0;
    QTest::newRow("in front") << 0.05;
    QTest::newRow("behind") << -0.12;
  }
  void raysAreThoseOfABruteForceLoop() {
    QFETCH(double, focus);
    writeCapture(noise);
    const Session scene = asScene({"lightField.session.focus=" + std::to_string(focus)});
    LiveFile file(scene.lightField, scene.display);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-0.13, 0.13), slope(-0.5, 0.5);
    int lit = 0;
    for (int k = 0; k < 5000; ++k) {
      const double x = place(random), y = place(random), a = slope(random), b = slope(random);
      const double z = 0.2;  // a ray begins in front of the panel
      const std::array rays{plugin::Ray{x + a * z, y + b * z, z, a, b, 1}};
      std::array<plugin::Colour, 1> light;
      file.content().trace(rays, light);
      const double wanted = bruteForce(noise, x, y, a, b, focus);
      QVERIFY2(std::abs(double(light[0].r) - wanted) < 1e-4,
               qPrintable(QString("%1 %2 %3 %4: %5, not %6")
                              .arg(x)
                              .arg(y)
                              .arg(a)
                              .arg(b)
                              .arg(double(light[0].r))
                              .arg(wanted)));
      lit += wanted > 0 ? 1 : 0;
    }
    QVERIFY(lit > 1000);
  }

  /// What is linear in hogels and directions comes out linear on a display with other ones.
  void linearContentStaysLinear() {
    const auto ramp = [](int i, int j, int u, int v, int) {
      return 10 + 8 * i + 5 * j + 9 * u + 4 * v;
    };
    writeCapture(ramp);
    Session scene = asScene({"display.hogels=[31,17]", "display.directions=[9,7]",
                             "display.size=[0.2,0.16]", "display.fov=[40,30]"});
    const auto light = LiveFile(scene.lightField, scene.display).read({});
    const hogelscope::Display other({scene.display, notGiven}),
        own({loadSession("capture.json").display, notGiven});
    for (int k = 0; k < 500; ++k) {
      const TexelIndex at{k * 7 % 31, k * 5 % 17, k * 3 % 9, k % 7};
      const PanelRay ray = other.rayOf(at);
      const auto hit = own.hit({ray.position.x + ray.slopes.x, ray.position.y + ray.slopes.y, 1},
                               {-ray.slopes.x, -ray.slopes.y, -1});
      QVERIFY(hit.has_value());
      const double wanted =
          10 + 8 * (hit->i - 0.5) + 5 * (hit->j - 0.5) + 9 * (hit->u - 0.5) + 4 * (hit->v - 0.5);
      QVERIFY2(std::abs(light.texel(at).r - wanted) < 1e-3,
               qPrintable(QString("%1, not %2").arg(light.texel(at).r).arg(wanted)));
    }
  }

  /// Moved and enlarged, it is seen as by an eye that moves and shrinks the other way.
  void positionAndScaleAreThoseOfItsPanel() {
    writeCapture(noise);
    const Session scene =
        asScene({"lightField.session.position=[0.02,0.01,-0.1]", "lightField.session.scale=2"});
    LiveFile file(scene.lightField, scene.display);
    double back = 0, front = 0;
    file.content().depths(back, front);
    QCOMPARE(back, -0.1);
    QCOMPARE(front, -0.1);
    for (int k = 0; k < 500; ++k) {
      const double x = 0.0003 * (k - 250), y = 0.0002 * (k % 97 - 48);
      const double a = 0.001 * (k % 300 - 150), b = 0.001 * (k % 200 - 100);
      // The point of its panel, in its own size, is (x, y).
      const double z = 0.3;
      const std::array rays{
          plugin::Ray{0.02 + 2 * x + a * (z + 0.1), 0.01 + 2 * y + b * (z + 0.1), z, a, b, 1}};
      std::array<plugin::Colour, 1> light;
      file.content().trace(rays, light);
      QVERIFY(std::abs(double(light[0].r) - bruteForce(noise, x, y, a, b, 0)) < 1e-3);
    }
    // A ray that ends before it sees nothing, and no depth is invented.
    const std::array rays{plugin::Ray{0.02, 0.01, 0.3, 0, 0, 0.2}};
    std::array<plugin::Colour, 1> light;
    std::array<double, 1> depth{};
    file.content().trace(rays, light);
    QVERIFY(light[0].r == 0 && file.content().traceDepths(rays, depth) && std::isnan(depth[0]));
  }

  /// The share of the display's rays that the capture does not have.
  void whatIsOutsideIsSaid() {
    writeCapture(noise);
    const auto said = [](const std::vector<std::string>& overrides) {
      const Session scene = asScene(overrides);
      const std::vector<std::string> warnings = loadViewSource(scene, {}).warnings;
      return warnings.empty() ? QString() : QString::fromStdString(warnings.front());
    };
    QCOMPARE(said({}), QString());
    QCOMPARE(
        said({"display.size=[0.48,0.4]"}),
        QString("about 75 % of the display's rays are outside the capture, and black: it covers "
                "a panel of 0.24×0.2 m and a field of 50×40°"));
    QVERIFY(said({"lightField.session.scale=2"}).isEmpty());
    QVERIFY(said({"lightField.session.position=[0,0,-1]"}).contains("outside the capture"));
  }

  void refused_data() {
    QTest::addColumn<QByteArray>("object");
    QTest::addColumn<QString>("line");
    QTest::newRow("no file") << QByteArray(R"({})")
                             << "lightField.session.file: is missing: name the session";
    QTest::newRow("missing") << QByteArray(R"({"file": "none.json"})") << "none.json";
    QTest::newRow("itself") << QByteArray(R"({"file": "scene.json"})")
                            << "lightField.layout: is \"live\", which is no capture";
    QTest::newRow("scale") << QByteArray(R"({"file": "capture.json", "scale": 0})") << "scale";
  }
  void refused() {
    QFETCH(QByteArray, object);
    QFETCH(QString, line);
    writeCapture(noise);
    writeFile("scene.json",
              contentOf("capture.json")
                  .replace(R"("file": "hogels.png")",
                           R"("layout": "live", "source": "session", "session": )" + object));
    const QString error = errorOf([] {
      const Session session = loadSession("scene.json");
      (void)openLightField(session.lightField, session.display);
    });
    QVERIFY2(error.contains(line), qPrintable(error));
  }

  /// The capture's files are inputs, which no result replaces.
  void itsFilesAreInUse() {
    writeCapture(noise);
    const Session scene = asScene();
    std::vector<std::string> names;
    for (const auto& file : filesOf(scene)) names.push_back(file.filename().string());
    for (const char* name : {"capture.json", "hogels.png"})
      QVERIFY2(std::ranges::count(names, name) > 0, name);
  }

 private:
  QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestCaptureScene)
#include "test_capture_scene.moc"
