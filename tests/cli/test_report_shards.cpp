// SPDX-License-Identifier: BSD-3-Clause
// Tests reports and pictures that several processes share: whatever happens to them, the files are
// those of one run, to the byte.
#include <QTemporaryDir>
#include <QTest>
#include <csignal>

#include "tests/cli/long_report.h"
#include "tests/cli/program.h"

class TestReportShards : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void killedAndMissing();
  void atWork();
  void otherShards();
  void statusOfNothing();
  void statusOfTheImpossible();
  void hashesAreKept();
  void anotherFileOfTheSameSizeAndTime();
  void hashOfAStore();
  void pictures();
  void wrongShards_data();
  void wrongShards();

 private:
  Outcome runHere(const QStringList& arguments) { return run(arguments, m_folder.path()); }
  static QStringList shard(const QString& folder, const QString& part) {
    return report(folder, {"--shard", part});
  }

  QTemporaryDir m_folder;
};

void TestReportShards::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  writeLongSession();
  const Outcome whole = runHere(report("whole"));
  QCOMPARE(whole.err, QByteArray());
  QCOMPARE(whole.status, 0);
}

/// Of four shards the second is killed, the third is never started, the first is started twice.
void TestReportShards::killedAndMissing() {
  QProcess killed;
  do {  // again if it was faster
    QDir("killed").removeRecursively();
    start(killed, shard("killed", "2/4"), m_folder.path());
    waitUntil(killed, [] { return rowsIn("killed", ".2-4") >= 3; });
    send(killed, SIGKILL);
    waitForEnd(killed);
  } while (killed.exitStatus() == QProcess::NormalExit);
  QProcess first;
  QProcess again;
  start(first, shard("killed", "1/4"), m_folder.path());
  start(again, shard("killed", "1/4"), m_folder.path());
  const std::array<Outcome, 2> both{ended(first), ended(again)};
  for (const Outcome& outcome : both) {
    // One of them, unless it came when the other was ready.
    QVERIFY(outcome.status == 0 || outcome.err.contains("report.journal.1-4: is in use"));
  }
  QVERIFY(both[0].status == 0 || both[1].status == 0);
  const Outcome last = runHere(shard("killed", "4/4"));
  QCOMPARE(last.out, QByteArray("shard 4/4: its 20 views are done; the command without --shard "
                                "writes the report\n"));
  QCOMPARE(last.status, 0);

  QVERIFY(!QFile::exists("killed/report.csv") && !QFile::exists("killed/report.html"));
  const int rows = rowsIn("killed", ".2-4");
  const Outcome status = runHere({"--status", "killed"});
  QCOMPARE(status.out, QByteArray::number(40 + rows) +
                           " of 80 views are done; the report is not written\n4 shards\n"
                           "  done       1, 4\n  stopped    2\n  not begun  3\n");
  QCOMPARE(status.status, 1);

  // What a kill between the writing and the naming of a picture leaves.
  for (const char* folder : {"killed", "killed/reference", "killed/test2"})
    writeFile(QString(folder) + "/.hogelscope-47v4gb1kh22x.part", "half");
  const Outcome outcome = runHere(report("killed"));
  QCOMPARE(outcome.err, "hogelscope: went on after " + QByteArray::number(40 + rows) +
                            " views of an earlier run\n");
  QCOMPARE(outcome.status, 0);
  QCOMPARE(difference("killed", "whole"), QString());
  QCOMPARE(runHere({"--status", "killed"}).out,
           QByteArray("the report is finished: killed/report.csv\n"));
}

/// The run without a shard does not take a part that is still growing.
void TestReportShards::atWork() {
  QProcess process;
  do {
    QDir("work").removeRecursively();
    start(process, shard("work", "1/2"), m_folder.path());
    waitUntil(process, [] { return rowsIn("work", ".1-2") >= 1; });
    send(process, SIGSTOP);
  } while (process.state() == QProcess::NotRunning);
  const Outcome status = runHere({"--status", "work"});
  const Outcome outcome = runHere(report("work"));
  send(process, SIGCONT);
  QVERIFY2(status.out.endsWith("2 shards\n  at work    1\n  not begun  2\n"), status.out);
  QCOMPARE(outcome.err, QByteArray("hogelscope: work/report.journal.1-2: is in use: shard 1/2 of "
                                   "this report is still at work; wait\n"));
  QCOMPARE(outcome.status, 2);
  QCOMPARE(ended(process).status, 0);
}

