// SPDX-License-Identifier: BSD-3-Clause
// Tests --render: its pictures are the reference engine's, in every format, and go where they
// should.
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include "study/undistortion.h"
#include "tests/cli/program.h"
#include "tests/cli/views.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

/// Not the small sample: in some of its pictures a sum is halfway between two code values.
const QString table1 = QStringLiteral(HOGELSCOPE_SOURCE_DIR "/data/table1.json");

const QStringList states{"Fig 1", "Fig 2", "Fig 3", "Fig 4", "Fig 5", "Fig 6"};

QStringList filesOf(const QStringList& names, const QString& ending) {
  QStringList files;
  for (const QString& name : names) files << name + ending;
  return files;
}

/// Renders the sample's states with 64×64 px, or as `more` says, to "out".
QStringList job(const QStringList& more = {}) {
  QStringList arguments{"--render", "--session", table1, "--output", "out"};
  if (more.filter("camera.res=").isEmpty())
    arguments << "--set"
              << "camera.res=[64,64]";
  return arguments + more;
}

}  // namespace

class TestRender : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void init();
  void pictures();
  void needsNoDisplayServer();
  void masks();
  void exrHoldsTheValues();
  void tiffHoldsSixteenBits();
  void statesByName_data();
  void statesByName();
  void threadsMakeNoDifference();
  void threadsBeyondReason();
  void quietIsSilent();
  void overrides();
  void undistorts();
  void undistortsNothing_data();
  void undistortsNothing();
  void warnsOfCutWindows();
  void outputIsMade();
  void outputIsNoFolder_data();
  void outputIsNoFolder();
  void replacesOlderPictures();

 private:
  Outcome render(const QStringList& more = {}) { return run(job(more), m_folder->path()); }

  Session m_session;
  std::vector<Image> m_expected;
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestRender::initTestCase() {
  m_session = loadSession(table1.toStdString(), {"camera.res=[64,64]"});
  m_expected = simulated(m_session);
  QCOMPARE(m_expected.size(), std::size_t(6));
}

void TestRender::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestRender::pictures() {
  const Outcome outcome = render();
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.out, QByteArray("6 picture(s) in out\n"));
  QCOMPARE(outcome.status, 0);
  QCOMPARE(namesIn("out"), filesOf(states, ".png"));
  QCOMPARE(namesIn("."), QStringList{"out"});
  for (int k = 0; k < 6; ++k) {
    const PictureSpec spec = specOf("out/" + states[k] + ".png");
    QCOMPARE(spec.channels, 3);
    QVERIFY(spec.type == PictureType::UInt8);
    QVERIFY2(valuesOf<std::uint8_t>("out/" + states[k] + ".png") == m_expected[std::size_t(k)].rgb,
             qPrintable(states[k]));
  }
  QVERIFY(m_expected[0].rgb != m_expected[3].rgb);
}

void TestRender::needsNoDisplayServer() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    QVERIFY(!withoutDisplay().contains(name));
  QCOMPARE(render({"--states", "Fig 4"}).status, 0);
}

void TestRender::masks() {
  QCOMPARE(render({"--masks", "--states", "Fig [14]"}).status, 0);
  QCOMPARE(namesIn("out"),
           (QStringList{"Fig 1.mask.png", "Fig 1.png", "Fig 4.mask.png", "Fig 4.png"}));
  for (const std::size_t k : {std::size_t(0), std::size_t(3)}) {
    const QString file = "out/" + states[int(k)] + ".mask.png";
    QCOMPARE(specOf(file).channels, 1);
    const std::vector<std::uint8_t>& seen = m_expected[k].seen;
    QVERIFY(valuesOf<std::uint8_t>(file) == seen);
    QVERIFY(std::count(seen.begin(), seen.end(), 0) > 0);
  }
}

/// Unrounded, 1 = the code value 255.
void TestRender::exrHoldsTheValues() {
  QCOMPARE(render({"--format", "exr", "--masks", "--states", "Fig 1"}).status, 0);
  QCOMPARE(namesIn("out"), (QStringList{"Fig 1.exr", "Fig 1.mask.png"}));
  QVERIFY(specOf("out/Fig 1.exr").type == PictureType::Float);
  const std::vector<float> values = valuesOf<float>("out/Fig 1.exr");
  const ViewSource scene = loadViewSource(m_session, {});
  const Simulation simulation(scene.job(m_session.cameras[0]));
  int fractions = 0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const Rgb expected = simulation.pixel(x, y).value_or(PixelLight{});
      const float* rgb = &values[std::size_t(3 * (64 * y + x))];
      QVERIFY(std::abs(255.0 * rgb[0] - expected.r) < 1e-4);
      QVERIFY(std::abs(255.0 * rgb[1] - expected.g) < 1e-4);
      QVERIFY(std::abs(255.0 * rgb[2] - expected.b) < 1e-4);
      if (std::abs(expected.r - std::round(expected.r)) > 0.1) ++fractions;
    }
  }
  QVERIFY(fractions > 100);
}

