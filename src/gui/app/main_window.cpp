// SPDX-License-Identifier: BSD-3-Clause
#include "gui/app/main_window.h"

#include <vtkObject.h>

#include <QCloseEvent>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <chrono>
#include <utility>

#include "gui/app/guide.h"
#include "gui/app/help_commands.h"
#include "gui/app/home_page.h"
#include "gui/app/messages.h"
#include "gui/app/window_layout.h"
#include "gui/docks/design_numbers_widget.h"
#include "gui/docks/light_field_dock.h"
#include "gui/docks/parameter_docks.h"
#include "gui/docks/plot_saver.h"
#include "gui/docks/properties.h"
#include "gui/docks/state_dock.h"
#include "gui/files/content_optimiser.h"
#include "gui/files/file_commands.h"
#include "gui/files/light_field_output.h"
#include "gui/keys/command_palette.h"
#include "gui/scene/display_scene.h"
#include "gui/scene/scene_controller.h"
#include "gui/scene/scene_output.h"
#include "gui/session/camera_commands.h"
#include "gui/session/edit_commands.h"
#include "gui/session/session_forms.h"
#include "gui/session/session_model.h"
#include "gui/session/state_commands.h"
#include "gui/view/camera_player.h"
#include "gui/view/content_loader.h"
#include "gui/view/focus_finder.h"
#include "gui/view/frame_bar.h"
#include "gui/view/frame_stream.h"
#include "gui/view/image_commands.h"
#include "gui/view/view_worker.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/command.h"
#include "gui/widgets/elided_label.h"
#include "gui/widgets/note_bar.h"
#include "gui/widgets/task_widgets.h"
#include "ui_main_window.h"

namespace hogelscope {

MainWindow::MainWindow(QWidget* parent)
    : QMainWindow(parent),
      m_ui(std::make_unique<Ui::MainWindow>()),
      m_model(new SessionModel(this)),
      m_worker(new ViewWorker(this)),
      m_stateBox(new QComboBox(this)),
      m_colours(new QMenu(tr("&Colours"), this)),
      m_textSizes(new QMenu(tr("&Text size"), this)) {
  vtkObject::GlobalWarningDisplayOff();  // errors are shown in the status bar
  addLook(m_colours, m_textSizes);  // before the widgets, which keep a font they were made with
  m_ui->setupUi(this);
  m_messages = new Messages(this);
  m_files = new FileCommands(m_ui->fileMenu, m_model, this);
  m_home = new HomePage;
  m_ui->centralLayout->addWidget(m_home);
  auto* readout = new ElidedLabel;
  readout->setObjectName("sceneReadout");
  readout->setToolTip(tr(
      "What is picked in the scene or the simulated view, or how much of the panel's area lights "
      "the current state's eye. The report's \"Seen\" is another figure: the share of the "
      "picture's pixels that see the panel"));
  m_guide = new Guide(m_model);
  m_ui->statusBar->addPermanentWidget(m_guide);
  m_ui->statusBar->addPermanentWidget(readout);
  m_scene = new SceneController(m_ui->sceneMenu, m_ui->sceneWidget, readout, m_model, this);
  m_imageCommands = new ImageCommands(m_ui->pictureMenu, m_ui->pictureView, m_ui->pictureLayout,
                                      m_ui->statusBar, m_model, this);
  m_stateBox->setObjectName("stateBox");
  m_stateBox->setToolTip(tr("The current camera state"));
  m_stateBox->setMinimumContentsLength(8);
  m_stateBox->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  m_stateBox->setMaximumWidth(scaled(240));
  m_stateBox->setFocusPolicy(Qt::TabFocus);  // keys still move the camera after a click
  addDocks();
  connectActions();
  connectModel();
  connectDocks();
  connectWorker();
  m_loader = new ContentLoader(m_model, m_worker, this);
  connectLoader();
  connectFrames();
  addHelpers();
  addEditing();
  m_home->addCommands(*this);
  fillToolBar();
  addTopBar();
  showTitle();
}

MainWindow::~MainWindow() {
  hide();          // a field applies its text when it loses the focus, which needs the session
  delete m_scene;  // before the widget it draws into
}

void MainWindow::addDocks() {
  m_properties = new Properties(m_model, m_files->importAction(), this);
  m_ui->propertiesDock->setWidget(m_properties);
  connect(m_properties, &Properties::failed, m_messages, &Messages::showError);
  auto* commands = new StateCommands(m_ui->statesMenu, m_model, this);
  auto* states = new StateDock(m_model, commands, m_scene);
  m_ui->statesDock->setWidget(states);
  connect(commands, &StateCommands::nameAsked, this, [this, states] {
    m_ui->statesDock->show();
    m_ui->statesDock->raise();
    states->editName();
  });
  connect(commands, &StateCommands::failed, m_messages, &Messages::showError);
  connect(commands, &StateCommands::done, m_messages, &Messages::showMessage);
}

void MainWindow::connectActions() {
  connect(m_stateBox, &QComboBox::currentIndexChanged, this,
          [this](int index) { m_model->setCurrentIndex(std::size_t(index)); });
  m_ui->toolBar->toggleViewAction()->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_T);
  m_ui->viewMenu->addAction(m_ui->toolBar->toggleViewAction());
  int digit = Qt::Key_1;
  for (const char* name : {"cameraDock", "distortionDock", "psfDock", "lightFieldDock",
                           "displayDock", "statesDock", "samplingDock", "propertiesDock"})
    findChild<QDockWidget*>(name)->toggleViewAction()->setShortcut(Qt::CTRL | Qt::SHIFT |
                                                                   Qt::Key(digit++));
  findChild<QDockWidget*>("twinDock")
      ->toggleViewAction()
      ->setShortcut(Qt::CTRL | Qt::ALT | Qt::Key_T);
  findChild<QDockWidget*>("eyesDock")
      ->toggleViewAction()
      ->setShortcut(Qt::CTRL | Qt::SHIFT | Qt::Key_0);
  for (const auto& [dock, key] :
       {std::pair(m_ui->sceneDock, Qt::CTRL | Qt::SHIFT | Qt::Key_9),
        std::pair(m_ui->cameraSetDock, Qt::CTRL | Qt::SHIFT | Qt::Key_M),
        std::pair(m_ui->inspectorDock, Qt::CTRL | Qt::SHIFT | Qt::Key_P),
        std::pair(m_ui->reportDock, QKeyCombination(Qt::CTRL | Qt::Key_R)),
        std::pair(m_ui->measureDock, Qt::CTRL | Qt::SHIFT | Qt::Key_D),
        std::pair(m_ui->tradeoffDock, QKeyCombination(Qt::CTRL | Qt::Key_T))})
    dock->toggleViewAction()->setShortcut(key);
}

