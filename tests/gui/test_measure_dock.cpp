// SPDX-License-Identifier: BSD-3-Clause
// Drives the dock "Measure" of the real window: closed forms at once, the engine's figures when
// edits rest, the button that fits the content, and undo.
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSet>
#include <QSlider>
#include <QToolButton>
#include <QToolTip>
#include <QUndoStack>

#include "chart/depth_budget_chart.h"
#include "chart/plot_painting.h"
#include "gui/docks/chart_colours.h"
#include "gui/docks/design_parameters.h"
#include "gui/docks/measure_run_widget.h"
#include "gui/docks/measure_widget.h"
#include "gui/docks/sweep_widget.h"
#include "gui/view/image_widget.h"
#include "gui/widgets/colours.h"
#include "tests/gui/window_test.h"

using namespace hogelscope;

class TestMeasureDock : public WindowTest {
  Q_OBJECT

 private:
  QString status() const { return child<QLabel>("measureStatus")->text(); }
  QPushButton* fit() const { return child<QPushButton>("fitContentButton"); }
  QImage picture(const char* plot) const { return child<QWidget>(plot)->grab().toImage(); }
  double depth() const {
    return (*m_model->session().lightField.content.find<std::vector<double>>("position"))[2];
  }
  void editDisplay(const std::function<void(DisplayParams&)>& change) {
    Session content = m_model->session();
    change(content.display);
    m_model->setContent(content);
  }

