// SPDX-License-Identifier: BSD-3-Clause
// Tests reading of light fields made by others, and that parallax goes the right way with them.
#include <QTest>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/optics/camera.h"
#include "io/documents/session_file.h"
#include "io/scene/view_source.h"
#include "tests/io/documents.h"
#include "tests/io/texels.h"

using namespace hogelscope;

namespace {

const QString data = HOGELSCOPE_SOURCE_DIR "/../shared/data/";

cv::Mat real(const cv::Mat& grey) {
  cv::Mat picture;
  grey.convertTo(picture, CV_32F);
  return picture;
}

/// What a camera saw of the panel, seen from straight ahead again: one pixel for one hogel.
cv::Mat onPanel(const ViewSource& scene, const CameraState& state) {
  const Image image = simulate(scene.job(state));
  const cv::Mat rgb(image.height, image.width, CV_8UC3,
                    const_cast<std::uint8_t*>(image.rgb.data()));
  cv::Mat grey;
  cv::cvtColor(rgb, grey, cv::COLOR_RGB2GRAY);
  const Camera camera(state.camera);
  const RigidTransform cameraFromWorld = camera.worldFromCamera().inverse();
  const auto& [width, height] = scene.display.size;
  cv::Mat map(scene.display.hogels[1], scene.display.hogels[0], CV_32FC2);
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      const Vec3 p = cameraFromWorld.point(
          {((x + 0.5) / map.cols - 0.5) * width, (0.5 - (y + 0.5) / map.rows) * height, 0});
      map.at<cv::Point2f>(y, x) = {float(camera.focalLength().x * p.x / p.z + camera.centre().x),
                                   float(camera.focalLength().y * p.y / p.z + camera.centre().y)};
    }
  }
  cv::Mat picture;
  cv::remap(grey, picture, map, {}, cv::INTER_LINEAR);
  return real(picture);
}

/// Mean squared difference of `region` with `other`, moved by `shift`.
double costOf(const cv::Mat& picture, const cv::Mat& other, const cv::Rect& region,
              const cv::Point& shift = {}) {
  return cv::norm(picture(region), other(region - shift), cv::NORM_L2SQR) / region.area();
}

/// By how many hogels `other` moves to fit `picture` best in `region`: along x, or along y.
double bestShift(const cv::Mat& picture, const cv::Mat& other, const cv::Rect& region,
                 bool isAlongX) {
  constexpr int reach = 80;
  std::vector<double> costs;
  for (int shift = -reach; shift <= reach; ++shift)
    costs.push_back(
        costOf(picture, other, region, isAlongX ? cv::Point(shift, 0) : cv::Point(0, shift)));
  const auto best = std::min_element(costs.begin() + 1, costs.end() - 1);
  const double vertex = 0.5 * (best[-1] - best[1]) / (best[-1] - 2 * best[0] + best[1]);
  return double(best - costs.begin()) - reach + vertex;
}

/// The real-valued view index at the panel's middle, of an eye that is off by `offset`, to the
/// right or downwards.
double viewIndex(double offset, double distance, double fov, int count) {
  return count * (0.5 + offset / distance / (2 * std::tan(radians(fov) / 2)));
}

bool isHere(const QString& name) {
  return QFileInfo::exists(data + name);
}

}  // namespace

class TestRealLightFields : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void jpegPleno();
  void shopStatesShowTheirViews_data();
  void shopStatesShowTheirViews();
  void shopParallax_data();
  void shopParallax();
  void quiltStatesShowTheirViews_data();
  void quiltStatesShowTheirViews();

 private:
  void loadShop();
  CameraState state(const Session& session, const QString& name) const;
  cv::Mat shopView(int row, int column) const;
  int shopNumber(const char* name) const;

  Session m_shop;
  ViewSource m_shopScene;
};

