// SPDX-License-Identifier: BSD-3-Clause
// Tests the program's jobs on pictures taken through lenslets.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/random_numbers.h"
#include "tests/cli/program.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"
#include "tests/io/lenslet_camera.h"

using namespace hogelscope;

namespace {

const QStringList asLenslets{"--set", "lightField.layout=lenslets", "--set",
                             "lightField.white=white.png"};

void writePicture(const QString& file, const LensletCamera& camera) {
  const std::vector<double> light = camera.picture();
  writeImageFile(file, camera.width, camera.height,
                 [&](int x, int y, int) { return float(0.8 * light[camera.indexOf(x, y)]); },
                 {PictureType::UInt16, 1, 0});
}

/// Spots 12 px apart, each up to 2 px off its place.
void writeSpots(const QString& file) {
  RandomNumbers random(5);
  constexpr std::size_t side = 180;
  std::vector<double> light(side * side);
  for (int j = 0; j < 15; ++j)
    for (int i = 0; i < 15; ++i) {
      const double x0 = 12 * i + 6 + 4 * random.unit() - 2;
      const double y0 = 12 * j + 6 + 4 * random.unit() - 2;
      for (int y = 12 * j; y < 12 * j + 12; ++y)
        for (int x = 12 * i; x < 12 * i + 12; ++x)
          if (std::hypot(x - x0, y - y0) < 4) light[side * std::size_t(y) + std::size_t(x)] = 0.8;
    }
  writeImageFile(file, int(side), int(side), [&](int x, int y, int) {
    return float(light[side * std::size_t(y) + std::size_t(x)]);
  });
}

}  // namespace

class TestLenslets : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    QVERIFY(QDir::setCurrent(m_folder.path()));
    LensletCamera camera;
    camera.width = 160;
    camera.height = 130;
    writePicture("white.png", camera);
    camera.farLight = [](double x, double y) { return 0.5 + 0.4 * std::cos(x + 2 * y); };
    writePicture("raw.png", camera);
    writeSpots("spots.png");
  }

  void info() {
    const Outcome words = run(QStringList{"--info", "raw.png"} + asLenslets, m_folder.path());
    QCOMPARE(words.status, 0);
    QVERIFY2(words.out.contains("layout      lenslets, a square grid\nhogels      9×7\n"
                                "directions  15×15\n"),
             words.out.constData());
    QVERIFY2(words.out.contains("\nlenslets    pitch 15.38") &&
                 words.out.contains(" px, rotation 0.69") &&
                 words.out.contains("\nresidual    0.0"),
             words.out.constData());
    const Outcome json =
        run(QStringList{"--info", "raw.png", "--json"} + asLenslets, m_folder.path());
    const QJsonObject document = QJsonDocument::fromJson(json.out).object();
    QCOMPARE(document["layout"].toString(), QString("lenslets"));
    const QJsonObject lattice = document["lenslets"].toObject();
    QVERIFY(std::abs(lattice["pitch"].toDouble() - 15.3846) < 2e-3);
    QVERIFY(std::abs(lattice["rotation"].toDouble() - 0.7) < 0.02);
    QVERIFY(lattice["residual"].toDouble() < 0.05 && lattice["count"].toInt() >= 30);
    QCOMPARE(lattice["origin"].toArray().size(), 2);
    // Without a word they are a guess; for another layout there are none.
    const Outcome guess = run({"--info", "raw.png"}, m_folder.path());
    QVERIFY2(guess.out.contains("layout      lenslets, a square grid\n") &&
                 guess.out.contains("\nassumed     lenslets on a square grid of pitch 15.3") &&
                 guess.out.contains(" px, found by their spots of light: likely\n"),
             guess.out.constData());
    const Outcome without =
        run({"--info", "raw.png", "--json", "--set", "lightField.layout=hogels", "--set",
             "display.hogels=[16,13]", "--set", "display.directions=[10,10]"},
            m_folder.path());
    QVERIFY(without.out.contains("hogels") && !without.out.contains("\"lenslets\""));
  }

  void jobs() {
    const Outcome made = run(QStringList{"--render", "--session", "raw.png", "--output", "a",
                                         "--save-session", "s.json"} +
                                 asLenslets,
                             m_folder.path());
    QCOMPARE(made.err, QByteArray());
    QCOMPARE(run({"--render", "--session", "s.json", "--output", "b"}, m_folder.path()).err,
             QByteArray());
    const auto picture = valuesOf<unsigned char>("a/View.png");
    QVERIFY(!picture.empty() && *std::max_element(picture.begin(), picture.end()) > 60);
    QCOMPARE(valuesOf<unsigned char>("b/View.png"), picture);
    QCOMPARE(run({"--pack", "s.json", "--output", "store.tif"}, m_folder.path()).status, 0);
    QCOMPARE(run({"--render", "--session", "store.tif", "--output", "c"}, m_folder.path()).status,
             0);
    QCOMPARE(valuesOf<unsigned char>("c/View.png"), picture);
    QVERIFY(QFile::copy("raw.png", "coded.png"));
    const Outcome report = run({"--report", "--session", "s.json", "--test", "coded.png", "--test",
                                "white.png", "--output", "r"},
                               m_folder.path());
    QCOMPARE(report.status, 0);
    const QByteArray summary = contentOf("r/summary.csv");
    QVERIFY2(summary.contains("coded.png,identical_views,1,"), summary.constData());
    QVERIFY2(summary.contains("white.png,identical_views,0,"), summary.constData());
    QCOMPARE(
        run({"--render", "--session", "s.json", "--output", "white.png"}, m_folder.path()).status,
        2);
  }

  void warnings() {
    const Outcome info =
        run({"--info", "spots.png", "--set", "lightField.layout=lenslets"}, m_folder.path());
    QVERIFY2(info.out.contains("\nwarning     spots.png: lenslets lie 1."), info.out.constData());
    const Outcome render = run({"--render", "--session", "spots.png", "--output", "d", "--set",
                                "lightField.layout=lenslets"},
                               m_folder.path());
    QCOMPARE(render.status, 0);
    QVERIFY2(render.err.startsWith("hogelscope: spots.png: warning: spots.png: lenslets lie 1.") &&
                 render.err.count('\n') == 1,
             render.err.constData());
    QCOMPARE(run({"--render", "--session", "raw.png", "--output", "e", "--set",
                  "lightField.layout=lenslets", "--set", "lightField.white=spots.png"},
                 m_folder.path())
                 .err,
             QByteArray("hogelscope: spots.png: size: is 180×180 px, but the light "
                        "field's is 160×130: give a picture of the same camera, cut alike\n"));
  }

 private:
  QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestLenslets)
#include "test_lenslets.moc"
