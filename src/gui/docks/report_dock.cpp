// SPDX-License-Identifier: BSD-3-Clause
#include "gui/docks/report_dock.h"

#include <QDesktopServices>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QMenu>
#include <QUrl>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/error.h"
#include "core/cameras/frame_states.h"
#include "core/metrics/flicker.h"
#include "core/optics/eyes.h"
#include "gui/docks/report_plots.h"
#include "gui/session/session_forms.h"
#include "gui/session/session_model.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/command.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/task_widgets.h"
#include "io/plugins/metric_plugins.h"
#include "io/plugins/plugin_list.h"
#include "report/page/report_tables.h"
#include "report/report_frames.h"
#include "report/report_run.h"
#include "report/test_orders.h"
#include "ui_report_dock.h"

namespace hogelscope {

namespace {

/// Returns the session's name for the report's heading.
std::string nameOf(const SessionModel& model) {
  const std::string file = QFileInfo(model.file()).fileName().toStdString();
  if (file.empty()) return "an untitled session";
  return model.isModified() ? file + " with unsaved changes" : file;
}

/// Returns what is said of the order of the tests' views.
QStringList ordersOf(const std::vector<ReportTest>& tests) {
  QStringList orders;
  for (const ReportTest& test : tests)
    if (!test.order.empty())
      orders << QFileInfo(QString::fromStdString(test.name)).fileName() + ": " +
                    QString::fromStdString(test.order) + ".";
  return orders;
}

/// Returns a folder named after the session or, if it has no file yet, after its light field.
QString folderBeside(const SessionModel& model) {
  const QString lightField = QString::fromStdString(contentName(model.session().lightField));
  const QFileInfo info(QDir::cleanPath(model.file().isEmpty() ? lightField : model.file()));
  return info.path() + "/" + info.completeBaseName() + "-report";
}

/// The narrowest dock that has plots beside the tables, and texts on the buttons.
constexpr int wide = 700;

}  // namespace

ReportDock::ReportDock(QWidget* parent)
    : QWidget(parent),
      m_ui(std::make_unique<Ui::ReportDock>()),
      m_task(new Task(this)),
      m_reading(new Task(this)),
      m_testTable(new TestTable(this)),
      m_stateTable(new StateTable(this)),
      m_sorted(new FilteredRows(
          m_stateTable, [this](int row, std::size_t k) { return m_stateTable->numberOf(row, k); })),
      m_plots(new ReportPlots(m_data)),
      m_empty(
          new QLabel(tr("A report renders every state from the session's light field and from "
                        "each test, and compares the two.\n\nAdd what a codec made of the light "
                        "field as a test, then make the report."))) {
  setMinimumWidth(scaled(360));  // less than the plots need, which are then hidden
  m_ui->setupUi(this);
  m_ui->testList->setMaximumHeight(scaled(72));
  m_ui->reportFilter->setMaximumWidth(scaled(240));
  m_ui->parts->addWidget(m_plots);
  m_empty->setObjectName("reportEmpty");
  m_empty->setAlignment(Qt::AlignCenter);
  m_empty->setWordWrap(true);
  m_empty->setMargin(scaled(40));
  layout()->addWidget(m_empty);
  m_ui->parts->setSizes({812, 577});
  m_ui->tables->setSizes({200, 400});
  QSizePolicy kept = m_ui->addComparedButton->sizePolicy();
  kept.setRetainSizeWhenHidden(true);  // so that the buttons do not move
  m_ui->addComparedButton->setSizePolicy(kept);
  m_ui->testTable->setModel(m_testTable);
  m_sorted->setSortRole(sortRole);
  m_ui->reportTable->setModel(m_sorted);
  m_ui->reportTable->setSortingEnabled(true);
  m_ui->reportTable->horizontalHeader()->setSortIndicatorClearable(true);  // by a third click
  connectTools();
  connectTables();
  showAll();
  sizeColumns();
  m_ui->reportTable->sortByColumn(StateTable::psnr, Qt::AscendingOrder);  // worst first
  showIdle();
}

ReportDock::~ReportDock() = default;

void ReportDock::connectTools() {
  m_ui->testsButton->setIcon(icon("new"));
  m_ui->openPageButton->setIcon(icon("external"));
  m_ui->copyTableButton->setIcon(icon("copy_table"));
  m_ui->metricsButton->setIcon(icon("ruler"));
  auto* metrics = new QMenu(this);
  metrics->setToolTipsVisible(true);
  m_ui->metricsButton->setMenu(metrics);
  connect(metrics, &QMenu::aboutToShow, this, [this, metrics] { fillMetrics(metrics); });
  m_ui->makeReportButton->control(m_task, [this] { make(); });
  connect(m_ui->openPageButton, &QToolButton::clicked, this, &ReportDock::openPage);
  connect(m_ui->copyTableButton, &QToolButton::clicked, this,
          [this] { m_ui->reportTable->copy(true); });
  connect(m_ui->addTestButton, &QPushButton::clicked, this, [this] {
    for (const QString& file :
         chooseFiles(this, tr("Add test light fields"), lightFieldFilter(sessionPatterns)))
      addTest(file);
  });
  connect(m_ui->addTestFolderButton, &QPushButton::clicked, this, [this] {
    const QString folder = chooseFolder(this, tr("Add a folder of views"));
    if (!folder.isEmpty()) addTest(folder);
  });
  connect(m_ui->reportFolderButton, &QPushButton::clicked, this, [this] {
    const QString folder = chooseOutputFolder(this, tr("Folder of the report"));
    if (!folder.isEmpty()) setFolder(folder);
  });
  connect(m_ui->addComparedButton, &QPushButton::clicked, this, [this] {
    addTest(m_offered);
    m_ui->makeReportButton->setFocus();  // the button hides, and Qt would choose the next field
  });
  connect(m_ui->removeTestButton, &QPushButton::clicked, this, [this] {
    delete m_ui->testList->currentItem();
    showIdle();
  });
  auto* progress = new PolledBar(m_task);
  progress->setObjectName("reportProgress");
  m_ui->tools->insertWidget(m_ui->tools->indexOf(m_ui->openReportButton) + 1, progress);
  connect(progress, &QProgressBar::valueChanged, this, [this, progress] {
    const std::string left = timeLeft(double(m_clock.elapsed()) / 1000, m_task->share());
    progress->setFormat("%p % " + QString::fromStdString(left));
  });
  connect(m_reading, &Task::failed, this, &ReportDock::showFailure);
  connect(m_task, &Task::runningChanged, this, &ReportDock::showIdle);
  connect(m_task, &Task::stopped, this, [this] {
    m_ui->reportNote->setText(
        tr("Stopped. What is finished is kept: the same report goes on from there."));
  });
  connect(m_task, &Task::failed, this, &ReportDock::showFailure);
}

void ReportDock::connectTables() {
  connect(m_ui->testTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            if (current.isValid()) chooseTest(std::size_t(current.row()));
          });
  connect(m_ui->testTable, &QTableView::clicked, this, [this](const QModelIndex& index) {
    if (index.column() >= TestTable::worst) chooseExtreme(index.column() == TestTable::best);
  });
  connect(m_ui->reportTable->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &ReportDock::showChosen);
  connect(m_ui->reportFilter, &QLineEdit::textChanged, m_sorted,
          [this](const QString& text) { m_sorted->setFilter(m_stateTable->filterOf(text)); });
  connect(m_plots, &ReportPlots::rowClicked, this, &ReportDock::chooseRow);
  connect(m_plots, &ReportPlots::testClicked, this,
          [this](std::size_t test) { m_ui->testTable->selectRow(int(test)); });
  connect(m_plots, &ReportPlots::compareAsked, this, &ReportDock::compare);
}

