// SPDX-License-Identifier: BSD-3-Clause
// Tests reading OpenCV calibrations: what cv::FileStorage itself wrote, what others write by hand,
// and what is not one.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <opencv2/core.hpp>

#include "io/cameras/camera_file.h"
#include "io/documents/session_file.h"
#include "tests/core/random.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

const IntrinsicsParams intrinsics{535.915733961632, 534.25, 342.28315473308373, 235.57082909788173};
const DistortionParams lens{-0.2663726090966068, -0.03858889892230465, 0.0017831947042852964,
                            -0.0002812210044111547, 0.23839153080878486};

constexpr auto realCameras = HOGELSCOPE_SOURCE_DIR "/../shared/data/calibrations.json";

/// As OpenCV's calibration sample does it, in numbers of CV_64F or CV_32F.
void writeByOpenCv(const QString& file,
                   const Calibration& camera = {intrinsics, lens, {{640, 480}}},
                   int type = CV_64F) {
  const auto& [fx, fy, cx, cy] = camera.intrinsics;
  const auto& [k1, k2, p1, p2, k3, k4, k5, k6, model] = camera.distortion;
  cv::Mat k = (cv::Mat_<double>(3, 3) << fx, 0, cx, 0, fy, cy, 0, 0, 1);
  cv::Mat d = (cv::Mat_<double>(5, 1) << k1, k2, p1, p2, k3);
  k.convertTo(k, type);
  d.convertTo(d, type);
  cv::FileStorage storage(file.toStdString(), cv::FileStorage::WRITE);
  storage << "calibration_time"
          << "Fri 30 Sep 2022 10:00:00"
          << "image_width" << (*camera.res)[0] << "image_height" << (*camera.res)[1];
  storage.writeComment("flags: +fix_aspectRatio \"0\"");
  storage << "camera_matrix" << k << "distortion_coefficients" << d << "avg_reprojection_error"
          << 0.2;
}

/// What OpenCV itself reads of it.
Calibration readByOpenCv(const QString& file) {
  const cv::FileStorage storage(file.toStdString(), cv::FileStorage::READ);
  const cv::FileNode k = storage["camera_matrix"]["data"];
  const cv::FileNode d = storage["distortion_coefficients"]["data"];
  return {{k[0], k[4], k[2], k[5]},
          {d[0], d[1], d[2], d[3], d[4]},
          {{int(storage["image_width"]), int(storage["image_height"])}}};
}

bool areEqual(const Calibration& a, const Calibration& b) {
  return a.intrinsics == b.intrinsics && a.distortion == b.distortion && a.res == b.res;
}

QByteArray json(const QByteArray& k, const QByteArray& d, const QByteArray& more = "") {
  return "{\"K\": " + k + ", \"D\": " + d + more + "}";
}

const QByteArray plainMatrix = "[500, 0, 320, 0, 510, 240, 0, 0, 1]";

}  // namespace

class TestCalibrationFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void whatOpenCvWrites_data();
  void whatOpenCvWrites();
  void realCamerasByOpenCv_data();
  void realCamerasByOpenCv();
  void whatOthersWrite_data();
  void whatOthersWrite();
  void goesToEveryStateBeforeOverrides();
  void isRefused_data();
  void isRefused();
  void listOfCameras();
  void listOfOne();
  void listIsRefused_data();
  void listIsRefused();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCalibrationFile::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  QVERIFY(QDir::setCurrent(m_folder->path()));
}

void TestCalibrationFile::whatOpenCvWrites_data() {
  QTest::addColumn<QString>("file");
  for (const char* file : {"k.yml", "k.yaml", "k.json", "k.xml"}) QTest::newRow(file) << file;
}

void TestCalibrationFile::whatOpenCvWrites() {
  QFETCH(const QString, file);
  writeByOpenCv(file);
  QVERIFY(areEqual(loadCalibration(file.toStdString()), {intrinsics, lens, {{640, 480}}}));
  Random random(8);
  for (int k = 0; k < 200; ++k) {
    const auto length = [&random] { return random.uniform(1, 1e4); };
    const auto small = [&random] {
      return random.uniform(-1, 1) * std::pow(10, random.integer(-20, 0));
    };
    const Calibration camera{{length(), length(), length(), -length()},
                             {small(), small(), small(), small(), small()},
                             {{k + 1, 480}}};
    writeByOpenCv(file, camera, random.flip() ? CV_64F : CV_32F);
    QVERIFY(areEqual(loadCalibration(file.toStdString()), readByOpenCv(file)));
  }
}

