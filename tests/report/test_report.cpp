// SPDX-License-Identifier: BSD-3-Clause
// Tests the report's CSV, its numbers and its named averages.
#include <QTest>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/base/text.h"
#include "report/page/report_tables.h"
#include "tests/core/random.h"
#include "tests/report/metric_values.h"

using namespace hogelscope;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

const MetricSet metrics;

const std::string header = "state,test,mse,psnr,mse_seen,psnr_seen,ssim,seen,eye_x,eye_y,eye_z\n";

ReportRow row(const std::string& state, double mse) {
  return {state, "a.png", metricValues(mse), {0, 0, 1}};
}

std::string csvOf(const std::vector<ReportRow>& rows) {
  return reportCsv(rows, metrics);
}

ReportSummary summarise(const std::vector<ReportRow>& rows) {
  return summariseRows(rows, metrics);
}

QString lastLine(const std::string& text) {
  return QString::fromStdString(text).split('\n').at(1);
}

}  // namespace

class TestReport : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void csvOfNothingIsTheHeader();
  void csvRow();
  void csvRowsKeepTheirOrder();
  void csvOfSpecialNumbers();
  void csvQuotes_data();
  void csvQuotes();
  void csvKeepsNegativeNumbers();
  void bytesText_data();
  void bytesText();
  void numberText_data();
  void numberText();
  void numberTextReadsBack();
  void summary();
  void summaryOfIdenticalViews();
  void summaryOfNothing();
  void summaryInWords();
  void rowsThatCompareNothing();
};

void TestReport::csvOfNothingIsTheHeader() {
  QVERIFY(csvOf({}) == header);
}

void TestReport::csvRow() {
  ReportRow one{"Fig 1", "b.png", metricValues(650.25, 0.75, {}), {0.1, -2, 1e-7}};
  one.values[psnrSeenColumn] = 10;
  one.values[mseSeenColumn] = 6502.5;
  one.values[seenColumn] = 0.125;
  QVERIFY(csvOf({one}) == header + "Fig 1,b.png,650.25,20,6502.5,10,0.75,0.125,0.1,-2,1e-07\n");
}

void TestReport::csvRowsKeepTheirOrder() {
  const QStringList lines =
      QString::fromStdString(csvOf({row("b", 1), row("a", 2), row("c", 0)})).split('\n');
  QCOMPARE(lines.size(), 5);  // the text ends in a line end
  QVERIFY(lines[1].startsWith("b,") && lines[2].startsWith("a,") && lines[3].startsWith("c,"));
  QVERIFY(lines[4].isEmpty());
}

void TestReport::csvOfSpecialNumbers() {
  ReportRow identical{"s", "t", metrics.noValues(), {0, 0, 0}};
  identical.values[mseColumn] = 0;
  identical.values[psnrColumn] = infinite;
  QCOMPARE(lastLine(csvOf({identical})), QString("s,t,0,inf,nan,nan,nan,0,0,0,0"));
}

void TestReport::csvQuotes_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("cell");
  QTest::newRow("plain") << "Fig 1 (left)"
                         << "Fig 1 (left)";
  QTest::newRow("comma") << "a,b"
                         << "\"a,b\"";
  QTest::newRow("quote") << "5\" panel"
                         << "\"5\"\" panel\"";
  QTest::newRow("only a quote") << "\""
                                << "\"\"\"\"";
  QTest::newRow("line end") << "a\nb"
                            << "\"a\nb\"";
  QTest::newRow("carriage return") << "a\rb"
                                   << "\"a\rb\"";
  QTest::newRow("empty") << ""
                         << "";
  QTest::newRow("UTF-8") << "Köln"
                         << "Köln";
  QTest::newRow("formula") << "=1+1"
                           << "'=1+1";
  QTest::newRow("formula with quotes") << "=HYPERLINK(\"http://a\",\"b\")"
                                       << "\"'=HYPERLINK(\"\"http://a\"\",\"\"b\"\")\"";
  QTest::newRow("plus") << "+30°"
                        << "'+30°";
  QTest::newRow("minus") << "-30°"
                         << "'-30°";
  QTest::newRow("at") << "@SUM(1)"
                      << "'@SUM(1)";
  QTest::newRow("tab") << "\t=1"
                       << "'\t=1";
  QTest::newRow("carriage return first") << "\r=1"
                                         << "\"'\r=1\"";
  QTest::newRow("line end first") << "\n=1"
                                  << "\"'\n=1\"";
  QTest::newRow("full width") << "＝1"
                              << "'＝1";
  QTest::newRow("negative number") << "-30.5"
                                   << "-30.5";
  QTest::newRow("sign inside") << "a=b-c@d"
                               << "a=b-c@d";
}

