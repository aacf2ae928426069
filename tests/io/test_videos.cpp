// SPDX-License-Identifier: BSD-3-Clause
// Tests videos against the program ffmpeg, which writes and decodes them: frame by frame over
// codecs, containers and time stamps; colours against the closed form; orientations against a plain
// loop.
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <numeric>

#include "io/documents/session_file.h"
#include "io/images/image_file.h"
#include "io/opening/light_field_order.h"
#include "io/opening/session_around.h"
#include "io/scene/view_source.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

constexpr int width = 96;  // x265 3.5 writes beyond its arrays for smaller ones
constexpr int height = 64;
constexpr int frameCount = 14;

/// Values of 3 · width · height, in the file's bits.
using Values = std::vector<int>;

Values valuesOf(ImageFile& video, std::size_t frame) {
  Values values;
  const int most = (1 << video.bits()) - 1;
  video.select(frame);
  const auto add = [&](std::size_t, std::size_t rows, const StoredRows& stored) {
    const auto* const rgb = std::get<const float*>(stored);
    for (std::size_t k = 0; k < 3 * rows * video.width(); ++k)
      values.push_back(int(std::lround(double(rgb[k]) * most)));
  };
  video.read(StoredType::real, add, {});
  return values;
}

std::vector<Values> framesOf(const QString& file) {
  ImageFile video(file.toStdString());
  std::vector<Values> frames;
  for (std::size_t k = 0; k < video.frames(); ++k) frames.push_back(valuesOf(video, k));
  return frames;
}

/// Runs ffmpeg; returns what it writes to its output, none if it fails.
std::optional<QByteArray> ffmpeg(const QString& arguments) {
  QProcess process;
  process.start("ffmpeg", QString("-nostdin -v error -y " + arguments).split(' '));
  process.waitForFinished(-1);
  if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0) {
    qInfo("%s", process.readAllStandardError().constData());
    return std::nullopt;
  }
  return process.readAllStandardOutput();
}

/// Returns the frames as ffmpeg decodes them, with chroma at its place. One thread: of a stream
/// that was cut amid a group of pictures it shows other ones with more threads.
std::vector<Values> shownBy(const QString& file, int chromaX) {
  const QString scale =
      chromaX < 0 ? QString("null") : QString("scale=in_h_chr_pos=%1").arg(chromaX);
  const QByteArray rgb =
      ffmpeg("-threads 1 -i " + file + " -fps_mode passthrough -vf " + scale +
             " -sws_flags accurate_rnd+full_chroma_int+bicubic -f rawvideo -pix_fmt rgb24 -")
          .value_or(QByteArray());
  std::vector<Values> frames;
  constexpr qsizetype bytes = qsizetype(3) * width * height;
  for (qsizetype at = 0; at + bytes <= rgb.size(); at += bytes) {
    Values& frame = frames.emplace_back();
    for (qsizetype k = at; k < at + bytes; ++k) frame.push_back(uchar(rgb[k]));
  }
  return frames;
}

int largestDifference(const Values& a, const Values& b) {
  if (a.size() != b.size()) return INT_MAX;
  int largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

/// Returns the first frame that differs by more than `most`; "" if there is none.
QString firstDifference(const std::vector<Values>& is, const std::vector<Values>& should,
                        int most) {
  if (is.size() != should.size())
    return QString("%1 frames, not %2").arg(is.size()).arg(should.size());
  for (std::size_t k = 0; k < is.size(); ++k)
    if (const int difference = largestDifference(is[k], should[k]); difference > most)
      return QString("frame %1 differs by %2").arg(k).arg(difference);
  return {};
}

QString errorOfReading(const QString& file) {
  return errorOf([&] { (void)framesOf(file); });
}

}  // namespace

class TestVideos : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void frames_data();
  void frames();
  void cuts_data();
  void cuts();
  void someFramesCouldBeMade();
  void anyOrder_data();
  void anyOrder();
  void colours_data();
  void colours();
  void otherSamples_data();
  void otherSamples();
  void orientations_data();
  void orientations();
  void cutOff();
  void otherSizes();
  void noPictures();
  void quilts();
  void rawVideos();
  void namesOfRawVideos();

 private:
  QTemporaryDir m_folder;
  int m_made = 0;
};