void TestCalibrationFile::realCamerasByOpenCv_data() {
  whatOpenCvWrites_data();
}

void TestCalibrationFile::realCamerasByOpenCv() {
  QFETCH(const QString, file);
  if (!QFile::exists(realCameras)) QSKIP("the real calibrations are not here");
  for (const NamedCalibration& camera : loadCalibrations(realCameras)) {
    writeByOpenCv(file, camera.calibration);
    QVERIFY2(areEqual(loadCalibration(file.toStdString()), camera.calibration),
             camera.name.c_str());
  }
}

void TestCalibrationFile::whatOthersWrite_data() {
  QTest::addColumn<QByteArray>("content");
  QTest::newRow("flat lists") << json(plainMatrix, "[0.1, -0.2, 0, 0]");
  QTest::newRow("lists of lists") << json("[[500, 0, 320], [0, 510, 240], [0, 0, 1]]",
                                          "[[0.1, -0.2, 0, 0, 0]]");
  QTest::newRow("more coefficients, all 0") << json(plainMatrix, "[0.1, -0.2, 0, 0, 0, 0, 0, 0]");
  QTest::newRow("a stereo pair's first") << QByteArray(
      "%YAML:1.0\nM1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: " + plainMatrix +
      "\nD1: !!opencv-matrix\n   rows: 1\n   cols: 5\n   dt: d\n   data: [ 1.0e-1, "
      "-0.2, 0., 0., 0. ]\nM2: 3\n#-----------------------------------------------"
      "------------------------------------------------------\n");
}

void TestCalibrationFile::whatOthersWrite() {
  QFETCH(const QByteArray, content);
  writeFile("k", content);
  const Calibration read = loadCalibration("k");
  QVERIFY((read.intrinsics == IntrinsicsParams{500, 510, 320, 240}));
  QVERIFY((read.distortion == DistortionParams{0.1, -0.2}));
  QVERIFY(!read.res);
}

void TestCalibrationFile::goesToEveryStateBeforeOverrides() {
  writeByOpenCv("k.yml");
  writeFile("s.json", text());
  const Session session =
      loadSession("s.json", {"distortion.k1=0.5", "intrinsics.fy=1"}, loadCalibration("k.yml"));
  QCOMPARE(session.cameras.size(), std::size_t(2));
  for (const CameraState& state : session.cameras) {
    QCOMPARE(state.distortion.k1, 0.5);
    QCOMPARE(state.distortion.k3, lens.k3);
    QCOMPARE(state.intrinsics.fx, intrinsics.fx);
    QCOMPARE(state.intrinsics.fy, 1.0);
    QVERIFY((state.camera.res == std::array{640, 480}));
  }
  QCOMPARE(session.cameras[0].psf.sigma, 1.5);
  saveSession("t.json", session);
  QVERIFY(loadSession("t.json") == session);
  QCOMPARE(contentOf("t.json").count("\"fov\""), 1);  // the display's
}

