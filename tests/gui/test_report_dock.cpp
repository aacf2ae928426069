// SPDX-License-Identifier: BSD-3-Clause
// Drives the report and camera set docks in the real window: makes reports, stops them, reads them
// again, looks at their tables, plots and images.
#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDirIterator>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStatusBar>
#include <QTableView>
#include <QTemporaryDir>
#include <QToolButton>
#include <QUndoStack>
#include <QtTest>
#include <cmath>

#include "chart/plot_painting.h"
#include "gui/docks/camera_set_widget.h"
#include "gui/docks/report_dock.h"
#include "gui/docks/report_plots.h"
#include "gui/scene/vtk_widget.h"
#include "gui/session/session_model.h"
#include "gui/view/image_widget.h"
#include "gui/widgets/colours.h"
#include "io/documents/session_file.h"
#include "report/page/test_names.h"
#include "report/report_facts.h"
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
  void statesSayWhy();
  void sorts();
  void filters();
  void copiesTables();
  void worstAndBest();
  void aRowIsComparedInTheView();
  void theSceneIsTold();
  void bothEyesHaveARow();
  void plotsShowTheRows();
  void meansAndEyes();
  void namesAreShort();
  void picturesOfTheChosenState();
  void opensAReport();
  void aReportMovesWithItsTests();
  void namesOfLinksAndFolders();
  void opensAReportOfOtherStates();
  void whatIsNoReport();
  void narrowDocks();
  void stopsAndGoesOn();
  void errors();
  void metricsOfPlugins();
  void metricsAreChosen();
  void aSecondReportIsSortedToo();
  void unknownMetrics();
  void editsAreNoted();
  void unsavedEditsHaveAHeading();
  void anUntitledSessionHasAHeading();
  void aReportOfAnotherSessionIsNotTold();
  void progressQueuesNothing();
  void addsCameraSets();

 private:
  void theFiguresOfEditedStatesAreStale(const QSignalSpy& told);
  template <class T>
  T* child(const char* name) const {
    return m_window->findChild<T*>(name);
  }
  QString state(int row) const { return cell(row, StateTable::name); }
  void click(const char* name) const {
    QTest::mouseClick(child<QAbstractButton>(name), Qt::LeftButton);
  }
  void chooseTest(int test) const { child<QTableView>("testTable")->selectRow(test); }
  QString testCell(int row, int column) const {
    return child<QTableView>("testTable")->model()->index(row, column).data().toString();
  }
  /// The row that shows a state.
  int rowOf(const QString& name) const {
    for (int row = 0; row < child<QTableView>("reportTable")->model()->rowCount(); ++row)
      if (state(row) == name) return row;
    return -1;
  }
  QStringList states() const {
    QStringList names;
    for (int row = 0; row < child<QTableView>("reportTable")->model()->rowCount(); ++row)
      names << state(row);
    return names;
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
  /// Opens the session again.
  void forgetReport() { QVERIFY(files(*m_window).open(m_folder->filePath("s.json"))); }
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
  QCOMPARE(child<QTableView>("testTable")->model()->rowCount(), 2);
  for (const int test : {0, 1}) {  // each its own figures
    chooseTest(test);
    QCOMPARE(child<QTableView>("reportTable")->model()->rowCount(), stateCount);
    double sum = 0, low = 1000, high = 0;
    for (int k = 0; k < stateCount; ++k) {
      const int line = 2 * k + test;
      const QStringList cells = cellsOf(lines[line + 1]);
      const int row = rowOf(cells[0]);
      QVERIFY(row >= 0);
      const bool isBlind = k == stateCount - 1;
      QCOMPARE(cell(row, StateTable::psnr), isBlind ? QString("sees nothing of the display")
                                                    : QString::number(cells[5].toDouble(), 'f', 2));
      const double similarity = cellsOf(more[line + 1])[ssim].toDouble();
      QCOMPARE(cell(row, StateTable::ssim),
               isBlind ? QString("–") : QString::number(similarity, 'f', 4));
      if (isBlind) continue;
      QCOMPARE(cell(row, StateTable::seen), QString::number(100 * cells[7].toDouble(), 'f', 1));
      sum += cells[5].toDouble();
      low = std::min(low, cells[5].toDouble());
      high = std::max(high, cells[5].toDouble());
    }
    QCOMPARE(testCell(test, TestTable::name), test == 0 ? QString("b.png") : QString("c.png"));
    QCOMPARE(testCell(test, TestTable::psnr), QString::number(sum / (stateCount - 1), 'f', 2));
    QVERIFY(testCell(test, TestTable::worst).endsWith("  " + QString::number(low, 'f', 1)));
    QVERIFY(testCell(test, TestTable::best).endsWith("  " + QString::number(high, 'f', 1)));
    const double bits = 8.0 * double(QFileInfo(testCell(test, TestTable::name)).size());
    QCOMPARE(testCell(test, TestTable::rate), QString::number(bits / (128 * 128), 'f', 2));
  }
  QVERIFY(child<QAbstractButton>("openPageButton")->isEnabled());
  m_window->grab().save(QCoreApplication::applicationDirPath() + "/report_dock.png");
}

