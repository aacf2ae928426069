// SPDX-License-Identifier: BSD-3-Clause
// Tests that a report's tables read back as they were written, and that no other table is taken.
#include "report/report_reader.h"

#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

#include "core/base/error.h"
#include "core/base/text.h"
#include "io/files/atomic_file.h"
#include "report/report_files.h"
#include "tests/core/random.h"
#include "tests/report/metric_values.h"

using namespace hogelscope;

namespace fs = std::filesystem;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

bool isSame(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

class TestReportReader : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cells_data();
  void cells();
  void readsWhatWasWritten();
  void readsReportCsvAlone();
  void refuses_data();
  void refuses();
  void worstFirstByError();
  void pictures();

 private:
  QTemporaryDir m_temporary;
  fs::path m_folder = m_temporary.path().toStdString();
};

void TestReportReader::cells_data() {
  QTest::addColumn<QString>("text");
  QTest::newRow("plain") << "a b";
  QTest::newRow("empty") << "";
  QTest::newRow("comma") << "a,b";
  QTest::newRow("quotes") << R"("a" ""b"")";
  QTest::newRow("only quotes") << R"("")";
  QTest::newRow("lines") << "a\r\nb\n";
  QTest::newRow("formula") << "=1+1";
  QTest::newRow("formula with a comma") << "@a,\"b";
  QTest::newRow("apostrophe") << "'a";
  QTest::newRow("number") << "-5";
}

void TestReportReader::cells() {
  QFETCH(const QString, text);
  const std::string cell = text.toStdString();
  const Table table{{cell, "x", cell}, {"y"}};
  QVERIFY(csvRows(csvText(table)) == table);
  std::string line = csvText({table[0]});
  line.insert(line.size() - 1, "\r");
  QVERIFY(csvRows(line + "y\n") == table);
}

void TestReportReader::readsWhatWasWritten() {
  const MetricSet metrics;
  Random random(5);
  Report report;
  for (const char* state : {"a", "=b,\"c\"", "d\ne"})
    for (const char* test : {"/x/one.jpg", "two, three.png"}) {
      ReportRow row{state, test, metrics.noValues(), {}, 1};
      for (double& value : row.values) value = random.uniform(-100, 100);
      row.eye = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      row.weight = random.uniform(0, 3);
      report.rows.push_back(row);
    }
  report.rows[1].values[psnrSeenColumn] = infinite;
  report.rows[2].values = metrics.noValues();
  report.rows[2].problem = seesNothing;
  report.summaries = summariseTests(report.rows, metrics, {{"g", {{"two, three.png", 0.75}}}});
  writeTables(m_folder, report, metrics);
  const StoredReport read = readReport(m_folder, metrics);
  QCOMPARE(read.rows.size(), report.rows.size());
  for (std::size_t k = 0; k < report.rows.size(); ++k) {
    const ReportRow& a = report.rows[k];
    const ReportRow& b = read.rows[k];
    QVERIFY(a.state == b.state && a.test == b.test && a.problem == b.problem);
    QVERIFY(a.weight == b.weight && a.eye.x == b.eye.x && a.eye.y == b.eye.y && a.eye.z == b.eye.z);
    for (std::size_t column = 0; column < a.values.size(); ++column)
      QVERIFY2(isSame(a.values[column], b.values[column]), metrics.columns()[column].name.c_str());
  }
  QCOMPARE(read.rates.size(), std::size_t(1));
  QVERIFY(read.rates[0].test == "two, three.png" && read.rates[0].rate == 0.75);
}

/// As the first versions wrote it.
void TestReportReader::readsReportCsvAlone() {
  QTemporaryDir folder;
  const fs::path path = folder.path().toStdString();
  writeTextFile(path / "report.csv", "state,test,psnr_seen,eye_z\na,t,30,0.5\nb,t,inf,0.7\n");
  const StoredReport read = readReport(path, MetricSet());
  QCOMPARE(read.rows.size(), std::size_t(2));
  QCOMPARE(read.rows[0].values[psnrSeenColumn], 30.0);
  QCOMPARE(read.rows[1].values[psnrSeenColumn], infinite);
  QVERIFY(std::isnan(read.rows[0].values[ssimSeenColumn]));
  QCOMPARE(read.rows[1].eye.z, 0.7);
  QVERIFY(read.rates.empty());
}

