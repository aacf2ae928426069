// SPDX-License-Identifier: BSD-3-Clause
// What users expect of any desktop program, in the real window: asking before edits are lost,
// recovery after kill -9, recent files, layout, drops, errors, stopping, colours, manual.
#include <signal.h>

#include <QClipboard>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QScrollArea>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QToolButton>
#include <QTreeWidget>
#include <QtTest>

#include "gui/autosave_entry.h"
#include "gui/main_window.h"
#include "gui/manual_window.h"
#include "gui/picture_view.h"
#include "gui/session_model.h"
#include "gui/view_worker.h"
#include "io/session_file.h"
#include "report/versions.h"

using namespace hogelscope;

namespace {

const QString sampleFile = QStringLiteral(HOGELSCOPE_SOURCE_DIR "/data/table1.json");

constexpr int patience = 60000;  // milliseconds; machines may be busy

/// Presses a key in the next box, and keeps what the box says.
class BoxAnswer : public QObject {
 public:
  BoxAnswer(const char* name, Qt::Key key) {
    connect(&m_timer, &QTimer::timeout, this, [this, name, key] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr || box->objectName() != name || !box->isVisible()) return;
      m_timer.stop();
      text = box->text() + box->informativeText();
      QTimer::singleShot(20000, box, &QDialog::reject);  // rather than for ever
      QTest::keyClick(box, key);
    });
    m_timer.start(20);
  }
  QString text;  ///< empty while no box came

 private:
  QTimer m_timer;
};

/// Looks at the next file dialog, then chooses in it.
class DialogAnswer : public QObject {
 public:
  explicit DialogAnswer(const QString& choice) {
    connect(&m_timer, &QTimer::timeout, this, [this, choice] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || !dialog->isVisible()) return;
      m_timer.stop();
      folder = dialog->directory().absolutePath();
      name = dialog->findChild<QLineEdit*>("fileNameEdit")->text();
      dialog->selectFile(choice);
      static_cast<QDialog*>(dialog)->accept();
      if (dialog->isVisible()) dialog->reject();
    });
    m_timer.start(20);
  }
  QString folder;  ///< empty while no dialog came
  QString name;    ///< that it proposed

 private:
  QTimer m_timer;
};

}  // namespace

