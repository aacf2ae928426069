// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/report_dock.h"

#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QStyle>
#include <QTableView>
#include <QUrl>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "gui/docks/report_results.h"
#include "gui/session/session_forms.h"
#include "gui/session/session_model.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/polled_bar.h"
#include "gui/widgets/task.h"
#include "io/plugins/metric_plugins.h"
#include "report/page/report_tables.h"
#include "report/report_files.h"

namespace hogelscope {

namespace {

QWidget* makeRow(std::initializer_list<QWidget*> widgets) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  for (QWidget* widget : widgets) layout->addWidget(widget);
  return row;
}

/// Returns the session's name for the report's heading.
std::string nameOf(const SessionModel& model) {
  const std::string file = model.file().toStdString();
  if (file.empty()) return "an untitled session";
  return model.isModified() ? file + " with unsaved changes" : file;
}

/// Returns a folder named after the session or, if it has no file yet, after its light field.
QString folderBeside(const SessionModel& model) {
  const QString lightField = QString::fromStdString(contentName(model.session().lightField));
  const QFileInfo info(QDir::cleanPath(model.file().isEmpty() ? lightField : model.file()));
  return info.path() + "/" + info.completeBaseName() + "-report";
}

}  // namespace

ReportDock::ReportDock(QWidget* parent)
    : QWidget(parent),
      m_task(new Task(this)),
      m_table(new ReportTable(this)),
      m_plots(new ReportPlots),
      m_sorted(new QSortFilterProxyModel(this)),
      m_testList(new QListWidget),
      m_folder(new QLineEdit),
      m_addOffered(button("addComparedButton", {}, tr("What the picture is compared with"))),
      m_makeButton(button("makeReportButton", {},
                          tr("Renders every state from the session's light "
                             "field and from each test, and compares"))),
      m_pageButton(
          button("openPageButton", tr("&Open page"), tr("Shows report.html in the web browser"))),
      m_progress(new PolledBar([this] { return m_task->share(); })),
      m_note(new QLabel),
      m_stale(new QLabel(tr("The session has been edited since this report was made."))),
      m_rows(new QTableView) {
  m_sorted->setSourceModel(m_table);
  m_sorted->setSortRole(ReportTable::sortRole);
  m_rows->setObjectName("reportTable");
  m_rows->setMinimumWidth(210);
  m_rows->setModel(m_sorted);
  m_rows->setSortingEnabled(true);
  m_rows->sortByColumn(-1, Qt::AscendingOrder);  // in the report's order
  m_rows->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_rows->setSelectionMode(QAbstractItemView::SingleSelection);
  m_rows->horizontalHeader()->setSortIndicatorClearable(true);  // by a third click
  m_rows->verticalHeader()->setMaximumWidth(fontMetrics().averageCharWidth() * 20);
  m_rows->verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  m_rows->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  m_rows->horizontalHeader()->setDefaultSectionSize(
      fontMetrics().horizontalAdvance("PSNR seen, dB ") + 16);
  auto* parts = new QSplitter;
  parts->addWidget(makeSettings());
  parts->addWidget(m_rows);
  parts->addWidget(m_plots);
  parts->setSizes({280, 500, 500});
  parts->setChildrenCollapsible(false);
  auto* layout = new QHBoxLayout(this);
  layout->addWidget(parts);
  m_pageButton->setEnabled(false);
  connectAll();
  showIdle();
}

QWidget* ReportDock::makeSettings() {
  m_testList->setObjectName("testList");
  m_testList->setToolTip(tr("The light fields that are compared with the session's own"));
  m_testList->setMaximumHeight(90);
  m_folder->setObjectName("reportFolder");
  m_folder->setToolTip(
      tr("Where report.html, report.csv and the pictures go; an older report there is replaced"));
  m_note->setObjectName("reportNote");
  m_note->setWordWrap(true);
  m_stale->setObjectName("reportStale");
  m_stale->setWordWrap(true);
  m_stale->hide();
  m_progress->setObjectName("reportProgress");
  QSizePolicy kept = m_addOffered->sizePolicy();
  kept.setRetainSizeWhenHidden(true);  // so that the buttons below do not move
  m_addOffered->setSizePolicy(kept);
  auto* addFile = button("addTestButton", tr("&Add…"), tr("An image or a session"));
  auto* addFolder = button("addTestFolderButton", tr("Add &folder…"), tr("A folder of views"));
  auto* remove = button("removeTestButton", tr("&Remove"), tr("The one that is marked"));
  auto* choose = button("reportFolderButton", tr("Choose…"), tr("Another folder"));
  connect(addFile, &QPushButton::clicked, this, &ReportDock::askTest);
  connect(addFolder, &QPushButton::clicked, this, &ReportDock::askTestFolder);
  connect(choose, &QPushButton::clicked, this, &ReportDock::askFolder);
  connect(m_addOffered, &QPushButton::clicked, this, [this] { addTest(m_offered); });
  connect(remove, &QPushButton::clicked, this, [this] {
    delete m_testList->currentItem();
    showIdle();
  });
  auto* settings = new QWidget;
  auto* layout = new QVBoxLayout(settings);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(new QLabel(tr("Test light fields")));
  layout->addWidget(m_testList);
  layout->addWidget(makeRow({addFile, addFolder, remove}));
  layout->addWidget(m_addOffered);
  layout->addWidget(new QLabel(tr("Report folder")));
  layout->addWidget(makeRow({m_folder, choose}));
  layout->addWidget(makeRow({m_makeButton, m_pageButton}));
  layout->addWidget(m_progress);
  layout->addWidget(m_stale);
  layout->addWidget(m_note);
  layout->addStretch();
  auto* area = new QScrollArea;
  area->setFrameShape(QFrame::NoFrame);
  area->setWidget(settings);
  area->setWidgetResizable(true);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setMinimumWidth(settings->minimumSizeHint().width() +
                        style()->pixelMetric(QStyle::PM_ScrollBarExtent));
  return area;
}

