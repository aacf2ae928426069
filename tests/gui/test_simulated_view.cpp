// SPDX-License-Identifier: BSD-3-Clause
// Drives the real window: compares with a second light field, and scrubs a field fast.
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QImage>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTextDocumentFragment>
#include <QToolButton>
#include <QtTest>

#include "core/engine/fast_simulation.h"
#include "core/metrics/metric.h"
#include "core/optics/pixel_inspection.h"
#include "gui/scene/vtk_widget.h"
#include "gui/session/session_model.h"
#include "gui/view/comparison.h"
#include "gui/view/image_commands.h"
#include "gui/view/image_widget.h"
#include "gui/view/view_worker.h"
#include "io/documents/session_file.h"
#include "io/opening/session_around.h"
#include "picture/error_image.h"
#include "tests/core/rendered.h"
#include "tests/gui/patience.h"
#include "tests/gui/shown_image.h"
#include "tests/gui/window_files.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

const QString dataFolder = QStringLiteral(HOGELSCOPE_SOURCE_DIR "/tests/data/");
constexpr int side = 120;  ///< of an image: quick to render, like the light field of 16×16 hogels

QImage content(int grey) {
  QImage image(320, 320, QImage::Format_RGB888);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x)
      image.setPixelColor(x, y, QColor((x * 5 + grey) % 256, (y * 3) % 256, (x + y) % 256));
  return image;
}

}  // namespace