void ReportDock::setModel(SessionModel* model, QMenu* fileMenu, QMenu* statesMenu) {
  m_model = model;
  connect(model, &SessionModel::opened, this, [this] {
    forget();
    setFolder(folderBeside(*m_model));
  });
  connect(model, &SessionModel::edited, this, &ReportDock::noteEdits);
  connect(model, &SessionModel::statesChanged, this, &ReportDock::noteEdits);
  connect(model, &SessionModel::contentChanged, this, &ReportDock::noteEdits);
  connect(model, &SessionModel::currentChanged, this, &ReportDock::followSession);
  const auto add = [this](QToolButton* button, const char* image, QMenu* menu,
                          const CommandText& text, auto slot) {
    button->setDefaultAction(addCommand(menu, text, this, slot));
    button->defaultAction()->setIcon(icon(image));
  };
  add(m_ui->openReportButton, "folder", fileMenu,
      {"openReportAction", tr("Open &report…"),
       tr("Shows a report that was made before, without rendering"), Qt::CTRL | Qt::ALT | Qt::Key_R,
       tr("Open a report…")},
      [this] {
        const QString folder = chooseFolder(this, tr("Open a report"));
        if (!folder.isEmpty()) openReport(folder);
      });
  add(m_ui->worstStateButton, "down", statesMenu,
      {"worstStateAction", tr("&Worst of the report"),
       tr("Compares the state with the lowest PSNR of the report's chosen test in the view"),
       Qt::CTRL | Qt::ALT | Qt::Key_W, tr("Worst")},
      [this] { chooseExtreme(false); });
  add(m_ui->bestStateButton, "up", statesMenu,
      {"bestStateAction", tr("&Best of the report"),
       tr("Compares the state with the highest PSNR of the report's chosen test in the view"),
       Qt::CTRL | Qt::ALT | Qt::Key_B, tr("Best")},
      [this] { chooseExtreme(true); });
  showAll();
  showIdle();
}

