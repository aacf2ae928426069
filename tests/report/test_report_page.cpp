// SPDX-License-Identifier: BSD-3-Clause
// Tests the report's page: well-formed and whole in one file, its parts in order, none of them
// empty, its images byte for byte.
#include "report/page/report_page.h"

#include <QCryptographicHash>
#include <QTest>
#include <QXmlStreamReader>
#include <cmath>
#include <stdexcept>

#include "core/base/text.h"
#include "page/html.h"
#include "report/page/test_names.h"
#include "tests/core/random.h"
#include "tests/report/metric_values.h"

using namespace hogelscope;

namespace {

ReportRow row(const std::string& state, double mse) {
  return {state, "t.png", metricValues(mse), {0, 0, 1}};
}

ReportRow blind(const std::string& state) {
  return {state, "t.png", MetricSet().noValues(), {0, 0, -1}, 1, "sees <nothing>"};
}

PanelParams displayOf() {
  PanelParams display;
  display.hogels = {16, 12};
  display.directions = {8, 6};
  return display;
}

ReportPage pageOf(const std::vector<ReportRow>& rows) {
  ReportPage page;
  page.session = "s.json";
  page.display = displayOf();
  page.rows = rows;
  if (!rows.empty()) page.summaries = summariseTests(rows, page.metrics);
  return page;
}

/// Everything that a page can hold.
ReportPage fullPage() {
  ReportPage page = pageOf({row("a", 650.25), row("b", 65.025), row("c", 0), blind("d")});
  page.facts = {{"command", "hogelscope --report <x> & \"y\""}};
  page.comparisons = {{"A", "B", page.metrics.means()[meanPsnrSeen], bdDelta({}, {})}};
  page.groups = {{"A", {{"t.png", 0.25}}}, {"B", {}}};
  page.lenses = {{"a", {}}};
  page.views = {{0, "worst", "PNG1", "PNG2", "PNG3", 8, 1, "views/test1_worst"}};
  page.panels = {{"t.png", "PNG4", "PNG5", {2, 3, 0.25, 0.5, {1, 2}, {-10, 5}}}};
  return page;
}

/// The texts of all elements of a name; fails where the page is not well-formed.
QStringList textsOf(const std::string& html, const QString& name) {
  QXmlStreamReader xml(QByteArray::fromStdString(html));
  QStringList texts;
  while (!xml.atEnd())
    if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == name)
      texts.push_back(xml.readElementText(QXmlStreamReader::IncludeChildElements));
  if (xml.hasError()) qFatal("%s", qPrintable(xml.errorString()));
  return texts;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

class TestReportPage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void base64_data();
  void base64();
  void base64OfAnything();
  void roundedNumbers();
  void partsInOrder();
  void emptyPartsLeaveNoHeading();
  void oneFile();
  void onlyItsOwnScriptRuns();
  void facts();
  void meansAndProblems();
  void testsHaveShortNames();
  void oneTestAtATime();
  void weightedMeansComeFirst();
  void warnings();
  void problemsInTheTable();
  void pictures();
  void unitsAgainstTheDesign();
  void noSuchRow();
  void lensesThatAreShared();
  void lists();
  void namesAreEscaped();
};

void TestReportPage::base64_data() {
  QTest::addColumn<QString>("bytes");
  QTest::addColumn<QString>("text");  // RFC 4648, section 10
  QTest::newRow("0") << ""
                     << "";
  QTest::newRow("1") << "f"
                     << "Zg==";
  QTest::newRow("2") << "fo"
                     << "Zm8=";
  QTest::newRow("3") << "foo"
                     << "Zm9v";
  QTest::newRow("4") << "foob"
                     << "Zm9vYg==";
  QTest::newRow("5") << "fooba"
                     << "Zm9vYmE=";
  QTest::newRow("6") << "foobar"
                     << "Zm9vYmFy";
}

void TestReportPage::base64() {
  QFETCH(const QString, bytes);
  QFETCH(const QString, text);
  QCOMPARE(QString::fromStdString(hogelscope::base64(bytes.toStdString())), text);
}

