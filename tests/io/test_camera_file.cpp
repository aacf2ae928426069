// SPDX-License-Identifier: BSD-3-Clause
// Files of cameras of other programs: what each format says, where its cameras stand, and the line
// for what is not modelled.
#include "io/cameras/camera_file.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <cstring>

#include "core/cameras/camera_set.h"
#include "core/optics/camera.h"
#include "io/documents/camera_set_file.h"
#include "io/documents/gltf_cameras.h"
#include "tests/core/random.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

using Matrix = std::array<std::array<double, 4>, 4>;

QByteArray number(double value) {
  return QByteArray::number(value, 'g', 17);
}

/// Returns a random rotation, by Rodrigues' formula, and place, of which p = M (x, y, z, 1).
Matrix randomPose(Random& random) {
  const Vec3 axis =
      normalise({random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
  const double angle = random.uniform(-3, 3);
  const double c = std::cos(angle), s = std::sin(angle);
  const std::array a{axis.x, axis.y, axis.z};
  const std::array<std::array<double, 3>, 3> crossed{
      {{0, -a[2], a[1]}, {a[2], 0, -a[0]}, {-a[1], a[0], 0}}};
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      m[i][j] = (i == j ? c : 0) + (1 - c) * a[i] * a[j] + s * crossed[i][j];
    m[i][3] = random.uniform(-2, 2);
  }
  m[3][3] = 1;
  return m;
}

Vec3 times(const Matrix& m, const Vec3& p) {
  const auto row = [&](std::size_t i) {
    return m[i][0] * p.x + m[i][1] * p.y + m[i][2] * p.z + m[i][3];
  };
  return {row(0), row(1), row(2)};
}

/// Returns M⁻¹ p of a rigid M.
Vec3 timesInverse(const Matrix& m, const Vec3& p) {
  const Vec3 d{p.x - m[0][3], p.y - m[1][3], p.z - m[2][3]};
  const auto column = [&](std::size_t i) { return m[0][i] * d.x + m[1][i] * d.y + m[2][i] * d.z; };
  return {column(0), column(1), column(2)};
}

QByteArray rows(const Matrix& m) {
  QByteArray text = "[";
  for (const auto& row : m) {
    text += text.size() > 1 ? ", [" : "[";
    for (std::size_t k = 0; k < 4; ++k) text += (k == 0 ? "" : ", ") + number(row[k]);
    text += "]";
  }
  return text + "]";
}

/// The quaternion (w, x, y, z) of a rotation, by its largest component.
std::array<double, 4> quaternionOf(const Matrix& m) {
  const std::array<double, 4> squares{
      1 + m[0][0] + m[1][1] + m[2][2], 1 + m[0][0] - m[1][1] - m[2][2],
      1 - m[0][0] + m[1][1] - m[2][2], 1 - m[0][0] - m[1][1] + m[2][2]};
  const auto largest = std::size_t(std::ranges::max_element(squares) - squares.begin());
  const double d = 2 * std::sqrt(squares[largest]);
  const double a = m[2][1] - m[1][2], b = m[0][2] - m[2][0], c = m[1][0] - m[0][1];
  const double ab = m[0][1] + m[1][0], ac = m[0][2] + m[2][0], bc = m[1][2] + m[2][1];
  switch (largest) {
    case 0:
      return {d / 4, a / d, b / d, c / d};
    case 1:
      return {a / d, d / 4, ab / d, ac / d};
    case 2:
      return {b / d, ab / d, d / 4, bc / d};
    default:
      return {c / d, ac / d, bc / d, d / 4};
  }
}

/// The pixel at which a state without distortion takes a point.
Vec2 pixelOf(const CameraState& state, const Vec3& point) {
  const Camera camera(state.camera, state.intrinsics);
  const Vec3 p = camera.worldFromCamera().inverse().point(point);
  return {camera.focalLength().x * p.x / p.z + camera.centre().x,
          camera.focalLength().y * p.y / p.z + camera.centre().y};
}

Session session() {
  Session session;
  session.cameras.resize(1);
  session.cameras[0].camera.name = "model";
  return session;
}

/// The states that --make-cameras adds.
std::vector<CameraState> statesFrom(const std::string& file,
                                    const std::vector<std::string>& overrides = {}) {
  std::vector<CameraState> states = withCameras(session(), loadCameraSet(file, overrides)).cameras;
  states.erase(states.begin());
  return states;
}

template <class T>
void append(QByteArray& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

const QByteArray plainK = "[500, 0, 320, 0, 510, 240, 0, 0, 1]";
const QByteArray rosFile =
    "image_width: 640\nimage_height: 480\ncamera_name: left\ncamera_matrix:\n  rows: 3\n  cols: "
    "3\n  data: [500, 0, 320, 0, 510, 240, 0, 0, 1]\ndistortion_model: plumb_bob\n"
    "distortion_coefficients:\n  rows: 1\n  cols: 5\n  data: [0.1, -0.2, 0.003, 0.004, 0.05]\n"
    "rectification_matrix:\n  rows: 3\n  cols: 3\n  data: [1, 0, 0, 0, 1, 0, 0, 0, 1]\n";

/// One message as `ros2 topic echo` prints it.
QByteArray message(const QByteArray& frame = "cam") {
  QByteArray text = "header:\n  stamp:\n    sec: 1759840000\n    nanosec: 7\n  frame_id: " + frame +
                    "\nheight: 480\nwidth: 640\ndistortion_model: plumb_bob\n"
                    "d:\n";
  for (const char* d : {"0.1", "-0.2", "0.003", "0.004", "0.05"})
    text += QByteArray("- ") + d + "\n";
  text += "k:\n";
  for (const char* k : {"500.0", "0.0", "320.0", "0.0", "510.0", "240.0", "0.0", "0.0", "1.0"})
    text += QByteArray("- ") + k + "\n";
  return text + "binning_x: 0\nroi:\n  x_offset: 0\n  y_offset: 0\n---\n";
}

QByteArray kalibr(const QByteArray& model, const QByteArray& lens, const QByteArray& more = "") {
  return "  camera_model: " + model +
         "\n  distortion_coeffs: [0.1, -0.2, 0.003, 0.004]\n"
         "  distortion_model: " +
         lens +
         "\n  intrinsics: [500, 510, 320, 240]\n"
         "  resolution: [640, 480]\n  rostopic: /cam/image_raw\n" +
         more;
}

constexpr const char* colmapHeader =
    "# Camera list with one line of data per camera:\n#   CAMERA_ID, MODEL, WIDTH, HEIGHT, "
    "PARAMS[]\n# Number of cameras: 1\n";

}  // namespace

class TestCameraFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { QVERIFY(QDir::setCurrent((m_folder = std::make_unique<QTemporaryDir>())->path())); }
  void formats_data();
  void formats();
  void sizes_data();
  void sizes();
  void rationalAndFisheye_data();
  void rationalAndFisheye();
  void modelsByName_data();
  void modelsByName();
  void mistakes_data();
  void mistakes();
  void severalCameras();
  void assumedSizes();
  void otherSizes();
  void transforms();
  void anglesAlone();
  void splats();
  void colmap_data();
  void colmap();
  void kalibrChain();
  void kalibrOverImu();
  void gltf();
  void gltfOfOurOwn();
  void places();
  void othersAreNoCameras();

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
};

