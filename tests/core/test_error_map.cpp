// SPDX-License-Identifier: BSD-3-Clause
// Tests error maps, tones and histograms against their closed forms.
#include "core/metrics/error_map.h"

#include <QTest>
#include <cmath>

#include "core/base/colour_map.h"
#include "core/metrics/statistics.h"

using namespace hogelscope;

namespace {

using Rgb8 = std::array<std::uint8_t, 3>;
using Params = ErrorMap::Params;

Rgb8 mapped(const Params& params, const Rgb8& reference, const Rgb8& test) {
  Rgb8 result{};
  ErrorMap(params).write(reference, test, result);
  return result;
}

constexpr Rgb8 reference{100, 40, 0};
constexpr Rgb8 test{90, 60, 3};

}  // namespace

class TestErrorMap : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void channels();
  void limits();
  void gamma();
  void luma();
  void falseColours_data();
  void falseColours();
  void theScaleTellsTheError_data();
  void theScaleTellsTheError();
  void tones();
  void histogram();
};

void TestErrorMap::channels() {
  const auto with = [](ErrorKind kind, double gain) {
    return mapped({kind, {gain, 1}}, reference, test);
  };
  QVERIFY((with(ErrorKind::absolute, 1) == Rgb8{10, 20, 3}));
  QVERIFY((with(ErrorKind::absolute, 8) == Rgb8{80, 160, 24}));
  // 127.5 (1 + gain (t - r) / 255), rounded half up
  QVERIFY((with(ErrorKind::signedError, 1) == Rgb8{123, 138, 129}));
  QVERIFY((with(ErrorKind::signedError, 4) == Rgb8{108, 168, 134}));
  // (gain d)² / 255
  QVERIFY((with(ErrorKind::squared, 1) == Rgb8{0, 2, 0}));
  QVERIFY((with(ErrorKind::squared, 8) == Rgb8{25, 100, 2}));
  // 255 gain d / max(r, 1)
  QVERIFY((with(ErrorKind::relative, 1) == Rgb8{26, 128, 255}));
  QVERIFY((with(ErrorKind::relative, 0.25) == Rgb8{6, 32, 191}));
}

void TestErrorMap::limits() {
  const Rgb8 black{0, 0, 0};
  const Rgb8 white{255, 255, 255};
  for (const auto kind : {ErrorKind::absolute, ErrorKind::signedError, ErrorKind::squared,
                          ErrorKind::relative, ErrorKind::luma}) {
    for (const double gain : {1.0, 128.0}) {
      const std::uint8_t none = kind == ErrorKind::signedError ? 128 : 0;
      QCOMPARE(int(mapped({kind, {gain, 1}}, white, white)[1]), int(none));
      QCOMPARE(int(mapped({kind, {gain, 1}}, black, white)[1]), 255);
      const int below = kind == ErrorKind::signedError ? 0 : 255;
      QCOMPARE(int(mapped({kind, {gain, 1}}, white, black)[1]), below);
    }
  }
}

void TestErrorMap::gamma() {
  const int root = int(std::floor(255 * std::sqrt(8 * 20 / 255.0) + 0.5));
  QCOMPARE(int(mapped({ErrorKind::absolute, {8, 2}}, reference, test)[1]), root);
  const int below = int(std::floor(127.5 * (1 - std::sqrt(8 * 10 / 255.0)) + 0.5));
  QCOMPARE(int(mapped({ErrorKind::signedError, {8, 2}}, reference, test)[0]), below);
}

void TestErrorMap::luma() {
  const double y = -0.2126 * 10 + 0.7152 * 20 + 0.0722 * 3;
  QVERIFY(std::abs(pixelError(ErrorKind::luma, reference, test) - y) < 1e-12);
  const Rgb8 shown = mapped({ErrorKind::luma, {8, 1}}, reference, test);
  QVERIFY(shown[0] == shown[1] && shown[1] == shown[2]);
  QCOMPARE(int(shown[0]), int(std::floor(8 * y + 0.5)));
}