/// Frames that all differ, with a bar that moves.
void TestVideos::initTestCase() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
  QByteArray rgb;
  for (int k = 0; k < frameCount; ++k)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const bool isBar = x / 8 == k % 12 && y > 16;
        rgb += char(isBar ? 240 : 60 + x + 5 * k);
        rgb += char(isBar ? 20 + 10 * k : 40 + 2 * y + 4 * k);
        rgb += char(std::lround(128 + 60 * std::sin((x + y) / 9.0 + k)));
      }
  writeFile("source.rgb", rgb);
}

/// Gives a Y4M its place of chroma, which FFmpeg's newer programs take from the filters, not from
/// the option.
void nameChroma(const QString& file, const QByteArray& name) {
  const QByteArray y4m = contentOf(file);
  const qsizetype end = y4m.indexOf('\n'), at = y4m.indexOf(" C420");
  QVERIFY(at > 0 && at < end);
  QByteArray head = y4m.first(at) + " C" + name;
  if (y4m.first(end).contains("XCOLORRANGE")) head += " XCOLORRANGE=LIMITED";
  writeFile(file, head + y4m.sliced(end));
}

/// What precedes the options of a video that is encoded.
const QString source =
    QString("-f rawvideo -pix_fmt rgb24 -s %1x%2 -r 25 -i source.rgb ").arg(width).arg(height);

void TestVideos::frames_data() {
  QTest::addColumn<QString>("options");
  QTest::addColumn<QString>("file");
  QTest::addColumn<int>("chromaX");  // 1/256 px; −1: not interpolated
  const auto add = [](const char* options, const char* file, int chromaX = 0) {
    QTest::addRow("%s %s", options, file) << QString(options) << QString(file) << chromaX;
  };
  const char* x264 = "-c:v libx264 -crf 12 -pix_fmt yuv420p";
  for (const char* file : {"a.mp4", "a.mov", "a.mkv", "a.avi", "a.flv", "a.ts", "a.h264"})
    add(x264, file);
  const char* x265 = "-c:v libx265 -crf 12 -x265-params log-level=error -pix_fmt yuv420p";
  for (const char* file : {"b.mp4", "b.mkv", "b.mov", "b.hevc"}) add(x265, file);
  const char* vp9 =
      "-c:v libvpx-vp9 -crf 12 -b:v 0 -lag-in-frames 12 -auto-alt-ref 1 -pix_fmt yuv420p";
  for (const char* file : {"c.webm", "c.mp4", "c.ivf"}) add(vp9, file);
  add("-c:v libvpx -b:v 1M -lag-in-frames 12 -auto-alt-ref 1 -pix_fmt yuv420p", "d.webm");
  for (const char* file : {"e.mp4", "e.mkv"})
    add("-c:v libaom-av1 -crf 20 -cpu-used 8 -usage realtime -pix_fmt yuv420p", file);
  for (const char* file : {"f.mp4", "f.avi", "f.mkv"})
    add("-c:v mpeg4 -q:v 2 -bf 2 -pix_fmt yuv420p", file);
  for (const char* file : {"g.mpg", "g.mkv", "g.ts"})
    add("-c:v mpeg2video -q:v 2 -bf 2 -pix_fmt yuv420p", file);
  for (const char* file : {"h.avi", "h.mov"}) add("-c:v mjpeg -q:v 2 -pix_fmt yuvj420p", file, 128);
  for (const char* file : {"i.mkv", "i.avi"}) add("-c:v ffv1 -pix_fmt yuv420p", file);
  add("-c:v libtheora -q:v 9 -pix_fmt yuv420p", "j.ogv", 128);
  add("-c:v wmv2 -q:v 2 -pix_fmt yuv420p", "k.wmv");
  add("-pix_fmt yuv420p -chroma_sample_location left", "l.y4m");
  add("-pix_fmt yuv420p -chroma_sample_location center", "m.y4m", 128);
  add("-c:v rawvideo -pix_fmt yuv420p", "n.avi");
  add("-c:v huffyuv -pix_fmt yuv422p", "o.avi");
  add("-c:v libx264 -crf 8 -pix_fmt yuv444p", "p.mp4", -1);
  add("-c:v png -pix_fmt rgb24", "q.mov", -1);
  add("-c:v utvideo -pix_fmt gbrp", "r.avi", -1);
  add("-c:v libx264rgb -crf 8 -pix_fmt rgb24", "s.mp4", -1);
  add("-c:v ffv1 -pix_fmt gray", "t.mkv", -1);
  add("-c:v qtrle -pix_fmt argb", "u.mov", -1);
  // Time stamps.
  const QByteArray base = QByteArray(x264) + ' ';
  add(base + "-output_ts_offset 1.3", "late.mp4");
  add(base + "-output_ts_offset 1.3", "late.mkv");
  add(base + "-vf setpts=N*N*0.01/TB -fps_mode vfr", "uneven.mkv");
  add(base + "-vf setpts=PTS+0.7*random(0)/TB/25 -fps_mode vfr", "random.mp4");
  add(base + "-movflags frag_keyframe+empty_moov -g 4", "parts.mp4");
  add(base + "-use_editlist 0", "listless.mp4");
  add(base + "-movflags +negative_cts_offsets", "negative.mp4");
  add(base + "-output_ts_offset -0.2 -avoid_negative_ts disabled", "early.mp4");
  add(base + "-x264-params interlaced=1 -flags +ildct+ilme", "interlaced.mp4");
  for (const char* file : {"keys.mp4", "keys.mkv", "keys.ts"}) add(base + "-g 4 -bf 2", file);
  add(base + "-x264-params intra-refresh=1:keyint=6:bframes=0", "refresh.mp4");
}

