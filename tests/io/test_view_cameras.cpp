// SPDX-License-Identifier: BSD-3-Clause
// Tests cameras in files beside views: views are traced for cameras in a world that is turned at
// random, whose poses are written as nerfstudio and COLMAP write them; the folder must then be read
// as the cameras stood, with the panel where most of the scene is.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <cstring>
#include <numbers>

#include "capture/order/camera_grid.h"
#include "core/light_field/light_field.h"
#include "io/json/json_parameters.h"
#include "io/opening/opening.h"
#include "io/opening/session_around.h"
#include "io/scene/view_source.h"
#include "tests/core/random.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"
#include "tests/io/layered_views.h"

using namespace hogelscope;

namespace {

constexpr int width = 200;
constexpr int height = 150;
constexpr double focal = 220;  // px
constexpr double wall = 3;     // m
constexpr double spacing = 0.04;
/// What OpenCV's dense flow may be wrong by, in px; its versions differ.
constexpr double flowError = 0.07;

/// A camera in the rig: its place is right, down and forward of the middle one, in metres.
struct Eye {
  Vec3 place;
  double yaw = 0;  ///< to the right, radians
  double cx = (width - 1) / 2.0;
  std::string picture{};
};

/// Eyes in rows and columns, row by row from the top left one.
std::vector<Eye> gridOfEyes(int columns, int rows) {
  std::vector<Eye> eyes;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      eyes.push_back(
          {{spacing * (column - (columns - 1) / 2.0), spacing * (row - (rows - 1) / 2.0), 0}});
  return eyes;
}

/// Grey of the scene that a ray from the rig's point sees: cards at 2 m before a wall at 3 m.
double seen(const Vec3& from, const Vec3& along) {
  const auto at = [&](double depth) {
    const double t = (depth - from.z) / along.z;
    return Vec2{from.x + t * along.x, from.y + t * along.y};
  };
  const auto texture = [](const Vec2& p, int number) {
    return textureAt(80 * p.x + 1000, 80 * p.y + 1000, {.texture = number});
  };
  const Vec2 near = at(2);
  int card = 0;
  for (const Vec2& middle : {Vec2{-0.5, -0.35}, {0.45, -0.3}, {-0.1, 0.1}, {-0.6, 0.4}, {0.6, 0.4}})
    if (++card; std::hypot(near.x - middle.x, near.y - middle.y) < 0.14)
      return texture(near, card + 1);
  return texture(at(wall), 1);
}

void writeView(const std::string& file, const Eye& eye) {
  writeImageFile(QString::fromStdString(file), width, height, [&](int x, int y, int) {
    const double right = (x - eye.cx) / focal, down = (y - (height - 1) / 2.0) / focal;
    const double c = std::cos(eye.yaw), s = std::sin(eye.yaw);
    return float(seen(eye.place, {c * right + s, down, c - s * right}));
  });
}

/// Turns the rig into a world, by 0.7 about (1, 2, -1) and then some.
Vec3 worldOf(const Vec3& p) {
  const Vec3 k = normalise({1, 2, -1});
  const double c = std::cos(0.7), s = std::sin(0.7);
  return c * p + s * cross(k, p) + ((1 - c) * dot(k, p)) * k;
}

const Vec3 origin{3, -1, 20};

struct WorldPose {
  Vec3 right, down, forward, place;
};

WorldPose worldPose(const Eye& eye) {
  const double c = std::cos(eye.yaw), s = std::sin(eye.yaw);
  return {worldOf({c, 0, -s}), worldOf({0, 1, 0}), worldOf({s, 0, c}), worldOf(eye.place) + origin};
}

QByteArray text(double value) {
  return QByteArray::number(value, 'g', 12);
}

/// nerfstudio: worldFromCamera with OpenGL's axes, right, up and backward; pixels from the corner.
QByteArray transformsOf(const std::vector<Eye>& eyes, double scale = 1) {
  QByteArray file = R"({"camera_model": "PINHOLE", "w": )" + text(scale * width) + R"(, "h": )" +
                    text(scale * height) + R"(, "frames": [)";
  for (const Eye& eye : eyes) {
    const WorldPose pose = worldPose(eye);
    const Vec3 up = -1.0 * pose.down, backward = -1.0 * pose.forward;
    QByteArray matrix;
    for (const auto part : {&Vec3::x, &Vec3::y, &Vec3::z})
      matrix += "[" + text(pose.right.*part) + ", " + text(up.*part) + ", " + text(backward.*part) +
                ", " + text(pose.place.*part) + "], ";
    file += (&eye == &eyes.front() ? "" : ", ") + QByteArray(R"({"file_path": ")") +
            QByteArray::fromStdString(eye.picture) + R"(", "fl_x": )" + text(scale * focal) +
            R"(, "fl_y": )" + text(scale * focal) + R"(, "cx": )" + text(scale * (eye.cx + 0.5)) +
            R"(, "cy": )" + text(scale * height / 2.0) + R"(, "transform_matrix": [)" + matrix +
            "[0, 0, 0, 1]]}";
  }
  return file + "]}";
}