/// Fills the row above the simulated view, once all commands exist.
void MainWindow::fillToolBar() {
  QToolBar* bar = m_ui->toolBar;
  const int side = scaled(16);
  bar->setIconSize({side, side});
  const auto add = [this, bar](const char* command, const char* image) {
    auto* action = findChild<QAction*>(command);
    action->setIcon(icon(image));
    action->setIconVisibleInMenu(false);
    bar->addAction(action);
  };
  add("previousStateAction", "previous");
  bar->addWidget(m_stateBox);
  add("nextStateAction", "next");
  bar->addSeparator();
  add("compareIdealAction", "ideal");
  add("maskAction", "mask");
  add("histogramAction", "histogram");
  bar->addSeparator();
  add("fitViewAction", "fit");
  add("savePictureAction", "save_picture");
  add("copyPictureAction", "copy");
}

/// Puts the menus, the workspaces and the search field into one bar.
void MainWindow::addTopBar() {
  QWidget* palette = CommandPalette::makeButton(findChild<QAction*>("commandPaletteAction"));
  layout()->setMenuBar(nullptr);  // or Qt would delete the menus with the old bar
  auto* segments = new QWidget;
  segments->setObjectName("workspaces");
  auto* choices = new QHBoxLayout(segments);
  choices->setContentsMargins(2, 2, 2, 2);
  choices->setSpacing(2);
  for (QAction* action : m_layout->workspaces()) {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setFocusPolicy(Qt::NoFocus);
    choices->addWidget(button);
  }
  auto* bar = new QWidget;
  bar->setObjectName("topBar");
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(scaled(4), scaled(4), scaled(8), scaled(4));
  row->addWidget(m_ui->menuBar);
  row->addStretch(1);
  row->addWidget(segments);
  segments->hide();  // on the home page
  connect(m_model, &SessionModel::opened, segments, &QWidget::show);
  row->addStretch(1);
  row->addWidget(palette);
  m_ui->menuBar->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  setMenuWidget(bar);
}