void TestCameraFile::formats_data() {
  QTest::addColumn<QByteArray>("content");
  QTest::addColumn<QByteArray>("format");
  QTest::addColumn<QByteArray>("name");
  const auto row = [](const char* name, const QByteArray& content, const char* format,
                      const char* camera = "k") {
    QTest::newRow(name) << content << QByteArray(format) << QByteArray(camera);
  };
  const QByteArray d = "[0.1, -0.2, 0.003, 0.004, 0.05]";
  const QByteArray size = R"(, "image_width": 640, "image_height": 480})";
  const QByteArray listed = "[[500, 0, 320], [0, 510, 240], [0, 0, 1]]";
  row("the names of OpenCV's tutorial", R"({"mtx": )" + listed + R"(, "dist": [)" + d + "]" + size,
      "camera matrix");
  row("dist_coeff", R"({"camera_matrix": )" + listed + R"(, "dist_coeff": [)" + d + "]" + size,
      "camera matrix");
  row("cameraMatrix", R"({"cameraMatrix": )" + plainK + R"(, "distCoeffs": )" + d + size,
      "camera matrix");
  row("intrinsic matrix", R"({"Intrinsic-Matrix": )" + listed + R"(, "distortion": )" + d + size,
      "camera matrix");
  row("numbers by name", R"({"fx": 500, "fy": 510, "ppx": 320, "ppy": 240, "coeffs": )" + d + size,
      "camera matrix");
  row("coefficients by name",
      R"({"fx": 500, "fy": 510, "cx": 320, "cy": 240, "k1": 0.1, "k2": -0.2, "p1": 0.003,
          "p2": 0.004, "k3": 0.05)" +
          size,
      "camera matrix");
  row("in another object",
      R"({"date": 3, "calibration": {"K": )" + plainK + R"(, "D": )" + d + size + "}",
      "camera matrix", "calibration");
  row("several by name",
      R"({"cameras": {"left": {"model": "standard", "K": )" + listed + R"(, "dist": [)" + d + "]" +
          size + "}}",
      "camera matrix", "left");
  row("matrices in a list",
      R"({"cameras": [{"name": "a", "K": )" + listed + R"(, "D": )" + d + size + "]}",
      "camera matrix", "a");
  row("YAML of matrices", "mtx: " + listed + "\ndist: [" + d + "]\nw: 640\nh: 480\n",
      "camera matrix");
  row("ROS", rosFile, "ROS camera_info", "left");
  row("ROS, a byte order mark and CRLF", "\xEF\xBB\xBF" + QByteArray(rosFile).replace("\n", "\r\n"),
      "ROS camera_info", "left");
  row("topic echo", message(), "ROS camera_info", "cam");
  row("topic echo, often", message() + message() + message(), "ROS camera_info", "cam");
  row("topic echo of ROS 1", message().replace("d:\n", "D:\n").replace("k:\n", "K:\n"),
      "ROS camera_info", "cam");
  row("a message as JSON",
      R"({"header": {"frame_id": "c"}, "distortion_model": "plumb_bob",
      "D": )" +
          d + R"(, "K": )" + plainK + R"(, "width": 640, "height": 480})",
      "ROS camera_info", "c");
  row("Kalibr", "cam0:\n" + kalibr("pinhole", "radtan").replace("004]", "004, 0.05]"),
      "Kalibr camchain", "cam0");
  row("a sensor of EuRoC",
      "sensor_type: camera\nT_BS:\n  cols: 4\n  rows: 4\n  data: [1.0]\nresolution: [640, 480]\n"
      "camera_model: pinhole\nintrinsics: [500, 510, 320, 240]\ndistortion_model: "
      "radial-tangential\ndistortion_coefficients: " +
          d + "\n",
      "Kalibr camchain");
  row("COLMAP",
      QByteArray(colmapHeader) +
          "7 OPENCV 640 480 500 510 320.5 240.5 0.1 -0.2 0.003 "
          "0.004\n",
      "COLMAP", "7");
  row("COLMAP, the full model",
      "7 FULL_OPENCV 640 480 500 510 320.5 240.5 0.1 -0.2 0.003 0.004 "
      "0.05 0 0 0\n",
      "COLMAP", "7");
  row("transforms.json", R"({"camera_model": "OPENCV", "fl_x": 500, "fl_y": 510, "cx": 320.5,
      "cy": 240.5, "w": 640, "h": 480, "k1": 0.1, "k2": -0.2, "p1": 0.003, "p2": 0.004, "k3": 0.05,
      "frames": [{"file_path": "./images/a.0.png", "transform_matrix":
        [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}]})",
      "transforms.json", "a.0");
  row("XML",
      "<?xml version=\"1.0\"?>\n<opencv_storage>\n<!-- <a> -->\n<image_width>640</image_width>"
      "<image_height>480</image_height><camera_matrix type_id=\"opencv-matrix\"><rows>3</rows>"
      "<cols>3</cols><dt>d</dt><data>\n 500. 0. 320. 0.\n 510. 240. 0. 0. 1.</data>"
      "</camera_matrix><distortion_coefficients><rows>5</rows><cols>1</cols><data>1e-1 -0.2 "
      "0.003 0.004 0.05</data></distortion_coefficients></opencv_storage>\n",
      "OpenCV XML");
}

