// SPDX-License-Identifier: BSD-3-Clause
// Tests what is said about the unstable places beside the lens.
#include <QTest>
#include <cmath>
#include <numbers>

#include "core/optics/simulate.h"
#include "study/instabilities.h"
#include "study/single_precision.h"

using namespace hogelscope;

namespace {

/// The rows of a kind and method, in order.
std::vector<InstabilityRow> rowsOf(const std::vector<InstabilityRow>& all, const std::string& kind,
                                   const std::string& name) {
  std::vector<InstabilityRow> rows;
  for (const InstabilityRow& row : all)
    if (row.kind == kind && row.method == name) rows.push_back(row);
  return rows;
}

}  // namespace

class TestInstabilities : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void psfGainInClosedForm();
  void anIdenticalViewRuinsTheMean();
  void doublesAreTheReference();
  void floatsFailFarFromTheOrigin();
  void theFastEngineHolds();

 private:
  std::vector<InstabilityRow> m_rows;
};

void TestInstabilities::initTestCase() {
  m_rows = viewErrors(serialRows, {});
}

void TestInstabilities::psfGainInClosedForm() {
  const std::vector<InstabilityRow> rows = psfGains();
  for (const InstabilityRow& row : rowsOf(rows, "psf_gain", "normalised"))
    QVERIFY(std::abs(row.value - 1) < 1e-12);
  int wide = 0;
  for (const InstabilityRow& row : rowsOf(rows, "psf_gain", "paper eq. 5")) {
    const double density = 1 / (2 * std::numbers::pi * row.x * row.x);
    if (*row.y == 1) QVERIFY(std::abs(row.value / density - 1) < 1e-12);
    if (*row.y < 10 * row.x) continue;
    ++wide;
    // Poisson's sum of all samples of a Gaussian density, along one axis.
    double axis = 1;
    for (int k = 1; k < 20; ++k)
      axis += 2 * std::exp(-2 * std::pow(std::numbers::pi * row.x * k, 2));
    QVERIFY(std::abs(row.value - axis * axis) < 1e-5);
  }
  QVERIFY(wide > 20);
}

void TestInstabilities::anIdenticalViewRuinsTheMean() {
  const std::vector<InstabilityRow> all = psnrMeans();
  const auto at = [&all](const char* name, int identical) {
    return rowsOf(all, "psnr_mean", name)[std::size_t(identical)].value;
  };
  QVERIFY(std::abs(at("mean of cv::PSNR", 0) - 35) < 0.001);
  QVERIFY(std::abs(at("mean of cv::PSNR", 1) - (5 * 35 + 361.2) / 6) < 0.01);  // 89.4 dB
  for (int identical = 0; identical < 6; ++identical) {
    QVERIFY(std::abs(at("mean of finite", identical) - 35) < 0.001);
    QVERIFY(std::abs(at("of mean MSE", identical) - 35 - 10 * std::log10(6.0 / (6 - identical))) <
            0.001);
  }
}

/// Else the rows of "float" would measure something else.
void TestInstabilities::doublesAreTheReference() {
  RenderJob job;
  job.display.hogels = {16, 12};
  job.display.directions = {9, 14};
  job.display.position = {0.3, -0.2, 5};
  auto field = std::make_shared<LightField>(LightFieldSize{16, 12, 9, 14}, StoredType::uint8);
  for (int k = 0; k < 16 * 12 * 9 * 14; ++k) {
    const std::array rgb{std::uint8_t(k >> 8), std::uint8_t(k), std::uint8_t(7)};
    field->set({k % 16, k / 16 % 12, k / 192 % 9, k / 1728}, rgb.data());
  }
  job.lightField = field;
  job.state.camera.eye = {0.4, -0.1, 5.5};
  job.state.camera.lookat = {0.3, -0.25, 5};
  job.state.camera.res = {61, 47};
  for (const HogelLensModel lens : {HogelLensModel::rectilinear, HogelLensModel::equiangular}) {
    job.display.lens = lens;
    const Image reference = simulate(job);
    QVERIFY(std::count(reference.seen.begin(), reference.seen.end(), 255) > 500);
    QVERIFY(pictureIn<double>(job) == reference);
  }
}

void TestInstabilities::floatsFailFarFromTheOrigin() {
  const auto at = [this](const char* kind, double metres) {
    for (const InstabilityRow& row : rowsOf(m_rows, kind, "float"))
      if (row.x == metres) return row.value;
    return double(NAN);
  };
  QVERIFY(at("scale", 1) < 1e-3);
  QVERIFY(at("scale", 1e-3) < 1e-3);
  QVERIFY(at("scale", 1e6) < 1e-3);  // rounding is relative
  QVERIFY(at("origin", 1) < 1e-3);
  QVERIFY(at("origin", 1e6) > 0.1);
  QVERIFY(at("near_panel", 0.1) < 1e-3);
  QVERIFY(at("near_panel", 1e-8) > 0.1);
}

void TestInstabilities::theFastEngineHolds() {
  int rows = 0;
  for (const char* kind : {"near_panel", "grazing", "scale", "origin"}) {
    for (const InstabilityRow& row : rowsOf(m_rows, kind, "fast engine")) {
      ++rows;
      QVERIFY(*row.points > 1000);
      QVERIFY2(row.value < 1e-3, qPrintable(QString("%1 %2").arg(kind).arg(row.x)));
    }
  }
  QCOMPARE(rows, 9 + 10 + 10 + 10);
}

QTEST_APPLESS_MAIN(TestInstabilities)
#include "test_instabilities.moc"
