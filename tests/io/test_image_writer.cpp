// SPDX-License-Identifier: BSD-3-Clause
// Tests that OpenImageIO reads what the writers were given from the PNGs that libspng writes, and
// from the formats that it writes itself.
#include "io/images/image_writer.h"

#include <QTemporaryDir>
#include <QTest>
#include <random>

#include "core/base/error.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

template <class T>
std::vector<T> noise(int count) {
  std::mt19937 random(std::uint32_t(count) + sizeof(T));
  std::vector<T> values(std::size_t(count), T{});
  for (T& value : values) value = T(random());
  return values;
}

template <class T>
void writeByRows(const std::string& file, int width, const std::vector<T>& rgb, StoredType type) {
  const std::size_t row = 3 * std::size_t(width);
  ImageRowWriter writer(file, std::size_t(width), rgb.size() / row, type);
  for (std::size_t at = 0; at < rgb.size(); at += row) writer.write(&rgb[at]);
  writer.finish();
}

}  // namespace

class TestImageWriter : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QVERIFY(QDir::setCurrent(m_folder.path())); }
  void pictures_data();
  void pictures();
  void refusals();

 private:
  QTemporaryDir m_folder;
};

void TestImageWriter::pictures_data() {
  QTest::addColumn<int>("width");
  QTest::addColumn<int>("height");
  QTest::newRow("a pixel") << 1 << 1;
  QTest::newRow("a row") << 301 << 1;
  QTest::newRow("a column") << 1 << 207;
  QTest::newRow("odd") << 131 << 65;
  QTest::newRow("more rows than are written at once") << 64 << 129;
}

void TestImageWriter::pictures() {
  QFETCH(int, width);
  QFETCH(int, height);
  const auto rgb = noise<std::uint8_t>(3 * width * height);
  const auto deep = noise<std::uint16_t>(3 * width * height);
  for (const char* file : {"a.png", "a.PNG", "a.tif", "a.bmp"}) {
    writeImage(file, width, height, std::span<const std::uint8_t>(rgb));
    QCOMPARE(valuesOf<std::uint8_t>(file), rgb);
  }
  writeFile("memory.png", QByteArray::fromStdString(encodedPng(width, height, rgb)));
  QCOMPARE(valuesOf<std::uint8_t>("memory.png"), rgb);
  const std::span grey = std::span(rgb).first(std::size_t(width * height));
  writeMask("mask.png", width, height, grey);
  QCOMPARE(specOf("mask.png").channels, 1);
  QCOMPARE(valuesOf<std::uint8_t>("mask.png"), std::vector(grey.begin(), grey.end()));
  for (const char* file : {"rows.png", "rows.tif"}) {
    writeByRows(file, width, rgb, StoredType::uint8);
    QCOMPARE(valuesOf<std::uint8_t>(file), rgb);
    writeByRows(file, width, deep, StoredType::uint16);
    QCOMPARE(specOf(file).type, PictureType::UInt16);
    QCOMPARE(valuesOf<std::uint16_t>(file), deep);
  }
  // Code values 0 … 255, in steps of which 257 make a 16-bit one.
  std::vector<float> codes(deep.begin(), deep.end());
  for (float& code : codes) code /= 257;
  writeImage("codes.tif", width, height, std::span<const float>(codes));
  QCOMPARE(valuesOf<std::uint16_t>("codes.tif"), deep);
}

void TestImageWriter::refusals() {
  const auto errorOfRows = [](const char* file, std::size_t width, StoredType type) {
    return errorOf([&] { const ImageRowWriter writer(file, width, 1, type); });
  };
  QCOMPARE(errorOfRows("a.png", 1000001, StoredType::uint8),
           "a.png: cannot be written: PNG ends at 1000000 px; use TIFF");
  QCOMPARE(errorOfRows("a.jpg", 65501, StoredType::uint8),
           "a.jpg: cannot be written: JPEG ends at 65500 px; use PNG or TIFF");
  QCOMPARE(errorOfRows("a.png", 4, StoredType::real),
           "a.png: cannot be written: its format does not hold floats; use .exr or .tif");
  QCOMPARE(errorOfRows("a.bmp", 4, StoredType::uint16),
           "a.bmp: cannot be written: its format does not hold 16 bits; use .png or .tif");
  QCOMPARE(errorOfRows("a.xyz", 4, StoredType::uint8),
           "a.xyz: cannot be written: no picture format has the extension \".xyz\"");
  QCOMPARE(errorOfRows("none/a.png", 4, StoredType::uint8).left(10), "none/a.png");
  QVERIFY(!QFile::exists("a.jpg"));
}

QTEST_APPLESS_MAIN(TestImageWriter)
#include "test_image_writer.moc"
