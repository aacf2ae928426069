// SPDX-License-Identifier: BSD-3-Clause
// Files that other programs change while they are open, and light fields that are missing.
#include <QPushButton>
#include <QTemporaryDir>

#include "gui/files/file_commands.h"
#include "gui/view/image_widget.h"
#include "tests/gui/habits_test.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

using namespace hogelscope;

class TestChangedFiles : public HabitsTest {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    start();
    QVERIFY(QFile::copy(HOGELSCOPE_SOURCE_DIR "/tests/data/scene.png", path("scene.png")));
    QVERIFY(QFile::setPermissions(path("scene.png"), QFile::ReadOwner | QFile::WriteOwner));
    Session session = model().session();
    session.lightField.file = path("scene.png").toStdString();
    saveSession(m_session.toStdString(), session);
    makeWindow({m_session});
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
  }
  void cleanup() { stop(); }

  /// The current state stays, by its name.
  void aChangedSessionIsRead() {
    model().setCurrentIndex(2);
    Session session = model().session();
    std::swap(session.cameras[2], session.cameras[4]);
    session.cameras[4].camera.eye.x = 0.02;
    saveSession(m_session.toStdString(), session);
    QTRY_VERIFY_WITH_TIMEOUT(model().session() == session, patience);
    QCOMPARE(model().currentIndex(), std::size_t(4));
    QCOMPARE(eye()->value(), 0.02);
    QVERIFY(!m_window->isWindowModified());
    rewrite(0.03);  // a second time
    QTRY_COMPARE_WITH_TIMEOUT(model().session().cameras[0].camera.eye.x, 0.03, patience);
    action("undoAction")->trigger();
    QVERIFY(model().session() == session);
    QVERIFY(m_window->isWindowModified());
  }

  /// Only said.
  void editsAreKept() {
    eye()->setValue(0.01);
    rewrite(0.03);
    QTRY_VERIFY_WITH_TIMEOUT(errors().contains("has been changed by another program"), patience);
    QCOMPARE(eye()->value(), 0.01);
    QVERIFY(m_window->isWindowModified());
  }

  void ownSavesAreNoChange() {
    eye()->setValue(0.01);
    action("saveAction")->trigger();
    eye()->setValue(0.02);
    QTest::qWait(1500);
    QCOMPARE(eye()->value(), 0.02);
    QVERIFY2(errors().isEmpty(), qPrintable(errors()));
  }

  /// Nothing is measured, and no display is kept, without the light field.
  void anUnreadableLightFieldIsNotUsed() {
    QVERIFY(m_window->findChild<QPushButton*>("measureButton")->isEnabled());
    writeFile(path("scene.png"), "rubbish");
    QTRY_VERIFY_WITH_TIMEOUT(errors().contains("scene.png"), patience);
    QVERIFY(!m_window->findChild<QPushButton*>("measureButton")->isEnabled());
    action("compareKeptAction")->trigger();
    QVERIFY(!action("stopComparingAction")->isEnabled());
  }

  /// A file that is no session for now is said once, and read when it is one again.
  void damagedSessionsAreSaid() {
    const QByteArray before = contentOf(m_session);
    const double eyeBefore = eye()->value();
    writeFile(m_session, before.left(100));
    QTRY_VERIFY_WITH_TIMEOUT(errors().contains("mine.json"), patience);
    QCOMPARE(eye()->value(), eyeBefore);
    rewrite(0.03);
    QTRY_COMPARE_WITH_TIMEOUT(eye()->value(), 0.03, patience);
  }

  void aChangedLightFieldIsRead() {
    eye()->setValue(0.01);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
    const QImage before = view()->image();
    const QImage scene(path("scene.png"));
    QVERIFY(scene.mirrored().save(path("scene.png")));
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn() && view()->image() != before, patience);
    QCOMPARE(eye()->value(), 0.01);  // the session's edits stay
    QVERIFY(m_window->isWindowModified());
  }

  void aMissingLightFieldIsLocated() {
    QVERIFY(!action("locateFileAction")->isEnabled());
    QVERIFY(QFile::rename(path("scene.png"), path("moved.png")));
    makeWindow({m_session});
    QTRY_VERIFY_WITH_TIMEOUT(view()->findChild<QPushButton*>("locateFileActionCure") != nullptr,
                             patience);
    QVERIFY(action("locateFileAction")->isEnabled());
    {
      const DialogAnswer chosen(path("moved.png"));
      QTest::mouseClick(view()->findChild<QPushButton*>("locateFileActionCure"), Qt::LeftButton);
    }
    QTRY_VERIFY_WITH_TIMEOUT(isDrawn(), patience);
    QCOMPARE(model().session().lightField.file, path("moved.png").toStdString());
    QVERIFY(!action("locateFileAction")->isEnabled());
    QVERIFY(m_window->isWindowModified());
    action("undoAction")->trigger();
    QVERIFY(action("locateFileAction")->isEnabled());
    QVERIFY(!m_window->isWindowModified());
  }

  /// A light field of others, without a session, is looked at and closed.
  void nothingIsAskedAfterALook() {
    writeImageFile(path("foreign_qs2x2a1.png"), 40, 40,
                   [](int x, int y, int) { return float(x + y) / 80; });
    for (const QString& file : {path("foreign_qs2x2a1.png"), m_session, QString()}) {
      makeWindow({});
      if (file.isEmpty())
        action("newAction")->trigger();
      else
        m_window->findChild<FileCommands*>()->open(file);
      QTRY_VERIFY2_WITH_TIMEOUT(isDrawn(), qPrintable(file + errors() + view()->notice()),
                                patience);
      for (const char* look :
           {"nextStateAction", "previousStateAction", "sceneFrontAction", "maskAction",
            "playOrbitAction", "playOrbitAction", "sceneLookThroughAction", "oneToOneViewAction"})
        action(look)->trigger();
      // Going through all fields applies nothing.
      for (int k = 0; k < 60; ++k) {
        QTest::keyClick(
            QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : m_window.get(),
            Qt::Key_Tab);
        QVERIFY(!m_window->isWindowModified());
      }
      const BoxAnswer unexpected("unsavedBox", Qt::Key_Escape);
      QVERIFY2(m_window->close(), qPrintable(file));
      QCOMPARE(unexpected.text, QString());
    }
  }

 private:
  QString path(const QString& name) const { return m_folder->filePath(name); }
  ImageWidget* view() const { return m_window->findChild<ImageWidget*>("pictureView"); }
  bool isDrawn() const { return !view()->image().isNull() && view()->notice().isEmpty(); }
  /// Writes the session with another eye of the first state.
  void rewrite(double x) {
    Session session = model().session();
    session.cameras[0].camera.eye.x = x;
    saveSession(m_session.toStdString(), session);
  }
};

int main(int argc, char** argv) {
  return runHabitsTest<TestChangedFiles>(argc, argv);
}
#include "test_changed_files.moc"
