// SPDX-License-Identifier: BSD-3-Clause
// Tests a report's numbers against scikit-image on the written pictures, its summary, and BD-rates.
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

using namespace hogelscope;

namespace {

/// The sample light field as a JPEG shows it. A PNG, which is opened faster.
void writeLossy(const QString& file, int quality) {
  const QString source = HOGELSCOPE_SOURCE_DIR "/tests/data/scene.png";
  if (!QImage(source).save("lossy.jpg", "JPG", quality)) qFatal("cannot write lossy.jpg");
  const std::vector<std::uint8_t> shown = bytesOf("lossy.jpg");
  const QSize size = sizeOf("lossy.jpg");
  writeImageFile(file, size.width(), size.height(), [&](int x, int y, int c) {
    return float(shown[std::size_t(3 * (y * size.width() + x) + c)]) / 255;
  });
}

/// Debian's python3 where it has scikit-image; "" elsewhere.
QString pythonWithSkimage() {
  for (const char* python : {"python3", "/usr/bin/python3"})
    if (QProcess::execute("sh", {"-c", QString(python) + " -c 'import skimage' 2>/dev/null"}) == 0)
      return python;
  return {};
}

const QStringList states{"Fig 1", "Fig 2", "Fig 3", "Fig 4", "Fig 5", "Fig 6"};

}  // namespace

class TestReportMetrics : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void csvIsAsBefore();
  void asScikitImage();
  void againstItself();
  void jpegLadder();
  void summaryIsOfTheRows();
  void bdRates();
  void figuresCompileInLatex();
  void ratesFromFileSizes();
  void oneGroupIsACurve();
  void picturesOfThePageAreSmall();
  void badGroups_data();
  void badGroups();

 private:
  Outcome report(const QStringList& more, const QString& output = "out") {
    return run(QStringList{"--report", "--session", sampleSession, "--set", "camera.res=[80,60]",
                           "--output", output} +
                   more,
               m_folder.path());
  }

  QTemporaryDir m_folder;
  QStringList m_tests;
};

/// Four qualities twice: the same pictures under two names, so that only rates differ.
void TestReportMetrics::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  for (const int quality : {15, 30, 60, 90}) {
    const QString name = QString("q%1.png").arg(quality);
    writeLossy(name, quality);
    QVERIFY(QFile::copy(name, "copy_" + name));
    m_tests << "--test" << name;
  }
  const Outcome outcome = report(m_tests + QStringList{"--images"});
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(outcome.status, 0);
}

void TestReportMetrics::csvIsAsBefore() {
  QVERIFY(contentOf("out/report.csv")
              .startsWith("state,test,mse,psnr,mse_seen,psnr_seen,ssim,seen,eye_x,eye_y,eye_z\n"));
  QVERIFY(
      contentOf("out/metrics.csv")
          .startsWith("state,test,mse_y,mse_cb,mse_cr,psnr_y,psnr_cb,psnr_cr,psnr_yuv,"
                      "mse_y_seen,mse_cb_seen,mse_cr_seen,psnr_y_seen,psnr_cb_seen,"
                      "psnr_cr_seen,psnr_yuv_seen,ssim_seen,bits,mse_of_bits,weight,problem\n"));
  QVERIFY(!QFileInfo::exists("out/bd.csv"));
}

void TestReportMetrics::asScikitImage() {
  const QString python = pythonWithSkimage();
  if (python.isEmpty()) QSKIP("python3-skimage is not installed");
  const auto rows = tableOf("out/report.csv").mid(1);
  const auto more = tableOf("out/metrics.csv").mid(1);
  QStringList arguments{HOGELSCOPE_SOURCE_DIR "/tests/cli/metrics.py"};
  for (int k = 0; k < rows.size(); ++k)
    arguments << "out/reference/" + rows[k][0] + ".png"
              << QString("out/test%1/%2.png").arg(k % 4 + 1).arg(rows[k][0]);
  QProcess process;
  process.start(python, arguments);
  QVERIFY(process.waitForFinished(-1));
  const QList<QByteArray> lines = process.readAllStandardOutput().trimmed().split('\n');
  QVERIFY2(lines.size() == rows.size(), process.readAllStandardError());
  QCOMPARE(rows.size(), 24);
  const auto isNear = [](const QString& cell, const QByteArray& expected, double tolerance) {
    return cell == "inf" ? expected == "inf"
                         : std::abs(cell.toDouble() - expected.toDouble()) < tolerance;
  };
  for (int k = 0; k < rows.size(); ++k) {
    const QList<QByteArray> expected = lines[k].split(' ');
    QCOMPARE(expected.size(), 8);
    QVERIFY2(isNear(rows[k][2], expected[0], 1e-9), lines[k]);
    QVERIFY2(isNear(rows[k][3], expected[1], 1e-9), lines[k]);
    QVERIFY2(isNear(rows[k][6], expected[2], 1e-6), lines[k]);
    for (int c = 0; c < 4; ++c) QVERIFY2(isNear(more[k][2 + c], expected[3 + c], 1e-9), lines[k]);
    QVERIFY2(isNear(more[k][8], expected[7], 1e-9), lines[k]);
  }
}

