// SPDX-License-Identifier: BSD-3-Clause
// The main window: puts scene, simulated view, docks and menus together.
#include "gui/main_window.h"

#include <vtkObject.h>

#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/error.h"
#include "gui/camera_commands.h"
#include "gui/display_scene.h"
#include "gui/edit_commands.h"
#include "gui/parameter_form.h"
#include "gui/picture_commands.h"
#include "gui/session_model.h"
#include "gui/state_commands.h"
#include "gui/view_worker.h"
#include "io/calibration_file.h"
#include "ui_main_window.h"

namespace hogelscope {

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      m_ui(std::make_unique<Ui::MainWindow>()),
      m_model(new SessionModel(this)),
      m_worker(new ViewWorker(this)),
      m_stateBox(new QComboBox(this)),
      m_certificateLabel(new QLabel(this)) {
  vtkObject::GlobalWarningDisplayOff();  // errors are shown in the status bar
  m_ui->setupUi(this);
  m_ui->splitter->setSizes({1000, 1000});
  m_scene = std::make_unique<DisplayScene>(*m_ui->sceneWidget);
  m_stateBox->setObjectName("stateBox");
  m_stateBox->setToolTip(tr("The current camera state"));
  m_stateBox->setMinimumContentsLength(24);
  m_stateBox->setFocusPolicy(Qt::TabFocus);  // after a click, keys still move the camera
  m_ui->toolBar->addWidget(m_stateBox);
  addForms();
  connectActions();
  connectModel();
  addEditing();
  showTitle();
}

/// A field that loses the focus takes what was typed: while there still is a session to take it.
MainWindow::~MainWindow() {
  hide();
}

namespace {

/// One below the other.
QWidget* stacked(const std::vector<QWidget*>& widgets) {
  auto* column = new QWidget;
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  for (QWidget* widget : widgets) layout->addWidget(widget);
  layout->addStretch();
  return column;
}

}  // namespace

void MainWindow::addForms() {
  const auto form = [this](auto part) {
    m_forms.push_back(new ParameterForm([this, part](ParameterVisitor& visitor) {
      CameraState state = m_model->current();
      describe(visitor, state.*part);
      m_model->setCurrent(state);
    }));
    return m_forms.back();
  };
  auto* importButton = new QToolButton;
  importButton->setDefaultAction(m_ui->importAction);
  m_certificateLabel->setObjectName("certificateLabel");
  m_certificateLabel->setWordWrap(true);
  m_certificateLabel->setMargin(6);
  m_certificateLabel->setToolTip(tr("How far the lens can be trusted"));
  m_ui->cameraArea->setWidget(
      stacked({form(&CameraState::camera), form(&CameraState::intrinsics)}));
  m_ui->distortionArea->setWidget(
      stacked({form(&CameraState::distortion), m_certificateLabel, importButton}));
  m_ui->psfArea->setWidget(form(&CameraState::psf));
}

void MainWindow::connectActions() {
  connect(m_ui->openAction, &QAction::triggered, this, &MainWindow::askOpen);
  connect(m_ui->saveAction, &QAction::triggered, this, &MainWindow::save);
  connect(m_ui->saveAsAction, &QAction::triggered, this, &MainWindow::askSaveAs);
  connect(m_ui->importAction, &QAction::triggered, this, &MainWindow::askImport);
  connect(m_ui->quitAction, &QAction::triggered, this, &QWidget::close);
  connect(m_ui->fitAction, &QAction::triggered, this, [this] { m_scene->fit(); });
  connect(m_ui->aboutAction, &QAction::triggered, this, &MainWindow::showAbout);
  connect(m_stateBox, &QComboBox::currentIndexChanged, this,
          [this](int index) { m_model->setCurrentIndex(std::size_t(index)); });
  for (QDockWidget* dock : {m_ui->cameraDock, m_ui->distortionDock, m_ui->psfDock,
                            m_ui->cameraSetDock, m_ui->reportDock, m_ui->tradeoffDock})
    m_ui->viewMenu->addAction(dock->toggleViewAction());
  m_ui->viewMenu->addAction(m_ui->toolBar->toggleViewAction());
  m_ui->toolBar->toggleViewAction()->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_T);
  m_ui->cameraDock->toggleViewAction()->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_1);
  m_ui->distortionDock->toggleViewAction()->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_2);
  m_ui->psfDock->toggleViewAction()->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_3);
  m_ui->cameraSetDock->toggleViewAction()->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_M);
  m_ui->reportDock->toggleViewAction()->setShortcut(Qt::CTRL | Qt::Key_R);
  m_ui->tradeoffDock->toggleViewAction()->setShortcut(Qt::CTRL | Qt::Key_T);
  tabifyDockWidget(m_ui->reportDock, m_ui->tradeoffDock);
  for (QDockWidget* dock : {m_ui->cameraSetDock, m_ui->reportDock, m_ui->tradeoffDock})
    dock->hide();
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
}

