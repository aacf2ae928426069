// SPDX-License-Identifier: BSD-3-Clause
// Opens light fields without a session, in the real window: what is sure opens at once, what is in
// doubt is asked, and whatever is dropped is used for what it is, without an error.
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTextDocument>
#include <cmath>

#include "gui/files/file_commands.h"
#include "gui/files/opening_dialog.h"
#include "gui/view/image_widget.h"
#include "gui/widgets/colours.h"
#include "io/opening/opening.h"
#include "io/scene/view_source.h"
#include "io/store/store_writer.h"
#include "tests/gui/habits_test.h"
#include "tests/gui/window_files.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"
#include "tests/io/layered_views.h"

using namespace hogelscope;

namespace {

/// No hogels at all.
void writePhotograph(const QString& file, int width, int height) {
  writeImageFile(file, width, height, [=](int x, int y, int c) {
    return float((x * 7919 + y * 104729 + x * y * 31 + c * 7) % 251) / 251;
  });
}

/// A folder of 3 × 5 views whose rows run upwards.
void writeViews(const QString& folder, int rows = 3, int columns = 5) {
  QVERIFY(QDir().mkpath(folder));
  const GreyGrid grid = gridOf(randomScene(7, 1, 6), rows, columns, {true, false, false});
  for (int k = 0; k < rows * columns; ++k) {
    const GreyPicture view = grid.view(k / columns, k % columns);
    const QImage image(view.values.data(), view.width, view.height, view.width,
                       QImage::Format_Grayscale8);
    QVERIFY(image.save(QString("%1/00%2_00%3.png").arg(folder).arg(k / columns).arg(k % columns)));
  }
}

}  // namespace