/// The figures that explain a PSNR, and those that differ from most states' in orange.
void TestReportDock::statesSayWhy() {
  open();
  m_dock->addTest("b.png");
  auto* model = m_window->findChild<SessionModel*>();
  model->edit("one is odd", [](Session& edited) {
    for (CameraState& camera : edited.cameras) camera.psf = {0.67, 5};
    edited.cameras[1].psf = {0.41, 1};
    edited.cameras[2].distortion.k1 = 0.1;
    edited.cameras[3].camera.eye = {0.3, 0.3, 0.5};
  });
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("reportNote")->text().contains("mean of the finite"),
                           patience);
  const auto textOf = [this](const char* name, StateTable::Column column) {
    return cell(rowOf(name), column);
  };
  QCOMPARE(textOf("s0", StateTable::sigma), QString("0.67"));
  QCOMPARE(textOf("s1", StateTable::sigma), QString("0.41"));
  QCOMPARE(textOf("s1", StateTable::window), QString("1"));
  QCOMPARE(textOf("s0", StateTable::lens), QString("–"));
  QCOMPARE(textOf("s2", StateTable::lens), QString("yes"));
  QCOMPARE(textOf("s1", StateTable::distance), QString::number(std::sqrt(0.01 + 0.49), 'f', 3));
  QCOMPARE(textOf("s1", StateTable::angle), QString("8.1"));  // atan(1 / 7)
  QCOMPARE(textOf("s3", StateTable::angle), QString("40.3"));
  QCOMPARE(textOf("s4", StateTable::angle), QString("164.1"));  // behind the panel
  const auto isOrange = [this](const char* name, StateTable::Column column) {
    const QModelIndex index = child<QTableView>("reportTable")->model()->index(rowOf(name), column);
    return index.data(Qt::ForegroundRole).value<QBrush>().color() == tokens().eye;
  };
  for (const auto column : {StateTable::sigma, StateTable::window}) {
    QVERIFY(isOrange("s1", column));
    for (const char* name : {"s0", "s2", "s3", "s4"}) QVERIFY(!isOrange(name, column));
  }
}

/// From the worst; a click reverses, the third restores the order of the session.
void TestReportDock::sorts() {
  make();
  auto* header = child<QTableView>("reportTable")->horizontalHeader();
  const QPoint psnr(header->sectionViewportPosition(StateTable::psnr) + 10, 5);
  std::vector<double> up;
  for (int row = 1; row < stateCount; ++row) up.push_back(cell(row, StateTable::psnr).toDouble());
  QVERIFY(cell(0, StateTable::psnr).startsWith("sees nothing"));
  QCOMPARE(state(0), QString("s4"));  // the names go along
  QVERIFY(std::is_sorted(up.begin(), up.end()) && up.front() < up.back());
  QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, psnr);
  QCOMPARE(cell(0, StateTable::psnr).toDouble(), up.back());
  QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, psnr);  // as the session has them
  QCOMPARE(states(), QStringList({"s0", "s1", "s2", "s3", "s4"}));
  chooseTest(1);
  QCOMPARE(states(), QStringList({"s0", "s1", "s2", "s3", "s4"}));  // also of the other test
}

void TestReportDock::filters() {
  make();
  auto* filter = child<QLineEdit>("reportFilter");
  filter->setText("angle < 12");  // of s1 to s3, 0.1 m and 0 beside the middle in 0.7 m
  QStringList shown = states();
  shown.sort();
  QCOMPARE(shown, QStringList({"s1", "s2", "s3"}));
  filter->setText("angle<12, s3");
  QCOMPARE(states(), QStringList({"s3"}));
  filter->setText("psnr > 0");
  QVERIFY(!states().contains("s4"));  // it has none
  chooseTest(1);
  QVERIFY(!states().contains("s4") && states().size() == stateCount - 1);
  filter->clear();
  QCOMPARE(states().size(), stateCount);
}