void MainWindow::connectModel() {
  for (const auto signal : {&SessionModel::saved, &SessionModel::currentChanged})
    connect(m_model, signal, m_messages, &Messages::dismiss);
  for (const auto signal : {&SessionModel::opened, &SessionModel::edited,
                            &SessionModel::statesChanged, &SessionModel::contentChanged})
    connect(m_model, signal, m_messages, &Messages::settle);
  connect(m_model, &SessionModel::opened, this, &MainWindow::showSession);
  connect(m_model, &SessionModel::saved, this, &MainWindow::showTitle);
  connect(m_model, &SessionModel::currentChanged, this, &MainWindow::showCurrent);
  connect(m_model, &SessionModel::edited, this, &MainWindow::showCurrent);
  connect(m_model, &SessionModel::contentChanged, this, &MainWindow::showContent);
  connect(m_model, &SessionModel::statesChanged, this, &MainWindow::showStates);
  connect(m_model, &SessionModel::edited, this, &MainWindow::forgetMeasurement);
}

void MainWindow::connectDocks() {
  connect(m_ui->tradeoffView, &TradeoffWidget::failed, m_messages, &Messages::showError);
  connect(m_ui->tradeoffView, &TradeoffWidget::methodChosen, this,
          [this](const std::optional<NamedMethod>& method) {
            m_method = method;
            render();
          });
  connectMeasuring();
  m_ui->reportPanel->setModel(m_model, m_ui->fileMenu, m_ui->statesMenu);
  connect(m_ui->reportPanel, &ReportDock::failed, m_messages, &Messages::showError);
  connect(m_ui->reportPanel, &ReportDock::comparisonAsked, this, [this](const QString& file) {
    m_imageCommands->compareWith(file);
    m_layout->showView();
  });
  connect(m_ui->reportPanel, &ReportDock::psnrChanged, m_scene, &SceneController::showPsnr);
  connect(m_ui->reportPanel, &ReportDock::psnrChanged, findChild<StateDock*>(),
          &StateDock::showPsnr);
  m_ui->cameraSetView->setModel(m_model);
  connect(m_ui->cameraSetView, &CameraSetWidget::failed, m_messages, &Messages::showError);
  connect(m_ui->cameraSetView, &CameraSetWidget::previewChanged, m_scene,
          &SceneController::showPreview);
  connect(m_ui->pictureView, &ImageWidget::pixelPicked, m_scene, &SceneController::showPixel);
  connect(m_ui->pictureView, &ImageWidget::pixelPicked, m_guide, &Guide::pixelPicked);
  connect(m_scene, &SceneController::pixelsMarked, m_ui->pictureView, &ImageWidget::markPixels);
  m_ui->inspector->follow(m_scene, m_ui->pictureView);
  for (const PlotSaver* saver : findChildren<PlotSaver*>()) {
    connect(saver, &PlotSaver::done, m_messages, &Messages::showMessage);
    connect(saver, &PlotSaver::failed, m_messages, &Messages::showError);
  }
  for (const ParameterForm* form : findChildren<ParameterForm*>())
    connect(form, &ParameterForm::escaped, this, &MainWindow::leaveForm);
  connect(m_imageCommands, &ImageCommands::requestChanged, this, [this] {
    m_scene->setEyes(m_imageCommands->eyes());
    render();
  });
  auto* focus = new FocusFinder(
      m_ui->cameraMenu, m_ui->pictureView, m_model,
      [this](const QPoint& pixel) { return m_scene->viewAt(pixel); }, this);
  connect(focus, &FocusFinder::found, m_ui->inspector, &Inspector::showFocus);
  connect(focus, &FocusFinder::failed, m_messages, &Messages::showError);
  connect(focus, &FocusFinder::found, this, [this](const QPoint&, const QString& text) {
    if (!text.isEmpty()) m_messages->showMessage(text);
  });
  connect(m_imageCommands, &ImageCommands::compared, m_ui->reportPanel, &ReportDock::offerTest);
  connect(m_imageCommands, &ImageCommands::failed, m_messages, &Messages::showError);
  connect(m_imageCommands, &ImageCommands::done, m_messages, &Messages::showMessage);
}