void ReportDock::connectAll() {
  connect(m_makeButton, &QPushButton::clicked, this, &ReportDock::makeOrStop);
  connect(m_pageButton, &QPushButton::clicked, this, &ReportDock::openPage);
  connect(m_rows->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &ReportDock::showChosen);
  connect(m_plots, &ReportPlots::clicked, this, &ReportDock::chooseRow);
  connect(m_progress, &QProgressBar::valueChanged, this, &ReportDock::showTimeLeft);
  connect(m_task, &Task::stopped, this, [this] {
    showIdle();
    m_note->setText(tr("Stopped. What is finished is kept: the same report goes on from there."));
  });
  connect(m_task, &Task::failed, this, [this](const QString& line) {
    showIdle();
    m_note->setText(line);
    Q_EMIT failed(line);
  });
}

void ReportDock::setModel(SessionModel* model) {
  m_model = model;
  connect(model, &SessionModel::opened, this, [this] {
    forget();
    setFolder(folderBeside(*m_model));
  });
  connect(model, &SessionModel::edited, this, &ReportDock::noteEdits);
  connect(model, &SessionModel::statesChanged, this, &ReportDock::noteEdits);
  connect(model, &SessionModel::currentChanged, this,
          [this] { chooseState(m_model->currentIndex()); });
  showIdle();
}

/// Removes rows of another session and stops a running report.
void ReportDock::forget() {
  if (m_task->isRunning()) stop();
  m_table->begin(0);
  m_plots->begin({}, {});
  m_note->clear();
  m_stale->hide();
  m_pageButton->setEnabled(false);
  emitPsnr();
  showIdle();
}

void ReportDock::noteEdits() {
  if (m_table->rowCount() == 0) return showIdle();
  const auto nameOf = [](const CameraState& state) { return state.camera.name; };
  if (!std::ranges::equal(m_request.session.cameras, m_model->session().cameras, {}, nameOf,
                          nameOf))
    return forget();
  m_stale->setVisible(m_request.session != m_model->session());
}

void ReportDock::askTest() {
  const QStringList files =
      chooseFiles(this, tr("Add test light fields"), lightFieldFilter(sessionPatterns));
  for (const QString& file : files) addTest(file);
}

void ReportDock::askTestFolder() {
  const QString folder = chooseFolder(this, tr("Add a folder of views"));
  if (!folder.isEmpty()) addTest(folder);
}

void ReportDock::addTest(const QString& file) {
  m_testList->addItem(file);
  m_testList->setCurrentRow(m_testList->count() - 1);
  showIdle();
}

void ReportDock::offerTest(const QString& file) {
  m_offered = file;
  showOffer();
}

/// Offers a test unless it is in the list already.
void ReportDock::showOffer() {
  const bool isNew = m_testList->findItems(m_offered, Qt::MatchExactly).isEmpty();
  m_addOffered->setVisible(!m_offered.isEmpty() && isNew);
  m_addOffered->setText(tr("A&dd %1").arg(QFileInfo(m_offered).fileName().replace('&', "&&")));
}

void ReportDock::askFolder() {
  const QString folder = chooseOutputFolder(this, tr("Folder of the report"));
  if (!folder.isEmpty()) setFolder(folder);
}

void ReportDock::setFolder(const QString& folder) {
  m_folder->setText(folder);
}

void ReportDock::openPage() {
  const QString page = QString::fromStdString(m_request.output) + "/report.html";
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(page)))
    Q_EMIT failed(tr("%1: no web browser could be started for it").arg(page));
}

void ReportDock::makeOrStop() {
  if (m_task->isRunning()) return stop();
  try {
    start(metricsOf(m_model->session().metrics));
  } catch (const InputError& error) {
    m_note->setText(error.what());
    Q_EMIT failed(error.what());
  }
}

