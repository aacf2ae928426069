// SPDX-License-Identifier: BSD-3-Clause
// Tests that Ctrl-C and a full disk end the program soon, in one line, and leave no half files.
#include <sys/resource.h>

#include <QDir>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

namespace {

/// Does it hear the signal itself?
bool catches(const QProcess& process, int signal) {
  QFile file(QString("/proc/%1/status").arg(process.processId()));
  if (!file.open(QIODevice::ReadOnly)) return false;
  const QByteArray text = file.readAll();
  const QByteArray mask = text.mid(text.indexOf("SigCgt:") + 7).trimmed().left(16);
  return (mask.toULongLong(nullptr, 16) >> (signal - 1) & 1U) != 0;
}

/// It has come beyond its start, however busy the machine is.
bool isAtWork(const QProcess& process) {
  constexpr double start = 0.15;  // seconds of a core
  return catches(process, SIGINT) && cpuSeconds(process) > start;
}

/// As run(), where no file can grow beyond `bytes`: what a full disk is like.
Outcome runOnFullDisk(const QStringList& arguments, const QString& folder, rlim_t bytes) {
  QProcess process;
  process.setChildProcessModifier([bytes] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  });
  start(process, arguments, folder);
  return ended(process);
}

QStringList render(const QStringList& more) {
  return QStringList{"--render", "--session", sampleSession, "--output", "out"} + more;
}

QStringList generate(const QString& file, const QString& hogels) {
  return {"--generate", "scene", "--session", sampleSession,
          "--output",   file,    "--set",     "display.hogels=" + hogels};
}

}  // namespace

class TestStop : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void signalsStop_data();
  void signalsStop();
  void twoSignalsEndAtOnce();
  void fullDisk_data();
  void fullDisk();
  void fullDiskForTheReport();
  void fullDiskKeepsTheOldFile();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestStop::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestStop::signalsStop_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<int>("signal");
  // Work for minutes: what does not hear the signal comes to its end, and the test fails.
  const QStringList large{"--set", "camera.res=[4000,4000]", "--set", "sampling.samplesPerPixel=4"};
  QTest::newRow("Ctrl-C in a render") << render(large) << SIGINT;
  QTest::newRow("SIGTERM in a render") << render(large) << SIGTERM;
  const QStringList rays{"--set", "camera.res=[4000,4000]", "--set", "sampling.samplesPerPixel=8"};
  QTest::newRow("Ctrl-C, many rays in a pixel") << render(rays) << SIGINT;
  const QStringList report{"--report", "--session", sampleSession, "--output",
                           "out",      "--test",    sampleSession};
  QTest::newRow("Ctrl-C in a report") << report + large << SIGINT;
  const QStringList hard{
      "--set", "distortion.k1=0.2958943955272433", "--set", "distortion.k2=-1.0354662043042675",
      "--set", "camera.res=[4000,4000]",           "--set", "camera.fov=120"};
  QTest::newRow("SIGTERM in the table of a hard lens") << render(hard) << SIGTERM;
  QTest::newRow("SIGTERM in a hard lens' certificate")
      << render(hard + QStringList{"--explain"}) << SIGTERM;
  QTest::newRow("Ctrl-C in a pattern") << generate("out/a.png", "[2000,2000]") << SIGINT;
}

void TestStop::signalsStop() {
  QFETCH(QStringList, arguments);
  QFETCH(int, signal);
  const bool isGenerated = arguments.contains("--generate");
  if (isGenerated) QVERIFY(QDir().mkdir("out"));
  QProcess process;
  start(process, arguments, m_folder->path());
  QVERIFY(waitUntil(process, [&process] { return isAtWork(process); }));
  send(process, signal);
  waitForEnd(process);
  QCOMPARE(process.exitStatus(), QProcess::CrashExit);
  QCOMPARE(process.exitCode(), signal);
  for (const QString& name : namesIn("out"))
    if (!name.startsWith("report."))  // by which it goes on
      QVERIFY2(!name.contains(".part") && !bytesOf("out/" + name).empty(), qPrintable(name));
  const QByteArray told = process.readAllStandardError();
  QVERIFY2(told.endsWith("hogelscope: stopped; what is finished is kept\n"), told);
  const auto lines = told.count('\n');
  QVERIFY2(lines == 1 || (lines == 2 && told.contains("views are done;")), told);
}

/// For who cannot wait.
void TestStop::twoSignalsEndAtOnce() {
  QProcess process;
  start(process,
        render({"--set", "camera.res=[4000,4000]", "--set", "sampling.samplesPerPixel=16"}),
        m_folder->path());
  QVERIFY(waitUntil(process, [&process] { return isAtWork(process); }));
  send(process, SIGINT);
  waitUntil(process, [&process] { return !catches(process, SIGINT); });
  send(process, SIGINT);
  waitForEnd(process);
  QCOMPARE(process.exitStatus(), QProcess::CrashExit);
  QCOMPARE(process.exitCode(), SIGINT);
}

void TestStop::fullDisk_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("file");
  const QStringList small{"--set", "camera.res=[60,60]", "--states", "Fig 1"};
  QTest::newRow("PNG") << render(small) << QByteArray("out/Fig 1.png");
  QTest::newRow("EXR") << render(small + QStringList{"--format", "exr"})
                       << QByteArray("out/Fig 1.exr");
  QTest::newRow("TIFF") << render(small + QStringList{"--format", "tif"})
                        << QByteArray("out/Fig 1.tif");
  QTest::newRow("pattern, PNG") << generate("a.png", "[16,16]") << QByteArray("a.png");
  QTest::newRow("pattern, TIFF") << generate("a.tif", "[16,16]") << QByteArray("a.tif");
  QTest::newRow("pattern, JPEG") << generate("a.jpg", "[16,16]") << QByteArray("a.jpg");
}

void TestStop::fullDisk() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, file);
  const Outcome outcome = runOnFullDisk(arguments, m_folder->path(), 2000);
  QCOMPARE(outcome.err, "hogelscope: " + file + ": cannot be written: File too large\n");
  QCOMPARE(outcome.status, 2);
  QCOMPARE(outcome.out, QByteArray());
  QCOMPARE(namesIn("out") + namesIn("."),
           QFileInfo::exists("out") ? QStringList{"out"} : QStringList{});
}

void TestStop::fullDiskForTheReport() {
  const Outcome outcome = runOnFullDisk({"--report", "--session", sampleSession, "--output", "out",
                                         "--test", sampleSession, "--set", "camera.res=[20,20]"},
                                        m_folder->path(), 100);
  QCOMPARE(outcome.status, 2);
  QCOMPARE(outcome.err,
           QByteArray("hogelscope: out/report.hashes: cannot be written: File too large\n"));
  QCOMPARE(namesIn("out"), QStringList{"report.hashes"});
}

void TestStop::fullDiskKeepsTheOldFile() {
  writeFile("out/Fig 1.exr", "old");
  const QStringList arguments =
      render({"--set", "camera.res=[60,60]", "--states", "Fig 1", "--format", "exr"});
  QCOMPARE(runOnFullDisk(arguments, m_folder->path(), 2000).status, 2);
  QCOMPARE(contentOf("out/Fig 1.exr"), QByteArray("old"));
  QCOMPARE(namesIn("out"), QStringList{"Fig 1.exr"});
}

QTEST_GUILESS_MAIN(TestStop)
#include "test_stop.moc"