/// As CSV, in the order of columns and rows that is shown.
void TestReportDock::copiesTables() {
  make();
  auto* table = child<QTableView>("reportTable");
  const auto copied = [] { return QApplication::clipboard()->text().split('\n'); };
  const auto pressCopy = [](QWidget* widget) {
    widget->setFocus();
    QTest::keyClick(widget, Qt::Key_C, Qt::ControlModifier);
  };
  table->clearSelection();
  pressCopy(table);
  QCOMPARE(copied().size(), stateCount + 2);  // a header, and the end of the last line
  QCOMPARE(cellsOf(copied()[0].toUtf8()),
           QStringList({"State", "PSNR, dB", "SSIM", "Seen, %", "σ, px", "Window", "Lens",
                        "Distance, m", "Angle, °"}));
  for (int row = 0; row < stateCount; ++row) {
    const QStringList cells = cellsOf(copied()[row + 1].toUtf8());
    for (int column = 0; column < cells.size(); ++column)
      QCOMPARE(cells[column], cell(row, column));
  }
  table->horizontalHeader()->moveSection(StateTable::angle, 1);
  table->selectRow(2);
  pressCopy(table);
  QCOMPARE(copied().size(), 3);
  QVERIFY(copied()[0].startsWith("State,\"Angle, °\",\"PSNR, dB\""));
  QVERIFY(copied()[1].startsWith(state(2) + "," + cell(2, StateTable::angle) + "," +
                                 cell(2, StateTable::psnr)));
  click("copyTableButton");
  QCOMPARE(copied().size(), stateCount + 2);
  auto* tests = child<QTableView>("testTable");
  tests->clearSelection();
  pressCopy(tests);
  QCOMPARE(copied().size(), 4);
  const QStringList cells = cellsOf(copied()[1].toUtf8());
  QCOMPARE(cells[TestTable::name], QString("b.png"));
  QVERIFY(cells[TestTable::bar].contains(" – " + testCell(0, TestTable::psnr) + " ("));
}

/// By buttons, keys and links: the state is current, and compared.
void TestReportDock::worstAndBest() {
  QVERIFY(!child<QAbstractButton>("worstStateButton")->isEnabled());
  make();
  const auto current = [this] { return child<QComboBox>("stateBox")->currentText(); };
  const auto linkOf = [this](int test, int column) {
    return testCell(test, column).section("  ", 0, 0);
  };
  QSignalSpy compared(m_dock, &ReportDock::comparisonAsked);
  for (const int test : {0, 1}) {
    chooseTest(test);
    compared.clear();
    click("worstStateButton");
    QCOMPARE(current(), linkOf(test, TestTable::worst));
    QCOMPARE(current(), state(1));  // the first one sees nothing
    QCOMPARE(compared.last()[0].toString(), test == 0 ? QString("b.png") : QString("c.png"));
    QTest::keyClick(m_window.get(), Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
    QCOMPARE(current(), linkOf(test, TestTable::best));
    QCOMPARE(current(), state(stateCount - 1));
    QCOMPARE(child<QTableView>("reportTable")->selectionModel()->selectedRows().size(), 1);
  }
  auto* tests = child<QTableView>("testTable");
  const QRect link = tests->visualRect(tests->model()->index(0, TestTable::worst));
  QTest::mouseClick(tests->viewport(), Qt::LeftButton, {}, link.center());
  QCOMPARE(current(), linkOf(0, TestTable::worst));
  QCOMPARE(compared.last()[0].toString(), QString("b.png"));
  forgetReport();
  QVERIFY(!child<QAbstractButton>("worstStateButton")->isEnabled());
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
  const QList<QByteArray> lines = contentOf("s-report/report.csv").split('\n');
  for (const auto& [name, test] : {std::pair("s2", 1), std::pair("s1", 0)}) {
    chooseTest(test);
    const int row = rowOf(name);
    table->scrollTo(table->model()->index(row, 0));
    const QRect place = table->visualRect(table->model()->index(row, 0));
    QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, place.center());
    QCOMPARE(child<QComboBox>("stateBox")->currentText(), QString(name));
    const int line = 1 + 2 * QString(name).mid(1).toInt() + test;
    const QString frame = QString::number(cellsOf(lines[line])[3].toDouble(), 'f', 2);
    QTRY_VERIFY_WITH_TIMEOUT(!view->otherImage().isNull() && psnr() == frame, patience);
  }
  child<QAction>("stopComparingAction")->trigger();
  child<QComboBox>("stateBox")->setCurrentIndex(3);  // not by the table: it compares nothing
  QTest::qWait(200);
  QVERIFY(view->otherImage().isNull());
  m_window->grab().save(QCoreApplication::applicationDirPath() + "/report_rows.png");
}