/// Returns w, x, y, z of the rotation whose rows are right, down, forward.
std::array<double, 4> quaternionOf(const WorldPose& pose) {
  const auto& [a, b, c, place] = pose;
  const double w = std::sqrt(std::max(0.0, 1 + a.x + b.y + c.z)) / 2;
  return {w, (c.y - b.z) / (4 * w), (a.z - c.x) / (4 * w), (b.x - a.y) / (4 * w)};
}

/// COLMAP: cameraFromWorld with the axes right, down and forward; pixels from the corner.
void writeColmap(const QString& folder, const std::vector<Eye>& eyes, bool isBinary) {
  QDir().mkpath(folder);
  QByteArray cameras, images;
  const auto append = [](QByteArray& bytes, auto value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  const std::array parameters{focal, focal, width / 2.0, height / 2.0};
  if (isBinary) {
    append(cameras, std::uint64_t(1)), append(cameras, std::uint32_t(1));
    append(cameras, std::int32_t(1));
    append(cameras, std::uint64_t(width)), append(cameras, std::uint64_t(height));
    for (const double value : parameters) append(cameras, value);
    append(images, std::uint64_t(eyes.size()));
  } else {
    cameras = "# Camera list\n1 PINHOLE 200 150";
    for (const double value : parameters) cameras += " " + text(value);
    cameras += "\n";
  }
  std::uint32_t number = 0;
  for (const Eye& eye : eyes) {
    const WorldPose pose = worldPose(eye);
    const std::array t{-dot(pose.right, pose.place), -dot(pose.down, pose.place),
                       -dot(pose.forward, pose.place)};
    if (isBinary) {
      append(images, ++number);
      for (const double part : quaternionOf(pose)) append(images, part);
      for (const double part : t) append(images, part);
      append(images, std::uint32_t(1));
      images += QByteArray::fromStdString(eye.picture) + '\0';
      append(images, std::uint64_t(0));
    } else {
      images += QByteArray::number(++number);
      for (const double part : quaternionOf(pose)) images += " " + text(part);
      for (const double part : t) images += " " + text(part);
      images += " 1 " + QByteArray::fromStdString(eye.picture) + "\n\n";
    }
  }
  const QString ending = isBinary ? ".bin" : ".txt";
  writeFile(folder + "/cameras" + ending, cameras);
  writeFile(folder + "/images" + ending, images);
}

/// Writes views whose names count rows and columns, from below or from the right where it is said.
std::vector<Eye> writeNamed(const std::string& folder, int columns, int rows,
                            const GridSymmetry& as, const char* pattern = "%02d_%02d.png") {
  std::vector<Eye> eyes = gridOfEyes(columns, rows);
  for (int k = 0; k < columns * rows; ++k) {
    const int row = as.isUp ? rows - 1 - k / columns : k / columns;
    const int column = as.isLeft ? columns - 1 - k % columns : k % columns;
    Eye& eye = eyes[std::size_t(k)];
    eye.picture =
        QString::asprintf(pattern, as.isTransposed ? column : row, as.isTransposed ? row : column)
            .toStdString();
    writeView(folder + "/" + eye.picture, eye);
  }
  return eyes;
}

/// Writes views of one grey each, 10 (k + 1) for the eye k.
void writeFlat(const std::string& folder, const std::vector<Eye>& eyes) {
  for (std::size_t k = 0; k < eyes.size(); ++k)
    writeImageFile(QString::fromStdString(folder + "/" + eyes[k].picture), 12, 8,
                   [&](int, int, int) { return float(10 * (k + 1)) / 255; });
}

/// Whether the direction (u, v) is the view of the eye in column u and row v, counted from 0.
bool areInOrder(const Session& session, int columns, int rows) {
  const auto file = openLightField(session.lightField, session.display);
  if (!(file->size() == LightFieldSize{12, 8, columns, rows})) return false;
  const LightField lightField = file->read({});
  for (int v = 0; v < rows; ++v)
    for (int u = 0; u < columns; ++u)
      if (std::lround(lightField.texel({5, 4, u, v}).r) != 10 * (v * columns + u + 1)) return false;
  return true;
}

QString linesOf(const OrderedSession& around) {
  QString lines;
  for (const std::string& line : around.order.warnings)
    lines += QString::fromStdString(line) + "\n";
  return lines;
}

bool isNear(double value, double expected, double tolerance) {
  return std::abs(value - expected) <= tolerance * std::abs(expected);
}

/// Whether the panel is on the wall, and as large as a view sees of it.
bool isOnWall(const Session& session, int columns, int rows) {
  const auto fovOf = [](int count) {
    return 360 / std::numbers::pi * std::atan(count * spacing / (2 * wall));
  };
  constexpr double tolerance = flowError * wall / (focal * spacing);
  return isNear(session.lightField.viewingDistance, wall, tolerance) &&
         isNear(session.display.size[0], wall * width / focal, tolerance) &&
         isNear(session.display.size[1], wall * height / focal, tolerance) &&
         isNear(session.display.fov[0], fovOf(columns), tolerance) &&
         isNear(session.display.fov[1], fovOf(rows), tolerance);
}

}  // namespace