/// 10 bits, code values are fractions.
void TestRealLightFields::jpegPleno() {
  if (!isHere("jplm_small_greek_3x3")) QSKIP("no ../shared/data/jplm_small_greek_3x3 here");
  const QString folder = data + "jplm_small_greek_3x3";
  LightFieldParams params;
  params.file = folder.toStdString();
  params.layout = Layout::views;
  const LightField lightField = openLightField(params, {})->read({});
  QVERIFY(lightField.size() == (LightFieldSize{32, 32, 3, 3}));
  std::vector<cv::Mat> views;
  for (int k = 0; k < 9; ++k) {
    const QString file = QString("%1/00%2_00%3.ppm").arg(folder).arg(k / 3).arg(k % 3);
    views.push_back(cv::imread(file.toStdString(), cv::IMREAD_UNCHANGED));
    QCOMPARE(views.back().type(), CV_16UC3);
  }
  const auto expected = [&views](const TexelIndex& at) {
    const auto bgr = views[std::size_t(3 * at.v + at.u)].at<cv::Vec3w>(at.j, at.i);
    return 255.0 / 1023 * Rgb{double(bgr[2]), double(bgr[1]), double(bgr[0])};
  };
  QCOMPARE(firstWrong(lightField, expected, 1.0 / 257), QString());
}

/// Once, when the first test needs it.
void TestRealLightFields::loadShop() {
  if (m_shopScene.lightField) return;
  m_shop =
      loadSession(HOGELSCOPE_SOURCE_DIR "/tests/real/shop_13x13.json", {"camera.res=[540,360]"});
  m_shopScene = loadViewSource(m_shop, {});
}

CameraState TestRealLightFields::state(const Session& session, const QString& name) const {
  for (const CameraState& state : session.cameras)
    if (state.camera.name == name.toStdString()) return state;
  qFatal("the session has no state %s", qPrintable(name));
}

/// A picture of the 13×13, by the numbers in its name: 1, 3 … 25, from the bottom right.
cv::Mat TestRealLightFields::shopView(int row, int column) const {
  const QDir folder(data + "shop_13x13");
  const QStringList names =
      folder.entryList({QString::asprintf("Original Camera_%02d_%02d_*", row, column)});
  if (names.size() != 1) qFatal("not one picture for row %d, column %d", row, column);
  return real(cv::imread(folder.filePath(names[0]).toStdString(), cv::IMREAD_GRAYSCALE));
}

/// The number, in the file names, of the row or column that a state sees in the panel's middle.
int TestRealLightFields::shopNumber(const char* name) const {
  const Vec3 eye = state(m_shop, name).camera.eye;
  const double offset = eye.x == 0 ? -eye.y : eye.x;
  return 25 - 2 * int(viewIndex(offset, eye.z, m_shopScene.display.fov[0], 13));
}

void TestRealLightFields::shopStatesShowTheirViews_data() {
  QTest::addColumn<bool>("isAlongX");
  QTest::addColumn<bool>("lowNumbers");
  QTest::newRow("right") << true << true;
  QTest::newRow("left") << true << false;
  QTest::newRow("below") << false << true;
  QTest::newRow("above") << false << false;
}

/// What a state sees in the panel's middle is the picture taken from there, at its shear's place.
void TestRealLightFields::shopStatesShowTheirViews() {
  QFETCH(bool, isAlongX);
  QFETCH(bool, lowNumbers);
  if (!isHere("shop_13x13")) QSKIP("no ../shared/data/shop_13x13 here");
  loadShop();
  const char* name = QTest::currentDataTag();
  const cv::Mat picture = onPanel(m_shopScene, state(m_shop, name));
  const cv::Rect middle(440, 280, 80, 80);
  std::map<int, double> costs;
  for (int number = 1; number <= 25; number += 2) {
    const int shift = int(std::lround(5.6 * (6 - (number - 1) / 2)));
    costs[number] = isAlongX ? costOf(picture, shopView(13, number), middle, {shift, 0})
                             : costOf(picture, shopView(number, 13), middle, {0, shift});
  }
  int best = 1;
  double bestOfOtherSide = 1e300;
  for (const auto& [number, cost] : costs) {
    if (cost < costs[best]) best = number;
    if (number != 13 && (number < 13) != lowNumbers)
      bestOfOtherSide = std::min(bestOfOtherSide, cost);
  }
  QCOMPARE(best, shopNumber(name));
  QCOMPARE(best < 13, lowNumbers);
  QVERIFY2(costs[best] * 4 < bestOfOtherSide,
           qPrintable(QString("%1, %2").arg(costs[best]).arg(bestOfOtherSide)));
}

