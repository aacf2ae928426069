// SPDX-License-Identifier: BSD-3-Clause
// Tests --stability as a user runs it: its files, its flags, what it refuses.
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

/// How many of the 41×41 pixels of the first lens are blue in lenses.png, by a method.
int blueOnes(int method) {
  const QSize size = sizeOf("out/lenses.png");
  const auto values = bytesOf("out/lenses.png");
  const std::size_t channels = values.size() / std::size_t(size.width() * size.height());
  constexpr double across = (1000 - 2 * 14 - 4 * 16) / 5.0;  // points, half as many as pixels
  constexpr double up = across * 480 / 640;
  int count = 0;
  for (int row = 0; row < 41; ++row) {
    for (int column = 0; column < 41; ++column) {
      const int x = int(2 * (14 + method * (across + 16) + (column + 0.5) * across / 41));
      const int y = int(2 * (72 + (row + 0.5) * up / 41));
      const std::size_t at = std::size_t(y * size.width() + x) * channels;
      count += values[at] == 0x79 && values[at + 1] == 0xbf && values[at + 2] == 0xe8 ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

class TestStabilityJob : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void writesItsFiles();
  void mistakes_data();
  void mistakes();
  void stops();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestStabilityJob::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestStabilityJob::writesItsFiles() {
  writeFile("list.json", list);
  const QStringList cameras{"--calibrations", "list.json"};
  const Outcome one = run(stability(cameras), ".");
  QCOMPARE(one.err, QByteArray());
  QCOMPARE(
      one.out,
      QByteArray(
          "14 lens(es) and two maps in out/stability.csv and "
          "out/stability.png\n  a, b: brown\n  c: brown\n2 lens(es) of the calibrations, pixel by "
          "pixel, in out/lenses.png\n"));
  QCOMPARE(one.status, 0);
  QCOMPARE(namesIn("out"), QStringList({"lenses.png", "stability.csv", "stability.png"}));
  const QByteArray table = contentOf("out/stability.csv");
  QVERIFY(table.startsWith("kind,lens,method,points,right,"));
  QCOMPARE(table.count("\nlens,\"a, b\","), 5);
  QCOMPARE(table.count("\nlens,c,"), 5);
  QCOMPARE(table.count("\nlens,c,OpenCV 5,1681,1681,0,0,0,0,0,right,,,\n"), 1);
  const QSize size = sizeOf("out/stability.png");
  QCOMPARE(size.width(), 2000);
  QVERIFY(size.height() > 1000);
  const QList<QByteArray> lines = table.split('\n');
  for (int method = 0; method < 5; ++method) {
    const QStringList row = cellsOf(lines[1 + 12 * 5 + method]);  // after the twelve hard lenses
    QCOMPARE(row[1], QString("a, b"));
    QCOMPARE(blueOnes(method), row[4].toInt());
  }
  QVERIFY(blueOnes(0) < 1681);
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
      "--make-cameras, --make-twin, --generate, --pack, --export, --optimise, --tradeoff, "
      "--measure, --sweep, "
      "--depth");
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