void TestReportPage::base64OfAnything() {
  Random random(1);
  for (int length = 0; length < 300; ++length) {
    QByteArray bytes;
    for (int k = 0; k < length; ++k) bytes.push_back(char(random.integer(0, 255)));
    QCOMPARE(QByteArray::fromStdString(hogelscope::base64(bytes.toStdString())), bytes.toBase64());
  }
}

void TestReportPage::roundedNumbers() {
  QCOMPARE(rounded(31.005, 1), std::string("31.0"));
  QCOMPARE(rounded(-0.001, 2), std::string("0.00"));
  QCOMPARE(rounded(-12.345, 2), std::string("-12.35"));
  QCOMPARE(rounded(1e300, 0).size(), std::size_t(301));
  QCOMPARE(rounded(std::nan(""), 2), std::string("–"));
  QCOMPARE(rounded(psnr(0), 2), std::string("identical"));
}

void TestReportPage::partsInOrder() {
  QCOMPARE(textsOf(html(fullPage()), "h2"),
           (QStringList{"Results", "Quality over rate", "Bjøntegaard deltas",
                        "PSNR over camera position", "Worst, median and best views",
                        "Where the error comes from", "Means over the whole frame", "All states",
                        "How far the lenses can be trusted", "How to read the figures",
                        "What was tested"}));
}

void TestReportPage::emptyPartsLeaveNoHeading() {
  QCOMPARE(textsOf(html(pageOf({})), "h2"),
           (QStringList{"How to read the figures", "What was tested"}));
  QCOMPARE(textsOf(html(pageOf({row("a", 1)})), "h2"),
           (QStringList{"Results", "Means over the whole frame", "All states",
                        "How to read the figures", "What was tested"}));
}

/// Nothing lies elsewhere but the pictures' own files, and what is here is HTML and XML alike.
void TestReportPage::oneFile() {
  QString page = QString::fromStdString(html(fullPage()));
  QVERIFY(page.startsWith("<!DOCTYPE html>") && page.trimmed().endsWith("</html>"));
  page.remove("src=\"data:image/png;base64,").remove("href=\"data:image/png;base64,");
  page.remove("<a href=\"views/test");
  for (const char* outside : {"http:", "https:", "src=", "href=", "url(", "@import", "<link"})
    QVERIFY2(!page.contains(outside), outside);
}

/// By its policy, which names style and script by their hashes and allows nothing inline besides.
void TestReportPage::onlyItsOwnScriptRuns() {
  const std::string page = html(fullPage());
  const auto hashOf = [&page](const char* name) {
    const QStringList texts = textsOf(page, name);
    const QByteArray text = texts.value(0).toUtf8();
    return texts.size() == 1
               ? QString(QCryptographicHash::hash(text, QCryptographicHash::Sha256).toBase64())
               : QString("not one");
  };
  const QString policy =
      QString(
          "content=\"default-src 'none'; img-src data:; style-src 'sha256-%1'; script-src "
          "'sha256-%2'; base-uri 'none'; form-action 'none'\"/>")
          .arg(hashOf("style"), hashOf("script"));
  QVERIFY2(contains(page, policy.toStdString()), qPrintable(policy));
  QVERIFY(page.find(policy.toStdString()) < page.find("<style>"));
  QVERIFY(!contains(page, " style=") && !contains(page, " onclick="));
}

void TestReportPage::facts() {
  const QStringList cells = textsOf(html(fullPage()), "td");
  QCOMPARE(cells[cells.size() - 2], QString("hogelscope --report <x> & \"y\""));
  QCOMPARE(cells.back(), QString("0.5 × 0.5 m, 16 × 12 hogels of 8 × 6 directions, field of view "
                                 "60 × 60°, rectilinear hogel lenses"));
}

void TestReportPage::meansAndProblems() {
  const std::string page = html(fullPage());
  QVERIFY(contains(page, "nothing to compare</th>"));
  QVERIFY(contains(page,
                   "<td class=\"n\">1 of 4</td><td class=\"n\">1 of 4</td>"
                   "<td class=\"n\">20.00</td><td>a</td>"));
  QVERIFY(!contains(html(pageOf({row("a", 1)})), "nothing to compare</th>"));
}

