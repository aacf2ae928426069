// SPDX-License-Identifier: BSD-3-Clause
// Drives the docks of the real window: their places, the display and the light field.
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolButton>
#include <set>

#include "core/engine/fast_simulation.h"
#include "gui/docks/light_field_dock.h"
#include "gui/files/opening_dialog.h"
#include "gui/view/image_commands.h"
#include "gui/view/view_worker.h"
#include "io/opening/session_around.h"
#include "io/scene/view_source.h"
#include "tests/core/rendered.h"
#include "tests/gui/docks_test.h"
#include "tests/gui/shown_image.h"
#include "tests/gui/window_files.h"

using namespace hogelscope;

class TestDocks : public DocksTest {
  Q_OBJECT

 private:
  Image expected() const {
    const Session& session = m_model->session();
    return rendered(loadViewSource(session, {}).job(m_model->current()));
  }

  void nothingReplacesWhatIsRead(const QString& lightField) {
    const auto bytes = [&lightField] {
      QFile file(lightField);
      return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    const QByteArray before = bytes();
    QVERIFY(!files(*m_window).save(lightField));
    QVERIFY(message().contains("which is read"));
    QVERIFY(!m_window->findChild<ImageCommands*>()->saveImage(lightField));
    QVERIFY(message().contains("which is read"));
    QCOMPARE(bytes(), before);
  }

 private Q_SLOTS:
  void init() { showWindow(); }
  void cleanup() { m_window.reset(); }

  void theWindowFitsASmallScreen() {
    openSmall();
    m_window->resize(1280, 800);
    QTRY_COMPARE_WITH_TIMEOUT(m_window->size(), QSize(1280, 800), patience);
    QVERIFY(child<ImageWidget>("pictureView")->width() > 300);
    QVERIFY(list()->viewport()->height() >= 4 * list()->visualRect(at(0)).height());
  }

  /// A section stands in the column, or in a dock of its own while that is open.
  void aSectionTakenOut() {
    openSmall();
    auto* dock = child<QDockWidget>("cameraDock");
    auto* content = child<QWidget>("cameraArea");
    QVERIFY(dock->isHidden() && child<QDockWidget>("propertiesDock")->isAncestorOf(content));
    child<QAbstractButton>("cameraOutButton")->click();
    QVERIFY(dock->isVisible() && dock->isWindow() && dock->isAncestorOf(content));
    QVERIFY(content->isVisible() && !child<QWidget>("cameraHeader")->isVisible());
    editor<QDoubleSpinBox>("cameraArea", "eye.0")->setValue(0.1);
    QCOMPARE(m_model->current().camera.eye.x, 0.1);
    dock->setFloating(false);
    QVERIFY(dock->isVisible() && !dock->isWindow() && dock->isAncestorOf(content));
    dock->close();
    QVERIFY(child<QDockWidget>("propertiesDock")->isAncestorOf(content));
    QVERIFY(child<QAbstractButton>("cameraHeader")->isChecked());
    QVERIFY(content->isVisible());
    child<QAbstractButton>("cameraHeader")->click();
    QVERIFY(!content->isVisible());
    child<QAbstractButton>("cameraOutButton")->click();  // out it is open
    QVERIFY(content->isVisible());
    dock->close();
    QVERIFY(!content->isVisible());
  }

  /// A dock's key closes what can be seen, and brings to the front what cannot.
  void aDocksKey() {
    openSmall();
    const auto toggle = [](const QDockWidget* dock) {
      QAction* action = dock->toggleViewAction();
      QTest::keySequence(dock->parentWidget(), action->shortcut());
      QCoreApplication::processEvents();
      QCOMPARE(action->isChecked(), !dock->isHidden());
    };
    const auto isSeen = [](const QWidget* part) { return !part->visibleRegion().isEmpty(); };
    auto* states = child<QDockWidget>("statesDock");
    for (const bool isShown : {true, false, true}) {  // the first one goes to it
      toggle(states);
      QCOMPARE(isSeen(states), isShown);
    }
    for (const QString name :
         {"lightField", "display", "camera", "distortion", "psf", "sampling"}) {
      const auto* content = m_window->findChild<QWidget*>(name + "Area");
      QAction* action = m_window->findChild<QDockWidget*>(name + "Dock")->toggleViewAction();
      const bool wasSeen = isSeen(content);
      std::vector<bool> shown{!wasSeen, wasSeen};
      if (wasSeen) shown.insert(shown.begin(), true);  // the first one goes to it
      for (const bool isShown : shown) {
        QTest::keySequence(m_window.get(), action->shortcut());
        QTRY_COMPARE_WITH_TIMEOUT(isSeen(content), isShown, patience);
        QCOMPARE(action->isChecked(), isShown);
      }
    }
    child<QDockWidget>("propertiesDock")->hide();
    QTest::keySequence(m_window.get(),
                       child<QDockWidget>("psfDock")->toggleViewAction()->shortcut());
    QTRY_VERIFY_WITH_TIMEOUT(isSeen(child<QWidget>("psfArea")), patience);
    auto* report = child<QDockWidget>("reportDock");
    auto* tradeoff = child<QDockWidget>("tradeoffDock");
    toggle(report);
    QVERIFY(isSeen(report) && tradeoff->isHidden());
    toggle(tradeoff);
    QVERIFY(isSeen(tradeoff) && !isSeen(report) && !report->isHidden());
    toggle(report);
    QVERIFY(isSeen(report) && !isSeen(tradeoff) && !tradeoff->isHidden());
    report->setFloating(true);
    QCoreApplication::processEvents();
    QVERIFY(isSeen(report) && isSeen(tradeoff));
    toggle(report);
    QVERIFY(report->isHidden() && isSeen(tradeoff));
  }

  void theDisplayMovesWithoutReading() {
    openSmall();
    QSignalSpy loaded(m_window->findChild<ViewWorker*>(), &ViewWorker::loaded);
    const QImage before = view().copy();
    editor<QDoubleSpinBox>("displayArea", "size.0")->setValue(0.3);
    editor<QDoubleSpinBox>("displayArea", "orientation.1")->setValue(10);
    editor<QDoubleSpinBox>("displayArea", "fov.1")->setValue(50);
    editor<QComboBox>("displayArea", "lens")->setCurrentText("equiangular");
    editor<QComboBox>("samplingArea", "reconstruction")->setCurrentText("bilinear");
    editor<QSpinBox>("samplingArea", "samplesPerPixel")->setValue(2);
    QCOMPARE(m_model->undoStack()->undoText(), QString("Change samplesPerPixel"));
    QVERIFY(m_window->isWindowModified());
    const Image image = expected();
    QTRY_VERIFY_WITH_TIMEOUT(equals(view(), image), patience);
    QCOMPARE(loaded.count(), 0);
    while (m_model->undoStack()->canUndo()) m_model->undoStack()->undo();
    QTRY_VERIFY_WITH_TIMEOUT(view() == before, patience);
    QCOMPARE(editor<QDoubleSpinBox>("displayArea", "size.0")->value(), 0.5);
  }

  void lensesOfPlugins() {
    openSmall();
    const QImage before = view().copy();
    editor<QComboBox>("displayArea", "lens")->setCurrentText("plugin");
    auto* file = editor<QLineEdit>("displayArea", "file");
    QVERIFY(file != nullptr && file->isVisible());
    const auto type = [file](const QString& name) {
      file->setText(name);
      Q_EMIT file->editingFinished();
    };
    const QString table = m_folder.filePath("lens.csv");
    const Session plain = m_model->session();
    type(table);
    QVERIFY2(message().contains("lens.csv: cannot be read"), qPrintable(message()));
    QVERIFY(m_model->session() == plain);
    QCOMPARE(file->text(), QString());
    writeFile(table, "direction,angle\n-0.5,-40\n0.1,0\n0.5,20\n");
    type(table);
    QTRY_VERIFY_WITH_TIMEOUT(view() != before, patience);
    const Image image = expected();
    QTRY_VERIFY_WITH_TIMEOUT(equals(view(), image), patience);
    QCOMPARE(m_model->undoStack()->undoText(), QString("Change file"));
    auto* source = editor<QLineEdit>("displayArea", "lensSource");
    source->setText("fish-eye");
    Q_EMIT source->editingFinished();
    QVERIFY2(message().contains("plugin fish-eye: is not installed"), qPrintable(message()));
    QCOMPARE(source->text(), QString("measured-lens"));
    editor<QComboBox>("displayArea", "lens")->setCurrentText("rectilinear");
    QTRY_VERIFY_WITH_TIMEOUT(view() == before, patience);
    QVERIFY(file->isHidden() || !file->isVisible());
  }

  /// The same light field compared with itself stays the same image.
  void aComparisonFollowsTheDisplay() {
    openSmall();
    const QString file = QString::fromStdString(m_model->session().lightField.file);
    QVERIFY(m_window->findChild<ImageCommands*>()->compareWith(file));
    RenderedView last;
    connect(m_window->findChild<ViewWorker*>(), &ViewWorker::rendered, this,
            [&](const RenderedView& view) { last = view; });
    QTRY_VERIFY_WITH_TIMEOUT(!last.otherImage.isNull(), patience);
    editor<QDoubleSpinBox>("displayArea", "size.0")->setValue(0.3);
    editor<QSpinBox>("samplingArea", "samplesPerPixel")->setValue(2);
    const Image image = expected();
    QTRY_VERIFY_WITH_TIMEOUT(equals(last.image, image), patience);
    QVERIFY(equals(last.otherImage, image));
    disconnect(m_window->findChild<ViewWorker*>(), nullptr, this, nullptr);
  }

  void hogelsThatDoNotFitAreToldAndMended() {
    openSmall();
    auto* contents = child<QLabel>("contentsLabel");
    QTRY_VERIFY_WITH_TIMEOUT(contents->text().startsWith("128×128 hogels of 5×5 directions, 8 bit"),
                             patience);
    const QImage before = view().copy();
    for (const char* name : {"hogels.0", "hogels.1"})
      editor<QSpinBox>("displayArea", name)->setValue(64);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("64×64 hogels of 5×5 directions need"), patience);
    QVERIFY(view() == before);
    QVERIFY(child<ImageWidget>("pictureView")->notice().contains("64×64 hogels of 5×5"));
    editor<QDoubleSpinBox>("cameraArea", "eye.2")->setValue(0.7);  // nothing to render it from
    QTest::qWait(100);
    QVERIFY2(!message().startsWith("Reading"), qPrintable(message()));
    QCOMPARE(contents->text(), QString("No light field has been read."));
    for (const char* name : {"directions.0", "directions.1"})
      editor<QSpinBox>("displayArea", name)->setValue(10);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
    const Image image = expected();
    QTRY_VERIFY_WITH_TIMEOUT(equals(view(), image), patience);
    QVERIFY(contents->text().startsWith("64×64 hogels of 10×10 directions"));
  }

