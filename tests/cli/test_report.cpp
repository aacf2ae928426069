// SPDX-License-Identifier: BSD-3-Clause
// Tests --report: its numbers, its page, its gate, and what may be compared.
#include <QDirIterator>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <cmath>

#include "core/base/colour_map.h"
#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/cli/views.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

constexpr const char* header = "state,test,mse,psnr,mse_seen,psnr_seen,ssim,seen,eye_x,eye_y,eye_z";

/// 16×16 hogels of 8×8 directions.
float content(int x, int y, int channel) {
  return float((x * 5 + y * 3 + channel * 40 + (x / 16) * (y / 8)) % 200 + 20) / 255;
}

/// The same with some noise of at most 15 code values.
float noisy(int x, int y, int channel) {
  return content(x, y, channel) + float((x * 7919 + y * 104729 + channel) % 16) / 255;
}

// No raw strings before the class: moc would not find it.
const QByteArray cameras =
    "[{\"name\": \"a, \\\"b\\\"\", \"eye\": [0.1, -0.05, 0.6], \"fov\": 50, \"res\": [40, 30]},"
    " {\"name\": \"<i>&\", \"eye\": [0, 0, 0.5], \"fov\": 40, \"res\": [30, 30],"
    "  \"psf\": {\"sigma\": 0.7, \"windowSize\": 7}},"
    " {\"name\": \"behind\", \"eye\": [0, 0, -1], \"fov\": 40, \"res\": [20, 20]}]";

std::vector<std::vector<double>> metricsOf(const Session& session, const Session& test) {
  const std::vector<Image> references = simulated(session);
  const std::vector<Image> others = simulated(test);
  std::vector<std::vector<double>> metrics;
  for (std::size_t k = 0; k < references.size(); ++k)
    metrics.push_back(MetricSet().compare(references[k], others[k]));
  return metrics;
}

QStringList job(const QStringList& more) {
  return QStringList{"--report", "--session", "s.json", "--output", "out"} + more;
}

}  // namespace

class TestReport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void table();
  void testIsASession();
  void testIsAFolder();
  void testIsAFolderOfAnotherLayout();
  void testIsAnImageOfAnotherLayout();
  void pictures();
  void sideBySide();
  void sideBySideOfSmallPictures();
  void lossyReference();
  void page();
  void pageToLookAround();
  void summary();
  void toleranceIsLeftAside();
  void lightFieldsThatPassBy();
  void gate_data();
  void gate();
  void gateIsOverWhatIsSeen();
  void tenBitsAgainstTheirCopy();
  void sixteenBitsThatPassBy();
  void badTestsAreToldFirst_data();
  void badTestsAreToldFirst();

 private:
  Outcome report(const QStringList& more) { return run(job(more), m_folder->path()); }

  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestReport::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
  writeImageFile("a.png", 128, 128, content);
  writeImageFile("b.png", 128, 128, noisy);
  writeFile("s.json", text({.display = R"({"hogels": [16, 16], "directions": [8, 8]})",
                            .lightField = R"({"file": "a.png"})",
                            .cameras = cameras}));
}