/// A state that moves, or another display: what was measured is not of what is shown.
void TestReportDock::theFiguresOfEditedStatesAreStale(const QSignalSpy& told) {
  auto* model = m_window->findChild<SessionModel*>();
  const auto stale = [&] { return told.last()[1].value<std::vector<bool>>(); };
  QVERIFY(std::ranges::count(stale(), true) == 0);
  model->setCurrentIndex(1);
  CameraState moved = model->current();
  moved.camera.eye.x += 0.01;
  model->setCurrent(moved);
  QVERIFY(stale()[1] && std::ranges::count(stale(), true) == 1);
  const QModelIndex row = child<QListView>("stateList")->model()->index(1, 0);
  QVERIFY(row.data(Qt::ToolTipRole).toString().contains("was measured before"));
  model->undoStack()->undo();
  QVERIFY(std::ranges::count(stale(), true) == 0);
  QVERIFY(row.data(Qt::ToolTipRole).toString().isEmpty());
  Session wider = model->session();
  wider.display.fov[0] += 1;
  model->setContent(wider);
  QVERIFY(std::ranges::count(stale(), false) == 0);
  model->undoStack()->undo();
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
  chooseTest(1);
  QCOMPARE(last()[1], psnrOf(1, 1));
  theFiguresOfEditedStatesAreStale(told);
  child<QComboBox>("stateBox")->setCurrentIndex(3);
  QCOMPARE(table->currentIndex().row(), rowOf("s3"));
  QVERIFY(files(*m_window).open(m_folder->filePath("s.json")));
  QVERIFY(last().empty());
  QCOMPARE(table->model()->rowCount(), 0);
}

/// Each eye has one; the state's figure is that of the worse one.
void TestReportDock::bothEyesHaveARow() {
  open();
  auto* model = m_window->findChild<SessionModel*>();
  CameraState head = model->current();
  head.stereo.ipd = 0.1;
  model->setCurrent(head);
  QSignalSpy told(m_dock, &ReportDock::psnrChanged);
  m_dock->addTest("b.png");
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("reportNote")->text().contains("mean of the finite"),
                           patience);
  QCOMPARE(int(states().size()), stateCount + 1);
  const QList<QByteArray> lines = contentOf("s-report/report.csv").split('\n');
  QCOMPARE(cellsOf(lines[1])[0], QString("s0/left"));
  QCOMPARE(cellsOf(lines[2])[0], QString("s0/right"));
  const double left = cellsOf(lines[1])[5].toDouble();
  const double right = cellsOf(lines[2])[5].toDouble();
  QVERIFY(left != right);
  const auto last = told.last()[0].value<std::vector<double>>();
  QCOMPARE(last.size(), std::size_t(stateCount));
  QCOMPARE(last[0], std::min(left, right));
  auto* table = child<QTableView>("reportTable");
  for (const char* name : {"s2", "s0/right", "s1", "s0/left"}) {
    table->selectRow(rowOf(name));
    QCOMPARE(state(table->currentIndex().row()), QString(name));
    QCOMPARE(child<QComboBox>("stateBox")->currentText(), QString(name).section('/', 0, 0));
  }
}

/// A point of each row that compares something, where its PSNR says; a click chooses the row.
void TestReportDock::plotsShowTheRows() {
  make();
  const QList<QByteArray> lines = contentOf("s-report/report.csv").split('\n');
  const auto psnrOf = [&](std::size_t row) { return cellsOf(lines[1 + int(row)])[5].toDouble(); };
  auto* plot = child<ReportPlotView>("reportPlot");
  auto* table = child<QTableView>("reportTable");
  auto* kind = child<QComboBox>("reportPlotKind");
  kind->setCurrentIndex(1);
  m_window->findChild<QDockWidget*>("reportDock")->setFloating(true);
  m_window->findChild<QDockWidget*>("reportDock")->resize(1389, 868);
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
  const QColor second = tokens().series[1];
  const auto colourAt = [plot](const QPointF& place) {
    return plot->grab().toImage().pixelColor(place.toPoint());
  };
  QCOMPARE(colourAt(*placeOf(5)), second);
  QTest::mousePress(plot, Qt::RightButton, {}, placeOf(5)->toPoint());  // it has a menu
  QVERIFY(table->currentIndex().row() != rowOf("s2"));
  QTest::mouseClick(plot, Qt::LeftButton, {}, placeOf(5)->toPoint());
  QCOMPARE(table->currentIndex().row(), rowOf("s2"));
  QCOMPARE(child<QTableView>("testTable")->currentIndex().row(), 1);
  QCOMPARE(child<QComboBox>("stateBox")->currentIndex(), 2);

  const double byStates = placeOf(4)->x() - placeOf(2)->x();
  kind->setCurrentIndex(2);
  // s1 … s3 are at x = -0.1, 0, 0.1 of z = 0.7: even steps, and s0 a little nearer to s1.
  QVERIFY(std::abs(placeOf(6)->x() + placeOf(2)->x() - 2 * placeOf(4)->x()) < 1);
  QVERIFY(placeOf(2)->x() - placeOf(0)->x() < placeOf(4)->x() - placeOf(2)->x());
  QVERIFY(std::abs(placeOf(4)->x() - placeOf(2)->x() - byStates) > 1);

  kind->setCurrentIndex(3);
  QCOMPARE(plot->picture().toImage(), QImage("s-report/panel_error/test2_hogels.png")
                                          .convertToFormat(plot->picture().toImage().format()));
  chooseTest(0);
  QCOMPARE(plot->picture().toImage(), QImage("s-report/panel_error/test1_hogels.png")
                                          .convertToFormat(plot->picture().toImage().format()));
  kind->setCurrentIndex(4);
  QCOMPARE(plot->picture().size(), QImage("s-report/panel_error/test1_directions.png").size());
}

