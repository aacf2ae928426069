// SPDX-License-Identifier: BSD-3-Clause
// What users expect of any desktop program, in the real window: layout, errors, colours, manual.
#include <vtkVersion.h>
#include <QAbstractButton>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>
#include <QSet>
#include <QTabBar>
#include <QTextBlock>
#include <QToolButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "gui/app/help_commands.h"
#include "gui/app/window_layout.h"
#include "report/versions.h"
#include "tests/gui/habits_test.h"
#include "tests/gui/window_files.h"
#include "tests/io/documents.h"

using namespace hogelscope;

class TestHabits : public HabitsTest {
  Q_OBJECT

 private:
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

 private Q_SLOTS:
  void init() { start(); }
  void cleanup() { stop(); }

  void layoutPersistsAndResets() {
    auto* dock = m_window->findChild<QDockWidget*>("errorsDock");
    auto* states = m_window->findChild<QDockWidget*>("statesDock");
    auto* camera = m_window->findChild<QDockWidget*>("cameraDock");
    QVERIFY(!dock->isVisible() && !camera->isVisible());
    dock->show();
    camera->show();
    m_window->addDockWidget(Qt::RightDockWidgetArea, states);
    const QSize size = m_window->screen()->availableSize() - QSize(66, 55);
    m_window->resize(size);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->size(), size, patience);
    QVERIFY(m_window->close());
    makeWindow({m_session});
    dock = m_window->findChild<QDockWidget*>("errorsDock");
    states = m_window->findChild<QDockWidget*>("statesDock");
    camera = m_window->findChild<QDockWidget*>("cameraDock");
    auto* content = m_window->findChild<QWidget*>("cameraArea");
    QTRY_COMPARE_WITH_TIMEOUT(m_window->size(), size, patience);
    QVERIFY(dock->isVisible() && camera->isVisible() && camera->isAncestorOf(content));
    QCOMPARE(m_window->dockWidgetArea(states), Qt::RightDockWidgetArea);
    action("resetLayoutAction")->trigger();
    QVERIFY(!dock->isVisible() && !camera->isVisible() && states->isVisible());
    QVERIFY(content->isVisible());
    QCOMPARE(m_window->dockWidgetArea(states), Qt::LeftDockWidgetArea);
    QCOMPARE(m_window->size(), size);
  }

  /// The first page has no docks; they come with the first session, as they were at last.
  void theHomePageHasNoDocks() {
    m_window->findChild<QDockWidget*>("statesDock")->close();
    QVERIFY(m_window->close());
    for (const int start : {1, 2}) {  // a start without a session keeps them, too
      makeWindow({});
      QVERIFY(m_window->findChild<QWidget*>("homePage")->isVisible());
      for (const auto* dock : m_window->findChildren<QDockWidget*>())
        QVERIFY2(!dock->isVisible(), qPrintable(dock->objectName()));
      if (start == 1) QVERIFY(m_window->close());
    }
    QVERIFY(files(*m_window).open(m_session));
    QVERIFY(!m_window->findChild<QWidget*>("homePage")->isVisible());
    QVERIFY(m_window->findChild<QDockWidget*>("propertiesDock")->isVisible());
    QVERIFY(m_window->findChild<QDockWidget*>("sceneDock")->isVisible());
    QVERIFY(!m_window->findChild<QDockWidget*>("statesDock")->isVisible());
  }

  void oneKeyShowsTheViewAlone() {
    auto* view = m_window->findChild<QWidget*>("pictureView");
    auto* scene = m_window->findChild<QWidget*>("sceneArea");
    auto* camera = m_window->findChild<QWidget*>("cameraArea");
    auto* report = m_window->findChild<QDockWidget*>("reportDock");
    activate(m_window.get());
    const int width = view->width();
    QTest::keyClick(m_window.get(), Qt::Key_F11);
    QVERIFY(view->isVisible() && !scene->isVisible() && !camera->isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(view->width() > 3 * width / 2, patience);
    QTest::keyClick(m_window.get(), Qt::Key_F11, Qt::ShiftModifier);
    QVERIFY(!view->isVisible() && scene->isVisible() && !camera->isVisible());
    QTest::keyClick(m_window.get(), Qt::Key_F11, Qt::ShiftModifier);
    QVERIFY(view->isVisible() && scene->isVisible() && camera->isVisible());
    QVERIFY(!report->isVisible());
    QTest::mouseDClick(view, Qt::LeftButton);
    QVERIFY(view->isVisible() && !scene->isVisible());
    QTest::mouseDClick(view, Qt::LeftButton);
    QVERIFY(scene->isVisible() && camera->isVisible());
    QTest::mouseDClick(m_window->findChild<QWidget*>("sceneWidget"), Qt::LeftButton);
    QVERIFY(!view->isVisible() && scene->isVisible());
    QVERIFY(m_window->close());  // the docks come back at the next start
    makeWindow({m_session});
    QTRY_VERIFY_WITH_TIMEOUT(m_window->findChild<QWidget*>("cameraArea")->isVisible(), patience);
  }

  /// What no dock takes goes on to the window.
  void aDoubleClickOnADockIsNone() {
    const bool before = action("onlySceneAction")->isChecked();
    for (const char* name :
         {"statesDock", "propertiesDock", "toolBar", "statusBar", "cameraArea"}) {
      auto* part = m_window->findChild<QWidget*>(name);
      QTest::mouseDClick(part, Qt::LeftButton, {}, {part->width() - 3, part->height() - 3});
      QVERIFY2(action("onlySceneAction")->isChecked() == before, name);
    }
    QTest::mouseDClick(m_window.get(), Qt::LeftButton, {}, {3, m_window->height() - 3});
    QVERIFY(!action("onlySceneAction")->isChecked() && !action("onlyViewAction")->isChecked());
    QVERIFY(m_window->findChild<QWidget*>("pictureView")->isVisible());
  }

  /// Else the wheel, which scrolls the dock, would change what lies under it.
  void theWheelEditsOnlyWithFocus() {
    activate(m_window.get());
    const auto turn = [](QWidget* field) {
      const QPointF at = field->rect().center();
      QWheelEvent event(at, field->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                        Qt::NoScrollPhase, false);
      QApplication::sendEvent(field, &event);
    };
    const Session before = model().session();
    auto* view = m_window->findChild<QWidget*>("pictureView");
    view->setFocus();
    auto* area = m_window->findChild<QWidget*>("cameraArea");
    auto* fov = area->findChild<QWidget*>("fov");
    auto* states = m_window->findChild<QComboBox*>("stateBox");
    for (QWidget* field : std::initializer_list<QWidget*>{eye(), fov, states}) {
      QVERIFY(field != nullptr && !field->visibleRegion().isEmpty());
      turn(field);
      QVERIFY2(field->focusPolicy() != Qt::WheelFocus, qPrintable(field->objectName()));
      QCOMPARE(states->currentIndex(), 0);
      QVERIFY2(model().session() == before, qPrintable(field->objectName()));
    }
    fov->setFocus();
    turn(fov);
    QVERIFY(model().session() == before);  // numbers are scrubbed instead
    states->setFocus();
    turn(states);
    QCOMPARE(states->currentIndex(), 1);
  }

  void layoutsForTasks() {
    const auto shown = [this] {
      QStringList names;
      for (const char* name : {"sceneDock", "statesDock", "pictureView", "propertiesDock",
                               "measureDock", "tradeoffDock", "reportDock"})
        if (m_window->findChild<QWidget*>(name)->isVisible()) names << name;
      return names.join(' ');
    };
    const QString first = shown();
    QCOMPARE(first, QString("sceneDock statesDock pictureView propertiesDock"));
    activate(m_window.get());
    const auto go = [this](int digit) {
      QTest::keyClick(m_window.get(), Qt::Key(Qt::Key_0 + digit),
                      Qt::ControlModifier | Qt::AltModifier);
    };
    go(2);
    QCOMPARE(shown(), QString("statesDock pictureView"));
    QVERIFY(action("layoutCompareAction")->isChecked());
    go(3);
    QCOMPARE(shown(), QString("pictureView measureDock"));
    QVERIFY(m_window->findChild<QWidget*>("measureDock")->width() > m_window->width() / 3);
    go(4);
    QCOMPARE(shown(), QString("pictureView tradeoffDock"));
    QVERIFY(m_window->findChild<QWidget*>("tradeoffDock")->width() > m_window->width() / 3);
    go(5);
    QCOMPARE(shown(), QString("reportDock"));
    QVERIFY(m_window->findChild<QWidget*>("reportDock")->width() > 9 * m_window->width() / 10);
    go(1);
    QCOMPARE(shown(), first);
    QVERIFY(!m_window->findChild<QWidget*>("cameraArea")->visibleRegion().isEmpty());
  }

  /// At any size of the screen's, and no dock takes more than 300 px of a small one.
  void theFirstStartFitsTheScreen() {
    QSettings().clear();
    makeWindow({m_session});
    const QRect screen = m_window->screen()->availableGeometry();
    QTRY_VERIFY_WITH_TIMEOUT(screen.contains(m_window->frameGeometry()), patience);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->findChild<QWidget*>("propertiesDock")->width() <= 320,
                             patience);
    for (const char* area : {"lightFieldArea", "displayArea", "cameraArea", "distortionArea",
                             "psfArea", "samplingArea"})
      QVERIFY2(m_window->findChild<QWidget*>(area)->minimumSizeHint().width() <= 288, area);
  }

  void windowsAreFitted_data() {
    QTest::addColumn<QRect>("screen");
    QTest::addColumn<QRect>("window");
    QTest::addColumn<QRect>("expected");
    const QRect screen(0, 30, 1280, 770);
    QTest::newRow("fits") << screen << QRect(200, 100, 640, 480) << QRect(200, 100, 640, 480);
    QTest::newRow("just fits") << screen << screen << screen;
    QTest::newRow("title above") << screen << QRect(-1, -20, 900, 700) << QRect(0, 30, 900, 700);
    QTest::newRow("status bar below")
        << screen << QRect(500, 90, 800, 760) << QRect(480, 40, 800, 760);
    QTest::newRow("too large") << screen << QRect(0, 0, 1402, 925) << screen;
    QTest::newRow("too high") << screen << QRect(100, 50, 600, 800) << QRect(100, 30, 600, 770);
    const QRect second(-1920, 0, 1920, 1080);  // to the left of another one
    QTest::newRow("second screen")
        << second << QRect(-300, 500, 600, 700) << QRect(-600, 380, 600, 700);
  }
  void windowsAreFitted() {
    QFETCH(QRect, screen);
    QFETCH(QRect, window);
    QFETCH(QRect, expected);
    QCOMPARE(fitted(window, screen), expected);
  }

  /// As after a start on a larger screen, and whatever the list of recent sessions asks for.
  void aKeptLayoutFitsTheScreen() {
    for (int k = 0; k < 8; ++k)
      QVERIFY(files(*m_window).save(m_folder->filePath(QString("%1.json").arg(k))));
    const QSize screen = m_window->screen()->availableSize();
    m_window->resize(2 * screen);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->size(), 2 * screen, patience);
    for (const QStringList& files : {QStringList(), QStringList(m_session)}) {
      QVERIFY(m_window->close());
      makeWindow(files);
      QTest::qWait(100);  // docks are laid out
      QTRY_VERIFY_WITH_TIMEOUT(
          m_window->screen()->availableGeometry().contains(m_window->frameGeometry()), patience);
    }
  }

  void homePage() {
    QVERIFY(m_window->close());
    makeWindow({});
    auto* home = m_window->findChild<QWidget*>("homePage");
    QVERIFY(home->isVisible() && !m_window->findChild<QWidget*>("pictureView")->isVisible());
    QVERIFY(files(*m_window).open(m_session));
    QVERIFY(!home->isVisible() && m_window->findChild<QWidget*>("pictureView")->isVisible());
    QVERIFY(m_window->close());
    makeWindow({});
    home = m_window->findChild<QWidget*>("homePage");
    auto* recent = home->findChild<QAbstractButton*>("recentSession");
    QCOMPARE(recent->toolTip(), m_session);
    for (const auto* label : home->findChildren<QLabel*>()) QVERIFY(label->text() != "None yet");
    QTest::mouseClick(recent, Qt::LeftButton);
    QCOMPARE(model().file(), m_session);
    QVERIFY(m_window->close());
    makeWindow({});
    action("newAction")->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
    QCOMPARE(model().session().lightField.source, std::string("scene"));
    const BoxAnswer cancel("unsavedBox", Qt::Key_Escape);
    QVERIFY(m_window->close());  // nothing was edited: no question
  }

  void errorsStayUntilTheNextAction() {
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
    auto* button = m_window->findChild<QToolButton*>("errorsButton");
    QVERIFY(!button->isVisible());
    const QColor normal = m_window->statusBar()->palette().color(QPalette::WindowText);
    QVERIFY(!files(*m_window).importCalibration("/nowhere/a.yml"));
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

    QVERIFY(!files(*m_window).open("/nowhere/b.json"));
    QVERIFY(button->isVisible() && button->text().contains("2"));
    button->click();
    QVERIFY(m_window->findChild<QDockWidget*>("errorsDock")->isVisible());
    const QStringList lines = errors().split('\n');
    QCOMPARE(lines.size(), 2);
    QVERIFY(QRegularExpression("^\\d\\d:\\d\\d:\\d\\d  /nowhere/a.yml").match(lines[0]).hasMatch());
    eye()->setValue(0.02);  // what was wrong may be right now; the list stays
    QVERIFY(!button->isVisible());
    QVERIFY(!files(*m_window).open("/nowhere/c.json"));
    QVERIFY(button->isVisible() && button->text().contains("1"));
    auto* list = m_window->findChild<QPlainTextEdit*>("errors");
    list->selectAll();
    QTest::keyClick(list, Qt::Key_C, Qt::ControlModifier);
    QVERIFY(QGuiApplication::clipboard()->text().contains("/nowhere/b.json"));
  }

  void darkAndLight() {
    QVERIFY(action("darkColours")->isChecked());  // at first
    choose("lightColours");
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
    QVERIFY(QTest::qWaitForWindowExposed(manual, patience));
    auto* page = manual->findChild<ManualPage*>("manualPage");
    auto* contents = manual->findChild<QTreeWidget*>("manualContents");
    const auto top = [page] { return page->cursorForPosition({20, 8}).block().text(); };
    QCOMPARE(contents->currentItem()->text(0), "Manual");

    const auto summary = contents->findItems("The summary", Qt::MatchExactly | Qt::MatchRecursive);
    QCOMPARE(summary.size(), 1);
    contents->setCurrentItem(summary[0]);
    QCOMPARE(top(), "The summary");
    const auto follow = [page](const char* link) {
      page->setSource(page->source().resolved(QUrl(link)));
    };
    follow("#the-page");
    QCOMPARE(top(), "The page");
    QCOMPARE(contents->currentItem()->text(0), "The page");
    follow("10-accuracy.md#stability");
    QCOMPARE(top(), "Stability");
    QCOMPARE(contents->currentItem()->text(0), "Stability");
    page->backward();
    QCOMPARE(top(), "The page");
    QCOMPARE(contents->currentItem()->text(0), "The page");

    auto* search = manual->findChild<QLineEdit*>("manualSearch");
    auto* note = manual->findChild<QLabel*>("manualNote");
    QTest::keyClick(manual, Qt::Key_F, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(search->hasFocus(), patience);
    QTest::keyClicks(search, "serpentine");  // found while it is typed
    QVERIFY2(note->text().endsWith("2 chapters"), qPrintable(note->text()));
    int listed = 0;
    for (int k = 0; k < contents->topLevelItemCount(); ++k)
      listed += contents->topLevelItem(k)->isHidden() ? 0 : 1;
    QCOMPARE(listed, 2);
    QCOMPARE(page->textCursor().selectedText().toLower(), "serpentine");
    QTest::keyClick(search, Qt::Key_Return);
    QCOMPARE(page->textCursor().selectedText().toLower(), "serpentine");
    QStringList found;
    for (int k = 0; k < 12; ++k) {  // through all chapters and round
      QTest::keyClick(manual, Qt::Key_F3, k < 8 ? Qt::NoModifier : Qt::ShiftModifier);
      QCOMPARE(page->textCursor().selectedText().toLower(), "serpentine");
      found += page->source().fileName();
    }
    found.removeDuplicates();
    found.sort();
    QCOMPARE(found, QStringList({"04-views.md", "parameters.md"}));
    search->setText("no such words");
    QTest::keyClick(search, Qt::Key_Return);
    QCOMPARE(note->text(), "Not found");
    QTest::keyClick(manual, Qt::Key_Escape);
    QVERIFY(!manual->isVisible());
    action("layoutDesignAction")->trigger();
    action("manualAction")->trigger();
    QCOMPARE(page->source().fileName(), "16-measuring.md");
    manual->close();
    action("layoutViewAction")->trigger();
  }

  void chaptersOfTheManualAreThereWithTheirLinks() {
    action("manualAction")->trigger();
    auto* manual = m_window->findChild<ManualWindow*>();
    QVERIFY(QTest::qWaitForWindowExposed(manual, patience));
    auto* page = manual->findChild<ManualPage*>("manualPage");
    QSet<QString> places;
    int headings = 0;
    for (QTreeWidgetItemIterator item(manual->findChild<QTreeWidget*>("manualContents")); *item;
         ++item) {
      const QUrl url = (*item)->data(0, Qt::UserRole).toUrl();
      places.insert(url.fileName() + (url.hasFragment() ? "#" + url.fragment() : QString()));
      ++headings;
    }
    QCOMPARE(places.size(), headings);  // no page has two headings of one name

    const QDir folder(HOGELSCOPE_SOURCE_DIR "/resources/manual");
    const QRegularExpression link("(!?)\\[[^\\]]*\\]\\(([^)]+)\\)");
    int lines = 0;
    for (const QString& name : folder.entryList({"*.md"})) {
      QVERIFY2(places.contains(name), qPrintable(name + " is not in the contents"));
      const QString text = contentOf(folder.filePath(name));
      bool isCode = false;
      for (const QString& line : text.split('\n')) {
        if (line.startsWith("```")) isCode = !isCode;
        if (!isCode && line.startsWith('#')) ++lines;
      }
      for (auto each = link.globalMatch(text); each.hasNext();) {
        const auto found = each.next();
        const QString target = found.captured(2);
        if (found.captured(1) == "!") {  // every image is there, none too wide
          const QUrl url("qrc:/manual/" + target);
          const auto image = page->loadResource(QTextDocument::ImageResource, url).value<QImage>();
          QVERIFY2(!image.isNull() && image.width() <= page->viewport()->width(),
                   qPrintable(name + ": " + target));
        } else {
          const QString place = target.startsWith('#') ? name + target : target;
          QVERIFY2(places.contains(place), qPrintable(name + ": " + target));
        }
      }
    }
    QCOMPARE(headings, lines);
    manual->close();
  }

  void aboutNamesAllVersions() {
    const BoxAnswer close("aboutBox", Qt::Key_Escape);
    action("aboutAction")->trigger();
    QVERIFY(close.text.contains("Improved Simulated Viewing of Holographic Imagery"));
    std::vector<Version> all = versions();
    QCOMPARE(all.size(), 3);
    all.push_back({"Qt", qVersion()});
    all.push_back({"VTK", vtkVersion::GetVTKVersion()});
    for (const Version& each : all) {
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

int main(int argc, char** argv) {
  return runHabitsTest<TestHabits>(argc, argv);
}
#include "test_habits.moc"
