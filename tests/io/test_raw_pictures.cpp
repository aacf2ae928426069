// SPDX-License-Identifier: BSD-3-Clause
// Tests PGX and raw YUV against plain loops, and YUV against OpenCV's conversions.
#include <QTemporaryDir>
#include <QTest>
#include <opencv2/imgproc.hpp>

#include "core/base/random_numbers.h"
#include "io/documents/session_file.h"
#include "io/images/image_file.h"
#include "io/scene/view_source.h"
#include "tests/io/documents.h"
#include "tests/io/texels.h"

using namespace hogelscope;

namespace {

/// The values of a picture, three for a pixel, of 8 or 16 bits.
std::vector<int> valuesIn(const QString& file, const YuvParams& yuv = {}) {
  ImageFile image(file.toStdString(), yuv);
  std::vector<int> values;
  image.read(image.type(),
             [&](std::size_t, std::size_t rows, const StoredRows& stored) {
               std::visit(
                   [&](const auto* rgb) {
                     for (std::size_t k = 0; k < 3 * rows * image.width(); ++k)
                       values.push_back(int(rgb[k]));
                   },
                   stored);
             },
             {});
  return values;
}

/// A PGX of these samples, which may be negative.
QByteArray pgx(const QByteArray& header, int bits, const std::vector<int>& samples) {
  QByteArray bytes = header;
  for (const int sample : samples) {
    const auto low = char(sample & 255);
    const auto high = char((sample >> 8) & 255);
    if (bits <= 8)
      bytes += low;
    else if (header.startsWith("PG ML"))
      bytes += QByteArray() + high + low;
    else
      bytes += QByteArray() + low + high;
  }
  return bytes;
}

constexpr int width = 5;
constexpr int height = 4;

/// Of component c of view (row, column), 10 bits.
int sampleAt(int row, int column, int x, int y, int c) {
  return (row * 301 + column * 97 + x * 13 + y * 41 + c * 500) % 1024;
}

QByteArray component(int row, int column, int c) {
  std::vector<int> samples;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) samples.push_back(sampleAt(row, column, x, y, c));
  return pgx("PG ML +10 5 4\n", 10, samples);
}

/// As stored: 10 bits over 16.
double codeValue(int sample) {
  return std::floor(sample * 65535.0 / 1023 + 0.5) / 257;
}

std::vector<int> noise(std::size_t count, int bits, std::uint64_t seed) {
  std::vector<int> values(count);
  RandomNumbers random(seed);
  for (int& value : values) value = int(random.unit() * (1 << bits));
  return values;
}

void writeYuv(const QString& file, const std::vector<int>& samples, int bits) {
  writeFile(file, pgx("", bits, samples));  // the low byte first
}

/// The coefficients as tables print them: Y, Cr to R, Cb and Cr to G, Cb to B, of 8 bits.
struct Printed {
  double y;
  double crToR;
  double cbToG;
  double crToG;
  double cbToB;
  int black;
};

Printed printed(const YuvParams& p) {
  if (p.matrix == YuvMatrix::bt601)
    return p.range == YuvRange::limited
               ? Printed{1.164384, 1.596027, 0.391762, 0.812968, 2.017232, 16}
               : Printed{1, 1.402, 0.344136, 0.714136, 1.772, 0};
  return p.range == YuvRange::limited
             ? Printed{1.164384, 1.792741, 0.213249, 0.532909, 2.112402, 16}
             : Printed{1, 1.5748, 0.187324, 0.468124, 1.8556, 0};
}

/// The loop that anybody would write.
std::vector<int> bruteForce(const std::vector<int>& samples, const YuvParams& p) {
  const Printed k = printed(p);
  const int w = p.size[0];
  const int h = p.size[1];
  const bool isHalf = p.sampling == YuvSampling::s420;
  const int chromaWidth = isHalf ? (w + 1) / 2 : w;
  const int chromaHeight = isHalf ? (h + 1) / 2 : h;
  const int scale = 1 << (p.bits - 8);
  const int most = (1 << p.bits) - 1;
  std::vector<int> rgb;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const int at = isHalf ? y / 2 * chromaWidth + x / 2 : y * w + x;
      const double luma = k.y * (samples[std::size_t(y * w + x)] - k.black * scale);
      const double cb = samples[std::size_t(w * h + at)] - 128.0 * scale;
      const double cr =
          samples[std::size_t(w * h + chromaWidth * chromaHeight + at)] - 128.0 * scale;
      for (const double value :
           {luma + k.crToR * cr, luma - k.cbToG * cb - k.crToG * cr, luma + k.cbToB * cb}) {
        // Of limited range 10 bits have the peak 4·255, not 1023.
        const double whole = p.range == YuvRange::limited ? value * most / (255.0 * scale) : value;
        const int rounded = std::clamp(int(std::floor(whole + 0.5)), 0, most);
        rgb.push_back(p.bits == 8 ? rounded : int(std::floor(rounded * 65535.0 / 1023 + 0.5)));
      }
    }
  return rgb;
}