void TestRender::tiffHoldsSixteenBits() {
  QCOMPARE(render({"--format=tif", "--states", "Fig 1"}).status, 0);
  QCOMPARE(namesIn("out"), QStringList{"Fig 1.tif"});
  QVERIFY(specOf("out/Fig 1.tif").type == PictureType::UInt16);
  const std::vector<std::uint16_t> values = valuesOf<std::uint16_t>("out/Fig 1.tif");
  const ViewSource scene = loadViewSource(m_session, {});
  const Simulation simulation(scene.job(m_session.cameras[0]));
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const Rgb expected = simulation.pixel(x, y).value_or(PixelLight{});
      const std::uint16_t* rgb = &values[std::size_t(3 * (64 * y + x))];
      QVERIFY(std::abs(rgb[0] - 257 * expected.r) < 0.51);
      QVERIFY(std::abs(rgb[1] - 257 * expected.g) < 0.51);
      QVERIFY(std::abs(rgb[2] - 257 * expected.b) < 0.51);
    }
  }
}

void TestRender::statesByName_data() {
  QTest::addColumn<QString>("glob");
  QTest::addColumn<QStringList>("rendered");
  QTest::addColumn<QByteArray>("line");
  QTest::newRow("one") << "Fig 5" << QStringList{"Fig 5"} << QByteArray();
  QTest::newRow("some") << "*[246]" << QStringList{"Fig 2", "Fig 4", "Fig 6"} << QByteArray();
  QTest::newRow("no match") << "Fug*" << QStringList{}
                            << "hogelscope: " + table1.toUtf8() +
                                   ": --states Fug*: fits none of the states: Fig 1, Fig 2, "
                                   "Fig 3, Fig 4, Fig 5, Fig 6\n";
}

void TestRender::statesByName() {
  QFETCH(QString, glob);
  QFETCH(QStringList, rendered);
  QFETCH(QByteArray, line);
  const Outcome outcome = render({"--states", glob});
  QCOMPARE(outcome.err, line);
  QCOMPARE(outcome.status, rendered.isEmpty() ? 2 : 0);
  QCOMPARE(namesIn("out"), filesOf(rendered, ".png"));
}

void TestRender::threadsMakeNoDifference() {
  const QStringList more{"--states", "Fig [13]", "--masks", "--set", "sampling.samplesPerPixel=2"};
  QCOMPARE(render(more + QStringList{"--threads", "1"}).status, 0);
  QVERIFY(QDir().rename("out", "one"));
  QCOMPARE(render(more + QStringList{"--threads", "2"}).status, 0);
  QCOMPARE(namesIn("out").size(), 4);
  for (const QString& name : namesIn("out"))
    QVERIFY2(contentOf("out/" + name) == contentOf("one/" + name), qPrintable(name));
}

void TestRender::threadsBeyondReason() {
  const Outcome outcome =
      render({"--states", "Fig 5", "--threads", "100000", "--set", "camera.res=[4,4]"});
  QCOMPARE(outcome.status, 0);
}

/// Also where there is something to warn of.
void TestRender::quietIsSilent() {
  const QString threads = QString::number(4 * QThread::idealThreadCount());
  const Outcome outcome =
      render({"--quiet", "--states", "Fig 4", "--set", "psf.sigma=9", "--threads", threads});
  QCOMPARE(outcome.out, QByteArray());
  QCOMPARE(outcome.status, 0);
  QCOMPARE(outcome.err, QByteArray());
}

void TestRender::overrides() {
  const std::vector<std::string> given{"camera.res=[40,20]", "sampling.mapping=direct",
                                       "psf.windowSize=1"};
  QStringList flags{"--states", "Fig 1"};
  for (const std::string& text : given) flags << "--set" << QString::fromStdString(text);
  QCOMPARE(render(flags).status, 0);
  Session session = loadSession(table1.toStdString(), given);
  session.cameras.resize(1);
  const Image expected = simulated(session)[0];
  QCOMPARE(expected.width, 40);
  QVERIFY(valuesOf<std::uint8_t>("out/Fig 1.png") == expected.rgb);
}

