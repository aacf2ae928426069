// SPDX-License-Identifier: BSD-3-Clause
// Tests how a budget of time is shared out.
#include "study/time_budget.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

using namespace hogelscope;

class TestTimeBudget : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cheapMethodsAreRepeated() {
    const TimePlan plan = planTimes({{1, 1}, {1, 1}, {1, 1}, {2, 2}}, 50);
    QCOMPARE(plan.views, std::size_t(2));
    QVERIFY(std::ranges::all_of(plan.repeats, std::identity()));
  }

  /// What the cheap ones leave is enough for one run of the third, and for a part of the fourth.
  void slowMethodsAreTimedOnce() {
    const TimePlan plan = planTimes({{1}, {1}, {1}, {40}, {1000}, {1}, {1}, {1}, {1}}, 100);
    QCOMPARE(plan.views, std::size_t(1));
    QCOMPARE(plan.repeats, (std::vector{true, true, true, false, false, true, true, true, true}));
    QCOMPARE(plan.divisors[3], 2);
    QCOMPARE(plan.divisors[4], coarsestTime);
  }

  void fewerViewsRatherThanMostMethodsOnce() {
    const std::vector<std::vector<double>> costs(4, {1, 1, 1, 1, 1});
    QCOMPARE(planTimes(costs, 100).views, std::size_t(5));
    QCOMPARE(planTimes(costs, 60).views, std::size_t(3));
    const TimePlan least = planTimes(costs, 1);
    QCOMPARE(least.views, std::size_t(1));
    QVERIFY(std::ranges::none_of(least.repeats, std::identity()));
  }

  /// Whatever the costs are; what is too slow on the fewest pixels is not planned for.
  void plansStayWithinTheBudget() {
    for (int k = 1; k < 200; ++k) {
      std::vector<std::vector<double>> costs;
      for (int m = 0; m < 7; ++m) costs.push_back({std::pow(1.0 + k % 13, m), double(k % 5 + 1)});
      const double seconds = 3.0 * k;
      const TimePlan plan = planTimes(costs, seconds);
      double sum = 0;
      for (std::size_t m = 0; m < costs.size(); ++m) {
        const auto first = costs[m].begin();
        const double run = std::accumulate(first, first + std::ptrdiff_t(plan.views), 0.0);
        const int divisor = plan.divisors[m];
        if (divisor < coarsestTime)
          sum += plan.repeats[m] ? leastRuns * run : run / (divisor * divisor);
      }
      QVERIFY(sum <= seconds * (1 + 1e-9));
    }
  }

  void everyBeginningIsSpread() {
    QCOMPARE(spreadOrder(1), (std::vector<std::size_t>{0}));
    QCOMPARE(spreadOrder(6), (std::vector<std::size_t>{0, 3, 1, 4, 2, 5}));
    for (const std::size_t count : {2, 7, 64, 100}) {
      auto order = spreadOrder(count);
      QVERIFY(order[1] == count / 2);
      std::ranges::sort(order);
      for (std::size_t k = 0; k < count; ++k) QCOMPARE(order[k], k);
    }
  }
};

QTEST_APPLESS_MAIN(TestTimeBudget)
#include "test_time_budget.moc"
