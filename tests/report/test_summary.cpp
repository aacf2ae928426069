// SPDX-License-Identifier: BSD-3-Clause
// Tests summary.csv, metrics.csv, bd.csv, weighted means, and their place on the report's page.
#include <QTest>
#include <cmath>

#include "page/html.h"
#include "page/latex_table.h"
#include "report/page/report_tables.h"
#include "tests/core/random.h"
#include "tests/report/metric_values.h"

using namespace hogelscope;

namespace {

const MetricSet metrics;

/// PSNR 20 + `better`, PSNR-Y 30 + `better`, PSNR-YUV 27.5 + `better`.
ReportRow row(const std::string& state, const std::string& test, double better, double weight = 1) {
  const double factor = std::pow(10, -better / 10);
  return {state,
          test,
          metricValues(650.25 * factor, 0.5 + better / 100,
                       {65.025 * factor, 650.25 * factor, 650.25 * factor}),
          {0, 0, 1},
          weight};
}

ReportRow identical(const std::string& state, const std::string& test) {
  return {state, test, metricValues(0, 1, {}), {0, 0, 1}, 1};
}

ReportSummary summarise(const std::vector<ReportRow>& rows) {
  return summariseRows(rows, metrics);
}

std::vector<TestSummary> summariesOf(const std::vector<ReportRow>& rows,
                                     const std::vector<RateGroup>& groups = {}) {
  return summariseTests(rows, metrics, groups);
}

QStringList linesOf(const std::string& text) {
  return QString::fromStdString(text).split('\n');
}

bool near(double a, double b) {
  return std::abs(a - b) < 1e-9;
}

/// Value of a figure in summary.csv.
QStringList cells(const QStringList& lines, const QString& start) {
  for (const QString& line : lines)
    if (line.startsWith(start + ",")) return line.split(',');
  return {};
}

}  // namespace

class TestSummaries : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void means();
  void weightedMeans();
  void weightZeroDoesNotCount();
  void notANumberDoesNotCount();
  void blocks();
  void csvFigures();
  void rowsWithProblems();
  void allResamplesStates();
  void identicalOnly();
  void metricsTable();
  void anotherMetric();
  void bdRates();
  void bdIntervals();
  void bdOfAnError();
  void bdProblems();
  void page();
  void latex();
  void latexFitsAWidth();
};

void TestSummaries::means() {
  const ReportSummary s =
      summarise({row("a", "t", 0), row("b", "t", 10), identical("c", "t"), row("d", "t", 2)});
  QVERIFY(near(s.means[meanPsnr], 24));
  QVERIFY(near(s.means[meanPsnrY], 34));
  QVERIFY(near(s.means[meanPsnrYuv], 31.5));
  QVERIFY(near(s.means[meanSsim], (0.5 + 0.6 + 1 + 0.52) / 4));
  QVERIFY(near(s.means[psnrOfMeanMse], psnr(650.25 * (1 + 0.1 + std::pow(10, -0.2)) / 4)));
  QVERIFY(near(s.weighted[meanPsnr], s.means[meanPsnr]));
}

void TestSummaries::weightedMeans() {
  const std::vector<ReportRow> rows{row("a", "t", 0, 3), row("b", "t", 10, 1)};
  const std::vector<double> weighted = summarise(rows).weighted;
  QVERIFY(near(weighted[meanPsnr], 22.5));
  QVERIFY(near(weighted[meanPsnrY], 32.5));
  QVERIFY(near(weighted[meanPsnrYuv], 30));
  QVERIFY(near(weighted[meanSsim], 0.525));
  QVERIFY(near(weighted[psnrOfMeanMse], psnr(650.25 * (3 + 0.1) / 4)));
  // A weight is as many equal rows.
  const ReportSummary repeated =
      summarise({row("a", "t", 0), row("a", "t", 0), row("a", "t", 0), row("b", "t", 10)});
  QVERIFY(near(weighted[psnrOfMeanMse], repeated.means[psnrOfMeanMse]));
}