void TestReportReader::refuses_data() {
  QTest::addColumn<QByteArray>("report");
  QTest::addColumn<QByteArray>("metrics");
  QTest::addColumn<QString>("line");
  const QString none = "report.csv: is no table of a report: it has not every test for every state";
  QTest::newRow("another table") << QByteArray("a,b\n1,2\n") << QByteArray() << none;
  QTest::newRow("empty") << QByteArray("") << QByteArray() << none;
  QTest::newRow("no rows") << QByteArray("state,test\n") << QByteArray() << none;
  QTest::newRow("cut") << QByteArray("state,test\na,x\na,y\nb,x\n") << QByteArray() << none;
  QTest::newRow("other order") << QByteArray("state,test\na,x\na,y\nb,y\nb,x\n") << QByteArray()
                               << none;
  QTest::newRow("a test for each") << QByteArray("state,test\na,x\nb,y\n") << QByteArray() << none;
  QTest::newRow("another metrics.csv")
      << QByteArray("state,test\na,x\n") << QByteArray("state,test\n")
      << "metrics.csv: is no table of a report: report.csv has another number of lines";
}

void TestReportReader::refuses() {
  QFETCH(const QByteArray, report);
  QFETCH(const QByteArray, metrics);
  QFETCH(const QString, line);
  QTemporaryDir folder;
  const fs::path path = folder.path().toStdString();
  writeTextFile(path / "report.csv", report.toStdString());
  if (!metrics.isEmpty()) writeTextFile(path / "metrics.csv", metrics.toStdString());
  try {
    readReport(path, MetricSet());
    QFAIL("accepted");
  } catch (const InputError& error) {
    QVERIFY2(QString(error.what()).endsWith(line), error.what());
  }
}

/// Identical views last, a view in which nothing is seen by both first, one with a problem nowhere.
void TestReportReader::worstFirstByError() {
  std::vector<ReportRow> rows;
  for (const double mse : {4.0, 0.0, 9.0, double(NAN), 1.0})
    for (const double factor : {1.0, -1.0}) {
      rows.push_back({"s", "t", metricValues(10 + factor * mse), {}});
      if (std::isnan(mse) || mse == 0) rows.back().values = metricValues(mse);
    }
  rows[0].problem = seesNothing;
  QVERIFY((worstFirst(rows, {2}, 0) == std::vector<std::size_t>{3, 2, 4, 1}));
  QVERIFY((worstFirst(rows, {2}, 1) == std::vector<std::size_t>{3, 4, 0, 2, 1}));
}

void TestReportReader::pictures() {
  std::vector<ReportRow> rows;
  for (const char* state : {"a", "b", "c", "d"})
    rows.push_back({state, "t", metricValues(double(state[0])), {}});
  const auto filesOf = [&](std::size_t row) {
    QStringList names;
    for (const fs::path& file : picturesOf(m_folder, rows, {1}, row))
      names << QString::fromStdString(fs::relative(file, m_folder).string());
    return names.join(' ');
  };
  QCOMPARE(filesOf(3), QString());  // nothing is there
  for (const char* folder : {"views", "reference", "test1"}) makeFolder(m_folder / folder);
  for (const char* which : {"worst", "median", "best"})
    for (const char* ending : {"reference", "test", "difference"})
      writeTextFile(m_folder / "views" / (std::string("test1_") + which + "_" + ending + ".png"),
                    "");
  const auto viewsOf = [](const QString& which) {
    return QString(
               "views/test1_%1_reference.png views/test1_%1_test.png "
               "views/test1_%1_difference.png")
        .arg(which);
  };
  QCOMPARE(filesOf(3), viewsOf("worst"));
  QCOMPARE(filesOf(1), viewsOf("median"));
  QCOMPARE(filesOf(0), viewsOf("best"));
  QCOMPARE(filesOf(2), QString());
  for (const char* folder : {"reference", "test1"}) writeTextFile(m_folder / folder / "c.png", "");
  QCOMPARE(filesOf(2), QString("reference/c.png test1/c.png"));
}

QTEST_APPLESS_MAIN(TestReportReader)
#include "test_report_reader.moc"