void TestErrorMap::falseColours_data() {
  QTest::addColumn<int>("kind");
  QTest::addColumn<double>("share");
  QTest::newRow("absolute") << int(ErrorKind::absolute) << 4 * 11 / 255.0;
  QTest::newRow("signed") << int(ErrorKind::signedError) << 0.5 + 0.5 * 4 * (13 / 3.0) / 255;
  QTest::newRow("squared") << int(ErrorKind::squared) << 16 * (509 / 3.0) / (255 * 255);
  QTest::newRow("relative") << int(ErrorKind::relative) << 1.0;
  QTest::newRow("luma") << int(ErrorKind::luma) << 4 * (14.304 + 0.2166 - 2.126) / 255;
}

/// Of the mean of the channels' errors: 10, 20, 3; -10, 20, 3; 100, 400, 9; 10, 50, 300 %.
void TestErrorMap::falseColours() {
  QFETCH(const int, kind);
  QFETCH(const double, share);
  const Rgb8 expected = falseColour(std::floor(255 * share + 0.5) / 255);
  QVERIFY(mapped({ErrorKind(kind), {4, 1}, true}, reference, test) == expected);
}

void TestErrorMap::theScaleTellsTheError_data() {
  falseColours_data();
}

void TestErrorMap::theScaleTellsTheError() {
  QFETCH(const int, kind);
  for (const double gamma : {1.0, 2.2}) {
    const ErrorMap map({ErrorKind(kind), {4, gamma}, true});
    const double top = map.errorAt(1);
    for (const double place : {0.0, 0.125, 0.5, 0.9, 1.0})
      QVERIFY(std::abs(map.placeOf(map.errorAt(place)) - place) < 1e-12);
    const double expected = ErrorKind(kind) == ErrorKind::relative  ? 25
                            : ErrorKind(kind) == ErrorKind::squared ? 63.75 * 63.75
                                                                    : 63.75;
    QVERIFY(std::abs(top - expected) < 1e-9);
    QCOMPARE(map.errorAt(0), ErrorKind(kind) == ErrorKind::signedError ? -top : 0.0);
    QVERIFY(map.colourAt(1) == falseColour(1) && map.colourAt(0) == falseColour(0));
    // A grey pair whose error is known, looked up on the scale.
    const std::array<std::uint8_t, 3> dark{100, 100, 100};
    const std::array<std::uint8_t, 3> light{110, 110, 110};
    const Rgb8 shown = mapped({ErrorKind(kind), {4, gamma}, true}, dark, light);
    const double error = errorOf(ErrorKind(kind), 100, 110);
    double nearest = 1e9;
    for (int k = 0; k <= 255; ++k)
      if (map.colourAt(k / 255.0) == shown)
        nearest = std::min(nearest, std::abs(map.errorAt(k / 255.0) - error));
    QVERIFY2(nearest < 0.02 * expected, qPrintable(QString::number(nearest)));
  }
}

void TestErrorMap::tones() {
  const auto plain = toneTable({});
  const auto bright = toneTable({4, 1});
  const auto curved = toneTable({1, 2});
  for (int k = 0; k < 256; ++k) {
    QCOMPARE(int(plain[std::size_t(k)]), k);
    QCOMPARE(int(bright[std::size_t(k)]), std::min(4 * k, 255));
    QCOMPARE(int(curved[std::size_t(k)]), int(std::floor(std::sqrt(255.0 * k) + 0.5)));
  }
}

void TestErrorMap::histogram() {
  Image image(4, 1);
  image.rgb = {255, 255, 255, 0, 255, 0, 0, 0, 0, 0, 255, 0};
  image.seen = {255, 255, 0, 255};
  Histogram expected{};
  expected[255] = 1;
  expected[182] = 2;  // 0.7152 · 255 = 182.4
  QVERIFY(lumaHistogram(image) == expected);
}

QTEST_MAIN(TestErrorMap)
#include "test_error_map.moc"