void TestSummaries::weightZeroDoesNotCount() {
  const ReportSummary s = summarise({row("a", "t", 0, 0), row("b", "t", 7, 2)});
  QVERIFY(near(s.weighted[meanPsnr], 27));
  QVERIFY(near(s.means[meanPsnr], 23.5));
  QVERIFY(std::isnan(summarise({row("a", "t", 0, 0)}).weighted[meanPsnr]));
}

void TestSummaries::notANumberDoesNotCount() {
  ReportRow small = row("b", "t", 6);
  small.values[ssimColumn] = std::nan("");
  const ReportSummary s = summarise({row("a", "t", 0), small});
  QVERIFY(near(s.means[meanSsim], 0.5));
  QVERIFY(near(s.means[meanPsnr], 23));
}

void TestSummaries::blocks() {
  const auto summaries =
      summariesOf({row("a", "x", 0), row("a", "y", 5), row("b", "x", 10), row("b", "y", 7)});
  QCOMPARE(summaries.size(), std::size_t(3));
  QCOMPARE(summaries[0].test, std::string("x"));
  QCOMPARE(summaries[1].test, std::string("y"));
  QCOMPARE(summaries[2].test, std::string("all tests"));
  QVERIFY(near(summaries[0].summary.means[meanPsnr], 25));
  QVERIFY(near(summaries[1].summary.means[meanPsnr], 26));
  QVERIFY(near(summaries[2].summary.means[meanPsnr], 25.5));
}

void TestSummaries::csvFigures() {
  const auto summaries = summariesOf(
      {row("a", "x", 4, 1), row("b, c", "x", 0, 3), identical("d", "x")}, {{"g", {{"x", 0.25}}}});
  const QStringList lines = linesOf(summaryCsv(summaries, metrics));
  QCOMPARE(lines[0],
           QString("test,figure,value,low,high,weighted,weighted_low,weighted_high,state,over"));
  QCOMPARE(cells(lines, "x,views")[2], QString("3"));
  QCOMPARE(cells(lines, "x,identical_views")[2], QString("1"));
  QCOMPARE(cells(lines, "x,views_without_comparison")[2], QString("0"));
  QCOMPARE(cells(lines, "x,rate_bpp")[2], QString("0.25"));
  QVERIFY(lines.contains("x,worst_psnr,20,,,,,,\"b, c\",frame"));
  QVERIFY(lines.contains("x,worst_psnr_seen,20,,,,,,\"b, c\",seen"));
  for (const QString figure : {"mean_psnr", "psnr_of_mean_mse", "mean_ssim", "mean_psnr_y",
                               "mean_psnr_yuv", "mean_psnr_seen", "psnr_of_mean_mse_seen",
                               "mean_ssim_seen", "mean_psnr_y_seen", "mean_psnr_yuv_seen"}) {
    const QStringList row = cells(lines, "x," + figure);
    QCOMPARE(row.size(), 10);
    QCOMPARE(row[9], QString(figure.endsWith("_seen") ? "seen" : "frame"));
    QVERIFY(row[3].toDouble() <= row[2].toDouble() && row[2].toDouble() <= row[4].toDouble());
    QVERIFY(row[6].toDouble() <= row[5].toDouble() && row[5].toDouble() <= row[7].toDouble());
  }
  QVERIFY(near(cells(lines, "x,mean_psnr")[2].toDouble(), 22));
  QVERIFY(near(cells(lines, "x,mean_psnr")[5].toDouble(), 21));
  QVERIFY(cells(lines, "all tests,rate_bpp").isEmpty());
}

void TestSummaries::rowsWithProblems() {
  ReportRow blind = row("b", "x", 30, 5);
  blind.problem = "sees nothing";
  const auto summaries = summariesOf({row("a", "x", 4), blind, row("c", "x", 4)});
  const QStringList lines = linesOf(summaryCsv(summaries, metrics));
  QCOMPARE(cells(lines, "x,views")[2], QString("3"));
  QCOMPARE(cells(lines, "x,views_without_comparison")[2], QString("1"));
  for (const int k : {2, 3, 4, 5, 6, 7})
    QVERIFY(std::abs(cells(lines, "x,mean_psnr")[k].toDouble() - 24) < 1e-9);
}

