// SPDX-License-Identifier: BSD-3-Clause
// Drives the report and camera set docks in the real window: makes reports, stops them, looks at
// their rows and images.
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStatusBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>

#include "chart/plot_painting.h"
#include "gui/docks/camera_set_widget.h"
#include "gui/docks/report_dock.h"
#include "gui/docks/report_results.h"
#include "gui/scene/vtk_widget.h"
#include "gui/view/image_widget.h"
#include "io/documents/session_file.h"
#include "tests/cli/csv.h"
#include "tests/gui/patience.h"
#include "tests/gui/window_files.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

using namespace hogelscope;

namespace {

constexpr int stateCount = 5;

float content(int x, int y, int channel) {
  return float((x * 5 + y * 3 + channel * 40 + (x / 16) * (y / 8)) % 200 + 20) / 255;
}

/// The worse the further to the right.
float noisy(int x, int y, int channel) {
  return content(x, y, channel) + float((x * 7919 + y * 104729 + channel) % (2 + x / 8)) / 255;
}

/// The last one stands behind the panel.
QByteArray session(const QByteArray& res, const QByteArray& sampling) {
  QByteArray cameras;
  for (int k = 0; k < stateCount; ++k)
    cameras += (k == 0 ? "" : ", ") + QByteArray("{\"name\": \"s") + QByteArray::number(k) +
               "\", \"eye\": [" + QByteArray::number(0.1 * k - 0.2) + ", 0, " +
               (k == stateCount - 1 ? "-0.7" : "0.7") + "], \"fov\": 45, \"res\": " + res + "}";
  return text({.display = R"({"hogels": [16, 16], "directions": [8, 8]})",
               .lightField = R"({"file": "a.png"})",
               .sampling = sampling,
               .cameras = "[" + cameras + "]"});
}

}  // namespace

class TestReportDock : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void cleanup() { m_window.reset(); }
  void makesAReport();
  void sorts();
  void namesStayWhenScrolledSideways();
  void aRowIsComparedInTheView();
  void theSceneIsTold();
  void plotsShowTheRows();
  void stopsAndGoesOn();
  void errors();
  void metricsOfPlugins();
  void unknownMetrics();
  void editsAreNoted();
  void unsavedEditsHaveAHeading();
  void anUntitledSessionHasAHeading();
  void aReportOfAnotherSessionIsNotTold();
  void progressQueuesNothing();
  void addsCameraSets();

 private:
  template <class T>
  T* child(const char* name) const {
    return m_window->findChild<T*>(name);
  }
  QString state(int row) const {
    return child<QTableView>("reportTable")->model()->headerData(row, Qt::Vertical).toString();
  }
  void click(const char* name) const {
    QTest::mouseClick(child<QPushButton>(name), Qt::LeftButton);
  }
  /// Of the page, with its command.
  static QString heading(const QString& folder) {
    const QString page = QString::fromUtf8(contentOf(folder + "/report.html"));
    const QString heading = page.section("<h1>", 1).section("</h1>", 0, 0);
    const QString title = page.section("<title>", 1).section("</title>", 0, 0);
    return title.contains(heading.section(" of ", 1)) ? heading : "no title";
  }
  QString cell(int row, int column) const {
    auto* table = child<QTableView>("reportTable");
    return table->model()->index(row, column).data().toString();
  }
  void open(const QByteArray& res = "[80, 60]", const QByteArray& sampling = "{}",
            const QByteArray& metrics = "[]");
  void make();

  std::unique_ptr<QTemporaryDir> m_folder;
  std::unique_ptr<MainWindow> m_window;
  ReportDock* m_dock = nullptr;
};

void TestReportDock::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
  writeImageFile("a.png", 128, 128, content);
  writeImageFile("b.png", 128, 128, noisy);
  writeImageFile("c.png", 128, 128, [](int x, int y, int c) { return noisy(y, x, c); });
  m_window = std::make_unique<MainWindow>();
  m_window->resize(1600, 1000);
  m_window->show();
  QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), patience));
  activate(m_window.get());
  m_dock = m_window->findChild<ReportDock*>();
}