class TestViewCameras : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir::setCurrent(m_folder->path()));
  }

  void orderAndGeometry_data();
  void orderAndGeometry();
  void countedViews_data();
  void countedViews();
  void exchangedNames();
  void namesInNoOrder();
  void positionsInNames();
  void withoutStructure();
  void shiftedAndTurned_data();
  void shiftedAndTurned();
  void picturesOfAnotherSize();
  void noGrid_data();
  void noGrid();
  void roughGrid();
  void wrongConvention();
  void wrongPlaces();
  void brokenFile();
  void usersWords();
  void inASession();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestViewCameras::orderAndGeometry_data() {
  QTest::addColumn<QString>("format");
  QTest::addColumn<bool>("isUp");
  QTest::addColumn<bool>("isLeft");
  for (const char* format : {"json", "txt", "bin", "above"})
    for (const bool isUp : {false, true})
      for (const bool isLeft : {false, true})
        if (QString(format) == "json" || (isUp != isLeft) != (QString(format) == "txt"))
          QTest::addRow("%s%s%s", format, isUp ? " up" : "", isLeft ? " left" : "")
              << QString(format) << isUp << isLeft;
}

/// nerfstudio beside the views, COLMAP beside them and in sparse/0, both above a folder "images".
void TestViewCameras::orderAndGeometry() {
  QFETCH(QString, format);
  QFETCH(bool, isUp);
  QFETCH(bool, isLeft);
  const bool isAbove = format == "above";
  const std::string folder = isAbove ? "images" : "v";
  std::vector<Eye> eyes = writeNamed(folder, 5, 3, {isUp, isLeft, false});
  QString file = "v/transforms.json";
  if (format == "json") {
    for (Eye& eye : eyes) eye.picture = "./images_2/" + eye.picture.substr(0, 5);  // no ending
    writeFile(file, transformsOf(eyes));
  } else if (isAbove && isUp) {
    for (Eye& eye : eyes) eye.picture = "images/" + eye.picture;
    writeFile(file = "transforms.json", transformsOf(eyes));
  } else {
    file = isAbove ? "sparse/0" : format == "txt" ? "v" : "v/sparse/0";
    writeColmap(file, eyes, format != "txt");
  }
  const OrderedSession around = orderedSessionAround(folder);
  const LightFieldParams& used = around.session.lightField;
  QCOMPARE(linesOf(around), QString());
  QCOMPARE(around.order.sureness, Sureness::sure);
  QCOMPARE(QString::fromStdString(around.order.reason), "the cameras' places in " + file);
  QCOMPARE(QString::fromStdString(around.assumed),
           "5×3 views by their cameras' places in " + file + ", whose unit is taken for the metre");
  QCOMPARE(used.rows == RowOrder::bottomUp, isUp);
  QCOMPARE(used.columns == ColumnOrder::rightLeft, isLeft);
  QVERIFY2(isOnWall(around.session, 5, 3), qPrintable(QString::number(used.viewingDistance)));
  for (const double shear : used.shear)
    QVERIFY2(isNear(shear, focal * spacing / used.viewingDistance, 1e-5),
             qPrintable(QString::number(shear)));
  QCOMPARE(around.session.display.directions, (std::array{0, 0}));  // the names say it
}

