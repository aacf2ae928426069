// SPDX-License-Identifier: BSD-3-Clause
// Tests the statistics of votes: Student's t against tables, Bradley and Terry's strengths against
// closed forms and a search of the greatest likelihood, screening against the rule's own numbers,
// and both methods against simulated viewers whose opinion is known.
#include <QTest>
#include <cmath>
#include <numbers>

#include "core/metrics/votes.h"
#include "tests/core/random.h"

using namespace hogelscope;

namespace {

double normal(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform(0, 1))) *
         std::cos(2 * std::numbers::pi * random.uniform(0, 1));
}

std::vector<std::string> names(const char* letter, int count) {
  std::vector<std::string> list;
  for (int k = 0; k < count; ++k) list.push_back(letter + std::to_string(k));
  return list;
}

/// Viewers of one habit each who grade tests of these true scores.
Votes grades(const std::vector<double>& scores, int viewers, int states, Random& random) {
  Votes votes{.viewers = names("v", viewers),
              .states = names("s", states),
              .contents = names("c", int(scores.size()) + 1),
              .votes = {}};
  for (std::size_t viewer = 0; viewer < std::size_t(viewers); ++viewer) {
    const double habit = 0.4 * normal(random);
    for (std::size_t state = 0; state < std::size_t(states); ++state)
      for (std::size_t test = 0; test < scores.size(); ++test) {
        const double grade = std::round(scores[test] + habit + 0.6 * normal(random));
        votes.votes.push_back({viewer, state, 0, test + 1, int(std::clamp(grade, 1.0, 5.0))});
      }
  }
  return votes;
}

/// Viewers who compare contents of these true strengths.
Votes choices(const std::vector<double>& strengths, int viewers, Random& random) {
  Votes votes{.arePairs = true,
              .viewers = names("v", viewers),
              .states = names("s", 1),
              .contents = names("c", int(strengths.size())),
              .votes = {}};
  for (std::size_t viewer = 0; viewer < std::size_t(viewers); ++viewer)
    for (std::size_t a = 0; a < strengths.size(); ++a)
      for (std::size_t b = a + 1; b < strengths.size(); ++b) {
        const double odds = std::exp(strengths[a] - strengths[b]);
        const bool isFirst = random.uniform(0, 1) < odds / (1 + odds);
        if (random.flip())
          votes.votes.push_back({viewer, 0, a, b, isFirst ? 1 : 2});
        else
          votes.votes.push_back({viewer, 0, b, a, isFirst ? 2 : 1});
      }
  return votes;
}

/// The logarithm of the likelihood of strengths, with the tie that each pair gets.
double likelihood(const std::vector<double>& wins, const std::vector<double>& strengths) {
  const std::size_t n = strengths.size();
  double sum = 0;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b < n; ++b)
      if (a != b && wins[a * n + b] + wins[b * n + a] > 0)
        sum -= (wins[a * n + b] + 0.5) * std::log1p(std::exp(strengths[b] - strengths[a]));
  return sum;
}

}  // namespace

class TestVotes : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void quantilesOfStudent();
  void strengthsOfTwo();
  void strengthsAreTheLikeliest();
  void strengthsOfParts();
  void screening();
  void meansByHand();
  void gradesOfKnownViewers();
  void choicesOfKnownViewers();
  void oneViewer();
};

void TestVotes::quantilesOfStudent() {
  // Abramowitz and Stegun, table 26.10, and the normal limit.
  const std::vector<std::pair<int, double>> table{{1, 12.706}, {2, 4.303},  {3, 3.182},
                                                  {4, 2.776},  {5, 2.571},  {10, 2.228},
                                                  {29, 2.045}, {30, 2.042}, {120, 1.980}};
  for (const auto& [degrees, quantile] : table)
    QVERIFY2(std::abs(studentQuantile(degrees) - quantile) < 6e-4,
             qPrintable(QString::number(degrees)));
  QVERIFY(std::abs(studentQuantile(100001) - 1.96) < 1e-3);
}

void TestVotes::strengthsOfTwo() {
  const std::vector<double> strengths = bradleyTerry({0, 30, 10, 0}, 2);
  QVERIFY(std::abs(strengths[0] - strengths[1] - std::log(30.5 / 10.5)) < 1e-8);
  QVERIFY(std::abs(strengths[0] + strengths[1]) < 1e-12);
  // A content that always won has a finite strength.
  const std::vector<double> all = bradleyTerry({0, 7, 0, 0}, 2);
  QVERIFY(std::abs(all[0] - all[1] - std::log(7.5 / 0.5)) < 1e-8);
}

void TestVotes::strengthsAreTheLikeliest() {
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    const std::size_t n = std::size_t(random.integer(3, 6));
    std::vector<double> wins(n * n);
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b)
        if (a != b) wins[a * n + b] = random.integer(0, 12);
    const std::vector<double> found = bradleyTerry(wins, n);
    const double best = likelihood(wins, found);
    for (std::size_t k = 0; k < n; ++k)
      for (const double step : {-1e-3, 1e-3}) {
        std::vector<double> other = found;
        other[k] += step;
        QVERIFY(likelihood(wins, other) < best);
      }
  }
}

