// SPDX-License-Identifier: BSD-3-Clause
// Tests that files of formats that are not read are called by their names, with what to do.
#include <QTemporaryDir>
#include <QTest>

#include "io/images/other_formats.h"
#include "io/opening/session_around.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

using namespace hogelscope;

class TestOtherFormats : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void areNamed_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const QByteArray& content, const char* says) {
      QTest::newRow(name) << content + QByteArray(600, 'x') << QString(says);
    };
    row("a.lfp", "\x89LFP\r\n\x1a\n", "Lytro");
    row("a.LFR", "\x89LFP\r\n\x1a\n", "Lytro");
    row("a.bag", "#ROSBAG V2.0\n", "recording of ROS");
    row("a.mcap", "\x89MCAP0\r\n", "recording of ROS");
    row("a.db3", QByteArray("SQLite format 3\0", 16), "SQLite");
    row("a.splat", "", "Gaussian splats");
    row("a.spz", "\x1f\x8b", "Gaussian splats");
    row("b.spz", "NGSP", "Gaussian splats");
    row("splats.ply",
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float "
        "f_dc_0\nend_header\n",
        "Gaussian splats");
    row("points.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n",
        "cloud of points");
    row("a.las", "LASF", "cloud of points");
    row("a.e57", "ASTM-E57", "cloud of points");
    row("a.pcd", "# .PCD v0.7", "cloud of points");
    row("a.npy", "\x93NUMPY", "NumPy");
    row("a.npz", "PK\x03\x04", "NumPy");
    row("a.zip", "PK\x03\x04", "archive");
    row("a.tar", QByteArray(257, 'n') + "ustar", "archive");
    row("a.tar.gz", "\x1f\x8b\x08", "archive");
    row("a.7z", "7z\xbc\xaf\x27\x1c", "archive");
    row("a.pdf", "%PDF-1.7", "pdfimages");
    row("a.svg", "<svg ", "rsvg-convert");
  }

  /// One line that names the file and the format, wherever it is opened.
  void areNamed() {
    QFETCH(const QByteArray, content);
    QFETCH(const QString, says);
    const QTemporaryDir folder;
    QVERIFY(QDir::setCurrent(folder.path()));
    const QString name = QTest::currentDataTag();
    QFile file(name);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
    file.close();
    const QString error = errorOf([&] { (void)sessionAround(name.toStdString()); });
    QVERIFY2(error.startsWith(name) && error.contains(says), qPrintable(error));
    QVERIFY2(!error.contains('\n'), qPrintable(error));
  }

  /// Pictures, surfaces and what nobody knows have no such advice.
  void othersAreNot() {
    const QTemporaryDir folder;
    QVERIFY(QDir::setCurrent(folder.path()));
    for (const char* name : {"a.png", "a.jpg", "a.bmp"}) {
      writeImageFile(name, 8, 8, [](int x, int, int) { return float(x) / 8; });
      QCOMPARE(adviceOnFormat(name), std::string());
    }
    writeFile("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nelement face 1\nend_header\n");
    QCOMPARE(adviceOnFormat("a.ply"), std::string());
    writeFile("unknown", "xyz");
    QCOMPARE(adviceOnFormat("unknown"), std::string());
    writeFile("empty", "");
    QCOMPARE(adviceOnFormat("empty"), std::string());
  }
};

QTEST_GUILESS_MAIN(TestOtherFormats)
#include "test_other_formats.moc"
