// SPDX-License-Identifier: BSD-3-Clause
// Tests captures as scenes: on their own display they give their own bytes, on others what a
// brute-force loop finds along each ray.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/content/capture_content.h"
#include "core/engine/focus_search.h"
#include "core/engine/ideal_view.h"
#include "io/documents/session_file.h"
#include "io/plugins/plugin_library.h"
#include "io/scene/live_file.h"
#include "io/scene/view_source.h"
#include "io/store/light_field_store.h"
#include "io/store/store_writer.h"
#include "tests/core/rendered.h"
#include "tests/io/any_images.h"
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

class Silent : public plugin::Progress {
 public:
  [[nodiscard]] bool go(double) const override { return true; }
};

/// A store that counts its slices.
class InSlices : public LightFieldSource {
 public:
  explicit InSlices(const char* file) : m_store(file) {}
  [[nodiscard]] LightFieldSize size() const override { return m_store.size(); }
  [[nodiscard]] StoredType type() const override { return m_store.type(); }
  [[nodiscard]] std::shared_ptr<const LightField> slice(const ViewReads& reads,
                                                        const Progress& progress) const override {
    ++m_slices;
    return m_store.slice(reads, progress);
  }
  [[nodiscard]] std::shared_ptr<const LightField> overview() const override { return {}; }
  [[nodiscard]] int slices() const { return m_slices; }

