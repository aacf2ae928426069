// SPDX-License-Identifier: BSD-3-Clause
// Tests --stability as a user runs it: its files, its flags, what it refuses.
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

namespace {

/// A list of two cameras, one with a comma in its name, k3 left out.
const QByteArray list = R"({"note": "ours", "cameras": [
  {"name": "a, b", "source": "x", "size": [640, 480], "K": [500, 510, 320, 240],
   "D": [-0.3, 0.1, 0, 0]},
  {"name": "c", "size": [64, 48], "K": [50, 50, 32, 24], "D": [0, 0, 0, 0, 0]}]})";

QStringList stability(const QStringList& more) {
  return QStringList{"--stability", "--output", "out"} + more;
}

}  // namespace

class TestStabilityJob : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void writesItsFilesWhateverTheThreads();
  void mistakes_data();
  void mistakes();
  void stops();

 private:
  /// The lens of k1 −0.3 is right everywhere by our inverse; 5 steps of OpenCV's miss its corners.
  static void lensPictures() {
    const QImage lenses("out/lenses.png");
    QCOMPARE(lenses.width(), 2000);
    const auto at = [&](double x, double y) { return lenses.pixelColor(int(2 * x), int(2 * y)); };
    const QColor right(0x79, 0xbf, 0xe8);
    QCOMPARE(at(100, 140), right);  // the middle of the first lens by OpenCV's 5 steps
    QVERIFY(at(16, 74) != right);   // its corner
    QCOMPARE(at(14 + 4 * 197.6, 74), right);
  }

  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestStabilityJob::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestStabilityJob::writesItsFilesWhateverTheThreads() {
  writeFile("list.json", list);
  const QStringList cameras{"--calibrations", "list.json"};
  const Outcome one = run(stability(cameras + QStringList{"--threads", "1"}), ".");
  QCOMPARE(one.err, QByteArray());
  QCOMPARE(one.out, QByteArray("8 lens(es) and two maps in out/stability.csv and "
                               "out/stability.png\n2 lens(es) of the calibrations, pixel by "
                               "pixel, in out/lenses.png\n"));
  QCOMPARE(one.status, 0);
  QCOMPARE(namesIn("out"), QStringList({"lenses.png", "stability.csv", "stability.png"}));
  const QByteArray table = contentOf("out/stability.csv");
  QVERIFY(table.startsWith("kind,lens,method,points,right,"));
  QCOMPARE(table.count("\nlens,\"a, b\","), 5);
  QCOMPARE(table.count("\nlens,c,"), 5);
  QCOMPARE(table.count("\nlens,c,OpenCV 5,1681,1681,0,0,0,0,0,right,,,\n"), 1);
  const auto spec = specOf("out/stability.png");
  QCOMPARE(spec.width, 2000);
  QVERIFY(spec.height > 1000);
  const QByteArray picture = contentOf("out/stability.png");
  lensPictures();

  const Outcome two = run(stability(cameras + QStringList{"--threads", "2", "--quiet"}), ".");
  QCOMPARE(two.err + two.out, QByteArray());
  QCOMPARE(two.status, 0);
  QVERIFY(contentOf("out/stability.csv") == table);
  QVERIFY(contentOf("out/stability.png") == picture);
}

void TestStabilityJob::mistakes_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("line");
  const auto row = [](const char* name, const QStringList& arguments, const char* line) {
    QTest::newRow(name) << arguments << QByteArray(line);
  };
  row("no output", {"--stability"},
      "--output: is missing; --stability needs --output PATH, see --help stability");
  row("a file alone", stability({"s.json"}),
      "s.json: unexpected argument of --stability; see --help stability");
  row("no such file", stability({"--calibrations", "none.json"}),
      "none.json: cannot be read: No such file or directory");
  row("a session", stability({"--session", "s.json"}),
      "--session: is not an option of --stability; it belongs to --render, --report, "
      "--make-cameras, --generate, --pack, --export, --tradeoff");
}

void TestStabilityJob::mistakes() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, line);
  const Outcome outcome = run(arguments, ".");
  QCOMPARE(outcome.err, "hogelscope: " + line + "\n");
  QCOMPARE(outcome.out, QByteArray());
  QCOMPARE(outcome.status, 2);
  QCOMPARE(namesIn("."), QStringList());
}

void TestStabilityJob::stops() {
  QProcess process;
  start(process, stability({"--threads", "1"}), ".");
  QVERIFY(waitUntil(process, [] { return QFileInfo::exists("out"); }));
  send(process, SIGINT);
  waitForEnd(process);
  QCOMPARE(process.exitStatus(), QProcess::CrashExit);
  QCOMPARE(process.exitCode(), SIGINT);
  QCOMPARE(process.readAllStandardError(),
           QByteArray("hogelscope: stopped; what is finished is kept\n"));
  QCOMPARE(namesIn("out"), QStringList());
}

QTEST_GUILESS_MAIN(TestStabilityJob)
#include "test_stability_job.moc"
