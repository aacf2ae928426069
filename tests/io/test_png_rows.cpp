// SPDX-License-Identifier: BSD-3-Clause
// Tests PNGs of every kind, written here byte by byte, against what the PNG specification makes of
// these bytes, and conversions between depths against libpng behind OpenImageIO.
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

#include "io/images/image_file.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

constexpr int width = 13;
constexpr int height = 11;

struct Kind {
  int colourType = 2;
  int bitDepth = 8;
  bool isInterlaced = false;
  bool hasTransparency = false;

  [[nodiscard]] int samples() const {
    return colourType == 2 ? 3 : colourType == 4 ? 2 : colourType == 6 ? 4 : 1;
  }
};

std::uint32_t crcOf(const QByteArray& bytes) {
  std::uint32_t crc = ~0U;
  for (const char byte : bytes) {
    crc ^= std::uint8_t(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

QByteArray bigEndian(std::uint32_t value) {
  const auto swapped = qToBigEndian(value);
  return {reinterpret_cast<const char*>(&swapped), 4};
}

QByteArray chunk(const QByteArray& type, const QByteArray& content) {
  return bigEndian(std::uint32_t(content.size())) + type + content +
         bigEndian(crcOf(type + content));
}

/// Any value of the depth; a palette has 16 colours. One pixel is of the colour that tRNS names.
unsigned sampleAt(const Kind& kind, int x, int y, int c) {
  if (x == 5 && y == 5) return unsigned(c) + 1;
  const unsigned value = unsigned(x * 7919 + y * 104729 + c * 1299709) * 2654435761U >> 8U;
  const unsigned depth = kind.colourType == 3 && kind.bitDepth == 8 ? 4U : unsigned(kind.bitDepth);
  return value & ((1U << depth) - 1U);
}

/// Red, green, blue (or grey) and alpha of a pixel in the file's range, 255 or 65535: PNG 1.2,
/// sections 4.1 and 12.2. Values of less than 8 bits are spread over the whole range.
std::vector<unsigned> pixelAt(const Kind& kind, int x, int y) {
  std::vector<unsigned> stored;
  for (int c = 0; c < kind.samples(); ++c) stored.push_back(sampleAt(kind, x, y, c));
  if (kind.colourType == 3) {
    const unsigned index = stored[0];
    constexpr unsigned alphas[] = {0, 0x40, 0x80};
    return {index * 15, index * 15 + 5, index * 15 + 10,
            kind.hasTransparency && index < 3 ? alphas[index] : 255U};
  }
  const unsigned most = kind.bitDepth == 16 ? 65535 : 255;
  if (kind.colourType < 3) {
    const bool isClear = stored == (kind.colourType == 0 ? std::vector<unsigned>{1}
                                                         : std::vector<unsigned>{1, 2, 3});
    stored.push_back(kind.hasTransparency && isClear ? 0 : most);
    for (std::size_t c = 0; c + 1 < stored.size(); ++c)
      stored[c] *= kind.bitDepth < 8 ? most / ((1U << unsigned(kind.bitDepth)) - 1U) : 1;
  }
  return stored;
}

/// RGB rows: grey is all three; light over black, so stored values times alpha, rounded down.
template <class T>
std::vector<T> overBlack(const Kind& kind) {
  std::vector<T> rgb;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::vector<unsigned> pixel = pixelAt(kind, x, y);
      for (std::size_t c = 0; c < 3; ++c)
        rgb.push_back(
            T(pixel[pixel.size() < 4 ? 0 : c] * pixel.back() / std::numeric_limits<T>::max()));
    }
  return rgb;
}

/// The pixels from (x0, y0) on, every dx-th and dy-th, as rows without a filter.
QByteArray rowsOf(const Kind& kind, int x0, int y0, int dx, int dy) {
  QByteArray rows;
  for (int y = y0; y < height && x0 < width; y += dy) {
    rows += '\0';
    unsigned bits = 0;
    int count = 0;
    for (int x = x0; x < width; x += dx)
      for (int c = 0; c < kind.samples(); ++c) {
        bits = bits << unsigned(kind.bitDepth) | sampleAt(kind, x, y, c);
        count += kind.bitDepth;
        for (; count >= 8; count -= 8) rows += char(bits >> unsigned(count - 8));
      }
    if (count > 0) rows += char(bits << unsigned(8 - count));
  }
  return rows;
}

QByteArray adam7(const Kind& kind) {
  return rowsOf(kind, 0, 0, 8, 8) + rowsOf(kind, 4, 0, 8, 8) + rowsOf(kind, 0, 4, 4, 8) +
         rowsOf(kind, 2, 0, 4, 4) + rowsOf(kind, 0, 2, 2, 4) + rowsOf(kind, 1, 0, 2, 2) +
         rowsOf(kind, 0, 1, 1, 2);
}

QByteArray pngOf(const Kind& kind, int w = width, int h = height) {
  QByteArray png("\x89PNG\r\n\x1a\n", 8);
  png += chunk("IHDR", bigEndian(std::uint32_t(w)) + bigEndian(std::uint32_t(h)) +
                           char(kind.bitDepth) + char(kind.colourType) + '\0' + '\0' +
                           char(kind.isInterlaced ? 1 : 0));
  QByteArray palette;
  const int colours = std::min(16, 1 << kind.bitDepth);
  for (int k = 0; k < 3 * colours; ++k) palette += char(k * 5);
  if (kind.colourType == 3) png += chunk("PLTE", palette);
  if (kind.hasTransparency)
    png += chunk("tRNS", kind.colourType == 3   ? QByteArray("\x00\x40\x80", std::min(3, colours))
                         : kind.colourType == 0 ? QByteArray("\0\1", 2)
                                                : QByteArray("\0\1\0\2\0\3", 6));
  const QByteArray rows = kind.isInterlaced ? adam7(kind) : rowsOf(kind, 0, 0, 1, 1);
  return png + chunk("IDAT", qCompress(rows).mid(4)) + chunk("IEND", {});
}

template <class T>
std::vector<T> readAll(const QString& file, StoredType type) {
  ImageFile image(file.toStdString());
  std::vector<T> values;
  image.read(type,
             [&](std::size_t, std::size_t rows, const StoredRows& rgb) {
               const T* first = std::get<const T*>(rgb);
               values.insert(values.end(), first, first + 3 * rows * image.width());
             },
             {});
  return values;
}

/// Up to rounding: it multiplies by 1/255.
void compareReal(const QString& file) {
  const std::vector<float> ours = readAll<float>(file, StoredType::real);
  const std::vector<float> theirs = valuesOf<float>(file);
  QCOMPARE(ours.size(), theirs.size());
  for (std::size_t k = 0; k < ours.size(); ++k)
    QVERIFY(std::abs(ours[k] - theirs[k]) <= 1.2e-7F * theirs[k]);
}

}  // namespace

class TestPngRows : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QVERIFY(QDir::setCurrent(m_folder.path())); }
  void kinds_data();
  void kinds();
  void otherTypes();
  void hostileSizes_data();
  void hostileSizes();

 private:
  QTemporaryDir m_folder;
};