void TestViewCameras::countedViews_data() {
  QTest::addColumn<int>("columns");
  QTest::addColumn<int>("rows");
  QTest::addColumn<ViewScan>("scan");
  QTest::addColumn<int>("from");  // the corner: 1 right, 2 below
  QTest::newRow("raster") << 6 << 3 << ViewScan::raster << 0;
  QTest::newRow("raster of a square number") << 8 << 2 << ViewScan::raster << 1;
  QTest::newRow("to and fro from below") << 4 << 5 << ViewScan::serpentine << 2;
  QTest::newRow("columns") << 3 << 5 << ViewScan::columns << 3;
  QTest::newRow("columns to and fro") << 3 << 3 << ViewScan::columnsSerpentine << 1;
  QTest::newRow("one row from the right") << 7 << 1 << ViewScan::raster << 1;
  QTest::newRow("one column from below") << 1 << 4 << ViewScan::raster << 2;
}

/// Pictures without any structure, by one running number.
void TestViewCameras::countedViews() {
  QFETCH(int, columns);
  QFETCH(int, rows);
  QFETCH(ViewScan, scan);
  QFETCH(int, from);
  std::vector<Eye> eyes = gridOfEyes(columns, rows);
  int number = 0;
  const bool isByColumns = scan == ViewScan::columns || scan == ViewScan::columnsSerpentine;
  const bool isToAndFro = scan == ViewScan::serpentine || scan == ViewScan::columnsSerpentine;
  const int lines = isByColumns ? columns : rows, count = isByColumns ? rows : columns;
  for (int line = 0; line < lines; ++line)
    for (int k = 0; k < count; ++k) {
      const int at = isToAndFro && line % 2 == 1 ? count - 1 - k : k;
      int row = isByColumns ? at : line, column = isByColumns ? line : at;
      if ((from & 2) != 0) row = rows - 1 - row;
      if ((from & 1) != 0) column = columns - 1 - column;
      eyes[std::size_t(row * columns + column)].picture =
          QString::asprintf("frame_%05d.png", ++number).toStdString();
    }
  writeFlat("v", eyes);
  std::ranges::sort(eyes, {}, &Eye::picture);
  writeFile("v/transforms.json", transformsOf(eyes));
  const OrderedSession around = orderedSessionAround("v");
  QCOMPARE(around.order.sureness, Sureness::sure);
  QVERIFY2(areInOrder(around.session, columns, rows), qPrintable(linesOf(around)));
}