/// Shards of another number, or of another report, are no harm.
void TestReportShards::otherShards() {
  const QStringList changed{"--set", "psf.sigma=0.5", "--shard", "3/3"};
  QCOMPARE(runHere(report("other", changed)).status, 0);
  for (const char* part : {"1/2", "1/4", "50/60"})
    QCOMPARE(runHere(shard("other", part)).status, 0);
  const Outcome status = runHere({"--status", "other"});
  QVERIFY2(status.out.contains("4 shards\n  done       1\n  not begun  2 to 4\n"), status.out);
  QVERIFY2(status.out.contains("26 of 80 views are done"), status.out);  // of the changed session
  QCOMPARE(runHere(report("other")).status, 0);
  QCOMPARE(namesIn("other").filter("journal"), QStringList{"report.journal.3-3"});
  QVERIFY(QFile::remove("other/report.journal.3-3"));
  for (const char* test : {"1", "2"})
    QVERIFY(QFile::remove(QString("other/report.panel%1.3-3").arg(test)));
  QCOMPARE(difference("other", "whole"), QString());
}

void TestReportShards::statusOfNothing() {
  QVERIFY(QDir().mkpath("empty"));
  QCOMPARE(runHere({"--status", "empty"}).err,
           QByteArray("hogelscope: empty: holds no report, neither finished nor begun\n"));
  QCOMPARE(runHere({"--status", "none"}).err, QByteArray("hogelscope: none: is not a folder\n"));
}

/// A file that has not changed is not read again; one that has is.
/// Numbers that no report has, in a journal that somebody else has written.
void TestReportShards::statusOfTheImpossible() {
  const auto journal = [](const char* name, const char* states) {
    writeFile(
        QString("odd/report.journal") + name,
        QByteArray(R"({"hogelscope report":1,"key":"k","states":)") + states + ",\"tests\":1}\n");
  };
  journal(".1-1000000000000000", "1000000000000000");
  QCOMPARE(runHere({"--status", "odd"}).status, 2);
  journal(".2-1000000000000000", "99999999");
  const Outcome outcome = runHere({"--status", "odd"});
  QCOMPARE(outcome.status, 1);
  QVERIFY2(outcome.out.contains("not begun  1, 3 to 99999999\n"), outcome.out);
}

void TestReportShards::hashesAreKept() {
  QVERIFY(!QFile::exists("whole/report.hashes"));  // it has the paths of all inputs
  QCOMPARE(runHere(shard("kept", "1/40")).status, 0);
  const QByteArray hashes = contentOf("kept/report.hashes");
  QByteArrayList lines = hashes.split('\n');
  for (QByteArray& line : lines)
    if (line.size() > 32 && line[32] == ' ') line.replace(0, 2, "zz");
  writeFile("kept/report.hashes", lines.join('\n'));
  QCOMPARE(runHere(report("kept")).status, 0);
  QVERIFY(contentOf("kept/report.html").contains("XXH3-128 zz"));
  QFile file("b.png");
  QVERIFY(file.open(QIODevice::ReadWrite));
  QVERIFY(file.setFileTime(QDateTime::currentDateTime(), QFileDevice::FileModificationTime));
  file.close();
  writeFile("kept/report.hashes", hashes);
  QCOMPARE(runHere(shard("kept", "1/40")).status, 0);
  QCOMPARE(contentOf("kept/report.hashes").count("b.png"), 2);
  // Cut off by a full disk or kill -9, and not by us.
  writeFile("kept/report.hashes", hashes.left(hashes.size() - 30));
  QCOMPARE(runHere(report("kept")).status, 0);
  QVERIFY(!contentOf("kept/report.html").contains("XXH3-128 zz"));
  writeFile("kept/report.hashes", "my own notes");
  const Outcome outcome = runHere(report("kept"));
  QVERIFY2(outcome.err.startsWith("hogelscope: kept/report.hashes: "), outcome.err);
  QCOMPARE(outcome.status, 2);
  QCOMPARE(contentOf("kept/report.hashes"), QByteArray("my own notes"));
}

