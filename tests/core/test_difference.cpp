// SPDX-License-Identifier: BSD-3-Clause
// Tests difference images: their values and their gain.
#include "core/metrics/error_map.h"

#include <QTest>
#include <stdexcept>

using namespace hogelscope;

namespace {

/// Two pixels: the first differs in red by `difference`, only the second is seen.
std::array<Image, 2> pairOf(int difference) {
  std::array<Image, 2> images{Image(2, 1), Image(2, 1)};
  images[0].rgb = {255, 100, 7, 1, 2, 3};
  images[1].rgb = {std::uint8_t(255 - difference), 100, 7, 1, 2, 3};
  images[0].seen = {255, 255};
  images[1].seen = {0, 255};
  return images;
}

}  // namespace

class TestDifference : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void gain_data();
  void gain();
  void outliers();
  void bothSigns();
  void sizes();
  void deep();
};

void TestDifference::gain_data() {
  QTest::addColumn<int>("difference");
  QTest::addColumn<int>("gain");
  QTest::newRow("none") << 0 << 1;
  QTest::newRow("one step") << 1 << 128;
  QTest::newRow("two") << 2 << 64;
  QTest::newRow("just fits") << 127 << 2;
  QTest::newRow("just too large") << 128 << 1;
  QTest::newRow("largest") << 255 << 1;
}

void TestDifference::gain() {
  QFETCH(const int, difference);
  QFETCH(const int, gain);
  const auto [a, b] = pairOf(difference);
  const DifferenceImage result = differenceImage(a, b);
  QCOMPARE(result.gain, gain);
  QVERIFY((result.image.rgb ==
           std::vector<std::uint8_t>{std::uint8_t(gain * difference), 0, 0, 0, 0, 0}));
  QVERIFY((result.image.seen == std::vector<std::uint8_t>{0, 255}));
}

/// One value in a thousand may be cut off, two may not.
void TestDifference::outliers() {
  Image a(1000, 1);
  Image b(1000, 1);
  for (std::size_t k = 0; k < 1000; ++k) a.rgb[3 * k] = 10;
  a.rgb[0] = 200;
  QCOMPARE(differenceImage(a, b).gain, 16);
  QCOMPARE(differenceImage(a, b).image.rgb[0], std::uint8_t(255));
  QCOMPARE(differenceImage(a, b).image.rgb[3], std::uint8_t(160));
  a.rgb[3] = 200;
  QCOMPARE(differenceImage(a, b).gain, 1);
}

void TestDifference::bothSigns() {
  const auto [a, b] = pairOf(100);
  QVERIFY(differenceImage(a, b).image == differenceImage(b, a).image);
}

void TestDifference::sizes() {
  QVERIFY_EXCEPTION_THROWN(differenceImage(Image(2, 1), Image(1, 2)), std::invalid_argument);
}

/// A difference below one 8-bit step shows.
void TestDifference::deep() {
  Image a(2, 1, 10), b(2, 1, 10);
  a.deep = {500, 0, 0, 0, 0, 0};
  b.deep = {499, 0, 0, 0, 0, 1023};
  const DifferenceImage both = differenceImage(a, b);
  QCOMPARE(both.gain, 1);
  QCOMPARE(int(both.image.rgb[5]), 255);
  b.deep[5] = 0;
  const DifferenceImage one = differenceImage(a, b);
  QCOMPARE(one.gain, 1023 / 2 + 1);  // 512 · 255/1023 = 127.6
  QCOMPARE(int(one.image.rgb[0]), 128);
  QCOMPARE(differenceImage(a, a).gain, 1);
}

QTEST_APPLESS_MAIN(TestDifference)
#include "test_difference.moc"