/// The means over the rate, and the eyes on a map with one scale; both choose by a click.
void TestReportDock::meansAndEyes() {
  make();
  auto* dock = m_window->findChild<QDockWidget*>("reportDock");
  dock->setFloating(true);
  dock->resize(1389, 868);
  auto* means = child<ReportPlotView>("reportMeans");
  auto* map = child<ReportPlotView>("reportMap");
  QTRY_VERIFY_WITH_TIMEOUT(map->height() > 150 && means->height() > 150, patience);
  const auto placeOf = [](const ReportPlotView* view, std::size_t row) {
    return hogelscope::placeOf(view->plot(), row, QSizeF(view->size()));
  };
  const auto number = [this](int test, int column) { return testCell(test, column).toDouble(); };
  QCOMPARE(placeOf(means, 0)->x() < placeOf(means, 1)->x(),
           number(0, TestTable::rate) < number(1, TestTable::rate));
  QCOMPARE(placeOf(means, 0)->y() > placeOf(means, 1)->y(),
           number(0, TestTable::psnr) < number(1, TestTable::psnr));
  QTest::mouseClick(means, Qt::LeftButton, {}, placeOf(means, 1)->toPoint());
  QCOMPARE(child<QTableView>("testTable")->currentIndex().row(), 1);

  // 0.1 m from each to the next, and 0.7 m to the panel, which is 0.5 m wide
  const double step = placeOf(map, 3)->x() - placeOf(map, 1)->x();
  QVERIFY(step > 5);
  QVERIFY(std::abs(placeOf(map, 7)->x() - placeOf(map, 1)->x() - 3 * step) < 0.1);
  const PlotArea area = areaOf(map->plot(), {300, 200, 40, 60, 44, 30});
  QVERIFY(std::abs((area.across.at(0.1) - area.across.at(0)) - (area.up.at(0) - area.up.at(0.1))) <
          1e-9);
  for (const double x : {-0.25, 0.25})
    QVERIFY(area.across.low <= x && x <= area.across.high && area.up.low <= 0);
  QTest::mouseClick(map, Qt::LeftButton, {}, placeOf(map, 3)->toPoint());
  QCOMPARE(child<QComboBox>("stateBox")->currentText(), QString("s1"));
  // the chosen eye is ringed
  const QImage shown = map->grab().toImage();
  const QPoint eye = placeOf(map, 3)->toPoint();
  bool hasRing = false;
  for (int y = 5; y < 15; ++y) hasRing |= shown.pixelColor(eye + QPoint(0, y)) == tokens().eye;
  QVERIFY(hasRing);
  QCOMPARE(map->grab().toImage().pixelColor(2, map->height() - 2), tokens().canvas);
  dock->grab().save(QCoreApplication::applicationDirPath() + "/report_dock_large.png");
}

void TestReportDock::namesAreShort() {
  using Names = std::vector<std::string>;
  QCOMPARE(shortNames({"/x/a.jpg", "y/b.jpg", "c"}), Names({"a.jpg", "b.jpg", "c"}));
  QCOMPARE(shortNames({"/x/a/q.jpg", "/x/b/q.jpg", "/x/b/r.jpg"}),
           Names({"a/q.jpg", "b/q.jpg", "r.jpg"}));
  QCOMPARE(shortNames({"/x/a/out/v/q.jpg", "/x/b/out/v/q.jpg"}), Names({"a/…/q.jpg", "b/…/q.jpg"}));
  QCOMPARE(shortNames({"views/", "/views"}), Names({"views", "views"}));
  QCOMPARE(shortNames({"q.jpg", "q.jpg"}), Names({"q.jpg", "q.jpg"}));
}