/// Lists the metrics of plugins; those of the session are checked, with one that is not installed.
void ReportDock::fillMetrics(QMenu* menu) {
  menu->clear();
  const std::vector<std::string>& chosen = m_model->session().metrics;
  std::vector<std::pair<std::string, std::string>> metrics;  // and why one cannot be used
  for (const FoundPlugin& plugin : listPlugins())
    if (std::ranges::find(plugin.kinds, PluginKind::metric) != plugin.kinds.end())
      metrics.emplace_back(plugin.name, plugin.refusal);
  for (const std::string& name : chosen)
    if (std::ranges::find(metrics, name, &std::pair<std::string, std::string>::first) ==
        metrics.end())
      metrics.emplace_back(name, "");
  for (const auto& [name, refusal] : metrics) {
    QAction* action = menu->addAction(QString::fromStdString(name));
    action->setCheckable(true);
    action->setChecked(std::ranges::find(chosen, name) != chosen.end());
    action->setEnabled(refusal.empty() || action->isChecked());
    action->setToolTip(QString::fromStdString(refusal));
    connect(action, &QAction::toggled, this, [this, name = name](bool isOn) {
      m_model->edit(tr("Change metrics"), [&](Session& session) {
        std::erase(session.metrics, name);
        if (isOn) session.metrics.push_back(name);
      });
    });
  }
  if (metrics.empty()) menu->addAction(tr("No metrics are installed"))->setEnabled(false);
}

/// Removes rows of another session and stops a running report.
void ReportDock::forget() {
  if (m_task->isRunning()) m_ui->makeReportButton->stop();
  m_reading->abandon();
  m_data = ReportData();
  m_ui->testsButton->setChecked(true);
  m_ui->reportNote->clear();
  m_ui->reportStale->hide();
  showAll();
  showIdle();
}

void ReportDock::noteEdits() {
  if (m_data.rows.empty()) return showIdle();
  if (m_data.isRead) return emitPsnr();
  const auto stateName = [](const CameraState& state) { return state.camera.name; };
  const Session now = withEyes(m_model->session());
  if (!std::ranges::equal(m_data.session.cameras, now.cameras, {}, stateName, stateName))
    return forget();
  m_ui->reportStale->setVisible(m_data.session != now);
  emitPsnr();
}

void ReportDock::addTest(const QString& file) {
  m_ui->testList->addItem(file);
  m_ui->testList->setCurrentRow(m_ui->testList->count() - 1);
  showIdle();
}

void ReportDock::offerTest(const QString& file) {
  m_offered = file;
  showOffer();
}