void ReportDock::start(const MetricSet& metrics) {
  m_tests.clear();
  for (int k = 0; k < m_testList->count(); ++k)
    m_tests.push_back(m_testList->item(k)->text().toStdString());
  m_request = ReportRequest();
  m_request.session = m_model->session();
  m_request.metrics = metrics;
  const bool isEdited = m_model->isModified() || m_model->file().isEmpty();
  m_request.name = nameOf(*m_model);
  if (!isEdited) m_request.sessionFile = m_model->file().toStdString();
  m_request.output = m_folder->text().toStdString();
  m_request.command = "made in the window" + (isEdited ? ", from " + m_request.name : "");
  m_request.reference = m_reference;
  m_table->begin(m_request.session.cameras.size() * m_tests.size(), metrics);
  m_plots->begin(m_request, m_tests);
  m_rows->setColumnHidden(ReportTable::test, m_tests.size() == 1);
  m_test = 0;
  emitPsnr();
  m_note->clear();
  m_stale->hide();
  m_pageButton->setEnabled(false);
  m_makeButton->setText(tr("&Stop"));
  m_clock.start();
  m_task->start([this, task = m_task, request = m_request,
                 tests = m_tests](const Progress& progress) mutable {
    ReportListener listener;
    listener.progress = progress;
    listener.finished = [=, this](std::size_t index, const ReportRow& row) {
      task->queue([this, index, row] { showRow(index, row); });
    };
    request.tests = openTests(request.session, tests);
    return [this, report = makeReport(request, listener)] { showReport(report); };
  });
  m_progress->setVisible(true);
}

void ReportDock::stop() {
  m_task->stop();
  m_makeButton->setText(tr("Stopping…"));
  m_makeButton->setEnabled(false);
}

/// Resets the controls, except while a report is generated.
void ReportDock::showIdle() {
  showOffer();
  if (m_task->isRunning()) return;
  m_makeButton->setText(tr("&Make report"));
  m_makeButton->setEnabled(m_model != nullptr && !m_model->session().cameras.empty() &&
                           m_testList->count() > 0);
  m_progress->setVisible(false);
}

void ReportDock::showReport(const Report& report) {
  showIdle();
  if (m_table->rowCount() == 0) return;  // rows of another session
  QStringList texts;
  for (std::size_t k = 0; k + 1 < report.summaries.size(); ++k) {  // the last is of all tests
    const TestSummary& test = report.summaries[k];
    const std::string name = m_tests.size() == 1 ? "" : test.test + "\n";
    texts << QString::fromStdString(name + summaryText(test.summary, test.rows));
  }
  m_note->setText(texts.join("\n"));
  m_pageButton->setEnabled(true);
  m_plots->finish();
  if (!chosenRow()) chooseState(m_model->currentIndex());
  compare();
}

void ReportDock::showTimeLeft() {
  const std::string left = timeLeft(double(m_clock.elapsed()) / 1000, m_task->share());
  m_progress->setFormat("%p % " + QString::fromStdString(left));
}

void ReportDock::showRow(std::size_t index, const ReportRow& row) {
  m_table->set(index, row);
  m_plots->set(index, row);
  emitPsnr();
}

void ReportDock::emitPsnr() {
  std::vector<double> dB;
  if (m_table->rowCount() > 0) {
    dB.assign(m_request.session.cameras.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t state = 0; state < dB.size(); ++state)
      if (const auto& row = m_table->row(order().row(state, m_test)); row)
        dB[state] = row->values[psnrSeenColumn];
  }
  if (std::ranges::all_of(dB, [](double value) { return std::isnan(value); })) dB.clear();
  Q_EMIT psnrChanged(dB);
}

std::optional<std::size_t> ReportDock::chosenRow() const {
  const QModelIndex current = m_sorted->mapToSource(m_rows->currentIndex());
  if (!current.isValid()) return std::nullopt;
  return std::size_t(current.row());
}

void ReportDock::showChosen() {
  const std::optional<std::size_t> row = chosenRow();
  m_plots->select(row);
  if (!row || m_tests.empty()) return;
  if (const std::size_t test = order().test(*row); test != m_test) {
    m_test = test;
    emitPsnr();
  }
  if (!m_follows) compare();
  m_model->setCurrentIndex(order().state(*row));
}

void ReportDock::compare() {
  Q_EMIT comparisonAsked(QString::fromStdString(m_tests[m_test]));
}

void ReportDock::chooseState(std::size_t state) {
  const std::size_t row = order().row(state, m_test);
  if (m_tests.empty() || row >= std::size_t(m_table->rowCount()) || chosenRow() == row) return;
  m_follows = true;
  chooseRow(row);
  m_follows = false;
}

void ReportDock::chooseRow(std::size_t row) {
  m_rows->selectRow(m_sorted->mapFromSource(m_table->index(int(row), 0)).row());
}

}  // namespace hogelscope