void TestReportMetrics::againstItself() {
  QCOMPARE(report({"--test", HOGELSCOPE_SOURCE_DIR "/tests/data/scene.png"}, "self").status, 0);
  for (const QStringList& row : tableOf("self/report.csv").mid(1)) {
    QCOMPARE(row.mid(2, 2), (QStringList{"0", "inf"}));
    QCOMPARE(row[6], QString("1"));
  }
  const auto summary = tableOf("self/summary.csv");
  QCOMPARE(summary[1].mid(1, 2), (QStringList{"views", "6"}));
  QCOMPARE(summary[2].mid(1, 2), (QStringList{"identical_views", "6"}));
  for (const QStringList& row : tableOf("self/metrics.csv").mid(1))
    QCOMPARE(row.mid(2, 7), (QStringList{"0", "0", "0", "inf", "inf", "inf", "inf"}));
}

/// PSNR rises with the quality in every state, and so do the other metrics.
void TestReportMetrics::jpegLadder() {
  const auto rows = tableOf("out/report.csv").mid(1);
  const auto more = tableOf("out/metrics.csv").mid(1);
  for (int state = 0; state < states.size(); ++state) {
    for (int k = 4 * state + 1; k < 4 * state + 4; ++k) {
      QCOMPARE(rows[k][0], states[state]);
      QVERIFY(rows[k][3].toDouble() > rows[k - 1][3].toDouble());
      QVERIFY(rows[k][6].toDouble() > rows[k - 1][6].toDouble());
      QVERIFY(more[k][5].toDouble() > more[k - 1][5].toDouble());
      QVERIFY(more[k][8].toDouble() > more[k - 1][8].toDouble());
    }
  }
}

void TestReportMetrics::summaryIsOfTheRows() {
  double sum = 0;
  for (int k = 1; k < 24; k += 4) sum += tableOf("out/report.csv").mid(1)[k][5].toDouble() / 6;
  bool isFound = false;
  for (const QStringList& row : tableOf("out/summary.csv")) {
    if (row.mid(0, 2) != QStringList{"q30.png", "mean_psnr_seen"}) continue;
    isFound = true;
    QVERIFY(std::abs(row[2].toDouble() - sum) < 1e-12);
    QVERIFY(row[3].toDouble() < sum && row[4].toDouble() > sum);
    QCOMPARE(row.mid(5, 3), row.mid(2, 3));
    QVERIFY(contentOf("out/report.html")
                .contains("<td>q30</td><td class=\"n\">" + QByteArray::number(sum, 'f', 2) +
                          " <small>("));
  }
  QVERIFY(isFound);
}

/// Pictures of equal quality at half the rate.
void TestReportMetrics::bdRates() {
  QStringList arguments = m_tests;
  QStringList names;
  int k = 0;
  for (const char* quality : {"q15.png", "q30.png", "q60.png", "q90.png"}) {
    names << quality;
    const double rate = 0.2 * ++k;
    arguments << "--test" << QString("copy_") + quality;
    arguments << "--rate" << QString("%1=%2").arg(quality).arg(rate);
    arguments << "--rate" << QString("copy_%1=%2").arg(quality).arg(rate / 2);
  }
  arguments << "--group"
            << "JPEG=" + names.join(',');
  arguments << "--group"
            << "Half, 50 %_#=copy_" + names.join(",copy_");
  const Outcome outcome = report(arguments, "bd");
  QCOMPARE(outcome.err, QByteArray());
  const auto table = tableOf("bd/bd.csv");
  QCOMPARE(table.size(), 9);
  for (int row = 1; row < 9; ++row) {
    QCOMPARE(table[row].mid(0, 2), (QStringList{"JPEG", "Half, 50 %_#"}));
    QVERIFY(std::abs(table[row][3].toDouble() + 50) < 1e-9);
    QVERIFY(table[row][10].toDouble() > 0);
    QCOMPARE(table[row][8], QString(row <= 4 ? "seen" : "frame"));
    QCOMPARE(table[row][7], QString());
  }
  QVERIFY2(outcome.out.contains("Half, 50 %_# against JPEG, mean_psnr_seen: BD-rate -50.00 %"),
           outcome.out);
  QVERIFY(contentOf("bd/report.html")
              .contains("<td>Half, 50 %_#</td><td>JPEG</td><td>mean PSNR\u2011YUV in dB</td>"
                        "<td class=\"n\">-50.00 (-50.00 … -50.00)</td>"));
}