void TestReportDock::open(const QByteArray& res, const QByteArray& sampling,
                          const QByteArray& metrics) {
  QByteArray document = session(res, sampling);
  document.replace("\"sampling\"", "\"metrics\": " + metrics + ", \"sampling\"");
  writeFile("s.json", document);
  QVERIFY(files(*m_window).open(m_folder->filePath("s.json")));
  QTest::keyClick(m_window.get(), Qt::Key_R, Qt::ControlModifier);
  QTRY_VERIFY_WITH_TIMEOUT(m_dock->isVisible(), patience);
}

void TestReportDock::make() {
  open();
  m_dock->addTest("b.png");
  m_dock->addTest("c.png");
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("reportNote")->text().contains("mean of the finite"),
                           patience);
}

void TestReportDock::makesAReport() {
  QVERIFY(!child<QPushButton>("makeReportButton")->isEnabled());  // nothing to compare yet
  make();
  QCOMPARE(child<QLineEdit>("reportFolder")->text(), m_folder->filePath("s-report"));
  for (const char* file : {"report.csv", "report.html", "summary.csv"})
    QVERIFY2(QFileInfo::exists(QString("s-report/") + file), file);
  const QList<QByteArray> lines = contentOf("s-report/report.csv").split('\n');
  const QList<QByteArray> more = contentOf("s-report/metrics.csv").split('\n');
  const qsizetype ssim = cellsOf(more[0]).indexOf("ssim_seen");
  QCOMPARE(child<QTableView>("reportTable")->model()->rowCount(), 2 * stateCount);
  for (int row = 0; row < 2 * stateCount; ++row) {
    const QStringList cells = cellsOf(lines[row + 1]);
    QCOMPARE(state(row), cells[0]);
    QCOMPARE(cell(row, 0), cells[1]);
    const bool isBlind = row / 2 == stateCount - 1;
    QCOMPARE(cell(row, 1), isBlind ? QString("sees nothing of the display")
                                   : QString::number(cells[5].toDouble(), 'f', 2));
    QCOMPARE(cell(row, 3), QString::number(100 * cells[7].toDouble(), 'f', 1));
    const double similarity = cellsOf(more[row + 1])[ssim].toDouble();
    QCOMPARE(cell(row, 4), isBlind ? QString("–") : QString::number(similarity, 'f', 4));
  }
  const QStringList note = child<QLabel>("reportNote")->text().split('\n');
  for (const int test : {0, 1}) {  // each its own mean
    double sum = 0;
    for (int row = test; row < 2 * (stateCount - 1); row += 2)
      sum += cellsOf(lines[row + 1])[5].toDouble();
    const qsizetype at = note.indexOf(cellsOf(lines[test + 1])[1]);
    QVERIFY2(at >= 0, qPrintable(note.join('\n')));
    const QString mean = QString::number(sum / (stateCount - 1), 'f', 2);
    QVERIFY2(note[at + 1].contains("  " + mean + " dB over what is seen"),
             qPrintable(note[at + 1]));
  }
  QVERIFY(child<QPushButton>("openPageButton")->isEnabled());
  m_window->grab().save(QCoreApplication::applicationDirPath() + "/report_dock.png");
}

void TestReportDock::sorts() {
  make();
  auto* header = child<QTableView>("reportTable")->horizontalHeader();
  const QPoint psnr(header->sectionViewportPosition(1) + 10, 5);
  QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, psnr);
  std::vector<double> up;
  for (int row = 2; row < 2 * stateCount; ++row) up.push_back(cell(row, 1).toDouble());
  QVERIFY(cell(0, 1).startsWith("sees nothing") && cell(1, 1).startsWith("sees nothing"));
  QCOMPARE(state(0), QString("s4"));  // the names go along
  QVERIFY(std::is_sorted(up.begin(), up.end()) && up.front() < up.back());
  QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, psnr);
  QCOMPARE(cell(0, 1).toDouble(), up.back());
  QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, psnr);  // as the report has them
  QCOMPARE(state(0), QString("s0"));
  QCOMPARE(state(2 * stateCount - 1), QString("s4"));
}