class TestHabits : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<MainWindow> m_window;
  std::unique_ptr<QTemporaryDir> m_folder;
  QString m_session;  ///< small, and the tests' own

  SessionModel& model() const { return *m_window->findChild<SessionModel*>(); }
  QAction* action(const char* name) const { return m_window->findChild<QAction*>(name); }
  QString message() const { return m_window->statusBar()->currentMessage(); }
  QString errors() const { return m_window->findChild<QPlainTextEdit*>("errors")->toPlainText(); }
  QDoubleSpinBox* eye() const {
    auto* area = m_window->findChild<QScrollArea*>("cameraArea");
    return area->widget()->findChild<QDoubleSpinBox*>("eye.0");
  }
  double savedEye() const { return loadSession(m_session.toStdString()).cameras[0].camera.eye.x; }
  void makeWindow(const QStringList& files) {
    m_window.reset();
    m_window = std::make_unique<MainWindow>();
    m_window->start(files);
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
  }
  void drop(const QStringList& files) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& file : files) urls.append(QUrl::fromLocalFile(file));
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(m_window.get(), &event);
  }
  /// Qt hands palettes on to widgets only while the program's loop runs.
  void choose(const char* name) {
    QTimer::singleShot(0, this, [this, name] {
      action(name)->trigger();
      (void)QTest::qWaitFor(
          [this] { return m_window->palette().window() == QApplication::palette().window(); });
      QCoreApplication::exit();
    });
    QApplication::exec();
  }
  QStringList autosaved() const {
    return QDir(autosaveFolder()).entryList({"*.json"}, QDir::Files);
  }
  /// Another process edits the session and is killed.
  void crash() {
    QProcess other;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("HOGELSCOPE_CRASH", m_session);
    other.setProcessEnvironment(environment);
    other.start(QCoreApplication::applicationFilePath(), {});
    QVERIFY(other.waitForFinished(60000));
    QCOMPARE(other.exitStatus(), QProcess::CrashExit);
    QCOMPARE(autosaved().size(), 1);
  }

 private Q_SLOTS:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder->path());
    QSettings().clear();
    QDir(autosaveFolder()).removeRecursively();
    m_session = m_folder->filePath("mine.json");
    saveSession(m_session.toStdString(),
                loadSession(sampleFile.toStdString(), {"camera.res=[80,60]"}));
    makeWindow({m_session});
    QCOMPARE(model().file(), m_session);
  }
  void cleanup() {
    m_window.reset();
    QApplication::setPalette(QPalette());
  }

  void closesAtOnceWithoutEdits() {
    QVERIFY(m_window->close());
    QVERIFY(!m_window->isVisible());
  }

  void asksBeforeEditsAreLost() {
    eye()->setValue(0.01);
    QVERIFY(m_window->isWindowModified());
    {
      const BoxAnswer cancel("unsavedBox", Qt::Key_Escape);
      QVERIFY(!m_window->close());
      QVERIFY(cancel.text.contains("mine.json"));
    }
    QVERIFY(m_window->isVisible());
    QCOMPARE(eye()->value(), 0.01);
    const BoxAnswer save("unsavedBox", Qt::Key_Return);
    QVERIFY(m_window->close());
    QCOMPARE(savedEye(), 0.01);
  }

  void discardsAndQuits() {
    const double before = savedEye();
    eye()->setValue(0.01);
    const BoxAnswer discard("unsavedBox", Qt::Key_D);
    action("quitAction")->trigger();
    QVERIFY(!m_window->isVisible());
    QVERIFY(!discard.text.isEmpty());
    QCOMPARE(savedEye(), before);
  }

  /// A save that fails is no reason to lose the edits.
  void staysOpenWhereSavingFails() {
    eye()->setValue(0.01);
    QVERIFY(QFile::remove(m_session));
    QVERIFY(QDir().mkdir(m_session));
    const BoxAnswer save("unsavedBox", Qt::Key_Return);
    QVERIFY(!m_window->close());
    QVERIFY(errors().contains("mine.json"));
    QVERIFY(m_window->isWindowModified());
  }

  void openingAnotherAsksToo() {
    eye()->setValue(0.01);
    {
      const BoxAnswer cancel("unsavedBox", Qt::Key_Escape);
      drop({sampleFile});
      QTRY_VERIFY_WITH_TIMEOUT(!cancel.text.isEmpty(), patience);
      QCOMPARE(model().file(), m_session);
    }
    const BoxAnswer save("unsavedBox", Qt::Key_Return);
    drop({sampleFile});
    QTRY_COMPARE_WITH_TIMEOUT(model().file(), sampleFile, patience);
    QCOMPARE(savedEye(), 0.01);
  }

  void keepsEditsOnDiskUntilTheyAreSaved() {
    QVERIFY(autosaved().isEmpty());
    eye()->setValue(0.01);
    QTRY_COMPARE_WITH_TIMEOUT(autosaved().size(), 1, patience);
    QVERIFY(abandonedEntries().empty());  // this program lives
    const QString copy = QDir(autosaveFolder()).filePath(autosaved()[0]);
    const Session session = loadSession(copy.toStdString());
    QCOMPARE(session.cameras[0].camera.eye.x, 0.01);
    QCOMPARE(QFileInfo(QString::fromStdString(session.lightField.file)).canonicalFilePath(),
             QFileInfo(HOGELSCOPE_SOURCE_DIR "/data/scene.png").canonicalFilePath());
    action("saveAction")->trigger();
    QVERIFY(autosaved().isEmpty());
    eye()->setValue(0.02);
    QTRY_COMPARE_WITH_TIMEOUT(autosaved().size(), 1, patience);
    const BoxAnswer discard("unsavedBox", Qt::Key_D);
    QVERIFY(m_window->close());
    QVERIFY(QDir(autosaveFolder()).isEmpty());  // no lock either
  }

  /// Two values that do not go together are not written over what can be recovered.
  void neverKeepsWhatCannotBeOpened() {
    eye()->setValue(0.01);
    QTRY_COMPARE_WITH_TIMEOUT(autosaved().size(), 1, patience);
    const QString copy = QDir(autosaveFolder()).filePath(autosaved()[0]);
    model().edit("both", [](Session& session) {
      session.cameras[0].camera.eye.x = 0.02;
      session.cameras[1].camera.name = session.cameras[0].camera.name;
    });
    QTest::qWait(4000);
    QCOMPARE(loadSession(copy.toStdString()).cameras[0].camera.eye.x, 0.01);
    model().edit("mended", [](Session& session) { session.cameras[1].camera.name = "other"; });
    QTRY_COMPARE_WITH_TIMEOUT(loadSession(copy.toStdString()).cameras[0].camera.eye.x, 0.02,
                              patience);
  }

  void recoversAfterAKill() {
    QVERIFY(m_window->close());
    crash();
    const double before = savedEye();
    {
      const BoxAnswer later("recoveryBox", Qt::Key_Escape);
      makeWindow({});
      QVERIFY(later.text.contains(m_session));
      QVERIFY(model().session().cameras.empty());
      QCOMPARE(autosaved().size(), 1);
    }
    const BoxAnswer recover("recoveryBox", Qt::Key_R);
    makeWindow({});
    QVERIFY(recover.text.contains("mine.json"));
    QCOMPARE(model().file(), m_session);
    QVERIFY(m_window->isWindowModified());
    QCOMPARE(eye()->value(), 0.0123);
    QCOMPARE(savedEye(), before);
    QCOMPARE(autosaved().size(), 1);  // its own now: a second crash loses nothing
    QVERIFY(abandonedEntries().empty());
    action("saveAction")->trigger();
    QCOMPARE(savedEye(), 0.0123);
    QVERIFY(QDir(autosaveFolder()).isEmpty());
  }

  void discardsWhatACrashLeft() {
    QVERIFY(m_window->close());
    crash();
    const BoxAnswer discard("recoveryBox", Qt::Key_D);
    makeWindow({});
    QVERIFY(!discard.text.isEmpty());
    QVERIFY(QDir(autosaveFolder()).isEmpty());
  }

  /// A damaged copy is told and stays for whoever can read it.
  void keepsWhatCannotBeRecovered() {
    QVERIFY(QDir().mkpath(autosaveFolder()));
    QFile file(autosaveFolder() + "/broken.json");
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{\"hogelscope\"") > 0);
    file.close();
    const BoxAnswer recover("recoveryBox", Qt::Key_R);
    makeWindow({m_session});
    QVERIFY(errors().contains("broken.json"));
    QVERIFY(QFile::exists(file.fileName()));
    QCOMPARE(model().file(), m_session);  // the command line's still opens
  }

  void remembersRecentFiles() {
    const QString second = m_folder->filePath("second.json");
    QVERIFY(m_window->saveSession(second));
    auto* menu = m_window->findChild<QMenu*>("recentMenu");
    Q_EMIT menu->aboutToShow();
    QCOMPARE(menu->actions().size(), 2);
    QVERIFY(menu->actions()[0]->text().contains("second.json"));
    QVERIFY(menu->actions()[1]->isEnabled());
    menu->actions()[1]->trigger();
    QCOMPARE(model().file(), m_session);
    QVERIFY(QFile::remove(second));
    Q_EMIT menu->aboutToShow();
    QVERIFY(menu->actions()[0]->text().contains("mine.json"));
    QVERIFY(!menu->actions()[1]->isEnabled());  // missing
    for (int k = 0; k < 12; ++k)
      QVERIFY(m_window->saveSession(m_folder->filePath(QString("%1.json").arg(k))));
    Q_EMIT menu->aboutToShow();
    QCOMPARE(menu->actions().size(), 10);
  }

  /// Over runs of the program too; only saving proposes a name.
  void dialogsOpenInTheLastFolder() {
    QVERIFY(QDir(m_folder->path()).mkpath("far/views"));
    const QString far = m_folder->filePath("far");
    {
      const DialogAnswer saveAs(far + "/kept.json");
      action("saveAsAction")->trigger();
      QCOMPARE(saveAs.folder, m_folder->path());
      QCOMPARE(saveAs.name, QString("mine.json"));
      QCOMPARE(model().file(), far + "/kept.json");
    }
    QVERIFY(m_window->close());
    makeWindow({});
    {
      const DialogAnswer open(far + "/kept.json");
      action("openAction")->trigger();
      QCOMPARE(open.folder, far);
      QCOMPARE(open.name, QString());
      QCOMPARE(model().file(), far + "/kept.json");
    }
    QVERIFY(m_window->openSession(m_session));  // without a dialog
    QTRY_VERIFY_WITH_TIMEOUT(action("compareAction")->isEnabled(), patience);
    for (const char* name : {"loadStatesAction", "compareAction", "importAction"}) {
      const DialogAnswer dialog({});
      action(name)->trigger();
      QCOMPARE(dialog.folder, m_folder->path());
      QCOMPARE(dialog.name, QString());
    }
    const DialogAnswer folder(far + "/views");
    action("compareFolderAction")->trigger();
    QCOMPARE(folder.folder, m_folder->path());
    const DialogAnswer next({});
    action("openLightFieldAction")->trigger();
    QCOMPARE(next.folder, far);
  }

  void layoutPersistsAndResets() {
    auto* dock = m_window->findChild<QDockWidget*>("tradeoffDock");
    auto* camera = m_window->findChild<QDockWidget*>("cameraDock");
    QVERIFY(!dock->isVisible());
    dock->show();
    m_window->addDockWidget(Qt::LeftDockWidgetArea, camera);
    m_window->resize(1111, 850);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->size(), QSize(1111, 850), patience);
    QVERIFY(m_window->close());
    makeWindow({});
    dock = m_window->findChild<QDockWidget*>("tradeoffDock");
    camera = m_window->findChild<QDockWidget*>("cameraDock");
    QTRY_COMPARE_WITH_TIMEOUT(m_window->size(), QSize(1111, 850), patience);
    QVERIFY(dock->isVisible());
    QCOMPARE(m_window->dockWidgetArea(camera), Qt::LeftDockWidgetArea);
    action("resetLayoutAction")->trigger();
    QVERIFY(!dock->isVisible());
    QVERIFY(camera->isVisible());
    QCOMPARE(m_window->dockWidgetArea(camera), Qt::RightDockWidgetArea);
    QCOMPARE(m_window->size(), QSize(1111, 850));
  }

  void dropsOpenImportAndCompare() {
    auto* picture = m_window->findChild<PictureView*>("pictureView");
    QTRY_VERIFY_WITH_TIMEOUT(!picture->image().isNull(), patience);
    QFile file(m_folder->filePath("k.yml"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "%YAML:1.0\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
        "   data: [ 60., 0., 40., 0., 60., 30., 0., 0., 1. ]\n"
        "distortion_coefficients: !!opencv-matrix\n   rows: 4\n   cols: 1\n   dt: d\n"
        "   data: [ 0.125, 0., 0., 0. ]\n");
    file.close();
    drop({file.fileName()});
    QTRY_COMPARE_WITH_TIMEOUT(model().current().distortion.k1, 0.125, patience);
    QVERIFY(!action("stopComparingAction")->isEnabled());
    drop({QStringLiteral(HOGELSCOPE_SOURCE_DIR "/data/scene.png")});
    QTRY_VERIFY_WITH_TIMEOUT(action("stopComparingAction")->isEnabled(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(action("wipeAction")->isEnabled(), patience);
    QCOMPARE(model().file(), m_session);
  }

  void commandLineOpensAndCompares() {
    makeWindow({HOGELSCOPE_SOURCE_DIR "/data/scene.png", m_session});  // in any order
    QCOMPARE(model().file(), m_session);
    QTRY_VERIFY_WITH_TIMEOUT(action("wipeAction")->isEnabled(), patience);
    makeWindow({m_folder->filePath("missing.json"), "picture.png"});
    QVERIFY(m_window->isVisible());
    const QStringList lines = errors().split('\n');
    QCOMPARE(lines.size(), 2);
    QVERIFY(lines[0].contains("missing.json: cannot be read"));
    QVERIFY(lines[1].contains("picture.png: needs an open session"));
  }

  void errorsStayUntilTheNextAction() {
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
    auto* button = m_window->findChild<QToolButton*>("errorsButton");
    QVERIFY(!button->isVisible());
    const QColor normal = m_window->statusBar()->palette().color(QPalette::WindowText);
    QVERIFY(!m_window->importCalibration("/nowhere/a.yml"));
    QVERIFY(message().startsWith("Error: /nowhere/a.yml"));
    const QColor red = m_window->statusBar()->palette().color(QPalette::WindowText);
    QVERIFY(red != normal && red.red() > red.green() + 50);
    action("copyPictureAction")->trigger();  // says that it is done
    QVERIFY(message().startsWith("Error: "));
    QStatusTipEvent hover("");  // the pointer over a menu
    QApplication::sendEvent(m_window.get(), &hover);
    QVERIFY(message().startsWith("Error: "));
    QTest::keyClick(m_window->windowHandle(), Qt::Key_Shift);
    QVERIFY(!message().isEmpty() && !message().startsWith("Error"));
    QCOMPARE(m_window->statusBar()->palette().color(QPalette::WindowText), normal);

    QVERIFY(!m_window->openSession("/nowhere/b.json"));
    QVERIFY(button->isVisible() && button->text().contains("2"));
    button->click();
    QVERIFY(m_window->findChild<QDockWidget*>("errorsDock")->isVisible());
    const QStringList lines = errors().split('\n');
    QCOMPARE(lines.size(), 2);
    QVERIFY(QRegularExpression("^\\d\\d:\\d\\d:\\d\\d  /nowhere/a.yml").match(lines[0]).hasMatch());
    auto* list = m_window->findChild<QPlainTextEdit*>("errors");
    list->selectAll();
    QTest::keyClick(list, Qt::Key_C, Qt::ControlModifier);
    QVERIFY(QGuiApplication::clipboard()->text().contains("/nowhere/b.json"));
  }

  void readingCanBeStopped() {
    constexpr int side = 6000;
    const QString image = m_folder->filePath("large.png");
    {
      QImage large(side, side, QImage::Format_RGB888);
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < 3 * side; ++x) large.scanLine(y)[x] = uchar(x * 7 ^ y * 13);
      QVERIFY(large.save(image, nullptr, 100));
    }
    Session session = loadSession(m_session.toStdString());
    session.display.hogels = {300, 300};
    session.display.directions = {20, 20};
    session.lightField.file = image.toStdString();
    const QString file = m_folder->filePath("large.json");
    saveSession(file.toStdString(), session);
    auto* bar = m_window->findChild<QWidget*>("readingBar");
    auto* picture = m_window->findChild<PictureView*>("pictureView");
    QTRY_VERIFY_WITH_TIMEOUT(!picture->image().isNull(), patience);
    int shown = -1;
    connect(m_window->findChild<ViewWorker*>(), &ViewWorker::reading, bar, [&](double done) {
      if (done == 0 || shown >= 0 || !bar->isVisible()) return;
      shown = bar->findChild<QProgressBar*>()->value();
      bar->findChild<QToolButton*>()->click();
    });
    QVERIFY(m_window->openSession(file));
    QTRY_VERIFY_WITH_TIMEOUT(message().startsWith("Stopped reading"), patience);
    QVERIFY(shown > 0 && shown < 100);
    QVERIFY(!bar->isVisible());
    QVERIFY(picture->image().isNull());  // not the picture of another session
    eye()->setValue(0.01);               // the window goes on
    QTest::qWait(100);
    QVERIFY(picture->image().isNull());
    const BoxAnswer discard("unsavedBox", Qt::Key_D);
    drop({m_session});
    QTRY_COMPARE_WITH_TIMEOUT(picture->image().size(), QSize(80, 60), patience);
    QVERIFY(!bar->isVisible());
  }

  void darkAndLight() {
    QVERIFY(action("systemColours")->isChecked());
    choose("darkColours");
    QVERIFY(m_window->palette().color(QPalette::Window).lightness() < 80);
    QVERIFY(m_window->palette().color(QPalette::WindowText).lightness() > 180);
    QVERIFY(QSettings().value("colours").isValid());
    makeWindow({});
    QVERIFY(action("darkColours")->isChecked());
    QVERIFY(eye()->palette().color(QPalette::Base).lightness() < 80);
    choose("lightColours");
    QVERIFY(m_window->palette().color(QPalette::Window).lightness() > 180);
  }

  void showsTheManual() {
    action("manualAction")->trigger();
    auto* manual = m_window->findChild<ManualWindow*>();
    QVERIFY(QTest::qWaitForWindowExposed(manual));
    auto* page = manual->findChild<ManualPage*>("manualPage");
    auto* contents = manual->findChild<QTreeWidget*>("manualContents");
    QFile file(HOGELSCOPE_SOURCE_DIR "/resources/manual/manual.md");
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList lines = QString::fromUtf8(file.readAll()).split('\n');
    QCOMPARE(contents->topLevelItemCount(), lines.filter(QRegularExpression("^##? ")).size());
    const auto psnr = contents->findItems("Metrics", Qt::MatchExactly);
    QCOMPARE(psnr.size(), 1);
    contents->setCurrentItem(psnr[0]);
    QCOMPARE(page->cursorForPosition({20, 8}).block().text(), "Metrics");
    for (const QString& line : lines.filter("![")) {  // every picture is there, none too wide
      const QString name = line.section('(', -1).section(')', 0, 0);
      const auto image =
          page->loadResource(QTextDocument::ImageResource, "qrc:/manual/" + name).value<QImage>();
      QVERIFY2(!image.isNull(), qPrintable(name));
      QVERIFY(image.width() <= page->viewport()->width());
    }
    auto* search = manual->findChild<QLineEdit*>("manualSearch");
    QTest::keyClick(manual, Qt::Key_F, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(search->hasFocus(), patience);
    QTest::keyClicks(search, "bootstrap");
    QTest::keyClick(search, Qt::Key_Return);
    QCOMPARE(page->textCursor().selectedText().toLower(), "bootstrap");
    search->setText("no such words");
    QTest::keyClick(search, Qt::Key_Return);
    QCOMPARE(manual->findChild<QLabel*>("manualNote")->text(), "Not found");
    page->setSource(QUrl("parameters.md"));  // as its link does
    QVERIFY(page->toPlainText().contains("windowSize"));
    QTest::keyClick(manual, Qt::Key_Escape);
    QVERIFY(!manual->isVisible());
  }

  void aboutNamesAllVersions() {
    const BoxAnswer close("aboutBox", Qt::Key_Escape);
    action("aboutAction")->trigger();
    QVERIFY(close.text.contains("Improved Simulated Viewing of Holographic Imagery"));
    QCOMPARE(versions().size(), 5);
    for (const Version& each : versions()) {
      QVERIFY(close.text.contains(QString::fromStdString(each.name)));
      QVERIFY(QRegularExpression("^\\d+\\.\\d+\\.\\d+")
                  .match(QString::fromStdString(each.version))
                  .hasMatch());
      QVERIFY(close.text.contains(QString::fromStdString(each.version)));
    }
  }

  void scalesByFractions() {
    QCOMPARE(QGuiApplication::highDpiScaleFactorRoundingPolicy(),
             Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
  }
};

namespace {

/// What the other process of crash() does.
int editAndDie(const QString& file) {
  MainWindow window;
  window.start({file});
  auto* area = window.findChild<QScrollArea*>("cameraArea");
  area->widget()->findChild<QDoubleSpinBox*>("eye.0")->setValue(0.0123);
  const QDir folder(autosaveFolder());
  if (QTest::qWaitFor([&] { return !folder.entryList({"*.json"}, QDir::Files).isEmpty(); }, 20000))
    ::kill(::getpid(), SIGKILL);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QCoreApplication::setOrganizationName("Hogelscope");
  QCoreApplication::setApplicationName("test_habits");
  QStandardPaths::setTestModeEnabled(true);
  const QString file = qEnvironmentVariable("HOGELSCOPE_CRASH");
  if (!file.isEmpty()) return editAndDie(file);
  TestHabits test;
  return QTest::qExec(&test, argc, argv);
}

#include "test_habits.moc"