void TestReport::table() {
  const Outcome outcome = report({"--test", "b.png", "--test", "a.png"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.status, 0);
  QCOMPARE(namesIn("out"), (QStringList{"metrics.csv", "panel_error", "plots", "report.csv",
                                        "report.html", "summary.csv", "views"}));
  QStringList figures;
  for (const char* test : {"test1_b", "test2_a"})
    for (const char* kind : {"above", "angle", "directions", "front", "hogels", "ranks", "views"})
      for (const char* ending : {".csv", ".svg", "_page.svg"})
        figures << QString("%1_%2%3").arg(test).arg(kind).arg(ending);
  for (const char* name : {"test2_a_angle.csv", "test2_a_angle.svg", "test2_a_angle_page.svg"})
    figures.removeOne(name);  // identical: no PSNR is a number
  QCOMPARE(namesIn("out/plots"), QStringList{"means.tex"} + figures + QStringList{"tests.csv"});
  QCOMPARE(contentOf("out/plots/tests.csv"),
           QByteArray("number,test,plots\n1,b.png,test1_b\n2,a.png,test2_a\n"));
  for (const QString& name : figures) {
    const QByteArray content = contentOf("out/plots/" + name);
    if (name.endsWith(".csv")) {
      QVERIFY2(content.count('\n') > 3, qPrintable(name));
      continue;
    }
    QXmlStreamReader xml(content);
    while (!xml.atEnd()) xml.readNext();
    QVERIFY2(!xml.hasError() && content.startsWith("<svg xmlns=") &&
                 content.contains(name.contains("_page.") ? "178mm" : "86mm"),
             qPrintable(name));
  }
  const Session session = loadSession("s.json");
  const auto noise = metricsOf(session, loadSession("s.json", {"lightField.file=b.png"}));
  const auto same = metricsOf(session, session);
  QList<QByteArray> lines = contentOf("out/report.csv").split('\n');
  QCOMPARE(lines.takeFirst(), QByteArray(header));
  QCOMPARE(lines.takeLast(), QByteArray());
  QCOMPARE(lines.size(), 6);
  for (int k = 0; k < 3; ++k) {
    const CameraParams& camera = session.cameras[std::size_t(k)].camera;
    const QStringList first = cellsOf(lines[2 * k]);
    const QStringList second = cellsOf(lines[2 * k + 1]);
    QCOMPARE(first.mid(0, 2), (QStringList{QString::fromStdString(camera.name), "b.png"}));
    QCOMPARE(second.mid(0, 2), (QStringList{QString::fromStdString(camera.name), "a.png"}));
    if (k == 2) break;  // sees nothing
    QVERIFY2(saysAll(first, noise[std::size_t(k)], camera.eye), lines[2 * k]);
    QVERIFY2(saysAll(second, same[std::size_t(k)], camera.eye), lines[2 * k + 1]);
  }
  QVERIFY(lines[0].startsWith("\"a, \"\"b\"\"\",b.png,"));
  QVERIFY(noise[0][mseColumn] > 5 && noise[0][seenColumn] > 0.2 && noise[0][seenColumn] < 1);
  QCOMPARE(contentOf("out/metrics.csv").count("sees nothing"), 2);
  QVERIFY(lines[3].startsWith("<i>&,a.png,0,inf,0,inf,1,"));
  QCOMPARE(lines[4], QByteArray("behind,b.png,nan,nan,nan,nan,nan,0,0,0,-1"));
}

/// Its display and its light field; the states are the reference's.
void TestReport::testIsASession() {
  writeImageFile("c.png", 64, 96, noisy);
  writeFile("deep/t.json",
            text({.display = R"({"hogels": [8, 12], "directions": [8, 8], "fov": [50, 70]})",
                  .lightField = R"({"file": "../c.png"})",
                  .cameras = R"([{"name": "another"}])"}));
  const Outcome outcome = report({"--test", "deep/t.json", "--states", "<i>&"});
  QCOMPARE(outcome.err, QByteArray());
  Session session = loadSession("s.json");
  session.cameras = {session.cameras[1]};
  Session test = loadSession("deep/t.json");
  test.cameras = session.cameras;
  const QList<QByteArray> lines = contentOf("out/report.csv").split('\n');
  QCOMPARE(lines.size(), 3);
  const QStringList cells = cellsOf(lines[1]);
  QCOMPARE(cells.mid(0, 2), (QStringList{"<i>&", "deep/t.json"}));
  QVERIFY2(saysAll(cells, metricsOf(session, test)[0], session.cameras[0].camera.eye), lines[1]);
}

void TestReport::testIsAFolder() {
  for (int k = 0; k < 4; ++k) {
    const QString name = QString("/00%1_00%2.png").arg(k / 2).arg(k % 2);
    writeImageFile("v" + name, 24, 20, [k](int x, int y, int c) { return content(x + k, y, c); });
    writeImageFile("w" + name, 24, 20, [k](int x, int y, int c) { return noisy(x + k, y, c); });
  }
  writeFile("s.json", text({.display = "{}",
                            .lightField = R"({"file": "v", "layout": "views", "shear": [1, 0]})",
                            .cameras = cameras}));
  QCOMPARE(report({"--test", "w"}).status, 0);
  const Session session = loadSession("s.json");
  const Session test = loadSession("s.json", {"lightField.file=w"});
  const QList<QByteArray> lines = contentOf("out/report.csv").split('\n');
  QVERIFY2(saysAll(cellsOf(lines[1]), metricsOf(session, test)[0], {0.1, -0.05, 0.6}), lines[1]);
}

/// A folder can only be views, whatever the session's own layout is.
void TestReport::testIsAFolderOfAnotherLayout() {
  for (int k = 0; k < 64; ++k)
    writeImageFile(
        QString("v/%1_%2.png").arg(k / 8, 3, 10, QChar('0')).arg(k % 8, 3, 10, QChar('0')), 16, 16,
        [k](int x, int y, int c) { return content(8 * x + k % 8, 8 * y + k / 8, c); });
  const Outcome outcome = report({"--test", "v"});
  QCOMPARE(outcome.err, QByteArray());
  QVERIFY(contentOf("out/report.csv").contains("<i>&,v,0,inf,0,inf,1,"));
}

/// And a picture can only be hogels, which the session of views need not say.
void TestReport::testIsAnImageOfAnotherLayout() {
  for (const char* name : {"v/000_000.png", "v/000_001.png"}) writeGrey(name, 6, 4);
  writeGrey("hogels.png", 12, 4);
  writeFile("s.json", text({.display = "{}",
                            .lightField = R"({"file": "v", "layout": "views"})",
                            .cameras = cameras}));
  const Outcome outcome = report({"--test", "hogels.png"});
  QVERIFY2(!outcome.err.contains("0×0"), outcome.err);
}

void TestReport::pictures() {
  QCOMPARE(report({"--test", "b.png", "--test", "a.png", "--images", "--states", "[!a]*"}).status,
           0);
  QCOMPARE(namesIn("out"),
           (QStringList{"metrics.csv", "panel_error", "plots", "reference", "report.csv",
                        "report.html", "summary.csv", "test1", "test2", "views"}));
  Session session = loadSession("s.json");
  session.cameras.erase(session.cameras.begin());
  const std::vector<Image> references = simulated(session);
  session.lightField.file = "b.png";
  const std::vector<Image> tests = simulated(session);
  for (const char* folder : {"out/reference", "out/test1", "out/test2"})
    QCOMPARE(namesIn(folder), (QStringList{"<i>&.png", "behind.png"}));
  QVERIFY(valuesOf<std::uint8_t>("out/reference/<i>&.png") == references[0].rgb);
  QVERIFY(valuesOf<std::uint8_t>("out/test1/<i>&.png") == tests[0].rgb);
  QVERIFY(valuesOf<std::uint8_t>("out/test2/<i>&.png") == references[0].rgb);
  QVERIFY(references[0].rgb != tests[0].rgb);
}

/// Reference and test stand as they are in the sheet, beside the map of their error: where they
/// are the same it has the colour of 0.
void TestReport::sideBySide() {
  QCOMPARE(report({"--test", "b.png", "--states", "a*"}).status, 0);
  const QString sheet = "out/views/test1_worst.png";
  const QSize one(40, 30);
  const int em = 13, gap = em / 2, top = 3 * em / 2;
  const QSize whole(3 * one.width() + 4 * gap + 4 * em, one.height() + 2 * em);
  const auto pixels = valuesOf<std::uint8_t>(sheet);
  QCOMPARE(pixels.size(), std::size_t(3 * whole.width() * whole.height()));
  const auto at = [](const std::vector<std::uint8_t>& rgb, int width, int x, int y) {
    return std::array{rgb[3 * std::size_t(y * width + x)], rgb[3 * std::size_t(y * width + x) + 1],
                      rgb[3 * std::size_t(y * width + x) + 2]};
  };
  std::array<std::vector<std::uint8_t>, 2> shown;
  shown[0] = valuesOf<std::uint8_t>("out/views/test1_worst_reference.png");
  shown[1] = valuesOf<std::uint8_t>("out/views/test1_worst_test.png");
  int same = 0, different = 0;
  for (int y = 0; y < one.height(); ++y)
    for (int x = 0; x < one.width(); ++x) {
      std::array<std::array<std::uint8_t, 3>, 2> colours;
      for (int k = 0; k < 2; ++k) {
        colours[std::size_t(k)] = at(shown[std::size_t(k)], one.width(), x, y);
        QVERIFY(at(pixels, whole.width(), gap + k * (one.width() + gap) + x, top + y) ==
                colours[std::size_t(k)]);
      }
      const auto error = at(pixels, whole.width(), gap + 2 * (one.width() + gap) + x, top + y);
      const bool isZero = error == falseColour(0);
      if (colours[0] == colours[1]) QVERIFY(isZero);
      ++(isZero ? same : different);
    }
  QVERIFY(same > 0 && different > 100);
}

/// Pictures in which no number of the scale has room.
void TestReport::sideBySideOfSmallPictures() {
  for (const char* size : {"[40,1]", "[40,3]", "[40,5]", "[40,7]", "[1,40]", "[1,1]"}) {
    const Outcome outcome = report({"--test", "b.png", "--states", "a*", "--set",
                                    QString("camera.res=") + size, "--set", "camera.fov=20"});
    QVERIFY2(outcome.status == 0, size + outcome.err);
    QVERIFY2(QFile::exists("out/views/test1_worst.png"), size);
    QVERIFY(QDir("out").removeRecursively());
  }
}

/// A reference of JPEG is told, on the terminal and in the page; tests of JPEG are not.
void TestReport::lossyReference() {
  writeImageFile("j.jpg", 128, 128, noisy);
  writeFile("j.json", text({.display = R"({"hogels": [16, 16], "directions": [8, 8]})",
                            .lightField = R"({"file": "j.jpg"})",
                            .cameras = cameras}));
  const char* const words = "the reference is itself a lossy file (JPEG, ";
  const Outcome lossy = run({"--report", "--session", "j.json", "--test", "b.png", "--output", "j"},
                            m_folder->path());
  QVERIFY2(lossy.status == 0 && lossy.err.contains(words), lossy.err);
  QVERIFY(contentOf("j/report.html").contains(words));
  const Outcome good = report({"--test", "j.jpg"});
  QVERIFY2(good.status == 0 && !good.err.contains("lossy"), good.err);
  QVERIFY(!contentOf("out/report.html").contains("lossy"));
}

/// It can be mailed: nothing that it shows lies elsewhere.
/// The same light fields as a page, for a program with the engine; others say that they have none.
void TestReport::pageToLookAround() {
  const Outcome outcome = report({"--test", "b.png", "--page"});
  if (outcome.err.contains("was built without the engine")) {
    QCOMPARE(outcome.status, 2);
    QVERIFY(!QFile::exists("out"));
    return;
  }
  QCOMPARE(outcome.status, 0);
  QVERIFY(contentOf("out/report.html").contains("<a href=\"page.html\">"));
  const QByteArray page = contentOf("out/page.html");
  QVERIFY(page.contains("data-exact=\"yes\">\"s\"</script>"));
  QVERIFY(page.contains("data-exact=\"yes\">\"b\"</script>"));
  QCOMPARE(report({"--against", "design", "--page"}).status, 2);
}

void TestReport::page() {
  QCOMPARE(report({"--test", "b.png", "--images"}).status, 0);
  QString page = QString::fromUtf8(contentOf("out/report.html"));
  QVERIFY(page.startsWith("<!DOCTYPE html>"));
  QVERIFY(page.trimmed().endsWith("</html>"));
  page.remove("src=\"data:image/png;base64,").remove("href=\"data:image/png;base64,");
  page.remove("<a href=\"views/test");
  for (const char* outside : {"http:", "https:", "src=", "href=", "url(", "@import", "<link"})
    QVERIFY2(!page.contains(outside), outside);
  QVERIFY(page.contains("<td>&lt;i&gt;&amp;</td><td>b</td>"));
  QVERIFY(page.contains("<td>a, &quot;b&quot;</td><td>b</td>"));
  QVERIFY(!page.contains("<i>"));
  const QStringList cells = cellsOf(contentOf("out/report.csv").split('\n')[1]);
  QVERIFY(page.contains(">" + QString::number(cells[5].toDouble(), 'f', 2) + "</td>"));
  QVERIFY(page.contains("s.json"));
}

void TestReport::summary() {
  const Outcome outcome = report({"--test", "b.png"});
  const QString out = QString::fromUtf8(outcome.out);
  const QList<QByteArray> lines = contentOf("out/report.csv").split('\n');
  const auto cell = [&](int line, int column) { return cellsOf(lines[line])[column].toDouble(); };
  const double first = cell(1, 5);
  const double second = cell(2, 5);
  const auto ofMean = [&](int column) {
    return 10 * std::log10(255.0 * 255 / ((cell(1, column) + cell(2, column)) / 2));
  };
  const QString both = "%1 dB over what is seen, %2 dB over the whole frame\n";
  QVERIFY2(
      out.contains(
          "mean of the finite PSNRs  " +
          both.arg((first + second) / 2, 0, 'f', 2).arg((cell(1, 3) + cell(2, 3)) / 2, 0, 'f', 2)),
      outcome.out);
  QVERIFY2(out.contains("PSNR of the mean MSE      " +
                        both.arg(ofMean(4), 0, 'f', 2).arg(ofMean(2), 0, 'f', 2)),
           outcome.out);
  const QString worst = first < second ? "a, \"b\"" : "<i>&";
  QVERIFY2(out.contains(QString("worst view                %1 dB: %2, b.png\n")
                            .arg(std::min(first, second), 0, 'f', 2)
                            .arg(worst)),
           outcome.out);
  QVERIFY2(out.contains("identical views           0 of 3\n"), outcome.out);
  const Outcome quiet = report({"--test", "b.png", "--quiet"});
  QCOMPARE(quiet.out + quiet.err, QByteArray());
}

/// Differences must be the light fields', not those of two methods.
void TestReport::toleranceIsLeftAside() {
  QCOMPARE(report({"--test", "b.png"}).status, 0);
  const QByteArray expected = contentOf("out/report.csv");
  QCOMPARE(report({"--test", "b.png", "--set", "sampling.tolerance=60"}).status, 0);
  QCOMPARE(contentOf("out/report.csv"), expected);
}

/// Too large for the memory allowed: every file of the report is the same, but those that need all
/// views in memory, and it is told.
void TestReport::lightFieldsThatPassBy() {
  const QStringList tests{"--test", "b.png", "--test", "a.png", "--images"};
  QCOMPARE(report(tests).status, 0);
  QVERIFY(QDir().rename("out", "loaded"));
  const Outcome outcome = report(tests + QStringList{"--memory", "0.12"});
  QCOMPARE(outcome.status, 0);
  for (const QByteArray name : {"a.png", "b.png"})
    QVERIFY2(
        outcome.err.contains(name + ": has 49.2 kB of pixels, 60 kB are allowed: read from the "
                                    "top, all pictures made on the way\n"),
        outcome.err);
  int compared = 0;
  QDirIterator files("loaded", QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    const QString file = files.next();
    if (file.endsWith("report.html")) continue;  // has its command
    if (file.contains("_views") || file.contains("_ranks")) {
      QVERIFY2(!QFile::exists("out" + file.mid(6)), qPrintable(file));
      continue;
    }
    QVERIFY2(contentOf(file) == contentOf("out" + file.mid(6)), qPrintable(file));
    ++compared;
  }
  QVERIFY(compared >= 12);
}

void TestReport::gate_data() {
  QTest::addColumn<QString>("test");
  QTest::addColumn<QString>("below");
  QTest::addColumn<int>("status");
  QTest::newRow("met") << "b.png"
                       << "20" << 0;
  QTest::newRow("failed") << "b.png"
                          << "60.5" << 1;
  QTest::newRow("identical passes any") << "a.png"
                                        << "1e6" << 0;
}

void TestReport::gate() {
  QFETCH(QString, test);
  QFETCH(QString, below);
  QFETCH(int, status);
  const Outcome outcome =
      report({"--test", test, "--fail-below", below, "--states", "<i>&", "--quiet"});
  QCOMPARE(outcome.status, status);
  const QStringList cells = cellsOf(contentOf("out/report.csv").split('\n')[1]);
  const QString line = QString("hogelscope: <i>&: %1: PSNR %2 dB over what is seen is below %3\n")
                           .arg(test, cells[5], below);
  QCOMPARE(QString::fromUtf8(outcome.err), status == 1 ? line : QString());
}

/// Black surroundings would let it pass.
void TestReport::gateIsOverWhatIsSeen() {
  QCOMPARE(report({"--test", "b.png", "--states", "a*"}).status, 0);
  const QStringList cells = cellsOf(contentOf("out/report.csv").split('\n')[1]);
  const double seen = cells[5].toDouble(), frame = cells[3].toDouble();
  QVERIFY(frame > seen + 0.5);
  const QString between = QString::number((seen + frame) / 2);
  QCOMPARE(report({"--test", "b.png", "--states", "a*", "--fail-below", between}).status, 1);
}

/// A PPM of 10 bits, as JPEG Pleno has them.
void TestReport::tenBitsAgainstTheirCopy() {
  const auto value = [](int x, int y, int c) { return (x * 37 + y * 11 + c * 300) % 1024; };
  QByteArray ppm = "P6\n# 10 bits\n128 128\n1023\n";
  for (int k = 0; k < 3 * 128 * 128; ++k) {
    const int v = value(k / 3 % 128, k / 3 / 128, k % 3);
    ppm.append(char(v >> 8)).append(char(v & 255));
  }
  writeFile("ten.ppm", ppm);
  const auto rounded = [&](int x, int y, int c) {
    return int(value(x, y, c) * 255 / 1023.0 + 0.5);
  };
  writeImageFile("eight.png", 128, 128,
                 [&](int x, int y, int c) { return float(rounded(x, y, c)) / 255; });
  const QStringList tests{"--test", "eight.png", "--test", "ten.ppm"};
  const QStringList ten{"--set", "lightField.file=ten.ppm", "--images", "--states", "a*"};
  const Outcome outcome = report(tests + ten);
  QCOMPARE(outcome.err, QByteArray());
  // The written pictures have all bits, and the 8-bit one only its own.
  const auto a = valuesOf<std::uint16_t>("out/reference/a, \"b\".png");
  const auto b = valuesOf<std::uint16_t>("out/test1/a, \"b\".png");
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double stored = std::round(a[k] * 1023 / 65535.0);  // the 10-bit value itself
    QCOMPARE(int(a[k]), int(std::lround(stored * 65535 / 1023)));
    QCOMPARE(b[k] % 257, 0);
    QCOMPARE(b[k] / 257, int(stored * 255 / 1023 + 0.5));
    sum += std::pow(stored * 255 / 1023 - b[k] / 257, 2);
  }
  const QStringList cells = cellsOf(contentOf("out/report.csv").split('\n')[1]);
  QVERIFY(std::abs(cells[2].toDouble() - sum / double(a.size())) < 1e-12);
  QVERIFY(sum > 0 && cells[3].toDouble() > 55 && cells[3].toDouble() < 70);
  QVERIFY(contentOf("out/report.csv").split('\n')[2].contains(",ten.ppm,0,inf,0,inf,1,"));
  QVERIFY(contentOf("out/metrics.csv").split('\n')[1].contains(",10,"));
  QCOMPARE(contentOf("out/report.html").count("No pixel seen in both pictures differs."), 1);
}