 private Q_SLOTS:
  /// A mesh that stands far in front of the panel and behind it, on a display of few directions.
  void init() {
    writeFile(m_folder.filePath("a.obj"),
              "v -1 -1 -1 1 0 0\nv 1 -1 -1 1 0 0\nv 1 1 -1 0 1 0\nv -1 1 -1 0 1 0\n"
              "v -0.3 -0.3 1 0 0 1\nv 0.3 -0.3 1 0 0 1\nv 0 0.3 1 0 0 1\nf 1 2 3 4\nf 5 6 7\n");
    showWindow({1400, 800});
    QVERIFY(files(*m_window).open(m_folder.filePath("a.obj")));
    QTRY_VERIFY_WITH_TIMEOUT(!child<ImageWidget>("pictureView")->image().isNull(), patience);
    editDisplay([](DisplayParams& display) {
      display.hogels = {64, 64};
      display.directions = {16, 16};
    });
    QTest::keyClick(m_window.get(), Qt::Key_3, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(child<QWidget>("measureView")->isVisible());
  }
  void cleanup() { m_window.reset(); }

  void simulatesWhenEditsRest() {
    QTRY_VERIFY2_WITH_TIMEOUT(status().startsWith("Simulated; contrast differs"),
                              qPrintable(status()), patience);
    QVERIFY(status().section(' ', -1).toDouble() < 0.02);
    const QImage contrast = picture("contrastPlot");
    const QImage zone = picture("zonePlot");
    // An edit is followed at once.
    editDisplay([](DisplayParams& display) { display.fov = {30, 30}; });
    QCOMPARE(status(), QString("By formulas; the simulation follows"));
    QVERIFY(picture("contrastPlot") != contrast);
    QVERIFY(picture("zonePlot") != zone);
    QTRY_VERIFY_WITH_TIMEOUT(status().startsWith("Simulated"), patience);
  }

  void fitsTheContent() {
    QTRY_VERIFY_WITH_TIMEOUT(fit()->isEnabled(), patience);
    const double before = depth();
    const QString inside = fit()->text();
    QVERIFY2(fit()->toolTip().startsWith("scale "), qPrintable(fit()->toolTip()));
    QTest::mouseClick(fit(), Qt::LeftButton);
    QVERIFY(depth() != before);
    const auto percent = [](const QString& text) {
      return text.section('(', 1, 1).section(' ', 0, 0).toInt();
    };
    QTRY_VERIFY2_WITH_TIMEOUT(percent(fit()->text()) >= 95, qPrintable(fit()->text()), patience);
    QVERIFY(percent(inside) < 95);
    QTRY_COMPARE_WITH_TIMEOUT(fit()->toolTip(), QString("The content fits already"), patience);
    QVERIFY(!fit()->isEnabled());
    m_model->undoStack()->undo();
    QCOMPARE(depth(), before);
  }

  /// Nothing is worked out while the dock is hidden, and a hidden one stops.
  void restsWhileHidden() {
    child<QDockWidget>("measureDock")->hide();
    editDisplay([](DisplayParams& display) { display.fov = {40, 40}; });
    const QString before = status();
    QTest::qWait(800);
    QCOMPARE(status(), before);
    child<QDockWidget>("measureDock")->show();
    QTRY_VERIFY_WITH_TIMEOUT(status().startsWith("Simulated"), patience);
  }

  /// Sliders edit the session; A and B are two displays, of which the view shows both.
  void slidesTheDesign() {
    auto* slider = child<QSlider>("designDirections");
    const DisplayParams opened = m_model->session().display;
    QVERIFY(child<QToolButton>("designB")->isChecked());  // init() has edited the display
    const int before = slider->value();
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_PageUp);
    QCOMPARE(slider->value(), before + 100);
    const int directions = m_model->session().display.directions[0];
    QVERIFY(directions > opened.directions[0]);
    QCOMPARE(m_model->session().display.directions[1], directions);
    QCOMPARE(child<QLabel>("designDirectionsValue")->text(), QString::number(directions));
    QCOMPARE(m_model->undoStack()->undoText(), QString("Change directions across"));
    QTest::mouseClick(child<QToolButton>("designA"), Qt::LeftButton);
    const DisplayParams a = m_model->session().display;
    QVERIFY(a != opened);  // as the file was opened, before init() edited it
    QTest::mouseClick(child<QToolButton>("designB"), Qt::LeftButton);
    QCOMPARE(m_model->session().display.directions[0], directions);
    // A live scene belongs to the display that it was opened for: once B's is there, A needs its
    // own.
    QTRY_VERIFY_WITH_TIMEOUT(status().startsWith("Simulated"), patience);
    QTest::mouseClick(child<QPushButton>("compareDesigns"), Qt::LeftButton);
    auto* view = child<ImageWidget>("pictureView");
    // On a slow machine coarse pictures come first.
    QTRY_VERIFY_WITH_TIMEOUT(message().contains("both in") && !message().contains("resolution"),
                             patience);
    QVERIFY(!view->otherImage().isNull());
    QVERIFY2(view->notice().isEmpty(), qPrintable(view->notice()));
    QVERIFY(view->otherImage() != view->image());
    QCOMPARE(view->titles().last(), QString("A, as opened"));
    const QImage onA = view->otherImage();
    child<QAction>("stopComparingAction")->trigger();
    QTest::mouseClick(child<QToolButton>("designA"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(view->image() == onA, patience);
  }

  void holds_data() {
    QTest::addColumn<QString>("button");
    QTest::addColumn<double>("width");
    QTest::addColumn<int>("directions");
    QTest::newRow("size") << "holdSize" << 1.0 << 16;
    QTest::newRow("pitch") << "holdPitch" << 2.0 << 16;
    QTest::newRow("pixels") << "holdPixels" << 1.0 << 8;
  }
  /// Twice as many hogels: smaller ones, a larger panel, or fewer directions.
  void holds() {
    QFETCH(QString, button);
    QFETCH(double, width);
    QFETCH(int, directions);
    const double size = m_model->session().display.size[0];
    QTest::mouseClick(child<QToolButton>(button.toLatin1()), Qt::LeftButton);
    auto* slider = child<QSlider>("designHogels");
    // Logarithmic from 8 to 2048, eight doublings over 1000 steps.
    slider->setValue(slider->value() + 125);
    const DisplayParams& display = m_model->session().display;
    QCOMPARE(display.hogels[0], 128);
    QVERIFY(std::abs(display.size[0] - width * size) < 1e-9);
    QCOMPARE(display.directions[0], directions);
  }

  /// The value down keeps its ratio to the one across, and one direction stays one; the hogels of
  /// files stay as they are.
  void keepsRatios() {
    const auto parameter = [](const std::string& name) {
      return *std::ranges::find(designParameters(), name, &DesignParameter::name);
    };
    Session session = m_model->session();
    session.display.directions = {40, 1};
    session.display.fov = {40, 20};
    session.display.size = {0.5, 0.25};
    session = withValue(session, 0, parameter("Directions"), 200, Hold::size);
    QCOMPARE(session.display.directions, (std::array{200, 1}));
    session = withValue(session, 0, parameter("Fov"), 60, Hold::size);
    QCOMPARE(session.display.fov, (std::array{60.0, 30.0}));
    const Session live = withValue(session, 0, parameter("Size"), 1, Hold::pitch);
    QCOMPARE(live.display.size, (std::array{1.0, 0.5}));
    QCOMPARE(live.display.hogels, (std::array{128, 128}));
    session.lightField.layout = Layout::hogels;
    session.display.hogels = {0, 0};
    const Session files = withValue(session, 0, parameter("Size"), 1, Hold::pitch);
    QCOMPARE(files.display.hogels, (std::array{0, 0}));
  }

  /// The style sheet has no name left that the program does not know: Qt would drop all of it.
  void readsTheStyleSheet() {
    const QString sheet = m_window->styleSheet();
    QVERIFY(sheet.contains("QSlider"));
    QVERIFY(!sheet.mid(sheet.indexOf("*/")).contains('@'));
  }

  /// The windows that belong to the main window have its style sheet, too.
  void tipsAndMenusAreStyled() {
    QToolTip::showText({100, 100}, "tip", m_window.get());
    auto* menu = child<QMenu>("fileMenu");
    menu->popup({200, 200});
    const auto borderOf = [](QWidget* widget) {
      return widget->grab().toImage().pixelColor(widget->width() / 2, 0).name();
    };
    const QWidgetList windows = QApplication::topLevelWidgets();
    const auto tip = std::ranges::find_if(
        windows, [](const QWidget* one) { return one->inherits("QTipLabel"); });
    QVERIFY(tip != windows.end());
    QCOMPARE(borderOf(*tip), tokens().strongLine.name());
    QCOMPARE(borderOf(menu), tokens().strongLine.name());
    menu->hide();
    QToolTip::hideText();
  }

  void turnsLeakageOnAndOff() {
    auto* slider = child<QSlider>("designLeakage");
    slider->setValue(223);
    QCOMPARE(m_model->current().psf.sigma, 0.669);
    QCOMPARE(m_model->current().psf.windowSize, 5);
    slider->setValue(0);
    QCOMPARE(m_model->current().psf.windowSize, 1);
  }

  void tintsTheView() {
    auto* view = child<ImageWidget>("pictureView");
    QVERIFY(view->tint().isNull());
    child<QCheckBox>("tintBox")->setChecked(true);
    QTRY_VERIFY_WITH_TIMEOUT(!view->tint().isNull(), patience);
    QTRY_COMPARE_WITH_TIMEOUT(view->tint().size(), view->image().size(), patience);
    int tinted = 0, plain = 0;
    for (int y = 0; y < view->tint().height(); ++y)
      for (int x = 0; x < view->tint().width(); ++x)
        ++(view->tint().pixelColor(x, y).alpha() > 0 ? tinted : plain);
    QVERIFY(tinted > 0 && plain > 0);
    const QImage before = view->tint();
    editDisplay([](DisplayParams& display) { display.fov = {20, 20}; });
    QVERIFY(view->tint().isNull());  // it is of the display before
    QTRY_VERIFY_WITH_TIMEOUT(!view->tint().isNull(), patience);
    QVERIFY(view->tint() != before);
    child<QDockWidget>("measureDock")->hide();
    QVERIFY(view->tint().isNull());
    child<QDockWidget>("measureDock")->show();
  }

  /// The plot of megapixels over directions is a parabola.
  void sweeps() {
    const QImage before = picture("sweepPlot");
    // The range is proposed when a parameter is chosen.
    child<QComboBox>("sweepParameter")->setCurrentText("Field of view");
    child<QComboBox>("sweepParameter")->setCurrentText("Directions across");
    child<QComboBox>("sweepFigure")->setCurrentText("Pixels, Mpx");
    QTest::mouseClick(child<QPushButton>("sweepButton"), Qt::LeftButton);
    auto* sweep = m_window->findChild<SweepWidget*>();
    QTRY_VERIFY_WITH_TIMEOUT(!sweep->plot().series.empty(), patience);
    const Plot plot = sweep->plot();
    QCOMPARE(plot.titleAcross, std::string("Directions across"));
    const auto& points = plot.series.front().points;
    QVERIFY(points.size() > 5);
    QCOMPARE(points.front().across, 8.0);
    QCOMPARE(points.back().across, 32.0);
    for (const Plot::Point& point : points)
      QVERIFY(std::abs(point.up - 64 * 64 * point.across * point.across / 1e6) < 1e-9);
    QVERIFY(picture("sweepPlot") != before);
    child<QComboBox>("sweepFigure")->setCurrentText("PSNR to the ideal view, dB");
    QVERIFY(sweep->plot().series.front().points.back().up > 10);
    // What was swept goes with another session, and so does a sweep that runs.
    QTest::mouseClick(child<QPushButton>("sweepButton"), Qt::LeftButton);
    m_model->openNew(m_model->session());
    QVERIFY(sweep->plot().series.empty());
    QTRY_COMPARE_WITH_TIMEOUT(child<QPushButton>("sweepButton")->text(), QString("S&weep"),
                              patience);
    QVERIFY(sweep->plot().series.empty());
  }

  /// Errors of a unit are swept too: where the picture is good is said, the design is marked, and a
  /// point of the curve is read and taken with the mouse.
  void sweepsTheTwin() {
    child<QComboBox>("sweepParameter")->setCurrentText("Lens array · Rotation");
    QCOMPARE(child<QComboBox>("sweepFigure")->currentText(), QString("PSNR to the design, dB"));
    auto* from = child<QDoubleSpinBox>("sweepFrom");
    auto* to = child<QDoubleSpinBox>("sweepTo");
    QCOMPARE(from->value(), -0.1);
    QCOMPARE(to->value(), 0.1);
    from->setValue(-5);
    to->setValue(5);
    auto* sweep = m_window->findChild<SweepWidget*>();
    QTest::mouseClick(child<QPushButton>("sweepButton"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!sweep->plot().series.empty(), patience);
    const Plot plot = sweep->plot();
    const auto& points = plot.series.front().points;
    QCOMPARE(points.size(), std::size_t(12));
    QCOMPARE(points.front().across, -5.0);
    QVERIFY(points[5].up > points[0].up && points[6].up > points[11].up);
    QVERIFY(plot.mark == 0.0);
    // A limit between the middle and the ends is crossed on both sides.
    const double limit = std::round(0.5 * (std::min(points[5].up, points[6].up) +
                                           std::max(points.front().up, points.back().up)));
    child<QDoubleSpinBox>("sweepLimit")->setValue(limit);
    auto* answer = child<QLabel>("sweepAnswer");
    QVERIFY(answer->isVisible());
    QVERIFY2(answer->text().startsWith("PSNR to the design ≥ ") && answer->text().endsWith("°"),
             qPrintable(answer->text()));
    QVERIFY2(answer->text().contains("±") || answer->text().contains(" … "),
             qPrintable(answer->text()));
    QCOMPARE(sweep->plot().limit, std::optional(limit));
    child<QDoubleSpinBox>("sweepLimit")->setValue(200);
    QVERIFY2(answer->text().endsWith("nowhere in this range"), qPrintable(answer->text()));
    child<QComboBox>("sweepSense")->setCurrentIndex(1);
    QVERIFY2(answer->text().contains("≤ 200 dB: all of -5 … 5"), qPrintable(answer->text()));
    child<QComboBox>("sweepSense")->setCurrentIndex(0);
    child<QDoubleSpinBox>("sweepLimit")->setValue(30);
    // The mouse at a point, as the plot paints it.
    auto* chart = child<QWidget>("sweepPlot");
    const double text = chartFont().pixelSize();
    const double title = 1.6 * QFontMetrics(chartFont()).height();
    const QSizeF size(chart->width(), chart->height() - title);
    const auto at = placeOf(sweep->plot(), 8, size, text);
    QVERIFY(at.has_value());
    const QPoint place = (*at + QPointF(0, title)).toPoint();
    const QImage before = picture("sweepPlot");
    QTest::mouseMove(chart, QPoint(2, 2));
    QTest::mouseMove(chart, place);
    QTRY_COMPARE_WITH_TIMEOUT(sweep->hovered(), std::optional<std::size_t>(8), patience);
    QVERIFY(picture("sweepPlot") != before);
    const int edits = m_model->undoStack()->index();
    QTest::mouseClick(chart, Qt::LeftButton, {}, place);
    QCOMPARE(m_model->session().twin.lensArray.rotation, points[8].across);
    QCOMPARE(m_model->undoStack()->index(), edits + 1);
    QCOMPARE(m_model->undoStack()->undoText(), QString("Change lens array · rotation"));
    QVERIFY(sweep->plot().mark == points[8].across);
    m_model->undoStack()->undo();
    QCOMPARE(m_model->session().twin.lensArray.rotation, 0.0);
    QVERIFY(m_model->session().twin == TwinParams());
  }

  /// Every number of display and twin is there, reads as it is set, and keeps the session whole.
  void sweepsAllNumbers() {
    const auto& all = sweptParameters();
    QVERIFY(all.size() > 30);
    QSet<QString> labels;
    for (const DesignParameter& one : all) {
      QVERIFY2(!labels.contains(one.label), qPrintable(one.label));
      labels << one.label;
      const double value = one.isWhole ? 3 : 0.5 * (one.usualLeast + one.usualMost) + 1e-3;
      const Session set = withValue(m_model->session(), 0, one, value, Hold::size);
      QVERIFY2(std::abs(one.get(set, 0) - value) < 1e-12, qPrintable(one.label));
    }
    for (const char* const label :
         {"Display · Position x", "Lens array · Offset y", "Colour · Scale blue", "Shift · Sigma",
          "Random · Seed", "Light · Bits", "Gain · Sigma"})
      QVERIFY2(labels.contains(label), label);
    // A unit that changes light needs linear light.
    const auto gain = std::ranges::find(all, QString("Gain · Sigma"), &DesignParameter::label);
    const Session bright = withValue(m_model->session(), 0, *gain, 0.1, Hold::size);
    QVERIFY(bright.cameras[0].psf.light == LightModel::linear);
  }

  void measuresAll() {
    const QString folder = m_folder.filePath("all");
    m_window->findChild<MeasureRunWidget*>()->measureInto(folder);
    QTRY_VERIFY2_WITH_TIMEOUT(child<QLabel>("measureAllNote")->text().contains("rows are in all"),
                              qPrintable(child<QLabel>("measureAllNote")->text()), patience);
    for (const char* file : {"measure.csv", "measure.html", "plots/mtf.svg"})
      QVERIFY(QFileInfo::exists(folder + "/" + file));
    QVERIFY(child<QPushButton>("openMeasurePageButton")->isVisible());
    // A folder that cannot be made is said.
    writeFile(m_folder.filePath("file"), "");
    m_window->findChild<MeasureRunWidget*>()->measureInto(m_folder.filePath("file/all"));
    QTRY_VERIFY_WITH_TIMEOUT(child<QLabel>("measureAllNote")->text().contains("file"), patience);
  }

  void saysWhatIsWrong() {
    CameraState behind = m_model->current();
    behind.camera.eye.z = -1;
    behind.camera.lookat.z = -2;
    m_model->setCurrent(behind);
    QTRY_VERIFY2_WITH_TIMEOUT(status().contains("its eye is not in front of the panel"),
                              qPrintable(status()), patience);
    QVERIFY(!fit()->isEnabled());
  }
};

int main(int argc, char** argv) {
  return runWindowTest<TestMeasureDock>(argc, argv);
}
#include "test_measure_dock.moc"
