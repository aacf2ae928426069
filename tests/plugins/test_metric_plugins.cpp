// SPDX-License-Identifier: BSD-3-Clause
// Tests metrics of plugins in a report: the real program with MS-SSIM, in every file of a report.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <numeric>

#include "core/engine/renderer.h"
#include "core/optics/viewing.h"
#include "io/documents/session_file.h"
#include "io/opening/session_around.h"
#include "io/plugins/metric_plugins.h"
#include "io/plugins/plugin_library.h"
#include "io/scene/view_source.h"
#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"
#include "tests/plugins/plugin_files.h"

using namespace hogelscope;

namespace {

/// The column of this name.
QStringList columnOf(const QString& file, const QString& name) {
  QList<QByteArray> lines = contentOf(file).trimmed().split('\n');
  const qsizetype column = cellsOf(lines.takeFirst()).indexOf(name);
  QStringList cells;
  for (const QByteArray& line : lines) cells << cellsOf(line).value(column);
  return cells;
}

Outcome report(const QStringList& more, const QString& folder) {
  return run(QStringList{"--report", "--session", sampleSession, "--states", "Fig [123]", "--test",
                         "dark.png", "--set", "camera.res=[200,170]"} +
                 more,
             folder);
}

const QString msSsim = "metrics=[\"ms-ssim\"]";

}  // namespace

class TestMetricPlugins : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void columnsOfTheSet();
  void inEveryFile();
  void bothFigures();
  void areTold_data();
  void areTold();
  void withoutMemoryAReportGoesOn();
  void exitIsNoEnd();
  void aReportGoesOn();
  void anotherMetricIsAnotherReport();
  void inSessions();
  void badNames_data();
  void badNames();

 private:
  [[nodiscard]] QString path(const QString& name) const { return m_folder.path() + "/" + name; }

  QTemporaryDir m_folder;
};

/// The sample light field with noise, a bit darker.
void TestMetricPlugins::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  const QString source = HOGELSCOPE_SOURCE_DIR "/tests/data/scene.png";
  const QSize size = sizeOf(source);
  const std::vector<std::uint8_t> values = bytesOf(source);
  writeImageFile("dark.png", size.width(), size.height(), [&](int x, int y, int c) {
    const auto at = std::size_t(y) * std::size_t(size.width()) + std::size_t(x);
    return (0.8F * float(values[3 * at + std::size_t(c)]) + float((x * 7 + y * 11) % 40)) / 255;
  });
}

void TestMetricPlugins::columnsOfTheSet() {
  const MetricSet metrics = metricsOf({"ms-ssim"});
  const MetricSet standard;
  QCOMPARE(metrics.columns().size(), standard.columns().size() + 1);
  const MetricColumn& column = metrics.columns().back();
  QCOMPARE(column.name, std::string("ms_ssim"));
  QCOMPARE(column.title, std::string("MS\u2011SSIM"));
  QCOMPARE(column.decimals, 4);
  QVERIFY(column.where == MetricColumn::Where::window);
  QCOMPARE(metrics.means().back().name, std::string("mean_ms_ssim"));
  QVERIFY(metrics.means().back().isQuality);  // bd.csv has it
  QCOMPARE(metrics.means().back().column, metrics.columns().size() - 1);
  QCOMPARE(metricsOf({}).columns().size(), standard.columns().size());
  const MetricSet flip = metricsOf({"flip"});
  QCOMPARE(flip.columns()[standard.columns().size()].name, std::string("flip"));
  QCOMPARE(flip.columns().back().name, std::string("flip_seen"));
  QCOMPARE(flip.means().back().name, std::string("mean_flip_seen"));
  QVERIFY(flip.means().back().isSeen && flip.isHeadline(flip.means().size() - 1));
  QVERIFY(!flip.isHeadline(flip.means().size() - 2));
  QCOMPARE(errorOf([] { (void)metricsOf({"example"}); }),
           "plugin example: has no metric; its plugin.json says what it has");
}

/// The figures are the plugin's own for the pictures on the disk; all other columns are as without.
void TestMetricPlugins::inEveryFile() {
  const Outcome plain = report({"--output", "plain"}, m_folder.path());
  QVERIFY2(plain.status == 0, plain.err);
  const Outcome with = report({"--output", "with", "--images", "--set", msSsim}, m_folder.path());
  QVERIFY2(with.status == 0, with.err);
  QCOMPARE(contentOf("with/report.csv"), contentOf("plain/report.csv"));
  QCOMPARE(columnOf("with/metrics.csv", "psnr_y"), columnOf("plain/metrics.csv", "psnr_y"));
  const auto metric = loadPlugin("ms-ssim", PluginKind::metric).makeMetric();
  const QStringList figures = columnOf("with/metrics.csv", "ms_ssim");
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const QString name = QString("/Fig %1.png").arg(k + 1);
    const auto reference = bytesOf("with/reference" + name);
    const auto test = bytesOf("with/test1" + name);
    const double figure =
        metric->compare({200, 170, reference, {}, {}}, {200, 170, test, {}, {}}, {});
    QVERIFY(figure > 0.5 && figure < 0.99999);
    QVERIFY2(says(figures.value(k), figure), qPrintable(figures.value(k)));
    sum += figure;
  }
  const qsizetype row = columnOf("with/summary.csv", "figure").indexOf("mean_ms_ssim");
  const double mean = columnOf("with/summary.csv", "value").value(row).toDouble();
  QVERIFY2(std::abs(mean - sum / 3) < 1e-9, qPrintable(QString::number(mean)));
  const QByteArray page = contentOf("with/report.html");
  QVERIFY(page.contains("MS\u2011SSIM") && page.contains("mean MS\u2011SSIM"));
  QVERIFY(!contentOf("plain/report.html").contains("MS\u2011SSIM"));
  QVERIFY(!contentOf("plain/metrics.csv").contains("ms_ssim"));
}

