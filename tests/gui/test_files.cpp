// SPDX-License-Identifier: BSD-3-Clause
// Opens files as users do, in the real window: recent ones, dialogs, drops, the command line; and
// stops reading one.
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

#include "gui/files/recent_files.h"
#include "gui/view/image_widget.h"
#include "gui/view/view_worker.h"
#include "io/documents/session_file.h"
#include "tests/gui/habits_test.h"
#include "tests/gui/window_files.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"
#include "tests/io/layered_views.h"

using namespace hogelscope;

class TestFiles : public HabitsTest {
  Q_OBJECT

 private Q_SLOTS:
  void init() { start(); }
  void cleanup() { stop(); }

  void remembersRecentFiles() {
    const QString second = m_folder->filePath("second.json");
    QVERIFY(files(*m_window).save(second));
    auto* menu = m_window->findChild<QMenu*>("recentMenu");
    Q_EMIT menu->aboutToShow();
    QCOMPARE(menu->actions().size(), 2);
    QVERIFY(menu->actions()[0]->text().contains("second.json"));
    QVERIFY(menu->actions()[1]->isEnabled());
    menu->actions()[1]->trigger();
    QCOMPARE(model().file(), m_session);
    QVERIFY(QFile::remove(second));
    Q_EMIT menu->aboutToShow();
    QCOMPARE(menu->actions().size(), 1);  // the other one is gone
    QVERIFY(menu->actions()[0]->text().contains("mine.json"));
    for (int k = 0; k < 14; ++k)
      QVERIFY(files(*m_window).save(m_folder->filePath(QString("%1.json").arg(k))));
    Q_EMIT menu->aboutToShow();
    QCOMPARE(menu->actions().size(), 12);
  }

