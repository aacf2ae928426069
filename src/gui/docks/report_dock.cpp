// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/report_dock.h"

#include <QDesktopServices>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSplitter>
#include <QToolButton>
#include <QUrl>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "gui/docks/report_plots.h"
#include "gui/session/session_forms.h"
#include "gui/session/session_model.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/command.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/polled_bar.h"
#include "gui/widgets/task.h"
#include "io/plugins/metric_plugins.h"
#include "report/page/report_tables.h"

namespace hogelscope {

namespace {

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

/// Returns the rates of the tests that have one.
std::vector<std::optional<double>> ratesOf(const Session& session,
                                           const std::vector<std::string>& tests) {
  std::vector<std::optional<double>> rates;
  for (const std::string& test : tests) {
    rates.emplace_back();
    try {
      rates.back() = rateOfFiles(openTests(session, {test})[0]);
    } catch (const InputError&) {  // a report that is read may outlive its tests
    }
  }
  return rates;
}

QToolButton* toolButton(const QString& name, const QString& title, const QString& help,
                        const char* image) {
  auto* button = new QToolButton;
  button->setObjectName(name);
  button->setText(title);
  button->setToolTip(help);
  button->setIcon(icon(image));
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  return button;
}

/// The narrowest dock that has plots beside the tables, and texts on the buttons.
constexpr int wide = 700;

}  // namespace

ReportDock::ReportDock(QWidget* parent)
    : QWidget(parent),
      m_task(new Task(this)),
      m_testTable(new TestTable(this)),
      m_stateTable(new StateTable(this)),
      m_sorted(new StateFilter(this)),
      m_plots(new ReportPlots(m_data)),
      m_testList(new QListWidget),
      m_folder(new QLineEdit),
      m_addOffered(button("addComparedButton", {}, tr("What the picture is compared with"))),
      m_makeButton(button("makeReportButton", {},
                          tr("Renders every state from the session's light "
                             "field and from each test, and compares"))),
      m_progress(new PolledBar([this] { return m_task->share(); })),
      m_note(new QLabel),
      m_stale(new QLabel(tr("The session has been edited since this report was made."))),
      m_heading(new QLabel),
      m_tests(new CopyTable("testTable")),
      m_rows(new CopyTable("reportTable")) {
  setMinimumWidth(scaled(360));  // less than the plots need, which are then hidden
  auto* settings = makeSettings();
  auto* parts = new QSplitter;
  parts->addWidget(makeTables());
  parts->addWidget(m_plots);
  parts->setSizes({812, 577});
  parts->setChildrenCollapsible(false);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeTools());
  layout->addWidget(settings);
  layout->addWidget(parts, 1);
  connect(m_testsButton, &QToolButton::toggled, settings, &QWidget::setVisible);
  connectAll();
  showAll();
  sizeColumns();
  m_rows->sortByColumn(StateTable::psnr, Qt::AscendingOrder);  // worst first
  showIdle();
}

QWidget* ReportDock::makeTools() {
  m_makeButton->setProperty("primary", true);
  m_progress->setObjectName("reportProgress");
  m_testsButton = toolButton("testsButton", tr("Tests…"),
                             tr("The test light fields, and the folder of the report"), "new");
  m_testsButton->setCheckable(true);
  m_testsButton->setChecked(true);
  m_pageButton = toolButton("openPageButton", tr("Open page"),
                            tr("Shows report.html in the web browser"), "external");
  m_pageButton->setEnabled(false);
  m_openButton = toolButton("openReportButton", {}, {}, "folder");
  m_worstButton = toolButton("worstStateButton", {}, {}, "down");
  m_bestButton = toolButton("bestStateButton", {}, {}, "up");
  auto* copy = toolButton("copyTableButton", tr("Copy table"),
                          tr("Copies the table of states as CSV; Ctrl+C copies selected rows, "
                             "also of the tests"),
                          "copy_table");
  connect(m_makeButton, &QPushButton::clicked, this, &ReportDock::makeOrStop);
  connect(m_pageButton, &QToolButton::clicked, this, &ReportDock::openPage);
  connect(copy, &QToolButton::clicked, this, [this] { m_rows->copy(true); });
  auto* row = new QWidget;
  m_tools = new QHBoxLayout(row);
  m_tools->setContentsMargins(8, 4, 8, 4);
  for (QWidget* widget : std::initializer_list<QWidget*>{m_makeButton, m_testsButton, m_pageButton,
                                                         m_openButton, m_progress})
    m_tools->addWidget(widget);
  m_tools->addStretch();
  for (QWidget* widget : {m_worstButton, m_bestButton, copy}) m_tools->addWidget(widget);
  return row;
}

