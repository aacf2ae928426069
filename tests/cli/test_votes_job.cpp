// SPDX-License-Identifier: BSD-3-Clause
// Tests --votes as a user runs it: several files, beside a report, as a trace, and what it refuses.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"

namespace {

QJsonObject trial(const QString& state, const QString& first, const QString& second, int vote) {
  return {{"state", state},
          {"shown", QJsonArray{first, second}},
          {"vote", vote},
          {"seconds", 2.5},
          {"path", QJsonArray{QJsonArray{0, 0, 0.01 * vote, 0, 0.5},
                              QJsonArray{400, 1, 0.02 * vote, 0.1, 0.6}}}};
}

QJsonObject votesOf(const QString& viewer, const QJsonArray& trials) {
  return {{"hogelscope votes", 1},
          {"page", "0badf00d"},
          {"viewer", viewer},
          {"screen",
           QJsonObject{{"width", 0.6}, {"distance", 0.5}, {"pixels", QJsonArray{1920, 1080}}}},
          {"trials", trials}};
}

QByteArray textOf(const QJsonObject& object) {
  return QJsonDocument(object).toJson();
}

}  // namespace

class TestVotesJob : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void grades();
  void pairs();
  void besideAReport();
  void asATrace();
  void mistakes_data();
  void mistakes();

 private:
  [[nodiscard]] Outcome votes(const QStringList& words) const {
    return run(QStringList{"--votes"} + words, m_folder->path());
  }
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestVotesJob::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
  for (int viewer = 0; viewer < 3; ++viewer)
    writeFile(QString("v%1.json").arg(viewer),
              textOf(votesOf(
                  QString("viewer %1").arg(viewer),
                  {trial("a", "original", "good", 5 - viewer % 2),
                   trial("a", "original", "bad", 1 + viewer), trial("b", "original", "good", 4)})));
}

void TestVotesJob::grades() {
  const Outcome outcome = votes({"v0.json", "--votes", "v1.json", "v2.json", "--output", "out"});
  QCOMPARE(outcome.status, 0);
  QVERIFY2(outcome.err.contains("taken for dsis"), outcome.err);
  const QList<QStringList> table = tableOf("out/votes.csv");
  QCOMPARE(table.size(), 6);
  QCOMPARE(table[0], QString("state,test,n,mos,low,high,bt").split(','));
  QCOMPARE(table[1].mid(0, 3), QString("a,good,3").split(','));
  QVERIFY(std::abs(table[1][3].toDouble() - 14 / 3.0) < 1e-12);
  QCOMPARE(table[2].mid(0, 4), QString("a,bad,3,2").split(','));
  QCOMPARE(table[4].mid(0, 3), QString("all states,good,3").split(','));
  const QByteArray page = contentOf("out/votes.html");
  QVERIFY(page.contains("viewer 2") && page.contains("27.9"));  // 1920 px / 0.6 m · 0.5 m · tan 1°
}

void TestVotesJob::pairs() {
  QJsonObject file = votesOf("one", {trial("a", "x", "y", 1), trial("a", "z", "y", 0)});
  file["method"] = "pairs";
  writeFile("p.json", textOf(file));
  const Outcome outcome = votes({"p.json", "--output", "out"});
  QCOMPARE(outcome.status, 0);
  QCOMPARE(outcome.err, QByteArray());
  QVERIFY2(!outcome.out.contains("nan"), outcome.out);
  const QList<QStringList> table = tableOf("out/votes.csv");
  QCOMPARE(table.size(), 7);
  QCOMPARE(table[1].mid(0, 4), QString("a,x,1,").split(','));
  // x won of y 1.5 to 0.5 with the added tie; z and y are alike.
  QVERIFY(std::abs(table[1][6].toDouble() - table[2][6].toDouble() - std::log(3)) < 1e-6);
  QVERIFY(std::abs(table[3][6].toDouble() - table[2][6].toDouble()) < 1e-6);
}

void TestVotesJob::besideAReport() {
  QDir().mkdir("out");
  writeFile(
      "out/report.csv",
      "state,test,mse,psnr,eye_x\na,good.png,1,40,0\na,codec/bad.jpg,9,30,0\nb,good.png,2,inf,0\n");
  writeFile("out/metrics.csv",
            "state,test,flip,weight,problem\na,good.png,0.1,1,\n"
            "a,codec/bad.jpg,0.4,1,\nb,good.png,0.2,1,\n");
  const Outcome outcome = votes({"v0.json", "v1.json", "v2.json", "--output", "out"});
  QCOMPARE(outcome.status, 0);
  const QByteArray page = contentOf("out/votes.html");
  // Of psnr two rows have a finite number; flip falls with the grade, 14/3, 4 and 2.
  QVERIFY(page.contains("<td>psnr</td><td class=\"n\">2</td><td class=\"n\">1</td>"));
  QVERIFY(page.contains(
      "<td>flip</td><td class=\"n\">3</td><td class=\"n\">-0.996</td><td class=\"n\">-1</td>"));
  QVERIFY(!page.contains("<td>eye_x</td>") && !page.contains("<td>weight</td>"));
  // A report of other tests is said.
  writeFile("out/report.csv", "state,test,psnr\na,other.png,40\n");
  QFile::remove("out/metrics.csv");
  QVERIFY(votes({"v0.json", "--output", "out"}).err.contains("no rows of the votes' states"));
}

