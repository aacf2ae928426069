// SPDX-License-Identifier: BSD-3-Clause
// Tests the order that a test's views have by the reference's: found where it differs, through what
// a codec loses, and never invented for views that stand right or that do not tell.
#include "io/opening/matched_order.h"

#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

constexpr int width =
    64;  // OpenImageIO 2.4 writes beyond a video's frame of other widths than n·32
constexpr int height = 48;

/// Smooth noise that is not alike at two places.
double texture(double x, double y, double seed) {
  return std::sin(0.31 * x + seed) * std::cos(0.23 * y - 2 * seed) +
         0.6 * std::sin(0.83 * x - 0.57 * y + 3 * seed) +
         0.4 * std::cos(0.19 * x * std::sin(0.05 * y + seed));
}

/// A view of a wall with a ball before it, which shift by `parallax` and −2 `parallax` px.
QImage viewOf(int u, int v, double parallax = 1, double seed = 1) {
  QImage view(width, height, QImage::Format_RGB888);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double bx = x + 2 * parallax * u - 40;
      const double by = y + 2 * parallax * v - 30;
      const bool isBall = bx * bx + by * by < 150;
      const double value =
          isBall ? texture(bx, by, seed + 5) : texture(x - parallax * u, y - parallax * v, seed);
      const int grey = std::clamp(int(128 + 50 * value), 0, 255);
      view.setPixel(x, y, qRgb(grey, std::min(grey + 20, 255), 200 - grey / 2));
    }
  return view;
}

struct Grid {
  int columns;
  int rows;
};

/// The order in which pictures are numbered or named: that of the parameters with these words.
struct Numbering {
  bool isSerpentine = false;
  bool isUpwards = false;
  bool isLeftwards = false;

  /// Returns (u, v) of the picture that is numbered for a row and column.
  [[nodiscard]] std::pair<int, int> of(int row, int column, const Grid& grid) const {
    if (isSerpentine && row % 2 == 1) column = grid.columns - 1 - column;
    return {isLeftwards ? grid.columns - 1 - column : column,
            isUpwards ? grid.rows - 1 - row : row};
  }
  [[nodiscard]] QString text() const {
    QStringList words;
    if (isSerpentine) words << "lightField.scan=serpentine";
    if (isUpwards) words << "lightField.rows=bottom-up";
    if (isLeftwards) words << "lightField.columns=right-left";
    return words.join(" ");
  }
};

using View = std::function<QImage(int u, int v)>;

/// Writes views by running numbers, or by row and column; a quality of 0 is lossless.
void writeViews(const QString& folder, const Grid& grid, const Numbering& order, int quality,
                bool isNumbered, const View& view) {
  QDir().mkpath(folder);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const auto [u, v] = order.of(row, column, grid);
      const QString name =
          isNumbered ? QString("%1").arg(row * grid.columns + column, 4, 10, QChar('0'))
                     : QString("%1_%2").arg(row, 3, 10, QChar('0')).arg(column, 3, 10, QChar('0'));
      const QString file = folder + "/" + name + (quality > 0 ? ".jpg" : ".png");
      if (!view(u, v).save(file, nullptr, quality > 0 ? quality : 90)) qFatal("cannot write");
    }
}

LightFieldParams viewsIn(const std::string& file) {
  LightFieldParams params;
  params.file = file;
  params.layout = Layout::views;
  return params;
}

QString matchOf(const LightFieldParams& reference, const LightFieldParams& test, const Grid& grid) {
  DisplayParams display;
  display.directions = {grid.columns, grid.rows};
  OrderMatcher matcher(reference, display);
  const auto found = matcher.match(test, display, {});
  return found ? QString::fromStdString(orderText(test, *found)) : QString();
}

}  // namespace

class TestMatchedOrder : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void isFound_data();
  void isFound();
  void ofAVideo();
  void fromAnotherOrder();
  void isNotInvented();
  void ofOtherGrids();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestMatchedOrder::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestMatchedOrder::isFound_data() {
  QTest::addColumn<int>("columns");
  QTest::addColumn<int>("rows");
  QTest::addColumn<int>("quality");
  QTest::addColumn<double>("parallax");
  for (const auto& [columns, rows] :
       {std::pair{5, 5}, {4, 3}, {3, 6}, {3, 3}, {2, 2}, {7, 1}, {1, 4}})
    for (const int quality : {0, 50, 15})
      QTest::addRow("%dx%d, quality %d", columns, rows, quality)
          << columns << rows << quality << 1.0;
  QTest::newRow("small parallax") << 5 << 4 << 0 << 0.15;
  QTest::newRow("small parallax, JPEG") << 5 << 4 << 60 << 0.15;
}

/// All orders, of which one stands right.
void TestMatchedOrder::isFound() {
  QFETCH(int, columns);
  QFETCH(int, rows);
  QFETCH(int, quality);
  QFETCH(double, parallax);
  const Grid grid{columns, rows};
  const View view = [=](int u, int v) { return viewOf(u, v, parallax); };
  writeViews("reference", grid, {}, 0, false, view);
  for (const bool isSerpentine : {false, true})
    for (const bool isUpwards : {false, true})
      for (const bool isLeftwards : {false, true}) {
        // Where there is one row or column, fewer orders differ.
        if ((rows == 1 && (isSerpentine || isUpwards)) ||
            (columns == 1 && (isSerpentine || isLeftwards)))
          continue;
        // Of an even number of rows, to and fro from the bottom is the same from the other side.
        const Numbering order{isSerpentine, isUpwards, isLeftwards};
        const QString folder = "test" + order.text();
        writeViews(folder, grid, order, quality, true, view);
        const LightFieldParams test = viewsIn(folder.toStdString());
        QCOMPARE(matchOf(viewsIn("reference"), test, grid), order.text());
      }
}

