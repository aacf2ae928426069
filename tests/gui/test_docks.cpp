// SPDX-License-Identifier: BSD-3-Clause
// Drives the docks of the real window: display, light field, distortion, PSF, states.
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QScrollArea>
#include <QSlider>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include "core/colour_map.h"
#include "core/fast_simulation.h"
#include "gui/kernel_view.h"
#include "gui/lens_view.h"
#include "gui/light_field_dock.h"
#include "gui/main_window.h"
#include "gui/picture_commands.h"
#include "gui/picture_view.h"
#include "gui/session_model.h"
#include "gui/state_commands.h"
#include "gui/state_dock.h"
#include "gui/view_worker.h"
#include "gui/vtk_widget.h"
#include "io/light_field_file.h"
#include "io/session_file.h"
#include "tests/io/documents.h"
#include "tests/io/pictures.h"

using namespace hogelscope;

namespace {

const QString sampleFile = QStringLiteral(HOGELSCOPE_SOURCE_DIR "/data/table1.json");

bool equals(const QImage& shown, const Image& expected) {
  if (shown.width() != expected.width || shown.height() != expected.height) return false;
  const QImage rgb = shown.convertToFormat(QImage::Format_RGB888);
  for (int y = 0; y < rgb.height(); ++y)
    if (!std::equal(rgb.constScanLine(y), rgb.constScanLine(y) + 3 * rgb.width(),
                    expected.rgb.begin() + 3 * std::ptrdiff_t(y) * rgb.width()))
      return false;
  return true;
}

/// Pixels of a drawing that are nearly of a colour.
int count(QWidget* widget, const QColor& colour) {
  const QImage image = widget->grab().toImage();
  int found = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QColor c = image.pixelColor(x, y);
      found += std::abs(c.red() - colour.red()) + std::abs(c.green() - colour.green()) +
                   std::abs(c.blue() - colour.blue()) <
               60;
    }
  return found;
}

/// Of a tap in the drawing, near its top left corner.
QColor colourOfTap(KernelView& kernel, const QString& tap) {
  const QImage image = kernel.grab().toImage();
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      if (kernel.textAt(QPointF(x, y)).startsWith("Tap " + tap))
        return image.pixelColor(x + 3, y + 3);
  return {};
}

bool isColour(const QColor& colour, double share) {
  const auto [r, g, b] = falseColour(share);
  return std::abs(colour.red() - r) + std::abs(colour.green() - g) + std::abs(colour.blue() - b) <
         6;
}

}  // namespace