/// Over codecs and rates a mean of all tests means nothing. Tests have short names.
void TestReportPage::testsHaveShortNames() {
  ReportPage page = pageOf({row("a", 1), row("a", 2)});
  for (ReportRow& one : page.rows) one.test = "x/t.png";
  page.rows[1].test = "x/u.png";
  page.summaries = summariseTests(page.rows, page.metrics);
  const QStringList cells = textsOf(html(page), "td");
  QVERIFY(!cells.contains("all tests") && !cells.contains("x/t.png"));
  QCOMPARE(cells.count("t"), 3);  // means, means over the frame, states
  using Names = std::vector<std::string>;
  QCOMPARE(figureNames({"a/q.jpg", "b/r.jpg"}), Names({"q", "r"}));
  QCOMPARE(figureNames({"q.jpg", "q.jp2"}), Names({"q.jpg", "q.jp2"}));
  QCOMPARE(figureNames({"views/", "v/q0.25"}), Names({"views", "q0.25"}));
  QCOMPARE(figureNames({".jpg", "/"}), Names({".jpg", ""}));
}

/// The figures of one test are shown at a time: sections that the script reads.
void TestReportPage::oneTestAtATime() {
  ReportPage page = pageOf({row("a", 1), row("a", 2), row("b", 3), row("b", 4)});
  for (std::size_t k = 0; k < 4; ++k) {
    page.rows[k].test = k % 2 == 0 ? "t.png" : "u.png";
    page.rows[k].eye = {k < 2 ? 0.0 : 0.1, 0, 1};
  }
  page.summaries = summariseTests(page.rows, page.metrics);
  const QString text = QString::fromStdString(html(page));
  QCOMPARE(text.count("<section data-test=\"t\">"), 1);
  QCOMPARE(text.count("<section data-test=\"u\">"), 1);
  QCOMPARE(figuresOf(page).size(), std::size_t(6));
}

/// Weighted means come first where states have weights, and LaTeX has them alone.
void TestReportPage::weightedMeansComeFirst() {
  ReportPage page = pageOf({row("a", 650.25), row("b", 65.025)});
  page.rows[0].weight = 3;
  page.summaries = summariseTests(page.rows, page.metrics);
  const QStringList cells = textsOf(html(page), "td");
  QVERIFY(cells.indexOf("t, weighted") >= 0);
  QVERIFY(cells.indexOf("t, weighted") < cells.indexOf("t"));
  QVERIFY(cells.filter("22.50 (").size() >= 1);  // (3·20 + 30)/4
  const std::string tex = meansTex(page.summaries, page.metrics);
  QVERIFY(contains(tex, "t, weighted & 22.50 "));
  QVERIFY(!contains(tex, "25.00 ("));
}

void TestReportPage::warnings() {
  ReportPage page = pageOf({row("a", 1)});
  QVERIFY(!contains(html(page), "class=\"warning\""));
  page.warnings = {"the reference is <lossy>"};
  QVERIFY(contains(html(page), "<p class=\"warning\">the reference is &lt;lossy&gt;</p>"));
}

void TestReportPage::problemsInTheTable() {
  const std::string page = html(fullPage());
  QVERIFY(contains(page,
                   "<tr><td>d</td><td>t</td><td colspan=\"9\" class=\"problem\">"
                   "sees &lt;nothing&gt;</td></tr>"));
  QVERIFY(contains(page, "<tr><td>c</td><td>t</td><td class=\"n\">identical</td>"));
  QVERIFY(contains(page, "<tr><td>a</td><td>t</td><td class=\"n\">20.00</td>"));
}