/// A report has rows of one file alone, also where another has taken its place and looks the same.
void TestReportShards::anotherFileOfTheSameSizeAndTime() {
  const QByteArray content = contentOf("b.png");
  const QDateTime time = QFileInfo("b.png").lastModified();
  const auto hashes = [] {
    constexpr qsizetype length = 9 + 32;
    const QByteArray page = contentOf("same/report.html");
    QByteArrayList all;
    for (qsizetype at = 0; (at = page.indexOf("XXH3-128 ", at)) >= 0; ++at)
      all.append(page.mid(at, length));
    return all;
  };
  QCOMPARE(runHere(report("same")).status, 0);
  const QByteArrayList first = hashes();
  const QByteArray rows = contentOf("same/report.csv");
  // Decoders stop at the end of the picture.
  const QByteArray other = contentOf("a.png");
  writeFile("b.png", other + QByteArray(content.size() - other.size(), '\0'));
  QFile file("b.png");
  QVERIFY(file.open(QIODevice::ReadWrite));
  QVERIFY(file.setFileTime(time, QFileDevice::FileModificationTime));
  file.close();
  QCOMPARE(QFileInfo("b.png").lastModified(), time);
  QCOMPARE(QFileInfo("b.png").size(), content.size());
  QCOMPARE(runHere(report("same")).status, 0);
  QVERIFY(first.size() >= 2);
  QVERIFY(hashes() != first);
  QVERIFY(contentOf("same/report.csv") != rows);
  writeFile("b.png", content);
}

/// A store says what it holds: nobody reads it whole.
void TestReportShards::hashOfAStore() {
  QCOMPARE(runHere({"--pack", "b.png", "--session", "s.json", "--output", "b.tif"}).status, 0);
  QStringList arguments = report("store");
  arguments.replaceInStrings("b.png", "b.tif");
  QCOMPARE(runHere(arguments + QStringList{"--shard", "1/40"}).status, 0);
  const QByteArray hashes = contentOf("store/report.hashes");
  QVERIFY(hashes.contains("a.png") && !hashes.contains("b.tif"));
  const Outcome outcome = runHere(arguments);
  QCOMPARE(outcome.status, 0);
  const QByteArray page = contentOf("store/report.html");
  QVERIFY(page.contains("XXH3-128 of the pages "));
  // Other content is another report.
  QCOMPARE(runHere({"--pack", "a.png", "--session", "s.json", "--output", "b.tif"}).status, 0);
  QCOMPARE(runHere(arguments).status, 0);
  const auto hashIn = [](const QByteArray& text) {
    return text.mid(text.indexOf("XXH3-128 of the pages "), 60);
  };
  QVERIFY(hashIn(contentOf("store/report.html")) != hashIn(page));
}

void TestReportShards::pictures() {
  const auto render = [this](const QString& folder, const QStringList& more) {
    return runHere(QStringList{"--render", "--session", "s.json", "--output", folder} + more);
  };
  QCOMPARE(render("all", {}).status, 0);
  QCOMPARE(render("parts", {"--shard", "1/3"}).out, QByteArray("14 picture(s) in parts\n"));
  QCOMPARE(render("parts", {"--shard", "2/3"}).out, QByteArray("13 picture(s) in parts\n"));
  QCOMPARE(render("parts", {"--shard", "3/3"}).out, QByteArray("13 picture(s) in parts\n"));
  QCOMPARE(difference("parts", "all"), QString());
  QCOMPARE(render("parts", {"--shard", "41/50"}).out, QByteArray("0 picture(s) in parts\n"));
}

void TestReportShards::wrongShards_data() {
  QTest::addColumn<QString>("shard");
  for (const char* text : {"0/4", "5/4", "1", "1/", "/2", "1/2/3", "1.5/2", "-1/2", "a/b", "1/0",
                           "99999999999999999999/2", "1 /2"})
    QTest::newRow(text) << text;
}

void TestReportShards::wrongShards() {
  QFETCH(const QString, shard);
  const Outcome outcome = runHere(report("wrong", {"--shard", shard}));
  QCOMPARE(
      outcome.err,
      ("hogelscope: --shard " + shard + ": must be K/N, such as 2/8, with 1 ≤ K ≤ N\n").toUtf8());
  QCOMPARE(outcome.status, 2);
  QVERIFY(!QFile::exists("wrong"));
}

QTEST_GUILESS_MAIN(TestReportShards)
#include "test_report_shards.moc"