/// The largest difference, and how many values differ.
std::pair<int, int> differences(const std::vector<int>& a, const std::vector<int>& b) {
  if (a.size() != b.size()) return {INT_MAX, INT_MAX};
  int largest = 0;
  int count = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max(largest, std::abs(a[k] - b[k]));
    count += a[k] != b[k] ? 1 : 0;
  }
  return {largest, count};
}

std::vector<int> valuesOf(const cv::Mat3b& picture) {
  std::vector<int> values;
  for (const cv::Vec3b& pixel : picture)
    for (int c = 0; c < 3; ++c) values.push_back(pixel[c]);
  return values;
}

}  // namespace

class TestRawPictures : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QVERIFY(QDir::setCurrent(m_folder.path())); }
  void pgxPictures_data();
  void pgxPictures();
  void pgxAsHogels();
  void pgxComponents_data();
  void pgxComponents();
  void yuvIsWhatALoopSays_data();
  void yuvIsWhatALoopSays();
  void yuvIsWhatOpenCvSays();
  void yuvViews();

 private:
  QTemporaryDir m_folder;
};

void TestRawPictures::pgxPictures_data() {
  QTest::addColumn<QByteArray>("header");
  QTest::addColumn<int>("bits");
  QTest::addColumn<bool>("isSigned");
  QTest::newRow("JPEG Pleno") << QByteArray("PG ML +10 5 4\n") << 10 << false;
  QTest::newRow("little endian") << QByteArray("PG LM +10 5 4\n") << 10 << false;
  QTest::newRow("without sign") << QByteArray("PG ML 8 5 4\n") << 8 << false;
  QTest::newRow("a space behind the sign") << QByteArray("PG ML - 12 5 4\n") << 12 << true;
  QTest::newRow("signed, little endian") << QByteArray("PG LM -12 5 4\r\n") << 12 << true;
  QTest::newRow("signed bytes") << QByteArray("PG ML -8 5 4\n") << 8 << true;
  QTest::newRow("few bits") << QByteArray("PG\tML\t+3 5 4 \n") << 3 << false;
  QTest::newRow("one bit") << QByteArray("PG ML +1 5 4\n") << 1 << false;
  QTest::newRow("16 bits") << QByteArray("PG ML +16 5 4\n") << 16 << false;
  QTest::newRow("signed 16 bits") << QByteArray("PG LM -16 5 4\n") << 16 << true;
}

/// The name is not needed. The first byte of the samples may be that of a line's end.
void TestRawPictures::pgxPictures() {
  QFETCH(QByteArray, header);
  QFETCH(int, bits);
  QFETCH(bool, isSigned);
  std::vector<int> samples = noise(width * height, bits, 1);
  samples[0] = 0;
  samples[1] = (1 << bits) - 1;
  if (bits > 3) samples[2] = 10;
  const double full = bits > 8 ? 65535 : 255;
  std::vector<int> expected;
  for (const int sample : samples)
    expected.insert(expected.end(), 3, int(std::floor(sample * full / ((1 << bits) - 1) + 0.5)));
  for (int& sample : samples) sample -= isSigned ? 1 << (bits - 1) : 0;
  writeFile("a.picture", pgx(header, bits, samples));
  const ImageFile image(std::filesystem::path("a.picture"));
  QCOMPARE(image.format(), std::string("pgx"));
  QCOMPARE(image.width(), std::size_t(width));
  QCOMPARE(image.height(), std::size_t(height));
  QCOMPARE(image.channels(), 1);
  QCOMPARE(image.bits(), std::max(bits, 8));
  QCOMPARE(image.type(), bits > 8 ? StoredType::uint16 : StoredType::uint8);
  QCOMPARE(valuesIn("a.picture"), expected);
}

void TestRawPictures::pgxAsHogels() {
  writeFile("hogels.pgx", component(0, 0, 0));
  LightFieldParams params;
  params.file = "hogels.pgx";
  PanelParams display;
  display.hogels = {5, 2};
  display.directions = {1, 2};
  const auto file = openLightField(params, display);
  QCOMPARE(file->bits(), 10);
  const auto grey = [](const TexelIndex& at) {
    const double value = codeValue(sampleAt(0, 0, at.i, 2 * at.j + at.v, 0));
    return Rgb{value, value, value};
  };
  QCOMPARE(firstWrong(file->read({}), grey), QString());
}

void TestRawPictures::pgxComponents_data() {
  QTest::addColumn<QString>("folder");
  QTest::newRow("the light field's folder") << "field";
  QTest::newRow("the first component's") << "field/0";
}

/// As JPEG Pleno's reference software writes them.
void TestRawPictures::pgxComponents() {
  QFETCH(QString, folder);
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column)
      for (int c = 0; c < 3; ++c)
        writeFile(QString("field/%1/00%2_00%3.pgx").arg(c).arg(row).arg(column),
                  component(row, column, c));
  LightFieldParams params;
  params.file = folder.toStdString();
  params.layout = Layout::views;
  const auto file = openLightField(params, {});
  QCOMPARE(file->bits(), 10);
  const auto colour = [](const TexelIndex& at) {
    const auto value = [&](int c) { return codeValue(sampleAt(at.v, at.u, at.i, at.j, c)); };
    return Rgb{value(0), value(1), value(2)};
  };
  QCOMPARE(firstWrong(file->read({}), colour), QString());
}

