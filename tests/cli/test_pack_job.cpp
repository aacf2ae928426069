// SPDX-License-Identifier: BSD-3-Clause
// Tests --pack as a user runs it: what it writes, what renders from it, and that Ctrl-C, kill -9
// and a full disk leave what the same command goes on from.
#include <sys/resource.h>

#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "io/store/light_field_store.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"
#include "tests/io/texels.h"

using namespace hogelscope;

namespace {

constexpr LightFieldSize size{40, 40, 16, 16};

float valueAt(int x, int y, int c) {
  return float((x * 7 + y * 13 + x * y / 3 + 50 * c) % 256) / 255;
}

/// `hogels` × `hogels` of them, incompressible enough to take a while.
void writeSource(int hogels) {
  writeImageFile("a.png", hogels * size.du, hogels * size.dv, valueAt);
}

QStringList packArguments(int hogels) {
  return {"--pack",   "a.png",
          "--output", "store.tif",
          "--set",    QString("display.hogels=[%1,%1]").arg(hogels),
          "--set",    QString("display.directions=[%1,%2]").arg(size.du).arg(size.dv)};
}

QByteArray session(const QByteArray& lightField) {
  return R"({"hogelscope": 1,
  "display": {"size": [0.4, 0.4], "hogels": [40, 40], "directions": [16, 16], "fov": [50, 50]},
  "lightField": )" +
         lightField + R"(,
  "cameras": [{"name": "a", "eye": [0.1, 0.05, 0.6], "lookat": [0, 0, 0], "up": [0, 1, 0],
    "fov": 50, "res": [80, 60], "psf": {"sigma": 0.7, "windowSize": 3}}]})";
}

/// Runs it; the largest peak of memory of any run so far, kB.
long peakOf(const QStringList& arguments, const QString& folder) {
  QProcess process;
  start(process, arguments, folder);
  waitForEnd(process);
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  return process.exitCode() == 0 ? usage.ru_maxrss : -1;
}

}  // namespace

class TestPackJob : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void memoryIsBounded();  // first: the largest child so far is what is measured
  void packs();
  void sessionIsKept();
  void rendersTheSame();
  void killed();
  void interrupted();
  void fullDisk();
  void refusals_data();
  void refusals();

 private:
  void startLimited(QProcess& process, int hogels, rlim_t bytes);

  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestPackJob::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestPackJob::packs() {
  writeSource(40);
  const Outcome outcome = run(packArguments(40), m_folder->path());
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.status, 0);
  QVERIFY2(outcome.out.startsWith("40×40 hogels of 16×16 directions in blocks of 8×8 × 8×8; "),
           outcome.out);
  LightFieldStore store("store.tif");
  QCOMPARE(firstWrong(
               store.read({}),
               [](const TexelIndex& at) {
                 const int x = at.i * size.du + at.u;
                 const int y = at.j * size.dv + at.v;
                 const auto value = [&](int c) { return double(255 * valueAt(x, y, c)); };
                 return Rgb{value(0), value(1), value(2)};
               },
               1e-3),
           QString());
  QVERIFY(!store.header().display);  // nobody gave one
  const Outcome info = run({"--info", "store.tif"}, m_folder->path());
  QCOMPARE(info.status, 0);
  QVERIFY2(info.out.startsWith("layout      pack: a store, 8 bit, blocks of 8×8 hogels × 8×8 "
                               "directions\n"),
           info.out);
  QVERIFY2(info.out.contains("made of     a.png\nhogels      40×40\ndirections  16×16\n"),
           info.out);
}