void TestCalibrationFile::isRefused_data() {
  QTest::addColumn<QByteArray>("content");
  QTest::addColumn<QString>("line");
  const auto add = [](const char* name, const QByteArray& content, const char* line) {
    QTest::newRow(name) << content << QString("k: ") + line;
  };
  constexpr const char* other =
      "is not a file of cameras: known are OpenCV's YAML, XML and JSON, matrices as JSON or YAML "
      "(K, "
      "D), ROS camera_info, Kalibr, transforms.json, COLMAP and glTF";
  add("empty", "", other);
  add("a text", "something", other);
  add("XML", "<?xml version=\"1.0\"?>", "line 1: is not XML: an element begins with <");
  add("XML behind a byte order mark", "\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<a><a>",
      "line 2: is not XML: an element has no end");
  add("deep XML", "<?xml version=\"1.0\"?>" + QByteArray("<a>").repeated(100000),
      "line 1: is nested deeper than any calibration");
  add("XML of something else", "<?xml version=\"1.0\"?><svg><path>M 0 0</path></svg>", other);
  add("no matrix", R"({"D": [1, 2, 3, 4]})",
      "camera_matrix: is missing; it may also be called: cameraMatrix mtx K M1");
  add("no lens", R"({"K": [500, 0, 1, 0, 500, 1, 0, 0, 1]})",
      "distortion_coefficients: is missing; it may also be called: dist_coeffs distCoeffs dist D "
      "D1");
  add("a number", json("3", "[]"), "K: is not a matrix");
  add("texts", json(R"(["a", "b"])", "[]"), "K: has a value that is not a number");
  add("too few", json("[1, 2, 3]", "[0, 0, 0, 0]"), "camera_matrix: is not of 3×3 numbers");
  add("skew", json("[500, 2, 320, 0, 510, 240, 0, 0, 1]", "[0, 0, 0, 0]"),
      "camera_matrix: has a skew, 2.0, which is not modelled");
  add("projective", json("[500, 0, 320, 0, 510, 240, 0, 1, 1]", "[0, 0, 0, 0]"),
      "camera_matrix: is not of the form [fx 0 cx; 0 fy cy; 0 0 1]");
  add("mirrored", json("[-500, 0, 320, 0, 510, 240, 0, 0, 1]", "[0, 0, 0, 0]"),
      "intrinsics.fx: -500.0 is out of range: 0.001 to 1e+08 px");
  add("three coefficients", json(plainMatrix, "[0, 0, 0]"),
      "distortion_coefficients: are fewer than k1, k2, p1, p2");
  add("thin prism", json(plainMatrix, "[0, 0, 0, 0, 0, 0.5, 0, 0, 0.1, 0, 0, 0]"),
      "distortion_coefficients: are more than the 8 of the rational model; calibrate without the "
      "thin prism and tilted models");
  add("out of range", json(plainMatrix, "[0, 35, 0, 0]"),
      "distortion.k2: 35.0 is out of range: -10 to 10");
  add("one size", json(plainMatrix, "[0, 0, 0, 0]", ", \"image_width\": 640"),
      "image_width: and image_height are not two whole numbers");
  add("huge size",
      json(plainMatrix, "[0, 0, 0, 0]", ", \"image_width\": 640, \"image_height\": 70000"),
      "image size.res[1]: 70000 is out of range: 1 to 16384 px");
  add("deep", "{\"K\": " + QByteArray(100000, '['), "is nested deeper than any session");
  add("deep YAML", "%YAML:1.0\nK: " + QByteArray(100000, '['),
      "line 2: is nested deeper than any calibration");
  add("no YAML", "%YAML:1.0\nK: \"", "line 2: is not YAML: found unexpected end of stream");
  add("base64", "%YAML:1.0\nK: !!opencv-matrix\n   data: !!binary |\n     MWQg\n",
      "K: is a text; write matrices as numbers, without cv::FileStorage::BASE64");
  add("large", "%YAML:1.0\n" + QByteArray(2 << 20, ' '),
      "is larger than 1 MiB: not a camera's calibration");
}

void TestCalibrationFile::isRefused() {
  QFETCH(const QByteArray, content);
  QFETCH(const QString, line);
  writeFile("k", content);
  QCOMPARE(errorOf([] { (void)loadCalibration("k"); }), line);
}

void TestCalibrationFile::listOfCameras() {
  writeFile("k.json", R"({"note": 1, "cameras": [
    {"name": "a", "source": "somewhere", "size": [640, 480], "K": [500, 510, 320, 240],
     "D": [0.1, -0.2, 0.3, 0.4, 0.5]},
    {"name": "b", "size": [1, 2], "K": [5, 6, -7, 8], "D": [0, 0, 0, 0.25]}]})");
  const std::vector<NamedCalibration> read = loadCalibrations("k.json");
  QCOMPARE(read.size(), std::size_t(2));
  QCOMPARE(read[0].name, std::string("a"));
  QVERIFY((read[0].calibration.intrinsics == IntrinsicsParams{500, 510, 320, 240}));
  QVERIFY((read[0].calibration.distortion == DistortionParams{0.1, -0.2, 0.3, 0.4, 0.5}));
  QVERIFY((read[0].calibration.res == std::array{640, 480}));
  QCOMPARE(read[1].name, std::string("b"));
  QVERIFY((read[1].calibration.distortion == DistortionParams{0, 0, 0, 0.25, 0}));
}

void TestCalibrationFile::listOfOne() {
  writeByOpenCv("left lens.yml");
  const std::vector<NamedCalibration> read = loadCalibrations("left lens.yml");
  QCOMPARE(read.size(), std::size_t(1));
  QCOMPARE(read[0].name, std::string("left lens"));
  QVERIFY(read[0].calibration.distortion == lens);
  QVERIFY((read[0].calibration.res == std::array{640, 480}));
  writeFile("no size.json", json(plainMatrix, "[0.1, -0.2, 0, 0]"));
  QVERIFY((loadCalibrations("no size.json")[0].calibration.res == std::array{641, 481}));
}