class TestSimulatedView : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;
  QString m_sampleFile;  ///< Table I's states before a small display
  QString m_ownFile;
  QString m_otherFile;
  std::unique_ptr<MainWindow> m_window;

  ImageWidget* view() const { return m_window->findChild<ImageWidget*>("pictureView"); }
  ImageCommands* commands() const { return m_window->findChild<ImageCommands*>(); }
  QAction* action(const char* name) const { return m_window->findChild<QAction*>(name); }
  QString message() const { return m_window->statusBar()->currentMessage(); }
  /// The image that is shown is not a smaller one.
  bool isFull() const { return message().contains(" ms") && !message().contains("resolution"); }
  void openSample() {
    QVERIFY(files(*m_window).open(m_sampleFile));
    QTRY_VERIFY_WITH_TIMEOUT(isFull(), patience);
  }
  void compare() {
    QVERIFY(commands()->compareWith(m_otherFile));
    QTRY_VERIFY_WITH_TIMEOUT(!view()->otherImage().isNull() && isFull(), patience);
  }
  void moveTo(const char* area, const char* name, int value) const {
    auto* widget = m_window->findChild<QWidget*>(area);
    widget->findChild<QSpinBox*>(name)->setValue(value);
  }
  Image expected(const QString& lightField, const CameraState& state, int samples = 1) const {
    Session session = loadSession(m_sampleFile.toStdString());
    session.sampling.samplesPerPixel = samples;
    return rendered(
        loadViewSource(withLightField(session, lightField.toStdString()), {}).job(state));
  }

 private Q_SLOTS:
  void initTestCase() {
    m_ownFile = m_folder.filePath("own.png");
    m_otherFile = m_folder.filePath("other.png");
    m_sampleFile = m_folder.filePath("sample.json");
    QVERIFY(content(0).save(m_ownFile) && content(100).save(m_otherFile));
    Session session = loadSession((dataFolder + "table1.json").toStdString(),
                                  {"display.hogels=[16,16]", "camera.res=[120,120]"});
    session.lightField.file = m_ownFile.toStdString();
    saveSession(m_sampleFile.toStdString(), session);
  }
  void init() {
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get(), patience));
    activate(m_window.get());
  }
  void cleanup() { m_window.reset(); }

  void saysHowItRenders() {
    QVERIFY(!action("compareAction")->isEnabled() && !action("savePictureAction")->isEnabled());
    openSample();
    QVERIFY2(message().startsWith("120 × 120 px in "), qPrintable(message()));
    QVERIFY2(message().contains("nearest, 1 ray a pixel, 25 of 25 taps, lens table kept, "),
             qPrintable(message()));
    QVERIFY(message().contains(" thread"));
    QVERIFY(action("compareAction")->isEnabled() && action("savePictureAction")->isEnabled());
    QVERIFY(!action("stopComparingAction")->isEnabled() && !action("wipeAction")->isEnabled());
  }

  void comparesEachStateWithASecondLightField() {
    openSample();
    compare();
    Session session = loadSession(m_sampleFile.toStdString());
    QVERIFY(equals(view()->image(), expected(m_ownFile, session.cameras[0])));
    QVERIFY(equals(view()->otherImage(), expected(m_otherFile, session.cameras[0])));
    QVERIFY2(message().startsWith("120 × 120 px, both in "), qPrintable(message()));
    moveTo("psfArea", "windowSize", 1);
    session.cameras[0].psf.windowSize = 1;
    const Image own = expected(m_ownFile, session.cameras[0]);
    const Image other = expected(m_otherFile, session.cameras[0]);
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), own) && equals(view()->otherImage(), other),
                             patience);
  }

  void keysChooseHowToCompare() {
    openSample();
    compare();
    const QImage own = view()->image();
    const QImage other = view()->otherImage();
    QCOMPARE(view()->shownImage().size(), QSize(2 * side, side));
    QTest::keyClick(m_window.get(), Qt::Key_4, Qt::ControlModifier);
    QVERIFY(action("differenceAction")->isChecked());
    QCOMPARE(view()->shownImage(), errorImage(own, other, ErrorMap({.hasFalseColour = true})));
    QTest::keyClick(m_window.get(), Qt::Key_3, Qt::ControlModifier);
    QCOMPARE(view()->shownImage().size(), QSize(side, side));
    const QRect left(0, 0, 55, side);
    const QRect right(65, 0, 55, side);
    QCOMPARE(view()->shownImage().copy(left), own.copy(left));
    QCOMPARE(view()->shownImage().copy(right), other.copy(right));
    QTest::keyClick(m_window.get(), Qt::Key_1, Qt::ControlModifier);
    QCOMPARE(view()->shownImage(), own);
    const auto toned = [&](Qt::Key key) {  // wherever the focus is
      QTest::keyClick(m_window.get(), key, Qt::AltModifier);
      return std::pair(view()->gain(), view()->gamma());
    };
    QCOMPARE(toned(Qt::Key_Plus), std::pair(2.0, 1.0));
    QCOMPARE(toned(Qt::Key_Minus), std::pair(1.0, 1.0));
    QCOMPARE(toned(Qt::Key_Comma), std::pair(1.0, 0.8));
    QCOMPARE(toned(Qt::Key_Minus), std::pair(0.5, 0.8));
    QCOMPARE(toned(Qt::Key_Period), std::pair(0.5, 1.0));
    QCOMPARE(toned(Qt::Key_Period), std::pair(0.5, 1.2));
    QCOMPARE(toned(Qt::Key_0), std::pair(1.0, 1.0));
    QTest::keyClick(m_window.get(), Qt::Key_2, Qt::ControlModifier);
    QVERIFY(action("sideBySideAction")->isChecked() && !action("singleAction")->isChecked());
    QCOMPARE(view()->shownImage().copy(side, 0, side, side), other);
  }

  void theBarIsThereWhileComparing() {
    auto* bar = m_window->findChild<QWidget*>("comparisonBar");
    openSample();
    QVERIFY(!bar->isVisible() && !action("blinkAction")->isEnabled());
    compare();
    QVERIFY(bar->isVisible());
    for (auto* button : bar->findChildren<QToolButton*>()) {
      QVERIFY(!button->text().isEmpty() && !button->toolTip().isEmpty());
      QVERIFY(button->isVisible() && bar->rect().contains(button->geometry()));
    }
    const auto press = [&](const char* name) {
      for (auto* button : m_window->findChildren<QToolButton*>())
        if (button->isVisible() && button->defaultAction() == action(name))
          QTest::mouseClick(button, Qt::LeftButton, {}, QPoint(5, 5));
    };
    press("wipeAction");
    QVERIFY(action("wipeAction")->isChecked());
    press("differenceAction");
    const QImage own = view()->image();
    const QImage other = view()->otherImage();
    QCOMPARE(view()->shownImage(), errorImage(own, other, ErrorMap({.hasFalseColour = true})));
    press("falseColourAction");
    QCOMPARE(view()->shownImage(), errorImage(own, other, ErrorMap({})));
    press("falseColourAction");
    QTest::keyClick(m_window.get(), Qt::Key_7, Qt::ControlModifier);
    QVERIFY(action("blinkAction")->isChecked());
    // The kind is chosen in any mode.
    QTest::keyClick(m_window.get(), Qt::Key_3, Qt::AltModifier);
    QVERIFY(action("differenceAction")->isChecked());
    QCOMPARE(
        view()->shownImage(),
        errorImage(own, other, ErrorMap({.kind = ErrorKind::squared, .hasFalseColour = true})));
    m_window->grab().save(QCoreApplication::applicationDirPath() + "/compared.png");
    action("stopComparingAction")->trigger();
    QVERIFY(!bar->isVisible());
  }

  /// The mask says of each pixel that is not seen what becomes of its ray, as the trace does.
  void theMaskSaysWhy() {
    Session session = loadSession(m_sampleFile.toStdString());
    CameraState& state = session.cameras[0];
    state.camera.eye = {0.35, 0, 0.4};
    state.camera.fov = 90;
    state.distortion = {.k1 = -0.9};
    const QString file = m_folder.filePath("mask.json");
    saveSession(file.toStdString(), session);
    QVERIFY(files(*m_window).open(file));
    QTRY_VERIFY_WITH_TIMEOUT(isFull(), patience);
    QVERIFY(view()->seen().format() != QImage::Format_Indexed8);
    QTest::keyClick(m_window.get(), Qt::Key_M, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(view()->seen().format() == QImage::Format_Indexed8 && isFull(),
                             patience);
    const QImage seen = view()->seen();
    const RenderJob job = loadViewSource(session, {}).job(state);
    std::array<int, 4> counts{};
    for (int y = 0; y < side; y += 3)
      for (int x = 0; x < side; x += 3) {
        const RayEnd end = pixelTrace(job, x, y).end;
        QCOMPARE(RayEnd(seen.pixelIndex(x, y)), end);
        QCOMPARE(qGray(seen.pixel(x, y)) != 0, end == RayEnd::seen);
        ++counts[std::size_t(end)];
      }
    for (const int count : counts) QVERIFY(count > 20);
    QTest::keyClick(m_window.get(), Qt::Key_M, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(view()->seen().format() != QImage::Format_Indexed8, patience);
  }

  /// Each step stays until it is done, in any order, and does not come again.
  void theNextStepIsSaidOnce() {
    QSettings().remove("window/hintsUsed");
    openSample();
    auto* guide = m_window->findChild<QLabel*>("guide");
    QVERIFY(guide->isVisible() && guide->text().contains("drag the orange eye"));
    auto* model = m_window->findChild<SessionModel*>();
    model->edit("Directions", [](Session& session) { session.display.fov = {50, 50}; });
    QVERIFY(guide->text().contains("drag the orange eye"));
    CameraState state = model->current();
    state.camera.eye.x += 0.01;
    model->setCurrent(state);
    QVERIFY2(guide->text().contains("click a black"), qPrintable(guide->text()));
    QTRY_VERIFY_WITH_TIMEOUT(view()->notice().isEmpty(), patience);
    QTest::mouseClick(view(), Qt::LeftButton, {}, view()->rect().center());
    QVERIFY2(guide->text().contains("drag Directions"), qPrintable(guide->text()));
    openSample();
    QVERIFY(guide->isVisible() && guide->text().contains("drag Directions"));
    model->edit("Directions", [](Session& session) { session.display.directions = {5, 5}; });
    QVERIFY(!guide->isVisible());
    openSample();
    QVERIFY(!guide->isVisible());
  }

  /// By the functions of the report, of what is seen and of the rectangle.
  void figuresAreThoseOfTheReport() {
    openSample();
    compare();
    auto* figures = m_window->findChild<QLabel*>("comparisonFigures");
    const CameraState state = loadSession(m_sampleFile.toStdString()).cameras[0];
    const Image own = expected(m_ownFile, state);
    const Image other = expected(m_otherFile, state);
    const auto words = [](const std::vector<double>& values) {
      return QString("PSNR %1 dB SSIM %2 Seen in both")
          .arg(values[psnrSeenColumn], 0, 'f', 2)
          .arg(values[ssimSeenColumn], 0, 'f', 4);
    };
    const QString whole = words(MetricSet().compare(own, other));
    const auto shown = [&] {
      return QTextDocumentFragment::fromHtml(figures->text()).toPlainText().simplified();
    };
    QTRY_VERIFY2_WITH_TIMEOUT(shown().startsWith(whole), qPrintable(shown() + whole), patience);
    const QRect part(2, 3, 50, 20);  // not all of it is seen
    const auto cut = [&](const Image& image) {
      Image result(part.width(), part.height());
      for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
          const auto to = std::size_t(y * result.width + x);
          const auto from = std::size_t((y + part.y()) * image.width + x + part.x());
          result.seen[to] = image.seen[from];
          for (std::size_t k = 0; k < 3; ++k) result.rgb[3 * to + k] = image.rgb[3 * from + k];
        }
      return result;
    };
    view()->setRegion(part);
    const QString inside = words(MetricSet().compare(cut(own), cut(other)));
    QVERIFY(inside != whole);
    QTRY_VERIFY2_WITH_TIMEOUT(shown().contains("Rectangle 50 × 20 at 2, 3: " + inside),
                              qPrintable(shown() + inside), patience);
    QVERIFY(shown().startsWith(whole));
    QTest::keyClick(m_window.get(), Qt::Key_H, Qt::ControlModifier | Qt::ShiftModifier);
    auto* histogram = m_window->findChild<HistogramWidget*>();
    QVERIFY(histogram->isVisible());
    const std::vector<Histogram> counts{lumaHistogram(cut(own)), lumaHistogram(cut(other))};
    QTRY_VERIFY_WITH_TIMEOUT(histogram->histograms() == counts, patience);
    action("stopComparingAction")->trigger();  // of the one picture there still is one
    QTRY_COMPARE_WITH_TIMEOUT(histogram->histograms().size(), std::size_t(1), patience);
    QVERIFY(figures->text().isEmpty());
  }

  void whatIsComparedIsOfferedToTheReport() {
    openSample();
    m_window->findChild<QDockWidget*>("reportDock")->show();
    auto* add = m_window->findChild<QPushButton*>("addComparedButton");
    QVERIFY(!add->isVisible());
    const auto* make = m_window->findChild<QPushButton*>("makeReportButton");
    QTest::qWait(100);
    const int top = make->mapTo(m_window.get(), QPoint()).y();
    compare();
    QVERIFY(add->isVisible());
    QTest::qWait(100);
    QCOMPARE(make->mapTo(m_window.get(), QPoint()).y(), top);  // it does not jump
    QCOMPARE(add->text(), QString("A&dd other.png"));
    add->setFocus();
    add->click();
    QVERIFY(make->hasFocus());
    auto* tests = m_window->findChild<QListWidget*>("testList");
    QCOMPARE(tests->count(), 1);
    QCOMPARE(tests->item(0)->text(), m_otherFile);
    QVERIFY(!add->isVisible());
    m_window->findChild<QPushButton*>("removeTestButton")->click();
    QVERIFY(add->isVisible());
    action("stopComparingAction")->trigger();
    QVERIFY(!add->isVisible());
  }

  /// From the View menu, wherever the focus is.
  void fitsAndShowsOneToOne() {
    auto* view = m_window->findChild<ImageWidget*>("pictureView");
    auto* one = m_window->findChild<QAction*>("oneToOneViewAction");
    QVERIFY(!one->isEnabled());
    openSample();
    QVERIFY(view->viewport().fits);
    QTest::keyClick(m_window.get(), Qt::Key_6, Qt::ControlModifier);
    QVERIFY(!view->viewport().fits);
    QCOMPARE(view->viewport().zoom, 1.0);
    QTest::keyClick(m_window.get(), Qt::Key_5, Qt::ControlModifier);
    QVERIFY(view->viewport().fits);
    one->trigger();
    QCOMPARE(view->viewport().zoom, 1.0);
  }

  void theOtherLightFieldIsFreedWhenComparingStops() {
    openSample();
    for (const bool isBySession : {false, true}) {
      compare();
      const std::weak_ptr<const LightFieldSource> memory = commands()->other()->lightField;
      QVERIFY(!memory.expired());
      if (isBySession)
        openSample();
      else
        action("stopComparingAction")->trigger();
      QVERIFY(view()->otherImage().isNull() || isBySession);
      QTRY_VERIFY_WITH_TIMEOUT(memory.expired(), patience);
      QTRY_VERIFY_WITH_TIMEOUT(view()->otherImage().isNull(), patience);
      QVERIFY(!action("stopComparingAction")->isEnabled() && !action("wipeAction")->isEnabled());
      QTRY_VERIFY_WITH_TIMEOUT(isFull(), patience);
    }
  }

  void stopsReading() {
    openSample();
    for (const bool isRead : {false, true}) {  // but nobody has heard of it
      QVERIFY(commands()->compareWith(m_otherFile));
      QVERIFY(action("stopComparingAction")->isEnabled());
      const auto* comparison = m_window->findChild<Comparison*>();
      if (isRead) QVERIFY(sleepUntil([&] { return comparison->readShare() == 1; }));
      action("stopComparingAction")->trigger();
      QTest::qWait(100);
      QVERIFY(!commands()->other());
      QVERIFY(view()->otherImage().isNull());
    }
  }

  void aWrongFileIsToldAndChangesNothing() {
    openSample();
    compare();
    const QImage own = view()->image();
    const QImage other = view()->otherImage();
    const QString text = m_folder.filePath("text.png");
    writeFile(text, "no picture");
    const QString small = m_folder.filePath("small.png");
    QVERIFY(QImage(30, 20, QImage::Format_RGB888).save(small));
    const QString session = m_folder.filePath("bad.json");
    writeFile(session, R"({"hogelscope": 1, "cameras": []})");
    for (const QString& file : {text, small, session, m_folder.filePath("none.png"),
                                m_folder.filePath("none.json"), m_folder.path()}) {
      m_window->statusBar()->clearMessage();
      (void)commands()->compareWith(file);
      QTRY_VERIFY2_WITH_TIMEOUT(message().startsWith("Error: "), qPrintable(message()), patience);
      QVERIFY2(!message().contains('\n'), qPrintable(message()));
      QCOMPARE(view()->image(), own);
      QCOMPARE(view()->otherImage(), other);
      QVERIFY(commands()->other() && action("stopComparingAction")->isEnabled());
    }
  }

  void savesAndCopiesWhatIsShown() {
    openSample();
    compare();
    action("differenceAction")->trigger();
    const QString file = m_folder.filePath("shown.png");
    QVERIFY(commands()->saveImage(file));
    QCOMPARE(QImage(file).convertToFormat(QImage::Format_RGB888), view()->shownImage());
    action("copyPictureAction")->trigger();
    QCOMPARE(QGuiApplication::clipboard()->image().convertToFormat(QImage::Format_RGB888),
             view()->shownImage());
    QVERIFY(!commands()->saveImage(m_folder.filePath("none/shown.png")));
    QVERIFY2(message().startsWith("Error: ") && message().contains("shown.png"),
             qPrintable(message()));
  }

  void savesAFigureOfTheComparison() {
    openSample();
    QVERIFY(!action("saveFigureAction")->isEnabled());
    const QString file = m_folder.filePath("figure.png");
    compare();
    QVERIFY(action("saveFigureAction")->isEnabled());
    QVERIFY(commands()->saveFigure(file));
    const QImage figure = QImage(file).convertToFormat(view()->image().format());
    constexpr int gap = 6, top = 19;  // of a sheet with pictures of 120 rows
    const auto part = [&](int k, int y, int height) {
      return figure.copy(gap + k * (side + gap), y, side, height);
    };
    const auto picture = [&](int k) { return part(k, top, side); };
    QCOMPARE(picture(0), view()->image());
    QCOMPARE(picture(1), view()->otherImage());
    QVERIFY(picture(2) != picture(0) && picture(2) != picture(1));
    QImage white(side, top, figure.format());
    white.fill(Qt::white);
    for (int k = 0; k < 3; ++k) QVERIFY(part(k, 0, top) != white);  // has a label
    QVERIFY(!commands()->saveFigure(m_ownFile));                    // an input
    action("stopComparingAction")->trigger();
    QVERIFY(!action("saveFigureAction")->isEnabled() && !commands()->saveFigure(file));
    QVERIFY2(message().startsWith("Error: ") && message().contains("figure.png"),
             qPrintable(message()));
  }

  void theMaskIsOfEachImage() {
    openSample();
    m_window->findChild<QComboBox*>("stateBox")->setCurrentIndex(2);
    const Image third = expected(m_ownFile, loadSession(m_sampleFile.toStdString()).cameras[2]);
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), third) && isFull(), patience);
    const QImage plain = view()->grab().toImage();
    QTest::keyClick(m_window.get(), Qt::Key_M, Qt::ControlModifier);
    QVERIFY(view()->grab().toImage() != plain);
    QTest::keyClick(m_window.get(), Qt::Key_M, Qt::ControlModifier);
    QCOMPARE(view()->grab().toImage(), plain);
  }

  /// The exact image of the newest edit comes at last, and nothing after it; where a full image
  /// takes longer than an edit, smaller ones come meanwhile.
  void theNewestWinsWhileAFieldIsScrubbed() {
    openSample();
    compare();
    moveTo("samplingArea", "samplesPerPixel", 16);
    moveTo("cameraArea", "res.0", 2 * side);
    std::vector<RenderedView> views;
    connect(m_window->findChild<ViewWorker*>(), &ViewWorker::rendered, this,
            [&](const RenderedView& rendered) { views.push_back(rendered); });
    QTRY_VERIFY_WITH_TIMEOUT(view()->image().width() == 2 * side && isFull(), patience);
    const bool isSlow = views.back().milliseconds > 3 * ViewPace::quick;
    views.clear();
    auto* k1 = m_window->findChild<QWidget*>("distortionArea")->findChild<QDoubleSpinBox*>("k1");
    const double start = k1->value();
    constexpr std::size_t edits = 20;
    for (int step = 1; step <= int(edits); ++step) {
      k1->setValue(start - 0.02 * step);
      QTest::qWait(10);
    }
    Session session = loadSession(m_sampleFile.toStdString());
    CameraState& state = session.cameras[0];
    state.camera.res = {2 * side, side};
    state.distortion.k1 = k1->value();
    QVERIFY(state.distortion.k1 < 0.59);
    const Image own = expected(m_ownFile, state, 16);
    const Image other = expected(m_otherFile, state, 16);
    QTRY_VERIFY_WITH_TIMEOUT(equals(view()->image(), own), patience);
    QVERIFY(equals(view()->otherImage(), other));
    QVERIFY(isFull());
    QCOMPARE(views.back().scale, 1);
    QVERIFY(views.size() <= 2 * edits);
    const auto full = std::count_if(views.begin(), views.end(),
                                    [](const RenderedView& v) { return v.scale == 1; });
    QVERIFY2(!isSlow || int(views.size()) > full, "no smaller picture came");
    QVERIFY(full <= int(edits));
    for (const RenderedView& rendered : views)
      QCOMPARE(rendered.image.size(), QSize(2 * side, side));
    QTest::qWait(300);
    QVERIFY(equals(view()->image(), own));  // nothing older comes after it
  }

  void closesWhileReading() {
    QVERIFY(files(*m_window).open(dataFolder + "table1.json"));
    QTRY_VERIFY_WITH_TIMEOUT(isFull(), patience);
    QVERIFY(commands()->compareWith(dataFolder + "scene.png"));
    m_window.reset();  // must neither hang nor crash
  }
};

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  TestSimulatedView test;
  return QTest::qExec(&test, argc, argv);
}
#include "test_simulated_view.moc"