void TestReport::csvQuotes() {
  QFETCH(const QString, name);
  QFETCH(const QString, cell);
  ReportRow one = row(name.toStdString(), 1);
  one.test = one.state;
  const QString text = QString::fromStdString(csvOf({one}).substr(header.size()));
  QVERIFY(text.startsWith(cell + "," + cell + ",1,"));
}

/// The eye of a state with a dangerous name.
void TestReport::csvKeepsNegativeNumbers() {
  ReportRow one = row("=a", 1);
  one.eye = {-0.5, -1e-7, 2};
  QVERIFY(QString::fromStdString(csvOf({one}))
              .endsWith("\n'=a,a.png,1,48.1308036086791,1,"
                        "48.1308036086791,0.5,1,-0.5,-1e-07,2\n"));
}

void TestReport::bytesText_data() {
  QTest::addColumn<double>("bytes");
  QTest::addColumn<QString>("text");
  QTest::newRow("none") << 0.0 << "0 bytes";
  QTest::newRow("bytes") << 999.0 << "999 bytes";
  QTest::newRow("kB") << 1000.0 << "1 kB";
  QTest::newRow("small") << 40000.0 << "40 kB";
  QTest::newRow("nearly a MB") << 999940.0 << "999.9 kB";
  QTest::newRow("rounds to a MB") << 999960.0 << "1 MB";
  QTest::newRow("MB") << 19700000.0 << "19.7 MB";
  QTest::newRow("rounds to a GB") << 999960000.0 << "1 GB";
  QTest::newRow("GB") << 2.68e9 << "2.7 GB";
  QTest::newRow("many") << 2.83e14 << "283000 GB";
}

void TestReport::bytesText() {
  QFETCH(const double, bytes);
  QFETCH(const QString, text);
  QCOMPARE(QString::fromStdString(hogelscope::bytesText(std::size_t(bytes))), text);
}

void TestReport::numberText_data() {
  QTest::addColumn<double>("value");
  QTest::addColumn<QString>("text");
  QTest::newRow("zero") << 0.0 << "0";
  QTest::newRow("whole") << 42.0 << "42";
  QTest::newRow("shortest") << 0.1 << "0.1";
  QTest::newRow("third") << 1.0 / 3 << "0.3333333333333333";
  QTest::newRow("infinite") << infinite << "inf";
  QTest::newRow("minus infinite") << -infinite << "-inf";
  QTest::newRow("not a number") << notANumber << "nan";
  QTest::newRow("negative not a number") << -notANumber << "nan";
}

void TestReport::numberText() {
  QFETCH(const double, value);
  QFETCH(const QString, text);
  QCOMPARE(QString::fromStdString(hogelscope::numberText(value)), text);
}

void TestReport::numberTextReadsBack() {
  Random random(1);
  int finite = 0;
  while (finite < 20000) {
    // Any bits make a number, so that all magnitudes come up.
    const std::uint64_t high = std::uint64_t(random.uniform(0, 4294967296.0));
    const std::uint64_t low = std::uint64_t(random.uniform(0, 4294967296.0));
    const double value = std::bit_cast<double>(high << 32 | low);
    if (!std::isfinite(value)) continue;
    ++finite;
    const std::string text = hogelscope::numberText(value);
    QVERIFY(std::strtod(text.c_str(), nullptr) == value);
    QVERIFY(text.find(',') == std::string::npos);
  }
}