void TestPngRows::kinds_data() {
  QTest::addColumn<Kind>("kind");
  const std::map<int, std::vector<int>> depths{
      {0, {1, 2, 4, 8, 16}}, {2, {8, 16}}, {3, {1, 2, 4, 8}}, {4, {8, 16}}, {6, {8, 16}}};
  for (const auto& [colourType, bits] : depths)
    for (const int depth : bits)
      for (const bool interlaced : {false, true})
        for (const bool transparency : {false, true}) {
          if (transparency && colourType > 3) continue;
          QTest::addRow("type %d, %d bit%s%s", colourType, depth, interlaced ? ", interlaced" : "",
                        transparency ? ", tRNS" : "")
              << Kind{colourType, depth, interlaced, transparency};
        }
}

void TestPngRows::kinds() {
  QFETCH(Kind, kind);
  writeFile("a.png", pngOf(kind));
  const ImageFile image(std::filesystem::path("a.png"));
  QCOMPARE(image.channels(), (kind.colourType == 0 || kind.colourType == 4 ? 1 : 3) +
                                 (kind.colourType > 3 || kind.hasTransparency ? 1 : 0));
  QCOMPARE(image.width(), std::size_t(width));
  QCOMPARE(image.height(), std::size_t(height));
  QCOMPARE(image.type(), kind.bitDepth == 16 ? StoredType::uint16 : StoredType::uint8);
  if (kind.bitDepth == 16)
    QCOMPARE(readAll<std::uint16_t>("a.png", StoredType::uint16), overBlack<std::uint16_t>(kind));
  else
    QCOMPARE(readAll<std::uint8_t>("a.png", StoredType::uint8), overBlack<std::uint8_t>(kind));
}

/// A folder of views may hold pictures of another type than the first one's.
void TestPngRows::otherTypes() {
  writeFile("a.png", pngOf({2, 8}));
  QCOMPARE(readAll<std::uint16_t>("a.png", StoredType::uint16), valuesOf<std::uint16_t>("a.png"));
  compareReal("a.png");
  writeFile("b.png", pngOf({2, 16}));
  QCOMPARE(readAll<std::uint8_t>("b.png", StoredType::uint8), valuesOf<std::uint8_t>("b.png"));
  compareReal("b.png");
}

void TestPngRows::hostileSizes_data() {
  QTest::addColumn<Kind>("kind");
  QTest::newRow("rows") << Kind{};
  QTest::newRow("interlaced") << Kind{6, 16, true};
}

/// Refused before anything of that size is allocated.
void TestPngRows::hostileSizes() {
  QFETCH(Kind, kind);
  writeFile("a.png", pngOf(kind, 1000000, 1000000));
  QCOMPARE(errorOf([] { ImageFile(std::filesystem::path("a.png")); }),
           "a.png: is damaged: it is too short for 1000000×1000000 px");
}

QTEST_APPLESS_MAIN(TestPngRows)
#include "test_png_rows.moc"