void TestMatchedOrder::ofAVideo() {
  const Grid grid{5, 4};
  writeViews("reference", grid, {}, 0, false, [](int u, int v) { return viewOf(u, v); });
  for (const Numbering order : {Numbering{}, Numbering{true}, Numbering{true, true}}) {
    {
      cv::VideoWriter video("test.avi", cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                            25, {width, height});
      for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
          const auto [u, v] = order.of(row, column, grid);
          const QImage view = viewOf(u, v).convertToFormat(QImage::Format_BGR888);
          video.write(cv::Mat(height, width, CV_8UC3, const_cast<uchar*>(view.constBits()),
                              std::size_t(view.bytesPerLine())));
        }
    }
    QCOMPARE(matchOf(viewsIn("reference"), viewsIn("test.avi"), grid), order.text());
  }
}

/// The reference's own order is taken by a test that nothing else is known of.
void TestMatchedOrder::fromAnotherOrder() {
  const Grid grid{4, 3};
  const View view = [](int u, int v) { return viewOf(u, v); };
  writeViews("reference", grid, {false, true, false}, 0, false, view);
  writeViews("same", grid, {false, true, false}, 40, true, view);
  writeViews("straight", grid, {}, 40, true, view);
  LightFieldParams reference = viewsIn("reference");
  reference.rows = RowOrder::bottomUp;
  LightFieldParams test = reference;
  test.file = "same";
  QCOMPARE(matchOf(reference, test, grid), QString());
  test.file = "straight";
  QCOMPARE(matchOf(reference, test, grid), QString("lightField.rows=top-down"));
}

/// Views that are equal, differ in noise alone, are of another scene, or in an order that no
/// parameter has, are left as they stand; those that are counted by columns are not.
void TestMatchedOrder::isNotInvented() {
  const Grid grid{5, 5};
  const View view = [](int u, int v) { return viewOf(u, v); };
  writeViews("reference", grid, {}, 0, false, view);
  writeViews("other", grid, {}, 0, true, [](int u, int v) { return viewOf(u, v, 1, 2.2); });
  writeViews("named", grid, {true}, 0, false, view);
  writeViews("down", grid, {}, 50, true, [&](int u, int v) { return viewOf(v, u); });
  for (const char* const name : {"other", "named"})
    QCOMPARE(matchOf(viewsIn("reference"), viewsIn(name), grid), QString());
  QCOMPARE(matchOf(viewsIn("reference"), viewsIn("down"), grid),
           QString("lightField.scan=columns"));
  const auto noisy = [](int seed) {
    return [seed](int u, int v) {
      QImage image = viewOf(0, 0);
      unsigned state = unsigned(1 + seed + 17 * u + 311 * v);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < 3 * width; ++x) {
          state = 1664525 * state + 1013904223;
          uchar& value = image.scanLine(y)[x];
          value = uchar(std::clamp(int(value) + int(state >> 29) - 4, 0, 255));
        }
      return image;
    };
  };
  writeViews("flat", grid, {}, 0, false, [](int, int) { return viewOf(0, 0); });
  writeViews("flat test", grid, {}, 10, true, [](int, int) { return viewOf(0, 0); });
  writeViews("noise", grid, {}, 0, false, noisy(0));
  writeViews("noise test", grid, {}, 0, true, noisy(1000000));
  writeViews("noise copy", grid, {}, 30, true, noisy(0));
  QCOMPARE(matchOf(viewsIn("flat"), viewsIn("flat test"), grid), QString());
  QCOMPARE(matchOf(viewsIn("noise"), viewsIn("noise test"), grid), QString());
  QCOMPARE(matchOf(viewsIn("noise"), viewsIn("noise copy"), grid), QString());
}

void TestMatchedOrder::ofOtherGrids() {
  const View view = [](int u, int v) { return viewOf(u, v); };
  writeViews("reference", {4, 3}, {}, 0, false, view);
  writeViews("larger", {4, 4}, {true}, 0, true, view);
  writeViews("half", {4, 3}, {true}, 0, true,
             [&](int u, int v) { return view(u, v).scaled(width / 2, height / 2); });
  QCOMPARE(matchOf(viewsIn("reference"), viewsIn("larger"), {0, 0}), QString());
  QCOMPARE(matchOf(viewsIn("reference"), viewsIn("half"), {4, 3}), QString());
  LightFieldParams picture;
  picture.file = "reference/000_000.png";
  QCOMPARE(matchOf(viewsIn("reference"), picture, {4, 3}), QString());
  QCOMPARE(matchOf(picture, viewsIn("half"), {4, 3}), QString());
}

QTEST_GUILESS_MAIN(TestMatchedOrder)
#include "test_matched_order.moc"