/// All say the same camera, whatever the file is called.
void TestCameraFile::formats() {
  QFETCH(QByteArray, content);
  QFETCH(QByteArray, format);
  QFETCH(QByteArray, name);
  writeFile("k.dat", content);
  QVERIFY(isCameraFile("k.dat"));
  const CameraFile file = readCameraFile("k.dat", CameraUse::poses);
  QCOMPARE(QByteArray::fromStdString(file.format), format);
  QCOMPARE(file.cameras.size(), std::size_t(1));
  QCOMPARE(QByteArray::fromStdString(file.cameras[0].name), name);
  const Calibration read = loadCalibration("k.dat");
  QVERIFY((read.intrinsics == IntrinsicsParams{500, 510, 320, 240}));
  const double k3 = read.distortion.k3;  // COLMAP's OPENCV has none
  QVERIFY(k3 == 0.05 || (k3 == 0 && name == "7"));
  QVERIFY((read.distortion == DistortionParams{0.1, -0.2, 0.003, 0.004, k3}));
  QVERIFY((read.res == std::array{640, 480}));
}

void TestCameraFile::sizes_data() {
  QTest::addColumn<QByteArray>("size");
  QTest::addColumn<bool>("isTold");
  const auto row = [](const char* size, bool isTold = false) {
    QTest::newRow(size) << QByteArray(size) << isTold;
  };
  for (const char* key :
       {"img_size", "image_size", "imageSize", "resolution", "size", "frame_size"})
    QTest::newRow(key) << "\"" + QByteArray(key) + "\": [640, 480]" << false;
  row(R"("width": 640, "height": 480)");
  row(R"("w": 640.0, "h": 480)");
  row(R"("imageWidth": 640, "imageHeight": 480)");
  row(R"("img_size": "640x480")");
  row(R"("image_size": {"width": 640, "height": 480})");
  row(R"("image_shape": [480, 640])");
  row(R"("shape": [480, 640, 3])");
  row(R"("img_size": [480, 640])", true);
  row(R"("image_shape": [640, 480])", true);
  row(R"("res": [640, 480])");
  row(R"("HW": [480, 640])");
}

/// The principal point tells width and height apart where a name says otherwise.
void TestCameraFile::sizes() {
  QFETCH(QByteArray, size);
  QFETCH(bool, isTold);
  writeFile("k.json",
            R"({"K": [500, 0, 330, 0, 510, 236, 0, 0, 1], "D": [0, 0, 0, 0], )" + size + "}");
  std::vector<std::string> notes;
  const Calibration read = loadCalibration("k.json", "", &notes);
  QVERIFY((read.res == std::array{640, 480}));
  QCOMPARE(notes.size(), std::size_t(isTold ? 1 : 0));
}

void TestCameraFile::modelsByName_data() {
  QTest::addColumn<QByteArray>("content");
  QTest::addColumn<QByteArray>("line");
  const auto row = [](const char* name, const QByteArray& content, const char* line) {
    QTest::newRow(name) << content << QByteArray("k: ") + line;
  };
  const char* more =
      " that is not modelled; calibrate with k1, k2, p1, p2, k3 (Brown–Conrady), the rational or "
      "the fisheye model";
  const QByteArray four = "data: [0.1, -0.2, 0.003, 0.004]";
  row("ROS, thin prism", QByteArray(rosFile).replace("plumb_bob", "thin_prism"),
      (QByteArray("distortion_model: \"thin_prism\" is a lens model") + more).constData());
  row("Kalibr's omni", "cam0:\n" + kalibr("omni", "radtan"),
      (QByteArray("cam0.camera_model: \"omni\" is a lens model") + more).constData());
  row("a name of nobody", R"({"model": "swirl", "K": )" + plainK + R"(, "D": [0, 0, 0, 0]})",
      (QByteArray("model: \"swirl\" is a lens model") + more).constData());
  row("COLMAP's field of view", "1 FOV 640 480 500 510 320 240 0.9\n",
      (QByteArray("camera 1: \"FOV\" is a lens model") + more).constData());
  const QByteArray transforms = R"({"fl_x": 500, "w": 640, "h": 480, %, "frames": []})";
  row("nerfstudio's fourth coefficient", QByteArray(transforms).replace("%", R"("k4": 0.1)"),
      "distortion: are more than the 5 of the brown model; calibrate without the thin prism and "
      "tilted models");
  row("glTF, orthographic", R"({"asset": {"version": "2.0"}, "cameras": [{"type": "orthographic",
      "orthographic": {}}]})",
      (QByteArray("cameras[0].type: \"orthographic\" is a lens model") + more).constData());
}

