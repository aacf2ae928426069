// SPDX-License-Identifier: BSD-3-Clause
// Where curves are within limits, against a fine grid of places.
#include "measure/limit_spans.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace hogelscope;

class TestLimitSpans : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// A tent of 40 dB at 0 that falls by 1 dB for each 0.001 is above 30 dB within ± 0.01.
  void tent() {
    const auto spans = spansWithin({{-0.02, 20}, {0, 40}, {0.02, 20}}, {"", 30});
    QCOMPARE(spans.size(), std::size_t(1));
    QCOMPARE(spans[0].from, -0.01);
    QCOMPARE(spans[0].to, 0.01);
    QVERIFY(spans[0].beginsThere && spans[0].endsThere);
    QVERIFY(spansWithin({{0, 1}, {1, 2}}, {"", 3}).empty());
    QVERIFY(spansWithin({}, {"", 3}).empty());
    const auto all = spansWithin({{0, 4}, {1, 5}}, {"", 3});
    QCOMPARE(all.size(), std::size_t(1));
    QVERIFY(!all[0].beginsThere && !all[0].endsThere && all[0].from == 0 && all[0].to == 1);
  }

  void places() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0, 10);
    for (int trial = 0; trial < 100; ++trial) {
      std::vector<std::array<double, 2>> points(12);
      for (std::size_t k = 0; k < points.size(); ++k) points[k] = {double(k), uniform(random)};
      SweepLimit limit{""};
      if (trial % 3 != 1) limit.least = 3;
      if (trial % 3 != 0) limit.most = 7;
      const auto spans = spansWithin(points, limit);
      for (int at = 0; at <= 1100; ++at) {
        const double across = at / 100.0 + (at < 1100 ? 1e-7 : 0);
        const auto k = std::min<std::size_t>(std::size_t(across), 10);
        const double up = std::lerp(points[k][1], points[k + 1][1], across - double(k));
        // From one point to the next a curve may cross both limits, which only points tell.
        const bool isSkipped = !limit.allows(points[k][1]) && !limit.allows(points[k + 1][1]);
        const bool isIn = std::ranges::any_of(spans, [across](const LimitSpan& span) {
          return across >= span.from && across <= span.to;
        });
        if (!isSkipped) QCOMPARE(isIn, limit.allows(up));
      }
    }
  }
};

QTEST_GUILESS_MAIN(TestLimitSpans)
#include "test_limit_spans.moc"