void MainWindow::connectModel() {
  connect(m_model, &SessionModel::opened, this, &MainWindow::showSession);
  connect(m_model, &SessionModel::saved, this, &MainWindow::showTitle);
  connect(m_model, &SessionModel::currentChanged, this, &MainWindow::showCurrent);
  connect(m_model, &SessionModel::edited, this, &MainWindow::showCurrent);
  auto* states = new StateCommands(m_ui->statesMenu, m_model, this);
  connect(states, &StateCommands::failed, this, &MainWindow::showError);
  connect(states, &StateCommands::done, statusBar(),
          [this](const QString& line) { statusBar()->showMessage(line); });
  connect(m_model, &SessionModel::statesChanged, this, &MainWindow::showStates);
  connect(m_model, &SessionModel::edited, this, &MainWindow::offerViews);
  connect(m_ui->tradeoffView, &TradeoffView::failed, this, &MainWindow::showError);
  connect(m_ui->tradeoffView, &TradeoffView::methodChosen, this,
          [this](const std::optional<NamedMethod>& method) {
            m_method = method;
            render();
          });
  m_ui->reportPanel->setModel(m_model);
  connect(m_ui->reportPanel, &ReportDock::failed, this, &MainWindow::showError);
  m_ui->cameraSetView->setModel(m_model);
  connect(m_ui->cameraSetView, &CameraSetView::failed, this, &MainWindow::showError);
  connect(m_worker, &ViewWorker::certified, this, &MainWindow::showCertificate);
  connect(m_worker, &ViewWorker::failed, this, &MainWindow::showError);
  connect(m_worker, &ViewWorker::loaded, this, [this](const Scene& scene) {
    m_loaded = scene;
    m_display = scene.display;
    m_ui->reportPanel->setReference(scene);
    offerViews();
    showCurrent();
    m_scene->fit();
  });
  connect(m_worker, &ViewWorker::rendered, this, &MainWindow::showView);
  m_pictures = new PictureCommands(*m_ui, m_model, this);
  connect(m_pictures, &PictureCommands::otherChanged, this, &MainWindow::render);
  connect(m_pictures, &PictureCommands::failed, this, &MainWindow::showError);
  connect(m_pictures, &PictureCommands::done, statusBar(),
          [this](const QString& line) { statusBar()->showMessage(line); });
}

/// Last: keys are given to all actions.
void MainWindow::addEditing() {
  auto* camera = new CameraCommands(m_ui->cameraMenu, m_model, this);
  connect(camera, &CameraCommands::failed, this, &MainWindow::showError);
  auto* edit = new EditCommands(m_ui->editMenu, m_model, this);
  connect(edit, &EditCommands::failed, this, &MainWindow::showError);
  edit->readKeys();
}

void MainWindow::render() {
  m_worker->render(m_model->current(), m_method, m_pictures->other());
}

void MainWindow::showView(const RenderedView& view) {
  m_pictures->show(view);
  const int views = view.otherImage.isNull() ? 1 : 2;
  const QString form = views == 1 ? tr("%1 × %2 px in %3 ms, %4 views/s, %5")
                                  : tr("%1 × %2 px, both in %3 ms, %4 views/s, %5");
  QString line = form.arg(view.image.width())
                     .arg(view.image.height())
                     .arg(view.milliseconds, 0, 'f', 1)
                     .arg(1000 * views / view.milliseconds, 0, 'f', 0)
                     .arg(view.plan);
  if (view.scale > 1) line += tr(", resolution 1/%1").arg(view.scale);
  if (m_method) line += tr(", method: %1").arg(QString::fromStdString(m_method->name));
  statusBar()->showMessage(line);
}

/// To the measurement: the states as they are in the session now.
void MainWindow::offerViews() {
  std::vector<View> views;
  if (m_loaded)
    for (const CameraState& state : m_model->session().cameras)
      views.push_back(m_loaded->view(state));
  m_ui->tradeoffView->setViews(views);
}