void MainWindow::connectMeasuring() {
  m_ui->measureView->setModel(m_model);
  connect(m_ui->measureView, &MeasureWidget::tintChanged, m_ui->pictureView, &ImageWidget::setTint);
  connect(m_ui->measureView, &MeasureWidget::comparisonAsked, this,
          [this](const DisplayParams& opened) {
            Session session = m_model->session();
            session.display = opened;
            m_imageCommands->compareWithDesign(tr("A, as opened"), session);
          });
}

/// Runs last, because keys are assigned to all actions.
void MainWindow::addEditing() {
  auto* camera = new CameraCommands(m_ui->cameraMenu, m_model, this);
  connect(camera, &CameraCommands::failed, m_messages, &Messages::showError);
  m_player = new CameraPlayer(m_ui->cameraMenu, m_model, this);
  connect(m_player, &CameraPlayer::moved, this, [this] {
    m_ui->pictureView->setTint({});  // it is of the session's state
    render();
  });
  connect(m_player, &CameraPlayer::failed, m_messages, &Messages::showError);
  auto* edit = new EditCommands(m_ui->editMenu, m_model, this);
  connect(edit, &EditCommands::failed, m_messages, &Messages::showError);
  edit->readKeys();
}

/// Moves the focus back to the view, also from a floating dock, so that keys are commands again.
void MainWindow::leaveForm() {
  activateWindow();
  m_ui->pictureView->setFocus();
}

void MainWindow::connectWorker() {
  connect(m_worker, &ViewWorker::certified, m_properties->distortion(), &DistortionDock::showLens);
  connect(m_worker, &ViewWorker::failed, m_messages, &Messages::showError);
  connect(m_worker, &ViewWorker::loaded, m_messages, &Messages::dismiss);  // clears older errors
  connect(m_worker, &ViewWorker::rendered, this, &MainWindow::showView);
}

/// After connectWorker(): an older reading's messages go before those of a new one come.
void MainWindow::connectLoader() {
  connect(m_loader, &ContentLoader::sourceChanged, this, &MainWindow::showScene);
  connect(m_loader, &ContentLoader::loaded, this, [this] {
    if (std::exchange(m_isNew, false)) m_scene->scene().reset();
  });
  connect(m_loader, &ContentLoader::reading, this, [this](const QString& line) {
    m_readingBar->show();
    m_imageCommands->showNotice(line);
    m_messages->showMessage(line);
  });
  connect(m_loader, &ContentLoader::renderingBegun, this,
          [this] { m_imageCommands->showNotice(tr("Rendering …")); });
  connect(m_loader, &ContentLoader::stopped, this, [this](const QString& line) {
    m_imageCommands->drop(line);
    m_messages->showMessage(line);
  });
  connect(m_loader, &ContentLoader::failed, this, &MainWindow::showFailure);
  m_undoToPicture = addCommand(m_ui->editMenu,
                               {"undoToPictureAction", tr("&Back to the picture"),
                                tr("Takes all edits back that were made since a picture was shown"),
                                Qt::CTRL | Qt::ALT | Qt::Key_Z},
                               this, [this] { m_model->undoStack()->setIndex(m_shownAt); });
  connect(m_model, &SessionModel::opened, this, [this] { m_askedAt = m_shownAt = 0; });
  QAction* asBuilt =
      addSwitch(m_ui->pictureMenu,
                {"asBuiltAction", tr("As &built"),
                 tr("On: the unit that the session's twin describes. Off: the display as designed"),
                 Qt::Key_Y},
                true, m_loader, &ContentLoader::showTwin);
  m_ui->pictureMenu->insertAction(findChild<QAction*>("fitViewAction"), asBuilt);
  m_ui->tradeoffView->setViews([this] { return views(); });
}