/// Beside a state's picture the one without its lens, OpenCV's, and their difference.
void TestRender::undistorts() {
  const Outcome outcome = render({"--undistort", "--masks", "--states", "Fig [34]"});
  QCOMPARE(outcome.err, QByteArray());
  QVERIFY2(QRegularExpression("^Fig 3: OpenCV's picture without the lens: PSNR [0-9.]+ dB over "
                              "[0-9.]+ % of the pixels, difference × [0-9]+\n"
                              "5 picture\\(s\\) in out\n$")
               .match(QString::fromUtf8(outcome.out))
               .hasMatch(),
           outcome.out);
  QStringList names{"Fig 3.mask.png",
                    "Fig 3.png",
                    "Fig 3.undistorted-opencv.png",
                    "Fig 3.undistorted.mask.png",
                    "Fig 3.undistorted.png",
                    "Fig 3.undistortion.png",
                    "Fig 4.mask.png",
                    "Fig 4.png"};
  names.sort();
  QCOMPARE(namesIn("out"), names);
  QVERIFY(valuesOf<std::uint8_t>("out/Fig 3.png") == m_expected[2].rgb);
  Session session = m_session;
  session.cameras[2].distortion = {};
  const Image plain = simulated(session)[2];
  QVERIFY(valuesOf<std::uint8_t>("out/Fig 3.undistorted.png") == plain.rgb);
  QVERIFY(valuesOf<std::uint8_t>("out/Fig 3.undistorted-opencv.png") ==
          undistortedByOpenCv(m_expected[2], m_session.cameras[2]).rgb);
  QVERIFY(valuesOf<std::uint8_t>("out/Fig 3.undistortion.png") ==
          compareUndistortion(m_expected[2], plain, m_session.cameras[2]).difference.image.rgb);
}

void TestRender::undistortsNothing_data() {
  QTest::addColumn<QStringList>("more");
  QTest::addColumn<QByteArray>("line");
  QTest::newRow("plain lenses") << QStringList{"--states", "Fig [456]"}
                                << QByteArray("no state has a distortion");
  QTest::newRow("floats") << QStringList{"--format", "exr"}
                          << QByteArray("compares PNG pictures of one eye: leave out --format");
}

void TestRender::undistortsNothing() {
  QFETCH(QStringList, more);
  QFETCH(QByteArray, line);
  const Outcome outcome = render(QStringList{"--undistort"} + more);
  QCOMPARE(outcome.err, "hogelscope: --undistort: " + line + "\n");
  QCOMPARE(outcome.status, 2);
  QCOMPARE(namesIn("."), QStringList());
}

void TestRender::warnsOfCutWindows() {
  const Outcome outcome = render({"--states", "Fig 4", "--set", "psf.sigma=2"});
  QCOMPARE(outcome.err, "hogelscope: " + table1.toUtf8() +
                            ": warning: Fig 4: psf: a window of 5 keeps 62.2 % of the Gaussian of "
                            "sigma 2; widen it\n");
  QCOMPARE(outcome.status, 0);
}

void TestRender::outputIsMade() {
  QStringList arguments = job({"--states", "Fig 5"});
  arguments[4] = "new/and deeper/ä";
  QCOMPARE(run(arguments, m_folder->path()).status, 0);
  QCOMPARE(namesIn("new/and deeper/ä"), QStringList{"Fig 5.png"});
}

void TestRender::outputIsNoFolder_data() {
  QTest::addColumn<QString>("output");
  QTest::addColumn<QByteArray>("line");
  QTest::newRow("a file") << "file" << QByteArray("file: cannot be made: Not a directory");
  QTest::newRow("below a file") << "file/out"
                                << QByteArray("file/out: cannot be made: Not a directory");
  QTest::newRow("where nobody may write")
      << "/proc/out" << QByteArray("/proc/out: cannot be made: No such file or directory");
}

void TestRender::outputIsNoFolder() {
  QFETCH(QString, output);
  QFETCH(QByteArray, line);
  writeFile("file", "kept");
  QStringList arguments = job();
  arguments[4] = output;
  const Outcome outcome = run(arguments, m_folder->path());
  QCOMPARE(outcome.err, "hogelscope: " + line + "\n");
  QCOMPARE(outcome.status, 2);
  QCOMPARE(contentOf("file"), QByteArray("kept"));
  QCOMPARE(namesIn("."), QStringList{"file"});
}

void TestRender::replacesOlderPictures() {
  writeFile("out/Fig 5.png", "old");
  writeFile("out/notes.txt", "kept");
  QCOMPARE(render({"--states", "Fig 5"}).status, 0);
  QVERIFY(valuesOf<std::uint8_t>("out/Fig 5.png") == m_expected[4].rgb);
  QCOMPARE(contentOf("out/notes.txt"), QByteArray("kept"));
}

QTEST_GUILESS_MAIN(TestRender)
#include "test_render.moc"