void TestRawPictures::yuvIsWhatALoopSays_data() {
  QTest::addColumn<YuvParams>("params");
  for (const YuvSampling sampling : {YuvSampling::s420, YuvSampling::s444})
    for (const int bits : {8, 10})
      for (const YuvMatrix matrix : {YuvMatrix::bt709, YuvMatrix::bt601})
        for (const YuvRange range : {YuvRange::limited, YuvRange::full})
          QTest::addRow("%s, %d bits, %s, %s", sampling == YuvSampling::s420 ? "4:2:0" : "4:4:4",
                        bits, matrix == YuvMatrix::bt709 ? "BT.709" : "BT.601",
                        range == YuvRange::limited ? "limited" : "full")
              << YuvParams{{61, 43}, sampling, bits, matrix, range};
}

/// Printed coefficients have six digits, so what lies at a half may be rounded the other way.
void TestRawPictures::yuvIsWhatALoopSays() {
  QFETCH(YuvParams, params);
  const std::size_t pixels = 61 * 43;
  const std::size_t chroma = params.sampling == YuvSampling::s420 ? 31 * 22 : pixels;
  const std::vector<int> samples = noise(pixels + 2 * chroma, params.bits, 2);
  writeYuv("a.yuv", samples, params.bits);
  QCOMPARE(ImageFile("a.yuv", params).bits(), params.bits);
  const auto [largest, count] = differences(valuesIn("a.yuv", params), bruteForce(samples, params));
  QVERIFY2(largest <= (params.bits == 8 ? 1 : 65), qPrintable(QString::number(largest)));
  QVERIFY2(count <= int(3 * pixels / 200), qPrintable(QString::number(count)));
}

/// OpenCV has BT.601 alone, limited for 4:2:0 and full for 4:4:4, in whole numbers.
void TestRawPictures::yuvIsWhatOpenCvSays() {
  std::vector<int> half = noise(64 * 48 * 3 / 2, 8, 3);
  for (int p = 0; p < 64 * 48; ++p)  // OpenCV takes what is blacker than black for black
    half[std::size_t(p)] = std::max(half[std::size_t(p)], 16);
  writeYuv("half.yuv", half, 8);
  cv::Mat1b planes(48 * 3 / 2, 64);
  std::copy(half.begin(), half.end(), planes.begin());
  cv::Mat3b rgb;
  cv::cvtColor(planes, rgb, cv::COLOR_YUV2RGB_I420);
  YuvParams params{{64, 48}, YuvSampling::s420, 8, YuvMatrix::bt601, YuvRange::limited};
  QVERIFY(differences(valuesIn("half.yuv", params), valuesOf(rgb)).first <= 1);

  const std::vector<int> whole = noise(64 * 48 * 3, 8, 4);
  writeYuv("whole.yuv", whole, 8);
  cv::Mat3b pixels(48, 64);
  for (int p = 0; p < 64 * 48; ++p)
    pixels(p / 64, p % 64) = cv::Vec3b(uchar(whole[std::size_t(p)]),                // Y
                                       uchar(whole[std::size_t(2 * 64 * 48 + p)]),  // Cr
                                       uchar(whole[std::size_t(64 * 48 + p)]));     // Cb
  cv::cvtColor(pixels, rgb, cv::COLOR_YCrCb2RGB);
  params.sampling = YuvSampling::s444;
  params.range = YuvRange::full;
  QVERIFY(differences(valuesIn("whole.yuv", params), valuesOf(rgb)).first <= 1);
}

/// A session's words: each view a file, named by the pattern.
void TestRawPictures::yuvViews() {
  for (int view = 0; view < 4; ++view)
    writeYuv(QString("views/00%1_00%2.yuv").arg(view / 2).arg(view % 2),
             std::vector<int>(4 * 2 * 3 / 2, 128 + 10 * view), 8);
  writeFile("s.json",
            text({.display = "{}",
                  .lightField = R"({"file": "views", "layout": "views", "pattern": "RRR_CCC.yuv",
                                    "yuvSize": [4, 2], "yuvRange": "full"})"}));
  const Session session = loadSession("s.json");
  const auto file = openLightField(session.lightField, session.display);
  QCOMPARE(file->size(), (LightFieldSize{4, 2, 2, 2}));
  const auto colour = [](const TexelIndex& at) {
    const double chroma = 10 * (2 * at.v + at.u);
    const double y = 128 + chroma;
    return Rgb{std::min(255.0, std::floor(y + 1.5748 * chroma + 0.5)),
               std::floor(y - (0.187324 + 0.468124) * chroma + 0.5),
               std::min(255.0, std::floor(y + 1.8556 * chroma + 0.5))};
  };
  QCOMPARE(firstWrong(file->read({}), colour), QString());
}

QTEST_GUILESS_MAIN(TestRawPictures)
#include "test_raw_pictures.moc"