/// Frames are read beside the light field: what is shown stays until the next one is there.
void MainWindow::connectFrames() {
  m_frames = new FrameStream(this);
  m_frameBar = new FrameBar(m_ui->pictureMenu, m_ui->pictureArea);
  m_ui->pictureLayout->addWidget(m_frameBar);
  const auto close = [this] {
    m_frameBar->clear();
    m_frames->close();
    m_ui->reportPanel->setFrames({}, 0);
  };
  connect(m_loader, &ContentLoader::sourceChanged, this, [this, close] {
    if (!m_loader->source()) close();
  });
  connect(m_loader, &ContentLoader::loaded, this, [this, close] {
    const LiveScene* scene = m_loader->source()->lightField->scene();
    if (scene == nullptr || scene->duration() > 0)
      m_frames->open(m_loader->asked());
    else
      close();
  });
  connect(m_frames, &FrameStream::opened, this, [this](const FrameNumbers& frames, double rate) {
    m_frameBar->setFrames(frames, rate);
    m_ui->reportPanel->setFrames(frames, rate);
    showCurrent();
  });
  connect(m_frames, &FrameStream::failed, m_messages, &Messages::showError);
  connect(m_frames, &FrameStream::failed, m_frameBar, &FrameBar::stop);
  using Source = std::shared_ptr<const LightFieldSource>;
  connect(m_frames, &FrameStream::read, this,
          [this](int frame, const Source& own, const Source& other) {
            m_imageCommands->showFrame(own, other);
            m_loader->showFrame(frame, own);
          });
  connect(m_imageCommands, &ImageCommands::compared, this,
          [this] { m_frames->openOther(m_imageCommands->otherSession()); });
  connect(m_frames, &FrameStream::otherOpened, m_frameBar, &FrameBar::askAgain);
  connect(m_frameBar, &FrameBar::frameAsked, m_frames, &FrameStream::show);
  connect(m_ui->reportPanel, &ReportDock::frameChosen, m_frameBar, &FrameBar::showFrame);
  connect(m_frameBar, &FrameBar::played, this, [this](bool isPlaying) {
    if (!isPlaying && m_loader->isReady()) showScene();  // which stands still meanwhile
  });
  connect(m_loader, &ContentLoader::frameChanged, this, [this] {
    m_imageCommands->setSource(m_loader->source());
    m_lightFieldOutput->setFrame(m_loader->frame());
    if (!m_frameBar->isPlaying()) m_scene->setSource(m_loader->source());
    render();
  });
}

void MainWindow::render() {
  if (!m_loader->isReady()) return;  // showScene() renders
  m_askedAt = m_model->undoStack()->index();
  m_worker->render({m_player->shown(), *m_loader->source(), m_method, m_imageCommands->other(),
                    m_imageCommands->asksWhy(), m_imageCommands->eyes()});
}

void MainWindow::showView(const RenderedView& view) {
  m_imageCommands->show(view);
  m_frameBar->pictureShown();
  const bool isFull = view.scale == 1 && !view.isOverview && view.samples == 0;
  if (isFull) m_files->keepThumbnail(view.image);
  if (isFull) m_shownAt = m_askedAt;
  m_loader->followImage();
  const QString form =
      view.otherImage.isNull() ? tr("%1 × %2 px in %3 ms") : tr("%1 × %2 px, both in %3 ms");
  QString line =
      form.arg(view.image.width()).arg(view.image.height()).arg(view.milliseconds, 0, 'f', 1);
  if (const int rate = m_rate.shown(); rate > 1) line += tr(", %1 shown in a second").arg(rate);
  line += ", " + view.plan;
  if (view.isOverview)
    line += tr(", overview: the rest is being fetched");
  else if (view.scale > 1)
    line += tr(", resolution 1/%1").arg(view.scale);
  else if (view.samples > 0)
    line += tr(", coarse");
  if (m_method) line += tr(", method: %1").arg(QString::fromStdString(m_method->name));
  m_messages->showMessage(line);
}

/// Drops what was measured of other views than the session's states are now.
void MainWindow::forgetMeasurement() {
  m_ui->tradeoffView->forget(m_loader->isReady());
}

std::vector<RenderJob> MainWindow::views() const {
  std::vector<RenderJob> views;
  for (const CameraState& state : m_model->session().cameras)
    views.push_back(m_loader->source()->job(state));
  return views;
}

void MainWindow::start(const QStringList& files) {
  m_layout->restore();
  show();
  m_files->offerRecovery();
  m_files->openFiles(files);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  event->setAccepted(m_files->mayLeave());
  if (!event->isAccepted()) return;
  m_layout->save();
  m_files->end();
}