void TestPackJob::sessionIsKept() {
  writeSource(40);
  writeFile("s.json", session(R"({"file": "a.png", "incoming": true})"));
  const Outcome outcome = run({"--pack", "a.png", "--session", "s.json", "--output", "o/store.tif",
                               "--quiet", "--set", "display.fov=[44,45]"},
                              m_folder->path());
  QCOMPARE(outcome.err + outcome.out, QByteArray());
  LightFieldStore store("o/store.tif");
  QVERIFY(store.header().display);
  QCOMPARE(store.header().display->fov, (std::array{44.0, 45.0}));
  const double x = 3 * 16 + 15 - 4;  // the session's light field is incoming: u and v are turned
  const double y = 2 * 16 + 15 - 5;
  QCOMPARE(store.read({}).texel({3, 2, 4, 5}).r, std::round(255.0 * valueAt(int(x), int(y), 0)));
}

/// From memory, and from the disk where memory is too small.
void TestPackJob::rendersTheSame() {
  writeSource(40);
  writeFile("s.json", session(R"({"file": "a.png"})"));
  writeFile("p.json", session(R"({"file": "store.tif", "layout": "pack"})"));
  QCOMPARE(run(packArguments(40), m_folder->path()).status, 0);
  const auto render = [this](const char* from, const char* to, const QStringList& more) {
    const Outcome outcome =
        run(QStringList{"--render", "--session", from, "--output", to, "--quiet"} + more,
            m_folder->path());
    return outcome.err + outcome.out + QByteArray::number(outcome.status);
  };
  QCOMPARE(render("s.json", "1", {}), QByteArray("0"));
  QCOMPARE(render("p.json", "2", {}), QByteArray("0"));
  QCOMPARE(render("p.json", "3", {"--memory", "1"}), QByteArray("0"));
  QCOMPARE(contentOf("2/a.png"), contentOf("1/a.png"));
  QCOMPARE(contentOf("3/a.png"), contentOf("1/a.png"));
  const auto values = bytesOf("1/a.png");
  // The display is a third of the picture.
  QVERIFY(std::count(values.begin(), values.end(), 0) < std::ptrdiff_t(values.size()) * 3 / 4);
}

/// Starts packing where no file can grow beyond `bytes`.
void TestPackJob::startLimited(QProcess& process, int hogels, rlim_t bytes) {
  process.setChildProcessModifier([bytes] {
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  });
  start(process, packArguments(hogels), m_folder->path());
}

/// By a signal that it cannot hear, wherever it is.
void TestPackJob::killed() {
  constexpr int hogels = 64;
  writeSource(hogels);
  QCOMPARE(run(packArguments(hogels), m_folder->path()).status, 0);
  const QByteArray whole = contentOf("store.tif");
  for (const int tenths : {0, 5}) {
    QProcess process;
    do {  // again if it was faster
      QFile::remove("store.tif");
      start(process, packArguments(hogels), m_folder->path());
      (void)waitUntil(process, [&whole, tenths] {
        return QFileInfo("store.tif.part").size() > whole.size() / 10 * tenths;
      });
      send(process, SIGKILL);
      waitForEnd(process);
    } while (QFileInfo::exists("store.tif"));
    QCOMPARE(process.exitCode(), SIGKILL);
    QCOMPARE(namesIn("."), (QStringList{"a.png", "store.tif.part"}));
    QCOMPARE(run(packArguments(hogels), m_folder->path()).status, 0);
    QVERIFY(contentOf("store.tif") == whole);
    QCOMPARE(namesIn("."), (QStringList{"a.png", "store.tif"}));
  }
}

void TestPackJob::interrupted() {
  constexpr int hogels = 64;
  writeSource(hogels);
  QProcess process;
  do {  // again if it was faster
    QFile::remove("store.tif");
    start(process, packArguments(hogels), m_folder->path());
    QVERIFY(waitUntil(process, [] { return QFileInfo::exists("store.tif.part"); }) ||
            process.exitCode() == 0);
    send(process, SIGINT);
    waitForEnd(process);
  } while (process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0);
  QCOMPARE(process.exitStatus(), QProcess::CrashExit);
  QCOMPARE(process.exitCode(), SIGINT);
  QCOMPARE(process.readAllStandardError(),
           QByteArray("hogelscope: stopped; what is finished is kept\n"));
  QCOMPARE(namesIn("."), (QStringList{"a.png", "store.tif.part"}));
  QCOMPARE(run(packArguments(hogels), m_folder->path()).status, 0);
  QCOMPARE(namesIn("."), (QStringList{"a.png", "store.tif"}));
}