class TestDocks : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<MainWindow> m_window;
  QTemporaryDir m_folder;

  template <class T>
  T* child(const char* name) const {
    return m_window->findChild<T*>(name);
  }
  template <class T>
  T* editor(const char* area, const char* name) const {
    return child<QScrollArea>(area)->widget()->findChild<T*>(name);
  }
  const QImage& view() const { return child<PictureView>("pictureView")->image(); }
  SessionModel* model() const { return m_window->findChild<SessionModel*>(); }
  QString message() const { return m_window->statusBar()->currentMessage(); }
  QListWidget* list() const { return child<QListWidget>("stateList"); }
  QStringList names() const {
    QStringList result;
    for (int row = 0; row < list()->count(); ++row) result << list()->item(row)->text();
    return result;
  }
  void open(const QString& file) {
    QVERIFY(m_window->openSession(file));
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), 60000);
  }
  /// With small pictures, which the reference renders quickly.
  void openSmall() {
    const QString file = m_folder.filePath("small.json");
    saveSession(file.toStdString(), loadSession(sampleFile.toStdString(), {"camera.res=[90,80]"}));
    open(file);
  }
  Image expected() const {
    const Session& session = model()->session();
    return simulateFast(loadScene(session, {}).view(model()->current()));
  }
  void clickRow(int row, Qt::KeyboardModifiers modifiers = {}) {
    const QRect box = list()->visualItemRect(list()->item(row));
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, modifiers, box.center());
  }
  void press(const char* action) {
    for (auto* button : child<QWidget>("statesDock")->findChildren<QToolButton*>())
      if (button->defaultAction() && button->defaultAction()->objectName() == action)
        return QTest::mouseClick(button, Qt::LeftButton);
    QFAIL("no such button");
  }
  /// By the pointer of the window system, from a row's middle to so far into another one.
  void dragRow(int from, int to, double share) {
    QWindow* window = m_window->windowHandle();
    const auto at = [&](int row, double part) {
      const QRect box = list()->visualItemRect(list()->item(row));
      const QPoint point(box.center().x(), box.top() + qRound(part * box.height()));
      return list()->viewport()->mapTo(m_window.get(), point);
    };
    const QPoint start = at(from, 0.5);
    const QPoint end = at(to, share);
    QTest::mousePress(window, Qt::LeftButton, {}, start);
    // The first move starts a loop of its own, which the release ends.
    QTimer::singleShot(100, window, [=] { QTest::mouseMove(window, (start + end) / 2); });
    QTimer::singleShot(200, window, [=] { QTest::mouseMove(window, end); });
    QTimer::singleShot(300, window, [=] { QTest::mouseMove(window, end); });
    QTimer::singleShot(400, window, [=] { QTest::mouseRelease(window, Qt::LeftButton, {}, end); });
    QTest::mouseMove(window, start + QPoint(0, 2 * QApplication::startDragDistance()));
    QTest::qWait(600);
  }
  void drop(const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    auto* dock = m_window->findChild<StateDock*>();
    QDragEnterEvent enter({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(dock, &enter);
    if (!enter.isAccepted()) return;
    QDropEvent dropped({5, 5}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(dock, &dropped);
  }

 private Q_SLOTS:
  void init() {
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
  }
  void cleanup() { m_window.reset(); }

  void theWindowFitsASmallScreen() {
    openSmall();
    m_window->resize(1280, 800);
    QTRY_COMPARE(m_window->size(), QSize(1280, 800));
    QVERIFY(child<PictureView>("pictureView")->width() > 300);
    QVERIFY(list()->viewport()->height() >= 6 * list()->visualItemRect(list()->item(0)).height());
    // Each dock is a tab that can be moved and closed.
    for (const char* name : {"statesDock", "lightFieldDock", "displayDock", "cameraDock",
                             "distortionDock", "psfDock"}) {
      auto* dock = child<QDockWidget>(name);
      QVERIFY2(dock->features().testFlag(QDockWidget::DockWidgetMovable), name);
      dock->toggleViewAction()->trigger();
      QVERIFY2(dock->isHidden(), name);
      dock->toggleViewAction()->trigger();
      QVERIFY2(!dock->isHidden(), name);
    }
    auto* camera = child<QDockWidget>("cameraDock");
    camera->setFloating(true);
    QVERIFY(camera->isWindow() && camera->isVisible());
    camera->setFloating(false);
    QCOMPARE(m_window->tabifiedDockWidgets(child<QDockWidget>("cameraDock")).size(), 5);
  }

  void theDisplayMovesWithoutReading() {
    openSmall();
    QSignalSpy loaded(m_window->findChild<ViewWorker*>(), &ViewWorker::loaded);
    const QImage before = view().copy();
    editor<QDoubleSpinBox>("displayArea", "size.0")->setValue(0.3);
    editor<QDoubleSpinBox>("displayArea", "orientation.1")->setValue(10);
    editor<QDoubleSpinBox>("displayArea", "fov.1")->setValue(50);
    editor<QComboBox>("displayArea", "lens")->setCurrentText("equiangular");
    editor<QComboBox>("lightFieldArea", "reconstruction")->setCurrentText("bilinear");
    editor<QSpinBox>("lightFieldArea", "samplesPerPixel")->setValue(2);
    QCOMPARE(model()->undoStack()->undoText(), QString("Change samplesPerPixel"));
    QVERIFY(m_window->isWindowModified());
    const Image picture = expected();
    QTRY_VERIFY_WITH_TIMEOUT(equals(view(), picture), 20000);
    QCOMPARE(loaded.count(), 0);
    while (model()->undoStack()->canUndo()) model()->undoStack()->undo();
    QTRY_VERIFY_WITH_TIMEOUT(view() == before, 20000);
    QCOMPARE(editor<QDoubleSpinBox>("displayArea", "size.0")->value(), 0.5);
  }

  /// The same light field compared with itself stays the same picture.
  void aComparisonFollowsTheDisplay() {
    openSmall();
    const QString file = QString::fromStdString(model()->session().lightField.file);
    QVERIFY(m_window->findChild<PictureCommands*>()->compareWith(file));
    RenderedView last;
    connect(m_window->findChild<ViewWorker*>(), &ViewWorker::rendered, this,
            [&](const RenderedView& view) { last = view; });
    QTRY_VERIFY_WITH_TIMEOUT(!last.otherImage.isNull(), 20000);
    editor<QDoubleSpinBox>("displayArea", "size.0")->setValue(0.3);
    editor<QSpinBox>("lightFieldArea", "samplesPerPixel")->setValue(2);
    const Image picture = expected();
    QTRY_VERIFY_WITH_TIMEOUT(equals(last.image, picture), 20000);
    QVERIFY(equals(last.otherImage, picture));
    disconnect(m_window->findChild<ViewWorker*>(), nullptr, this, nullptr);
  }

  void hogelsThatDoNotFitAreToldAndMended() {
    openSmall();
    auto* contents = child<QLabel>("contentsLabel");
    QTRY_VERIFY(contents->text().startsWith("128×128 hogels of 20×20 directions, 8 bit"));
    const QImage before = view().copy();
    for (const char* name : {"hogels.0", "hogels.1"})
      editor<QSpinBox>("displayArea", name)->setValue(64);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("64×64 hogels of 20×20 directions need"), 20000);
    QVERIFY(view() == before);
    editor<QDoubleSpinBox>("cameraArea", "eye.2")->setValue(0.7);  // nothing to render it from
    QTest::qWait(100);
    QVERIFY2(!message().startsWith("Reading"), qPrintable(message()));
    QCOMPARE(contents->text(), QString("Nothing is in memory."));
    for (const char* name : {"directions.0", "directions.1"})
      editor<QSpinBox>("displayArea", name)->setValue(40);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), 20000);
    const Image picture = expected();
    QTRY_VERIFY_WITH_TIMEOUT(equals(view(), picture), 20000);
    QVERIFY(contents->text().startsWith("64×64 hogels of 40×40 directions"));
  }

  void aFolderOpensAsASessionAndAnotherFileIsChosen() {
    QVERIFY(!child<QToolButton>("importButton")->isEnabled());
    for (int v = 0; v < 3; ++v)
      for (int u = 0; u < 4; ++u)
        writePicture(m_folder.filePath(QString("views/00%1_00%2.png").arg(v).arg(u)), 32, 24,
                     [&](int x, int y, int c) {
                       return float((x * 7 + y * 5 + 40 * u + 60 * v + 80 * c) % 256) / 255;
                     });
    open(m_folder.filePath("views"));
    QVERIFY(m_window->windowTitle().startsWith("new session"));
    QVERIFY(m_window->isWindowModified());
    QCOMPARE(names(), QStringList("View"));
    QVERIFY(child<QLabel>("contentsLabel")->text().startsWith("32×24 hogels of 4×3 directions"));
    QCOMPARE(editor<QSpinBox>("displayArea", "hogels.0")->text(), QString("not given"));
    QCOMPARE(editor<QDoubleSpinBox>("displayArea", "size.1")->value(), 0.375);
    editor<QSpinBox>("cameraArea", "res.0")->setValue(60);
    QVERIFY(!editor<QLineEdit>("lightFieldArea", "pattern")->isHidden());
    editor<QComboBox>("lightFieldArea", "rows")->setCurrentText("bottom-up");
    const Image flipped = expected();
    QTRY_VERIFY_WITH_TIMEOUT(equals(view(), flipped), 20000);

    // A quilt: the layout follows, and the fields with it.
    const QString quilt = m_folder.filePath("q_qs2x2a1.png");
    writePicture(quilt, 40, 40, [](int x, int y, int) { return float(x + y) / 80; });
    m_window->findChild<LightFieldDock*>()->choose(quilt);
    QTRY_VERIFY(child<QLabel>("contentsLabel")->text().startsWith("20×20 hogels of 4×1"));
    QCOMPARE(editor<QComboBox>("lightFieldArea", "layout")->currentText(), QString("quilt"));
    QVERIFY(editor<QLineEdit>("lightFieldArea", "pattern")->isHidden());
    auto* columns = editor<QSpinBox>("lightFieldArea", "columns");
    QVERIFY(columns->isVisibleTo(child<QScrollArea>("lightFieldArea")->widget()));
    QCOMPARE(columns->text(), QString("not given"));
    columns->setValue(4);
    QTRY_VERIFY(child<QLabel>("contentsLabel")->text().startsWith("10×20 hogels of 8×1"));
    QVERIFY(m_window->saveSession(m_folder.filePath("around.json")));
    QVERIFY(loadSession(m_folder.filePath("around.json").toStdString()).cameras ==
            model()->session().cameras);
  }

  void aHogelImageAsksForItsHogels() {
    writePicture(m_folder.filePath("plain.png"), 60, 60,
                 [](int x, int y, int) { return float(x % 8 + y % 8) / 16; });
    QVERIFY(m_window->openSession(m_folder.filePath("plain.png")));
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("how many of them are hogels"), 20000);
    QVERIFY(!m_window->saveSession(m_folder.filePath("plain.json")));
    for (const char* name : {"hogels.0", "hogels.1"})
      editor<QSpinBox>("displayArea", name)->setValue(10);
    for (const char* name : {"directions.0", "directions.1"})
      editor<QSpinBox>("displayArea", name)->setValue(6);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), 20000);
    QVERIFY(!view().isNull());
    QVERIFY(!m_window->openSession(m_folder.filePath("none.png")));
    QVERIFY(message().contains("none.png"));
    QVERIFY(m_window->windowTitle().startsWith("new session"));
  }

  void theKernelIsDrawnAndItsLossTold() {
    openSmall();
    child<QDockWidget>("psfDock")->raise();
    auto* kernel = m_window->findChild<KernelView*>();
    auto* energy = child<QLabel>("energyLabel");
    QTRY_VERIFY(kernel->isVisible());
    editor<QDoubleSpinBox>("psfArea", "sigma")->setValue(2);
    editor<QSlider>("psfArea", "windowSize.slider")->setValue(3);
    QCOMPARE(editor<QSpinBox>("psfArea", "windowSize")->value(), 7);
    QCOMPARE(kernel->weights().size(), std::size_t(49));
    QVERIFY2(energy->text().contains("⚠ 15.4 % of the Gaussian's energy"),  // DESIGN §2
             qPrintable(energy->text()));
    const QString middle = kernel->textAt(kernel->rect().center() - QPointF(0, 12));
    QVERIFY2(middle.startsWith("Tap (0, 0): 4.67"), qPrintable(middle));  // 1 / Σ W
    QVERIFY(kernel->textAt({0, 0}).isEmpty());
    QVERIFY(isColour(colourOfTap(*kernel, "(0, 0)"), 1));
    QVERIFY(isColour(colourOfTap(*kernel, "(-3, 3)"), std::exp(-18.0 / 8)));
    QVERIFY(isColour(colourOfTap(*kernel, "(1, -2)"), std::exp(-5.0 / 8)));
    editor<QDoubleSpinBox>("psfArea", "sigma")->setValue(1);
    QVERIFY(!energy->text().contains("⚠"));
    QVERIFY(energy->text().startsWith("0.0930 %") || energy->text().startsWith("0.093 %"));
    QVERIFY(isColour(colourOfTap(*kernel, "(1, -2)"), std::exp(-5.0 / 2)));
    editor<QDoubleSpinBox>("psfArea", "sigma")->setValue(0);
    QVERIFY(kernel->weights().empty());
    QVERIFY(energy->text().contains("⚠"));
    editor<QSpinBox>("psfArea", "windowSize")->setValue(99);
    kernel->grab();
  }

  void theLensIsDrawnWithItsFold() {
    openSmall();
    child<QDockWidget>("distortionDock")->raise();
    auto* lens = m_window->findChild<LensView*>();
    QTRY_VERIFY(lens->isVisible());
    const QColor red(200, 40, 40);
    const QColor blue(52, 94, 150);
    for (const char* name : {"k1", "k2", "k3"})
      editor<QDoubleSpinBox>("distortionArea", name)->setValue(0);
    QTRY_VERIFY_WITH_TIMEOUT(count(lens, blue) > 1000 && count(lens, red) == 0, 20000);
    const int straight = count(lens, blue);
    editor<QDoubleSpinBox>("distortionArea", "k1")->setValue(-1.2);  // folds at r = 0.527
    QTRY_VERIFY_WITH_TIMEOUT(count(lens, red) > 500, 20000);
    QVERIFY(count(lens, blue) != straight);
    auto* certificate = child<QLabel>("certificateLabel");
    QVERIFY(certificate->text().contains("have no ray: the lens folds"));
    editor<QComboBox>("lightFieldArea", "mapping")->setCurrentText("direct");
    QTRY_VERIFY_WITH_TIMEOUT(count(lens, red) == 0, 20000);
    lens->resize(1, 1);
    lens->grab();
  }

  /// Grey from the edit on, until what is said is of this lens.
  void aStaleCertificateIsGrey() {
    openSmall();
    child<QDockWidget>("distortionDock")->raise();
    auto* certificate = child<QLabel>("certificateLabel");
    auto* lens = m_window->findChild<LensView*>();
    const auto isGrey = [&] { return !certificate->isEnabled() && !lens->isEnabled(); };
    QTRY_VERIFY_WITH_TIMEOUT(certificate->isEnabled() && lens->isEnabled(), 20000);
    const QString before = certificate->text();
    const int blue = count(lens, QColor(52, 94, 150));
    editor<QDoubleSpinBox>("distortionArea", "k1")->setValue(0.2);
    QVERIFY(isGrey());
    QCOMPARE(certificate->text(), before);
    QVERIFY(count(lens, QColor(52, 94, 150)) < blue / 10);
    QTRY_VERIFY_WITH_TIMEOUT(certificate->isEnabled() && lens->isEnabled(), 20000);
    QVERIFY(certificate->text() != before);
    editor<QDoubleSpinBox>("cameraArea", "eye.0")->setValue(0.01);  // the lens stays
    QVERIFY(!isGrey());
    // Another one and back before anything could be worked out.
    editor<QDoubleSpinBox>("distortionArea", "k1")->setValue(0.3);
    model()->undoStack()->undo();
    QVERIFY(!isGrey());
    child<QComboBox>("stateBox")->setCurrentIndex(3);
    QVERIFY(isGrey());
    QTRY_VERIFY_WITH_TIMEOUT(certificate->isEnabled(), 20000);
    editor<QDoubleSpinBox>("cameraArea", "eye.2")->setValue(0);  // the look-at: no camera
    QVERIFY(!certificate->text().isEmpty());
  }

  void statesAreListedAndChosen() {
    openSmall();
    QCOMPARE(list()->count(), 6);
    clickRow(3);
    QCOMPARE(model()->currentIndex(), std::size_t(3));
    QTest::keyClick(list(), Qt::Key_Down);
    QCOMPARE(model()->currentIndex(), std::size_t(4));
    child<QComboBox>("stateBox")->setCurrentIndex(1);
    QCOMPARE(list()->currentRow(), 1);
    press("addStateAction");
    QCOMPARE(names().back(), QString("View"));
    QCOMPARE(list()->currentRow(), 6);
    press("moveUpAction");
    QCOMPARE(names()[5], QString("View"));
    press("duplicateAction");
    QCOMPARE(names()[6], QString("View 2"));
    model()->undoStack()->undo();
    QCOMPARE(list()->count(), 7);
  }

  void statesAreRenamedInPlace() {
    openSmall();
    child<QDockWidget>("statesDock")->hide();
    const auto type = [this](const QString& name) {
      child<QAction>("renameAction")->trigger();
      QTRY_VERIFY(list()->isVisible() && list()->findChild<QLineEdit*>() != nullptr);
      auto* line = list()->findChild<QLineEdit*>();
      line->setText(name);
      QTest::keyClick(line, Qt::Key_Return);
      QTRY_VERIFY(list()->findChild<QLineEdit*>() == nullptr);
    };
    type("wide");
    QCOMPARE(names().front(), QString("wide"));
    QCOMPARE(model()->current().camera.name, std::string("wide"));
    QCOMPARE(child<QComboBox>("stateBox")->itemText(0), QString("wide"));
    type("Fig 2");
    QVERIFY2(message().contains("another state's already"), qPrintable(message()));
    QCOMPARE(names().front(), QString("wide"));
    type("a/b");
    QVERIFY(message().startsWith("Error"));
    QCOMPARE(names().front(), QString("wide"));
  }

  void statesAreDragged() {
    openSmall();
    clickRow(2);
    dragRow(2, 0, 0.2);
    QCOMPARE(names(), QStringList({"Fig 3", "Fig 1", "Fig 2", "Fig 4", "Fig 5", "Fig 6"}));
    QCOMPARE(model()->currentIndex(), std::size_t(0));  // still Fig 3
    QCOMPARE(list()->currentRow(), 0);
    QCOMPARE(model()->undoStack()->count(), 1);
    QVERIFY(model()->undoStack()->undoText().startsWith("Move "));
    model()->undoStack()->undo();
    QCOMPARE(names().front(), QString("Fig 1"));
    QCOMPARE(model()->current().camera.name, std::string("Fig 3"));
    // Several; the current one is none of them.
    clickRow(0);
    clickRow(1, Qt::ControlModifier);
    QTest::qWait(1100);  // else it is one edit with the next
    dragRow(1, 4, 0.8);
    QCOMPARE(names(), QStringList({"Fig 3", "Fig 4", "Fig 5", "Fig 1", "Fig 2", "Fig 6"}));
    QCOMPARE(model()->current().camera.name, std::string("Fig 2"));
    QCOMPARE(list()->count(), 6);
    // To where it is: nothing happens.
    const int steps = model()->undoStack()->count();
    clickRow(3);
    dragRow(3, 3, 0.9);
    QCOMPARE(model()->undoStack()->count(), steps);
    QCOMPARE(names()[3], QString("Fig 1"));
  }

  void severalStatesAreDeletedAndSaved() {
    openSmall();
    clickRow(1);
    clickRow(3, Qt::ControlModifier);
    clickRow(5, Qt::ControlModifier);
    auto* commands = m_window->findChild<StateCommands*>();
    const QString file = m_folder.filePath("some.json");
    QVERIFY(commands->saveStatesAs(file));
    const Session saved = loadSession(file.toStdString());
    QCOMPARE(saved.cameras.size(), std::size_t(3));
    QVERIFY(saved.cameras[1] == model()->session().cameras[3]);
    QVERIFY(saved.display == model()->session().display);
    QVERIFY(commands->appendStatesTo(file));
    QCOMPARE(loadSession(file.toStdString()).cameras.size(), std::size_t(6));
    press("removeAction");
    QCOMPARE(names(), QStringList({"Fig 1", "Fig 3", "Fig 5"}));
    QCOMPARE(list()->selectedItems().size(), 1);
    model()->undoStack()->undo();
    QCOMPARE(list()->count(), 6);
    list()->selectAll();
    press("removeAction");
    QCOMPARE(list()->count(), 6);
    QVERIFY(message().contains("a session needs one"));
  }

  void droppedSessionsGiveTheirStates() {
    openSmall();
    drop(sampleFile);
    QCOMPARE(list()->count(), 12);
    QCOMPARE(names()[6], QString("Fig 1 2"));
    drop(m_folder.filePath("none.json"));
    QVERIFY(message().contains("none.json"));
    drop("/etc/hosts");
    QCOMPARE(list()->count(), 12);
  }

  /// 300 states: what a step through them costs is not allowed to grow with the square.
  void manyStates() {
    openSmall();
    model()->changeStates("many", [](Session& session) {
      CameraState state = session.cameras[0];
      for (int k = 0; k < 294; ++k) {
        state.camera.name = "s" + std::to_string(k);
        session.cameras.push_back(state);
      }
      return std::size_t(0);
    });
    QCOMPARE(list()->count(), 300);
    for (int row = 0; row < 300; row += 10) {
      list()->setCurrentRow(row);
      QCOMPARE(model()->currentIndex(), std::size_t(row));
    }
    list()->selectAll();
    clickRow(list()->currentRow(), Qt::ControlModifier);
    press("removeAction");
    QCOMPARE(list()->count(), 1);
  }
};

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(VtkWidget::surfaceFormat());
  QApplication application(argc, argv);
  TestDocks test;
  return QTest::qExec(&test, argc, argv);
}
#include "test_docks.moc"