/// All codecs' frames are those that ffmpeg shows.
void TestVideos::frames() {
  QFETCH(const QString, options);
  QFETCH(const QString, file);
  QFETCH(const int, chromaX);
  if (!ffmpeg(source + options + " " + file)) QSKIP("ffmpeg cannot encode it");
  ++m_made;
  if (options.contains("left")) nameChroma(file, "420mpeg2 XYSCSS=420MPEG2");
  if (options.contains("center")) nameChroma(file, "420jpeg XYSCSS=420JPEG");
  const std::vector<Values> should = shownBy(file, chromaX);
  QVERIFY(!should.empty());
  std::vector<Values> is;
  QCOMPARE(errorOf([&] { is = framesOf(file); }), QString());
  QCOMPARE(firstDifference(is, should, 1), QString());
}

void TestVideos::cuts_data() {
  QTest::addColumn<QString>("parameters");
  QTest::addColumn<QString>("cut");
  QTest::addColumn<QString>("file");
  for (const char* parameters :
       {"-c:v libx264 -x264-params keyint=5:bframes=3",
        "-c:v libx264 -x264-params keyint=5:bframes=3:open-gop=1",
        "-c:v libx265 -x265-params log-level=error:keyint=5:bframes=3:open-gop=1"})
    for (const char* cut : {"-ss 0.2", "-ss 0.28", "-ss 0.4", "-t 0.3", "-ss 0.2 -t 0.2"})
      for (const char* file : {"cut.mp4", "cut.mkv", "cut.mov"})
        QTest::addRow("%s %s %s", parameters, cut, file)
            << QString(parameters) << QString(cut) << QString(file);
}

/// Streams that were cut without coding them again begin amid a group of pictures, or have edit
/// lists.
void TestVideos::cuts() {
  QFETCH(const QString, parameters);
  QFETCH(const QString, cut);
  QFETCH(const QString, file);
  if (!ffmpeg(source + parameters + " -crf 12 -pix_fmt yuv420p whole.mp4"))
    QSKIP("ffmpeg cannot encode it");
  QVERIFY(ffmpeg(cut + " -i whole.mp4 -c copy " + file));
  ++m_made;
  const std::vector<Values> should = shownBy(file, 0);
  QVERIFY(!should.empty() && should.size() < frameCount);
  std::vector<Values> is;
  QCOMPARE(errorOf([&] { is = framesOf(file); }), QString());
  QCOMPARE(firstDifference(is, should, 1), QString());
}

