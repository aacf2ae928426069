// SPDX-License-Identifier: BSD-3-Clause
// Tests the filter of rows: texts, conditions, columns alone, and what is no condition.
#include "core/base/row_filter.h"

#include <QTest>
#include <cmath>

using hogelscope::RowFilter;

class TestRowFilter : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void rows_data();
  void rows();
};

void TestRowFilter::rows_data() {
  QTest::addColumn<QString>("filter");
  QTest::addColumn<QString>("names");
  QTest::newRow("all") << ""
                       << "Fig 1,Fig 2,Random 3";
  QTest::newRow("text") << "fig"
                        << "Fig 1,Fig 2";
  QTest::newRow("all texts") << "fig, 2"
                             << "Fig 2";
  QTest::newRow("column alone") << "LENS"
                                << "Fig 1";
  QTest::newRow("less") << "σ < 0.5"
                        << "Fig 2";
  QTest::newRow("sigma") << "sigma<0.5"
                         << "Fig 2";
  QTest::newRow("at most") << "σ <= 0.41"
                           << "Fig 2";
  QTest::newRow("at most sign") << "σ≤0.41"
                                << "Fig 2";
  QTest::newRow("more than a negative") << "ang > -10.5"
                                        << "Fig 1,Random 3";
  QTest::newRow("at least") << "angle>=20"
                            << "Fig 1";
  QTest::newRow("at least sign") << "angle ≥ 20"
                                 << "Fig 1";
  QTest::newRow("equal") << "lens = 0"
                         << "Fig 2,Random 3";
  QTest::newRow("both") << "lens=0, random"
                        << "Random 3";
  QTest::newRow("more is not equal") << "angle > 9"
                                     << "Fig 1";
  QTest::newRow("less is not equal") << "angle < 9"
                                     << "Fig 2";
  QTest::newRow("missing value alone") << "PSNR"
                                       << "Fig 1,Fig 2";
  QTest::newRow("missing value") << "psnr < 100"
                                 << "Fig 1,Fig 2";
  QTest::newRow("no column") << "weight > 0"
                             << "";
  QTest::newRow("no number") << "angle > ."
                             << "";
  QTest::newRow("beginning of a column is text") << "an"
                                                 << "Random 3";
  QTest::newRow("commas only") << " , ,"
                               << "Fig 1,Fig 2,Random 3";
}

void TestRowFilter::rows() {
  QFETCH(const QString, filter);
  QFETCH(const QString, names);
  const RowFilter read(filter.toLower().toStdString(), {"psnr", "σ", "lens", "angle"});
  const std::vector<std::pair<QString, std::vector<double>>> rows{
      {"Fig 1", {30, 0.67, 1, 20}}, {"Fig 2", {25, 0.41, 0, -20}}, {"Random 3", {NAN, 0.67, 0, 9}}};
  QStringList passed;
  for (const auto& row : rows)
    if (read.accepts(row.first.toLower().toStdString(),
                     [&](std::size_t k) { return row.second[k]; }))
      passed << row.first;
  QCOMPARE(passed.join(','), names);
}

QTEST_APPLESS_MAIN(TestRowFilter)
#include "test_row_filter.moc"