void TestReportDock::namesStayWhenScrolledSideways() {
  make();
  auto* table = child<QTableView>("reportTable");
  table->setFixedWidth(250);
  auto* names = table->verticalHeader();
  QVERIFY(names->isVisible() && names->width() >= table->fontMetrics().horizontalAdvance("s0"));
  auto* bar = table->horizontalScrollBar();
  QTRY_VERIFY_WITH_TIMEOUT(bar->maximum() > 0, patience);
  bar->setValue(bar->maximum());
  QVERIFY(table->columnViewportPosition(0) < 0);  // the columns have moved, the names have not
  QCOMPARE(names->mapTo(table, QPoint(0, 0)).x(), table->frameWidth());
  const QPoint third(5, names->sectionViewportPosition(6) + 5);
  QTest::mouseClick(names->viewport(), Qt::LeftButton, {}, third);
  QCOMPARE(child<QComboBox>("stateBox")->currentText(), QString("s3"));
}

/// In the view, where all ways to compare are; the state is the row's.
void TestReportDock::aRowIsComparedInTheView() {
  make();
  auto* table = child<QTableView>("reportTable");
  const auto* view = child<ImageWidget>("pictureView");
  const auto psnr = [&] {  // of the whole frame
    double sum = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 80; ++x) {
        const QColor a = view->image().pixelColor(x, y), b = view->otherImage().pixelColor(x, y);
        for (const int d : {a.red() - b.red(), a.green() - b.green(), a.blue() - b.blue()})
          sum += d * d;
      }
    return QString::number(10 * std::log10(255.0 * 255 * 3 * 60 * 80 / sum), 'f', 2);
  };
  for (const int row : {5, 2}) {  // s2 by c.png, s1 by b.png
    const QRect place = table->visualRect(table->model()->index(row, 0));
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, place.center());
    QCOMPARE(child<QComboBox>("stateBox")->currentText(), state(row));
    QTRY_VERIFY_WITH_TIMEOUT(!view->otherImage().isNull() && psnr() == cell(row, 2), patience);
  }
  child<QAction>("stopComparingAction")->trigger();
  child<QComboBox>("stateBox")->setCurrentIndex(3);  // not by the table: it compares nothing
  QTest::qWait(200);
  QVERIFY(view->otherImage().isNull());
  m_window->grab().save(QCoreApplication::applicationDirPath() + "/report_rows.png");
}

/// And a state that is chosen elsewhere is chosen here.
void TestReportDock::theSceneIsTold() {
  QSignalSpy told(m_dock, &ReportDock::psnrChanged);
  make();
  const QList<QByteArray> lines = contentOf("s-report/report.csv").split('\n');
  const auto psnrOf = [&](int state, int test) {
    return cellsOf(lines[1 + 2 * state + test])[5].toDouble();  // psnr_seen
  };
  const auto last = [&] { return told.last()[0].value<std::vector<double>>(); };
  QCOMPARE(last().size(), std::size_t(stateCount));
  QCOMPARE(last()[1], psnrOf(1, 0));
  QVERIFY(std::isnan(last()[stateCount - 1]));
  auto* table = child<QTableView>("reportTable");
  table->selectRow(3);  // s1, c.png
  QCOMPARE(last()[1], psnrOf(1, 1));
  child<QComboBox>("stateBox")->setCurrentIndex(3);
  QCOMPARE(table->currentIndex().row(), 7);
  QVERIFY(files(*m_window).open(m_folder->filePath("s.json")));
  QVERIFY(last().empty());
  QCOMPARE(table->model()->rowCount(), 0);
}