void TestVotesJob::asATrace() {
  const Outcome outcome = run({"--make-cameras", "v1.json", "--session", sampleSession, "--output",
                               "cameras.json", "--set", "cameraSet.count=12"},
                              m_folder->path());
  QVERIFY2(outcome.status == 0, outcome.err);
  const QJsonArray cameras =
      QJsonDocument::fromJson(contentOf("cameras.json")).object()["cameras"].toArray();
  QVERIFY(cameras.size() > 1);
  for (const auto& camera : cameras) {
    const double z = camera.toObject()["eye"].toArray()[2].toDouble();
    QVERIFY(z >= 0.5 && z <= 0.6);
  }
}

void TestVotesJob::mistakes_data() {
  QTest::addColumn<QByteArray>("content");
  QTest::addColumn<QByteArray>("line");
  const auto with = [](const QString& key, const QJsonValue& value) {
    QJsonObject object = votesOf("other", {trial("a", "original", "good", 4)});
    object[key] = value;
    return textOf(object);
  };
  const auto withTrial = [&](const QString& key, const QJsonValue& value) {
    QJsonObject one = trial("a", "original", "good", 4);
    one[key] = value;
    return with("trials", QJsonArray{one});
  };
  QTest::newRow("no votes") << QByteArray("{\"display\": {}}") << QByteArray("no file of votes");
  QTest::newRow("cut") << textOf(votesOf("other", {})).left(40) << QByteArray("x.json: ");
  QTest::newRow("version") << with("hogelscope votes", 2) << QByteArray("2 is not 1");
  QTest::newRow("another page") << with("page", "1")
                                << QByteArray("is of another page than v0.json");
  QTest::newRow("the same viewer")
      << with("viewer", "viewer 0") << QByteArray("has voted in a file before");
  QTest::newRow("nobody") << with("viewer", "") << QByteArray("viewer: is missing");
  QTest::newRow("another method") << with("method", "pairs") << QByteArray("method: is another");
  QTest::newRow("unknown method") << with("method", "acr") << QByteArray("is not pairs or dsis");
  QTest::newRow("unknown key") << with("colour", 1) << QByteArray("colour");
  QTest::newRow("no list") << with("trials", 3) << QByteArray("trials: is not a list");
  QTest::newRow("screen") << with("screen", QJsonObject{{"width", -1}})
                          << QByteArray("screen.width");
  QTest::newRow("grade") << withTrial("vote", 0) << QByteArray("trials[0].vote: 0 is not 1 to 5");
  QTest::newRow("above") << withTrial("vote", 6) << QByteArray("trials[0].vote");
  QTest::newRow("no number") << withTrial("vote", "good") << QByteArray("trials[0].vote");
  QTest::newRow("names") << withTrial("shown", QJsonArray{"a"})
                         << QByteArray("trials[0].shown: is not");
  QTest::newRow("reference") << withTrial("shown", QJsonArray{"good", "original"})
                             << QByteArray("has another reference than original");
  QTest::newRow("path") << withTrial("path", QJsonArray{QJsonArray{0, 2, 0, 0, 1}})
                        << QByteArray("trials[0].path[0]: is not [milliseconds");
  QTest::newRow("again") << with("trials", QJsonArray{trial("a", "original", "good", 4),
                                                      trial("a", "original", "good", 5)})
                         << QByteArray("trials[1]: answers a question again");
}

void TestVotesJob::mistakes() {
  QFETCH(QByteArray, content);
  QFETCH(QByteArray, line);
  writeFile("x.json", content);
  const Outcome outcome = votes({"v0.json", "x.json", "--output", "out"});
  QCOMPARE(outcome.status, 2);
  QVERIFY2(outcome.err.contains(line) && outcome.err.contains("x.json"), outcome.err);
  QCOMPARE(outcome.err.count('\n'), 1);
  QVERIFY(!QFile::exists("out"));
}

QTEST_GUILESS_MAIN(TestVotesJob)
#include "test_votes_job.moc"
