// SPDX-License-Identifier: BSD-3-Clause
// Tests views in one file: data sets written by libhdf5, and videos of PNGs written by OpenCV.
#include <hdf5.h>
#include <sys/stat.h>

#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <opencv2/videoio.hpp>

#include "core/base/error.h"
#include "io/opening/light_field_order.h"
#include "io/scene/view_source.h"
#include "tests/io/documents.h"
#include "tests/io/layered_views.h"
#include "tests/io/light_fields.h"

using namespace hogelscope;

namespace {

constexpr int width = 7;
constexpr int height = 5;

/// Of view `view` of a sequence.
int sampleAt(int view, int x, int y, int c) {
  return (view * 71 + x * 13 + y * 41 + c * 101) % 251;
}

using Lengths = std::vector<hsize_t>;

/// `file` is an open HDF5 file; chunks of one view, compressed, if `isPacked`.
template <class T>
void addDataSet(hid_t file, const char* name, hid_t type, const Lengths& lengths,
                const std::vector<T>& values, bool isPacked = false) {
  const hid_t space = H5Screate_simple(int(lengths.size()), lengths.data(), nullptr);
  const hid_t created = H5Pcreate(H5P_DATASET_CREATE);
  if (isPacked) {
    Lengths chunk = lengths;
    chunk[0] = chunk[1] = 1;
    H5Pset_chunk(created, int(chunk.size()), chunk.data());
    H5Pset_deflate(created, 6);
  }
  const hid_t set = H5Dcreate2(file, name, type, space, H5P_DEFAULT, created, H5P_DEFAULT);
  if (!values.empty()) H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
  H5Dclose(set);
  H5Pclose(created);
  H5Sclose(space);
}

/// Adds the attribute by which MATLAB marks its variables.
void addMark(hid_t file, const char* name) {
  const hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
  const hid_t space = H5Screate(H5S_SCALAR);
  const hid_t mark =
      H5Acreate2(set, "MATLAB_class", H5T_NATIVE_UINT8, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Aclose(mark);
  H5Sclose(space);
  H5Dclose(set);
}

hid_t newFile(const char* name) {
  return H5Fcreate(name, H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
}

/// Values of rows × columns × height × width × channels.
template <class T>
std::vector<T> sampled(int rows, int columns, int channels, double scale) {
  std::vector<T> values;
  for (int view = 0; view < rows * columns; ++view)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < channels; ++c) values.push_back(T(scale * sampleAt(view, x, y, c)));
  return values;
}

Lengths lengthsOf(int rows, int columns) {
  return {hsize_t(rows), hsize_t(columns), height, width, 3};
}

/// Two rows of three views, 8 bits.
void writeBytes(const char* name, bool isPacked = false) {
  const hid_t file = newFile(name);
  addDataSet(file, "LF", H5T_NATIVE_UINT8, lengthsOf(2, 3), sampled<std::uint8_t>(2, 3, 3, 1),
             isPacked);
  H5Fclose(file);
}

/// The code value of view v · columns + u.
ExpectedTexel inRaster(int columns, int channels = 3) {
  return [=](const TexelIndex& at) {
    const auto value = [&](int c) {
      return double(sampleAt(at.v * columns + at.u, at.i, at.j, channels == 3 ? c : 0));
    };
    return Rgb{value(0), value(1), value(2)};
  };
}

/// Frames in lossless PNGs.
void writeVideo(const char* name, int frames, const char* codec = "png ") {
  cv::VideoWriter out(name, cv::CAP_FFMPEG,
                      cv::VideoWriter::fourcc(codec[0], codec[1], codec[2], codec[3]), 25,
                      cv::Size(width + 9, height + 11));
  QVERIFY(out.isOpened());
  for (int k = 0; k < frames; ++k) {
    cv::Mat frame(height + 11, width + 9, CV_8UC3);
    for (int y = 0; y < frame.rows; ++y)
      for (int x = 0; x < frame.cols; ++x)
        for (int c = 0; c < 3; ++c)
          frame.at<cv::Vec3b>(y, x)[2 - c] = std::uint8_t(sampleAt(k, x, y, c));
    out.write(frame);
  }
}

std::unique_ptr<LightFieldFile> open(const char* file, const LightFieldParams& params = {},
                                     std::array<int, 2> directions = {0, 0}) {
  LightFieldParams used = params;
  used.file = file;
  used.layout = lightFieldOf(file).layout;
  PanelParams display;
  display.directions = directions;
  return openLightField(used, display);
}

QByteArray errorOf(const char* file, const LightFieldParams& params = {},
                   std::array<int, 2> directions = {0, 0}) {
  try {
    (void)open(file, params, directions)->read({});
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

class TestViewSequences : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir::setCurrent(m_folder->path()));
  }

  void bytes_data() {
    QTest::addColumn<bool>("isPacked");
    QTest::newRow("contiguous") << false;
    QTest::newRow("compressed") << true;
  }
  void bytes() {
    QFETCH(const bool, isPacked);
    writeBytes("lf.h5", isPacked);
    QCOMPARE(lightFieldOf("lf.h5").layout, Layout::views);
    const auto file = open("lf.h5");
    QVERIFY((file->size() == LightFieldSize{width, height, 3, 2}));
    QCOMPARE(file->type(), StoredType::uint8);
    QCOMPARE(firstWrong(file->read({}), inRaster(3)), QString());
    QCOMPARE(firstWrong(streamed(*file), inRaster(3)), QString());
  }

  void otherTypes() {
    hid_t file = newFile("16.h5");
    addDataSet(file, "LF", H5T_NATIVE_UINT16, lengthsOf(2, 3),
               sampled<std::uint16_t>(2, 3, 3, 257));
    H5Fclose(file);
    QCOMPARE(open("16.h5")->bits(), 16);
    QCOMPARE(firstWrong(open("16.h5")->read({}), inRaster(3)), QString());
    file = newFile("real.hdf5");
    addDataSet(file, "views", H5T_NATIVE_DOUBLE, lengthsOf(2, 3),
               sampled<double>(2, 3, 3, 1 / 255.0));
    H5Fclose(file);
    QCOMPARE(open("real.hdf5")->type(), StoredType::real);
    QCOMPARE(firstWrong(open("real.hdf5")->read({}), inRaster(3), 1e-4), QString());
  }

  void axes_data() {
    QTest::addColumn<QByteArray>("axes");  // R, C: rows and columns of views; N: views; y, x; c
    QTest::addColumn<int>("colours");
    QTest::addColumn<bool>("isMatlab");
    QTest::addColumn<QByteArray>("line");
    const auto add = [](const char* axes, int colours, const char* line = "",
                        bool isMatlab = false) {
      QTest::addRow("%s %d%s", axes, colours, isMatlab ? " MATLAB" : "")
          << QByteArray(axes) << colours << isMatlab << QByteArray(line);
    };
    const char* const fourth = "a weight or alpha, is left aside";
    add("RCyxc", 3);
    add("RCyxc", 1);
    add("RCyxc", 4, fourth);
    add("RCyx", 1);
    add("Nyxc", 3, "6×8×11×3, which are taken for views × height × width × colours");
    add("Nyxc", 4, fourth);
    add("Ncyx", 3, "views × colours × height × width");
    add("cNyx", 3, "colours × views × height × width");
    add("RCcyx", 4, "rows of views × columns × colours × height × width");
    add("yxRCc", 4, "height × width × rows of views × columns × colours");
    add("Nyx", 1, "views × height × width");
    // MATLAB's LF(row, column, y, x, colour), and the same without its mark.
    add("cxyCR", 4, fourth, true);
    add("cxyCR", 4, "colours × width × height × columns × rows of views");
    add("xyCR", 1, "", true);
  }
  /// By their lengths, in any order.
  void axes() {
    QFETCH(const QByteArray, axes);
    QFETCH(const int, colours);
    QFETCH(const bool, isMatlab);
    QFETCH(const QByteArray, line);
    const std::map<char, int> lengthOf{{'R', 2},  {'C', 5}, {'N', 6},
                                       {'x', 11}, {'y', 8}, {'c', colours}};
    Lengths lengths;
    for (const char axis : axes) lengths.push_back(hsize_t(lengthOf.at(axis)));
    std::vector<std::uint8_t> values;
    std::map<char, int> at;
    const std::function<void(qsizetype)> fill = [&](qsizetype k) {
      if (k == axes.size()) {
        const int view = axes.contains('N') ? at['N'] : 5 * at['R'] + at['C'];
        values.push_back(std::uint8_t(sampleAt(view, at['x'], at['y'], at['c'])));
        return;
      }
      for (at[axes[k]] = 0; at[axes[k]] < lengthOf.at(axes[k]); ++at[axes[k]]) fill(k + 1);
    };
    fill(0);
    const hid_t file = newFile("axes.h5");
    addDataSet(file, "x", H5T_NATIVE_UINT8, lengths, values);
    if (isMatlab) addMark(file, "x");
    H5Fclose(file);
    const int columns = axes.contains('N') ? 6 : 5;
    const auto opened = open("axes.h5");
    QVERIFY((opened->size() == LightFieldSize{11, 8, columns, axes.contains('N') ? 1 : 2}));
    QCOMPARE(firstWrong(opened->read({}), inRaster(columns, colours == 1 ? 1 : 3)), QString());
    const std::vector<std::string> warnings = opened->warnings();
    QCOMPARE(warnings.empty(), line.isEmpty());
    if (!line.isEmpty())
      QVERIFY2(QByteArray::fromStdString(warnings[0]).contains(line), warnings[0].c_str());
  }

  void unclearAxes_data() {
    QTest::addColumn<QList<int>>("lengths");
    QTest::newRow("three alike") << QList<int>{7, 7, 7, 3};
    QTest::newRow("two of 3") << QList<int>{9, 3, 4, 30, 40};
    QTest::newRow("one picture") << QList<int>{30, 40, 3};
    QTest::newRow("too many") << QList<int>{2, 2, 2, 30, 40, 3};
    QTest::newRow("a list") << QList<int>{100};
  }
  void unclearAxes() {
    QFETCH(const QList<int>, lengths);
    const hid_t file = newFile("unclear.h5");
    addDataSet(file, "x", H5T_NATIVE_UINT8, {lengths.begin(), lengths.end()},
               std::vector<std::uint8_t>(200000));
    H5Fclose(file);
    QByteArray shape = "x ";
    for (const int length : lengths)
      shape += (shape.size() > 2 ? "×" : "") + QByteArray::number(length);
    QVERIFY2(errorOf("unclear.h5").endsWith("or floats: " + shape), errorOf("unclear.h5"));
  }

  /// MATLAB's files of version 7.3 have a text before HDF5's signature.
  void behindText() {
    const hid_t created = H5Pcreate(H5P_FILE_CREATE);
    H5Pset_userblock(created, 512);
    const hid_t file = H5Fcreate("a.mat", H5F_ACC_TRUNC, created, H5P_DEFAULT);
    H5Pclose(created);
    addDataSet(file, "LF", H5T_NATIVE_UINT8, lengthsOf(2, 3), sampled<std::uint8_t>(2, 3, 3, 1));
    H5Fclose(file);
    QCOMPARE(lightFieldOf("a.mat").layout, Layout::views);
    QCOMPARE(firstWrong(open("a.mat")->read({}), inRaster(3)), QString());
  }

  /// HCI's archive has the depth beside them.
  void whichDataSet() {
    const hid_t file = newFile("many.h5");
    addDataSet(file, "LF", H5T_NATIVE_UINT8, lengthsOf(2, 3), sampled<std::uint8_t>(2, 3, 3, 1));
    addDataSet(file, "GT_DEPTH", H5T_NATIVE_FLOAT, {2, 3, height, width},
               sampled<float>(2, 3, 1, 0.01));
    addDataSet(file, "number", H5T_NATIVE_UINT8, {1}, std::vector<std::uint8_t>{1});
    H5Fclose(file);
    QCOMPARE(firstWrong(open("many.h5")->read({}), inRaster(3)), QString());
    LightFieldParams params;
    params.pattern = "GT_DEPTH";
    QVERIFY((open("many.h5", params)->size() == LightFieldSize{width, height, 3, 2}));
    QCOMPARE(open("many.h5", params)->read({}).texel({2, 1, 1, 1}).g,
             255 * double(float(0.01 * sampleAt(4, 2, 1, 0))));
    params.pattern = "number";
    QCOMPARE(errorOf("many.h5", params),
             QByteArray("many.h5: number: has 1 values, not rows × columns × height × width × 3 of "
                        "8 or 16 bits or floats"));
    params.pattern = "lf";
    QCOMPARE(errorOf("many.h5", params),
             QByteArray("many.h5: lightField.pattern: \"lf\" is no data set of the file: it has "
                        "GT_DEPTH 2×3×5×7, LF 2×3×5×7×3, number 1"));
  }

  void twoDataSets() {
    const hid_t file = newFile("two.h5");
    for (const char* name : {"a", "b"})
      addDataSet(file, name, H5T_NATIVE_UINT8, lengthsOf(2, 3), sampled<std::uint8_t>(2, 3, 3, 1));
    H5Fclose(file);
    QCOMPARE(errorOf("two.h5"),
             QByteArray("two.h5: lightField.pattern: must name one of the data sets: a 2×3×5×7×3, "
                        "b 2×3×5×7×3"));
  }

  void nothingToShow() {
    H5Fclose(newFile("empty.h5"));
    QVERIFY(errorOf("empty.h5").endsWith("or floats: it has none at all"));
    const hid_t file = newFile("other.h5");
    addDataSet(file, "x", H5T_NATIVE_INT, lengthsOf(2, 3), sampled<int>(2, 3, 3, 1));
    H5Fclose(file);
    QVERIFY(errorOf("other.h5").endsWith("or floats: x 2×3×5×7×3"));
  }

  void damaged() {
    writeBytes("lf.h5", true);
    const QByteArray whole = contentOf("lf.h5");
    for (const double share : {0.1, 0.5, 0.9, 0.999}) {
      writeFile("cut.h5", whole.left(qsizetype(share * double(whole.size()))));
      const QByteArray error = errorOf("cut.h5");
      QVERIFY2(error.startsWith("cut.h5: ") && !error.contains('\n'), error);
    }
    // Bytes flipped, one at a time, within what describes the data: an error or a picture.
    for (qsizetype at = 8; at < std::min<qsizetype>(whole.size(), 4000); at += 31) {
      QByteArray bad = whole;
      bad[at] = char(~bad[at]);
      writeFile("bad.h5", bad);
      (void)errorOf("bad.h5");
    }
    const hid_t file = newFile("hollow.h5");
    addDataSet(file, "LF", H5T_NATIVE_UINT8, {9, 9, 100000, 100000, 3},
               std::vector<std::uint8_t>());
    H5Fclose(file);
    QCOMPARE(errorOf("hollow.h5"),
             QByteArray("hollow.h5: LF: is damaged: 9×9×100000×100000×3 values are not in the "
                        "file"));
  }

  /// Raw values elsewhere, a data set of another's parts, a link: a pipe there would wait for ever,
  /// and any file of the user's could be read as pixels.
  void otherFiles() {
    QCOMPARE(::mkfifo("pipe", 0600), 0);
    writeBytes("lf.h5");
    const Lengths lengths = lengthsOf(2, 3);
    const hid_t space = H5Screate_simple(int(lengths.size()), lengths.data(), nullptr);
    const hid_t outside = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(outside, "pipe", 0, H5F_UNLIMITED);
    const hid_t parts = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_virtual(parts, space, "lf.h5", "LF", space);
    for (const auto& [name, layout] : {std::pair("outside.h5", outside), {"parts.h5", parts}}) {
      const hid_t file = newFile(name);
      H5Dclose(H5Dcreate2(file, "LF", H5T_NATIVE_UINT8, space, H5P_DEFAULT, layout, H5P_DEFAULT));
      H5Fclose(file);
      H5Pclose(layout);
      QCOMPARE(errorOf(name), QByteArray(name) +
                                  ": LF: keeps its values in other files; copy them into "
                                  "this one");
    }
    H5Sclose(space);
    for (const char* target : {"pipe", "lf.h5"}) {
      const hid_t file = newFile("link.h5");
      H5Lcreate_external(target, "/LF", file, "LF", H5P_DEFAULT, H5P_DEFAULT);
      H5Fclose(file);
      LightFieldParams params;
      params.pattern = "LF";
      QVERIFY(errorOf("link.h5", params).contains("\"LF\" is no data set of the file"));
    }
  }

  void notANumber() {
    std::vector<float> values = sampled<float>(2, 3, 3, 0.003);
    values[100] = std::numeric_limits<float>::quiet_NaN();
    const hid_t file = newFile("nan.h5");
    addDataSet(file, "LF", H5T_NATIVE_FLOAT, lengthsOf(2, 3), values);
    H5Fclose(file);
    QCOMPARE(errorOf("nan.h5"), QByteArray("nan.h5: has a value that is not a number"));
  }

  /// As for a folder of views.
  void orderAndShear() {
    writeBytes("lf.h5");
    LightFieldParams params;
    params.rows = RowOrder::bottomUp;
    params.columns = ColumnOrder::rightLeft;
    params.shear = {2, -1};
    const ExpectedTexel stored = inRaster(3);
    const auto expected = [&](const TexelIndex& at) {
      const int right = 2 * (at.u - 1);
      const int down = int(std::floor(-(at.v - 0.5) + 0.5));
      const TexelIndex from{at.i - right, at.j - down, 2 - at.u, 1 - at.v};
      const bool isInside = from.i >= 0 && from.i < width && from.j >= 0 && from.j < height;
      return isInside ? stored(from) : Rgb{};
    };
    QCOMPARE(firstWrong(open("lf.h5", params)->read({}), expected), QString());
  }

  void videos_data() {
    QTest::addColumn<int>("frames");
    QTest::addColumn<int>("columns");  // given; 0: not
    QTest::addColumn<int>("rows");
    QTest::addColumn<ViewScan>("scan");
    QTest::addColumn<int>("du");
    QTest::addColumn<int>("dv");
    QTest::newRow("a square") << 9 << 0 << 0 << ViewScan::raster << 3 << 3;
    QTest::newRow("a row") << 12 << 0 << 0 << ViewScan::raster << 12 << 1;
    QTest::newRow("a grid") << 12 << 4 << 3 << ViewScan::raster << 4 << 3;
    QTest::newRow("serpentine") << 12 << 4 << 3 << ViewScan::serpentine << 4 << 3;
    QTest::newRow("by columns") << 12 << 4 << 3 << ViewScan::columns << 4 << 3;
    QTest::newRow("by columns, to and fro")
        << 12 << 4 << 3 << ViewScan::columnsSerpentine << 4 << 3;
    QTest::newRow("a column") << 6 << 1 << 6 << ViewScan::serpentine << 1 << 6;
  }
  void videos() {
    QFETCH(const int, frames);
    QFETCH(const int, columns);
    QFETCH(const int, rows);
    QFETCH(const ViewScan, scan);
    QFETCH(const int, du);
    QFETCH(const int, dv);
    writeVideo("views.avi", frames);
    LightFieldParams params;
    params.scan = scan;
    const auto file = open("views.avi", params, {columns, rows});
    QVERIFY((file->size() == LightFieldSize{width + 9, height + 11, du, dv}));
    const auto expected = [&](const TexelIndex& at) {
      const bool isByColumns = scan == ViewScan::columns || scan == ViewScan::columnsSerpentine;
      const bool isToAndFro = scan == ViewScan::serpentine || scan == ViewScan::columnsSerpentine;
      const auto [line, place, length] =
          isByColumns ? std::array{at.u, at.v, dv} : std::array{at.v, at.u, du};
      const int frame = line * length + (isToAndFro && line % 2 == 1 ? length - 1 - place : place);
      return Rgb{double(sampleAt(frame, at.i, at.j, 0)), double(sampleAt(frame, at.i, at.j, 1)),
                 double(sampleAt(frame, at.i, at.j, 2))};
    };
    QCOMPARE(firstWrong(file->read({}), expected), QString());
    QCOMPARE(firstWrong(streamed(*file), expected), QString());
  }

  /// The same order of pictures that are files.
  void serpentineFolders() {
    for (int k = 1; k <= 12; ++k)
      writeImageFile(QString("views/view%1.png").arg(k), width, height,
                     [&](int x, int y, int c) { return float(sampleAt(k - 1, x, y, c)) / 255; });
    LightFieldParams params;
    params.scan = ViewScan::serpentine;
    const auto expected = [&](const TexelIndex& at) {
      const int view = at.v * 4 + (at.v == 1 ? 3 - at.u : at.u);
      return inRaster(100)({at.i, at.j, view, 0});
    };
    QCOMPARE(firstWrong(open("views", params, {4, 3})->read({}), expected), QString());
  }

  void badVideos() {
    writeVideo("views.avi", 12);
    QVERIFY(errorOf("views.avi", {}, {5, 5})
                .contains("12 views do not make a grid of 5×5; mend display.directions"));
    writeFile("text.mp4", "no video");
    QVERIFY(errorOf("text.mp4").startsWith("text.mp4: cannot be read as a picture"));
    // A stream does not say its frames: they are counted.
    writeVideo("views.mpg", 9, "PIM1");
    QVERIFY((open("views.mpg")->size() == LightFieldSize{width + 9, height + 11, 3, 3}));
    const QByteArray whole = contentOf("views.avi");
    writeFile("cut.avi", whole.left(whole.size() / 2));
    const QByteArray error = errorOf("cut.avi");
    QVERIFY2(error.isEmpty() || (error.startsWith("cut.avi: ") && !error.contains('\n')), error);
  }

  /// A session made around one has its order and shear.
  void sessionsAround() {
    const GreyGrid grid = gridOf(randomScene(3, -2, 3), 5, 5, {.isUp = true});
    std::vector<std::uint8_t> values;
    for (int row = 0; row < 5; ++row)
      for (int column = 0; column < 5; ++column)
        for (const std::uint8_t value : grid.view(row, column).values)
          values.insert(values.end(), 3, value);
    const GreyPicture one = grid.view(0, 0);
    const hid_t file = newFile("up.h5");
    addDataSet(file, "LF", H5T_NATIVE_UINT8, {5, 5, hsize_t(one.height), hsize_t(one.width), 3},
               values);
    H5Fclose(file);
    const LightFieldOrder order = findLightFieldOrder(lightFieldOf("up.h5"), {});
    QCOMPARE(order.sureness, Sureness::sure);
    QCOMPARE(order.found.rows, RowOrder::bottomUp);
    QCOMPARE(order.found.columns, ColumnOrder::leftRight);
  }

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_APPLESS_MAIN(TestViewSequences)
#include "test_view_sequences.moc"