void TestRealLightFields::shopParallax_data() {
  QTest::addColumn<cv::Rect>("region");
  QTest::addColumn<double>("sign");
  QTest::newRow("behind the panel: the plants") << cv::Rect(280, 280, 120, 120) << 1.0;
  QTest::newRow("before the panel: the glasses") << cv::Rect(540, 360, 120, 100) << -1.0;
}

/// From the left to the right state and from the one below to the one above, by as much as between
/// the pictures themselves; what is behind the panel goes along with the eye.
void TestRealLightFields::shopParallax() {
  QFETCH(cv::Rect, region);
  QFETCH(double, sign);
  if (!isHere("shop_13x13")) QSKIP("no ../shared/data/shop_13x13 here");
  loadShop();
  const auto panel = [this](const char* name) { return onPanel(m_shopScene, state(m_shop, name)); };
  const int right = shopNumber("right");
  const int left = shopNumber("left");
  const CameraParams camera = state(m_shop, "right").camera;
  const double fov = m_shopScene.display.fov[0];
  const double views = viewIndex(camera.eye.x, camera.eye.z, fov, 13) -
                       viewIndex(-camera.eye.x, camera.eye.z, fov, 13);
  const double between = (left - right) / 2;
  const double perViewX =
      5.6 + bestShift(shopView(13, right), shopView(13, left), region, true) / between;
  const double perViewY =
      5.6 + bestShift(shopView(right, 13), shopView(left, 13), region, false) / between;
  const double x = bestShift(panel("right"), panel("left"), region, true);
  const double y = bestShift(panel("below"), panel("above"), region, false);
  QVERIFY2(std::abs(x - views * perViewX) < 1.5, qPrintable(QString::number(x)));
  QVERIFY2(std::abs(y - views * perViewY) < 1.5, qPrintable(QString::number(y)));
  QVERIFY2(x * sign > 3 && y * sign > 3, qPrintable(QString("%1, %2").arg(x).arg(y)));
}

void TestRealLightFields::quiltStatesShowTheirViews_data() {
  QTest::addColumn<bool>("isFirstHalf");
  QTest::newRow("left") << true;
  QTest::newRow("right") << false;
}

/// View 0 is the picture's bottom left tile and was taken from the left.
void TestRealLightFields::quiltStatesShowTheirViews() {
  QFETCH(bool, isFirstHalf);
  if (!isHere("quilt_kirurobo")) QSKIP("no ../shared/data/quilt_kirurobo here");
  const Session session = loadSession(HOGELSCOPE_SOURCE_DIR "/tests/real/quilt_kirurobo.json",
                                      {"camera.res=[400,200]"});
  const ViewSource scene = loadViewSource(session, {});
  const CameraState camera = state(session, QTest::currentDataTag());
  const cv::Mat picture = onPanel(scene, camera);
  const cv::Mat tiles = cv::imread(session.lightField.file, cv::IMREAD_GRAYSCALE);
  const cv::Rect middle(240, 32, 32, 192);
  std::vector<double> costs;
  for (int view = 0; view < 32; ++view) {
    const cv::Rect tile(512 * (view % 4), 256 * (7 - view / 4), 512, 256);
    costs.push_back(costOf(picture, real(tiles(tile)), middle));
  }
  const auto best = std::min_element(costs.begin(), costs.end());
  const auto otherHalf = isFirstHalf ? costs.begin() + 16 : costs.begin();
  const double expected =
      viewIndex(camera.camera.eye.x, camera.camera.eye.z, session.display.fov[0], 32);
  QCOMPARE(expected < 16, isFirstHalf);
  QVERIFY2(std::abs(double(best - costs.begin()) + 0.5 - expected) < 2.5,
           qPrintable(QString::number(best - costs.begin())));
  QVERIFY(*best * 3 < *std::min_element(otherHalf, otherHalf + 16));
}

QTEST_APPLESS_MAIN(TestRealLightFields)
#include "test_real_light_fields.moc"