void TestReportPage::pictures() {
  const std::string page = html(fullPage());
  for (const char* bytes : {"PNG1", "PNG2", "PNG3", "PNG4", "PNG5"})
    QVERIFY2(contains(page, "=\"data:image/png;base64," + hogelscope::base64(bytes) + "\""), bytes);
  QVERIFY(textsOf(page, "h3").contains("Worst view: a: PSNR 20.00 dB, SSIM 0.5000"));
  const QStringList captions = textsOf(page, "figcaption");
  QVERIFY(captions.contains("absolute difference, 8 times as bright"));
  // Each leads to its file; those with all pixels are shown so.
  for (const char* kind : {"reference", "test", "difference"})
    QVERIFY(contains(page, std::string("<a href=\"views/test1_worst_") + kind + ".png\"><img "));
  QVERIFY(contains(page, "<div class=\"row views whole\">"));
  ReportPage small = fullPage();
  small.views[0].scale = 3;
  QVERIFY(contains(html(small), "<div class=\"row views\">"));
  QVERIFY(contains(html(small), "SSIM 0.5000, 1/3 of the size of the files in views</h3>"));
  QVERIFY(contains(page, "half of the") || contains(page, "Half of the squared error"));
  QVERIFY(contains(page, "costliest direction is 10.0° left, 5.0° up"));
}

/// The heading says what is compared, and plots of all units come first.
void TestReportPage::unitsAgainstTheDesign() {
  ReportPage page = pageOf({row("a", 65), row("b", 650)});
  page.rows[1].test = "u.png";
  page.summaries = summariseTests(page.rows, page.metrics);
  QCOMPARE(textsOf(html(page), "h1"), QStringList("Perceived views of s.json"));
  QVERIFY(!textsOf(html(page), "h2").contains("Over the units"));
  page.isAgainstDesign = true;
  QCOMPARE(textsOf(html(page), "h1"), QStringList("Units as built against the design of s.json"));
  QCOMPARE(textsOf(html(page), "h2").mid(0, 2), (QStringList{"Over the units", "Results"}));
  QCOMPARE(hogelscope::figuresOf(page).front().name, std::string("units_mean_psnr_seen"));
}

void TestReportPage::noSuchRow() {
  ReportPage page = fullPage();
  page.views[0].row = 4;
  QVERIFY_EXCEPTION_THROWN(html(page), std::out_of_range);
}

void TestReportPage::lensesThatAreShared() {
  ReportPage page = pageOf({row("a", 1)});
  for (int k = 0; k < 50; ++k)
    page.lenses.push_back({"s" + std::to_string(k), {0.5, 0.1, 0, 0, 9}});
  page.lenses.insert(page.lenses.begin() + 1, {"other", {0.7, 0.1, 0, 0, 9}});
  const QStringList cells = textsOf(html(page), "td");
  QVERIFY(cells.contains("s0, s1 and 48 others"));
  QVERIFY(cells.contains("other"));
  QCOMPARE(cells.filter("one-to-one").size(), 2);
}

void TestReportPage::lists() {
  QCOMPARE(listed({"a"}), std::string("a"));
  QCOMPARE(listed({"a", "b"}), std::string("a and b"));
  QCOMPARE(listed({"a", "b", "c"}), std::string("a, b and c"));
  QCOMPARE(listed({"a", "b", "c", "d"}), std::string("a, b and 2 others"));
}

void TestReportPage::namesAreEscaped() {
  ReportPage page = pageOf({row("<b>&\"", 1)});
  page.session = "a<i>.json";
  page.lenses = {{"<b>", {}}};
  const std::string text = html(page);
  QVERIFY(contains(text, "&lt;b&gt;&amp;&quot;") && contains(text, "a&lt;i&gt;.json"));
  QVERIFY(!contains(text, "<b>") && !contains(text, "<i>"));
  // Bytes that are not UTF-8, characters that XML has not, those that turn the writing.
  page.session = "\xff\x1b\ufffe\u202e.json";
  const std::string odd = html(page);
  QCOMPARE(QString::fromStdString(odd).toStdString(), odd);
  QVERIFY(textsOf(odd, "h1")[0].contains("\\xff\\x1b\\ufffe\\u202e.json"));
}

QTEST_APPLESS_MAIN(TestReportPage)
#include "test_report_page.moc"