/// FLIP of a report, over the frame and over what is seen, is the plugin's own with the state's
/// pixels per degree.
void TestMetricPlugins::bothFigures() {
  const Outcome made =
      report({"--output", "flip", "--images", "--set", "metrics=[\"flip\"]"}, m_folder.path());
  QVERIFY2(made.status == 0, made.err);
  const Session session = loadSession(sampleSession.toStdString(), {"camera.res=[200,170]"});
  const ViewSource scene = loadViewSource(session, {});
  const auto metric = loadPlugin("flip", PluginKind::metric).makeMetric();
  for (int k = 0; k < 3; ++k) {
    const QString name = QString("/Fig %1.png").arg(k + 1);
    const auto reference = bytesOf("flip/reference" + name);
    const auto test = bytesOf("flip/test1" + name);
    const CameraState& state = session.cameras[std::size_t(k)];
    const Viewing viewing = viewingOf(state, scene.display, session.sampling.mapping);
    Renderer renderer;
    const std::vector<std::uint8_t> seen = renderer.render(scene.job(state)).seen;
    const plugin::Figures figures =
        metric->compareBoth({200, 170, reference, {}, seen}, {200, 170, test, {}, seen},
                            {viewing.pixelsPerDegree, viewing.distance});
    QVERIFY(figures.frame > 0.001 && figures.seen > figures.frame);
    QVERIFY(says(columnOf("flip/metrics.csv", "flip").value(k), figures.frame));
    QVERIFY(says(columnOf("flip/metrics.csv", "flip_seen").value(k), figures.seen));
  }
}

void TestMetricPlugins::areTold_data() {
  QTest::addColumn<QStringList>("options");
  QTest::newRow("in memory") << QStringList();
  QTest::newRow("read from the top") << QStringList{"--memory", "2"};
}

/// The figures of metrics that return what they are told.
void TestMetricPlugins::areTold() {
  QFETCH(QStringList, options);
  const QStringList names{"pixels", "distance", "reference", "difference"};
  for (const QString& name : names) {
    const QString library = QString(HOGELSCOPE_WRONG_PLUGINS "/%1.so").arg(name);
    writePlugin(path("p/" + name), contentOf(library),
                {{"name", "\"" + name.toUtf8() + "\""}, {"kinds", "[\"metric\"]"}});
  }
  options << "--set"
          << "metrics=[\"" + names.join("\",\"") + "\"]";
  const Outcome told =
      report(QStringList{"--output", "told", "--plugins-path", "p"} + options, m_folder.path());
  QVERIFY2(told.status == 0, told.err);
  std::vector<std::string> changes{"camera.res=[200,170]"};
  if (options.contains("--memory")) QVERIFY2(told.err.contains("read from the top"), told.err);
  const Session session = loadSession(sampleSession.toStdString(), changes);
  const ViewSource scene = loadViewSource(session, {});
  const ViewSource dark = loadViewSource(withLightField(session, "dark.png"), {});
  const auto meanOf = [](const FloatImage& image) {
    return std::accumulate(image.rgb.begin(), image.rgb.end(), 0.0) / double(image.rgb.size());
  };
  Renderer renderer;
  for (int k = 0; k < 3; ++k) {
    const CameraState& state = session.cameras[std::size_t(k)];
    const Viewing viewing = viewingOf(state, scene.display, scene.sampling.mapping);
    const double reference = meanOf(renderer.renderFloat(scene.job(state)));
    const double test = meanOf(renderer.renderFloat(dark.job(state)));
    QVERIFY(std::abs(reference - test) > 1);
    const std::vector<double> expected{viewing.pixelsPerDegree, viewing.distance, reference,
                                       reference - test};
    for (qsizetype column = 0; column < names.size(); ++column) {
      const QString cell = columnOf("told/metrics.csv", names[column]).value(k);
      QVERIFY2(says(cell, expected[std::size_t(column)]), qPrintable(names[column] + cell));
    }
  }
}

