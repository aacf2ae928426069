// SPDX-License-Identifier: BSD-3-Clause
// Tests which methods are advised: by the rules, and the same whatever the noise of the times.
#include "chart/recommendations.h"

#include <QTest>
#include <algorithm>
#include <set>

#include "tests/chart/sample_rows.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

using Rows = std::vector<TradeoffRow>;
using Runs = std::vector<double>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Measured {
  const char* method;
  double rmse;
  Runs runs;  ///< milliseconds
};

/// The default is called so.
Rows measured(const std::vector<Measured>& samples) {
  Rows rows;
  for (const auto& [method, rmse, runs] : samples) {
    TradeoffRow row;
    row.method = method;
    row.rmse = rmse;
    row.isDefault = row.method == "default";
    setTimes(row, runs);
    rows.push_back(row);
  }
  return rows;
}

std::string nameOf(const Rows& rows, std::optional<std::size_t> index) {
  return index ? rows[*index].method : "none";
}

std::string paper(const Rows& rows) {
  return nameOf(rows, forPaper(rows));
}

std::string moving(const Rows& rows) {
  return nameOf(rows, forMovingView(rows));
}

/// What runs of a method take on a machine with other work: now and then three times as long.
Runs noisy(Random& random, double milliseconds, int count) {
  Runs runs;
  for (int k = 0; k < count; ++k) {
    const double disturbed = random.integer(0, 9) == 0 ? 3 : 1;
    runs.push_back(disturbed * milliseconds * (1 + 0.3 * random.uniform(0, 1)));
  }
  return runs;
}

}  // namespace

class TestRecommendations : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void timesOfRuns();
  void leastErrorIsForThePaper();
  void fastEnoughIsForTheMovingView();
  void withinTheSpreadAccuracyThenTheDefaultWins();
  void theDefaultStaysWhereOthersAreHardlyFaster();
  void whatIsNotMeasuredIsNotAdvised();
  void eachPurposeHasItsMethod();
  void whatIsBetter();
  void noiseChangesNothing_data();
  void noiseChangesNothing();
};

void TestRecommendations::timesOfRuns() {
  TradeoffRow row;
  setTimes(row, {5, 1, 4, 2, 30});
  QCOMPARE(row.fastest, 1.0);
  QCOMPARE(row.milliseconds, 4.0);
  QCOMPARE(row.upperQuartile, 5.0);
  setTimes(row, {8, 2, 6, 4});
  QCOMPARE(row.milliseconds, 5.0);
  QCOMPARE(row.upperQuartile, 6.0);
  setTimes(row, {7});
  QVERIFY(row.fastest == 7 && row.milliseconds == 7 && row.upperQuartile == 7);
}

void TestRecommendations::leastErrorIsForThePaper() {
  QCOMPARE(paper(rowsOf({{"slow", 40, 0}, {"slower", 50, 0}, {"fast", 1, 0.01}})),
           std::string("slow"));
  QCOMPARE(paper(rowsOf({{"slower", 50, 0}, {"slow", 40, 0}})), std::string("slow"));
}

void TestRecommendations::fastEnoughIsForTheMovingView() {
  const Rows rows =
      rowsOf({{"slow", 40, 0}, {"no front", 16.5, 2}, {"smooth", 16, 2}, {"fast", 1, 9}});
  QCOMPARE(moving(rows), std::string("smooth"));
  // Where nothing is, the fastest.
  QCOMPARE(moving(rowsOf({{"a", 300, 0}, {"b", 20, 2}, {"c", 30, 1}})), std::string("b"));
}

void TestRecommendations::withinTheSpreadAccuracyThenTheDefaultWins() {
  // Medians say "other", by a hair and by much; the runs say nothing.
  QCOMPARE(paper(measured({{"other", 0, {8, 9, 12}}, {"default", 0, {9, 10, 12}}})),
           std::string("default"));
  QCOMPARE(paper(measured({{"other", 0, {5, 6, 22}}, {"default", 0, {20, 21, 30}}})),
           std::string("default"));
  QCOMPARE(paper(measured({{"other", 0, {5, 6, 7}}, {"default", 0, {20, 21, 30}}})),
           std::string("other"));
  // No default: the first of the table.
  QCOMPARE(paper(measured({{"first", 0, {8, 9, 12}}, {"second", 0, {7, 8, 9}}})),
           std::string("first"));
  // About the limit of 16.7 ms, and where nothing keeps it.
  QCOMPARE(moving(measured({{"good", 1, {16, 17, 18}}, {"bad", 2, {3, 4, 5}}})),
           std::string("good"));
  QCOMPARE(moving(measured({{"bad", 2, {20, 21, 25}}, {"good", 1, {24, 30, 31}}})),
           std::string("good"));
  QCOMPARE(moving(measured({{"bad", 2, {20, 21, 23}}, {"good", 1, {24, 30, 31}}})),
           std::string("bad"));
}