/// Those that the report's folder has: the worst, the median and the best.
void TestReportDock::picturesOfTheChosenState() {
  make();
  auto* dock = m_window->findChild<QDockWidget*>("reportDock");
  dock->setFloating(true);
  dock->resize(1389, 868);
  const auto* reference = child<ReportPlotView>("reportReference");
  click("worstStateButton");
  QTRY_VERIFY_WITH_TIMEOUT(reference->isVisible(), patience);
  QCOMPARE(reference->picture().toImage().pixelColor(40, 30),
           QImage("s-report/views/test1_worst_reference.png").pixelColor(40, 30));
  QVERIFY(child<QLabel>("reportPicturesTitle")->text().contains(cell(1, StateTable::psnr)));
  dock->grab().save(QCoreApplication::applicationDirPath() + "/report_dock_pictures.png");
  click("bestStateButton");
  QCOMPARE(child<ReportPlotView>("reportDifference")->picture().toImage().pixelColor(40, 30),
           QImage("s-report/views/test1_best_difference.png").pixelColor(40, 30));
  QSignalSpy compared(m_dock, &ReportDock::comparisonAsked);
  click("compareStateButton");
  QCOMPARE(compared.count(), 1);
  child<QTableView>("reportTable")->selectRow(rowOf("s4"));  // it sees nothing
  QVERIFY(!reference->isVisible());
}

/// Its tables and plots are those of the report that was made, without rendering.
void TestReportDock::opensAReport() {
  make();
  chooseTest(0);
  const auto contents = [this] {
    QStringList all;
    for (const char* name : {"testTable", "reportTable"}) {
      const auto* model = child<QTableView>(name)->model();
      for (int row = 0; row < model->rowCount(); ++row)
        for (int column = 0; column < model->columnCount(); ++column)
          all << model->index(row, column).data().toString();
    }
    return all;
  };
  const QStringList made = contents();
  const QByteArray before = contentOf("s-report/report.csv");
  forgetReport();
  QVERIFY(contents() != made);
  QSignalSpy told(m_dock, &ReportDock::psnrChanged);
  m_dock->openReport(m_folder->filePath("s-report"));
  QTRY_COMPARE_WITH_TIMEOUT(contents(), made, patience);
  QCOMPARE(contentOf("s-report/report.csv"), before);
  QCOMPARE(told.last()[0].value<std::vector<double>>().size(), std::size_t(stateCount));
  QVERIFY(child<QAbstractButton>("openPageButton")->isEnabled());
  QSignalSpy compared(m_dock, &ReportDock::comparisonAsked);
  click("worstStateButton");
  QCOMPARE(compared.last()[0].toString(), m_folder->filePath("b.png"));
  QCOMPARE(child<QComboBox>("stateBox")->currentText(), state(1));
}

/// Its files name the tests from its folder, not from the root, so that both can be moved together.
void TestReportDock::aReportMovesWithItsTests() {
  open();
  m_dock->addTest(m_folder->filePath("b.png"));
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("reportNote")->text().contains("mean of the finite"),
                           patience);
  int read = 0;
  for (QDirIterator file("s-report", QDir::Files, QDirIterator::Subdirectories); file.hasNext();) {
    const QString name = file.next();
    if (name.endsWith(".png")) continue;
    QVERIFY2(!contentOf(name).contains(m_folder->path().toUtf8()), qPrintable(name));
    ++read;
  }
  QVERIFY(read > 5);
  QVERIFY(contentOf("s-report/report.csv").contains("s0,../b.png,"));
  const QByteArray page = contentOf("s-report/report.html");
  for (const char* fact : {">../s.json, ", ">../a.png, ", ">../b.png, "})
    QVERIFY2(page.contains(fact), fact);
  QDir(".").mkdir("moved");
  for (const char* name : {"s-report", "b.png"})
    QVERIFY(QDir(".").rename(name, QString("moved/") + name));
  forgetReport();
  m_dock->openReport(m_folder->filePath("moved/s-report"));
  QTRY_COMPARE_WITH_TIMEOUT(states().size(), stateCount, patience);
  QSignalSpy compared(m_dock, &ReportDock::comparisonAsked);
  click("worstStateButton");
  QCOMPARE(compared.last()[0].toString(), m_folder->filePath("moved/b.png"));
}