/// With tests that hardly differ, the interval over all is as wide as that of one of them: more
/// tests of the same places say nothing new about other places.
void TestSummaries::allResamplesStates() {
  Random random(1);
  std::vector<ReportRow> rows;
  for (int k = 0; k < 40; ++k) {
    const double better = random.uniform(0, 10);
    for (const char* test : {"x", "y", "z"}) rows.push_back(row(std::to_string(k), test, better));
  }
  const auto summaries = summariesOf(rows);
  const auto width = [&](std::size_t k) {
    return summaries[k].intervals[0].high - summaries[k].intervals[0].low;
  };
  QVERIFY(width(0) > 1);
  QVERIFY(near(width(3), width(0)));
}

void TestSummaries::identicalOnly() {
  const auto summaries = summariesOf({identical("a", "x"), identical("b", "x")});
  const QStringList lines = linesOf(summaryCsv(summaries, metrics));
  QVERIFY(lines.contains("x,mean_psnr,nan,nan,nan,nan,nan,nan,,frame"));
  QVERIFY(lines.contains("x,psnr_of_mean_mse,inf,inf,inf,inf,inf,inf,,frame"));
  QVERIFY(lines.contains("x,mean_ssim_seen,1,1,1,1,1,1,,seen"));
  QVERIFY(cells(lines, "x,worst_psnr").isEmpty());
}

void TestSummaries::metricsTable() {
  ReportRow one = row("a, b", "t", 0, 0.5);
  one.values = metricValues(650.25, 0.5, {650.25, 65.025, 0});
  QCOMPARE(QString::fromStdString(metricsCsv({one}, metrics)),
           QString("state,test,mse_y,mse_cb,mse_cr,psnr_y,psnr_cb,psnr_cr,psnr_yuv,mse_y_seen,"
                   "mse_cb_seen,mse_cr_seen,psnr_y_seen,psnr_cb_seen,psnr_cr_seen,psnr_yuv_seen,"
                   "ssim_seen,bits,mse_of_bits,weight,problem\n"
                   "\"a, b\",t,650.25,65.025,0,20,30,inf,inf,650.25,65.025,0,20,30,inf,inf,0.5,"
                   "8,650.25,0.5,\n"));
  one.problem = "no frame, sorry";
  QVERIFY(metricsCsv({one}, metrics).ends_with(",0.5,\"no frame, sorry\"\n"));
}

/// Its column and its mean reach every table without a line of theirs.
void TestSummaries::anotherMetric() {
  Metric largest;
  largest.columns = {{"largest", "Largest", "cv", "", 1, 1, MetricColumn::Where::page}};
  largest.means = {{"mean_largest", "mean largest", 0, 1, nullptr, true}};
  largest.compare = [](const Image& reference, const Image& test, const ParallelRows&,
                       const Progress&, const Viewing&) {
    int most = 0;
    for (std::size_t k = 0; k < test.rgb.size(); ++k)
      most = std::max(most, std::abs(int(reference.rgb[k]) - int(test.rgb[k])));
    return std::vector<double>{double(most)};
  };
  const MetricSet more({largest});
  Image a(20, 20), b(20, 20);
  b.rgb[7] = 99;
  const std::vector<ReportRow> rows{{"s", "t", more.compare(a, b), {0, 0, 1}, 1},
                                    {"u", "t", more.compare(a, a), {0, 0, 1}, 1}};
  QVERIFY(
      reportCsv(rows, more).starts_with("state,test,mse,psnr,mse_seen,psnr_seen,ssim,seen,eye_x"));
  const QStringList lines = linesOf(metricsCsv(rows, more));
  QVERIFY(lines[0].endsWith(",mse_of_bits,largest,weight,problem"));
  QVERIFY(lines[1].endsWith(",99,1,") && lines[2].endsWith(",0,1,"));
  const auto summaries = summariseTests(rows, more);
  QCOMPARE(cells(linesOf(summaryCsv(summaries, more)), "t,mean_largest")[2], QString("49.5"));
  QVERIFY(meansTable(summaries, more).find("<th class=\"n\">mean largest</th>") !=
          std::string::npos);
  QVERIFY(more.isHeadline(more.means().size() - 1) && !more.isHeadline(meanPsnr));
  const std::string table = statesTable(rows, more);
  QVERIFY(table.find("<th class=\"n\">Largest cv</th>") != std::string::npos);
  QVERIFY(table.find("<td class=\"n\">99.0</td>") != std::string::npos);
  const std::vector<RateGroup> groups{{"A", {{"t", 1}}}, {"B", {{"t", 2}}}};
  QCOMPARE(bdRows(summaries, more, groups).back().quality.name, std::string("mean_largest"));
}