  /// Each with what it is and a picture of its first view; pictures of forgotten files go.
  void recentFilesHavePictures() {
    const auto newest = [] { return RecentFiles::list().front(); };
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(newest().thumbnail), patience);
    QCOMPARE(newest().file, m_session);
    QCOMPARE(newest().what, QString("Session · 6 states"));
    QVERIFY(std::abs(newest().when.secsTo(QDateTime::currentDateTime())) < 60);
    const QImage shown = m_window->findChild<ImageWidget*>("pictureView")->image();
    const QImage kept(newest().thumbnail);
    QCOMPARE(kept.size(), shown.size().scaled(112, 80, Qt::KeepAspectRatio));
    QCOMPARE(kept.convertToFormat(QImage::Format_RGB32),
             shown.scaled(112, 80, Qt::KeepAspectRatio, Qt::SmoothTransformation)
                 .convertToFormat(QImage::Format_RGB32));
    const QString first = newest().thumbnail;
    QVERIFY(QDir::setCurrent(m_folder->path()));
    writeTwoWalls("theirs.png", 40, 30, 24, 18);
    QVERIFY(files(*m_window).open(m_folder->filePath("theirs.png")));
    QTRY_COMPARE_WITH_TIMEOUT(newest().file, m_folder->filePath("theirs.png"), patience);
    QCOMPARE(newest().what, QString("Hogels 40 × 30 of 24 × 18"));
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(newest().thumbnail), patience);
    QVERIFY(QFileInfo::exists(first));
    for (int k = 0; k < 12; ++k)
      QVERIFY(files(*m_window).save(m_folder->filePath(QString("%1.json").arg(k))));
    QCOMPARE(RecentFiles::list().size(), std::size_t(12));
    QVERIFY(!QFileInfo::exists(first));
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
    QVERIFY(files(*m_window).open(m_session));  // without a dialog
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

  /// A dropped mesh is a session of its own; the dock's button puts one behind this session's
  /// states.
  void meshesAreOpened() {
    writeFile(m_folder->filePath("a.obj"), "v -1 -1 0\nv 1 -1 0\nv 0 1 0.5\nf 1 2 3\n");
    const auto mesh = [this] {
      const auto* file = model().session().lightField.content.find<std::string>("file");
      return file != nullptr ? QFileInfo(QString::fromStdString(*file)).fileName() : QString();
    };
    QVERIFY(mesh().isEmpty());
    drop({m_folder->filePath("a.obj")});
    QTRY_COMPARE_WITH_TIMEOUT(mesh(), QString("a.obj"), patience);
    QCOMPARE(model().session().cameras.size(), std::size_t{1});

    QVERIFY(files(*m_window).open(m_session));
    QTRY_VERIFY_WITH_TIMEOUT(mesh().isEmpty(), patience);
    const Session before = model().session();
    QVERIFY(before.cameras.size() > 1);
    const DialogAnswer dialog(m_folder->filePath("a.obj"));
    m_window->findChild<QPushButton*>("chooseFileButton")->click();
    QTRY_COMPARE_WITH_TIMEOUT(mesh(), QString("a.obj"), patience);
    QCOMPARE(model().session().cameras.size(), before.cameras.size());
    QVERIFY(model().session().display != before.display);
    QCOMPARE(model().session().display.position, before.display.position);
    action("undoAction")->trigger();
    QVERIFY(model().session() == before);
  }

  /// Of a folder whose rows run upwards; a session that says otherwise is told so.
  void viewsGetTheirOrder() {
    QVERIFY(QDir(m_folder->path()).mkpath("v"));
    const GreyGrid grid = gridOf(randomScene(7, 1, 6), 3, 5, {true, false, false});
    for (int k = 0; k < 15; ++k) {
      const GreyPicture view = grid.view(k / 5, k % 5);
      const QImage image(view.values.data(), view.width, view.height, view.width,
                         QImage::Format_Grayscale8);
      QVERIFY(image.save(m_folder->filePath(QString("v/00%1_00%2.png").arg(k / 5).arg(k % 5))));
    }
    const auto& lightField = model().session().lightField;
    QVERIFY(files(*m_window).open(m_folder->filePath("v")));
    QTRY_VERIFY_WITH_TIMEOUT(lightField.layout == Layout::views, patience);
    QVERIFY(lightField.rows == RowOrder::bottomUp && lightField.shear[1] > 0.5);
    Session wrong = model().session();
    wrong.lightField.rows = RowOrder::topDown;
    saveSession(m_folder->filePath("wrong.json").toStdString(), wrong);
    QSignalSpy errors(&files(*m_window), &FileCommands::failed);
    QVERIFY(files(*m_window).open(m_folder->filePath("wrong.json")));
    QTRY_COMPARE_WITH_TIMEOUT(errors.size(), 1, patience);
    QVERIFY(errors[0][0].toString().contains("mend it with lightField.rows=bottom-up"));
    QVERIFY(lightField.rows == RowOrder::topDown);
    // A view that is missing is told beside it.
    QVERIFY(QFile::remove(m_folder->filePath("v/000_004.png")));
    errors.clear();
    QVERIFY(files(*m_window).open(m_folder->filePath("wrong.json")));
    QTRY_COMPARE_WITH_TIMEOUT(errors.size(), 2, patience);
    const QString hole = "1 of 15 views are missing and shown black: (row, column) 0 4";
    QVERIFY(errors[0][0].toString().endsWith(hole));
  }

  void dropsOpenImportAndCompare() {
    auto* image = m_window->findChild<ImageWidget*>("pictureView");
    QTRY_VERIFY_WITH_TIMEOUT(!image->image().isNull(), patience);
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
    QFile other(m_folder->filePath("lens.json"));  // no session, but a camera by what is in it
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.write(
        R"({"mtx": [[60, 0, 40], [0, 60, 30], [0, 0, 1]], "dist": [[0.25, 0, 0, 0, 0]], "w": 80, "h": 60})");
    other.close();
    drop({other.fileName()});
    QTRY_COMPARE_WITH_TIMEOUT(model().current().distortion.k1, 0.25, patience);
    QVERIFY(!action("stopComparingAction")->isEnabled());
    drop({QStringLiteral(HOGELSCOPE_SOURCE_DIR "/tests/data/scene.png")});
    QTRY_VERIFY_WITH_TIMEOUT(action("stopComparingAction")->isEnabled(), patience);
    QTRY_VERIFY_WITH_TIMEOUT(action("wipeAction")->isEnabled(), patience);
    QCOMPARE(model().file(), m_session);
  }

  void commandLineOpensAndCompares() {
    makeWindow({HOGELSCOPE_SOURCE_DIR "/tests/data/scene.png", m_session});  // in any order
    QCOMPARE(model().file(), m_session);
    QTRY_VERIFY_WITH_TIMEOUT(action("wipeAction")->isEnabled(), patience);
    makeWindow({m_folder->filePath("missing.json"), "picture.png"});
    QVERIFY(m_window->isVisible());
    const QStringList lines = errors().split('\n');
    QCOMPARE(lines.size(), 2);
    QVERIFY(lines[0].contains("missing.json: cannot be read"));
    QVERIFY(lines[1].contains("picture.png: needs an open session"));
  }

  void sessionsHaveASuffixOfTheirOwn() {
    const QString file = m_folder->filePath("copy.hogelscope");
    saveSession(file.toStdString(), model().session());
    drop({file});
    QTRY_COMPARE_WITH_TIMEOUT(model().file(), file, patience);
    makeWindow({HOGELSCOPE_SOURCE_DIR "/tests/data/scene.png", file});
    QTRY_COMPARE_WITH_TIMEOUT(model().file(), file, patience);
  }

  void readingCanBeStopped() {
    const QString file = largeSession(4000);
    auto* bar = m_window->findChild<QWidget*>("readingBar");
    auto* image = m_window->findChild<ImageWidget*>("pictureView");
    QTRY_VERIFY_WITH_TIMEOUT(!image->image().isNull(), patience);
    QVERIFY(!bar->isVisible());
    QVERIFY(files(*m_window).open(file));
    QVERIFY(bar->isVisible());
    bar->findChild<QToolButton*>()->click();
    QTRY_VERIFY_WITH_TIMEOUT(message().startsWith("Stopped reading"), patience);
    QVERIFY(image->notice().startsWith("Stopped reading"));
    QVERIFY(!bar->isVisible());
    QVERIFY(image->image().isNull());  // not the image of another session
    eye()->setValue(0.01);             // the window goes on
    QTest::qWait(100);
    QVERIFY(image->image().isNull());
    const BoxAnswer discard("unsavedBox", Qt::Key_D);
    drop({m_session});
    QTRY_COMPARE_WITH_TIMEOUT(image->image().size(), QSize(80, 60), patience);
    QVERIFY(!bar->isVisible());
  }

  /// The bar moves, but what is read while the window is busy is not painted step by step after it.
  void progressQueuesNothing() {
    const QString file = largeSession(6000);
    auto* bar = m_window->findChild<QWidget*>("readingBar")->findChild<QProgressBar*>();
    auto* worker = m_window->findChild<ViewWorker*>();
    QSignalSpy moved(bar, &QProgressBar::valueChanged);
    QSignalSpy loaded(worker, &ViewWorker::loaded);
    QVERIFY(files(*m_window).open(file));
    QVERIFY(sleepUntil([&] { return worker->readShare() > 0.5; }));
    QTRY_VERIFY_WITH_TIMEOUT(!moved.isEmpty() && moved.last()[0].toInt() > 0, patience);
    QVERIFY(sleepUntil([&] { return worker->readShare() == 1; }));
    moved.clear();
    QTRY_COMPARE_WITH_TIMEOUT(loaded.count(), 1, patience);
    QVERIFY2(moved.count() <= 2, qPrintable(QString::number(moved.count())));
    QTRY_VERIFY_WITH_TIMEOUT(!bar->isVisible(), patience);
  }

 private:
  /// Over a light field that takes a while to read.
  QString largeSession(int side) {
    const QString image = m_folder->filePath("large.png");
    QImage large(side, side, QImage::Format_RGB888);
    for (int y = 0; y < side; ++y) {
      uchar* row = large.scanLine(y);
      for (int x = 0; x < 3 * side; ++x) row[x] = uchar(x * 7 ^ y * 13);
    }
    if (!large.save(image, nullptr, 100)) qFatal("cannot write %s", qPrintable(image));
    Session session = loadSession(m_session.toStdString());
    session.display.hogels = {side / 20, side / 20};
    session.display.directions = {20, 20};
    session.lightField.file = image.toStdString();
    const QString file = m_folder->filePath("large.json");
    saveSession(file.toStdString(), session);
    return file;
  }
};

int main(int argc, char** argv) {
  return runHabitsTest<TestFiles>(argc, argv);
}
#include "test_files.moc"