template <class Action>
bool MainWindow::guarded(Action action) {
  try {
    action();
    return true;
  } catch (const std::exception& error) {
    showError(QString::fromUtf8(error.what()));
    return false;
  }
}

bool MainWindow::openSession(const QString& file) {
  return guarded([&] { m_model->open(file); });
}

bool MainWindow::saveSession(const QString& file) {
  return guarded([&] { m_model->save(file); });
}

bool MainWindow::importCalibration(const QString& file) {
  return guarded([&] {
    CameraState state = m_model->current();
    apply(loadCalibration(file.toStdString()), state);
    m_model->setCurrent(state);
  });
}

void MainWindow::askOpen() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Open session"), m_model->file(),
                                                    tr("Sessions (*.json)"));
  if (!file.isEmpty()) openSession(file);
}

void MainWindow::save() {
  if (m_model->file().isEmpty()) return askSaveAs();
  saveSession(m_model->file());
}

void MainWindow::askSaveAs() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Save session as"), m_model->file(),
                                                    tr("Sessions (*.json)"));
  if (!file.isEmpty()) saveSession(file);
}

void MainWindow::askImport() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Import OpenCV calibration"), m_model->file(),
                                   tr("Calibrations (*.yml *.yaml *.json)"));
  if (!file.isEmpty()) importCalibration(file);
}

void MainWindow::showAbout() {
  QMessageBox::about(this, tr("About Hogelscope"),
                     tr("Hogelscope %1\nSimulated viewing of light field displays")
                         .arg(QStringLiteral(HOGELSCOPE_VERSION)));
}

/// Fills the list of states again.
void MainWindow::showStates() {
  const QSignalBlocker quiet(m_stateBox);
  m_stateBox->clear();
  for (const CameraState& state : m_model->session().cameras)
    m_stateBox->addItem(QString::fromStdString(state.camera.name));
  offerViews();
  showCurrent();
}

void MainWindow::showSession() {
  m_display = m_model->session().display;
  m_ui->reportPanel->setReference(std::nullopt);
  m_loaded.reset();  // the old one's memory is free before the new one is read
  m_method.reset();
  m_ui->tradeoffView->forgetChoice();
  m_worker->load(m_model->session());
  statusBar()->showMessage(
      tr("Reading %1 …").arg(QString::fromStdString(m_model->session().lightField.file)));
  showStates();
  m_scene->fit();
}

void MainWindow::showCurrent() {
  const QSignalBlocker quiet(m_stateBox);
  const auto index = int(m_model->currentIndex());
  m_stateBox->setItemText(index, QString::fromStdString(m_model->current().camera.name));
  m_stateBox->setCurrentIndex(index);
  for (ParameterForm* form : m_forms) form->refresh();
  m_scene->show(m_display, m_model->session().cameras, m_model->currentIndex());
  render();
  showTitle();
}

void MainWindow::showTitle() {
  const QString name =
      m_model->file().isEmpty() ? tr("no session") : QFileInfo(m_model->file()).fileName();
  setWindowTitle(tr("%1[*] – Hogelscope").arg(name));
  setWindowModified(m_model->isModified());
  setWindowFilePath(m_model->file());
  m_ui->saveAction->setEnabled(!m_model->session().cameras.empty());
  m_ui->saveAsAction->setEnabled(!m_model->session().cameras.empty());
  m_ui->importAction->setEnabled(!m_model->session().cameras.empty());
  m_ui->cameraMenu->setEnabled(!m_model->session().cameras.empty());
  m_ui->statesMenu->setEnabled(!m_model->session().cameras.empty());
}

void MainWindow::showCertificate(const LensCertificate& certificate) {
  const double share = 100 * double(certificate.withoutRay) / double(certificate.pixels);
  const QString warning =
      certificate.withoutRay == 0
          ? QString()
          : tr("<b>⚠ %1 % of the pixels have no ray: the lens folds within the picture.</b><br>")
                .arg(share, 0, 'f', 1);
  m_certificateLabel->setText(
      warning + tr("Lens: %1.").arg(QString::fromStdString(text(certificate)).toHtmlEscaped()));
}

void MainWindow::showError(const QString& line) {
  statusBar()->showMessage(tr("Error: %1").arg(line));
}

}  // namespace hogelscope
