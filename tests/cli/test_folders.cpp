// SPDX-License-Identifier: BSD-3-Clause
// Tests what the jobs do with a folder as people have it: holes, other files, no session.
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include "core/base/text.h"
#include "io/store/light_field_store.h"
#include "tests/cli/csv.h"
#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

using namespace hogelscope;

namespace {

const QByteArray missing =
    "lightField: 2 of 9 views are missing and shown black: (row, column) 0 0, 2 1";
const QByteArray warning = "hogelscope: v: warning: " + missing + "\n";

}  // namespace

class TestFolders : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// 3×3 views of 8×6, two of them missing.
  void initTestCase() {
    QVERIFY(QDir::setCurrent(m_folder.path()));
    for (int k = 1; k < 9; ++k)
      if (k != 7)
        writeImageFile(QString("v/scene_00%1_00%2_crop.png").arg(k / 3).arg(k % 3), 8, 6,
                       [k](int x, int y, int) { return float(20 * k + 3 * x + 5 * y) / 255; });
    writeFile("v/README.md", "hello");
    writeFile("v/.DS_Store", "x");
    writeGrey("v/thumb.png", 2, 2);
  }

  void info() {
    const Outcome words = done({"--info", "v"});
    for (const char* line :
         {"layout      views, 3 rows of 3\n", "names       scene_RRR_CCC_crop.png\n",
          "first       scene_000_001_crop.png\n", "last        scene_002_002_crop.png\n",
          "others      2: README.md, thumb.png; no views\n"})
      QVERIFY2(words.out.contains(line), words.out.constData());
    QVERIFY(words.out.contains("warning     " + missing + "\n"));
    const QJsonDocument json = QJsonDocument::fromJson(done({"--info", "v", "--json"}).out);
    QCOMPARE(json["warnings"].toArray(), QJsonArray{QString(missing)});
    QCOMPARE(json["directions"].toArray(), (QJsonArray{3, 3}));
    const Outcome excluded = done({"--info", "v", "--set", "lightField.exclude=*_crop.png;*.md"});
    QCOMPARE(excluded.status, 2);
    QCOMPARE(excluded.err, QByteArray("hogelscope: v: views: no names agree in all but their "
                                      "numbers: thumb.png is there; give lightField.pattern, such "
                                      "as RRR_CCC\n"));
  }

  /// On stdout and stderr: they could turn, colour or forge a terminal's lines.
  void namesAreHarmless() {
    const QString folder = QString::fromUtf8("w\x1b[31m\nconfidence  sure\u202e");
    for (int k = 0; k < 4; ++k)
      writeImageFile(folder + QString("/a\u009b%1_%2.png").arg(k / 2).arg(k % 2), 8, 6,
                     [k](int, int, int) { return float(k) / 8; });
    writeFile((folder + "/b\nc").toUtf8(), "x");
    for (const QStringList& arguments :
         {QStringList{"--info", folder}, QStringList{"--plugins", "--plugins-path", folder},
          QStringList{"--render", "--session", folder, "--output", folder + "/" + folder},
          QStringList{"--export", "views", "--session", folder, "--output", folder + "out"}}) {
      const Outcome outcome = done(arguments);
      const QString all = QString::fromUtf8(outcome.out + outcome.err);
      QVERIFY2(!all.isEmpty(), qPrintable(arguments[0]));
      for (const QString& line : all.split('\n'))
        QVERIFY2(
            !line.startsWith("confidence") && line.toStdString() == printable(line.toStdString()),
            qPrintable(all));
    }
  }

  /// Once, on stderr; --quiet is quiet. A session that is kept says it again.
  void jobsWarn() {
    const QStringList render{"--render", "--session", "v", "--output", "out"};
    const Outcome first = done(render + QStringList{"--save-session", "s.json"});
    QCOMPARE(first.status, 0);
    QCOMPARE(first.err.count("warning"), 1);
    QVERIFY2(first.err.contains(warning), first.err.constData());
    QCOMPARE(done(render + QStringList{"--quiet"}).err, QByteArray());
    QCOMPARE(done({"--render", "--session", "s.json", "--output", "out2"}).err,
             "hogelscope: s.json: warning: " + missing + "\n");
    const Outcome packed = done({"--pack", "v", "--output", "v.tif"});
    QCOMPARE(packed.err, warning);
    QVERIFY((LightFieldStore("v.tif").size() == LightFieldSize{8, 6, 3, 3}));
  }

  /// A test of a report, too, whose holes would otherwise be a codec's errors.
  void reportsWarnOfTheirTests() {
    QVERIFY(done({"--export", "views", "--session", "v", "--output", "whole"}).status == 0);
    const Outcome report =
        done({"--report", "--session", "whole", "--test", "v", "--output", "report"});
    QCOMPARE(report.status, 0);
    QVERIFY2(report.err.contains(warning), report.err.constData());
    QCOMPARE(report.err.count("warning"), 1);
  }

  /// Other files in a test's folder are none of its bits.
  void ratesAreOfViews() {
    QStringList arguments{"--report", "--session", "whole", "--output", "rates"};
    for (const char* test : {"t1", "t2", "t3", "t4"}) {
      QVERIFY(done({"--export", "views", "--session", "whole", "--output", test}).status == 0);
      writeFile(QString(test) + "/README.md", QByteArray(100000, 'x'));
      arguments << "--test" << test;
    }
    const Outcome report = done(arguments + QStringList{"--group", "a=t1,t2,t3,t4"});
    QVERIFY2(report.status == 0, report.err.constData());
    qint64 bytes = 0;
    for (const QFileInfo& view : QDir("t1").entryInfoList({"*.png"})) bytes += view.size();
    int found = 0;
    for (const QStringList& row : tableOf("rates/summary.csv")) {
      if (row[1] != "rate_bpp") continue;
      QCOMPARE(row[2].toDouble(), 8.0 * double(bytes) / (8 * 6 * 9));
      ++found;
    }
    QCOMPARE(found, 4);
  }

  /// --generate fills a display with as many hogels and directions, over none of the views.
  void aFolderIsASession() {
    QCOMPARE(done({"--generate", "directions", "--session", "v", "--output", "g.png"}).status, 0);
    QCOMPARE(sizeOf("g.png"), QSize(24, 18));
    const Outcome over = done(
        {"--generate", "directions", "--session", "v", "--output", "v/scene_001_001_crop.png"});
    QCOMPARE(over.status, 2);
    const Outcome packed =
        done({"--pack", "g.png", "--session", "g.png", "--set", "display.hogels=[8,6]", "--set",
              "display.directions=[3,3]", "--output", "g.tif"});
    QCOMPARE(packed.status, 0);
    QVERIFY(LightFieldStore("g.tif").header().display.has_value());
  }

 private:
  [[nodiscard]] Outcome done(const QStringList& arguments) const {
    return run(arguments, m_folder.path());
  }

  QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestFolders)
#include "test_folders.moc"
