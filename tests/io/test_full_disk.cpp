// SPDX-License-Identifier: BSD-3-Clause
// Tests every writer of files on a disk that is full after any number of 8 kB: the new file is
// whole, or the old one is still there, and then the writer throws; nothing else is left.
#include <sys/resource.h>

#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <functional>

#include "core/optics/session.h"
#include "io/documents/panel_error_file.h"
#include "io/documents/session_file.h"
#include "io/images/image_writer.h"
#include "io/scene/view_source.h"
#include "io/store/store_writer.h"
#include "tests/io/documents.h"

using namespace hogelscope;

using Writer = std::function<void(const std::string& file)>;
Q_DECLARE_METATYPE(Writer)

namespace {

constexpr int width = 150;
constexpr int height = 70;

/// Values that no format compresses much.
template <class T>
std::vector<T> noise(std::size_t count) {
  std::vector<T> values(count);
  std::uint32_t state = 1;
  for (T& value : values) value = T((state = state * 1664525U + 1013904223U) >> 24U);
  return values;
}

const auto bytes = noise<std::uint8_t>(std::size_t(3 * width * height));
const auto floats = noise<float>(std::size_t(3 * width * height));

void writeRows(const std::string& file) {
  ImageRowWriter writer(file, width, height);
  for (std::size_t y = 0; y < height; ++y)
    writer.write(&bytes[std::size_t(3 * width) * std::size_t(y)]);
  writer.finish();
}

void writeManyStates(const std::string& file) {
  Session session;
  session.lightField.file = "a.png";
  for (int k = 0; k < 100; ++k)
    session.cameras.emplace_back().camera.name = "state " + std::to_string(k);
  saveSession(file, session);
}

void writeStore(const std::string& file) {
  LightFieldParams params;
  params.file = "source.png";
  PanelParams display;
  display.hogels = {15, 7};
  display.directions = {10, 10};
  const auto source = openLightField(params, display);
  pack(*source, planPack(params, *source, display, 1 << 20), file, 1, {});
}

/// While it lives, no file can grow beyond `limit` bytes.
class FullDisk {
 public:
  explicit FullDisk(std::size_t limit) {
    ::getrlimit(RLIMIT_FSIZE, &m_before);
    const rlimit less{limit, m_before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &less);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() { ::setrlimit(RLIMIT_FSIZE, &m_before); }

 private:
  rlimit m_before{};
};

}  // namespace

class TestFullDisk : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase();
  void writers_data();
  void writers();

 private:
  QTemporaryDir m_folder;
};

void TestFullDisk::initTestCase() {
  std::signal(SIGXFSZ, SIG_IGN);  // as main() does
  QVERIFY(QDir::setCurrent(m_folder.path()));
  writeImage("source.png", width, height, bytes);
}

void TestFullDisk::writers_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<Writer>("write");
  const auto row = [](const char* name, const char* file, const Writer& write) {
    QTest::newRow(name) << QString(file) << write;
  };
  for (const char* file :
       {"a.png", "a.jpg", "a.tif", "a.exr", "a.bmp", "a.webp", "a.tga", "a.ppm"}) {
    row(qPrintable(QString("8 bit, %1").arg(file)), file, [](const std::string& to) {
      writeImage(to, width, height, std::span<const std::uint8_t>(bytes));
    });
    if (QByteArray(file) != "a.webp")  // which is written at once
      row(qPrintable(QString("by rows, %1").arg(file)), file, writeRows);
  }
  for (const char* file : {"a.exr", "a.tif"})
    row(qPrintable(QString("values, %1").arg(file)), file, [](const std::string& to) {
      writeImage(to, width, height, std::span<const float>(floats));
    });
  row("mask", "a.mask.png", [](const std::string& to) {
    writeMask(to, width, height, std::span(bytes).first(std::size_t(width * height)));
  });
  row("planes", "a.exr", [](const std::string& to) {
    writePlanes(to, width, height,
                {{"mse", {floats.begin(), floats.begin() + width * height}},
                 {"pixels", {floats.begin(), floats.begin() + width * height}}});
  });
  row("session", "a.json", writeManyStates);
  row("panel error", "report.panel1", [](const std::string& to) {
    const std::vector<PanelError::Cell> cells(2000, {3, 4});
    savePanelError(to, "k", {{1, 2}, PanelError({20, 100, 50, 40}, cells, cells)});
  });
  row("store", "a.tif", writeStore);
}

void TestFullDisk::writers() {
  QFETCH(QString, file);
  QFETCH(Writer, write);
  QTemporaryDir folder;
  const QString path = folder.filePath(file);
  write(path.toStdString());
  const QByteArray whole = contentOf(path);
  const QByteArray old = file == "report.panel1" ? R"({"hogelscope panel error":1,)" : "old";
  constexpr qsizetype step = 8192;
  for (qsizetype limit = 0; limit < whole.size() + step; limit += step) {
    writeFile(path, old);
    QFile::remove(path + ".part");  // a store's, by which it would go on
    QString error;
    {
      const FullDisk full{std::size_t(limit)};
      error = errorOf([&] { write(path.toStdString()); });
    }
    const bool fits = limit >= whole.size();
    if (!fits) QVERIFY2(error.endsWith(": cannot be written: File too large"), qPrintable(error));
    if (fits) QCOMPARE(error, QString());
    QVERIFY2(contentOf(path) == (fits ? whole : old), qPrintable(QString::number(limit)));
    QStringList left = namesIn(folder.path());
    left.removeOne(file + ".part");
    QCOMPARE(left, QStringList{file});
  }
}

QTEST_APPLESS_MAIN(TestFullDisk)
#include "test_full_disk.moc"