class TestOpening : public HabitsTest {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    start();
    makeWindow({});
  }
  void cleanup() { stop(); }

  void aHogelImageOpensAtOnce() {
    writeTwoWalls(path("h.png"), 40, 30, 24, 18);
    drop({path("h.png")});
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    QVERIFY(dialog() == nullptr);
    QVERIFY((model().session().display.hogels == std::array{40, 30}));
    QCOMPARE(errors(), QString());
  }

  /// What no picture says stands above the picture, until it is closed or chosen.
  void whatWasAssumedIsSaid() {
    writeTwoWalls(path("h.png"), 40, 30, 24, 18);
    auto* change = m_window->findChild<QAction*>("changeOpeningAction");
    QVERIFY(!change->isEnabled());
    drop({path("h.png")});
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    auto* bar = m_window->findChild<QWidget*>("noteBar");
    auto* line = m_window->findChild<QLabel*>("noteLine");
    QVERIFY(bar->isVisible() && change->isEnabled());
    QVERIFY2(
        line->text().startsWith("40×30 hogels of 24×18 directions · assumed: panel 0.5×0.2812 m"),
        qPrintable(line->text()));
    QVERIFY(line->text().endsWith("field of view 60×60°"));
    m_window->findChild<QAbstractButton*>("noteCure")->click();
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    QTest::keyClick(dialog(), Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, patience);
    m_window->findChild<QAbstractButton*>("noteClose")->click();
    QVERIFY(!bar->isVisible());
    drop({m_session});
    QTRY_VERIFY_WITH_TIMEOUT(!change->isEnabled(), patience);  // a session says all itself
  }

  /// Of a picture that nothing is known of the window asks, and stays as it was if it is not told.
  void whatNothingIsKnownOfIsAsked() {
    writePhotograph(path("p.png"), 240, 180);
    const Session before = model().session();
    drop({path("p.png")});
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    QVERIFY(!openButton()->isEnabled());
    QVERIFY(label("headlineLabel").startsWith("How many hogels?"));
    QVERIFY(label("headlineLabel").contains("? please check"));
    QVERIFY(label("assumedLabel").contains("no borders of hogels stand out"));
    QVERIFY(label("problemLabel").contains("how many of them are hogels"));
    QCOMPARE(preview()->image(),  // the picture itself
             QImage(path("p.png")).convertToFormat(QImage::Format_RGB888));
    for (const auto& [layout, question] :
         {std::pair(Layout::quilt, "How many views?"), std::pair(Layout::mosaic, "How many views?"),
          std::pair(Layout::lenslets, "How many lenslets?")}) {
      field<QComboBox>("layout")->setCurrentIndex(int(layout));
      QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
      QVERIFY2(label("headlineLabel").startsWith(question), qPrintable(label("headlineLabel")));
    }
    QTest::keyClick(dialog(), Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(dialog() == nullptr, patience);
    QVERIFY(model().session() == before);
    QCOMPARE(errors(), QString());
  }

  /// One number says the rest, for square hogels; a number of directions says it too.
  void oneNumberOfHogelsIsEnough() {
    writePhotograph(path("p.png"), 240, 180);
    drop({path("p.png")});
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    field<QSpinBox>("hogels.0")->setValue(24);
    QTRY_VERIFY_WITH_TIMEOUT(isSettled() && openButton()->isEnabled(), patience);
    QCOMPARE(field<QSpinBox>("hogels.1")->value(), 18);
    QCOMPARE(field<QSpinBox>("directions.0")->value(), 10);
    field<QSpinBox>("directions.0")->setValue(7);
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    QVERIFY(!openButton()->isEnabled());
    QVERIFY(label("problemLabel").contains("is 240×180 px, but"));
    QCOMPARE(field<QSpinBox>("directions.0")->value(), 7);  // as it was typed
    field<QSpinBox>("directions.0")->setValue(12);
    field<QSpinBox>("directions.1")->setValue(12);
    QTRY_VERIFY_WITH_TIMEOUT(isSettled() && openButton()->isEnabled(), patience);
    QCOMPARE(field<QSpinBox>("hogels.0")->value(), 20);
    QCOMPARE(headline(), QString("20 × 15 hogels of 12 × 12  ✓ sure"));
    QVERIFY(reasons().contains("chosen here"));
    QTest::mouseClick(openButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    QVERIFY((model().session().display.hogels == std::array{20, 15}));
    QVERIFY((model().session().display.directions == std::array{12, 12}));
    QCOMPARE(errors(), QString());
  }

  void aFolderOfViewsOpensAtOnce() {
    writeViews(path("v"));
    drop({path("v")});
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    QVERIFY(dialog() == nullptr);
    QVERIFY(model().session().lightField.rows == RowOrder::bottomUp);
    QCOMPARE(errors(), QString());
  }

  /// The preview is the contact sheet of what the fields say, and the newest edit wins.
  void theOrderOfViewsIsCorrected() {
    writeViews(path("v"));
    askAbout(path("v/001_001.png"));
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    field<QComboBox>("layout")->setCurrentIndex(int(Layout::views));
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    QVERIFY(label("assumedLabel").contains("rows bottom-up, columns left-right"));
    const QImage found = preview()->image();
    const Opening opening = inspectFile(path("v").toStdString(), {}, {});
    const Image sheet = previewOf(opening, {}).image;
    QCOMPARE(found.size(), QSize(sheet.width, sheet.height));
    QVERIFY(found == QImage(sheet.rgb.data(), sheet.width, sheet.height, 3 * sheet.width,
                            QImage::Format_RGB888));
    auto* rows = field<QComboBox>("rows");
    for (int k = 0; k < 6; ++k) rows->setCurrentIndex(k % 2);  // top-down first
    rows->setCurrentIndex(0);
    QVERIFY(!openButton()->isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(isSettled() && openButton()->isEnabled(), patience);
    QVERIFY(label("assumedLabel").contains("rows top-down, columns left-right"));
    QVERIFY(label("assumedLabel").contains("chosen here, but"));
    QVERIFY(preview()->image() != found);
    rows->setCurrentIndex(1);  // what was found, but the heading says who says it
    QTRY_VERIFY_WITH_TIMEOUT(isSettled() && openButton()->isEnabled(), patience);
    constexpr int heading = 24;  // px
    const auto below = [&](const QImage& image) {
      return image.copy(0, heading, image.width(), image.height() - heading);
    };
    QVERIFY(preview()->image() != found && below(preview()->image()) == below(found));
    rows->setCurrentIndex(0);
    QTRY_VERIFY_WITH_TIMEOUT(isSettled() && openButton()->isEnabled(), patience);
    QTest::mouseClick(openButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    QVERIFY(model().session().lightField.rows == RowOrder::topDown);
    QCOMPARE(errors(), QString());
  }

  /// A hole among the views makes their order less sure: the dialog names it.
  void missingViewsAreNamed() {
    writeViews(path("v"));
    QVERIFY(QFile::remove(path("v/000_004.png")));
    askAbout(path("v/001_001.png"));
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    field<QComboBox>("layout")->setCurrentIndex(int(Layout::views));
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    QVERIFY(label("assumedLabel").contains("1 of 15 views are missing"));
    QVERIFY(openButton()->isEnabled());
  }

  /// Chosen among its neighbours, a picture may stand for all of them.
  void aViewStandsForItsFolder() {
    writeViews(path("v"));
    askAbout(path("v/000_001.png"));
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    field<QComboBox>("layout")->setCurrentIndex(int(Layout::views));
    QTRY_VERIFY_WITH_TIMEOUT(isSettled() && openButton()->isEnabled(), patience);
    QVERIFY(headline().endsWith("hogels of 5 × 3  ✓ sure"));
    QTest::mouseClick(openButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    QVERIFY(model().session().lightField.layout == Layout::views);
    QCOMPARE(QFileInfo(QString::fromStdString(model().session().lightField.file)).fileName(),
             QString("v"));
  }

  /// Where no pattern can be told from the names, one is asked for.
  void namesThatSayNothing() {
    writeViews(path("v"), 1, 2);
    QVERIFY(QFile::rename(path("v/000_000.png"), path("v/cam 2 1.png")));
    QVERIFY(QFile::rename(path("v/000_001.png"), path("v/camera 1 1.png")));
    drop({path("v")});
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    QVERIFY(label("problemLabel").contains("give lightField.pattern"));
    auto* pattern = field<QLineEdit>("pattern");
    pattern->setText("cam* CC RR.png");
    Q_EMIT pattern->editingFinished();
    QTRY_VERIFY_WITH_TIMEOUT(isSettled() && openButton()->isEnabled(), patience);
    QCOMPARE(errors(), QString());
  }

  /// By its name at once; without one by its tiles, and then it is asked.
  void aQuilt() {
    const auto quilt = [](int px, int py, int c) {
      const int view = px / 120 + 5 * (3 - py / 120);
      const double x = (px % 120 + 0.4 * view) / 120, y = (py % 120) / 120.0;
      return float(0.5 + 0.2 * std::sin(31 * x + 5 * y + c) + 0.2 * std::sin(27 * y - 8 * x));
    };
    writeImageFile(path("q_qs5x4a1.png"), 600, 480, quilt);
    drop({path("q_qs5x4a1.png")});
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    QVERIFY(model().session().lightField.layout == Layout::quilt);
    QVERIFY(dialog() == nullptr);
    startAnew();
    writeImageFile(path("tiles.png"), 600, 480, quilt);
    drop({path("tiles.png")});
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    QCOMPARE(field<QComboBox>("layout")->currentIndex(), int(Layout::quilt));
    QCOMPARE(headline(), QString("120 × 120 hogels of 20 × 1  ? please check"));
    QVERIFY(reasons().contains("tiles in the picture"));
    const auto columnsAre = [this](int columns, const char* said) {
      field<QSpinBox>("columns")->setValue(columns);
      QTRY_VERIFY_WITH_TIMEOUT(isSettled() && openButton()->isEnabled(), patience);
      QCOMPARE(headline(), QString(said));
    };
    columnsAre(10, "60 × 120 hogels of 40 × 1  ✓ sure");
    columnsAre(5, "120 × 120 hogels of 20 × 1  ✓ sure");
    QTest::mouseClick(openButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    QCOMPARE(model().session().lightField.quiltColumns, 5);
    QCOMPARE(model().session().lightField.quiltRows, 4);
    QCOMPARE(errors(), QString());
  }

  /// Asked, as a guess; another number of views is taken at once, and one number stands for both.
  void aMosaic() {
    const auto tiles = [](int px, int py, int c) {
      const int column = px / 120, row = py / 120;
      const int x = px % 120 + column, y = py % 120 + row;
      const auto texture = [c](double s, double t) {
        return 0.2 * std::sin(0.26 * s + 0.04 * t + c) + 0.2 * std::sin(0.23 * t - 0.07 * s);
      };
      const bool isNear = std::hypot(px % 120 + 3 * column - 60, py % 120 + 3 * row - 60) < 30;
      return float(0.5 +
                   (isNear ? texture(x + 2 * column + 9, 1.3 * (y + 2 * row)) : texture(x, y)));
    };
    writeImageFile(path("tiles.png"), 600, 480, tiles);
    drop({path("tiles.png")});
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    QCOMPARE(field<QComboBox>("layout")->currentIndex(), int(Layout::mosaic));
    QCOMPARE(headline(), QString("120 × 120 hogels of 5 × 4  ~ likely"));
    auto* across = field<QSpinBox>("directions.0");
    QVERIFY(across != nullptr && across->isVisible());
    across->setValue(10);
    QTRY_VERIFY_WITH_TIMEOUT(isSettled() && openButton()->isEnabled(), patience);
    QVERIFY(headline().startsWith("60 × 120 hogels of 10 × 4 "));
    across->setValue(5);
    QTRY_VERIFY_WITH_TIMEOUT(isSettled() && openButton()->isEnabled(), patience);
    QVERIFY(headline().startsWith("120 × 120 hogels of 5 × 4 "));
    QTest::mouseClick(openButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    QVERIFY(model().session().lightField.layout == Layout::mosaic);
    QCOMPARE(model().session().display.directions, (std::array{5, 4}));
    QCOMPARE(errors(), QString());
  }

  void aMeshACalibrationAndAStore() {
    writeFile(path("a.obj"), "v -1 -1 0\nv 1 -1 0\nv 0 1 0.5\nf 1 2 3\n");
    drop({path("a.obj")});
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    QVERIFY(model().session().lightField.layout == Layout::live);
    QCOMPARE(errors(), QString());
    startAnew();
    writeFile(path("k.yml"),
              "%YAML:1.0\ncamera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
              "   data: [ 60., 0., 40., 0., 60., 30., 0., 0., 1. ]\n"
              "distortion_coefficients: !!opencv-matrix\n   rows: 4\n   cols: 1\n   dt: d\n"
              "   data: [ 0.125, 0., 0., 0. ]\n");
    drop({path("k.yml")});
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    QCOMPARE(model().current().distortion.k1, 0.125);
    QVERIFY(errors().contains("k.yml: does not say the size of its pictures"));
    startAnew();
    writeStore();
    drop({path("s.tif")});
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    QVERIFY(model().session().lightField.layout == Layout::pack);
    QVERIFY(dialog() == nullptr);
    QCOMPARE(errors(), QString());
  }

  /// With a session open a light field is compared with it, or opens where the display cannot show
  /// it; what is no light field is an error, and the session stays.
  void whatCannotBeComparedOpens() {
    makeWindow({m_session});
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    writeTwoWalls(path("h.png"), 40, 30, 24, 18);
    drop({path("h.png")});
    QTRY_VERIFY_WITH_TIMEOUT(model().file().isEmpty() && hasPicture(), patience);
    QVERIFY((model().session().display.hogels == std::array{40, 30}));
    QCOMPARE(errors(), QString());
    writeFile(path("junk.png"), "no picture");
    const Session before = model().session();
    drop({path("junk.png")});
    QTRY_VERIFY_WITH_TIMEOUT(errors().contains("junk.png"), patience);
    QVERIFY(dialog() == nullptr && model().session() == before);
  }

  /// Spots of light on a regular grid, as under the lenslets of a plenoptic camera: a guess, which
  /// stays while other fields are corrected. The picture is dark, its preview is not.
  void aDarkCaptureThroughLenslets() {
    writeImageFile(path("raw.png"), 338, 272, [](int x, int y, int c) {
      const double u = std::remainder(x - 5.6, 11.25), v = std::remainder(y - 5.6, 11.25);
      const double scene = 1 + 0.4 * std::sin(x / 40.0 + y / 60.0);
      return float((c == 0 ? 0.12 : 0.06) * scene * std::exp(-(u * u + v * v) / 14));
    });
    drop({path("raw.png")});
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    QCOMPARE(field<QComboBox>("layout")->currentIndex(), int(Layout::lenslets));
    QCOMPARE(headline(), QString("30 × 24 hogels of 11 × 11  ~ likely"));
    QCOMPARE(label("previewCaption"), QString("contrast stretched"));
    const QColor middle = preview()->image().pixelColor(preview()->image().rect().center());
    QVERIFY2(middle.red() > 100 && middle.red() > middle.green() + 30, qPrintable(middle.name()));
    field<QDoubleSpinBox>("gain")->setValue(4);  // still a guess's, but bright
    QTRY_VERIFY_WITH_TIMEOUT(isSettled() && openButton()->isEnabled(), patience);
    QCOMPARE(field<QComboBox>("layout")->currentIndex(), int(Layout::lenslets));
    QCOMPARE(label("previewCaption"), QString());
    QCOMPARE(headline(), QString("30 × 24 hogels of 11 × 11  ~ likely"));
    QTest::mouseClick(openButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
    QVERIFY(model().session().lightField.layout == Layout::lenslets);
    QCOMPARE(errors(), QString());
  }

  /// The command asks even where all is sure; one more Return opens.
  void openAsAlwaysAsks() {
    writeTwoWalls(path("h.png"), 40, 30, 24, 18);
    askAbout(path("h.png"));
    QTRY_VERIFY_WITH_TIMEOUT(isSettled(), patience);
    QVERIFY(openButton()->isEnabled());
    QCOMPARE(headline(), QString("40 × 30 hogels of 24 × 18  ✓ sure"));
    QVERIFY(!label("assumedLabel").contains("borders of hogels"));
    QVERIFY(reasons().contains("borders of hogels in the picture"));
    // No picture says how large the panel is, nor its field of view.
    const QString amber = QString("<span style='color:%1'>assumed").arg(tokens().amber.name());
    const QStringList rows = label("assumedLabel").split("<tr>");
    for (const char* what : {"Panel", "Field of view"}) {
      const QStringList row = rows.filter(QString("<b>%1</b>").arg(what));
      QVERIFY2(row.size() == 1 && row[0].contains(amber), what);
    }
    QTest::keyClick(dialog(), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(hasPicture(), patience);
  }

 private:
  [[nodiscard]] QString path(const char* name) const { return m_folder->filePath(name); }
  [[nodiscard]] OpeningDialog* dialog() const { return m_window->findChild<OpeningDialog*>(); }
  [[nodiscard]] ImageWidget* preview() const {
    return dialog()->findChild<ImageWidget*>("previewView");
  }
  /// There is a dialog, with a preview.
  [[nodiscard]] bool isSettled() const {
    return dialog() != nullptr && dialog()->isVisible() &&
           !preview()->notice().startsWith("Looking");
  }
  [[nodiscard]] QString label(const char* name) const {
    return dialog()->findChild<QLabel*>(name)->text();
  }
  [[nodiscard]] QString headline() const {
    QTextDocument text;
    text.setHtml(label("headlineLabel"));
    return text.toPlainText().replace(QChar::Nbsp, ' ');
  }
  [[nodiscard]] QString reasons() const {
    return dialog()->findChild<QLabel*>("headlineLabel")->toolTip();
  }
  [[nodiscard]] QPushButton* openButton() const {
    return dialog()->findChild<QDialogButtonBox*>("buttons")->button(QDialogButtonBox::Open);
  }
  template <class T>
  T* field(const char* name) const {
    return dialog()->findChild<T*>(name);
  }
  [[nodiscard]] bool hasPicture() const {
    const auto* view = m_window->findChild<ImageWidget*>("pictureView");
    return dialog() == nullptr && !view->image().isNull() && view->notice().isEmpty();
  }
  /// By File ▸ Open light field as.
  void askAbout(const QString& file) {
    const DialogAnswer answer(file);
    action("openLightFieldAsAction")->trigger();
  }
  /// Nothing is left that would have to be recovered.
  void startAnew() {
    m_window.reset();
    QDir(autosaveFolder()).removeRecursively();
    makeWindow({});
  }
  void writeStore() const {
    const Session session = loadSession(m_session.toStdString());
    const auto file = openLightField(session.lightField, session.display);
    const std::string store = path("s.tif").toStdString();
    pack(*file, planPack(session.lightField, *file, session.display, 100000000), store, 0, {});
  }
};

int main(int argc, char** argv) {
  return runHabitsTest<TestOpening>(argc, argv);
}
#include "test_opening.moc"