void TestVideos::someFramesCouldBeMade() {
  QVERIFY2(m_made > 0, "the program ffmpeg made none of the videos");
}

void TestVideos::anyOrder_data() {
  QTest::addColumn<QString>("file");
  for (const char* file :
       {"a.mp4", "a.mkv", "a.avi", "a.ts", "b.mkv", "c.webm", "e.mp4", "f.avi", "g.mpg", "h.avi",
        "i.mkv", "l.y4m", "late.mp4", "refresh.mp4", "keys.mp4", "keys.mkv", "keys.ts", "cut.mkv"})
    QTest::newRow(file) << QString(file);
}

/// Going back and leaping forward give the frames that reading in order gave.
void TestVideos::anyOrder() {
  QFETCH(const QString, file);
  if (!QFile::exists(file)) QSKIP("ffmpeg cannot encode it");
  std::vector<Values> should;
  QCOMPARE(errorOf([&] { should = framesOf(file); }), QString());
  ImageFile video(file.toStdString());
  for (const std::size_t frame : {9, 2, 3, 13, 0, 6, 6, 5, 12, 1})
    if (frame < should.size()) QVERIFY(valuesOf(video, frame) == should[frame]);
}

struct Matrix {
  const char* tag;
  double red;
  double blue;
};

void TestVideos::colours_data() {
  QTest::addColumn<QString>("samples");
  QTest::addColumn<int>("bits");
  QTest::addColumn<QString>("tags");
  QTest::addColumn<double>("red");
  QTest::addColumn<double>("blue");
  QTest::addColumn<bool>("isFull");
  const std::array matrices{Matrix{"", 0.299, 0.114}, Matrix{" -colorspace bt709", 0.2126, 0.0722},
                            Matrix{" -colorspace smpte170m", 0.299, 0.114},
                            Matrix{" -colorspace bt470bg", 0.299, 0.114},
                            Matrix{" -colorspace bt2020nc", 0.2627, 0.0593}};
  const std::array<std::pair<const char*, int>, 6> samples{{{"yuv420p", 8},
                                                            {"yuv444p", 8},
                                                            {"yuv420p10le", 10},
                                                            {"yuv422p10le", 10},
                                                            {"yuv420p12le", 12},
                                                            {"yuv444p12le", 12}}};
  for (const auto& [name, bits] : samples)
    for (const Matrix& matrix : matrices)
      for (const char* range : {"", " -color_range tv", " -color_range pc"})
        QTest::addRow("%s%s%s", name, matrix.tag, range)
            << QString(name) << bits << QString(matrix.tag) + range << matrix.red << matrix.blue
            << (QByteArray(range) == " -color_range pc");
}