  void aFolderOpensAsASessionAndAnotherFileIsChosen() {
    QVERIFY(!child<QToolButton>("importButton")->isEnabled());
    for (int v = 0; v < 3; ++v)
      for (int u = 0; u < 4; ++u)
        writeImageFile(m_folder.filePath(QString("views/00%1_00%2.png").arg(v).arg(u)), 32, 24,
                       [&](int x, int y, int c) {
                         return float((x * 7 + y * 5 + 40 * u + 60 * v + 80 * c) % 256) / 255;
                       });
    QVERIFY(files(*m_window).open(m_folder.filePath("views")));
    // Nothing in these views tells their order.
    const auto dialog = [this] { return m_window->findChild<OpeningDialog*>(); };
    QTRY_VERIFY_WITH_TIMEOUT(dialog() != nullptr && dialog()->isVisible(), patience);
    dialog()->accept();
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
    QVERIFY(m_window->windowTitle().startsWith("new session"));
    QVERIFY(!m_window->isWindowModified());  // nothing was edited
    QCOMPARE(names(), QStringList("View"));
    QVERIFY(child<QLabel>("contentsLabel")->text().startsWith("32×24 hogels of 4×3 directions"));
    // Grey: the session leaves out what its files say.
    QTRY_COMPARE_WITH_TIMEOUT(editor<QSpinBox>("displayArea", "hogels.0")->text(), QString("32"),
                              patience);
    QCOMPARE(m_model->session().display.hogels[0], 0);
    QCOMPARE(editor<QDoubleSpinBox>("displayArea", "size.1")->value(), 0.375);
    editor<QSpinBox>("cameraArea", "res.0")->setValue(60);
    QVERIFY(!editor<QLineEdit>("lightFieldArea", "pattern")->isHidden());
    editor<QComboBox>("lightFieldArea", "rows")->setCurrentText("bottom-up");
    const Image flipped = expected();
    QTRY_VERIFY_WITH_TIMEOUT(equals(view(), flipped), patience);

    // A quilt: the layout follows, and the fields with it.
    const QString quilt = m_folder.filePath("q_qs2x2a1.png");
    writeImageFile(quilt, 40, 40, [](int x, int y, int) { return float(x + y) / 80; });
    m_window->findChild<LightFieldDock*>()->choose(quilt);
    QTRY_VERIFY_WITH_TIMEOUT(
        child<QLabel>("contentsLabel")->text().startsWith("20×20 hogels of 4×1"), patience);
    QCOMPARE(editor<QComboBox>("lightFieldArea", "layout")->currentText(), QString("quilt"));
    QVERIFY(editor<QLineEdit>("lightFieldArea", "pattern")->isHidden());
    auto* columns = editor<QSpinBox>("lightFieldArea", "columns");
    QVERIFY(columns->isVisibleTo(child<QWidget>("lightFieldArea")));
    QCOMPARE(columns->text(), QString("not given"));
    columns->setValue(4);
    QTRY_VERIFY_WITH_TIMEOUT(
        child<QLabel>("contentsLabel")->text().startsWith("10×20 hogels of 8×1"), patience);
    QVERIFY(files(*m_window).save(m_folder.filePath("around.json")));
    QVERIFY(loadSession(m_folder.filePath("around.json").toStdString()).cameras ==
            m_model->session().cameras);
  }