/// Coefficients stand in the order of the model that the file names.
void TestCameraFile::rationalAndFisheye_data() {
  QTest::addColumn<QByteArray>("content");
  QTest::addColumn<DistortionParams>("lens");
  const DistortionParams four{0.1, -0.2, 0, 0, 0.003, 0.004, 0, 0, DistortionModel::fisheye};
  const auto fisheye = [](const QByteArray& file) {
    return QByteArray(file)
        .replace("plumb_bob", "equidistant")
        .replace("cols: 5", "cols: 4")
        .replace(", 0.05]", "]");
  };
  QTest::newRow("OpenCV's YAML with ROS's field") << "%YAML:1.0\n---\n" + fisheye(rosFile) << four;
  QTest::newRow("ROS") << fisheye(rosFile) << four;
  QTest::newRow("ROS, rational") << QByteArray(rosFile)
                                        .replace("plumb_bob", "rational_polynomial")
                                        .replace("cols: 5", "cols: 8")
                                        .replace("0.05]", "0.05, 1, 2, 3]")
                                 << DistortionParams{0.1,   -0.2, 0.003,
                                                     0.004, 0.05, 1,
                                                     2,     3,    DistortionModel::rational};
  QTest::newRow("OpenCV's sample")
      << "%YAML:1.0\nfisheye_model: 1\nK: " + plainK + "\n" + "D: [0.1, -0.2, 0.003, 0.004]\n"
      << four;
  QTest::newRow("OpenCV's vector of eight")
      << R"({"K": )" + plainK + R"(, "D": [0.1, 0.2, 0.003, 0.004, 0.5, 0.6, 0.7, 0.8]})"
      << DistortionParams{0.1, 0.2, 0.003, 0.004, 0.5, 0.6, 0.7, 0.8, DistortionModel::rational};
  QTest::newRow("Kalibr's equidistant") << "cam0:\n" + kalibr("pinhole", "equidistant") << four;
  QTest::newRow("COLMAP's fisheye")
      << QByteArray("1 OPENCV_FISHEYE 640 480 500 510 320 240 0.1 -0.2 0.003 0.004\n") << four;
  const QByteArray transforms =
      R"({"fl_x": 500, "w": 640, "h": 480, "k1": 0.1, "k2": -0.2, "k3": 0.003, "k4": 0.004, %, )"
      R"("frames": []})";
  QTest::newRow("nerfstudio's fisheye")
      << QByteArray(transforms).replace("%", R"("camera_model": "OPENCV_FISHEYE")") << four;
  QTest::newRow("instant-ngp's fisheye")
      << QByteArray(transforms).replace("%", R"("is_fisheye": true)") << four;
}

void TestCameraFile::rationalAndFisheye() {
  QFETCH(QByteArray, content);
  QFETCH(DistortionParams, lens);
  writeFile("k", content);
  QVERIFY(loadCalibration("k").distortion == lens);
}

/// What is not modelled is refused by its name, but --info can say what it is.
void TestCameraFile::modelsByName() {
  QFETCH(QByteArray, content);
  QFETCH(QByteArray, line);
  writeFile("k", content);
  QVERIFY(isCameraFile("k"));
  QCOMPARE(readCameraFile("k", CameraUse::poses).cameras.size(), std::size_t(1));
  QCOMPARE(errorOf([] { (void)loadCalibration("k"); }).toUtf8(), line);
  QCOMPARE(errorOf([] { (void)loadCameraSet("k"); }).toUtf8(), line);
}

void TestCameraFile::mistakes_data() {
  QTest::addColumn<QByteArray>("content");
  QTest::addColumn<QByteArray>("line");
  const auto row = [](const char* name, const QByteArray& content, const char* line) {
    QTest::newRow(name) << content << QByteArray("k: ") + line;
  };
  const QByteArray frame =
      R"({"fl_x": 500, "w": 64, "h": 48, "frames": [{"transform_matrix": %}]})";
  const auto pose = [&](const char* matrix) { return QByteArray(frame).replace("%", matrix); };
  const char* rigid =
      "frames[0].transform_matrix: is not a rotation and a place: it scales, skews or mirrors";
  row("a scaled pose", pose("[[2,0,0,0],[0,2,0,0],[0,0,2,0],[0,0,0,1]]"), rigid);
  row("a mirrored pose", pose("[[1,0,0,0],[0,1,0,0],[0,0,-1,0],[0,0,0,1]]"), rigid);
  row("half a pose", pose("[[1,0,0,0],[0,1,0,0]]"),
      "frames[0].transform_matrix: is not a matrix of 4×4 or 3×4 numbers");
  row("no pose", R"({"fl_x": 500, "w": 64, "h": 48, "frames": [{}]})",
      "frames[0].transform_matrix: is missing");
  row("no length", R"({"w": 64, "h": 48, "camera_model": "OPENCV", "frames": []})",
      "fl_x: is missing, and there is no camera_angle_x either");
  row("COLMAP's parameters", "1 PINHOLE 640 480 500 510\n",
      "camera 1: PINHOLE has 4 parameters, not 2");
  row("images alone", "1 1 0 0 0 0 0 0 1 a.png\n\n",
      "has COLMAP's images, but there is no cameras.txt or cameras.bin beside it");
  row("entities",
      "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY b \"c\">]><opencv_storage><K>&b;</K>"
      "</opencv_storage>",
      "line 1: has a document type or a section of text (<!), which is not read");
  row("a type of its own", R"({"asset": {}, "cameras": [{"type": "perspective", "perspective":
      {"yfov": 4}}]})",
      "cameras[0].perspective.yfov: is not an angle between 0 and π");
  row("a node above itself", R"({"asset": {}, "cameras": [{"type": "perspective", "perspective":
      {"yfov": 1}}], "nodes": [{"camera": 0, "children": [1]}, {"children": [0]}]})",
      "nodes[0].: has more than 1000 nodes above it, or is above itself");
  row("a camera that is not calibrated",
      QByteArray(rosFile).replace("500, 0, 320, 0, 510, 240, 0, 0, 1", "0, 0, 0, 0, 0, 0, 0, 0, 0"),
      "camera_matrix: is of zeros: the camera has not been calibrated");
  row("short of camera matrices", R"({"D": [1, 2, 3, 4]})",
      "camera_matrix: is missing; it may also be called: cameraMatrix mtx K M1");
}