QWidget* ReportDock::makeSettings() {
  m_testList->setObjectName("testList");
  m_testList->setToolTip(tr("The light fields that are compared with the session's own"));
  m_testList->setMaximumHeight(scaled(72));
  m_folder->setObjectName("reportFolder");
  m_folder->setToolTip(
      tr("Where report.html, report.csv and the pictures go; an older report there is replaced"));
  QSizePolicy kept = m_addOffered->sizePolicy();
  kept.setRetainSizeWhenHidden(true);  // so that the buttons do not move
  m_addOffered->setSizePolicy(kept);
  auto* addFile = button("addTestButton", tr("&Add…"), tr("An image or a session"));
  auto* addFolder = button("addTestFolderButton", tr("Add &folder…"), tr("A folder of views"));
  auto* remove = button("removeTestButton", tr("&Remove"), tr("The one that is marked"));
  auto* choose = button("reportFolderButton", tr("Choose…"), tr("Another folder"));
  connect(addFile, &QPushButton::clicked, this, [this] {
    for (const QString& file :
         chooseFiles(this, tr("Add test light fields"), lightFieldFilter(sessionPatterns)))
      addTest(file);
  });
  connect(addFolder, &QPushButton::clicked, this, [this] {
    const QString folder = chooseFolder(this, tr("Add a folder of views"));
    if (!folder.isEmpty()) addTest(folder);
  });
  connect(choose, &QPushButton::clicked, this, [this] {
    const QString folder = chooseOutputFolder(this, tr("Folder of the report"));
    if (!folder.isEmpty()) setFolder(folder);
  });
  connect(m_addOffered, &QPushButton::clicked, this, [this] { addTest(m_offered); });
  connect(remove, &QPushButton::clicked, this, [this] {
    delete m_testList->currentItem();
    showIdle();
  });
  auto* settings = new QWidget;
  auto* grid = new QGridLayout(settings);
  grid->setContentsMargins(8, 4, 8, 4);
  grid->addWidget(m_testList, 0, 0, 2, 2);
  grid->addWidget(addFile, 0, 2);
  grid->addWidget(addFolder, 0, 3);
  grid->addWidget(remove, 1, 2);
  grid->addWidget(m_addOffered, 1, 3);
  grid->addWidget(new QLabel(tr("Report folder")), 2, 0);
  grid->addWidget(m_folder, 2, 1);
  grid->addWidget(choose, 2, 2);
  grid->setColumnStretch(1, 1);
  return settings;
}