void TestPackJob::fullDisk() {
  writeSource(40);
  QProcess process;
  startLimited(process, 40, 100000);
  waitForEnd(process);
  QCOMPARE(process.readAllStandardError(),
           QByteArray("hogelscope: store.tif: cannot be written: File too large\n"));
  QCOMPARE(process.exitCode(), 2);
  QCOMPARE(run(packArguments(40), m_folder->path()).status, 0);
}

/// Eight times the rows of hogels, no more memory.
void TestPackJob::memoryIsBounded() {
#ifdef __SANITIZE_ADDRESS__
  QSKIP("the sanitizer keeps what was freed");
#endif
  const auto pack = [this](int rows) {
    const QString hogels = QString("display.hogels=[2000,%1]").arg(rows);
    const QString directions = "display.directions=[8,8]";
    writeFile("s.json", session(R"({"file": "a.png"})"));
    const Outcome made = run({"--generate", "directions", "--session", "s.json", "--output",
                              "a.png", "--set", hogels, "--set", directions},
                             m_folder->path());
    if (made.status != 0) return -1L;
    return peakOf({"--pack", "a.png", "--output", "store.tif", "--set", hogels, "--set", directions,
                   "--memory", "8"},
                  m_folder->path());
  };
  const long few = pack(16);
  const long many = pack(128);  // 49 MB of pixels
  QVERIFY(few > 0 && many > 0);
  QVERIFY2(many < few + 20000, qPrintable(QString("%1 kB, %2 kB").arg(few).arg(many)));
}

void TestPackJob::refusals_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("line");
  QTest::newRow("nothing there") << QStringList{"--pack", "b.png", "--output", "s.tif"}
                                 << QByteArray("b.png: there is no such file");
  QTest::newRow("no output") << QStringList{"--pack", "a.png"}
                             << QByteArray(
                                    "--output: is missing; --pack needs --output PATH, see "
                                    "--help pack");
  QTest::newRow("memory for less than a row")
      << QStringList{"--pack",   "a.png",
                     "--output", "s.tif",
                     "--set",    "display.hogels=[160,10]",
                     "--set",    "display.directions=[4,64]",
                     "--memory", "0.04"}
      << QByteArray("a.png: size: one row of hogels needs 122.9 kB of memory, 40 kB are allowed");
  QTest::newRow("a folder as output")
      << QStringList{"--pack",   "a.png",
                     "--output", ".",
                     "--set",    "display.hogels=[40,40]",
                     "--set",    "display.directions=[16,16]"}
      << QByteArray(".: cannot be written: it is there, and is not a file");
  QTest::newRow("a name of another format")
      << QStringList{"--pack",   "a.png",
                     "--output", "y.png",
                     "--set",    "display.hogels=[40,40]",
                     "--set",    "display.directions=[16,16]"}
      << QByteArray("--output y.png: is the name of a store, which is a TIFF: end it in .tif");
  QTest::newRow("onto itself")
      << QStringList{"--pack",   "a.png",
                     "--output", "./a.png",
                     "--set",    "display.hogels=[40,40]",
                     "--set",    "display.directions=[16,16]"}
      << QByteArray("./a.png: cannot be written: it is a.png, which is read: choose another name");
}

void TestPackJob::refusals() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, line);
  writeSource(40);
  const Outcome outcome = run(arguments + QStringList{"--quiet"}, m_folder->path());
  QCOMPARE(outcome.err, "hogelscope: " + line + "\n");
  QCOMPARE(outcome.status, 2);
  QCOMPARE(namesIn("."), QStringList{"a.png"});
}

QTEST_GUILESS_MAIN(TestPackJob)
#include "test_pack_job.moc"
