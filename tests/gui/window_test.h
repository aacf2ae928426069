// SPDX-License-Identifier: BSD-3-Clause
// Common parts of tests of the real window: a small session, fast to read and render, and keys.
#pragma once

#include <QAbstractButton>
#include <QSettings>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QtTest>

#include "gui/app/translations.h"
#include "gui/scene/vtk_widget.h"
#include "gui/session/session_model.h"
#include "tests/gui/patience.h"
#include "tests/gui/window_files.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

/// Writes s.json: three states, a (with lens and leakage), b and c, for a.png.
inline void writeSmallSession() {
  writeImageFile("a.png", 64, 64, [](int x, int y, int channel) {
    return float((x * 5 + y * 3 + channel * 40) % 200 + 20) / 255;
  });
  const auto state = [](const QByteArray& name, const QByteArray& more) {
    return "{\"name\": \"" + name + "\", \"eye\": [0, 0, 0.7], \"res\": [40, 30]" + more + "}";
  };
  writeFile("s.json", text({.display = R"({"hogels": [16, 16], "directions": [4, 4]})",
                            .lightField = R"({"file": "a.png"})",
                            .cameras = "[" +
                                       state("a",
                                             R"(, "distortion": {"k1": 0.1, "p2": 0.01},
                                                "psf": {"sigma": 0.5, "windowSize": 3})") +
                                       ", " + state("b", "") + ", " + state("c", "") + "]"}));
}

class WindowTest : public QObject {
 protected:
  /// Starts with s.json open.
  void start() {
    QVERIFY(QDir::setCurrent(m_folder.path()));
    writeSmallSession();
    showWindow();
    QVERIFY(files(*m_window).open("s.json"));
  }
  /// Shows the window without a session.
  void showWindow(const QSize& size = {}) {
    QSettings().remove("window/sections");  // open are those of a first start
    m_window = std::make_unique<hogelscope::MainWindow>();
    if (size.isValid()) m_window->resize(size);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), patience));
    activate(m_window.get());
    m_model = m_window->findChild<hogelscope::SessionModel*>();
  }
  /// Opens a file and waits until its image is shown.
  void open(const QString& file) {
    QVERIFY(files(*m_window).open(file));
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
  }

  template <class T>
  T* child(const char* name) const {
    return m_window->findChild<T*>(name);
  }
  template <class T>
  T* editor(const char* area, const char* name) const {
    return child<QWidget>(area)->findChild<T*>(name);
  }
  /// Opens a section of the Properties dock, such as "camera".
  void openSection(const QString& name) const {
    m_window->findChild<QAbstractButton*>(name + "Header")->setChecked(true);
  }
  void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {}) const {
    QTest::keyClick(m_window.get(), which, modifiers);
  }
  [[nodiscard]] QString message() const { return m_window->statusBar()->currentMessage(); }

  QTemporaryDir m_folder;
  std::unique_ptr<hogelscope::MainWindow> m_window;
  hogelscope::SessionModel* m_model = nullptr;
};

/// Runs a test program without changing the users' files.
template <class Test>
int runWindowTest(int argc, char** argv) {
  QStandardPaths::setTestModeEnabled(true);
  const QApplication application(argc, argv);
  hogelscope::installTranslations();
  Test test;
  return QTest::qExec(&test, argc, argv);
}