QWidget* ReportDock::makeTables() {
  m_note->setObjectName("reportNote");
  m_stale->setObjectName("reportStale");
  for (QLabel* line : {m_note, m_stale}) {
    line->setWordWrap(true);
    line->setContentsMargins(8, 2, 8, 2);
  }
  m_stale->hide();
  m_tests->setModel(m_testTable);
  m_tests->setSelectionMode(QAbstractItemView::SingleSelection);
  m_tests->setMinimumHeight(scaled(52));
  m_sorted->setSourceModel(m_stateTable);
  m_sorted->setSortRole(sortRole);
  m_rows->setModel(m_sorted);
  m_rows->setMinimumHeight(scaled(52));
  m_rows->setSortingEnabled(true);
  m_rows->horizontalHeader()->setSortIndicatorClearable(true);  // by a third click
  m_heading->setObjectName("reportHeading");
  auto* filter = new QLineEdit;
  filter->setObjectName("reportFilter");
  filter->setClearButtonEnabled(true);
  filter->setMaximumWidth(scaled(240));
  filter->setPlaceholderText(tr("Filter: lens, σ < 0.5, angle > 20"));
  filter->setToolTip(
      tr("A part of a name, a column, or a column with < > = ≤ ≥ and a number; commas join them"));
  connect(filter, &QLineEdit::textChanged, m_sorted, &StateFilter::setText);
  auto* states = new QWidget;
  auto* head = new QHBoxLayout;
  head->setContentsMargins(8, 4, 8, 4);
  head->addWidget(m_heading, 1);
  head->addWidget(filter, 1);
  auto* layout = new QVBoxLayout(states);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addLayout(head);
  layout->addWidget(m_rows, 1);
  layout->addWidget(m_stale);
  layout->addWidget(m_note);
  auto* tables = new QSplitter(Qt::Vertical);
  tables->addWidget(m_tests);
  tables->addWidget(states);
  tables->setChildrenCollapsible(false);
  tables->setSizes({200, 400});
  return tables;
}

void ReportDock::connectAll() {
  connect(m_tests->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            if (current.isValid()) chooseTest(std::size_t(current.row()));
          });
  connect(m_tests, &QTableView::clicked, this, [this](const QModelIndex& index) {
    if (index.column() >= TestTable::worst) chooseExtreme(index.column() == TestTable::best);
  });
  connect(m_rows->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &ReportDock::showChosen);
  connect(m_plots, &ReportPlots::rowClicked, this, &ReportDock::chooseRow);
  connect(m_plots, &ReportPlots::testClicked, this,
          [this](std::size_t test) { m_tests->selectRow(int(test)); });
  connect(m_plots, &ReportPlots::compareAsked, this, &ReportDock::compare);
  connect(m_progress, &QProgressBar::valueChanged, this, [this] {
    const std::string left = timeLeft(double(m_clock.elapsed()) / 1000, m_task->share());
    m_progress->setFormat("%p % " + QString::fromStdString(left));
  });
  connect(m_task, &Task::stopped, this, [this] {
    showIdle();
    m_note->setText(tr("Stopped. What is finished is kept: the same report goes on from there."));
  });
  connect(m_task, &Task::failed, this, [this](const QString& line) {
    m_testsButton->setChecked(true);
    showIdle();
    m_note->setText(line);
    Q_EMIT failed(line);
  });
}

void ReportDock::setModel(SessionModel* model, QMenu* fileMenu, QMenu* statesMenu) {
  m_model = model;
  connect(model, &SessionModel::opened, this, [this] {
    forget();
    setFolder(folderBeside(*m_model));
  });
  connect(model, &SessionModel::edited, this, &ReportDock::noteEdits);
  connect(model, &SessionModel::statesChanged, this, &ReportDock::noteEdits);
  connect(model, &SessionModel::currentChanged, this, &ReportDock::followSession);
  m_openButton->setDefaultAction(
      addCommand(fileMenu,
                 {"openReportAction", tr("Open &report…"),
                  tr("Shows a report that was made before, without rendering"),
                  Qt::CTRL | Qt::ALT | Qt::Key_R, tr("Open a report…")},
                 this, [this] {
                   const QString folder = chooseFolder(this, tr("Open a report"));
                   if (!folder.isEmpty()) openReport(folder);
                 }));
  m_openButton->defaultAction()->setIcon(icon("folder"));
  m_worstButton->setDefaultAction(addCommand(
      statesMenu,
      {"worstStateAction", tr("&Worst of the report"),
       tr("Compares the state with the lowest PSNR of the report's chosen test in the view"),
       Qt::CTRL | Qt::ALT | Qt::Key_W, tr("Worst")},
      this, [this] { chooseExtreme(false); }));
  m_worstButton->defaultAction()->setIcon(icon("down"));
  m_bestButton->setDefaultAction(addCommand(
      statesMenu,
      {"bestStateAction", tr("&Best of the report"),
       tr("Compares the state with the highest PSNR of the report's chosen test in the view"),
       Qt::CTRL | Qt::ALT | Qt::Key_B, tr("Best")},
      this, [this] { chooseExtreme(true); }));
  m_bestButton->defaultAction()->setIcon(icon("up"));
  showAll();
  showIdle();
}