/// Its figures are not known, which the rows say.
void TestMetricPlugins::withoutMemoryAReportGoesOn() {
  writePlugin(path("p/hungry"), contentOf(HOGELSCOPE_WRONG_PLUGINS "/hungry.so"),
              {{"name", "\"hungry\""}, {"kinds", "[\"metric\"]"}});
  const Outcome made =
      report({"--output", "hungry", "--plugins-path", "p", "--set", "metrics=[\"hungry\"]"},
             m_folder.path());
  QVERIFY2(made.status == 0, made.err);
  const QString problem = "not enough memory to compare its pictures";
  QCOMPARE(columnOf("hungry/metrics.csv", "problem"), QStringList({problem, problem, problem}));
}

/// A plugin that ends the program with 0 has not made the report.
void TestMetricPlugins::exitIsNoEnd() {
  writePlugin(path("p/exits"), contentOf(HOGELSCOPE_WRONG_PLUGINS "/exits.so"),
              {{"name", "\"exits\""}, {"kinds", "[\"metric\"]"}});
  const Outcome ended =
      report({"--output", "exits", "--plugins-path", "p", "--set", "metrics=[\"exits\"]"},
             m_folder.path());
  QCOMPARE(ended.status, 3);
  QVERIFY2(ended.err.endsWith("hogelscope: internal error: a plugin or a library ended the program "
                              "before the job's end\n"),
           ended.err);
  QVERIFY(!QFile::exists("exits/report.html"));
}

/// A journal of the same request is taken up; one of other metrics is not.
void TestMetricPlugins::aReportGoesOn() {
  // The page cannot replace a folder, so the run fails after its last row.
  QVERIFY(QDir().mkpath("half/report.html"));
  QCOMPARE(report({"--output", "half", "--set", msSsim}, m_folder.path()).status, 2);
  QVERIFY(QFileInfo::exists("half/report.journal"));
  QVERIFY(QDir().rmdir("half/report.html"));
  QVERIFY(QDir().mkpath("other"));
  QVERIFY(QFile::copy("half/report.journal", "other/report.journal"));
  const Outcome same = report({"--output", "half", "--set", msSsim}, m_folder.path());
  QVERIFY2(same.err.contains("went on after 3 views"), same.err);
  QCOMPARE(contentOf("half/metrics.csv"), contentOf("with/metrics.csv"));
}

void TestMetricPlugins::anotherMetricIsAnotherReport() {
  const Outcome other = report({"--output", "other"}, m_folder.path());
  QVERIFY2(other.err.contains("was of another report"), other.err);
  QCOMPARE(contentOf("other/metrics.csv"), contentOf("plain/metrics.csv"));
}

void TestMetricPlugins::inSessions() {
  const Session plain = loadSession(sampleSession.toStdString());
  QVERIFY(plain.metrics.empty());
  QVERIFY(!QString::fromStdString(textOf(plain)).contains("metrics"));
  const Session with = loadSession(sampleSession.toStdString(), {msSsim.toStdString()});
  QCOMPARE(with.metrics, std::vector<std::string>{"ms-ssim"});
  QVERIFY(with != plain);
  QVERIFY(QString::fromStdString(textOf(with)).contains("\n  \"metrics\": [\"ms-ssim\"],\n"));
  saveSession("saved.json", with);
  QCOMPARE(loadSession("saved.json").metrics, with.metrics);
  QVERIFY(loadSession("saved.json", {"metrics=[]"}).metrics.empty());
  QCOMPARE(loadStates("saved.json").size(), with.cameras.size());
  appendStates("saved.json", {plain.cameras[0]});
  QCOMPARE(loadSession("saved.json").metrics, with.metrics);
}

void TestMetricPlugins::badNames_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<QByteArray>("line");
  const QByteArray list = "metrics: is not a list of plugins' names: [\"ms-ssim\"]";
  const QByteArray name = " is not a plugin's name: small letters, digits and \"-\"";
  QTest::newRow("a text") << "ms-ssim" << list;
  QTest::newRow("an object") << "{\"a\":1}" << list;
  QTest::newRow("numbers") << "[1]" << list;
  QTest::newRow("a path") << "[\"../ms-ssim\"]"
                          << "metrics[0]: \"../ms-ssim\"" + name;
  QTest::newRow("empty") << "[\"ms-ssim\",\"\"]"
                         << "metrics[1]: \"\"" + name;
  QTest::newRow("twice") << "[\"ms-ssim\",\"ms-ssim\"]"
                         << QByteArray("metrics[1]: \"ms-ssim\" stands twice in the list");
  QTest::newRow("mistyped") << "[\"ms-sim\"]"
                            << QByteArray("plugin ms-sim: is not installed; did you mean ms-ssim?");
  QTest::newRow("another kind")
      << "[\"example\"]"
      << QByteArray("plugin example: has no metric; its plugin.json says what it has");
}

void TestMetricPlugins::badNames() {
  QFETCH(QString, text);
  QFETCH(QByteArray, line);
  const Outcome outcome = report({"--output", "bad", "--set", "metrics=" + text}, m_folder.path());
  QCOMPARE(outcome.err, "hogelscope: " + sampleSession.toUtf8() + ": " + line + "\n");
  QCOMPARE(outcome.status, 2);
  QVERIFY(!QFileInfo::exists("bad"));
}

QTEST_GUILESS_MAIN(TestMetricPlugins)
#include "test_metric_plugins.moc"