/// Names that begin with the column.
void TestViewCameras::exchangedNames() {
  const auto eyes = writeNamed("v", 5, 3, {true, false, true});
  writeFile("v/transforms.json", transformsOf(eyes));
  const OrderedSession around = orderedSessionAround("v");
  QCOMPARE(QString::fromStdString(around.session.lightField.pattern), QString("CCC_RRR"));
  QCOMPARE(around.session.lightField.rows, RowOrder::bottomUp);
  QCOMPARE(around.order.sureness, Sureness::sure);
  QVERIFY(isOnWall(around.session, 5, 3));
  QCOMPARE(linesOf(around),
           QString("v/transforms.json: by its cameras, which are used, the numbers "
                   "of rows in the views' names are those of columns\n"));
}

void TestViewCameras::namesInNoOrder() {
  std::vector<Eye> eyes = gridOfEyes(3, 2);
  for (std::size_t k = 0; k < eyes.size(); ++k)
    eyes[k].picture = "IMG_" + std::to_string(std::array{4, 1, 6, 2, 3, 5}[k]) + ".png";
  writeFlat("v", eyes);
  writeFile("v/transforms.json", transformsOf(eyes));
  const OrderedSession around = orderedSessionAround("v");
  QCOMPARE(around.order.sureness, Sureness::unknown);
  QCOMPARE(linesOf(around),
           QString("v/transforms.json: its cameras stand in a grid of 3×2, along which the views' "
                   "names do not run; name the views by row and column from the top left one on: "
                   "IMG_4.png is 000_000, IMG_1.png is 000_001, IMG_6.png is 000_002, …\n"));
}

/// Coordinates in names, whose y runs upwards.
void TestViewCameras::positionsInNames() {
  std::vector<Eye> eyes = gridOfEyes(3, 3);
  for (int k = 0; k < 9; ++k)
    eyes[std::size_t(k)].picture = QString::asprintf("out_%02d_%02d_%d_%d_.png", k / 3, k % 3,
                                                     900 - 40 * (k / 3), 100 + 40 * (k % 3))
                                       .toStdString();
  writeFlat("v", eyes);
  writeFile("v/transforms.json", transformsOf(eyes));
  const OrderedSession around = orderedSessionAround("v");
  QVERIFY(areInOrder(around.session, 3, 3));
  QVERIFY2(linesOf(around).startsWith("v/transforms.json: its cameras' places are used, but the "
                                      "positions in the file names say the opposite\n"),
           qPrintable(linesOf(around)));
}

/// Views in which nothing moves: the panel's distance is the user's to give.
void TestViewCameras::withoutStructure() {
  std::vector<Eye> eyes = gridOfEyes(3, 3);
  for (int k = 0; k < 9; ++k) eyes[std::size_t(k)].picture = std::to_string(k) + ".png";
  writeFlat("v", eyes);
  writeFile("v/transforms.json", transformsOf(eyes, 12.0 / width));
  OrderedSession around = orderedSessionAround("v");
  QVERIFY(areInOrder(around.session, 3, 3));
  QCOMPARE(around.session.lightField.viewingDistance, notGiven);
  QCOMPARE(around.session.display.size[0], 0.5);
  QCOMPARE(linesOf(around), QString("v/transforms.json: its cameras do not say the distance of the "
                                    "panel, and no shear was found in the views; give "
                                    "lightField.viewingDistance\n"));
  around = orderedSessionAround("v", {"lightField.viewingDistance=3"});
  QCOMPARE(linesOf(around), QString());
  QVERIFY(isNear(around.session.display.size[0], wall * width / focal, 1e-5));
  QVERIFY(isNear(around.session.lightField.shear[0], focal * spacing / wall * 12 / width, 1e-4));
}

void TestViewCameras::shiftedAndTurned_data() {
  QTest::addColumn<double>("shift");  // px, of the sensor, for each view
  QTest::addColumn<double>("turn");   // radians to the left, for each view to the right
  QTest::newRow("sensors that converge at 4 m") << focal * spacing / 4 << 0.0;
  QTest::newRow("cameras that turn to 5 m") << 0.0 << spacing / 5;
  QTest::newRow("cameras that turn away") << 0.0 << -0.005;
}