/// Removes rows of another session and stops a running report.
void ReportDock::forget() {
  if (m_task->isRunning()) stop();
  m_data = ReportData();
  m_testsButton->setChecked(true);
  m_note->clear();
  m_stale->hide();
  showAll();
  showIdle();
}

void ReportDock::noteEdits() {
  if (m_data.rows.empty()) return showIdle();
  if (m_data.isRead) return;
  const auto stateName = [](const CameraState& state) { return state.camera.name; };
  if (!std::ranges::equal(m_data.session.cameras, m_model->session().cameras, {}, stateName,
                          stateName))
    return forget();
  m_stale->setVisible(m_data.session != m_model->session());
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

void ReportDock::setFolder(const QString& folder) {
  m_folder->setText(folder);
}

void ReportDock::openPage() {
  const QString page = QString::fromStdString(m_data.folder) + "/report.html";
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(page)))
    Q_EMIT failed(tr("%1: no web browser could be started for it").arg(page));
}

void ReportDock::makeOrStop() {
  if (m_task->isRunning()) return stop();
  try {
    start();
  } catch (const InputError& error) {
    m_note->setText(error.what());
    Q_EMIT failed(error.what());
  }
}

void ReportDock::start() {
  ReportData made{m_model->session(), m_folder->text().toStdString()};
  made.metrics = metricsOf(made.session.metrics);
  for (int k = 0; k < m_testList->count(); ++k)
    made.tests.push_back(m_testList->item(k)->text().toStdString());
  made.begin();
  m_data = made;
  ReportRequest request;
  request.session = made.session;
  request.metrics = made.metrics;
  const bool isEdited = m_model->isModified() || m_model->file().isEmpty();
  request.name = nameOf(*m_model);
  if (!isEdited) request.sessionFile = m_model->file().toStdString();
  request.output = made.folder;
  request.command = "made in the window" + (isEdited ? ", from " + request.name : "");
  request.reference = m_reference;
  m_note->clear();
  m_stale->hide();
  m_test = 0;
  m_testsButton->setChecked(false);
  showAll();
  m_makeButton->setText(tr("&Stop"));
  m_clock.start();
  m_task->start(
      [this, task = m_task, request, tests = made.tests](const Progress& progress) mutable {
        ReportListener listener;
        listener.progress = progress;
        listener.finished = [=, this](std::size_t index, const ReportRow& row) {
          task->queue([this, index, row] { showRow(index, row); });
        };
        request.tests = openTests(request.session, tests);
        std::vector<std::optional<double>> rates;
        for (const ReportTest& test : request.tests) rates.push_back(rateOfFiles(test));
        return [this, rates, report = makeReport(request, listener)] { finish(report, rates); };
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
  m_makeButton->setText(m_data.rows.empty() ? tr("&Make report") : tr("&Make again"));
  m_makeButton->setEnabled(m_model != nullptr && !m_model->session().cameras.empty() &&
                           m_testList->count() > 0);
  m_progress->setVisible(false);
}

void ReportDock::finish(const Report& report, const std::vector<std::optional<double>>& rates) {
  showIdle();
  if (m_data.rows.empty()) return;  // rows of another session
  m_data.rows = report.rows;
  m_data.summaries = report.summaries;
  m_data.panels = report.panels;
  for (std::size_t k = 0; k < rates.size(); ++k)
    m_data.plotted[k].rate = rates[k].value_or(std::numeric_limits<double>::quiet_NaN());
  showAll();
  compare();
}

void ReportDock::openReport(const QString& folder) {
  if (m_task->isRunning()) return;
  try {
    ReportData made{m_model->session(), folder.toStdString(), true};
    made.metrics = metricsOf(made.session.metrics);
    m_task->start([this, made](const Progress&) {
      const StoredReport stored = readReport(made.folder, made.metrics);
      return [this, made, stored, rates = ratesOf(made.session, testsOf(stored.rows))] {
        showRead(stored, made, rates);
      };
    });
  } catch (const InputError& error) {
    Q_EMIT failed(error.what());
  }
}

/// The states that the session does not have are there with their name and eye.
void ReportDock::showRead(const StoredReport& stored, const ReportData& empty,
                          const std::vector<std::optional<double>>& rates) {
  ReportData made = empty;
  made.tests = testsOf(stored.rows);
  made.session.cameras.clear();
  for (std::size_t row = 0; row < stored.rows.size(); row += made.tests.size()) {
    CameraState state;
    for (const CameraState& known : m_model->session().cameras)
      if (known.camera.name == stored.rows[row].state) state = known;
    state.camera.name = stored.rows[row].state;
    state.camera.eye = stored.rows[row].eye;
    made.session.cameras.push_back(state);
  }
  made.begin();
  made.rows = stored.rows;
  made.summaries = summariseTests(made.rows, made.metrics);
  for (std::size_t k = 0; k < made.tests.size(); ++k) {
    const auto known = std::ranges::find(stored.rates, made.tests[k], &TestRate::test);
    made.plotted[k].rate = known != stored.rates.end()
                               ? known->rate
                               : rates[k].value_or(std::numeric_limits<double>::quiet_NaN());
  }
  m_data = made;
  m_test = 0;
  m_stale->hide();
  m_testsButton->setChecked(false);
  showAll();
  showIdle();
}

/// Sets the columns' widths, which the user may change.
void ReportDock::sizeColumns() {
  m_tests->setColumnWidth(TestTable::name, scaled(130));
  for (const int column : {TestTable::rate, TestTable::psnr, TestTable::ssim})
    m_tests->setColumnWidth(column, scaled(76));
  m_tests->setColumnWidth(TestTable::bar, scaled(170));
  m_tests->horizontalHeader()->setStretchLastSection(true);
  const std::array widths{112, 112, 64, 64, 62, 64, 56, 88, 70};
  for (int k = StateTable::name; k < StateTable::plugins; ++k)
    m_rows->setColumnWidth(k, scaled(widths.at(std::size_t(k))));
}

/// Fills tables and plots. The chosen test stays, and the current state is chosen.
void ReportDock::showAll() {
  m_follows = true;
  m_testTable->fill(m_data);
  m_test = std::min(m_test, m_data.tests.empty() ? 0 : m_data.tests.size() - 1);
  m_tests->selectRow(int(m_test));
  chooseTest(m_test);
  m_follows = false;
  m_pageButton->setEnabled(!m_data.summaries.empty());
  for (QToolButton* button : {m_worstButton, m_bestButton})
    if (button->defaultAction() != nullptr)
      button->defaultAction()->setEnabled(!m_data.summaries.empty());
  showNote();
}

void ReportDock::showNote() {
  if (m_data.summaries.empty()) return;
  QStringList texts;
  for (std::size_t k = 0; k < m_data.tests.size(); ++k)  // the last summary is of all tests
    texts << QString::fromStdString(
        m_data.plotted[k].name + "\n" +
        summaryText(m_data.summaries[k].summary, m_data.summaries[k].rows));
  m_note->setToolTip(texts.join("\n"));
  m_note->setText(tr("%1 states × %2 tests. PSNR and SSIM of a test: mean of the finite values.")
                      .arg(m_data.session.cameras.size())
                      .arg(m_data.tests.size()));
}

void ReportDock::showRow(std::size_t index, const ReportRow& row) {
  if (index >= m_data.rows.size()) return;
  m_data.rows[index] = row;
  const std::size_t test = m_data.order().test(index);
  m_testTable->fill(m_data, test);
  if (test != m_test) return;
  m_stateTable->fill(m_data, test, m_data.order().state(index));
  m_plots->showTest(m_test, chosenState());
  emitPsnr();
}

void ReportDock::emitPsnr() {
  std::vector<double> dB;
  if (!m_data.rows.empty()) {
    dB.assign(m_model->session().cameras.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t state = 0; state < m_data.session.cameras.size(); ++state)
      if (const auto index = inSession(state))
        dB[*index] = m_data.psnr(m_data.order().row(state, m_test));
  }
  if (std::ranges::all_of(dB, [](double value) { return std::isnan(value); })) dB.clear();
  Q_EMIT psnrChanged(dB);
}

std::optional<std::size_t> ReportDock::chosenState() const {
  const QModelIndex current = m_sorted->mapToSource(m_rows->currentIndex());
  if (!current.isValid()) return std::nullopt;
  return std::size_t(current.row());
}

std::optional<std::size_t> ReportDock::inSession(std::size_t state) const {
  const std::vector<CameraState>& states = m_model->session().cameras;
  const std::string& name = m_data.session.cameras[state].camera.name;
  if (state < states.size() && states[state].camera.name == name) return state;
  for (std::size_t k = 0; k < states.size(); ++k)
    if (states[k].camera.name == name) return k;
  return std::nullopt;
}

/// Shows the states of a test, the current one chosen.
void ReportDock::chooseTest(std::size_t test) {
  m_test = test;
  const std::optional<std::size_t> state = chosenState();
  const bool wasFollowing = std::exchange(m_follows, true);
  m_stateTable->fill(m_data, test);
  m_heading->setText(
      m_data.tests.empty()
          ? QString()
          : tr("<b>%1</b> %n states", "", int(m_data.session.cameras.size()))
                .arg(QString::fromStdString(m_data.plotted[test].name).toHtmlEscaped()));
  if (state && *state < m_data.session.cameras.size()) chooseState(*state);
  if (!chosenState()) followSession();
  m_follows = wasFollowing;
  m_plots->showTest(m_test, chosenState());
  if (m_model != nullptr) emitPsnr();
  if (!m_follows && !m_data.tests.empty()) compare();
}

void ReportDock::chooseState(std::size_t state) {
  // selectRow() would add to the selection while a command's Ctrl is down.
  m_rows->selectionModel()->setCurrentIndex(
      m_sorted->mapFromSource(m_stateTable->index(int(state), 0)),
      QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

void ReportDock::chooseRow(std::size_t row) {
  m_tests->selectRow(int(m_data.order().test(row)));
  chooseState(m_data.order().state(row));
}

void ReportDock::chooseExtreme(bool isBest) {
  const std::optional<std::size_t> state = m_data.extreme(m_test, isBest);
  if (!state) return;
  chooseState(*state);
  compare();
}

/// Chooses the row of the session's current state.
void ReportDock::followSession() {
  if (m_model == nullptr || m_data.rows.empty()) return;
  for (std::size_t state = 0; state < m_data.session.cameras.size(); ++state)
    if (inSession(state) == m_model->currentIndex() && chosenState() != state) {
      const bool wasFollowing = std::exchange(m_follows, true);
      chooseState(state);
      m_follows = wasFollowing;
    }
}

void ReportDock::showChosen() {
  const std::optional<std::size_t> state = chosenState();
  if (!state || m_data.tests.empty()) return;
  m_plots->showTest(m_test, state);
  if (!m_follows) compare();
  if (const auto index = inSession(*state)) m_model->setCurrentIndex(*index);
}

/// A report that was read may outlive its tests.
void ReportDock::compare() {
  const QString file = QString::fromStdString(m_data.tests[m_test]);
  if (!m_data.isRead || QFileInfo::exists(file)) Q_EMIT comparisonAsked(file);
}

void ReportDock::resizeEvent(QResizeEvent*) {
  const bool isWide = width() >= scaled(wide);
  m_plots->setVisible(isWide);
  for (int k = 0; k < m_tools->count(); ++k)
    if (auto* button = qobject_cast<QToolButton*>(m_tools->itemAt(k)->widget()))
      button->setToolButtonStyle(isWide ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
}

/// The tables' marks and links have colours of the scheme.
void ReportDock::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) showAll();
  QWidget::changeEvent(event);
}

}  // namespace hogelscope