void TestCameraFile::mistakes() {
  QFETCH(QByteArray, content);
  QFETCH(QByteArray, line);
  writeFile("k", content);
  compareLine(
      errorOf([] { (void)calibratedCameras(readCameraFile("k", CameraUse::poses)); }).toUtf8(),
      line);
}

void TestCameraFile::severalCameras() {
  const QByteArray second = kalibr("pinhole", "radtan").replace("500", "600");
  writeFile("chain.yaml", "cam0:\n" + kalibr("pinhole", "radtan") + "cam1:\n" + second);
  QCOMPARE(
      errorOf([] { (void)loadCalibration("chain.yaml"); }),
      QString("chain.yaml: has the cameras cam0, cam1: say by its name which of them is wanted"));
  QCOMPARE(loadCalibration("chain.yaml", "cam1").intrinsics.fx, 600.0);
  QCOMPARE(errorOf([] { (void)loadCalibration("chain.yaml", "cam2"); }),
           QString("chain.yaml: has no camera \"cam2\": cam0, cam1"));
  QCOMPARE(loadCameraSet("chain.yaml", {}, "cam1").source.index(), std::size_t(5));
  QCOMPARE(loadCalibrations("chain.yaml").size(), std::size_t(2));
  // A stereo pair of OpenCV, and messages of two cameras.
  writeFile("pair.json", R"({"M1": )" + plainK + R"(, "D1": [0, 0, 0, 0], "M2": )" +
                             QByteArray(plainK).replace("500", "600") + R"(, "D2": [0, 0, 0, 0]})");
  QCOMPARE(loadCalibration("pair.json", "M2").intrinsics.fx, 600.0);
  QVERIFY(errorOf([] { (void)loadCalibration("pair.json"); }).contains("has the cameras M1, M2"));
  // A list of cameras without names, of which the places in it are the names.
  writeFile("list.json", R"([{"K": )" + plainK + R"(, "D": [0, 0, 0, 0]}, {"K": )" +
                             QByteArray(plainK).replace("500", "600") + R"(, "D": [0, 0, 0, 0]}])");
  QCOMPARE(loadCalibration("list.json", "1").intrinsics.fx, 600.0);
  writeFile("echo.yaml", message("a") + message("b").replace("500", "600") + message("a"));
  QCOMPARE(readCameraFile("echo.yaml", CameraUse::lens).cameras.size(), std::size_t(2));
  QCOMPARE(loadCalibration("echo.yaml", "b").intrinsics.fx, 600.0);
  // Cameras of one lens need no choice.
  writeFile("same.yaml", message("a") + message("b"));
  QCOMPARE(loadCalibration("same.yaml").intrinsics.fx, 500.0);
}

/// Without a size the state's stays, unless the principal point is beside its picture.
void TestCameraFile::assumedSizes() {
  writeFile("k.json", R"({"K": [1052.4, 0, 957.1, 0, 1050.2, 541.8, 0, 0, 1], "D": [0, 0, 0, 0]})");
  const Calibration read = loadCalibration("k.json");
  QVERIFY(!read.res);
  CameraState state;
  state.camera.res = {120, 90};
  apply(read, state);
  QVERIFY((state.camera.res == std::array{1915, 1085}));
  QCOMPARE(sizeWarning(read, state.camera.res),
           std::string("does not say the size of its pictures: 1915×1085 px are assumed"));
  state.camera.res = {1920, 1080};
  apply(read, state);
  QVERIFY((state.camera.res == std::array{1920, 1080}));
}

/// States of another size than the calibration's pictures are offered what scales it: pixels' edges
/// keep their places, so the middle of 1920 pixels, 959.5, is that of 600, 299.5.
void TestCameraFile::otherSizes() {
  writeFile("k.json", R"({"K": [1056, 0, 959.5, 0, 1056, 539.5, 0, 0, 1], "D": [0, 0, 0, 0],
                          "image_size": [1920, 1080]})");
  const Calibration read = loadCalibration("k.json");
  QCOMPARE(sizeWarning(read, {1920, 1080}), std::string());
  QCOMPARE(sizeWarning(read, {600, 600}),
           std::string("is of pictures of 1920×1080 px, but states have 600×600 px: --set "
                       "camera.res=[600,338] --set intrinsics.fx=330 --set intrinsics.fy=330 --set "
                       "intrinsics.cx=299.5 --set intrinsics.cy=168.25 scale it to that width"));
}

