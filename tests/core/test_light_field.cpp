// SPDX-License-Identifier: BSD-3-Clause
// Tests where the light field's texels lie, what their stored values mean, and how pixels round.
#include <QTest>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "core/light_field/light_field.h"
#include "core/optics/image.h"

using namespace hogelscope;

class TestLightField : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void texelsLieInTheHogelImagesRaster();
  void aHogelHasItsOwnPicture();
  void storedValues();
  void littleMemoryIsPadding();
  void neighboursAreSetTogether();
  void wrongCountIsRefused();
  void quantisedRoundsHalfUp_data();
  void quantisedRoundsHalfUp();
  void imageIsBlackAndUnseen();
};

void TestLightField::texelsLieInTheHogelImagesRaster() {
  const LightFieldSize size{3, 2, 5, 4};
  QCOMPARE(size.width(), std::size_t(15));
  QCOMPARE(size.height(), std::size_t(8));
  std::vector<std::uint16_t> values(3 * size.width() * size.height());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = static_cast<std::uint16_t>(257 * k);
  // 257 k overflows 16 bits from k = 256 on, so look at the first rows only.
  const LightField lightField(size, values);
  QVERIFY((lightField.size() == size));
  QVERIFY((lightField.texel({0, 0, 0, 0}) == Rgb{0, 1, 2}));
  QVERIFY((lightField.texel({0, 0, 1, 0}) == Rgb{3, 4, 5}));
  QVERIFY((lightField.texel({2, 0, 4, 0}) == Rgb{42, 43, 44}));
  QVERIFY((lightField.texel({1, 0, 2, 3}) == Rgb{156, 157, 158}));
  QVERIFY((lightField.texel({0, 1, 0, 0}) == Rgb{180, 181, 182}));
  QVERIFY((lightField.texel({1, 1, 3, 1}) == Rgb{249, 250, 251}));
}

void TestLightField::aHogelHasItsOwnPicture() {
  const LightFieldSize size{2, 3, 4, 2};
  std::vector<std::uint8_t> values(3 * size.width() * size.height());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = static_cast<std::uint8_t>(k);
  const Image picture = hogelTexels(LightField(size, values), 1, 2);
  QCOMPARE(picture.width, 4);
  QCOMPARE(picture.height, 2);
  for (std::size_t v = 0; v < 2; ++v)
    for (std::size_t k = 0; k < 12; ++k)  // its tile of the hogel image, 24 values a row
      QCOMPARE(picture.rgb[12 * v + k], static_cast<std::uint8_t>(24 * (4 + v) + 12 + k));
  QVERIFY(picture.seen == std::vector<std::uint8_t>(8, 255));
}

void TestLightField::storedValues() {
  const LightFieldSize one{1, 1, 1, 1};
  const TexelIndex at{0, 0, 0, 0};
  const LightField bytes(one, std::vector<std::uint8_t>{0, 100, 255});
  QVERIFY((bytes.texel(at) == Rgb{0, 100, 255}));
  const LightField words(one, std::vector<std::uint16_t>{128, 25700, 65535});
  QVERIFY((words.texel(at) == Rgb{128 / 257.0, 100, 255}));
  const LightField floats(one, std::vector<float>{0.5F, -0.25F, 2});
  QVERIFY((floats.texel(at) == Rgb{127.5, -63.75, 510}));
}

/// A light field takes little more memory than its texels, however many directions it has.
void TestLightField::littleMemoryIsPadding() {
  for (const int du : {2, 3, 5, 7, 8, 9, 11, 13, 15, 16, 17, 20, 31, 64, 100})
    for (const int dv : {1, 9, 13, 64}) {
      const LightFieldSize size{96, 64, du, dv};
      const double texels = double(size.width()) * double(size.height());
      const double bytes = double(LightField::bytes(size, StoredType::uint8));
      QVERIFY2(bytes <= 1.13 * 4 * texels + 4, qPrintable(QString("%1×%2").arg(du).arg(dv)));
    }
  QVERIFY(LightField::blockFor({512, 512, 64, 64}) == LightField::standardBlock);
}

/// As one after the other, wherever blocks begin; all others stay black.
void TestLightField::neighboursAreSetTogether() {
  const auto compare = [](auto zero) {
    using T = decltype(zero);
    const LightFieldSize size{21, 3, 3, 9};
    const auto type = std::is_same_v<T, std::uint8_t>    ? StoredType::uint8
                      : std::is_same_v<T, std::uint16_t> ? StoredType::uint16
                                                         : StoredType::real;
    std::vector<T> values(3 * 21);
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = T(k + 1);
    for (int first = 0; first < 21; ++first)
      for (int count = 0; first + count <= 21; ++count) {
        LightField together(size, type), single(size, type);
        together.setHogels({first, 1, 2, 8}, count, values.data());
        for (int k = 0; k < count; ++k)
          single.set<T>({first + k, 1, 2, 8}, &values[3 * std::size_t(k)]);
        for (int i = 0; i < 21; ++i)
          for (int v = 0; v < 9; ++v)
            QVERIFY(together.texel({i, 1, 2, v}) == single.texel({i, 1, 2, v}));
      }
  };
  compare(std::uint8_t{});
  compare(std::uint16_t{});
  compare(float{});
}

void TestLightField::wrongCountIsRefused() {
  const LightFieldSize size{1, 1, 2, 2};
  QVERIFY_THROWS_EXCEPTION(std::invalid_argument, LightField(size, std::vector<std::uint8_t>(11)));
  QVERIFY_THROWS_EXCEPTION(std::invalid_argument, LightField(size, std::vector<float>(13)));
}

void TestLightField::quantisedRoundsHalfUp_data() {
  QTest::addColumn<double>("value");
  QTest::addColumn<int>("pixel");
  QTest::newRow("whole") << 7.0 << 7;
  QTest::newRow("just below a half") << 7.4999999 << 7;
  QTest::newRow("half") << 7.5 << 8;
  QTest::newRow("even half") << 8.5 << 9;
  QTest::newRow("white, nearly") << 254.5 << 255;
  QTest::newRow("brighter than white") << 255.7 << 255;
  QTest::newRow("far too bright") << 1e300 << 255;
  QTest::newRow("below black") << -0.7 << 0;
  QTest::newRow("far below black") << -1e300 << 0;
  QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN() << 0;
}

void TestLightField::quantisedRoundsHalfUp() {
  QFETCH(const double, value);
  QFETCH(const int, pixel);
  QCOMPARE(int(quantised(value)), pixel);
}

void TestLightField::imageIsBlackAndUnseen() {
  const Image image(3, 2);
  QCOMPARE(image.pixelCount(), std::size_t(6));
  QVERIFY(image.rgb == std::vector<std::uint8_t>(18, 0));
  QVERIFY(image.seen == std::vector<std::uint8_t>(6, 0));
}

QTEST_APPLESS_MAIN(TestLightField)
#include "test_light_field.moc"