/// Even patches are as the standards' formulas have them, to half a step of their bits.
void TestVideos::colours() {
  QFETCH(const QString, samples);
  QFETCH(const int, bits);
  QFETCH(const QString, tags);
  QFETCH(const double, red);
  QFETCH(const double, blue);
  QFETCH(const bool, isFull);
  const int unit = 1 << (bits - 8);
  const int most = (1 << bits) - 1;
  const std::array<std::array<int, 3>, 4> patches{
      {{16, 128, 128}, {235, 128, 128}, {120, 90, 160}, {171, 151, 101}}};
  const int across = samples.contains("444") ? 32 : 16;
  const int down = samples.contains("420") ? 16 : 32;
  QByteArray raw;
  for (const auto& patch : patches)
    for (std::size_t c = 0; c < 3; ++c)
      for (int k = 0; k < (c == 0 ? 32 * 32 : across * down); ++k) {
        const int sample = patch[c] * unit + (bits > 8 ? 3 : 0);
        raw += char(sample & 255);
        if (bits > 8) raw += char(sample >> 8);
      }
  writeFile("patches.raw", raw);
  // The input has the tags too: newer versions convert what is tagged otherwise.
  if (!ffmpeg("-f rawvideo -pix_fmt " + samples + " -s 32x32" + tags + " -i patches.raw -c:v ffv1" +
              tags + " patches.mkv"))
    QSKIP("ffmpeg cannot encode it");
  ImageFile video("patches.mkv");
  QCOMPARE(video.bits(), bits);
  QCOMPARE(video.type(), bits > 8 ? StoredType::uint16 : StoredType::uint8);
  QCOMPARE(video.frames(), patches.size());
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const auto part = [&](std::size_t c, int zero, int span) {
      const int sample = patches[k][c] * unit + (bits > 8 ? 3 : 0);
      return double(sample - zero * unit) / (isFull ? most : span * unit);
    };
    const double y = part(0, isFull ? 0 : 16, 219);
    const double r = y + 2 * (1 - red) * part(2, 128, 224);
    const double b = y + 2 * (1 - blue) * part(1, 128, 224);
    const double g = (y - red * r - blue * b) / (1 - red - blue);
    const Values values = valuesOf(video, k);
    for (std::size_t p = 0; p < values.size(); p += 3)
      for (std::size_t c = 0; c < 3; ++c) {
        const double should = most * std::clamp(std::array{r, g, b}[c], 0.0, 1.0);
        QVERIFY2(std::abs(values[p + c] - should) < 0.55,
                 qPrintable(QString::number(values[p + c])));
      }
  }
}

void TestVideos::otherSamples_data() {
  QTest::addColumn<QString>("samples");
  QTest::addColumn<QString>("codec");
  QTest::addColumn<int>("bits");
  QTest::newRow("RGB of 10 bits") << "gbrp10le"
                                  << "ffv1" << 10;
  QTest::newRow("RGB of 16 bits") << "rgb48be"
                                  << "png" << 16;
  QTest::newRow("grey of 10 bits") << "gray10le"
                                   << "ffv1" << 10;
  QTest::newRow("grey of 16 bits") << "gray16le"
                                   << "ffv1" << 16;
}

/// Values without a matrix are those of the file.
void TestVideos::otherSamples() {
  QFETCH(const QString, samples);
  QFETCH(const QString, codec);
  QFETCH(const int, bits);
  if (!ffmpeg(source + "-c:v " + codec + " -pix_fmt " + samples + " deep.mkv"))
    QSKIP("ffmpeg cannot encode it");
  const QString plain = samples.startsWith("gray") ? samples : QString("rgb48le");
  const QByteArray raw = *ffmpeg("-i deep.mkv -f rawvideo -pix_fmt " + plain + " -");
  const bool isGrey = plain != "rgb48le";
  ImageFile video("deep.mkv");
  QCOMPARE(video.bits(), bits);
  const Values values = valuesOf(video, 0);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const auto at = qsizetype(2 * (isGrey ? k / 3 : k));
    const int sample = uchar(raw[at]) + 256 * uchar(raw[at + 1]);
    QCOMPARE(values[k], isGrey ? sample : sample >> (16 - bits));
  }
}

void TestVideos::orientations_data() {
  QTest::addColumn<std::array<int, 4>>("matrix");  // x' = m₀ x + m₂ y, y' = m₁ x + m₃ y
  for (const int a : {1, -1})
    for (const int b : {1, -1}) {
      QTest::addRow("%d 0 0 %d", a, b) << std::array{a, 0, 0, b};
      QTest::addRow("0 %d %d 0", a, b) << std::array{0, a, b, 0};
    }
}