/// A point of each row that compares something, where its PSNR says; a click chooses the row.
void TestReportDock::plotsShowTheRows() {
  make();
  const QList<QByteArray> lines = contentOf("s-report/report.csv").split('\n');
  const auto psnrOf = [&](std::size_t row) { return cellsOf(lines[1 + int(row)])[5].toDouble(); };
  auto* plot = child<ReportPlotView>("reportPlot");
  auto* table = child<QTableView>("reportTable");
  QTRY_VERIFY_WITH_TIMEOUT(plot->width() > 200 && plot->height() > 100, patience);
  const auto placeOf = [plot](std::size_t row) {
    return hogelscope::placeOf(plot->plot(), row, QSizeF(plot->size()));
  };
  QVERIFY(!placeOf(2 * stateCount - 1));  // it is behind the panel
  for (const std::size_t a : {0U, 1U, 2U, 5U})
    for (const std::size_t b : {0U, 3U, 4U, 7U}) {
      QCOMPARE(placeOf(a)->y() < placeOf(b)->y(), psnrOf(a) > psnrOf(b));
      QCOMPARE(placeOf(a)->x() < placeOf(b)->x(), a / 2 < b / 2);
    }
  const QColor second("#d55e00");
  const auto colourAt = [plot](const QPointF& place) {
    return plot->grab().toImage().pixelColor(place.toPoint());
  };
  QCOMPARE(colourAt(*placeOf(5)), second);
  QTest::mousePress(plot, Qt::RightButton, {}, placeOf(5)->toPoint());  // it has a menu
  QVERIFY(table->currentIndex().row() != 5);
  QTest::mouseClick(plot, Qt::LeftButton, {}, placeOf(5)->toPoint());
  QCOMPARE(table->currentIndex().row(), 5);
  QCOMPARE(child<QComboBox>("stateBox")->currentIndex(), 2);

  auto* kind = child<QComboBox>("reportPlotKind");
  const double byStates = placeOf(4)->x() - placeOf(2)->x();
  kind->setCurrentIndex(1);
  // s1 … s3 are at x = -0.1, 0, 0.1 of z = 0.7: even steps, and s0 a little nearer to s1.
  QVERIFY(std::abs(placeOf(6)->x() + placeOf(2)->x() - 2 * placeOf(4)->x()) < 1);
  QVERIFY(placeOf(2)->x() - placeOf(0)->x() < placeOf(4)->x() - placeOf(2)->x());
  QVERIFY(std::abs(placeOf(4)->x() - placeOf(2)->x() - byStates) > 1);

  kind->setCurrentIndex(2);
  QCOMPARE(plot->picture().toImage(), QImage("s-report/panel_error/test2_hogels.png")
                                          .convertToFormat(plot->picture().toImage().format()));
  table->selectRow(4);
  QCOMPARE(plot->picture().toImage(), QImage("s-report/panel_error/test1_hogels.png")
                                          .convertToFormat(plot->picture().toImage().format()));
  kind->setCurrentIndex(3);
  QCOMPARE(plot->picture().size(), QImage("s-report/panel_error/test1_directions.png").size());
}

void TestReportDock::stopsAndGoesOn() {
  open("[800, 600]", R"({"samplesPerPixel": 5})");
  m_dock->addTest("b.png");
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(!cell(0, 1).isEmpty(), patience);
  QCOMPARE(child<QPushButton>("makeReportButton")->text(), QString("&Stop"));
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("reportNote")->text().startsWith("Stopped"), patience);
  QVERIFY(QFileInfo::exists("s-report/report.journal"));
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("reportNote")->text().contains("mean of the finite"),
                           patience);
  QVERIFY(!QFileInfo::exists("s-report/report.journal"));
}

void TestReportDock::errors() {
  writeGrey("small.png", 8, 8);
  open();
  // The image's line would take the place of the error's.
  QTRY_VERIFY_WITH_TIMEOUT(m_window->statusBar()->currentMessage().contains(" ms"), patience);
  m_dock->addTest("small.png");
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(
      child<QLabel>("reportNote")->text().contains("small.png: size: is 8×8 px"), patience);
  click("removeTestButton");
  QCOMPARE(child<QListWidget>("testList")->count(), 0);
  QVERIFY(!child<QPushButton>("makeReportButton")->isEnabled());
}

