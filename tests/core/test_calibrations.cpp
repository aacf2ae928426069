// SPDX-License-Identifier: BSD-3-Clause
// Tests the lens's inverse on real calibrations, over their whole images.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "core/optics/distortion.h"
#include "tests/core/lens_oracle.h"

using namespace hogelscope;

namespace {

constexpr auto file = HOGELSCOPE_SOURCE_DIR "/../shared/data/calibrations.json";

struct Calibration {
  std::array<int, 2> size;
  double fx, fy, cx, cy;
  std::array<double, 5> d;  ///< OpenCV's order

  [[nodiscard]] Vec2 normalised(const Vec2& pixel) const {
    return {(pixel.x - cx) / fx, (pixel.y - cy) / fy};
  }
  [[nodiscard]] LensOracle oracle() const { return {d[0], d[1], d[2], d[3], d[4]}; }
  [[nodiscard]] Distortion lens() const { return Distortion({d[0], d[1], d[2], d[3], d[4]}); }
  /// How far an ideal point's place in the image is from q's, in pixels.
  [[nodiscard]] double residual(const Vec2& ideal, const Vec2& q) const {
    const LensOracle::Point p = oracle().distort({ideal.x, ideal.y});
    return std::hypot(fx * (p.real() - q.x), fy * (p.imag() - q.y));
  }
};

Calibration calibration(const QJsonObject& json) {
  const QJsonArray size = json["size"].toArray();
  const QJsonArray k = json["K"].toArray();
  const QJsonArray d = json["D"].toArray();
  Calibration c{{size[0].toInt(), size[1].toInt()},
                k[0].toDouble(),
                k[1].toDouble(),
                k[2].toDouble(),
                k[3].toDouble(),
                {}};
  for (int index = 0; index < 5; ++index) c.d[std::size_t(index)] = d[index].toDouble();
  return c;
}

/// Pixels of a 33×25 grid, corners included.
std::vector<Vec2> grid(const Calibration& c) {
  std::vector<Vec2> pixels;
  for (int row = 0; row < 25; ++row)
    for (int column = 0; column < 33; ++column)
      pixels.push_back({column * (c.size[0] - 1) / 32.0, row * (c.size[1] - 1) / 24.0});
  return pixels;
}

Vec2 openCvUndistorts(const Calibration& c, const Vec2& q) {
  std::vector<cv::Point2d> ideal;
  const std::vector distorted{cv::Point2d(q.x, q.y)};
  cv::undistortPoints(distorted, ideal, cv::Matx33d::eye(), cv::Vec<double, 5>(c.d.data()),
                      cv::noArray(), cv::noArray(),
                      cv::TermCriteria(cv::TermCriteria::COUNT, 200, 0));
  return {ideal[0].x, ideal[0].y};
}

/// Is det J above 0 all the way from the centre to `p`?
bool inValidRegion(const Calibration& c, const Vec2& p) {
  for (int k = 0; k <= 200; ++k)
    if (!(c.oracle().det({k / 200.0 * p.x, k / 200.0 * p.y}) > 0)) return false;
  return true;
}

}  // namespace

class TestCalibrations : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void inverse_data();
  void inverse();
  void agreesWithOpenCvWhereThatConverges_data() { inverse_data(); }
  void agreesWithOpenCvWhereThatConverges();

 private:
  QList<Calibration> m_calibrations;
  QStringList m_names;
};

void TestCalibrations::initTestCase() {
  QFile document(file);
  if (!document.open(QIODevice::ReadOnly)) QSKIP(qPrintable(QString("no file ") + file));
  const QJsonArray cameras = QJsonDocument::fromJson(document.readAll())["cameras"].toArray();
  for (const QJsonValue camera : cameras) {
    m_calibrations << calibration(camera.toObject());
    m_names << camera["name"].toString();
  }
  QVERIFY(m_calibrations.size() >= 5);
}

void TestCalibrations::inverse_data() {
  QTest::addColumn<int>("index");
  for (int index = 0; index < m_names.size(); ++index)
    QTest::newRow(qPrintable(m_names[index])) << index;
}

void TestCalibrations::inverse() {
  QFETCH(const int, index);
  const Calibration& c = m_calibrations[index];
  int rays = 0;
  for (const Vec2& pixel : grid(c)) {
    const Vec2 q = c.normalised(pixel);
    const auto ideal = c.lens().undistort(q);
    const auto walk = c.oracle().walk({q.x, q.y});
    if (walk.end == LensOracle::Walk::End::unclear) continue;
    QCOMPARE(ideal.has_value(), walk.end == LensOracle::Walk::End::ray);
    if (!ideal) continue;
    ++rays;
    QVERIFY(c.residual(*ideal, q) < 1e-9);
    QVERIFY(std::abs(LensOracle::Point(ideal->x, ideal->y) - walk.point) < 1e-6);
  }
  QVERIFY(rays > 33 * 25 / 2);
}

void TestCalibrations::agreesWithOpenCvWhereThatConverges() {
  QFETCH(const int, index);
  const Calibration& c = m_calibrations[index];
  int compared = 0;
  for (const Vec2& pixel : grid(c)) {
    const Vec2 q = c.normalised(pixel);
    const Vec2 theirs = openCvUndistorts(c, q);
    if (!(c.residual(theirs, q) < 1e-9) || !inValidRegion(c, theirs)) continue;
    ++compared;
    const auto ours = c.lens().undistort(q);
    QVERIFY(ours);
    QVERIFY(std::hypot(ours->x - theirs.x, ours->y - theirs.y) < 1e-9);
  }
  QVERIFY(compared > 33 * 25 / 2);
}

QTEST_APPLESS_MAIN(TestCalibrations)
#include "test_calibrations.moc"