/// All eight matrices of an MP4's track header, as phones write some of them.
void TestVideos::orientations() {
  using Numbers = std::array<int, 4>;
  QFETCH(const Numbers, matrix);
  if (!ffmpeg(source + "-c:v libx264 -crf 8 -pix_fmt yuv444p upright.mp4") &&
      !ffmpeg(source + "-c:v png upright.mp4"))
    QSKIP("ffmpeg cannot encode it");
  QByteArray file = contentOf("upright.mp4");
  const qsizetype header = file.indexOf("tkhd");
  QVERIFY(header > 0);
  const std::array places{0, 1, 3, 4};
  for (std::size_t k = 0; k < 4; ++k)
    for (int byte = 0; byte < 4; ++byte)
      file[header + 44 + 4 * places[k] + byte] = char((matrix[k] * 65536) >> (24 - 8 * byte));
  writeFile("turned.mp4", file);
  ImageFile upright("upright.mp4");
  ImageFile turned("turned.mp4");
  const bool isTurned = matrix[0] == 0;
  QCOMPARE(turned.width(), std::size_t(isTurned ? height : width));
  QCOMPARE(turned.height(), std::size_t(isTurned ? width : height));
  for (const std::size_t frame : {0, 5}) {
    const Values from = valuesOf(upright, frame);
    const Values to = valuesOf(turned, frame);
    const auto [a, b, c, d] = matrix;
    const int left = (a < 0 ? width - 1 : 0) + (c < 0 ? height - 1 : 0);
    const int top = (b < 0 ? width - 1 : 0) + (d < 0 ? height - 1 : 0);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const auto at =
            std::size_t(left + a * x + c * y) + turned.width() * std::size_t(top + b * x + d * y);
        for (std::size_t k = 0; k < 3; ++k)
          QCOMPARE(to[3 * at + k], from[std::size_t(3 * (y * width + x)) + k]);
      }
  }
}

/// A file without its end is told, not filled.
void TestVideos::cutOff() {
  if (!ffmpeg(source + "-c:v mjpeg -q:v 2 -movflags faststart whole.mov")) QSKIP("no ffmpeg");
  const QByteArray whole = contentOf("whole.mov");
  for (const double part : {0.99, 0.7, 0.5}) {
    writeFile("cut.mov", whole.left(qsizetype(part * double(whole.size()))));
    const QString error = errorOfReading("cut.mov");
    QVERIFY2(error.startsWith("cut.mov: ") && error.contains("cut off"), qPrintable(error));
  }
  QByteArray damaged = whole;
  std::fill(damaged.begin() + whole.size() / 2, damaged.begin() + whole.size() / 2 + 300, 'x');
  writeFile("damaged.mov", damaged);
  const QString error = errorOfReading("damaged.mov");
  QVERIFY2(error.isEmpty() || (error.startsWith("damaged.mov: ") && !error.contains('\n')),
           qPrintable(error));
}

void TestVideos::otherSizes() {
  if (!ffmpeg(source + "-c:v libx264 -pix_fmt yuv420p one.h264") ||
      !ffmpeg(source + "-vf scale=48:48 -c:v libx264 -pix_fmt yuv420p two.h264"))
    QSKIP("ffmpeg cannot encode it");
  writeFile("both.h264", contentOf("one.h264") + contentOf("two.h264"));
  QCOMPARE(
      errorOfReading("both.h264"),
      QString("both.h264: frame 14: is 48×48 px of 8 bits, but frame 0 is 96×64 px of 8 bits"));
}

void TestVideos::noPictures() {
  if (!ffmpeg("-f lavfi -i sine -t 0.1 sound.mkv")) QSKIP("no ffmpeg");
  QCOMPARE(errorOfReading("sound.mkv"), QString("sound.mkv: is a matroska file without pictures"));
}

/// A video whose name is a quilt's is one quilt a frame; as views it is told.
void TestVideos::quilts() {
  if (!ffmpeg(source + "-c:v ffv1 -pix_fmt gbrp dance_qs4x2a0.8.mkv")) QSKIP("no ffmpeg");
  LightFieldParams views = lightFieldOf("dance_qs4x2a0.8.mkv");
  QCOMPARE(views.layout, Layout::quilt);
  views.layout = Layout::views;
  const auto told = openLightField(views, PanelParams())->warnings();
  QCOMPARE(told.size(), std::size_t(1));
  QVERIFY(QString::fromStdString(told[0]).contains("each frame is a quilt of 4×2 views"));
  const Session session = sessionAround("dance_qs4x2a0.8.mkv", {"lightField.layout=quilt"}, {});
  const auto quilt = openLightField(session.lightField, session.display);
  QCOMPARE(quilt->size(), (LightFieldSize{width / 4, height / 2, 8, 1}));
  QCOMPARE(quilt->warnings().size(), std::size_t(0));
  QCOMPARE(quilt->frames(), (FrameNumbers{0, 13, 1}));
}