void TestReport::summary() {
  const std::vector<ReportRow> rows{row("a", 6.5025), row("b", 650.25), row("c", 0),
                                    row("d", 65.025), row("e", 650.25)};
  const ReportSummary s = summarise(rows);
  QVERIFY(std::abs(s.means[meanPsnr] - (40 + 20 + 30 + 20) / 4.0) < 1e-12);
  QVERIFY(std::abs(s.means[psnrOfMeanMse] - psnr((6.5025 + 650.25 + 65.025 + 650.25) / 5)) < 1e-12);
  QCOMPARE(*s.worst, std::size_t(1));
  QCOMPARE(s.identical, std::size_t(1));
}

void TestReport::summaryOfIdenticalViews() {
  const ReportSummary s = summarise({row("a", 0), row("b", 0)});
  QVERIFY(std::isnan(s.means[meanPsnr]));
  QCOMPARE(s.means[psnrOfMeanMse], infinite);
  QVERIFY(!s.worst);
  QCOMPARE(s.identical, std::size_t(2));
}

void TestReport::summaryOfNothing() {
  const ReportSummary s = summarise({});
  QVERIFY(std::isnan(s.means[meanPsnr]) && std::isnan(s.means[psnrOfMeanMse]));
  QVERIFY(!s.worst);
  QCOMPARE(s.identical, std::size_t(0));
}

void TestReport::summaryInWords() {
  const std::vector<ReportRow> rows{row("a", 6.5025), row("b", 650.25), row("c", 0)};
  const QString text = QString::fromStdString(summaryText(summarise(rows), rows));
  const QStringList lines = text.split('\n');
  QVERIFY(lines[0].startsWith("mean of the finite PSNRs") &&
          lines[0].endsWith(" 30.00 dB over what is seen, 30.00 dB over the whole frame"));
  QVERIFY(lines[1].startsWith("PSNR of the mean MSE") &&
          lines[1].endsWith(" 24.73 dB over what is seen, 24.73 dB over the whole frame"));
  QVERIFY(lines[2].startsWith("worst view") && lines[2].endsWith(" 20.00 dB: b, a.png"));
  QVERIFY(lines[3].startsWith("identical views") && lines[3].endsWith(" 1 of 3"));
}

/// A row with a problem counts as such and nowhere else.
void TestReport::rowsThatCompareNothing() {
  ReportRow blind = row("b", notANumber);
  blind.problem = "sees nothing";
  blind.values = metrics.noValues();
  ReportRow misleading = row("c", 0);  // whatever its numbers are
  misleading.problem = "no frame";
  const std::vector<ReportRow> rows{row("a", 650.25), blind, misleading};
  const ReportSummary s = summarise(rows);
  QCOMPARE(s.withoutView, std::size_t(2));
  QCOMPARE(s.identical, std::size_t(0));
  QCOMPARE(*s.worst, std::size_t(0));
  QCOMPARE(s.means[meanPsnr], 20.0);
  QCOMPARE(s.means[psnrOfMeanMse], 20.0);
  QCOMPARE(s.means[meanSsim], 0.5);
  QVERIFY(!summarise({blind}).worst && std::isnan(summarise({blind}).means[meanPsnr]));
  const QStringList lines = QString::fromStdString(summaryText(s, rows)).split('\n');
  QCOMPARE(lines[4], QString("nothing to compare        2 of 3"));
  QVERIFY(summaryText(summarise({row("a", 1)}), {row("a", 1)}).find("nothing") ==
          std::string::npos);
  QCOMPARE(lastLine(csvOf({blind})), QString("b,a.png,nan,nan,nan,nan,nan,0,0,0,1"));
}

QTEST_APPLESS_MAIN(TestReport)
#include "test_report.moc"