/// Offers a test unless it is in the list already.
void ReportDock::showOffer() {
  const bool isNew = m_ui->testList->findItems(m_offered, Qt::MatchExactly).isEmpty();
  m_ui->addComparedButton->setVisible(!m_offered.isEmpty() && isNew);
  m_ui->addComparedButton->setText(
      tr("A&dd %1").arg(QFileInfo(m_offered).fileName().replace('&', "&&")));
}

void ReportDock::setFolder(const QString& folder) {
  m_ui->reportFolder->setText(folder);
  showIdle();
}

void ReportDock::openPage() {
  const QString page = QString::fromStdString(m_data.folder) + "/report.html";
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(page)))
    Q_EMIT failed(tr("%1: no web browser could be started for it").arg(page));
}

void ReportDock::showFailure(const QString& line) {
  m_ui->testsButton->setChecked(true);
  m_ui->reportNote->setText(line);
  Q_EMIT failed(line);
}

/// Returns the number of states of a report in the folder that this window has not made; 0 if there
/// is none. A report that was stopped goes on, and replaces nothing.
int ReportDock::statesInFolder() const {
  const std::string folder = m_ui->reportFolder->text().toStdString();
  if (!m_data.rows.empty() && !m_data.isRead && m_data.folder == folder) return 0;
  try {
    const StoredReport stored = readReport(folder, MetricSet());
    std::set<std::string> states;
    for (const ReportRow& row : stored.rows) states.insert(row.state);
    return int(states.size());
  } catch (const InputError&) {
    return 0;
  }
}

void ReportDock::make() {
  if (const int states = m_isReplacing ? 0 : statesInFolder(); states > 0) {
    m_isReplacing = true;
    m_ui->makeReportButton->setIdle(tr("Replace report of %n states", "", states), true);
    m_ui->reportNote->setText(
        tr("%1 has a report already: click again to replace it, or choose another folder.")
            .arg(m_ui->reportFolder->text()));
    m_ui->testsButton->setChecked(true);
    return;
  }
  try {
    start();
  } catch (const InputError& error) {
    m_ui->reportNote->setText(error.what());
    Q_EMIT failed(error.what());
  }
}

void ReportDock::start() {
  m_reading->abandon();
  ReportData made{withEyes(m_model->session()), m_ui->reportFolder->text().toStdString()};
  made.metrics = metricsOf(made.session.metrics);
  for (int k = 0; k < m_ui->testList->count(); ++k)
    made.tests.push_back(m_ui->testList->item(k)->text().toStdString());
  ReportRequest request;
  request.session = made.session;
  if (!m_frames.isStill()) {
    made.metrics = metricsOf(made.session.metrics, {flickerMetric()});
    const auto views = statesAtFrames(made.session.cameras, m_frames, m_frames, m_frameRate);
    made.session.cameras.clear();
    for (const auto& [state, frame] : views) {
      made.session.cameras.push_back(state);
      made.frames.push_back(frame);
    }
  }
  made.begin();
  m_data = made;
  request.metrics = made.metrics;
  const bool isEdited = m_model->isModified() || m_model->file().isEmpty();
  request.name = nameOf(*m_model);
  if (!isEdited) request.sessionFile = m_model->file().toStdString();
  request.output = made.folder;
  request.hasRelativeNames = true;
  request.command = "made in the window" + (isEdited ? ", from " + request.name : "");
  const bool isAsDesigned = !m_reference || m_reference->twin == nullptr;
  if (isAsDesigned == made.session.twin.isZero()) request.reference = m_reference;
  m_ui->reportNote->clear();
  m_ui->reportStale->hide();
  m_test = 0;
  m_ui->testsButton->setChecked(false);
  showAll();
  m_clock.start();
  m_task->start([this, task = m_task, request, tests = made.tests, areFrames = !made.frames.empty(),
                 views = made.session.cameras.size()](const Progress& progress) mutable {
    ReportListener listener;
    listener.progress = part(progress, 0.02, 1);
    listener.finished = [=, this](std::size_t index, const ReportRow& row) {
      task->queue([this, index, row] { showRow(index, row); });
    };
    request.file = openLightField(request.session.lightField, request.session.display);
    request.tests = openTests(request.session, tests);
    std::vector<std::optional<double>> rates;
    orderTests(request, part(progress, 0, 0.02));
    for (const ReportTest& test : request.tests) rates.push_back(rateOfFiles(test));
    if (areFrames) takeFrames(request, {});
    if (request.session.cameras.size() != views)
      throw InputError(contentName(request.session.lightField), "has other frames than before",
                       "open it again");
    return [this, rates, orders = ordersOf(request.tests), report = makeReport(request, listener)] {
      finish(report, rates);
      if (!orders.isEmpty())
        m_ui->reportNote->setText(m_ui->reportNote->text() + "\n" + orders.join("\n"));
    };
  });
}

