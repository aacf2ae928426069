// SPDX-License-Identifier: BSD-3-Clause
// The widget for images alone: zoom, pan, linked views, the ways to compare, read-out and mask,
// by what it paints. Positions are worked out here from the definition of one to one: one image
// pixel on one pixel of the screen.
#include "gui/view/image_widget.h"

#include <QAction>
#include <QSignalSpy>
#include <QtTest>
#include <cmath>

#include "core/base/colour_map.h"
#include "gui/view/view_worker.h"
#include "picture/error_image.h"
#include "tests/gui/patience.h"
#include "tests/gui/shown_image.h"

using namespace hogelscope;

namespace {

/// Every pixel tells where it is.
QImage coordinates(int width, int height, int blue) {
  QImage image(width, height, QImage::Format_RGB888);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.setPixelColor(x, y, QColor(x, y, blue));
  return image;
}

constexpr int firstBlue = 50;
constexpr int secondBlue = 90;

}  // namespace

class TestImageWidget : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<ImageWidget> m_view;

  /// The screen's own pixels.
  QImage grabbed() const {
    QImage image = m_view->grab().toImage();
    image.setDevicePixelRatio(1);
    return image;
  }
  double ratio() const { return m_view->devicePixelRatioF(); }
  /// What is painted under a place of the widget.
  QColor at(const QPointF& position) const {
    return grabbed().pixelColor((position * ratio()).toPoint());
  }
  void wheel(const QPointF& position, int angle) {
    QWheelEvent event(position, m_view->mapToGlobal(position), {}, {0, angle}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(m_view.get(), &event);
  }
  void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(m_view.get(), which, modifiers);
  }
  void compare() {
    m_view->setImages(coordinates(200, 150, firstBlue), coordinates(200, 150, secondBlue));
  }
  /// At once, not when the display server says so.
  void mouse(QEvent::Type type, const QPoint& position, Qt::KeyboardModifiers modifiers = {}) {
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, QPointF(position), m_view->mapToGlobal(QPointF(position)), button,
                      Qt::LeftButton, modifiers);
    QApplication::sendEvent(m_view.get(), &event);
  }
  void look(const QPoint& position) { mouse(QEvent::MouseMove, position); }
  void drag(const std::vector<QPoint>& way) {
    mouse(QEvent::MouseButtonPress, way.front());
    for (const QPoint& position : way) look(position);
    mouse(QEvent::MouseButtonRelease, way.back());
  }
  /// A read-out hides what is painted beneath it.
  void lookAway() {
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(m_view.get(), &leave);
  }
  /// "x 12, y 34"
  QString placeAt(const QPoint& position) {
    look(position);
    return m_view->readOut().section(':', 0, 0);
  }

 private Q_SLOTS:
  void init() {
    m_view = std::make_unique<ImageWidget>();
    m_view->resize(400, 300);
    m_view->setImages(coordinates(200, 150, firstBlue));
    m_view->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_view.get(), patience));
    activate(m_view.get());
    m_view->setFocus();
    lookAway();
  }
  void cleanup() { m_view.reset(); }

  void fitsAtFirstAndShowsEachPixel() {
    QCOMPARE(at({1, 1}), QColor(0, 0, firstBlue));
    QCOMPARE(at({399, 299}), QColor(199, 149, firstBlue));
    QCOMPARE(at({201, 151}), QColor(100, 75, firstBlue));
    m_view->resize(500, 300);  // bars left and right, 50 wide
    QTRY_COMPARE_WITH_TIMEOUT(m_view->width(), 500, patience);
    QCOMPARE(at({51, 1}), QColor(0, 0, firstBlue));
    QVERIFY(at({48, 1}) != QColor(0, 0, firstBlue));
  }

  void oneToOneIsTheScreensOwnPixels() {
    key(Qt::Key_1);
    QCOMPARE(m_view->viewport().zoom, 1.0);
    const QImage image = grabbed();
    const QPoint corner((image.width() - 200) / 2, (image.height() - 150) / 2);
    QCOMPARE(image.copy(QRect(corner, QSize(200, 150))).convertToFormat(QImage::Format_RGB888),
             coordinates(200, 150, firstBlue));
    key(Qt::Key_0);
    QVERIFY(m_view->viewport().fits);
    QCOMPARE(at({1, 1}), QColor(0, 0, firstBlue));
  }

  void zoomKeepsThePointUnderThePointer() {
    for (const QPoint position : {QPoint(311, 91), QPoint(61, 251), QPoint(201, 151)}) {
      key(Qt::Key_0);
      const QString place = placeAt(position);
      QVERIFY(place.startsWith("x "));
      for (const int angle : {120, 120, 120, 240, -120, 120}) {
        wheel(position, angle);
        QCOMPARE(placeAt(position), place);
      }
      QVERIFY(m_view->viewport().zoom >= 8);
    }
    // Powers of √2 from 1/32 to 64; a wheel of finer steps adds up.
    for (int k = 0; k < 40; ++k) wheel({200, 150}, 120);
    QCOMPARE(m_view->viewport().zoom, 64.0);
    for (int k = 0; k < 40; ++k) wheel({200, 150}, -120);
    QCOMPARE(m_view->viewport().zoom, 1.0 / 32);
    for (int k = 0; k < 4; ++k) wheel({200, 150}, 30);
    QCOMPARE(m_view->viewport().zoom, std::sqrt(2.0) / 32);
  }

  void keysZoomAboutTheMiddle() {
    key(Qt::Key_1);
    const QPointF middle = m_view->viewport().centre;
    key(Qt::Key_Plus);
    key(Qt::Key_Plus);
    QCOMPARE(m_view->viewport().zoom, 2.0);
    key(Qt::Key_Minus);
    QVERIFY(std::abs(m_view->viewport().zoom - std::sqrt(2.0)) < 1e-12);
    const QPointF moved = m_view->viewport().centre - middle;
    QVERIFY(std::abs(moved.x()) < 1e-9 && std::abs(moved.y()) < 1e-9);
  }

  void neighboursAreNotMixedAboveOneToOneAndAGridShowsThem() {
    key(Qt::Key_1);
    for (int k = 0; k < 4; ++k) key(Qt::Key_Plus);
    QCOMPARE(m_view->viewport().zoom, 4.0);
    lookAway();
    const auto strangers = [&] {
      int count = 0;
      const QImage image = grabbed();
      for (int x = 0; x < image.width(); ++x)
        if (image.pixelColor(x, image.height() / 2 + 1).blue() != firstBlue) ++count;
      return count;
    };
    QCOMPARE(strangers(), 0);
    for (int k = 0; k < 2; ++k) key(Qt::Key_Plus);
    QCOMPARE(m_view->viewport().zoom, 8.0);
    const int lines = grabbed().width() / 8;
    QVERIFY2(std::abs(strangers() - lines) <= 1, qPrintable(QString::number(strangers())));
  }

  void belowOneToOneItAverages() {
    QImage checks(400, 300, QImage::Format_RGB888);
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 400; ++x)
        checks.setPixelColor(x, y, (x + y) % 2 == 0 ? Qt::white : Qt::black);
    m_view->setImages(checks);
    key(Qt::Key_1);
    for (int k = 0; k < 4; ++k) key(Qt::Key_Minus);
    QCOMPARE(m_view->viewport().zoom, 0.25);
    const QColor grey = at({200, 150});
    QVERIFY2(std::abs(grey.red() - 128) < 12, qPrintable(grey.name()));
  }

  void dragAndArrowsMoveTheImage() {
    key(Qt::Key_1);
    for (int k = 0; k < 4; ++k) key(Qt::Key_Plus);
    const QString place = placeAt({200, 150});
    drag({{200, 150}, {215, 160}, {260, 110}});
    QCOMPARE(placeAt({260, 110}), place);
    const double x = m_view->viewport().centre.x();
    key(Qt::Key_Right);
    const double step = 400 * ratio() / 10 / 4;
    QVERIFY(std::abs(m_view->viewport().centre.x() - (x + step)) < 0.5);
    key(Qt::Key_Left);
    QVERIFY(std::abs(m_view->viewport().centre.x() - x) < 0.5);
    for (int k = 0; k < 50; ++k) key(Qt::Key_Down);
    QCOMPARE(m_view->viewport().centre.y(), 150.0);  // the image is not lost
  }

  void aClickPicksAPixelADragDoesNot() {
    const QSignalSpy picked(m_view.get(), &ImageWidget::pixelPicked);
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, {101, 51});
    QCOMPARE(picked.count(), 1);
    QCOMPARE(picked[0][0].toInt(), 50);
    QCOMPARE(picked[0][1].toInt(), 25);
    drag({{101, 51}, {150, 90}});
    QCOMPARE(picked.count(), 1);
    m_view->setImages({});
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, {101, 51});
    QCOMPARE(picked.count(), 1);
  }

  void sideBySideShowsBothAlike() {
    compare();
    const QImage image = grabbed();  // each pane is 199 wide, the image 0.995 times its size
    QCOMPARE(image.pixelColor(QPoint(100, 150) * ratio()).blue(), firstBlue);
    QCOMPARE(image.pixelColor(QPoint(300, 150) * ratio()).blue(), secondBlue);
    key(Qt::Key_1);
    for (int k = 0; k < 2; ++k) key(Qt::Key_Plus);
    lookAway();
    const QColor left = at({100.5, 150.5});
    const QColor right = at({301.5, 150.5});
    QVERIFY(std::abs(left.red() - right.red()) <= 1 && left.green() == right.green());
    QCOMPARE(left.blue(), firstBlue);
    QCOMPARE(right.blue(), secondBlue);
    const QString place = placeAt({102, 151});
    wheel({102, 151}, 120);
    QCOMPARE(placeAt({102, 151}), place);
    wheel({320, 100}, 240);
    wheel({320, 100}, -240);
    QCOMPARE(placeAt({102, 151}), place);
  }

  void theWipesLineIsWhereItIsPut() {
    compare();
    m_view->setMode(ImageWidget::Mode::wipe);
    const auto isAt = [&](int line) {  // widget coordinates, two pixels of shade at most
      return at({line - 4.0, 100}).blue() == firstBlue &&
             at({line + 4.0, 100}).blue() == secondBlue;
    };
    QVERIFY(isAt(200));
    drag({{202, 100}, {120, 100}, {80, 100}});
    lookAway();
    QVERIFY(isAt(80));
    QVERIFY(m_view->viewport().fits);  // the line moved, not the image
    key(Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(m_view->wipe(), 0.22);
    QVERIFY(isAt(88));
    key(Qt::Key_Left, Qt::ShiftModifier);
    key(Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(isAt(72));
    const QImage shown = m_view->shownImage();
    QCOMPARE(shown.size(), QSize(200, 150));
    QCOMPARE(shown.pixelColor(35, 7), QColor(35, 7, firstBlue));
    QCOMPARE(shown.pixelColor(36, 7), QColor(36, 7, secondBlue));
  }

  void theDifferenceIsTimesTheGain() {
    compare();
    m_view->setMode(ImageWidget::Mode::difference);
    m_view->setGain(1);
    QCOMPARE(at({201, 151}), QColor(0, 0, secondBlue - firstBlue));
    key(Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(m_view->gain(), 2.0);
    QCOMPARE(at({201, 151}), QColor(0, 0, 80));
    for (int k = 0; k < 9; ++k) key(Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(m_view->gain(), 128.0);
    QCOMPARE(at({201, 151}), QColor(0, 0, 255));
    for (int k = 0; k < 9; ++k) key(Qt::Key_Down, Qt::ShiftModifier);
    QCOMPARE(m_view->gain(), 1.0);
    QCOMPARE(m_view->shownImage(),
             errorImage(coordinates(200, 150, firstBlue), coordinates(200, 150, secondBlue),
                        ErrorMap({ErrorKind::absolute, {1, 1}})));
    QVERIFY(errorImage(coordinates(2, 3, 0), coordinates(3, 2, 0), ErrorMap({})).isNull());
    QImage light(1, 1, QImage::Format_RGB888);
    QImage dark = light;
    light.fill(QColor(10, 200, 30));
    dark.fill(QColor(13, 100, 30));
    const auto map = [](double gain) { return ErrorMap({ErrorKind::absolute, {gain, 1}}); };
    QCOMPARE(errorImage(light, dark, map(2)).pixelColor(0, 0), QColor(6, 200, 0));
    QCOMPARE(errorImage(light, dark, map(4)).pixelColor(0, 0), QColor(12, 255, 0));
  }

  /// The window does not wait for the map of large images, and the newest of many wins; what is
  /// saved is right meanwhile.
  void largeErrorMapsComeFromAThread() {
    constexpr int width = 1400, height = 1000;
    QImage own(width, height, QImage::Format_RGB888);
    QImage other = own;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < 3 * width; ++x) {
        own.scanLine(y)[x] = uchar(x * 7 ^ y * 13);
        other.scanLine(y)[x] = uchar(x * 7 ^ y * 13 ^ (x * y) % 32);
      }
    const auto wanted = [&](int gain) {
      QImage map(width, height, QImage::Format_RGB888);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < 3 * width; ++x)
          map.scanLine(y)[x] = uchar(
              std::min(255, gain * std::abs(int(own.scanLine(y)[x]) - int(other.scanLine(y)[x]))));
      return map;
    };
    const auto shows = [&](const QImage& map) {
      const QPoint middle(200, 150);
      const QImage image = grabbed();
      const double ratio = m_view->devicePixelRatioF();
      const QPoint offset(int(width / 2 - ratio * middle.x()),
                          int(height / 2 - ratio * middle.y()));
      for (int y = 40; y < image.height() - 40; ++y)
        for (int x = 0; x < image.width(); ++x)
          if (image.pixelColor(x, y) != map.pixelColor(QPoint(x, y) + offset)) return false;
      return true;
    };
    m_view->setMode(ImageWidget::Mode::difference);
    m_view->setImages(own, other);
    m_view->oneToOne();
    lookAway();
    QCOMPARE(m_view->shownImage(), wanted(4));
    QVERIFY(!shows(wanted(4)));  // this thread has not made it
    QTRY_VERIFY_WITH_TIMEOUT(shows(wanted(4)), patience);
    for (const int gain : {16, 2, 64, 4}) {
      m_view->setGain(gain);
      QCOMPARE(m_view->shownImage(), wanted(gain));
    }
    QVERIFY(shows(wanted(4)));
    QTRY_VERIFY_WITH_TIMEOUT(shows(wanted(4)), patience);
    QTest::qWait(100);
    QVERIFY(shows(wanted(4)));  // none of the others comes later
    m_view->setImages(coordinates(200, 150, firstBlue), coordinates(200, 150, secondBlue));
    m_view->fit();
    QCOMPARE(at({201, 151}), QColor(0, 0, 4 * (secondBlue - firstBlue)));
  }

  /// The other is 40 bluer.
  void errorMapsAndTheirScale() {
    compare();
    m_view->setMode(ImageWidget::Mode::difference);
    m_view->setGain(2);
    const auto shows = [&](ErrorKind kind, const QColor& colour) {
      m_view->setErrorMap(kind, false);
      return at({201, 151}) == colour;
    };
    QVERIFY(shows(ErrorKind::absolute, QColor(0, 0, 80)));
    QVERIFY(shows(ErrorKind::signedError, QColor(128, 128, 168)));
    QVERIFY(shows(ErrorKind::squared, QColor(0, 0, 25)));
    QVERIFY(shows(ErrorKind::relative, QColor(0, 0, 255)));
    QVERIFY(shows(ErrorKind::luma, QColor(6, 6, 6)));
    look({201, 151});
    QVERIFY2(m_view->readOut().contains("luma error 2.888"), qPrintable(m_view->readOut()));
    lookAway();
    const auto [red, green, blue] = falseColour(std::round(255 * 2 * 40 / 3.0 / 255) / 255);
    m_view->setErrorMap(ErrorKind::absolute, true);
    QCOMPARE(at({201, 151}), QColor(red, green, blue));
    // The scale reaches from violet to yellow, at the right, and is no part of what is saved.
    const auto [topRed, topGreen, topBlue] = falseColour(1);
    const QImage image = grabbed();
    QVERIFY(count(image.copy(image.width() - 120, 0, 120, image.height()),
                  QColor(topRed, topGreen, topBlue), 12) > 0);
    QCOMPARE(count(m_view->shownImage(), QColor(topRed, topGreen, topBlue), 12), 0);
    m_view->setErrorMap(ErrorKind::absolute, false);
    QCOMPARE(at({201, 151}), QColor(0, 0, 80));
  }

  /// Left both pictures and the line, right the map of their error; zoomed and moved together.
  void wipeAndErrorAreBesideEachOther() {
    compare();
    m_view->setErrorMap(ErrorKind::absolute, false);
    m_view->setMode(ImageWidget::Mode::wipe);
    m_view->setWipe(0.25);
    const QImage wiped = m_view->shownImage();
    m_view->setMode(ImageWidget::Mode::difference);
    const QImage error = m_view->shownImage();
    m_view->setMode(ImageWidget::Mode::wipeAndError);
    m_view->setWipe(0.25);
    const QImage both = m_view->shownImage();
    const QSize size = m_view->image().size();
    QCOMPARE(both.size(), QSize(2 * size.width(), size.height()));
    QCOMPARE(both.copy(QRect({size.width(), 0}, size)), error);
    QCOMPARE(wiped.pixel(0, size.height() / 2), both.pixel(0, size.height() / 2));
    QCOMPARE(both.pixel(size.width() - 1, 20), m_view->otherImage().pixel(size.width() - 1, 20));
    // Both panes have the gain of the error, and the line is in the left one alone.
    m_view->setGain(2);
    QCOMPARE(m_view->gain(), 2.0);
    QCOMPARE(QColor(m_view->shownImage().pixel(size.width() + 5, 5)), QColor(0, 0, 80));
    const QPoint line(m_view->width() / 8, m_view->height() / 2);
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, line);
    QTest::mouseMove(m_view.get(), {m_view->width() / 4, m_view->height() / 2});
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {},
                        {m_view->width() / 4, m_view->height() / 2});
    QVERIFY2(std::abs(m_view->wipe() - 0.5) < 0.02, qPrintable(QString::number(m_view->wipe())));
  }

  void gainAndGammaChangeWhatIsShown() {
    key(Qt::Key_Up, Qt::ShiftModifier);
    QCOMPARE(at({201, 151}), QColor(200, 150, 2 * firstBlue));
    key(Qt::Key_Down, Qt::ShiftModifier);
    key(Qt::Key_Down, Qt::ShiftModifier);
    QCOMPARE(m_view->gain(), 0.5);
    QCOMPARE(at({201, 151}), QColor(50, 38, firstBlue / 2));
    key(Qt::Key_R);
    for (int k = 0; k < 5; ++k) key(Qt::Key_Up, Qt::ControlModifier);
    QCOMPARE(m_view->gamma(), 2.0);
    QCOMPARE(at({201, 151}).blue(), int(std::round(std::sqrt(255.0 * firstBlue))));
    look({201, 151});
    QVERIFY(m_view->readOut().contains("100 75 50"));  // code values stay what they are
    lookAway();
    // The error has a tone of its own.
    compare();
    m_view->setMode(ImageWidget::Mode::difference);
    QCOMPARE(m_view->gain(), 4.0);
    QCOMPARE(m_view->gamma(), 1.0);
    key(Qt::Key_R);
    m_view->setMode(ImageWidget::Mode::single);
    QCOMPARE(m_view->gamma(), 2.0);
    key(Qt::Key_R);
    QCOMPARE(at({201, 151}), QColor(100, 75, firstBlue));
  }

  void blinkingTakesTurns() {
    compare();
    m_view->setMode(ImageWidget::Mode::blink);
    QTRY_COMPARE_WITH_TIMEOUT(at({201, 151}).blue(), secondBlue, patience);
    QTRY_COMPARE_WITH_TIMEOUT(at({201, 151}).blue(), firstBlue, patience);
    key(Qt::Key_Space);
    const int now = at({201, 151}).blue();
    QTest::qWait(700);  // none takes a turn by itself now
    QCOMPARE(at({201, 151}).blue(), now);
    QCOMPARE(m_view->shownImage().pixelColor(0, 0).blue(), now);
    key(Qt::Key_Space);
    QCOMPARE(at({201, 151}).blue(), firstBlue + secondBlue - now);
  }

  void shiftAndADragMarkARectangle() {
    const QSignalSpy changed(m_view.get(), &ImageWidget::regionChanged);
    const QImage plain = grabbed();
    const auto mark = [&](const QPoint& from, const QPoint& to) {
      mouse(QEvent::MouseButtonPress, from, Qt::ShiftModifier);
      mouse(QEvent::MouseMove, to, Qt::ShiftModifier);
      mouse(QEvent::MouseButtonRelease, to, Qt::ShiftModifier);
      lookAway();
    };
    mark({41, 61}, {121, 81});
    QCOMPARE(m_view->region(), QRect(QPoint(20, 30), QPoint(60, 40)));
    QCOMPARE(changed.back()[0].toRect(), m_view->region());
    QVERIFY(m_view->viewport().fits);
    QVERIFY(grabbed() != plain);
    mark({121, 81}, {41, 61});  // whichever way it is drawn
    QCOMPARE(m_view->region(), QRect(QPoint(20, 30), QPoint(60, 40)));
    mark({301, 201}, {600, 500});  // beyond the image
    QCOMPARE(m_view->region(), QRect(QPoint(150, 100), QPoint(199, 149)));
    mark({11, 11}, {11, 11});
    QVERIFY(m_view->region().isNull());
    mark({41, 61}, {121, 81});
    key(Qt::Key_Delete);
    QVERIFY(m_view->region().isNull());
    QCOMPARE(grabbed(), plain);
    // Side by side in the second picture.
    compare();
    mark({241, 101}, {281, 141});
    const QRect inSecond = m_view->region();
    mark({40, 101}, {80, 141});
    QCOMPARE(m_view->region(), inSecond);
  }

  void markedPixelsHaveAFrame() {
    const QImage plain = grabbed();
    m_view->markPixels(QRect(50, 25, 1, 1));
    const QImage marked = grabbed();
    QVERIFY(marked.copy(QRect(QPoint(80, 30) * ratio(), QSize(42, 42) * ratio())) !=
            plain.copy(QRect(QPoint(80, 30) * ratio(), QSize(42, 42) * ratio())));
    QCOMPARE(at({101, 51}), QColor(50, 25, firstBlue));  // the pixel itself is seen
    QCOMPARE(marked.pixel(300, 200), plain.pixel(300, 200));
    m_view->markPixels({});
    QCOMPARE(grabbed(), plain);
  }

  void readsOutPixels() {
    look({101, 51});
    QCOMPARE(m_view->readOut(), QString("x 50, y 25: 50 25 50 (%1 %)").arg(200 * ratio()));
    compare();
    m_view->setMode(ImageWidget::Mode::wipe);
    look({103, 51});
    QVERIFY2(m_view->readOut().startsWith("x 51, y 25: 51 25 50 | 51 25 90, difference 0 0 40"),
             qPrintable(m_view->readOut()));
    QImage seen(200, 150, QImage::Format_Grayscale8);
    seen.fill(255);
    seen.setPixel(51, 25, 0);
    m_view->setMask(QImage(), seen);
    QVERIFY(m_view->readOut().startsWith("x 51, y 25: 51 25 50 | not seen"));
    lookAway();
    QCOMPARE(m_view->readOut(), QString());
    m_view->resize(500, 300);
    QTRY_COMPARE_WITH_TIMEOUT(m_view->width(), 500, patience);
    look({20, 51});
    QCOMPARE(m_view->readOut(), QString());  // beside the image
  }

  /// The lines of text are counted in the middle of a pixel: rows with ink, in groups.
  void codeValuesStandInLargePixels() {
    const auto linesIn = [this](int shownZoom) {
      const QImage image = grabbed();
      const QPoint middle(image.width() / 2, image.height() / 2);
      const QRect inside(middle - QPoint(shownZoom / 3, shownZoom / 2 - 3),
                         QSize(2 * shownZoom / 3, shownZoom - 6));
      int lines = 0;
      bool wasInk = false;
      for (int y = inside.top(); y <= inside.bottom(); ++y) {
        bool isInk = false;
        for (int x = inside.left(); x <= inside.right(); ++x)
          isInk = isInk || qGray(image.pixel(x, y)) > 150;
        lines += isInk && !wasInk ? 1 : 0;
        wasInk = isInk;
      }
      return lines;
    };
    const QPointF centre(50.5, 60.5);  // a dark pixel: 50 60 50
    m_view->setViewport({false, 16, centre});
    QCOMPARE(linesIn(16), 0);
    m_view->setViewport({false, 64, centre});
    QCOMPARE(linesIn(64), 3);
    compare();
    m_view->setMode(ImageWidget::Mode::difference);
    m_view->setGain(1);
    QCOMPARE(linesIn(64), 3);
    m_view->setErrorMap(ErrorKind::luma, false);
    m_view->setGain(1);
    QCOMPARE(linesIn(64), 1);
  }

  void theMaskMarksWhatIsNotSeen() {
    QImage seen(200, 150, QImage::Format_Grayscale8);
    seen.fill(255);
    for (int y = 0; y < 150; ++y) std::fill_n(seen.scanLine(y), 100, uchar(0));
    m_view->setMask(seen);
    const QImage plain = grabbed();
    m_view->showMask(true);
    const QImage marked = grabbed();
    int changedLeft = 0;
    int changedRight = 0;
    for (int y = 0; y < plain.height(); ++y)
      for (int x = 0; x < plain.width(); ++x)
        if (plain.pixel(x, y) != marked.pixel(x, y))
          ++(x < plain.width() / 2 ? changedLeft : changedRight);
    QCOMPARE(changedLeft, plain.width() / 2 * plain.height());
    QVERIFY(changedRight < plain.width() / 2 * plain.height() / 4);  // the legend
    m_view->showMask(false);
    QCOMPARE(grabbed(), plain);
  }

  /// Each reason has a pattern of its own, and a line of the legend.
  void theMaskHasAPatternForEachReason() {
    QImage seen(200, 150, QImage::Format_Indexed8);
    seen.setColorTable({qRgb(0, 0, 0), qRgb(0, 0, 0), qRgb(0, 0, 0), qRgb(255, 255, 255)});
    std::vector<QImage> patterns;
    for (const RayEnd end : {RayEnd::noRay, RayEnd::misses, RayEnd::outsideField}) {
      seen.fill(uint(end));
      const QImage pattern = hatched(seen, hatchColours());
      for (const QImage& other : patterns) QVERIFY(pattern != other);
      patterns.push_back(pattern);
      std::array<bool, 3> only{};
      only[std::size_t(end)] = true;
      QVERIFY(reasonsIn(seen) == only);
    }
    seen.fill(uint(RayEnd::seen));
    for (int y = 0; y < 150; ++y) std::fill_n(seen.scanLine(y), 100, uchar(RayEnd::noRay));
    m_view->setMask(seen);
    const QImage plain = grabbed();
    m_view->showMask(true);
    const QImage marked = grabbed();
    const QRect right(plain.width() / 2, 0, plain.width() / 2, plain.height());
    QVERIFY(marked.copy(right) != plain.copy(right));  // the legend
    m_view->showMask(false);
    QCOMPARE(grabbed(), plain);
  }

  void aTagStandsInTheCorner() {
    const QImage plain = grabbed();
    m_view->setTag("Coarse");
    const QRect corner(plain.width() / 2, 0, plain.width() / 2, plain.height() / 2);
    QVERIFY(grabbed().copy(corner) != plain.copy(corner));
    m_view->setTag({});
    QCOMPARE(grabbed(), plain);
  }

  void nothingToShowIsSaid() {
    const QImage image = grabbed();
    m_view->setNotice("Nothing here");
    m_view->setImages({});
    const QImage empty = grabbed();
    const QColor ground = empty.pixelColor(2, 2);
    bool hasText = false;
    for (int x = 0; x < empty.width(); ++x)
      for (int y = empty.height() / 2 - 10; y < empty.height() / 2 + 10; ++y)
        hasText = hasText || empty.pixelColor(x, y) != ground;
    QVERIFY(hasText);
    for (const Qt::Key which : {Qt::Key_Plus, Qt::Key_Minus, Qt::Key_1, Qt::Key_0, Qt::Key_Left})
      key(which);
    wheel({10, 10}, 120);
    QVERIFY(m_view->shownImage().isNull());
    m_view->setImages(coordinates(200, 150, firstBlue), coordinates(100, 75, secondBlue));
    QVERIFY(m_view->otherImage().isNull());  // another size
    QVERIFY(grabbed() != image);
    m_view->setNotice({});
    QCOMPARE(grabbed(), image);
  }

  void thePaceGoesByWhatImagesTook() {
    ViewPace pace;
    QCOMPARE(pace.firstScale(), 1);
    pace.rendered(1, 100);
    QCOMPARE(pace.firstScale(), 2);
    pace.rendered(2, 20);
    QCOMPARE(pace.firstScale(), 2);
    pace.rendered(2, 40);  // so a full one takes 160
    QCOMPARE(pace.firstScale(), 4);
    pace.rendered(1, 25);
    QCOMPARE(pace.firstScale(), 1);
    pace.stopped(31);
    QCOMPARE(pace.firstScale(), 2);
  }
};

QTEST_MAIN(TestImageWidget)
#include "test_image_widget.moc"
