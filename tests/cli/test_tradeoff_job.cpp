// SPDX-License-Identifier: BSD-3-Clause
// Tests --tradeoff as a user runs it: files, columns, the Pareto column, the same errors again.
#include <QImage>
#include <QMap>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

namespace {

enum Column {
  name,
  milliseconds = 7,
  rmse = 9,
  psnr,
  maxError,
  seenMismatch,
  pareto,
  fastest,
  upperQuartile,
  lowerQuartile,
  spread,
  runs,
  timedPixels,
  errorPixels,
  psnrLow,
  psnrHigh,
  columns
};

float content(int x, int y, int channel) {
  return float((x * 5 + y * 3 + channel * 40 + (x / 16) * (y / 8)) % 200 + 20) / 255;
}

}  // namespace

class TestTradeoffJob : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir::setCurrent(m_folder->path()));
    writeImageFile("a.png", 128, 128, content);
    writeFile("s.json", text({.display = R"({"hogels": [16, 16], "directions": [8, 8]})",
                              .lightField = R"({"file": "a.png"})",
                              .cameras = R"([{"name": "a", "eye": [0.1, 0, 0.6], "res": [40, 30],
                                "distortion": {"k1": 0.6}, "psf": {"windowSize": 5}}])"}));
  }

  void writesTableAndChart() {
    const Outcome outcome = job({});
    QCOMPARE(outcome.err, QByteArray());
    QCOMPARE(outcome.status, 0);
    QCOMPARE(namesIn("out"), (QStringList{"tradeoff.csv", "tradeoff.png", "tradeoff.svg"}));
    QVERIFY(outcome.out.startsWith("error against the exact pixels"));
    QImage picture("out/tradeoff.png");
    QCOMPARE(picture.size(), QSize(1440, 1040));
    QList<QStringList> rows = tableOf("out/tradeoff.csv");
    QCOMPARE(rows.takeFirst().join(","),
             QString("method,lens,reconstruction,psf,samples,scale,precision,milliseconds,"
                     "mrays_per_s,rmse,psnr,max_error,seen_mismatch,pareto,milliseconds_min,"
                     "milliseconds_q75,milliseconds_q25,spread,runs,timed_pixels,error_pixels,"
                     "psnr_low,psnr_high"));
    QVERIFY(rows.size() >= 20);
    const QByteArray svg = contentOf("out/tradeoff.svg");
    int named = 0;
    for (const QStringList& row : rows) {
      QCOMPARE(row.size(), int(columns));
      named += svg.contains(row[name].toUtf8()) ? 1 : 0;
      QVERIFY(row[fastest].toDouble() > 0);
      QVERIFY(row[fastest].toDouble() <= row[milliseconds].toDouble());
      QVERIFY(row[milliseconds].toDouble() <= row[upperQuartile].toDouble());
      QVERIFY(row[lowerQuartile].toDouble() <= row[milliseconds].toDouble());
      QVERIFY(row[fastest].toDouble() <= row[lowerQuartile].toDouble());
      QCOMPARE(std::isnan(row[spread].toDouble()), row[runs] == "1");
      QCOMPARE(row[errorPixels], QString("1200"));
      QVERIFY(row[psnrLow] == row[psnr] && row[psnrHigh] == row[psnr]);
    }
    QVERIFY2(named >= 8, qPrintable(QString::number(named)));  // others have no free place
    QVERIFY(svg.contains("Error against the exact pixels, RMS in code values"));
  }

  void aSmallBudgetHasAllRows() {
    (void)job({});
    const QList<QStringList> ample = tableOf("out/tradeoff.csv");
    const Outcome outcome = job({"--budget", "0.001", "--set", "camera.res=[64,640]"});
    QCOMPARE(outcome.err, QByteArray());
    QVERIFY(outcome.out.contains("timed once: exact; "));
    QVERIFY(outcome.out.contains("on part of the pixels (see the table): exact; "));
    const QList<QStringList> rows = tableOf("out/tradeoff.csv");
    QCOMPARE(rows.size(), ample.size());
    for (int k = 1; k < rows.size(); ++k) {
      QCOMPARE(rows[k][name], ample[k][name]);
      const double pixels = rows[k][errorPixels].toDouble();
      QVERIFY(pixels >= 30000 && pixels < 64 * 640);
      QVERIFY(rows[k][psnrLow].toDouble() < rows[k][psnr].toDouble());
      QVERIFY(rows[k][psnrHigh].toDouble() >= rows[k][psnr].toDouble());
      QVERIFY(rows[k][milliseconds].toDouble() > 0 && rows[k][rmse].toDouble() >= 0);
    }
    QVERIFY(contentOf("out/tradeoff.svg").contains("on part of the pixels"));
    QVERIFY(job({"--budget", "0"}).err.contains("--budget"));
  }

  /// Which of the methods with the least error is advised depends on times, their error does not.
  void advisesALeastError() {
    const QByteArray out = job({}).out;
    const QRegularExpressionMatch advised =
        QRegularExpression("for a moving view: (.+)\nfor a paper: (.+)\n").match(out);
    QVERIFY2(advised.hasMatch(), out);
    QMap<QString, double> errors;
    for (const QStringList& row : tableOf("out/tradeoff.csv").mid(1))
      errors[row[name]] = row[rmse].toDouble();
    QVERIFY(errors.contains(advised.captured(1)));
    QCOMPARE(errors.value(advised.captured(2), -1), *std::ranges::min_element(errors));
  }

  void theParetoColumnFollowsFromTheOthers() {
    (void)job({});
    QList<QStringList> rows = tableOf("out/tradeoff.csv");
    rows.removeFirst();
    for (const QStringList& row : rows) {
      bool isBeaten = false;
      for (const QStringList& other : rows) {
        const double faster = row[milliseconds].toDouble() - other[milliseconds].toDouble();
        const double better = row[rmse].toDouble() - other[rmse].toDouble();
        isBeaten = isBeaten || (faster >= 0 && better >= 0 && faster + better > 0);
      }
      QCOMPARE(row[pareto], QString(isBeaten ? "0" : "1"));
    }
    QVERIFY(rows.size() >= 20);
  }

  void errorsAreTheSameToTheLastDigit() {
    (void)job({});
    const QList<QStringList> first = tableOf("out/tradeoff.csv");
    (void)job({"--threads", "1"});
    const QList<QStringList> second = tableOf("out/tradeoff.csv");
    for (int k = 0; k < first.size(); ++k) QCOMPARE(second[k].mid(rmse, 4), first[k].mid(rmse, 4));
  }

  void theIdealPicture() {
    const Outcome outcome = job({"--set", "sampling.reconstruction=quadrilinear", "--quiet"});
    QCOMPARE(outcome.out + outcome.err, QByteArray());
    for (const QStringList& row : tableOf("out/tradeoff.csv"))
      if (row[name] == "quadrilinear 8×8") QCOMPARE(row[psnr], QString("inf"));
  }

  void badInput() {
    const Outcome missing = run({"--tradeoff", "--output", "out"}, m_folder->path());
    QCOMPARE(
        missing.err,
        QByteArray("hogelscope: --session: is missing; --tradeoff needs --session FILE, see --help "
                   "tradeoff\n"));
    const Outcome noFile = job({"--set", "lightField.file=b.png"});
    QCOMPARE(noFile.status, 2);
    QVERIFY(noFile.err.contains("b.png: ") && noFile.err.count('\n') == 1);
    QVERIFY(!QFile::exists("out"));
  }

 private:
  Outcome job(const QStringList& more) {
    QStringList all{"--tradeoff", "--session", "s.json", "--output", "out"};
    if (!more.contains("--budget")) all += {"--budget", "0.1"};  // too few rows to leave any out
    return run(all + more, m_folder->path());
  }

  std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_APPLESS_MAIN(TestTradeoffJob)
#include "test_tradeoff_job.moc"