/// Shows what can be done, except while a report is generated.
void ReportDock::showIdle() {
  showOffer();
  m_isReplacing = false;
  const bool isEmpty = m_data.rows.empty();
  m_empty->setVisible(isEmpty);
  m_ui->parts->setVisible(!isEmpty);
  m_ui->makeReportButton->setIdle(
      m_data.rows.empty() ? tr("&Make report") : tr("&Make again"),
      m_model != nullptr && !m_model->session().cameras.empty() && m_ui->testList->count() > 0);
}

void ReportDock::finish(const Report& report, const std::vector<std::optional<double>>& rates) {
  if (m_data.rows.empty()) return;  // rows of another session
  m_data.rows = report.rows;
  m_data.summaries = report.summaries;
  m_data.panels = report.panels;
  m_data.setRates(rates);
  showAll();
  compare();
}

void ReportDock::openReport(const QString& folder) {
  if (m_task->isRunning() || m_reading->isRunning()) return;
  try {
    ReportData made{m_model->session(), folder.toStdString(), true};
    made.metrics = metricsOf(made.session.metrics);
    m_reading->start([this, made](const Progress&) mutable {
      made.take(readReport(made.folder, made.metrics));
      return [this, made] { showRead(made); };
    });
  } catch (const InputError& error) {
    Q_EMIT failed(error.what());
  }
}

void ReportDock::showRead(const ReportData& read) {
  m_data = read;
  m_test = 0;
  m_ui->reportStale->hide();
  m_ui->testsButton->setChecked(false);
  showAll();
  showIdle();
}

/// Sets the columns' widths, which the user may change.
void ReportDock::sizeColumns() {
  m_ui->testTable->setColumnWidth(TestTable::name, scaled(130));
  for (const int column : {TestTable::rate, TestTable::psnr, TestTable::ssim})
    m_ui->testTable->setColumnWidth(column, scaled(80));
  m_ui->testTable->setColumnWidth(TestTable::bar, scaled(196));
  m_ui->testTable->horizontalHeader()->setStretchLastSection(true);
  const std::array widths{96, 112, 64, 76, 64, 76, 56, 104, 72};
  for (int k = StateTable::name; k < StateTable::plugins; ++k)
    m_ui->reportTable->setColumnWidth(k, scaled(widths.at(std::size_t(k))));
}