void TestSummaries::bdRates() {
  std::vector<ReportRow> rows;
  RateGroup anchor{"A", {}}, half{"B", {}};
  for (int k = 0; k < 4; ++k) {
    const std::string a = "a" + std::to_string(k), b = "b" + std::to_string(k);
    rows.push_back(row("s", a, 2 * k));
    rows.push_back(row("s", b, 2 * k));
    anchor.tests.push_back({a, 0.1 * (k + 1)});
    half.tests.push_back({b, 0.05 * (k + 1)});
  }
  const std::vector<RateGroup> groups{anchor, half};
  const auto comparisons = bdRows(summariesOf(rows, groups), metrics, groups);
  QStringList qualities;
  for (const BdRow& one : comparisons) {
    qualities << QString::fromStdString(one.quality.name);
    QVERIFY(std::abs(one.delta.rate + 50) < 1e-9);
  }
  QCOMPARE(qualities, (QStringList{"mean_psnr_seen", "mean_ssim_seen", "mean_psnr_y_seen",
                                   "mean_psnr_yuv_seen", "mean_psnr", "mean_ssim", "mean_psnr_y",
                                   "mean_psnr_yuv"}));
  QVERIFY(near(comparisons[2].delta.from, 30));
  const QStringList lines = linesOf(bdCsv(comparisons));
  QCOMPARE(lines[0], QString("anchor,group,quality,bd_rate_percent,bd_psnr_db,psnr_from,psnr_to,"
                             "problem,over,unit,bd_quality,quality_from,quality_to,means,"
                             "bd_rate_low,bd_rate_high,bd_quality_low,bd_quality_high"));
  QCOMPARE(lines.size(), 10);
  QVERIFY(lines[8].startsWith("A,B,mean_psnr_yuv,-"));
  const QStringList psnr = lines[1].split(','), ssim = lines[2].split(',');
  QCOMPARE(psnr.mid(8, 2), (QStringList{"seen", "dB"}));
  QCOMPARE(psnr.mid(10, 3), psnr.mid(4, 3));
  QCOMPARE(psnr[13], QString("plain"));
  // Of one state every draw is that state.
  QCOMPARE(psnr.mid(14), (QStringList{psnr[3], psnr[3], psnr[10], psnr[10]}));
  QCOMPARE(ssim.mid(4, 6), (QStringList{"", "", "", "", "seen", ""}));
  QVERIFY(near(ssim[11].toDouble(), 0.5) && near(ssim[12].toDouble(), 0.56));
  QVERIFY(ssim[10].toDouble() > 0);
  QVERIFY(bdText(comparisons, metrics)
              .starts_with("B against A, mean_psnr_seen: BD-rate -50.00 % (-50.00 … -50.00), at "
                           "equal rate "));
  const std::string page = bdTable(comparisons, metrics);
  QVERIFY(page.find("<td>B</td><td>A</td><td>mean PSNR\u2011Y in dB</td>"
                    "<td class=\"n\">-50.00 (-50.00 … -50.00)</td>") != std::string::npos);
  QVERIFY(bdTex(comparisons, metrics).find("B & A & mean PSNR-Y in dB & $-$50.00 ") !=
          std::string::npos);
  const std::string means = meansTable(summariesOf(rows, groups), metrics);
  QVERIFY(means.find("<td>b1</td><td class=\"n\">0.1000</td>") != std::string::npos);
  QVERIFY(means.find("\\begin{tabular}{@{}lrr") != std::string::npos);
  QVERIFY(means.find("\\hline\ntest &amp; bpp &amp; mean PSNR") != std::string::npos);
}