/// A point is where nerfstudio's own camera takes it: +x right, +y up, it looks along −z, and
/// pixels are counted from the picture's corner.
void TestCameraFile::transforms() {
  Random random(62);
  QByteArray frames;
  std::vector<Matrix> poses;
  for (int k = 0; k < 20; ++k) {
    poses.push_back(randomPose(random));
    frames +=
        (k == 0 ? "" : ", ") + QByteArray(R"({"file_path": "images\\frame_)") +
        QByteArray::number(k) + ".png\"" +
        (k == 19 ? R"(, "fl_x": 200, "fl_y": 210, "cx": 31, "cy": 22, "w": 64, "h": 48)" : "") +
        R"(, "transform_matrix": )" + rows(poses.back()) + "}";
  }
  writeFile("any name", R"({"fl_x": 500, "fl_y": 510, "cx": 330, "cy": 236, "w": 640, "h": 480,
      "frames": [)" + frames +
                            "]}");
  const std::vector<CameraState> states = statesFrom("any name", {"cameraSet.scale=0.1"});
  QCOMPARE(states.size(), poses.size());
  QCOMPARE(states[3].camera.name, std::string("frame_3"));
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const Vec3 point{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(1, 3)};
    const Vec3 inOwn{point.x, -point.y, -point.z};  // in front of the camera, OpenGL's axes
    const Vec3 world = times(poses[k], inOwn);
    const bool isOther = k == 19;
    const double fx = isOther ? 200 : 500, fy = isOther ? 210 : 510;
    const double cx = isOther ? 31 : 330, cy = isOther ? 22 : 236;
    const Vec2 pixel = pixelOf(states[k], 0.1 * world);
    QVERIFY(std::abs(pixel.x - (fx * point.x / point.z + cx - 0.5)) < 1e-4);
    QVERIFY(std::abs(pixel.y - (fy * point.y / point.z + cy - 0.5)) < 1e-4);
  }
  QVERIFY((states[19].camera.res == std::array{64, 48}));
  QVERIFY(loadCameraSet("any name").notes.back().starts_with("says no unit of its places"));
}

/// Blender's data sets have one angle, and no size; pixels are square.
void TestCameraFile::anglesAlone() {
  writeFile("t.json", R"({"camera_angle_x": 0.7, "frames": [{"file_path": "./train/r_0",
      "transform_matrix": [[1,0,0,0],[0,1,0,0],[0,0,1,4],[0,0,0,1]]}]})");
  const std::vector<CameraState> states = statesFrom("t.json");
  QCOMPARE(states[0].camera.name, std::string("r_0"));
  QVERIFY((states[0].camera.res == CameraParams().res));
  const double f = CameraParams().res[0] / 2.0 / std::tan(0.35);
  QVERIFY(std::abs(states[0].intrinsics.fx - f) < 1e-9);
  QCOMPARE(Camera(states[0].camera, states[0].intrinsics).focalLength().y, states[0].intrinsics.fx);
  QVERIFY((states[0].camera.eye == Vec3{0, 0, 4}) && states[0].camera.lookat == Vec3());
}

void TestCameraFile::splats() {
  Random random(63);
  const Matrix pose = randomPose(random);
  QByteArray rotation = "[";
  for (std::size_t i = 0; i < 3; ++i)
    rotation += (i == 0 ? "[" : ", [") + number(pose[i][0]) + ", " + number(pose[i][1]) + ", " +
                number(pose[i][2]) + "]";
  writeFile("cameras.json",
            R"([{"id": 0, "img_name": "a", "width": 640, "height": 480, "position": [)" +
                number(pose[0][3]) + ", " + number(pose[1][3]) + ", " + number(pose[2][3]) +
                R"(], "rotation": )" + rotation + R"(], "fy": 510, "fx": 500}])");
  const std::vector<CameraState> states = statesFrom("cameras.json");
  const Vec3 point{0.3, -0.2, 1.5};
  const Vec2 pixel = pixelOf(states[0], times(pose, point));
  QVERIFY(std::abs(pixel.x - (500 * 0.3 / 1.5 + 319.5)) < 1e-4);
  QVERIFY(std::abs(pixel.y - (510 * -0.2 / 1.5 + 239.5)) < 1e-4);
}

void TestCameraFile::colmap_data() {
  QTest::addColumn<bool>("isBinary");
  QTest::addColumn<QString>("given");
  for (const bool isBinary : {false, true})
    for (const char* given : {"images", "cameras", "folder"})
      QTest::addRow("%s %s", given, isBinary ? "bin" : "txt") << isBinary << QString(given);
}