/// Fills tables and plots. The chosen test stays, and the current state is chosen.
void ReportDock::showAll() {
  m_follows = true;
  m_testTable->fill(m_data);
  m_test = std::min(m_test, m_data.tests.empty() ? 0 : m_data.tests.size() - 1);
  m_ui->testTable->selectRow(int(m_test));
  chooseTest(m_test);
  m_follows = false;
  m_ui->openPageButton->setEnabled(!m_data.summaries.empty());
  for (QToolButton* button : {m_ui->worstStateButton, m_ui->bestStateButton})
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
  m_ui->reportNote->setToolTip(texts.join("\n"));
  m_ui->reportNote->setText(
      tr("%1 states × %2 tests. PSNR and SSIM of a test: mean of the finite values.")
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

/// Whether a state of the report, or what it saw, has been edited since; `now` has both eyes of its
/// states. Of a report that was read only the eyes' places are known.
bool ReportDock::isStale(std::size_t state, const Session& now) const {
  const auto& [name, eye] = std::tie(m_data.session.cameras[state].camera.name,
                                     m_data.rows[m_data.order().row(state, m_test)].eye);
  const auto own = std::ranges::find_if(
      now.cameras, [&](const CameraState& each) { return each.camera.name == name; });
  if (own == now.cameras.end()) return false;
  if (m_data.isRead) return length(own->camera.eye - eye) > 1e-6;
  return *own != m_data.session.cameras[state];
}

void ReportDock::emitPsnr() {
  std::vector<double> dB;
  std::vector<bool> stale;
  if (!m_data.rows.empty()) {
    const Session now = withEyes(m_model->session());
    Session measured = m_data.session;
    measured.cameras = now.cameras;
    measured.metrics = now.metrics;
    dB.assign(m_model->session().cameras.size(), std::numeric_limits<double>::quiet_NaN());
    stale.assign(dB.size(), !m_data.isRead && measured != now);
    for (std::size_t state = 0; state < m_data.session.cameras.size(); ++state)
      if (const auto index = m_data.stateIn(m_model->session(), state)) {
        // The worse one of two eyes; NaN gives way.
        dB[*index] = std::fmin(dB[*index], m_data.psnr(m_data.order().row(state, m_test)));
        if (isStale(state, now)) stale[*index] = true;
      }
  }
  if (std::ranges::all_of(dB, [](double value) { return std::isnan(value); })) dB.clear();
  Q_EMIT psnrChanged(dB, stale);
}

std::optional<std::size_t> ReportDock::chosenState() const {
  const QModelIndex current = m_sorted->mapToSource(m_ui->reportTable->currentIndex());
  if (!current.isValid()) return std::nullopt;
  return std::size_t(current.row());
}

/// Shows the states of a test, the current one chosen.
void ReportDock::chooseTest(std::size_t test) {
  m_test = test;
  const std::optional<std::size_t> state = chosenState();
  const bool wasFollowing = std::exchange(m_follows, true);
  m_stateTable->fill(m_data, test);
  m_ui->reportHeading->setText(
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
  m_ui->reportTable->selectionModel()->setCurrentIndex(
      m_sorted->mapFromSource(m_stateTable->index(int(state), 0)),
      QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

void ReportDock::chooseRow(std::size_t row) {
  m_ui->testTable->selectRow(int(m_data.order().test(row)));
  chooseState(m_data.order().state(row));
}

void ReportDock::chooseExtreme(bool isBest) {
  const std::optional<std::size_t> state = m_data.extreme(m_test, isBest);
  if (!state) return;
  chooseState(*state);
  compare();
}

/// Chooses a row of the session's current state, unless one of it is chosen.
void ReportDock::followSession() {
  if (m_model == nullptr || m_data.rows.empty()) return;
  const auto isCurrent = [this](std::size_t state) {
    return m_data.stateIn(m_model->session(), state) == m_model->currentIndex();
  };
  if (const auto chosen = chosenState(); chosen && isCurrent(*chosen)) return;
  for (std::size_t state = 0; state < m_data.session.cameras.size(); ++state)
    if (isCurrent(state)) {
      const bool wasFollowing = std::exchange(m_follows, true);
      chooseState(state);
      m_follows = wasFollowing;
      return;
    }
}

void ReportDock::showChosen() {
  const std::optional<std::size_t> state = chosenState();
  if (!state || m_data.tests.empty()) return;
  m_plots->showTest(m_test, state);
  if (!m_follows) compare();
  if (const auto index = m_data.stateIn(m_model->session(), *state))
    m_model->setCurrentIndex(*index);
  if (const auto frame = m_data.rows[m_data.order().row(*state, m_test)].frame)
    Q_EMIT frameChosen(*frame);
}

/// A report that was read may outlive its tests.
void ReportDock::compare() {
  const QString file = QString::fromStdString(m_data.tests[m_test]);
  if (!m_data.isRead || QFileInfo::exists(file)) Q_EMIT comparisonAsked(file);
}

void ReportDock::resizeEvent(QResizeEvent*) {
  const bool isWide = width() >= scaled(wide);
  m_plots->setVisible(isWide);
  for (auto* button : m_ui->reportTools->findChildren<QToolButton*>())
    button->setToolButtonStyle(isWide ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
}

/// The tables' marks and links have colours of the scheme.
void ReportDock::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) showAll();
  QWidget::changeEvent(event);
}

}  // namespace hogelscope
