// SPDX-License-Identifier: BSD-3-Clause
// In the real window: asking before edits are lost, and recovery after kill -9.
#include <signal.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>

#include "tests/gui/habits_test.h"

using namespace hogelscope;

class TestUnsavedEdits : public HabitsTest {
  Q_OBJECT

 private:
  double savedEye() const { return loadSession(m_session.toStdString()).cameras[0].camera.eye.x; }
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
    QVERIFY(other.waitForFinished(patience));
    QCOMPARE(other.exitStatus(), QProcess::CrashExit);
    QCOMPARE(autosaved().size(), 1);
  }

 private Q_SLOTS:
  void init() { start(); }
  void cleanup() { stop(); }

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
             QFileInfo(HOGELSCOPE_SOURCE_DIR "/tests/data/scene.png").canonicalFilePath());
    action("saveAction")->trigger();
    QVERIFY(autosaved().isEmpty());
    eye()->setValue(0.02);
    QTRY_COMPARE_WITH_TIMEOUT(autosaved().size(), 1, patience);
    const BoxAnswer discard("unsavedBox", Qt::Key_D);
    QVERIFY(m_window->close());
    QVERIFY(QDir(autosaveFolder()).isEmpty());  // no lock either
  }

  /// It is said once, and tried again.
  void saysThatEditsAreNotKept() {
    const QString folder = autosaveFolder();
    QVERIFY(QDir(folder).removeRecursively() && QFile(folder).open(QIODevice::WriteOnly));
    eye()->setValue(0.01);
    const QString said = "a crash would lose the edits";
    QTRY_VERIFY_WITH_TIMEOUT(errors().contains(said), patience);
    QTest::qWait(4000);
    QCOMPARE(errors().count(said), 1);
    QVERIFY(QFile::remove(folder));
    QTRY_COMPARE_WITH_TIMEOUT(autosaved().size(), 1, patience);
    const BoxAnswer discard("unsavedBox", Qt::Key_D);
    QVERIFY(m_window->close());
    QVERIFY(autosaved().isEmpty());
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
};

namespace {

/// What the other process of crash() does.
int editAndDie(const QString& file) {
  MainWindow window;
  window.start({file});
  auto* area = window.findChild<QWidget*>("cameraArea");
  area->findChild<QDoubleSpinBox*>("eye.0")->setValue(0.0123);
  const QDir folder(autosaveFolder());
  if (QTest::qWaitFor([&] { return !folder.entryList({"*.json"}, QDir::Files).isEmpty(); },
                      patience))
    ::kill(::getpid(), SIGKILL);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  setUpProgram();
  const QString file = qEnvironmentVariable("HOGELSCOPE_CRASH");
  if (!file.isEmpty()) return editAndDie(file);
  TestUnsavedEdits test;
  return QTest::qExec(&test, argc, argv);
}

#include "test_unsaved_edits.moc"