/// A column of the table after the standard ones, which another session's report does not have.
void TestReportDock::metricsOfPlugins() {
  open("[180, 170]", "{}", "[\"ms-ssim\"]");
  m_dock->addTest("b.png");
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("reportNote")->text().contains("mean of the finite"),
                           patience);
  auto* model = child<QTableView>("reportTable")->model();
  QCOMPARE(model->columnCount(), 6);
  QCOMPARE(model->headerData(5, Qt::Horizontal).toString(), QString("MS\u2011SSIM"));
  const QList<QByteArray> lines = contentOf("s-report/metrics.csv").split('\n');
  const qsizetype column = cellsOf(lines[0]).indexOf("ms_ssim");
  for (int row = 0; row + 1 < stateCount; ++row) {
    const double figure = cellsOf(lines[row + 1]).value(column).toDouble();
    QVERIFY(figure > 0.1 && figure < 1);
    QCOMPARE(cell(row, 5), QString::number(figure, 'f', 4));
  }
  m_window->findChild<QWidget*>("cameraArea")->findChild<QDoubleSpinBox*>("eye.0")->setValue(0.05);
  QVERIFY(child<QLabel>("reportStale")->isVisible());
  QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(!child<QLabel>("reportStale")->isVisible());  // the session is whole again, metrics too
  writeFile("t.json", session("[80, 60]", "{}"));
  QVERIFY(files(*m_window).open(m_folder->filePath("t.json")));
  QCOMPARE(model->columnCount(), 5);
}

void TestReportDock::unknownMetrics() {
  open("[80, 60]", "{}", "[\"ms-sim\"]");
  QTRY_VERIFY_WITH_TIMEOUT(m_window->statusBar()->currentMessage().contains(" ms"), patience);
  m_dock->addTest("b.png");
  click("makeReportButton");
  QCOMPARE(child<QLabel>("reportNote")->text(),
           QString("plugin ms-sim: is not installed; did you mean ms-ssim?"));
  QCOMPARE(child<QPushButton>("makeReportButton")->text(), QString("&Make report"));
  QVERIFY(!QFileInfo::exists("s-report"));
}

void TestReportDock::editsAreNoted() {
  make();
  m_window->findChild<QWidget*>("cameraArea")->findChild<QDoubleSpinBox*>("eye.0")->setValue(0.05);
  auto* stale = child<QLabel>("reportStale");
  QVERIFY(stale->isVisible() && stale->text().contains("edited"));
  QVERIFY(child<QLabel>("reportNote")->text().contains("mean of the finite"));
  QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);  // as it was
  QVERIFY(!stale->isVisible());
  QCOMPARE(child<QTableView>("reportTable")->model()->rowCount(), 2 * stateCount);
  QTest::keyClick(m_window.get(), Qt::Key_D, Qt::ControlModifier);  // duplicate
  QCOMPARE(child<QTableView>("reportTable")->model()->rowCount(), 0);
}

void TestReportDock::unsavedEditsHaveAHeading() {
  QVERIFY(!child<QPushButton>("openPageButton")->isEnabled());  // there is no page
  open();
  QVERIFY(!child<QPushButton>("openPageButton")->isEnabled());
  m_window->findChild<QWidget*>("cameraArea")->findChild<QDoubleSpinBox*>("eye.0")->setValue(0.05);
  m_dock->addTest("b.png");
  click("makeReportButton");
  QVERIFY(!child<QPushButton>("openPageButton")->isEnabled());
  QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("openPageButton")->isEnabled(), patience);
  const QString name = m_folder->filePath("s.json") + " with unsaved changes";
  QCOMPARE(heading("s-report"), "Perceived views of " + name);
  QVERIFY(contentOf("s-report/report.html")
              .contains(("made in the window, from " + name + "<").toUtf8()));
  QVERIFY(files(*m_window).save(m_folder->filePath("s.json")));
  child<QPushButton>("openPageButton")->setEnabled(false);
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("openPageButton")->isEnabled(), patience);
  QCOMPARE(heading("s-report"), "Perceived views of " + m_folder->filePath("s.json"));
  QVERIFY(contentOf("s-report/report.html").contains("s.json, XXH3-128 "));
}