void TestCalibrationFile::listIsRefused_data() {
  QTest::addColumn<QByteArray>("content");
  QTest::addColumn<QString>("line");
  const auto add = [](const char* name, const QByteArray& content, const char* line) {
    QTest::newRow(name) << content << QString("k: ") + line;
  };
  const auto one = [&add](const char* name, const QByteArray& camera, const char* line) {
    add(name, "{\"cameras\": [" + camera + "]}", line);
  };
  add("empty", "",
      "is not a file of cameras: known are OpenCV's YAML, XML and JSON, matrices as JSON or YAML "
      "(K, "
      "D), ROS camera_info, Kalibr, transforms.json, COLMAP and glTF");
  add("no list", R"({"cameras": 3})", "cameras: is not a list of at least one camera");
  add("an empty list", R"({"cameras": []})", "cameras: is not a list of at least one camera");
  add("a list alone", "[1, 2]",
      "is not a file of cameras: known are OpenCV's YAML, XML and JSON, matrices as JSON or YAML "
      "(K, "
      "D), ROS camera_info, Kalibr, transforms.json, COLMAP and glTF");
  add("a key twice", R"({"cameras": [], "cameras": []})", "cameras: stands twice in one object");
  add("deep", "{\"cameras\": " + QByteArray(100000, '['), "is nested deeper than any session");
  add("large", "{\"cameras\": [" + QByteArray(17 << 20, ' ') + "]}",
      "is larger than 16 MiB: not a camera's calibration");
  one("a number", "3", "cameras[0]: is not an object with name, size, K and D");
  one("no name", "{}", "cameras[0].name: is missing, or not a text that names the camera");
  one("no matrix", R"({"name": "a"})", "cameras[0].K: is missing: [fx, fy, cx, cy]");
  one("nine numbers", R"({"name": "a", "K": [1, 0, 0, 0, 1, 0, 0, 0, 1]})",
      "cameras[0].K: is not a list of numbers [fx, fy, cx, cy]");
  one("texts", R"({"name": "a", "K": ["1", 2, 3, 4]})",
      "cameras[0].K: is not a list of numbers [fx, fy, cx, cy]");
  const QByteArray begin = R"({"name": "a", "K": [500, 500, 320, 240], )";
  one("three coefficients", begin + R"("D": [0, 0, 0]})",
      "cameras[0].D: is not a list of numbers [k1, k2, p1, p2, k3]");
  one("null", begin + R"("D": [0, 0, null, 0]})",
      "cameras[0].D: is not a list of numbers [k1, k2, p1, p2, k3]");
  one("no size", begin + R"("D": [0, 0, 0, 0]})", "cameras[0].size: is missing: [width, height]");
  one("out of range", begin + R"("size": [640, 480], "D": [0, 35, 0, 0]})",
      "cameras[0].D.k2: 35.0 is out of range: -10 to 10");
  one("no length", R"({"name": "a", "size": [640, 480], "K": [0, 1, 0, 0], "D": [0, 0, 0, 0]})",
      "cameras[0].K.fx: 0.0 is out of range: 0.001 to 1e+08 px");
  one("half a pixel", begin + R"("size": [640, 0.5], "D": [0, 0, 0, 0]})",
      "cameras[0].size.res[1]: 0.5 is out of range: 1 to 16384 px");
  one("huge", begin + R"("size": [640, 70000], "D": [0, 0, 0, 0]})",
      "cameras[0].size.res[1]: 70000 is out of range: 1 to 16384 px");
  const QByteArray whole = begin + R"("size": [640, 480], "D": [0, 0, 0, 0]})";
  one("one name twice", whole + "," + whole, "cameras[1].name: \"a\" is another camera's name too");
  add("no size, no centre", json("[500, 0, -320, 0, 510, 240, 0, 0, 1]", "[0, 0, 0, 0]"),
      "image_width: is missing, and the principal point is not in a picture");
}

void TestCalibrationFile::listIsRefused() {
  QFETCH(const QByteArray, content);
  QFETCH(const QString, line);
  writeFile("k", content);
  QCOMPARE(errorOf([] { (void)loadCalibrations("k"); }), line);
}

QTEST_APPLESS_MAIN(TestCalibrationFile)
#include "test_calibration_file.moc"