/// The same bytes where both are read from the top once.
void TestReport::sixteenBitsThatPassBy() {
  const PictureKind sixteen{PictureType::UInt16};
  writeImageFile("a.png", 128, 128, content, sixteen);
  writeImageFile("b.png", 128, 128, noisy, sixteen);
  QCOMPARE(report({"--test", "b.png", "--images"}).status, 0);
  QVERIFY(QDir().rename("out", "loaded"));
  const Outcome outcome = report({"--test", "b.png", "--images", "--memory", "0.2"});
  QVERIFY2(outcome.err.contains("read from the top"), outcome.err);
  for (const char* file : {"/report.csv", "/metrics.csv", "/summary.csv", "/reference/<i>&.png",
                           "/test1/<i>&.png", "/panel_error/test1_hogels.exr"})
    QVERIFY2(contentOf(QString("loaded") + file) == contentOf(QString("out") + file), file);
  QCOMPARE(specOf("out/test1/<i>&.png").type, PictureType::UInt16);
}

void TestReport::badTestsAreToldFirst_data() {
  QTest::addColumn<QString>("test");
  QTest::addColumn<QByteArray>("line");
  QTest::newRow("missing") << "none.png" << QByteArray("none.png: there is no such file");
  QTest::newRow("empty") << "" << QByteArray("--test: needs a value: LF");
  QTest::newRow("another size") << "small.png"
                                << QByteArray(
                                       "small.png: size: is 8×8 px, but 16×16 hogels of 8×8 "
                                       "directions need 128×128");
  QTest::newRow("a session without content")
      << "t.json"
      << QByteArray("t.json: display.hogels: is missing: a hogel image does not say it");
}

void TestReport::badTestsAreToldFirst() {
  QFETCH(QString, test);
  QFETCH(QByteArray, line);
  writeGrey("small.png", 8, 8);
  writeFile("t.json", text({.display = "{}"}));
  const Outcome outcome = report({"--test", "b.png", "--test", test});
  QCOMPARE(outcome.err, "hogelscope: " + line + "\n");
  QCOMPARE(outcome.out, QByteArray());
  QCOMPARE(outcome.status, 2);
  QVERIFY(!QFileInfo::exists("out"));
}

QTEST_GUILESS_MAIN(TestReport)
#include "test_report.moc"
