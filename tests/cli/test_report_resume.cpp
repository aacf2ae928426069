// SPDX-License-Identifier: BSD-3-Clause
// Tests unattended reports: killed, stopped, out of disk or memory, they lose nothing that is
// finished, and the same command ends with the same files to the byte.
#include <sys/resource.h>

#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "tests/cli/long_report.h"
#include "tests/cli/program.h"

namespace {

void limitTo(QProcess& process, int resource, rlim_t most) {
  process.setChildProcessModifier([resource, most] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{most, most};
    ::setrlimit(__rlimit_resource_t(resource), &limit);
  });
}

}  // namespace

class TestReportResume : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void stopped_data();
  void stopped();
  void fullDisk();
  void anotherReport();
  void twoAtOnce();
  void noMemoryForOneState();

 private:
  std::pair<int, QByteArray> stoppedAfter(int rows, int signal, const QString& folder);
  Outcome runHere(const QStringList& arguments) { return run(arguments, m_folder.path()); }

  QTemporaryDir m_folder;
};

void TestReportResume::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  writeLongSession();
  const Outcome whole = runHere(report("whole"));
  QCOMPARE(whole.err, QByteArray());
  QCOMPARE(whole.status, 0);
}

/// Starts a report and sends the signal when its journal holds `rows`; again if it was faster and
/// came to its end. How many rows there are then, and what it told.
std::pair<int, QByteArray> TestReportResume::stoppedAfter(int rows, int signal,
                                                          const QString& folder) {
  for (;;) {
    QDir(folder).removeRecursively();
    QProcess process;
    start(process, report(folder), m_folder.path());
    waitUntil(process, [&] { return rowsIn(folder) >= rows; });
    send(process, signal);
    const Outcome outcome = ended(process);
    if (outcome.status > 0 || rowsIn(folder) >= rows) return {rowsIn(folder), outcome.err};
  }
}

void TestReportResume::stopped_data() {
  QTest::addColumn<int>("signal");
  QTest::addColumn<int>("rows");  ///< on disk before the signal
  QTest::newRow("kill -9 in the first test") << SIGKILL << 5;
  QTest::newRow("kill -9 in the second test") << SIGKILL << stateCount + 5;
  QTest::newRow("Ctrl-C") << SIGINT << 7;
}

void TestReportResume::stopped() {
  QFETCH(int, signal);
  QFETCH(int, rows);
  const QString folder = QTest::currentDataTag();
  const auto [before, told] = stoppedAfter(rows, signal, folder);
  QVERIFY(before >= rows && before < 2 * stateCount);
  // On a machine so busy that nothing hears the signal for a while nobody counts.
  const QByteArray counted = "hogelscope: " + QByteArray::number(before) +
                             " of 80 views are done; the same command goes on from there\n";
  const QByteArray stopped = "hogelscope: stopped; what is finished is kept\n";
  if (signal == SIGINT) QVERIFY2(told == counted + stopped || told == stopped, told);
  const Outcome outcome = runHere(report(folder));
  QCOMPARE(outcome.err, "hogelscope: went on after " + QByteArray::number(before) +
                            " views of an earlier run\n");
  QCOMPARE(outcome.status, 0);
  QCOMPARE(difference(folder, "whole"), QString());
}

void TestReportResume::fullDisk() {
  QProcess process;
  limitTo(process, RLIMIT_FSIZE, 3000);
  QStringList arguments = report("disk");
  arguments.removeOne("--images");
  start(process, arguments, m_folder.path());
  waitForEnd(process);
  QCOMPARE(process.readAllStandardError(),
           QByteArray("hogelscope: disk/report.journal: cannot be written: File too large\n"));
  QCOMPARE(process.exitCode(), 2);
  const int rows = rowsIn("disk");
  QVERIFY(rows > 5);
  const Outcome outcome = runHere(arguments);
  QCOMPARE(outcome.err,
           "hogelscope: went on after " + QByteArray::number(rows) + " views of an earlier run\n");
  QCOMPARE(contentOf("disk/report.csv"), contentOf("whole/report.csv"));
}

void TestReportResume::anotherReport() {
  QVERIFY(stoppedAfter(3, SIGKILL, "other").first >= 3);
  const QStringList changed{"--set", "psf.sigma=0.5", "--set", "sampling.samplesPerPixel=1"};
  const Outcome outcome = runHere(report("other", changed));
  QCOMPARE(outcome.err,
           QByteArray("hogelscope: other/report.journal: was of another report that did not "
                      "finish; begun anew\n"));
  QVERIFY(contentOf("other/report.csv") != contentOf("whole/report.csv"));
}

void TestReportResume::twoAtOnce() {
  QProcess process;
  do {  // again if it was faster
    waitForEnd(process);
    start(process, report("shared"), m_folder.path());
    waitUntil(process, [] { return rowsIn("shared") >= 1; });
    send(process, SIGSTOP);  // so that it is still there, however long the other takes
  } while (rowsIn("shared") < 1 && process.exitCode() == 0);
  const Outcome outcome = runHere(report("shared"));
  send(process, SIGCONT);
  QCOMPARE(outcome.err, QByteArray("hogelscope: shared/report.journal: is in use: another "
                                   "hogelscope makes this report; wait, or choose another "
                                   "folder\n"));
  QCOMPARE(outcome.status, 2);
  waitForEnd(process);
  QCOMPARE(difference("shared", "whole"), QString());
}

/// The others go on, and the gate fails.
void TestReportResume::noMemoryForOneState() {
#ifdef __SANITIZE_ADDRESS__
  QSKIP("the sanitizer's own memory is beyond any limit");
#endif
  QByteArray document = longSession();
  const QByteArray small = "[90, 68]";
  const qsizetype res = document.indexOf(small, document.indexOf("\"s12\""));
  writeFile("large.json", document.replace(res, small.size(), "[16384, 16384]"));
  QProcess process;
  limitTo(process, RLIMIT_AS, rlim_t{1} << 30U);
  start(process,
        {"--report", "--session", "large.json", "--states", "s1?", "--test", "b.png", "--output",
         "memory", "--fail-below", "1", "--quiet"},
        m_folder.path());
  waitForEnd(process);
  QCOMPARE(process.readAllStandardError(),
           QByteArray("hogelscope: s12: b.png: not enough memory for its picture\n"));
  QCOMPARE(process.exitCode(), 1);
  const QByteArray rows = contentOf("memory/report.csv");
  QVERIFY(rows.contains("\ns12,b.png,nan,nan,nan,nan,nan,0,"));
  QCOMPARE(rows.count("\ns1"), 10);
  QCOMPARE(rows.count("nan"), 5);
  QVERIFY(contentOf("memory/metrics.csv").contains(",not enough memory for its picture\n"));
}

QTEST_GUILESS_MAIN(TestReportResume)
#include "test_report_resume.moc"