/// Raw YUV of several pictures: each is that of a file of its own.
void TestVideos::rawVideos() {
  QByteArray all;
  for (int k = 0; k < 5; ++k) {
    QByteArray one;
    for (int sample = 0; sample < 6 * 4 * 3 / 2; ++sample) one += char(40 + 7 * sample + 30 * k);
    writeFile(QString("one%1.yuv").arg(k), one);
    all += one;
  }
  writeFile("all.yuv", all);
  const YuvParams params{.size = {6, 4}};
  ImageFile video("all.yuv", params);
  QCOMPARE(video.frames(), std::size_t(5));
  for (const int k : {0, 3, 1, 4}) {
    ImageFile one("one" + std::to_string(k) + ".yuv", params);
    QVERIFY(valuesOf(video, std::size_t(k)) == valuesOf(one, 0));
  }
  LightFieldParams views;
  views.file = "all.yuv";
  views.layout = Layout::views;
  views.yuv = params;
  QCOMPARE(openLightField(views, PanelParams())->size(), (LightFieldSize{6, 4, 5, 1}));
  for (int k = 1; k < 5; ++k) writeFile(QString("folder/all%1.yuv").arg(k), all);
  views.file = "folder";
  const auto frames = openLightField(views, PanelParams());
  QCOMPARE(frames->warnings().size(), std::size_t(0));
  QCOMPARE(frames->frames(), (FrameNumbers{0, 4, 1}));
  writeFile("all.yuv", all.chopped(1));
  QVERIFY(errorOf([&] { ImageFile cut("all.yuv", params); }).contains("is 179 bytes, but one"));
}

void TestVideos::namesOfRawVideos() {
  const QByteArray picture(8 * 4 * 3 / 2 * 2, '\1');
  writeFile("v00_texture_8x4_yuv420p10le.yuv", picture + picture);
  const LightFieldParams found = lightFieldOf("v00_texture_8x4_yuv420p10le.yuv");
  QCOMPARE(found.layout, Layout::views);
  const auto file = openLightField(found, PanelParams());
  QCOMPARE(file->size(), (LightFieldSize{8, 4, 2, 1}));
  QCOMPARE(file->bits(), 10);
  writeFile("a_8x4_yuv444p.yuv", QByteArray(8 * 4 * 3, '\1'));
  QCOMPARE(lightFieldOf("a_8x4_yuv444p.yuv").layout, Layout::hogels);
  QCOMPARE(ImageFile("a_8x4_yuv444p.yuv").width(), std::size_t(8));
  writeFile("a_8x4_yuv422p.yuv", QByteArray(8 * 4 * 2, '\1'));
  QCOMPARE(errorOfReading("a_8x4_yuv422p.yuv"),
           QString("a_8x4_yuv422p.yuv: has the name of yuv422p; of raw YUV 4:2:0 and 4:4:4 are "
                   "read, 8 to 16 bits, low byte first"));
  for (int k = 0; k < 9; ++k) {
    writeFile(QString("seq/v0%1_texture_8x4_yuv420p10le.yuv").arg(k), picture);
    writeFile(QString("seq/v0%1_depth_8x4_yuv420p16le.yuv").arg(k), picture);
  }
  LightFieldParams params = lightFieldOf("seq");
  QCOMPARE(openLightField(params, PanelParams())->size(), (LightFieldSize{8, 4, 3, 3}));
  params.pattern = "vNN_texture_8x4_yuv420p10le.yuv";
  PanelParams display;
  display.directions = {9, 1};
  QCOMPARE(openLightField(params, display)->size(), (LightFieldSize{8, 4, 9, 1}));
}

QTEST_GUILESS_MAIN(TestVideos)
#include "test_videos.moc"