/// The wall is where it is, whatever the cameras were aimed at.
void TestViewCameras::shiftedAndTurned() {
  QFETCH(double, shift);
  QFETCH(double, turn);
  std::vector<Eye> eyes = gridOfEyes(5, 3);
  for (int k = 0; k < 15; ++k) {
    Eye& eye = eyes[std::size_t(k)];
    eye.cx += (k % 5 - 2) * shift;
    eye.yaw = -(k % 5 - 2) * turn;
    eye.picture = QString::asprintf("%d_%d.png", k / 5, k % 5).toStdString();
    writeView("v/" + eye.picture, eye);
  }
  writeFile("v/transforms.json", transformsOf(eyes));
  const OrderedSession around = orderedSessionAround("v");
  QCOMPARE(linesOf(around), QString());
  QVERIFY2(isOnWall(around.session, 5, 3),
           qPrintable(QString::number(around.session.lightField.viewingDistance)));
  const double shear = focal * (spacing / wall - turn) - shift;
  QVERIFY2(std::abs(around.session.lightField.shear[0] - shear) < flowError,
           qPrintable(QString::number(around.session.lightField.shear[0])));
}

/// A reconstruction of the pictures at four times their size, whose lens was a real one.
void TestViewCameras::picturesOfAnotherSize() {
  const auto eyes = writeNamed("v", 5, 3, {});
  writeFile("v/transforms.json", transformsOf(eyes, 4).replace("\"w\":", "\"k1\": 0.1, \"w\":"));
  const OrderedSession around = orderedSessionAround("v");
  QVERIFY(isOnWall(around.session, 5, 3));
  QCOMPARE(linesOf(around), QString("v/transforms.json: the views are taken for undistorted; the "
                                    "distortion of its lens is not used\n"));
}

void TestViewCameras::noGrid_data() {
  QTest::addColumn<int>("kind");
  QTest::addColumn<QString>("why");
  QTest::newRow("ring") << 0
                        << "its cameras do not look the same way, but up to 60.0° from their mean";
  QTest::newRow("path") << 1 << "spacing beside a regular plane grid";
  QTest::newRow("empty place") << 2 << "its 8 cameras leave places of a grid of 3×3 empty";
  QTest::newRow("one place") << 3 << "two of its cameras stand at one place of the grid";
  QTest::newRow("unposed view") << 4 << "has poses of 8 of the 9 views, not of 8.png";
  QTest::newRow("others") << 5 << "has poses of none of the 9 views, not of 0.png";
  QTest::newRow("bent") << 6 << "% of their spacing beside a regular plane grid";
  QTest::newRow("tilted") << 7 << "its cameras' grid is turned by 12.0° against their pictures";
}

/// What is no grid changes nothing, and one line says why.
void TestViewCameras::noGrid() {
  QFETCH(int, kind);
  QFETCH(QString, why);
  std::vector<Eye> eyes = gridOfEyes(3, 3);
  Random random(5);
  for (int k = 0; k < 9; ++k) {
    Eye& eye = eyes[std::size_t(k)];
    eye.picture = std::to_string(k) + ".png";
    if (kind == 0)
      eye = {{std::sin(0.2618 * (k - 4)), 0, 0}, 0.2618 * (k - 4), eye.cx, eye.picture};
    if (kind == 1)
      eye.place = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (kind == 6) eye.place.z = 4 * eye.place.x * eye.place.x;
    const double c = std::cos(std::numbers::pi / 15), s = std::sin(std::numbers::pi / 15);
    if (kind == 7)
      eye.place = {c * eye.place.x - s * eye.place.y, s * eye.place.x + c * eye.place.y, 0};
  }
  if (kind == 2) eyes.erase(eyes.begin() + 4);
  if (kind == 3)
    eyes[8].place = eyes[0].place, eyes[7].place = eyes[1].place, eyes[6].place = eyes[2].place;
  writeFlat("v", eyes);
  std::optional<OrderedSession> without;  // the views are the same in most
  if (kind == 0 || kind == 2) without = orderedSessionAround("v");
  if (kind == 4) eyes.pop_back();
  if (kind == 5)
    for (Eye& eye : eyes) eye.picture = "frame" + eye.picture;
  writeFile("v/transforms.json", transformsOf(eyes));
  const OrderedSession around = orderedSessionAround("v");
  if (without) QVERIFY(around.session == without->session);
  if (without) QCOMPARE(around.order.sureness, without->order.sureness);
  const QString line = linesOf(around).section('\n', 0, 0);
  QVERIFY2(line.startsWith("v/transforms.json: ") &&
               line.endsWith(why + ": not used for the order of views"),
           qPrintable(line));
}

