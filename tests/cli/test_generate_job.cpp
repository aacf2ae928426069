// SPDX-License-Identifier: BSD-3-Clause
// Tests --generate as a user runs it: what it writes, and what it refuses before it writes.
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <filesystem>

#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

class TestGenerateJob : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void makesTheSampleAgain();
  void makesItsFolder();
  void degrades();
  void refuses_data();
  void refuses();
  void needsRoom();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestGenerateJob::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

/// The README's command.
void TestGenerateJob::makesTheSampleAgain() {
  const Outcome outcome = run({"--generate", "scene", "--session",
                               HOGELSCOPE_SOURCE_DIR "/data/table1.json", "--output", "scene.png"},
                              m_folder->path());
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.out, QByteArray("scene.png: 2560×2560 px\n"));
  QCOMPARE(outcome.status, 0);
  QCOMPARE(namesIn("."), QStringList{"scene.png"});
  const auto made = bytesOf("scene.png");
  QCOMPARE(made.size(), std::size_t(3 * 2560 * 2560));
  QVERIFY(made == bytesOf(HOGELSCOPE_SOURCE_DIR "/data/scene.png"));
}

void TestGenerateJob::makesItsFolder() {
  const Outcome outcome = run({"--generate", "scene", "--session", sampleSession, "--output",
                               "new/deeper/g.png", "--set", "display.hogels=[2,3]", "--quiet"},
                              m_folder->path());
  QCOMPARE(outcome.err + outcome.out, QByteArray());
  QCOMPARE(namesIn("new/deeper"), QStringList{"g.png"});
  QCOMPARE(sizeOf("new/deeper/g.png"), QSize(40, 60));
}

/// A copy that differs as much as it was asked to; the same with the same seed.
void TestGenerateJob::degrades() {
  const auto made = [this](const QString& file, const QStringList& more) {
    const QStringList arguments{"--generate", "edge",
                                "--session",  sampleSession,
                                "--output",   file,
                                "--set",      "display.hogels=[8,6]",
                                "--set",      "pattern.depth=0.05",
                                "--quiet"};
    const Outcome outcome = run(arguments + more, m_folder->path());
    return outcome.status == 0 ? bytesOf(file) : std::vector<std::uint8_t>();
  };
  const auto plain = made("a.png", {});
  QCOMPARE(plain.size(), std::size_t(3 * 160 * 120));
  QVERIFY(plain != made("b.png", {"--set", "pattern.angle=40"}));
  const auto noisy = made("c.png", {"--degrade", "noise:4"});
  double squares = 0;
  for (std::size_t k = 0; k < plain.size(); ++k)
    squares += std::pow(double(plain[k]) - noisy[k], 2) / double(plain.size());
  QVERIFY2(std::abs(squares - 16) < 0.5, qPrintable(QString::number(squares)));
  QVERIFY(noisy == made("d.png", {"--degrade", "noise:4"}));
  QVERIFY(noisy != made("e.png", {"--degrade", "noise:4", "--seed", "5"}));
}

void TestGenerateJob::refuses_data() {
  QTest::addColumn<QStringList>("more");
  QTest::addColumn<QByteArray>("line");
  QTest::newRow("a field")
      << QStringList{"--set", "pattern.dept=1"}
      << QByteArray("override: pattern.dept: is not known here; did you mean \"depth\"?");
  QTest::newRow("a range") << QStringList{"--set", "pattern.depth=11"}
                           << QByteArray(
                                  "override: pattern.depth: 11 is out of range: -10 to 10 m");
  QTest::newRow("more than PNG has")
      << QStringList{"--set", "display.hogels=[65536,1]", "--set", "display.directions=[16,1]"}
      << QByteArray("a.png: cannot be written: PNG ends at 1000000 px; use TIFF");
  QTest::newRow("a copy") << QStringList{"--degrade", "jpeg:0"}
                          << QByteArray(
                                 "degradation: jpeg:0: needs a number from 1 to 100 after jpeg:");
  QTest::newRow("a seed of nothing")
      << QStringList{"--degrade", "blur:1", "--seed", "2"}
      << QByteArray("--seed: is of the noise; it needs --degrade noise:SIGMA");
}

void TestGenerateJob::refuses() {
  QFETCH(QStringList, more);
  QFETCH(QByteArray, line);
  const Outcome outcome =
      run(QStringList{"--generate", "edge", "--session", sampleSession, "--output", "a.png"} + more,
          m_folder->path());
  QCOMPARE(outcome.err, "hogelscope: " + line + "\n");
  QCOMPARE(outcome.status, 2);
  QCOMPARE(namesIn("."), QStringList());
}

/// 1.4 TB of noise: told by a few rows of it, before anything is there.
void TestGenerateJob::needsRoom() {
  constexpr double bytesOfColumn = 3.0 * 60000 * 16 * 8;
  // Noise takes half of its pixels' bytes, since half of all values are saturated.
  const auto available = double(std::filesystem::space(m_folder->path().toStdString()).available);
  // Others may free some of the disk meanwhile.
  const int columns = 2 + int(6 * available / bytesOfColumn);
  if (columns > 65536) QSKIP("the disk has room for any light field");
  const Outcome outcome =
      run({"--generate", "edge", "--session", sampleSession, "--output", "a.png", "--degrade",
           "noise:2", "--set", QString("display.hogels=[%1,60000]").arg(columns), "--set",
           "display.directions=[16,8]"},
          m_folder->path());
  const QRegularExpression line(
      "^hogelscope: a.png: cannot be written: it needs about ([\\d.]+) GB, the disk has [\\d.]+ "
      "[GM]B "
      "left\n$");
  const QRegularExpressionMatch match = line.match(outcome.err);
  QVERIFY2(match.hasMatch(), outcome.err.constData());
  const double part = match.captured(1).toDouble() * 1e9 / (columns * bytesOfColumn);
  QVERIFY2(part > 0.35 && part < 1, outcome.err.constData());
  QCOMPARE(outcome.status, 2);
  QCOMPARE(namesIn("."), QStringList());
}

QTEST_GUILESS_MAIN(TestGenerateJob)
#include "test_generate_job.moc"