/// COLMAP's x = K (R X + t), with the quaternion of R, and pixels from the picture's corner.
void TestCameraFile::colmap() {
  QFETCH(bool, isBinary);
  QFETCH(QString, given);
  Random random(64);
  const int count = 12;
  std::vector<Matrix> poses;
  QByteArray cameras = QByteArray(colmapHeader) +
                       "2 PINHOLE 640 480 500 510 330 236\n"
                       "5 SIMPLE_RADIAL 64 48 200 31 22 0.0\n";
  QByteArray images = "# Image list with two lines of data per image:\n";
  QByteArray cameraBytes, imageBytes;
  append(cameraBytes, std::uint64_t(2));
  for (const int id : {2, 5}) {
    append(cameraBytes, std::uint32_t(id));
    append(cameraBytes, std::int32_t(id == 2 ? 1 : 2));
    append(cameraBytes, std::uint64_t(id == 2 ? 640 : 64));
    append(cameraBytes, std::uint64_t(id == 2 ? 480 : 48));
    for (const double p :
         id == 2 ? std::array{500.0, 510.0, 330.0, 236.0} : std::array{200.0, 31.0, 22.0, 0.0})
      append(cameraBytes, p);
  }
  append(imageBytes, std::uint64_t(count));
  for (int k = 0; k < count; ++k) {
    poses.push_back(randomPose(random));
    const auto q = quaternionOf(poses.back());
    const int camera = k % 3 == 0 ? 5 : 2;
    const QByteArray name = "sub folder/p " + QByteArray::number(k) + ".jpg";
    images += QByteArray::number(k + 1);
    append(imageBytes, std::uint32_t(k + 1));
    for (const double part : q) images += " " + number(part), append(imageBytes, part);
    for (std::size_t i = 0; i < 3; ++i)
      images += " " + number(poses.back()[i][3]), append(imageBytes, poses.back()[i][3]);
    images += " " + QByteArray::number(camera) + " " + name + "\n";
    append(imageBytes, std::uint32_t(camera));
    imageBytes += name + '\0';
    append(imageBytes, std::uint64_t(k));
    for (int point = 0; point < k; ++point) {
      images += "1.5 2.5 -1 ";
      append(imageBytes, 1.5), append(imageBytes, 2.5), append(imageBytes, std::int64_t(-1));
    }
    images += "\n";
  }
  const QString ending = isBinary ? ".bin" : ".txt";
  writeFile("sparse/cameras" + ending, isBinary ? cameraBytes : cameras);
  writeFile("sparse/images" + ending, isBinary ? imageBytes : images);
  const QString file = given == "folder" ? "sparse" : "sparse/" + given + ending;
  const std::vector<CameraState> states = statesFrom(file.toStdString());
  QCOMPARE(states.size(), std::size_t(count));
  for (std::size_t k = 0; k < states.size(); ++k) {
    QCOMPARE(states[k].camera.name, "p " + std::to_string(k));
    const Vec3 inCamera{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(1, 3)};
    const Vec2 pixel = pixelOf(states[k], timesInverse(poses[k], inCamera));
    const bool isFifth = k % 3 == 0;
    const double x = inCamera.x / inCamera.z, y = inCamera.y / inCamera.z;
    QVERIFY(std::abs(pixel.x - (isFifth ? 200 * x + 30.5 : 500 * x + 329.5)) < 1e-4);
    QVERIFY(std::abs(pixel.y - (isFifth ? 200 * y + 21.5 : 510 * y + 235.5)) < 1e-4);
  }
  QVERIFY(
      errorOf([&] { (void)loadCalibration(file.toStdString()); }).contains("has the cameras 2, 5"));
  QCOMPARE(loadCalibration(file.toStdString(), "5").intrinsics.fy, 200.0);
}