/// The manual's way: every plot as PDF of the right width, both tables, and a picture of a view, in
/// one document whose columns are those of IEEEtran, from which nothing sticks out.
void TestReportMetrics::figuresCompileInLatex() {
  for (const char* program : {"pdflatex", "rsvg-convert"})
    if (QStandardPaths::findExecutable(program).isEmpty())
      QSKIP(qPrintable(QString("%1 is not installed").arg(program)));
  const auto call = [](const QString& program, const QStringList& arguments) {
    QProcess process;
    process.start(program, arguments);
    process.waitForFinished(-1);
    return std::pair(process.exitCode(), process.readAllStandardOutput());
  };
  QByteArray body;
  const QStringList plots = QDir("bd/plots").entryList({"*.svg"});
  QCOMPARE(plots.size(), 2 * (8 * 5 + 4));  // of eight tests, and the curves
  for (const QString& plot : plots) {
    const QString pdf = plot.chopped(4) + ".pdf";
    QCOMPARE(call("rsvg-convert", {"-f", "pdf", "-o", pdf, "bd/plots/" + plot}).first, 0);
    const bool isForPage = plot.endsWith("_page.svg");
    const auto box = QRegularExpression(R"(/MediaBox \[ ?0 0 ([0-9.]+))")
                         .match(QString::fromLatin1(contentOf(pdf)));
    const double width = box.captured(1).toDouble() / 72 * 25.4;
    QVERIFY2(std::abs(width - (isForPage ? 178 : 86)) < 0.1, qPrintable(plot));
    if (isForPage) continue;
    body += "\\includegraphics{" + pdf.toUtf8() + "}\n";
  }
  body += "\\includegraphics[width=\\linewidth]{bd/views/test1_worst.png}\n";
  for (const char* table : {"means", "bd"})
    body += QByteArray("\n\\input{bd/plots/") + table + ".tex}\n";
  QFile document("paper.tex");
  QVERIFY(document.open(QIODevice::WriteOnly));
  document.write(
      "\\documentclass[twocolumn]{article}\\usepackage{graphicx}\n"
      "\\setlength{\\textwidth}{516pt}\\setlength{\\columnsep}{12pt}\n"
      "\\setlength{\\parindent}{0pt}\n\\begin{document}\n" +
      body + "\\end{document}\n");
  document.close();
  const auto [status, said] =
      call("pdflatex", {"-halt-on-error", "-interaction=nonstopmode", "paper.tex"});
  QVERIFY2(status == 0, said);
  QVERIFY(said.contains("Output written on paper.pdf"));
  QVERIFY2(!said.contains("Overfull"), said);
}

void TestReportMetrics::ratesFromFileSizes() {
  QStringList arguments = m_tests;
  const QString names = "q15.png,q30.png,q60.png,q90.png";
  const Outcome outcome =
      report(arguments + QStringList{"--group", "a=" + names, "--group", "b=" + names}, "sizes");
  QCOMPARE(outcome.err, QByteArray());
  QCOMPARE(tableOf("sizes/bd.csv")[1][3].toDouble(), 0.0);
  for (const QStringList& row : tableOf("sizes/summary.csv"))
    if (row[1] == "rate_bpp")
      QCOMPARE(row[2].toDouble(), 8.0 * double(QFileInfo(row[0]).size()) / (640 * 640));
}

/// One group is a curve, of which nothing is compared.
void TestReportMetrics::oneGroupIsACurve() {
  const Outcome outcome =
      report(m_tests + QStringList{"--group", "a=q15.png,q30.png,q60.png,q90.png"}, "one");
  QCOMPARE(outcome.err, QByteArray());
  QVERIFY(!QFileInfo::exists("one/bd.csv"));
  const QByteArray page = contentOf("one/report.html");
  QVERIFY(page.contains("Quality over rate") && !page.contains("Bjøntegaard deltas"));
}

