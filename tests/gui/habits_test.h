// SPDX-License-Identifier: BSD-3-Clause
// Common parts of the tests of files and settings: a window that starts like the program, with its
// own settings and session file, answers to modal boxes, and drops.
#pragma once

#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QtTest>

#include "gui/app/main_window.h"
#include "gui/files/autosave.h"
#include "gui/session/session_model.h"
#include "io/documents/session_file.h"
#include "tests/gui/patience.h"

inline const QString sampleFile = QStringLiteral(HOGELSCOPE_SOURCE_DIR "/tests/data/table1.json");

/// Presses a key in the next box, and keeps the box's text.
class BoxAnswer : public QObject {
 public:
  BoxAnswer(const char* name, Qt::Key key) {
    connect(&m_timer, &QTimer::timeout, this, [this, name, key] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr || box->objectName() != name || !box->isVisible()) return;
      m_timer.stop();
      text = box->text() + box->informativeText();
      QTimer::singleShot(patience, box, &QDialog::reject);  // limits the wait
      QTest::keyClick(box, key);
    });
    m_timer.start(20);
  }
  QString text;  ///< empty without a box

 private:
  QTimer m_timer;
};

/// Reads the next file dialog, then types a choice.
class DialogAnswer : public QObject {
 public:
  explicit DialogAnswer(const QString& choice) {
    connect(&m_timer, &QTimer::timeout, this, [this, choice] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || !dialog->isVisible()) return;
      auto* edit = dialog->findChild<QLineEdit*>("fileNameEdit");
      if (!edit->hasFocus()) return;  // otherwise a proposed file would stay selected
      m_timer.stop();
      QTimer::singleShot(patience, dialog, &QDialog::reject);  // limits the wait
      folder = dialog->directory().absolutePath();
      name = edit->text();
      if (choice.isEmpty()) return dialog->reject();
      // Typed, because the dialog's list may not contain it yet.
      edit->setText(choice);
      static_cast<QDialog*>(dialog)->accept();
    });
    m_timer.start(20);
  }
  QString folder;  ///< empty without a dialog
  QString name;    ///< the proposed name

 private:
  QTimer m_timer;
};

class HabitsTest : public QObject {
 protected:
  /// Starts with the test's session open.
  void start() {
    m_folder = std::make_unique<QTemporaryDir>();
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_folder->path());
    QSettings().clear();
    QDir(hogelscope::autosaveFolder()).removeRecursively();
    m_session = m_folder->filePath("mine.json");
    hogelscope::saveSession(
        m_session.toStdString(),
        hogelscope::loadSession(sampleFile.toStdString(), {"camera.res=[80,60]"}));
    makeWindow({m_session});
    QCOMPARE(model().file(), m_session);
  }
  void stop() {
    m_window.reset();
    QApplication::setPalette(QPalette());
  }

  hogelscope::SessionModel& model() const {
    return *m_window->findChild<hogelscope::SessionModel*>();
  }
  QAction* action(const char* name) const { return m_window->findChild<QAction*>(name); }
  QString message() const { return m_window->statusBar()->currentMessage(); }
  QString errors() const { return m_window->findChild<QPlainTextEdit*>("errors")->toPlainText(); }
  QDoubleSpinBox* eye() const {
    auto* area = m_window->findChild<QWidget*>("cameraArea");
    return area->findChild<QDoubleSpinBox*>("eye.0");
  }
  void makeWindow(const QStringList& files) {
    m_window.reset();
    m_window = std::make_unique<hogelscope::MainWindow>();
    m_window->start(files);
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), patience));
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

  std::unique_ptr<hogelscope::MainWindow> m_window;
  std::unique_ptr<QTemporaryDir> m_folder;
  QString m_session;  ///< small, owned by the tests
};

/// Uses Qt's own dialogs, which a test can answer. Keeps the users' files unchanged: each test
/// program has its own autosave folder.
inline void setUpProgram() {
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QCoreApplication::setOrganizationName("Hogelscope");
  QStandardPaths::setTestModeEnabled(true);
}

template <class Test>
int runHabitsTest(int argc, char** argv) {
  const QApplication application(argc, argv);
  setUpProgram();
  Test test;
  return QTest::qExec(&test, argc, argv);
}