/// A point in the first camera's frame is at T_cn_cnm1 … T_c1_c0 X in the others'; the first stands
/// where the template does.
void TestCameraFile::kalibrChain() {
  Random random(65);
  const Matrix one = randomPose(random), two = randomPose(random);
  const auto chained = [](const Matrix& m) {
    QByteArray text = "  T_cn_cnm1:\n";
    for (const auto& row : m)
      text += "  - [" + number(row[0]) + ", " + number(row[1]) + ", " + number(row[2]) + ", " +
              number(row[3]) + "]\n";
    return text;
  };
  writeFile("c", "cam0:\n" + kalibr("pinhole", "none") + "cam1:\n" +
                     kalibr("pinhole", "none", chained(one)) + "cam2:\n" +
                     kalibr("pinhole", "none", chained(two)));
  const std::vector<CameraState> states = statesFrom("c");
  QCOMPARE(states.size(), std::size_t(3));
  QVERIFY(states[0].camera.eye == session().cameras[0].camera.eye);
  const RigidTransform world = Camera(states[0].camera, states[0].intrinsics).worldFromCamera();
  for (int k = 0; k < 20; ++k) {
    const Vec3 point{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    const Vec3 inOne = times(one, point), inTwo = times(two, inOne);
    for (const auto& [state, p] :
         {std::pair(&states[0], point), {&states[1], inOne}, {&states[2], inTwo}}) {
      if (std::abs(p.z) < 1) continue;
      const Vec2 pixel = pixelOf(*state, world.point(point));
      QVERIFY(std::abs(pixel.x - (500 * p.x / p.z + 320)) < 1e-3);
      QVERIFY(std::abs(pixel.y - (510 * p.y / p.z + 240)) < 1e-3);
    }
  }
}

/// Without a chain the poses are those to the inertial sensor: p = T_cam_imu (x, y, z, 1).
void TestCameraFile::kalibrOverImu() {
  Random random(66);
  const Matrix one = randomPose(random), two = randomPose(random);
  writeFile("c", "cam0:\n" + kalibr("pinhole", "none", "  T_cam_imu: " + rows(one) + "\n") +
                     "cam1:\n" + kalibr("pinhole", "none", "  T_cam_imu: " + rows(two) + "\n"));
  const std::vector<CameraState> states = statesFrom("c");
  const RigidTransform world = Camera(states[0].camera, states[0].intrinsics).worldFromCamera();
  for (int k = 0; k < 20; ++k) {
    const Vec3 ofImu{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    const Vec3 p = times(two, ofImu);
    if (std::abs(p.z) < 1) continue;
    const Vec2 pixel = pixelOf(states[1], world.point(times(one, ofImu)));
    QVERIFY(std::abs(pixel.x - (500 * p.x / p.z + 320)) < 1e-3);
    QVERIFY(std::abs(pixel.y - (510 * p.y / p.z + 240)) < 1e-3);
  }
}

/// A camera under nodes that turn, scale and move.
void TestCameraFile::gltf() {
  const QByteArray gltf = R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
      "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "aspectRatio": 1.5, "znear": 0.1}}],
      "nodes": [{"children": [1], "translation": [1, 2, 3], "scale": [2, 2, 2],
                 "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]},
                {"name": "eye", "camera": 0, "translation": [0.5, 0, 0]}]})";
  QByteArray glb = "glTF";
  append(glb, std::uint32_t(2));
  append(glb, std::uint32_t(20 + gltf.size()));
  append(glb, std::uint32_t(gltf.size()));
  writeFile("c.gltf", gltf);
  writeFile("c.glb", glb + "JSON" + gltf);
  for (const char* file : {"c.gltf", "c.glb"}) {
    const std::vector<CameraState> states = statesFrom(file);
    QCOMPARE(states.size(), std::size_t(1));
    const CameraParams& camera = states[0].camera;
    QCOMPARE(camera.name, std::string("eye"));
    // +x of the parent is +y of the world, and twice as long.
    QVERIFY(length(camera.eye - Vec3{1, 3, 3}) < 1e-8);
    QVERIFY(length(normalise(camera.lookat - camera.eye) - Vec3{0, 0, -1}) < 1e-8);
    QVERIFY(length(camera.up - Vec3{-1, 0, 0}) < 1e-8);
    QVERIFY((camera.res == std::array{900, 600}));
    QVERIFY(std::abs(states[0].intrinsics.fy - 300 / std::tan(0.4)) < 1e-9);
    QVERIFY(std::abs(states[0].intrinsics.fx - states[0].intrinsics.fy) < 1e-9);
  }
}

/// What the program exports comes back.
void TestCameraFile::gltfOfOurOwn() {
  std::vector<CameraState> states(2);
  states[0].camera = {"a", {0.1, 0.2, 0.5}, {0, 0.05, 0}, {0.1, 1, 0}, 40, {320, 200}, 1};
  states[1].camera = {"b", {-0.1, 0, 0.7}, {0, 0, 0}, {0, 1, 0}, 40, {640, 480}, 1};
  states[1].intrinsics = {500, 510, 330, 236};
  writeFile("g.gltf",
            QByteArray::fromStdString(withCameras(R"({"asset": {"version": "2.0"}})", {}, states)));
  const std::vector<CameraState> read = statesFrom("g.gltf");
  QCOMPARE(read.size(), states.size());
  for (std::size_t k = 0; k < 2; ++k) {
    QCOMPARE(read[k].camera.name, states[k].camera.name);
    QVERIFY(length(read[k].camera.eye - states[k].camera.eye) < 1e-8);
  }
  QVERIFY(read[1].intrinsics == states[1].intrinsics);
  for (const Vec3& point : {Vec3{0.1, 0.05, 0}, {-0.2, 0.1, 0.1}}) {
    const Vec2 a = pixelOf(read[1], point), b = pixelOf(states[1], point);
    QVERIFY(std::hypot(a.x - b.x, a.y - b.y) < 1e-4);
  }
}

/// Names are those of the cameras, as far as they can be names of files, and differ.
void TestCameraFile::places() {
  const QByteArray frame = R"({"file_path": "%", "transform_matrix":
      [[1,0,0,0],[0,1,0,0],[0,0,1,0.6],[0,0,0,1]]})";
  const auto file = [&](const QList<QByteArray>& names) {
    QByteArray frames;
    for (const QByteArray& name : names)
      frames += (frames.isEmpty() ? "" : ", ") + QByteArray(frame).replace("%", name);
    writeFile("t.json", R"({"fl_x": 50, "w": 64, "h": 48, "frames": [)" + frames + "]}");
    QByteArray read;
    for (const CameraState& state : statesFrom("t.json"))
      read += (read.isEmpty() ? "" : "|") + QByteArray::fromStdString(state.camera.name);
    return read;
  };
  QCOMPARE(file({"a/0001.png", "a/0002.png"}), QByteArray("0001|0002"));
  QCOMPARE(file({"./left/1.png", "./right/1.png"}), QByteArray("left-1|right-1"));
  QCOMPARE(file({"x/CON", "a\\u0007", "model.png", "MODEL.jpg"}),
           QByteArray("camera|camera 2|model 2|MODEL 3"));
  const std::vector<CameraState> named = statesFrom("t.json", {"cameraSet.name=v"});
  QCOMPARE(named[2].camera.name, std::string("v-0003"));
}

void TestCameraFile::othersAreNoCameras() {
  for (const QByteArray& content :
       {QByteArray(), QByteArray("time,x,y\n0,0,0\n"), QByteArray("# a: b\nv 0 0 0\nf 1 2 3\n"),
        QByteArray("P3\n1 1\n255\n1 2 3\n"), QByteArray(R"({"hogelscope": 1, "cameras": []})"),
        text(), QByteArray(R"({"hogelscopeCameras": 1, "poses": []})"),
        QByteArray("0 1 2 3 0 0 0 1\n"), QByteArray("a: 1\nb: [2]\n"),
        QByteArray(R"({"pitch": 1})"), QByteArray(100000, '\0'),
        QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16)}) {
    writeFile("other", content);
    QVERIFY2(!isCameraFile("other"), content.left(30));
  }
  QVERIFY(!isCameraFile("."));
  QVERIFY(!isCameraFile("none"));
  QCOMPARE(errorOf([] { (void)readCameraFile("other", CameraUse::lens); }).left(40),
           QString("other: is not a file of cameras: known a").left(40));
}

QTEST_APPLESS_MAIN(TestCameraFile)
#include "test_camera_file.moc"