/// The page's pictures have 8 MB, however many tests there are; those of the first test have all
/// pixels, those of others lead to files that have.
void TestReportMetrics::picturesOfThePageAreSmall() {
  const Outcome outcome =
      run(QStringList{"--report", "--session", sampleSession, "--set", "camera.res=[900,840]",
                      "--set", "sampling.reconstruction=quadrilinear", "--states", "Fig [145]",
                      "--output", "large"} +
              m_tests.mid(0, 6),
          m_folder.path());
  QCOMPARE(outcome.status, 0);
  const QByteArray page = contentOf("large/report.html");
  qsizetype bytes = 0;
  int pictures = 0;
  for (qsizetype at = page.indexOf("base64,"); at >= 0; at = page.indexOf("base64,", at + 1)) {
    bytes += page.indexOf('"', at) - at - 7;
    ++pictures;
  }
  QCOMPARE(pictures, 3 * (9 + 4));
  QVERIFY2(bytes < 8000000 && bytes > 3000000, qPrintable(QString::number(bytes)));
  QCOMPARE(page.count("<div class=\"row views whole\">"), 3);
  QCOMPARE(page.count(" of the size of the files in views</h3>"), 6);
  QVERIFY(page.indexOf("row views whole") < page.indexOf("of the size of the files in views"));
  qint64 files = 0;
  for (int k = 0; k < 27; ++k) {
    const QString file = QString("large/views/test%1_%2_%3.png")
                             .arg(k / 9 + 1)
                             .arg(QStringList{"worst", "median", "best"}[k / 3 % 3],
                                  QStringList{"reference", "test", "difference"}[k % 3]);
    QCOMPARE(sizeOf(file).width(), 900);
    QVERIFY(page.contains(("<a href=\"" + file.mid(6) + "\">").toUtf8()));
    files += QFileInfo(file).size();
  }
  QVERIFY2(4 * files / 3 > 8000000,
           qPrintable(QString::number(files)));  // they would not have fitted
}

void TestReportMetrics::badGroups_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("line");
  const QString all = "=q15.png,q30.png,q60.png,q90.png";
  const auto row = [](const char* name, const QStringList& arguments, const QByteArray& line) {
    QTest::newRow(name) << arguments << line;
  };
  row("unknown test", {"--group", "a=q15.png,q31.png", "--group", "b" + all},
      "--group a: \"q31.png\" is not given as --test; did you mean q30.png?");
  row("three tests", {"--group", "a" + all, "--group", "b=q15.png,q30.png,q60.png"},
      "--group b: has 3 light field(s), but a rate-distortion curve needs four or more");
  row("twice the same test", {"--group", "a=q15.png,q15.png", "--group", "b" + all},
      "--group a: has q15.png twice");
  row("twice the same name", {"--group", "a" + all, "--group", "a=q90.png,q60.png,q30.png,q15.png"},
      "--group a: is given twice");
  row("no name", {"--group", all, "--group", "b" + all},
      "--group: \"" + all.toUtf8() + "\" is not NAME=FILE,FILE,FILE,FILE");
  row("no tests", {"--group", "a", "--group", "b" + all},
      "--group: \"a\" is not NAME=FILE,FILE,FILE,FILE");
  row("rate without group", {"--rate", "q15.png=1"},
      "--rate: is for --group NAME=FILE,FILE,…, of which there is none");
  const QStringList groups{"--group", "a" + all, "--group", "b" + all};
  row("rate of nothing", groups + QStringList{"--rate", "0.5"},
      "--rate: \"0.5\" is not FILE=BITS, such as test.jpg=0.5");
  row("rate of no test", groups + QStringList{"--rate", "nothing.tif=0.5"},
      "--rate: \"nothing.tif\" is not given as --test");
  for (const char* bad : {"0", "-1", "nan", "inf", "1x", ""})
    row(bad, groups + QStringList{"--rate", QString("q15.png=") + bad},
        "--rate: \"" + QByteArray(bad) + "\" is not a number of bits above 0");
  row("two rates", groups + QStringList{"--rate", "q15.png=1", "--rate", "q15.png=2"},
      "--rate: gives q15.png two rates");
}

void TestReportMetrics::badGroups() {
  QFETCH(const QStringList, arguments);
  QFETCH(const QByteArray, line);
  const Outcome outcome = report(m_tests + arguments, "bad");
  QCOMPARE(outcome.err, "hogelscope: command line: " + line + "\n");
  QCOMPARE(outcome.status, 2);
  QVERIFY(!QFileInfo::exists("bad"));
}

QTEST_GUILESS_MAIN(TestReportMetrics)
#include "test_report_metrics.moc"