/// A test that is a link has the link's name, and a folder around the report its own.
void TestReportDock::namesOfLinksAndFolders() {
  open();
  QVERIFY(QFile::link("b.png", "link.png"));
  QDir(".").mkpath("views/deep");
  m_dock->setFolder(m_folder->filePath("views/deep/made"));
  m_dock->addTest(m_folder->filePath("link.png"));
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("reportNote")->text().contains("mean of the finite"),
                           patience);
  QVERIFY(contentOf("views/deep/made/report.csv").contains("s0,../../../link.png,"));
  ReportRequest request;
  request.output = "views/deep/made";
  request.hasRelativeNames = true;
  for (const auto& [file, name] :
       {std::pair("views", "../../../views"), std::pair("views/", "../../../views"),
        std::pair("views/deep/x.png", "../x.png"), std::pair("views/deep/made/x.png", "x.png"),
        std::pair("", "")})
    QCOMPARE(nameIn(request, file), std::string(name));
  request.hasRelativeNames = false;
  QCOMPARE(nameIn(request, "views/"), std::string("views/"));
}

/// The session's states are others by now: the report's are shown by name, and nothing follows.
void TestReportDock::opensAReportOfOtherStates() {
  make();
  const QStringList names = states();
  QByteArray other = contentOf("s.json");
  other.replace("\"s1\"", "\"new\"");
  writeFile("t.json", other);
  QVERIFY(files(*m_window).open(m_folder->filePath("t.json")));
  QFile::remove("b.png");
  m_dock->openReport(m_folder->filePath("s-report"));
  QTRY_COMPARE_WITH_TIMEOUT(states(), names, patience);
  QCOMPARE(testCell(0, TestTable::rate), QString("–"));  // its file is gone
  child<QComboBox>("stateBox")->setCurrentIndex(0);
  QSignalSpy compared(m_dock, &ReportDock::comparisonAsked);
  child<QTableView>("reportTable")->selectRow(rowOf("s1"));
  QCOMPARE(child<QComboBox>("stateBox")->currentText(), QString("s0"));
  QCOMPARE(compared.count(), 0);
  child<QTableView>("reportTable")->selectRow(rowOf("s2"));
  QCOMPARE(child<QComboBox>("stateBox")->currentText(), QString("s2"));
  QTest::keyClick(m_window.get(), Qt::Key_D, Qt::ControlModifier);  // a state more
  QCOMPARE(states(), names);
}

void TestReportDock::whatIsNoReport() {
  open();
  QTRY_VERIFY_WITH_TIMEOUT(m_window->statusBar()->currentMessage().contains(" ms"), patience);
  const auto line = [this](const QByteArray& csv) {
    QDir(".").mkdir("none");
    if (!csv.isEmpty()) writeFile("none/report.csv", csv);
    child<QLabel>("reportNote")->clear();
    m_dock->openReport(m_folder->filePath("none"));
    [&] { QTRY_VERIFY_WITH_TIMEOUT(!child<QLabel>("reportNote")->text().isEmpty(), patience); }();
    return child<QLabel>("reportNote")->text();
  };
  QCOMPARE(line(""), m_folder->filePath("none") + ": is no report: it has no report.csv");
  for (const char* csv : {"a,b\n1,2\n", "state,test\n", "state,test\na,x\na,y\nb,x\n",
                          "state,test\na,x\nb,y\n", "\"", "\n\n,\n"})
    QVERIFY2(line(csv).contains("report.csv: is no table of a report"), csv);
  QCOMPARE(child<QTableView>("testTable")->model()->rowCount(), 0);
}

/// Plots leave their place to the tables.
void TestReportDock::narrowDocks() {
  make();
  auto* dock = m_window->findChild<QDockWidget*>("reportDock");
  dock->setFloating(true);
  dock->resize(900, 500);
  QTRY_VERIFY_WITH_TIMEOUT(child<ReportPlotView>("reportMap")->isVisible(), patience);
  dock->resize(600, 500);
  QTRY_VERIFY_WITH_TIMEOUT(!child<ReportPlotView>("reportMap")->isVisible(), patience);
  QVERIFY(child<QTableView>("reportTable")->isVisible() && dock->width() <= 600);
  QVERIFY(!child<QAbstractButton>("worstStateButton")->visibleRegion().isEmpty());
}

void TestReportDock::stopsAndGoesOn() {
  open("[800, 600]", R"({"samplesPerPixel": 5})");
  m_dock->addTest("b.png");
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(!cell(stateCount - 1, StateTable::psnr).isEmpty(), patience);
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
  QCOMPARE(model->columnCount(), StateTable::plugins + 1);
  QCOMPARE(model->headerData(StateTable::plugins, Qt::Horizontal).toString(),
           QString("MS\u2011SSIM"));
  const QList<QByteArray> lines = contentOf("s-report/metrics.csv").split('\n');
  const qsizetype column = cellsOf(lines[0]).indexOf("ms_ssim");
  for (int k = 0; k + 1 < stateCount; ++k) {
    const double figure = cellsOf(lines[k + 1]).value(column).toDouble();
    QVERIFY(figure > 0.1 && figure < 1);
    QCOMPARE(cell(rowOf("s" + QString::number(k)), StateTable::plugins),
             QString::number(figure, 'f', 4));
  }
  m_window->findChild<QWidget*>("cameraArea")->findChild<QDoubleSpinBox*>("eye.0")->setValue(0.05);
  QVERIFY(child<QLabel>("reportStale")->isVisible());
  QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(!child<QLabel>("reportStale")->isVisible());  // the session is whole again, metrics too
  writeFile("t.json", session("[80, 60]", "{}"));
  QVERIFY(files(*m_window).open(m_folder->filePath("t.json")));
  QCOMPARE(model->columnCount(), int(StateTable::plugins));
}