/// Large grids whose cameras stand up to 6 % of their spacing beside their places, and are turned.
void TestViewCameras::roughGrid() {
  Random random(62);
  for (const auto& [columns, rows] : {std::pair(17, 17), {25, 1}, {2, 9}, {1, 12}}) {
    const auto count = std::size_t(columns * rows);
    std::vector<Eye> eyes = gridOfEyes(columns, rows);
    for (std::size_t k = 0; k < count; ++k) {
      Eye& eye = eyes[k];
      eye.place = {eye.place.x * (rows > 2 ? 1 : 3) + spacing * random.uniform(-0.06, 0.06),
                   eye.place.y - 0.02 * eye.place.x + spacing * random.uniform(-0.06, 0.06),
                   0.03 * eye.place.x + spacing * random.uniform(-0.03, 0.03)};
      eye.yaw = random.uniform(-0.02, 0.02);
    }
    std::vector<RigidTransform> poses;
    for (std::size_t k = 0; k < count; ++k) {
      const WorldPose pose = worldPose(eyes[(7 * k + 3) % count]);  // in another order
      poses.push_back({pose.right, pose.down, pose.forward, pose.place});
    }
    const CameraGrid grid = cameraGridOf(poses);
    QCOMPARE(QString::fromStdString(grid.refusal), QString());
    QCOMPARE(grid.columns, columns);
    QCOMPARE(grid.rows, rows);
    for (std::size_t cell = 0; cell < count; ++cell)
      QCOMPARE((7 * grid.cameras[cell] + 3) % count, cell);
  }
}

/// Poses with the axes of OpenCV in transforms.json turn the grid upside down: the pictures tell.
void TestViewCameras::wrongConvention() {
  const auto eyes = writeNamed("v", 5, 3, {});
  QByteArray file = transformsOf(eyes);
  Json document = Json::parse(file.toStdString());
  for (Json& frame : document["frames"])
    for (int row = 0; row < 3; ++row)
      for (const int column : {1, 2}) {
        Json& value = frame["transform_matrix"][std::size_t(row)][std::size_t(column)];
        value = -value.get<double>();
      }
  writeFile("v/transforms.json", QByteArray::fromStdString(document.dump()));
  const OrderedSession around = orderedSessionAround("v");
  QCOMPARE(around.order.sureness, Sureness::likely);
  QVERIFY2(linesOf(around).startsWith(
               "v/transforms.json: its cameras' places are used, but the pictures contradict them"),
           qPrintable(linesOf(around)));
  QVERIFY(linesOf(around).contains("are its poses in the axes of their own format?"));
}

