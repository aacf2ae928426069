// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/image_commands.h"

#include <QActionGroup>
#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>
#include <QRegularExpression>
#include <QStatusBar>
#include <array>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/content/capture_content.h"
#include "core/metrics/metric.h"
#include "gui/session/library_menu.h"
#include "gui/session/session_model.h"
#include "gui/view/comparison_commands.h"
#include "gui/view/view_output.h"
#include "gui/view/view_worker.h"
#include "gui/widgets/command.h"
#include "gui/widgets/dialogs.h"
#include "gui/widgets/guarded.h"
#include "gui/widgets/task_widgets.h"
#include "io/images/comparison_sheet.h"
#include "io/images/image_writer.h"
#include "io/plugins/plugin_library.h"
#include "io/scene/view_source.h"
#include "picture/conversions.h"

namespace hogelscope {

namespace {

/// Whether a mask has no pixel that is seen.
bool isBlack(const QImage& seen) {
  for (int y = 0; y < seen.height(); ++y)
    for (int x = 0; x < seen.width(); ++x)
      if (qGray(seen.pixel(x, y)) != 0) return false;
  return !seen.isNull();
}

}  // namespace

ImageCommands::ImageCommands(QMenu* menu, ImageWidget* view, QVBoxLayout* around,
                             QStatusBar* statusBar, SessionModel* model, QObject* parent)
    : QObject(parent),
      m_eyes(new QActionGroup(this)),
      m_view(view),
      m_model(model),
      m_comparison(new Comparison(this)),
      m_bar(new ReadingBar(
          tr("Other light field"), [this] { return m_comparison->readShare(); }, statusBar)) {
  addCommands(menu, around, statusBar);
  connect(m_comparison, &Comparison::changed, this, &ImageCommands::requestChanged);
  connect(m_comparison, &Comparison::changed, this, &ImageCommands::showComparison);
  connect(m_comparison, &Comparison::changed, this,
          [this] { Q_EMIT compared(m_comparison->file()); });
  connect(m_comparison, &Comparison::failed, this, &ImageCommands::failed);
  connect(m_comparison, &Comparison::failed, this, &ImageCommands::showComparison);
  connect(m_model, &SessionModel::opened, m_comparison, &Comparison::stop);
  connect(m_output, &ViewOutput::done, this, &ImageCommands::done);
  connect(m_output, &ViewOutput::failed, this, &ImageCommands::failed);
  m_bar->setObjectName("otherReadingBar");
  statusBar->addPermanentWidget(m_bar);
  connect(m_bar, &ReadingBar::stopAsked, this, &ImageCommands::stopReading);
  drop(tr("No view yet: open a session (Ctrl+O)"));
}

/// Adds what a picture can be compared with.
void ImageCommands::addComparisons(QMenu* menu) {
  m_ofAnyImage << addCommand(
      menu,
      {"compareAction", tr("&Compare with light field…"),
       tr("Shows the current state on another light field too: a picture, or a "
          "session with its own display"),
       Qt::CTRL | Qt::Key_L},
      this, &ImageCommands::askFile);
  m_ofAnyImage << addCommand(
      menu,
      {"compareFolderAction", tr("Compare with &folder of views…"),
       tr("Shows the current state on another light field too: a folder of sub-aperture pictures"),
       Qt::CTRL | Qt::SHIFT | Qt::Key_F},
      this, &ImageCommands::askFolder);
  m_compareIdeal = addCommand(menu,
                              {"compareIdealAction", tr("Compare with the &ideal view"),
                               tr("Shows beside the display what the eye would see of the live "
                                  "scene itself, without a display"),
                               Qt::CTRL | Qt::SHIFT | Qt::Key_I},
                              m_comparison, &Comparison::startIdeal);
  m_ofAnyImage << addCommand(
      menu,
      {"compareKeptAction", tr("Keep this &display and compare"),
       tr("Keeps the display as it is now, and shows it beside the one that you edit"),
       Qt::CTRL | Qt::SHIFT | Qt::Key_K},
      this, [this] { m_comparison->startKept(tr("Display before")); });
  m_compareDesigned =
      addCommand(menu,
                 {"compareDesignedAction", tr("Compare &as built with as designed"),
                  tr("Shows the unit of the session's twin beside the display without its errors"),
                  Qt::CTRL | Qt::SHIFT | Qt::Key_Y},
                 this, [this] {
                   parent()->findChild<QAction*>("asBuiltAction")->setChecked(true);
                   m_comparison->startDesigned();
                 });
  m_library = menu->addMenu(tr("See this content &on"));
  auto* library = new LibraryMenu(m_library, sampleFile("displays/library"), this);
  connect(library, &LibraryMenu::chosen, this, &ImageCommands::seeOn);
  connect(library, &LibraryMenu::failed, this, &ImageCommands::failed);
  m_stop = addCommand(menu,
                      {"stopComparingAction", tr("&Stop comparing"),
                       tr("Frees the other light field"), Qt::CTRL | Qt::SHIFT | Qt::Key_L},
                      this, &ImageCommands::stopComparing);
}

void ImageCommands::addCommands(QMenu* menu, QVBoxLayout* around, QStatusBar* statusBar) {
  addComparisons(menu);
  menu->addSeparator();
  m_comparing = new ComparisonCommands(menu, m_view, around, this);
  m_mask = addSwitch(menu,
                     {"maskAction", tr("Show &mask"),
                      tr("Hatches the pixels that see nothing of the display, and says why"),
                      Qt::CTRL | Qt::Key_M},
                     false, m_view, &ImageWidget::showMask);
  connect(m_mask, &QAction::toggled, this, &ImageCommands::requestChanged);
  addEyes(menu->addMenu(tr("Stereo")));
  m_ofAnyImage << addCommand(menu,
                             {"fitViewAction", tr("&Fit picture"),
                              tr("Shows the whole simulated view"), Qt::CTRL | Qt::Key_5},
                             m_view, &ImageWidget::fit);
  m_ofAnyImage << addCommand(
      menu,
      {"oneToOneViewAction", tr("One &to one"),
       tr("Shows one pixel of the simulated view on one of the screen"), Qt::CTRL | Qt::Key_6},
      m_view, &ImageWidget::oneToOne);
  menu->addSeparator();
  m_ofRightImage << addCommand(menu,
                               {"savePictureAction", tr("Sa&ve picture…"),
                                tr("Saves the picture as the mode shows it, in full size"),
                                Qt::CTRL | Qt::Key_E, tr("Save picture")},
                               this, &ImageCommands::askImage);
  m_figure = addCommand(menu,
                        {"saveFigureAction", tr("Save f&igure…"),
                         tr("Saves both pictures side by side with the map of their error and its "
                            "scale, labelled, for a paper or a slide"),
                         Qt::CTRL | Qt::ALT | Qt::Key_G, tr("Figure…")},
                        this, &ImageCommands::askFigure);
  m_comparing->addToBar(m_figure);
  m_output = new ViewOutput(menu, m_view, statusBar, m_model, this);
  m_ofRightImage << addCommand(menu,
                               {"copyPictureAction", tr("Co&py picture"),
                                tr("Copies the picture as the mode shows it, in full size"),
                                Qt::CTRL | Qt::SHIFT | Qt::Key_C, tr("Copy picture")},
                               this, &ImageCommands::copy);
}

void ImageCommands::addEyes(QMenu* menu) {
  struct EyesChoice {
    StereoView view;
    const char* name;
    QString title;
    QString help;
  };
  const std::array choices{
      EyesChoice{StereoView::head, "headViewAction", tr("&Head"),
                 tr("Shows what one eye between the two would see")},
      EyesChoice{StereoView::left, "leftEyeAction", tr("&Left eye"),
                 tr("Shows the left eye's view")},
      EyesChoice{StereoView::right, "rightEyeAction", tr("&Right eye"),
                 tr("Shows the right eye's view")},
      EyesChoice{StereoView::sideBySide, "eyesSideBySideAction", tr("&Side by side"),
                 tr("Shows the left eye's view on the left: for stereo viewers, or parallel eyes")},
      EyesChoice{StereoView::anaglyph, "anaglyphAction", tr("&Anaglyph"),
                 tr("Shows both for glasses with red on the left and cyan on the right")},
      EyesChoice{StereoView::anaglyphGrey, "anaglyphGreyAction", tr("Anaglyph, &grey"),
                 tr("Shows the luminance of both for the same glasses")},
      EyesChoice{StereoView::crossEyed, "crossEyedAction", tr("&Cross-eyed"),
                 tr("Shows the right eye's view on the left: for crossed eyes")}};
  int digit = Qt::Key_1;
  for (const EyesChoice& choice : choices) {
    QAction* action = addCommand(menu,
                                 {choice.name, choice.title,
                                  tr("%1, of states with a distance of the eyes").arg(choice.help),
                                  Qt::ALT | Qt::SHIFT | Qt::Key(digit++)},
                                 this, &ImageCommands::requestChanged);
    action->setCheckable(true);
    action->setData(int(choice.view));
    m_eyes->addAction(action);
  }
  m_eyes->actions().front()->setChecked(true);
}

StereoView ImageCommands::eyes() const {
  return static_cast<StereoView>(m_eyes->checkedAction()->data().toInt());
}

void ImageCommands::setSource(const std::optional<ViewSource>& own) {
  m_comparison->setSource(own);
  m_output->setSource(own);
}

void ImageCommands::showFrame(const std::shared_ptr<const LightFieldSource>& own,
                              const std::shared_ptr<const LightFieldSource>& other) {
  m_comparison->showFrame(own, other);
}

const std::optional<Session>& ImageCommands::otherSession() const {
  return m_comparison->session();
}

bool ImageCommands::asksWhy() const {
  return m_mask->isChecked();
}

std::optional<ViewSource> ImageCommands::other() const {
  return m_comparison->other(m_model->session());
}

void ImageCommands::show(const RenderedView& view) {
  const bool hasOther = other().has_value();  // false for an image that arrives after the stop
  m_view->setImages(view.image, hasOther ? view.otherImage : QImage());
  m_view->setMask(view.seen, hasOther ? view.otherSeen : QImage());
  m_coarse.clear();
  if (!view.method.isEmpty()) m_coarse << view.method;
  if (view.isOverview)
    m_coarse << tr("overview: the rest is being fetched");
  else if (view.samples > 0 && view.scale == 1)
    m_coarse << tr("coarse: %n samples of the pupil", "", view.samples);
  else if (view.scale > 1)
    m_coarse << tr("coarse: 1/%1 of the resolution").arg(view.scale);
  QStringList tags;
  if (!m_model->session().twin.isZero())
    tags << (view.isBuilt ? tr("as built") : tr("as designed"));
  if (view.eyes == StereoView::left) tags << tr("left eye");
  if (view.eyes == StereoView::right) tags << tr("right eye");
  m_view->setTag((tags + m_coarse).join(QStringLiteral(" · ")));
  showNotice({});
  if (view.scale == 1 && !view.isOverview) remark(view);
}

/// Says why a picture is black, and what helps.
void ImageCommands::remark(const RenderedView& view) {
  constexpr int dark = 32;  // code values below which hardly anything is seen
  const auto cures = [this](const QStringList& names) {
    QList<QAction*> found;
    for (const QString& name : names) found << parent()->findChild<QAction*>(name);
    return found;
  };
  if (m_view->hasTwo()) return m_view->setRemark({});
  if (isBlack(view.seen))
    return m_view->setRemark(tr("No pixel sees the panel."),
                             cures({"lookAtPanelAction", "maskAction"}));
  const int lightest = m_view->lightest(dark);
  const bool isDark = lightest > 0 && lightest < dark && m_view->toneText().isEmpty();
  m_view->setRemark(isDark
                        ? tr("The picture is dark: its lightest pixel has %1 of 255.").arg(lightest)
                        : QString(),
                    isDark ? cures({"stretchAction"}) : QList<QAction*>());
}

QStringList ImageCommands::deviations() const {
  QStringList all = m_coarse;
  if (const QString tone = m_view->toneText(); !tone.isEmpty()) all.prepend(tone);
  if (m_view->hasTwo()) all.prepend(tr("a comparison"));
  if (hasTwoEyes(m_model->current()) && jointModeOf(eyes())) all.prepend(tr("both eyes"));
  return all;
}

void ImageCommands::showNotice(const QString& why, const QList<QAction*>& cures) {
  m_view->setNotice(why, cures);
  showComparison();
}

void ImageCommands::drop(const QString& why) {
  m_view->setMask({}, {});
  m_view->setImages({});
  showNotice(why);
}

bool ImageCommands::isRight() const {
  return !m_view->image().isNull() && m_view->notice().isEmpty();
}

/// Enables the commands that are available now.
void ImageCommands::showComparison() {
  const bool hasImage = !m_view->image().isNull();
  m_bar->setVisible(m_comparison->isReading());
  m_comparing->setComparing(other().has_value());
  m_comparing->measure();
  m_stop->setEnabled(other() || m_comparison->isReading());
  m_figure->setEnabled(isRight() && other() && !m_view->otherImage().isNull());
  for (QAction* action : m_ofAnyImage) action->setEnabled(hasImage);
  for (QAction* action : m_ofRightImage) action->setEnabled(isRight());
  const bool isLive = m_model->session().lightField.isLive();
  m_compareIdeal->setEnabled(hasImage && isLive);
  const bool isSaved = !m_model->file().isEmpty() && !m_model->isModified();
  const bool isCapture = isSaved && !m_model->session().display.sheet;
  for (QAction* action : m_library->actions())
    action->setEnabled(hasImage && (isLive || isCapture));
  m_compareDesigned->setEnabled(hasImage && !m_model->session().twin.isZero());
  m_view->setTitles(ownName(), m_comparison->name());
}

/// Returns what the session's own picture is called beside the other one.
QString ImageCommands::ownName() const {
  const Session& session = m_model->session();
  if (!m_comparison->file().isEmpty())
    return QFileInfo(QString::fromStdString(contentName(session.lightField))).fileName();
  if (m_comparison->isDesigned()) return tr("As built");
  return session.display == m_named.second ? m_named.first : tr("Display");
}

void ImageCommands::stopComparing() {
  m_comparison->stop();
  m_view->setImages(m_view->image());
  m_comparing->measure();
}

/// Stops reading and, as every stop does, the current comparison.
void ImageCommands::stopReading() {
  stopComparing();
  Q_EMIT done(tr("Stopped reading the other light field"));
}

bool ImageCommands::compareWith(const QString& file) {
  if (m_comparison->file() == file) return true;
  if (!guarded(this, [&] { m_comparison->start(m_model->session(), file); })) return false;
  Q_EMIT done(tr("Reading %1 …").arg(file));
  showComparison();
  return true;
}

void ImageCommands::compareWithDesign(const QString& name, const Session& session) {
  m_comparison->startDesign(name, session);
  showComparison();
  m_comparing->wipe();
}

void ImageCommands::seeOn(const QString& name, const DisplayParams& display) {
  const bool isNamed = m_model->session().display == m_named.second;
  m_comparison->startKept(isNamed ? m_named.first : tr("Display before"));
  m_comparing->wipe();
  m_model->edit(tr("See on %1").arg(name), [&](Session& session) {
    DisplayParams placed = display;
    placed.position = session.display.position;
    placed.orientation = session.display.orientation;
    m_named = {name, placed};
    session.display = placed;
    session.twin = {};  // errors of a unit of the display before
    if (session.lightField.isLive()) return;
    // What was captured is seen on the other display as a scene.
    LightFieldParams capture;
    capture.layout = Layout::live;
    capture.source = CaptureContent::sourceName;
    capture.type = LiveType::capture;
    capture.content = contentParamsOf(capture.source);
    capture.content.set("file", m_model->file().toStdString());
    session.lightField = capture;
  });
}

/// Writes a picture of the current state with `write`.
template <class Write>
bool ImageCommands::save(const QString& file, const Write& write) {
  if (!isRight()) {  // outdated while its name was asked for
    Q_EMIT failed(tr("%1: not written: there is no picture of the current state").arg(file));
    return false;
  }
  return guarded(this, [&] {
    write();
    Q_EMIT done(tr("Saved %1").arg(file));
  });
}

bool ImageCommands::saveImage(const QString& file) {
  return save(file, [&] {
    const QImage image = m_view->shownImage();
    writeImage(file.toStdString(), image.width(), image.height(), bytesOf(image));
  });
}

bool ImageCommands::saveFigure(const QString& file) {
  return save(file, [&] {
    if (m_view->otherImage().isNull())
      throw InputError(file.toStdString(), "not written", "nothing is compared any more");
    const QRect whole = m_view->image().rect();
    const Image own = toImage(m_view->image(), m_view->seen(), whole);
    const Image other = toImage(m_view->otherImage(), m_view->otherSeen(), whole);
    const QStringList titles = m_view->titles();
    const double psnr = MetricSet().compare(own, other, parallelRows, {})[psnrSeenColumn];
    const Image sheet =
        comparisonSheet(own, other, {titles[0].toStdString(), titles[1].toStdString(), psnr});
    writeImage(file.toStdString(), sheet.width, sheet.height, sheet.rgb);
  });
}

void ImageCommands::copy() {
  QGuiApplication::clipboard()->setImage(m_view->shownImage());
  Q_EMIT done(tr("Copied"));
}

void ImageCommands::askFile() {
  const QString file =
      chooseFile(m_view, tr("Compare with light field"), lightFieldFilter(sessionPatterns));
  if (!file.isEmpty()) compareWith(file);
}

void ImageCommands::askFolder() {
  const QString folder = chooseFolder(m_view, tr("Compare with folder of views"));
  if (!folder.isEmpty()) compareWith(folder);
}

/// Returns the state whose picture is shown: of two eyes joined in one picture, the head's.
CameraState ImageCommands::shownState() const {
  const StereoView one = jointModeOf(eyes()) ? StereoView::head : eyes();
  return eyeAt(one, m_model->current(), m_model->session().display, {}).state;
}

/// Saves the exact picture in full size. Where another one is shown, that is a choice, which its
/// name then says.
void ImageCommands::askImage() {
  const QStringList deviating = deviations();
  const CameraState state = shownState();
  QString name = QString::fromStdString(m_model->current().camera.name);
  bool isExact = true;
  if (!deviating.isEmpty()) {
    const auto [width, height] = state.camera.res;
    const std::optional<bool> chosen = askEither(
        m_view, tr("Save picture"),
        tr("What is shown is not the state's exact picture: %1.").arg(deviating.join(", ")),
        {tr("&Exact, %1 × %2 px").arg(width).arg(height), tr("&As shown")});
    if (!chosen) return;
    isExact = *chosen;
    const QRegularExpression notInNames(R"([/\\:*?"<>|]+\s*)");
    if (!isExact) name += " (" + deviating.join(", ").replace(notInNames, "-") + ")";
  }
  const QString file = chooseNewFile(m_view, tr("Save picture"), name + ".png",
                                     tr("Pictures (*.png *.tif *.tiff *.exr *.jpg)"));
  if (file.isEmpty()) return;
  if (isExact && !deviating.isEmpty())
    m_output->saveView(file, state);
  else
    saveImage(file);
}

void ImageCommands::askFigure() {
  const QString name = QString::fromStdString(m_model->current().camera.name) + "_figure.png";
  const QString file = chooseNewFile(m_view, tr("Save figure"), name,
                                     tr("Pictures (*.png *.tif *.tiff *.exr *.jpg)"));
  if (!file.isEmpty()) saveFigure(file);
}

}  // namespace hogelscope