/// A choice is an edit of the session, and shows plugins that are installed.
void TestReportDock::metricsAreChosen() {
  open("[80, 60]", "{}");
  auto* model = m_window->findChild<SessionModel*>();
  const auto actionOf = [this](const QString& name) {
    QMenu* menu = child<QToolButton>("metricsButton")->menu();
    Q_EMIT menu->aboutToShow();
    const QList<QAction*> actions = menu->actions();
    const auto found = std::ranges::find(actions, name, &QAction::text);
    return found == actions.end() ? nullptr : *found;
  };
  QVERIFY(actionOf("ms-ssim") != nullptr && !actionOf("ms-ssim")->isChecked());
  actionOf("ms-ssim")->trigger();
  QCOMPARE(model->session().metrics, std::vector<std::string>{"ms-ssim"});
  QVERIFY(actionOf("ms-ssim")->isChecked());
  QVERIFY(m_window->isWindowModified());
  model->undoStack()->undo();
  QVERIFY(model->session().metrics.empty());
  QVERIFY(!actionOf("ms-ssim")->isChecked());
}

/// Worst first, by the column with the arrow.
void TestReportDock::aSecondReportIsSortedToo() {
  make();
  const auto isSorted = [this] {
    double before = -1;
    for (int row = 0; row < stateCount; ++row) {
      const double now = cell(row, StateTable::psnr).toDouble();
      if (now < before) return false;
      before = now;
    }
    return before > 0;
  };
  QVERIFY(isSorted());
  auto* model = m_window->findChild<SessionModel*>();
  model->edit("Sigma", [](Session& session) {
    for (std::size_t k = 0; k < session.cameras.size(); ++k)
      session.cameras[k].psf = {.sigma = 2 - 0.3 * double(k), .windowSize = 7};
  });
  click("makeReportButton");
  if (child<QPushButton>("makeReportButton")->text().startsWith("&Replace"))
    click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("reportNote")->text().contains("mean of the finite"),
                           patience);
  QVERIFY2(isSorted(), qPrintable(states().join(' ')));
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
  QCOMPARE(child<QTableView>("reportTable")->model()->rowCount(), stateCount);
  QTest::keyClick(m_window.get(), Qt::Key_D, Qt::ControlModifier);  // duplicate
  QCOMPARE(child<QTableView>("reportTable")->model()->rowCount(), 0);
}

void TestReportDock::unsavedEditsHaveAHeading() {
  QVERIFY(!child<QAbstractButton>("openPageButton")->isEnabled());  // there is no page
  open();
  QVERIFY(!child<QAbstractButton>("openPageButton")->isEnabled());
  m_window->findChild<QWidget*>("cameraArea")->findChild<QDoubleSpinBox*>("eye.0")->setValue(0.05);
  m_dock->addTest("b.png");
  click("makeReportButton");
  QVERIFY(!child<QAbstractButton>("openPageButton")->isEnabled());
  QTRY_VERIFY_WITH_TIMEOUT(child<QAbstractButton>("openPageButton")->isEnabled(), patience);
  const QString name = "s.json with unsaved changes";
  QCOMPARE(heading("s-report"), "Perceived views of " + name);
  QVERIFY(contentOf("s-report/report.html")
              .contains(("made in the window, from " + name + "<").toUtf8()));
  QVERIFY(files(*m_window).save(m_folder->filePath("s.json")));
  child<QAbstractButton>("openPageButton")->setEnabled(false);
  click("makeReportButton");
  QTRY_VERIFY_WITH_TIMEOUT(child<QAbstractButton>("openPageButton")->isEnabled(), patience);
  QCOMPARE(heading("s-report"), QString("Perceived views of s.json"));
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
  QTRY_VERIFY_WITH_TIMEOUT(child<QAbstractButton>("openPageButton")->isEnabled(), patience);
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
  QVERIFY(!child<QAbstractButton>("openPageButton")->isEnabled());
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
  QTRY_VERIFY_WITH_TIMEOUT(child<QAbstractButton>("openPageButton")->isEnabled(), patience);
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