void TestRecommendations::theDefaultStaysWhereOthersAreHardlyFaster() {
  const auto against = [](double milliseconds) {
    return measured({{"other", 0, {milliseconds}}, {"default", 0, {10}}});
  };
  for (const double hardly : {8.1, 9.0, 11.0}) {
    QCOMPARE(paper(against(hardly)), std::string("default"));
    QCOMPARE(moving(against(hardly)), std::string("default"));
  }
  QCOMPARE(paper(against(7.9)), std::string("other"));
  QCOMPARE(moving(against(7.9)), std::string("other"));
  // But not where another one is more accurate, or keeps a limit that the default does not.
  QCOMPARE(paper(measured({{"other", 0, {9}}, {"default", 0.002, {10}}})), std::string("other"));
  QCOMPARE(moving(measured({{"other", 0, {16}}, {"default", 0, {18}}})), std::string("other"));
}

void TestRecommendations::whatIsNotMeasuredIsNotAdvised() {
  const Rows odd = rowsOf({{"no time", 0, 0}, {"no error", 1, none}, {"c", 30, 1}});
  QCOMPARE(moving(odd), std::string("c"));
  QCOMPARE(paper(odd), std::string("c"));
  QVERIFY(!forMovingView({}) && !forPaper({}));
}

void TestRecommendations::eachPurposeHasItsMethod() {
  const Rows rows = measured({{"fast", 9, {1}}, {"default", 2, {100}}, {"good", 0, {300}}});
  QCOMPARE(recommended(rows, Purpose::movingView), forMovingView(rows));
  QCOMPARE(recommended(rows, Purpose::paper), forPaper(rows));
  QCOMPARE(recommended(rows, Purpose::standard), std::optional<std::size_t>(1));
  QVERIFY(!recommended(rowsOf({{"a", 1, 1}}), Purpose::standard));
}

void TestRecommendations::whatIsBetter() {
  const Rows rows = rowsOf({{"a", 1, 9}, {"b", 5, 3}, {"c", 6, 3}, {"d", 7, 5}, {"e", 5, 4}});
  const auto better = [&](std::size_t row) { return nameOf(rows, betterThan(rows, row)); };
  QCOMPARE(better(0), std::string("none"));
  QCOMPARE(better(1), std::string("none"));
  QCOMPARE(better(2), std::string("b"));  // as accurate
  QCOMPARE(better(3), std::string("b"));  // not c, which is slower
  QCOMPARE(better(4), std::string("b"));  // as fast
  for (std::size_t k = 0; k < rows.size(); ++k)
    QCOMPARE(betterThan(rows, k).has_value(), !rows[k].isPareto);
}

void TestRecommendations::noiseChangesNothing_data() {
  QTest::addColumn<int>("runs");
  for (const int runs : {5, 9, 25}) QTest::addRow("%d runs", runs) << runs;
}

/// Methods of equal error whose times hardly differ, as those of a small picture, with noise of 30
/// % and runs that were disturbed, in any order.
void TestRecommendations::noiseChangesNothing() {
  QFETCH(int, runs);
  const std::vector<SampleRow> truth{
      {"default", 1.1, 0},    {"Newton", 1.0, 0},    {"fixed point 20", 1.3, 0}, {"table", 1.05, 0},
      {"float", 0.95, 0.003}, {"half size", 0.4, 8}, {"quadrilinear", 8, 4}};
  std::set<std::string> papers;
  std::set<std::string> movings;
  for (int seed = 1; seed <= 1000; ++seed) {
    Random random{std::uint64_t(seed)};
    std::vector<Measured> samples;
    for (const auto& [method, milliseconds, rmse] : truth)
      samples.push_back({method, rmse, noisy(random, milliseconds, runs)});
    for (std::size_t k = samples.size(); k > 1; --k)
      std::swap(samples[k - 1], samples[std::size_t(random.integer(0, int(k) - 1))]);
    const Rows rows = measured(samples);
    papers.insert(paper(rows));
    movings.insert(moving(rows));
  }
  QCOMPARE(papers, std::set<std::string>{"default"});
  QCOMPARE(movings, std::set<std::string>{"default"});
}

QTEST_APPLESS_MAIN(TestRecommendations)
#include "test_recommendations.moc"