/// Creates the helpers for files, help, hints, colours and layout, which need no further
/// connections.
void MainWindow::addHelpers() {
  connect(m_home, &HomePage::chosen, m_files, &FileCommands::open);
  connect(m_files, &FileCommands::done, m_messages, &Messages::showMessage);
  connect(m_files, &FileCommands::failed, m_messages, &Messages::showError);
  connect(m_files, &FileCommands::lightFieldChanged, this, [this] { m_loader->load(); });
  auto* note = new NoteBar(m_files->changeAction());
  m_ui->pictureLayout->insertWidget(0, note);
  connect(m_model, &SessionModel::opened, note, &QWidget::hide);
  connect(m_files, &FileCommands::assumed, note, &NoteBar::say);
  connect(m_files, &FileCommands::comparisonAsked, m_imageCommands, &ImageCommands::compareWith);
  auto* sceneOutput = new SceneOutput(m_ui->sceneMenu, m_ui->statusBar, m_scene, m_model, this);
  connect(sceneOutput, &SceneOutput::done, m_messages, &Messages::showMessage);
  connect(sceneOutput, &SceneOutput::failed, m_messages, &Messages::showError);
  m_lightFieldOutput = new LightFieldOutput(m_ui->fileMenu, m_ui->statusBar, m_model, this);
  connect(m_lightFieldOutput, &LightFieldOutput::done, m_messages, &Messages::showMessage);
  connect(m_lightFieldOutput, &LightFieldOutput::failed, m_messages, &Messages::showError);
  m_optimiser = new ContentOptimiser(m_ui->fileMenu, m_ui->statusBar, m_model, this);
  connect(m_optimiser, &ContentOptimiser::done, m_messages, &Messages::showMessage);
  connect(m_optimiser, &ContentOptimiser::failed, m_messages, &Messages::showError);
  connect(m_optimiser, &ContentOptimiser::written, m_imageCommands, &ImageCommands::compareWith);
  connect(m_properties->lightField(), &LightFieldDock::optimiseAsked, m_optimiser,
          &ContentOptimiser::ask);
  m_ui->fileMenu->addSeparator();
  addCommand(m_ui->fileMenu,
             {"quitAction", tr("&Quit"), tr("Closes the window"), Qt::CTRL | Qt::Key_Q}, this,
             &QWidget::close);
  addHelp(m_ui->helpMenu, this);
  m_layout = new WindowLayout(
      this, m_ui->viewMenu,
      {m_home, m_ui->pictureArea, m_ui->sceneDock, m_ui->statesDock, m_ui->propertiesDock,
       m_ui->measureDock, m_ui->tradeoffDock, m_ui->reportDock, m_properties},
      {m_ui->pictureView, m_ui->sceneWidget});
  m_ui->viewMenu->addMenu(m_colours);
  m_ui->viewMenu->addMenu(m_textSizes);
  addProgress();
}

/// Puts the bars of reading over the picture that they will replace.
void MainWindow::addProgress() {
  m_readingBar = new ReadingBar(
      tr("Light field"), [this] { return m_worker->readShare(); }, this);
  m_readingBar->setObjectName("readingBar");
  m_lookingBar = new ReadingBar(
      tr("Light field"), [this] { return m_files->lookedShare(); }, this,
      tr("How much has been looked at"), tr("Stops; the window stays as it is"));
  m_lookingBar->setObjectName("lookingBar");
  auto* over = new QVBoxLayout(m_ui->pictureView);
  over->addStretch(3);
  for (ReadingBar* bar : {m_readingBar, m_lookingBar}) {
    bar->setAttribute(Qt::WA_StyledBackground);
    over->addWidget(bar, 0, Qt::AlignHCenter);
  }
  over->addStretch(1);
  connect(m_lookingBar, &ReadingBar::stopAsked, m_files, &FileCommands::stopLooking);
  connect(m_files, &FileCommands::looking, this, &MainWindow::showLooking);
  connect(m_worker, &ViewWorker::loaded, m_readingBar, &QWidget::hide);
  connect(m_worker, &ViewWorker::failed, m_readingBar, &QWidget::hide);
  connect(m_worker, &ViewWorker::readingStopped, m_readingBar, &QWidget::hide);
  connect(m_readingBar, &ReadingBar::stopAsked, m_worker, &ViewWorker::stopReading);
}