  /// The light field says the same number, which stands there in grey where it is left out.
  void aGivenNumberThatIsKnownTooStays() {
    QVERIFY(QDir::setCurrent(m_folder.path()));
    writeSmallSession();
    QVERIFY(files(*m_window).open("s.json"));
    auto* hogels = editor<QSpinBox>("displayArea", "hogels.0");
    const Session before = m_model->session();
    QVERIFY(before.display.hogels[0] > 0);
    QTRY_COMPARE_WITH_TIMEOUT(hogels->specialValueText(), hogels->text(), patience);
    hogels->interpretText();  // as when it loses the focus
    QVERIFY(m_model->session() == before);
  }

  void lenslets() {
    writeImageFile(m_folder.filePath("raw.png"), 60, 50,
                   [](int x, int y, int) { return float(x * y % 97) / 96; });
    m_model->openNew(sessionAround(m_folder.filePath("raw.png").toStdString()));
    auto* layout = editor<QComboBox>("lightFieldArea", "layout");
    layout->setCurrentText("lenslets");
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("raw.png: lenslets: are not found"), patience);
    QVERIFY(!editor<QLineEdit>("lightFieldArea", "white")->isHidden());
    QVERIFY(!editor<QLineEdit>("lightFieldArea", "dark")->isHidden());
    QVERIFY(!editor<QComboBox>("lightFieldArea", "grid")->isHidden());
    QCOMPARE(editor<QDoubleSpinBox>("lightFieldArea", "pitch")->text(), QString("not given"));
    editor<QDoubleSpinBox>("lightFieldArea", "pitch")->setValue(10);
    editor<QDoubleSpinBox>("lightFieldArea", "rotation")->setValue(0);
    editor<QDoubleSpinBox>("lightFieldArea", "origin.0")->setValue(4.5);
    editor<QDoubleSpinBox>("lightFieldArea", "origin.1")->setValue(4.5);
    QTRY_VERIFY_WITH_TIMEOUT(
        child<QLabel>("contentsLabel")->text().startsWith("6×5 hogels of 10×10 directions, 8 bit"),
        patience);
    layout->setCurrentText("hogels");
    QVERIFY(editor<QLineEdit>("lightFieldArea", "white")->isHidden());
  }

  void aHogelImageAsksForItsHogels() {
    writeImageFile(m_folder.filePath("plain.png"), 60, 60,
                   [](int x, int y, int) { return float((x * 7919 + x * y * 31) % 251) / 251; });
    m_model->openNew(sessionAround(m_folder.filePath("plain.png").toStdString()));
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("how many of them are hogels"), patience);
    QVERIFY(!files(*m_window).save(m_folder.filePath("plain.json")));
    for (const char* name : {"hogels.0", "hogels.1"})
      editor<QSpinBox>("displayArea", name)->setValue(10);
    for (const char* name : {"directions.0", "directions.1"})
      editor<QSpinBox>("displayArea", name)->setValue(6);
    QTRY_VERIFY_WITH_TIMEOUT(message().contains(" ms"), patience);
    QVERIFY(!view().isNull());
    nothingReplacesWhatIsRead(m_folder.filePath("plain.png"));
    QVERIFY(files(*m_window).open(m_folder.filePath("none.png")));
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("none.png: there is no such file"), patience);
    QVERIFY(m_window->windowTitle().startsWith("new session"));
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestDocks>(argc, argv);
}
#include "test_docks.moc"