/// Three groups are three pairs. Of two states the draws are both, or one of them twice, so that an
/// interval reaches from the least to the largest delta of these.
void TestSummaries::bdIntervals() {
  std::vector<ReportRow> rows;
  std::vector<RateGroup> groups{{"A", {}}, {"B", {}}, {"C", {}}};
  const std::array gains{0.0, 0.7, 1.9};
  for (int k = 0; k < 4; ++k)
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::string test = groups[g].name + std::to_string(k);
      groups[g].tests.push_back({test, 0.1 * (1 << k) * (1 + 0.1 * double(g))});
      rows.push_back(row("s", test, 2 * k + gains[g], 3));
      rows.push_back(row("t", test, 3 * k + gains[g] * gains[g], 1));
    }
  const std::vector<TestSummary> summaries = summariesOf(rows, groups);
  const auto comparisons = bdRows(summaries, metrics, groups);
  QCOMPARE(comparisons.size(), std::size_t(3 * 2 * 8));
  const auto deltaOf = [&](const BdRow& one, double ofS, double ofT) {
    const auto curve = [&](const std::string& name) {
      std::vector<RatePoint> points;
      const auto& group = *std::ranges::find(groups, name, &RateGroup::name);
      const double gain = gains[std::size_t(&group - groups.data())];
      for (int k = 0; k < 4; ++k)
        points.push_back(
            {group.tests[std::size_t(k)].rate,
             (ofS * (20 + 2 * k + gain) + ofT * (20 + 3 * k + gain * gain)) / (ofS + ofT)});
      return points;
    };
    return bdDelta(curve(one.anchor), curve(one.group));
  };
  int checked = 0;
  for (const BdRow& one : comparisons) {
    if (one.quality.name != "mean_psnr_seen") continue;
    const double weight = one.isWeighted ? 3 : 1;
    const std::array draws{deltaOf(one, weight, 1), deltaOf(one, 1, 0), deltaOf(one, 0, 1)};
    QVERIFY(near(one.delta.rate, draws[0].rate) && near(one.delta.quality, draws[0].quality));
    const auto least = [&](double BdDelta::*of) {
      return std::min({draws[0].*of, draws[1].*of, draws[2].*of});
    };
    const auto most = [&](double BdDelta::*of) {
      return std::max({draws[0].*of, draws[1].*of, draws[2].*of});
    };
    QVERIFY(near(one.rate.low, least(&BdDelta::rate)) && near(one.rate.high, most(&BdDelta::rate)));
    QVERIFY(near(one.gain.low, least(&BdDelta::quality)) &&
            near(one.gain.high, most(&BdDelta::quality)));
    ++checked;
  }
  QCOMPARE(checked, 6);
  QVERIFY(comparisons.front().isWeighted && comparisons.front().group == "B");
  QVERIFY(comparisons.back().anchor == "B" && comparisons.back().group == "C");
  QVERIFY(bdCsv(comparisons).find(",weighted,") != std::string::npos);
}

/// An error that falls with the rate compares as its negative does; one that does not fall on both
/// curves has no BD-rate.
void TestSummaries::bdOfAnError() {
  Metric metric;
  metric.columns = {{.name = "good"}, {.name = "bad"}};
  metric.means = {
      {.name = "mean_good", .title = "", .column = 0, .isQuality = true},
      {.name = "mean_bad", .title = "", .column = 1, .isQuality = true, .mayFall = true}};
  const MetricSet both({metric});
  std::vector<ReportRow> rows;
  std::vector<RateGroup> groups{{"A", {}}, {"B", {}}};
  for (int k = 0; k < 4; ++k)
    for (std::size_t g = 0; g < 2; ++g) {
      const std::string test = groups[g].name + std::to_string(k);
      groups[g].tests.push_back({test, 0.1 * (1 << k)});
      const double good = 3 * std::sqrt(k) + double(g);
      rows.push_back(row("s", test, 2 * k));
      rows.back().values.insert(rows.back().values.end(), {good, -good});
    }
  auto comparisons = bdRows(summariseTests(rows, both, groups), both, groups);
  const BdDelta good = comparisons[comparisons.size() - 2].delta, bad = comparisons.back().delta;
  QVERIFY(good.problem.empty() && good.rate < 0 && good.quality > 0);
  QVERIFY(near(bad.rate, good.rate) && near(bad.quality, -good.quality));
  QVERIFY(near(bad.from, -good.to) && near(bad.to, -good.from));
  rows.back().values.back() = 5;
  comparisons = bdRows(summariseTests(rows, both, groups), both, groups);
  QVERIFY(!comparisons.back().delta.problem.empty());
}