/// The file says that views are counted column by column, the pictures that rows are: the file has
/// the last word, but not a sure one.
void TestViewCameras::wrongPlaces() {
  std::vector<Eye> eyes = gridOfEyes(3, 3);
  for (int k = 0; k < 9; ++k) {
    eyes[std::size_t(k)].picture = std::to_string(k) + ".png";
    writeView("v/" + eyes[std::size_t(k)].picture, eyes[std::size_t(k)]);
  }
  std::vector<Eye> wrong = eyes;
  for (int k = 0; k < 9; ++k)
    wrong[std::size_t(k)].picture = std::to_string(k % 3 * 3 + k / 3) + ".png";
  writeFile("v/transforms.json", transformsOf(wrong));
  const OrderedSession around = orderedSessionAround("v");
  QCOMPARE(around.session.lightField.scan, ViewScan::columns);
  QCOMPARE(around.order.sureness, Sureness::likely);
  QVERIFY2(linesOf(around).startsWith(
               "v/transforms.json: its cameras' places are used, but the pictures contradict them"),
           qPrintable(linesOf(around)));
}

/// A file that cannot be read is a line, not the end.
void TestViewCameras::brokenFile() {
  std::vector<Eye> eyes = gridOfEyes(3, 3);
  for (int k = 0; k < 9; ++k) eyes[std::size_t(k)].picture = std::to_string(k) + ".png";
  writeFlat("v", eyes);
  for (const QByteArray& content :
       {QByteArray("{\"frames\": [{}"), transformsOf(eyes).replace("transform_matrix", "pose"),
        QByteArray("[1, 2]")}) {
    writeFile("v/transforms.json", content);
    const OrderedSession around = orderedSessionAround("v");
    QVERIFY2(linesOf(around).startsWith("v/transforms.json: ") &&
                 linesOf(around).section('\n', 0, 0).endsWith(": its cameras are not used"),
             qPrintable(linesOf(around)));
  }
  QFile::remove("v/transforms.json");
  for (const char* const ending : {".bin", ".txt"}) {
    for (const char* const name : {"v/cameras", "v/images"})
      writeFile(QString(name) + ending, QByteArray(40, '\x7f'));
    const QString lines = linesOf(orderedSessionAround("v"));
    QVERIFY2(lines.contains("its cameras are not used"), qPrintable(lines));
    for (const char* const name : {"v/cameras", "v/images"}) QFile::remove(QString(name) + ending);
  }
}

/// Views that replace a session's: in their cameras' order, on the display as it was.
void TestViewCameras::inASession() {
  for (const bool isCounted : {false, true}) {
    const QTemporaryDir folder;
    const std::string at = folder.path().toStdString();
    std::vector<Eye> eyes = gridOfEyes(3, 2);
    // The names run from below and from the right; counted ones do so along one number.
    for (std::size_t k = 0; k < eyes.size(); ++k)
      eyes[k].picture =
          isCounted ? "im" + std::to_string(5 - k) + ".png"
                    : "im_" + std::to_string(1 - k / 3) + "_" + std::to_string(2 - k % 3) + ".png";
    writeFlat(at, eyes);
    writeFile(folder.filePath("transforms.json"), transformsOf(eyes));
    Session session;
    session.display.size = {0.31, 0.17};
    LightFieldParams views;
    views.file = at;
    views.layout = Layout::views;
    const OrderedSession with = withViews(session, views, {});
    QVERIFY(areInOrder(with.session, 3, 2));
    QCOMPARE(with.session.display.size, session.display.size);
  }
}

/// What is given stays, and contradictions are told.
void TestViewCameras::usersWords() {
  const auto eyes = writeNamed("v", 4, 4, {true, false, false});
  writeFile("v/transforms.json", transformsOf(eyes));
  const OrderedSession around = orderedSessionAround("v", {"lightField.rows=top-down"});
  QCOMPARE(around.session.lightField.rows, RowOrder::topDown);
  QVERIFY(QString::fromStdString(contradictionOf(around.session.lightField, around.order))
              .contains("lightField.rows=bottom-up"));
  const OrderedSession other = orderedSessionAround("v", {"display.directions=[8,2]"});
  QVERIFY2(linesOf(other).startsWith("v/transforms.json: its cameras stand in a grid of 4×4, but "
                                     "display.directions is 8×2: not used for the order of views"),
           qPrintable(linesOf(other)));
}

QTEST_GUILESS_MAIN(TestViewCameras)
#include "test_view_cameras.moc"