void TestReportDock::anUntitledSessionHasAHeading() {
  const QString quilt = m_folder->filePath("q_qs2x2a1.png");
  writeImageFile(quilt, 40, 40, [](int x, int y, int) { return float(x + y) / 80; });
  writeImageFile("t_qs2x2a1.png", 40, 40, [](int x, int y, int) { return float(x + 2 * y) / 120; });
  QVERIFY(files(*m_window).open(quilt));
  QTRY_COMPARE_WITH_TIMEOUT(child<QLineEdit>("reportFolder")->text(),
                            m_folder->filePath("q_qs2x2a1-report"), patience);  // it is looked at
  QTest::keyClick(m_window.get(), Qt::Key_R, Qt::ControlModifier);
  m_dock->addTest("t_qs2x2a1.png");
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("openPageButton")->isEnabled(), patience);
  QCOMPARE(heading("q_qs2x2a1-report"), QString("Perceived views of an untitled session"));
  QVERIFY(contentOf("q_qs2x2a1-report/report.html")
              .contains("made in the window, from an untitled session<"));
}

/// Neither what it found nor its page, where it ends while another session is opened.
void TestReportDock::aReportOfAnotherSessionIsNotTold() {
  open();
  m_dock->addTest("b.png");
  click("makeReportButton");
  QVERIFY(sleepUntil([] { return QFileInfo::exists("s-report/report.html"); }));
  QTest::qSleep(300);  // its end waits in the queue
  writeFile("s2.json", contentOf("s.json"));
  QVERIFY(files(*m_window).open(m_folder->filePath("s2.json")));
  QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("makeReportButton")->text().contains("Make"),
                           patience);
  QCOMPARE(child<QLabel>("reportNote")->text(), QString());
  QVERIFY(!child<QPushButton>("openPageButton")->isEnabled());
}

/// What is done while the window is busy is not painted step by step after it.
void TestReportDock::progressQueuesNothing() {
  open();
  m_dock->addTest("b.png");
  auto* bar = child<QProgressBar>("reportProgress");
  QSignalSpy moved(bar, &QProgressBar::valueChanged);
  click("makeReportButton");
  QVERIFY(bar->isVisible());
  moved.clear();
  QVERIFY(sleepUntil([] { return QFileInfo::exists("s-report/report.html"); }));
  QTRY_VERIFY_WITH_TIMEOUT(child<QPushButton>("openPageButton")->isEnabled(), patience);
  QVERIFY(!bar->isVisible());
  QVERIFY2(moved.count() <= 2, qPrintable(QString::number(moved.count())));
}

void TestReportDock::addsCameraSets() {
  open();
  QTest::keyClick(m_window.get(), Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
  auto* sets = m_window->findChild<CameraSetWidget*>();
  QTRY_VERIFY_WITH_TIMEOUT(sets->isVisible(), patience);
  sets->findChild<QSpinBox*>("count")->setValue(7);
  auto* states = child<QComboBox>("stateBox");
  click("addSetButton");
  QCOMPARE(states->count(), stateCount + 7);
  writeFile("t.csv", "time,x,y,z\n0,0,0,0.6\n10,0.2,0,0.6\n");
  QVERIFY(sets->addFromFile("t.csv"));
  QVERIFY(states->count() > stateCount + 7);
  const int before = states->count();
  writeFile("t.csv", "time,x\n");
  QVERIFY(!sets->addFromFile("t.csv"));
  QVERIFY(m_window->statusBar()->currentMessage().contains("t.csv"));
  QCOMPARE(states->count(), before);
  m_window->grab().save(QCoreApplication::applicationDirPath() + "/camera_set_dock.png");
}

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  TestReportDock test;
  return QTest::qExec(&test, argc, argv);
}
#include "test_report_dock.moc"