void TestVotes::strengthsOfParts() {
  // 0 and 1 were compared, and 2 and 3, but nothing connects them.
  std::vector<double> wins(16);
  wins[0 * 4 + 1] = 3;
  wins[2 * 4 + 3] = 5;
  const std::vector<double> strengths = bradleyTerry(wins, 4);
  QVERIFY(std::abs(strengths[0] - strengths[1] - std::log(3.5 / 0.5)) < 1e-8);
  QVERIFY(std::isnan(strengths[2]) && std::isnan(strengths[3]));
}

void TestVotes::screening() {
  // 19 viewers grade alike, most of them 3; one grades at both ends.
  Votes votes{
      .viewers = names("v", 20), .states = names("s", 10), .contents = names("c", 2), .votes = {}};
  for (std::size_t viewer = 0; viewer < 20; ++viewer)
    for (std::size_t state = 0; state < 10; ++state)
      votes.votes.push_back({viewer, state, 0, 1,
                             (viewer + state) % 5 == 0   ? 2
                             : (viewer + state) % 5 == 4 ? 4
                                                         : 3});
  QVERIFY(screenedViewers(votes).empty());
  for (Vote& vote : votes.votes)
    if (vote.viewer == 7) vote.vote = vote.state % 2 == 0 ? 1 : 5;
  QCOMPARE(screenedViewers(votes), std::vector<std::size_t>{7});
  // Whoever is always above has another opinion, which counts.
  for (Vote& vote : votes.votes)
    if (vote.viewer == 7) vote.vote = 5;
  QVERIFY(screenedViewers(votes).empty());
  // All agree: nothing is beyond.
  for (Vote& vote : votes.votes) vote.vote = 4;
  QVERIFY(screenedViewers(votes).empty());
}

void TestVotes::meansByHand() {
  Votes votes{.viewers = names("v", 3),
              .states = {"a", "b"},
              .contents = {"original", "coded"},
              .votes = {{0, 0, 0, 1, 5}, {1, 0, 0, 1, 4}, {2, 0, 0, 1, 3}, {0, 1, 0, 1, 1}}};
  const std::vector<VoteRow> rows = voteRows(votes);
  QCOMPARE(rows.size(), std::size_t(3));
  QCOMPARE(rows[0].state, std::string("a"));
  QCOMPARE(rows[0].test, std::string("coded"));
  QCOMPARE(rows[0].n, std::size_t(3));
  QCOMPARE(rows[0].mos, 4.0);
  QVERIFY(std::abs(rows[0].interval.high - (4 + 4.30265 / std::sqrt(3))) < 1e-4);
  QCOMPARE(rows[1].mos, 1.0);
  QVERIFY(std::isnan(rows[1].interval.low));
  // Over all states: means of the viewers' means, 3, 4 and 3.
  QVERIFY(std::abs(rows[2].mos - 10.0 / 3) < 1e-12);
  QCOMPARE(rows[2].n, std::size_t(3));
  QCOMPARE(votesCsv({rows[1]}), std::string("state,test,n,mos,low,high,bt\nb,coded,1,1,,,\n"));
}

void TestVotes::gradesOfKnownViewers() {
  Random random(11);
  const std::vector<double> truth{4.2, 3.1, 1.9};
  int inside = 0;
  int all = 0;
  // The mean of many viewers is what intervals of few should hold: grades are cut off at 1 and 5.
  const std::vector<VoteRow> crowd = voteRows(grades(truth, 20000, 3, random));
  for (int round = 0; round < 200; ++round) {
    const std::vector<VoteRow> rows = voteRows(grades(truth, 15, 3, random));
    for (std::size_t k = 0; k < 3; ++k) {
      const VoteRow& row = rows[rows.size() - 3 + k];
      const double score = crowd[crowd.size() - 3 + k].mos;
      inside += int(row.interval.low <= score && score <= row.interval.high);
      ++all;
    }
    QVERIFY(rows[rows.size() - 3].mos > rows[rows.size() - 2].mos);
    QVERIFY(rows[rows.size() - 2].mos > rows.back().mos);
  }
  const double share = double(inside) / all;
  QVERIFY2(share > 0.92 && share < 0.98, qPrintable(QString::number(share)));
}

void TestVotes::choicesOfKnownViewers() {
  Random random(12);
  const std::vector<double> truth{1.2, 0.3, -0.3, -1.2};
  int inside = 0;
  for (int round = 0; round < 60; ++round) {
    const std::vector<VoteRow> rows = voteRows(choices(truth, 40, random));
    for (std::size_t k = 0; k < 4; ++k) {
      const VoteRow& row = rows[4 + k];
      inside += int(row.interval.low <= truth[k] && truth[k] <= row.interval.high);
      if (k > 0) QVERIFY(row.strength < rows[3 + k].strength);
    }
  }
  const double share = inside / 240.0;
  QVERIFY2(share > 0.88 && share < 0.99, qPrintable(QString::number(share)));
}

void TestVotes::oneViewer() {
  Random random(2);
  for (const VoteRow& row : voteRows(choices({1, 0, -1}, 1, random))) {
    QVERIFY(std::isnan(row.interval.low));
    QVERIFY(std::isfinite(row.strength));
  }
  for (const VoteRow& row : voteRows(grades({3, 2}, 1, 2, random)))
    QVERIFY(std::isnan(row.interval.low));
}

QTEST_GUILESS_MAIN(TestVotes)
#include "test_votes.moc"