void TestSummaries::bdProblems() {
  const BdRow none{"A", "B", metrics.means()[meanPsnrSeen], bdDelta({}, {})};
  QCOMPARE(bdText({none}, metrics),
           std::string("B against A, mean_psnr_seen: no BD-rate: the anchor has 0 points, "
                       "but four are needed\n"));
  QVERIFY(bdCsv({none}).ends_with(
      "A,B,mean_psnr_seen,nan,nan,nan,nan,\"the anchor has 0 points, but four are needed\",seen,dB,"
      "nan,nan,nan,plain,nan,nan,nan,nan\n"));
}

void TestSummaries::page() {
  const std::string plain = meansTable(summariesOf({row("<s>", "<t>", 1)}), metrics);
  QVERIFY(plain.find("<td>&lt;t&gt;</td>") != std::string::npos);
  QVERIFY(plain.find("<td>&lt;s&gt;</td>") != std::string::npos);
  QVERIFY(plain.find("weighted") == std::string::npos);
  QVERIFY(plain.find("Bjøntegaard") == std::string::npos);
  const std::string weighted =
      meansTable(summariesOf({row("a", "t", 0, 3), row("b", "t", 10)}), metrics);
  QVERIFY(weighted.find("<td>t, weighted</td><td class=\"n\">22.50 <small>(") != std::string::npos);
}

/// A name of LaTeX's own characters; columns of numbers are to the right.
void TestSummaries::latex() {
  QCOMPARE(
      QString::fromStdString(latexPart(latexTable(
          {{"test", "a_b", "note"}, {"x\\y{z}&%$#^~.png", "-1.5", "–"}, {"<q>", "–", "w"}}))),
      QString(
          "<details><summary>As LaTeX</summary><pre>{\\footnotesize\\setlength{\\tabcolsep}{3pt}"
          "%\n\\begin{tabular}{@{}lrl@{}}\n\\hline\n"
          "test &amp; a\\_b &amp; note \\\\\n\\hline\n"
          "x\\textbackslash{}y\\{z\\}\\&amp;\\%\\$\\#\\textasciicircum{}\\textasciitilde{}.png"
          " &amp; $-$1.5 &amp; -- \\\\\n\\textless{}q\\textgreater{} &amp; -- &amp; w \\\\\n"
          "\\hline\n\\end{tabular}}\n</pre></details>\n"));
}

/// Heads, ranges, names and tables are broken one after the other, as far as a width asks.
void TestSummaries::latexFitsAWidth() {
  const Table table{{"test", "mean PSNR in dB", "mean SSIM"},
                    {"hevc_q22", "31.20 (30.95 … 31.44)", "0.9512 (0.9400 … 0.9600)"}};
  const auto has = [](const std::string& tex, const char* line) {
    return tex.find(line) != std::string::npos;
  };
  const std::string wide = latexTable(table, 1000);
  QVERIFY(has(wide,
              "\nhevc\\_q22 & 31.20 (30.95 \\ldots{} 31.44) & 0.9512 (0.9400 \\ldots{} 0.9600) "
              "\\\\\n"));
  const std::string column = latexTable(table, 190);
  QVERIFY2(has(column,
               "\nhevc\\_q22 & 31.20 & 0.9512 \\\\\n & (30.95 \\ldots{} 31.44) & (0.9400 "
               "\\ldots{} 0.9600) \\\\\n"),
           column.c_str());
  const std::string narrow = latexTable(table, 130);
  QCOMPARE(QString::fromStdString(narrow).count("\\begin{tabular}{@{}lr@{}}"), 2);
  QCOMPARE(QString::fromStdString(narrow).count("hevc\\_q22 & "), 2);
  const std::string least = latexTable({{"test", "n"}, {"a_very_long_name_of_a_test", "1"}}, 60);
  QVERIFY2(has(least, "\\ldots{}") && !has(least, "long"), least.c_str());
}

QTEST_APPLESS_MAIN(TestSummaries)
#include "test_summary.moc"