 private:
  LightFieldStore m_store;
  mutable int m_slices = 0;
};

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

  void aPlaneIsFocusedOn_data() {
    QTest::addColumn<double>("depth");
    for (const double depth : {-0.11, -0.03, 0.04, 0.09}) QTest::addRow("%g m", depth) << depth;
  }
  /// A textured plane is found at its depth, and is then as sharp as on the capture's own display.
  void aPlaneIsFocusedOn() {
    QFETCH(double, depth);
    constexpr int hogels = 96, directions = 9;
    const double width = 0.24, most = std::tan(25 * M_PI / 180);
    // Waves of a tenth of the panel and shorter; the shortest has eight hogels.
    const auto texture = [&](double x, double y) {
      double sum = 0.5;
      for (const double wave : {0.02, 0.023, 0.031})
        sum += 0.15 * std::sin(2 * M_PI * x / wave + 3 * y / wave);
      return sum;
    };
    writeImageFile("plane.png", hogels * directions, hogels * directions, [&](int x, int y, int) {
      const auto place = [&](int at) { return ((at / directions + 0.5) / hogels - 0.5) * width; };
      const auto slope = [&](int at) {
        return (2 * (at % directions + 0.5) / directions - 1) * most;
      };
      return float(texture(place(x) + depth * slope(x), -place(y) - depth * slope(y)));
    });
    writeFile("plane.json", R"({"hogelscope": 1,
      "display": {"size": [0.24, 0.24], "hogels": [96, 96], "directions": [9, 9], "fov": [50, 50]},
      "lightField": {"file": "plane.png"},
      "cameras": [{"name": "a", "eye": [0.03, -0.02, 0.6], "res": [120, 120], "fov": 22}]})");
    writeFile("shown.json", contentOf("plane.json")
                                .replace(R"("file": "plane.png")",
                                         R"("layout": "live", "source": "session", "type": "real",
                                            "session": {"file": "plane.json"})"));
    const Session scene = loadSession("shown.json");
    const ViewSource shown = loadViewSource(scene, {});
    const auto live = std::dynamic_pointer_cast<const LiveSource>(shown.lightField);
    const auto& capture = dynamic_cast<const CaptureContent&>(live->content());
    const double unit = capture.depthOfOneHogel();
    QVERIFY(std::abs(unit - width / hogels / (2 * most / directions)) < 1e-12);
    LensTables tables;
    const auto at = [&](double focus) { return live->withContent(capture.focusedAt(focus)); };
    const auto found = sharpestContent(
        shown.job(scene.cameras[0]), 60, 50, 81, [&](double k) { return (k - 40) * unit / 4; }, at,
        tables, serialRows);
    QVERIFY(found.has_value());
    QVERIFY2(std::abs(*found - depth) < 0.3 * unit, qPrintable(QString::number(*found)));
    // Between the directions nothing is lost at that focus, and much is at the panel's.
    const auto contrast = [&](double focus) {
      RenderJob job = shown.job(scene.cameras[0]);
      job.lightField = at(focus);
      job.isIdeal = true;
      const FloatImage image = renderIdeal(job, tables, serialRows, {});
      double sum = 0, squares = 0;
      for (const float value : image.rgb) {
        sum += double(value);
        squares += double(value) * double(value);
      }
      const auto count = double(image.rgb.size());
      return std::sqrt(squares / count - sum / count * sum / count) / 255;
    };
    const double ofTexture = 0.15 * std::sqrt(1.5);
    QVERIFY2(contrast(*found) > 0.85 * ofTexture, qPrintable(QString::number(contrast(*found))));
    if (std::abs(depth) > 2 * unit) QVERIFY(contrast(0) < 0.8 * contrast(*found));
  }

  /// Captures of the program's own scene come nearer to it with more hogels and directions. At its
  /// edges the light jumps, so the mean error falls with the first power of their distance.
  void capturesConvergeToTheirScene() {
    double sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;  // of a line through logarithms
    constexpr std::array sizes{60, 90, 120, 160, 200};
    for (const int n : sizes) {
      const QByteArray hogels = QByteArray::number(n), views = QByteArray::number(n / 10);
      writeFile("live.json", R"({"hogelscope": 1,
        "display": {"size": [0.4, 0.4], "fov": [50, 50], "hogels": [)" +
                                 hogels + ", " + hogels + R"(], "directions": [)" + views + ", " +
                                 views + R"(]},
        "lightField": {"layout": "live", "source": "scene", "scene": {"depth": [-0.02, 0.02]}},
        "cameras": [{"name": "a", "eye": [0.05, 0.02, 0.7], "res": [150, 150], "fov": 30}]})");
      const Session session = loadSession("live.json");
      const ViewSource scene = loadViewSource(session, {});
      auto captured = std::make_shared<const LightField>(
          openLightField(session.lightField, session.display)->read({}));
      const auto content = std::make_shared<CaptureContent>();
      content->take(captured, scene.display, {});
      content->open({}, {".", 1}, Silent());
      RenderJob job = scene.job(session.cameras[0]);
      job.isIdeal = true;
      LensTables tables;
      const FloatImage wanted = renderIdeal(job, tables, parallelRows, {});
      job.lightField =
          std::dynamic_pointer_cast<const LiveSource>(scene.lightField)->withContent(content);
      const FloatImage found = renderIdeal(job, tables, parallelRows, {});
      double sum = 0;
      for (std::size_t k = 0; k < wanted.rgb.size(); ++k)
        sum += std::abs(double(wanted.rgb[k]) - double(found.rgb[k]));
      const double x = std::log(n), y = std::log(sum);
      sumX += x;
      sumY += y;
      sumXX += x * x;
      sumXY += x * y;
    }
    const double order = -(double(sizes.size()) * sumXY - sumX * sumY) /
                         (double(sizes.size()) * sumXX - sumX * sumX);
    QVERIFY2(order > 0.7 && order < 1.4, qPrintable(QString::number(order)));
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

  /// A store larger than memory is read slice by slice, and gives what one in memory gives.
  void storesAreReadBySlices() {
    writeCapture(noise);
    writeImageFile("big.png", 60 * 20, 50 * 20, [](int x, int y, int c) {
      return float(noise(x / 20, y / 20, x % 20, y % 20, c)) / 255;
    });
    const Session capture = loadSession(
        "capture.json",
        {"lightField.file=big.png", "display.hogels=[60,50]", "display.directions=[20,20]"});
    const PanelParams display = resolved({capture.display, notGiven}, {60, 50, 20, 20});
    const auto texels = loadViewSource(capture, {}).lightField;
    const auto file = openLightField(capture.lightField, capture.display);
    pack(*file, planPack(capture.lightField, *file, display, std::size_t{1} << 30), "a.tif", 3, {});
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-0.13, 0.13), slope(-0.5, 0.5);
    std::vector<plugin::Ray> rays(3000);
    for (plugin::Ray& ray : rays) {
      const double x = place(random), y = place(random), a = slope(random), b = slope(random);
      ray = {x + 0.2 * a, y + 0.2 * b, 0.2, a, b, 1};
    }
    const auto traced = [&](std::shared_ptr<const LightFieldSource> source) {
      ContentParams params = contentParamsOf("session");
      params.set("focus", std::vector<double>{0.04});
      const auto made = params.make();
      auto& content = dynamic_cast<CaptureContent&>(*made);
      content.take(std::move(source), display, {});
      content.open({}, {".", 1}, Silent());  // it places the panel
      std::vector<plugin::Colour> light(rays.size());
      for (std::size_t k = 0; k < rays.size(); k += 500)
        content.trace(std::span(rays).subspan(k, 500), std::span(light).subspan(k, 500));
      return light;
    };
    const auto inSlices = std::make_shared<const InSlices>("a.tif");
    const auto wanted = traced(texels), found = traced(inSlices);
    for (std::size_t k = 0; k < rays.size(); ++k) QCOMPARE(found[k].g, wanted[k].g);
    QVERIFY(inSlices->slices() > 6);  // rays from all over the capture are more than one slice
  }

  /// What a type that is not given is: that of the capture, but for 16 bits, which are not rounded.
  void typeIsThatOfTheCapture() {
    writeCapture(noise);
    (void)asScene();
    const auto typeOfScene = [](const QByteArray& type) {
      writeFile("typed.json", contentOf("scene.json").replace(R"("type": "real",)", type));
      const Session session = loadSession("typed.json");
      return openLightField(session.lightField, session.display)->type();
    };
    QCOMPARE(typeOfScene(""), StoredType::uint8);
    QCOMPARE(typeOfScene(R"("type": "real",)"), StoredType::real);
    const auto grey = [](int, int, int) { return 0.123F; };
    writeImageFile("hogels.png", nx * du, ny * dv, grey, {.type = PictureType::UInt16});
    QCOMPARE(typeOfScene(""), StoredType::real);
    QCOMPARE(typeOfScene(R"("type": "capture",)"), StoredType::real);
    QCOMPARE(typeOfScene(R"("type": "uint8",)"), StoredType::uint8);
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