/// Dims the picture while a light field is looked at that may take its place, after a moment. An
/// empty line: no longer.
void MainWindow::showLooking(const QString& line) {
  constexpr std::chrono::milliseconds moment(300);
  const QString before = std::exchange(m_lookingLine, line);
  m_lookingBar->hide();
  if (m_ui->pictureView->notice() == before && !before.isEmpty())
    m_imageCommands->showNotice(m_noticeBefore);
  if (line.isEmpty()) return;
  QTimer::singleShot(moment, this, [this, line] {
    if (m_lookingLine != line) return;
    m_layout->leaveHome();
    m_lookingBar->show();
    const QString notice = m_ui->pictureView->notice();
    if (!notice.isEmpty() && !m_ui->pictureView->image().isNull()) return;  // an error
    m_noticeBefore = notice;
    m_imageCommands->showNotice(line);
  });
}

/// Shows an error in place of the image until an image is rendered again.
void MainWindow::showFailure(const QString& line) {
  const bool isRead = m_loader->source().has_value();
  const QString what =
      isRead ? tr("This state cannot be rendered.") : tr("The light field cannot be read.");
  QString advice = tr("Correct it in the docks, undo the edit, or choose another state.");
  if (!isRead)
    advice =
        tr("Correct it in the Light field or Display section, undo the edit, or open the session "
           "again.");
  else if (m_imageCommands->other())
    advice += tr(" Where it is the other light field's fault, stop comparing.");
  QList<QAction*> cures;
  // The last edit alone need not be the wrong one.
  if (m_model->undoStack()->index() > m_shownAt + 1) cures << m_undoToPicture;
  for (const char* name : {"undoAction", "locateFileAction", "stopComparingAction", "openAction"})
    if (auto* cure = findChild<QAction*>(name)) cures << cure;
  m_imageCommands->showNotice(what + "\n\n" + line + "\n\n" + advice, cures);
}

/// Refills the list of states.
void MainWindow::showStates() {
  const QSignalBlocker quiet(m_stateBox);
  m_stateBox->clear();
  for (const CameraState& state : m_model->session().cameras)
    m_stateBox->addItem(QString::fromStdString(state.camera.name));
  forgetMeasurement();
  showCurrent();
}

void MainWindow::showSession() {
  m_layout->leaveHome();
  m_method.reset();
  m_isNew = true;
  m_guide->offer();
  m_ui->tradeoffView->forgetChoice();
  m_imageCommands->drop({});
  m_loader->load();
  showStates();
}

void MainWindow::showContent() {
  if (m_loader->follow()) return;  // showScene() has shown it
  forgetMeasurement();
  showCurrent();
}

void MainWindow::showScene() {
  const std::optional<ViewSource>& source = m_loader->source();
  m_properties->lightField()->setSource(source);
  m_properties->designNumbers()->setSource(source);
  m_properties->display()->setSource(source);
  m_ui->measureView->setSource(source);
  m_scene->setSource(source);
  m_imageCommands->setSource(source);
  m_lightFieldOutput->setSize(source ? std::optional(source->lightField->size()) : std::nullopt);
  m_optimiser->setHasContent(source.has_value());
  m_lightFieldOutput->setFrame(m_loader->frame());
  m_ui->reportPanel->setReference(source);
  forgetMeasurement();
  if (source) showCurrent();
}

void MainWindow::showCurrent() {
  const QSignalBlocker quiet(m_stateBox);
  const auto index = int(m_model->currentIndex());
  m_stateBox->setItemText(index, QString::fromStdString(m_model->current().camera.name));
  m_stateBox->setCurrentIndex(index);
  if (const double time = m_model->current().camera.time; time != notGiven)
    m_frameBar->showTime(time);
  render();
  showTitle();
}

void MainWindow::showTitle() {
  const QString name = !m_model->file().isEmpty()           ? QFileInfo(m_model->file()).fileName()
                       : m_model->session().cameras.empty() ? tr("no session")
                                                            : tr("new session");
  const QString title = tr("%1[*] – Hogelscope").arg(name);
  if (title != windowTitle()) setWindowTitle(title);
  if (m_model->isModified() != isWindowModified()) setWindowModified(m_model->isModified());
  if (m_model->file() != windowFilePath()) setWindowFilePath(m_model->file());
  const bool isOpen = !m_model->session().cameras.empty();
  m_files->setOpen(isOpen);
  m_properties->setOpen(isOpen);
  for (QWidget* part : std::initializer_list<QWidget*>{m_ui->cameraMenu, m_ui->statesMenu,
                                                       m_ui->statesDock->widget()})
    part->setEnabled(isOpen);
}

}  // namespace hogelscope
