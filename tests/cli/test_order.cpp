// SPDX-License-Identifier: BSD-3-Clause
// Tests --info on the order of views, folders in place of sessions, and sessions that contradict
// their pictures.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <opencv2/imgcodecs.hpp>

#include "tests/cli/program.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"
#include "tests/io/layered_views.h"

using namespace hogelscope;

class TestOrder : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// 3 rows from below, 5 columns from the left.
  void initTestCase() {
    QVERIFY(QDir::setCurrent(m_folder.path()));
    const GreyGrid grid = gridOf(randomScene(7, 1, 6), 3, 5, {true, false, false});
    for (int k = 0; k < 15; ++k) {
      const GreyPicture view = grid.view(k / 5, k % 5);
      writeImageFile(QString("v/00%1_00%2.png").arg(k / 5).arg(k % 5), view.width, view.height,
                     [&](int x, int y, int) {
                       return float(view.values[std::size_t(y * view.width + x)]) / 255;
                     });
    }
  }

  void infoForPeople() {
    const Outcome outcome = run({"--info", "v", "--output", "sheet"}, m_folder.path());
    QCOMPARE(outcome.err, QByteArray());
    QVERIFY2(outcome.out.contains("order       rows bottom-up, columns left-right: sure\n"),
             outcome.out.constData());
    QVERIFY(outcome.out.contains("which puts the middle depth on the panel\n"));
    QVERIFY(!outcome.out.contains("warning"));
    const cv::Mat sheet = cv::imread("sheet/views.png");
    QVERIFY(sheet.cols > 5 * 240 && sheet.rows > 3 * 180);
    // The top left view is the last row's first, at its quarter.
    const cv::Mat view = cv::imread("v/002_000.png");
    QVERIFY(cv::norm(sheet(cv::Rect(78 + 60, 78 + 45, 150, 120)), view(cv::Rect(60, 45, 150, 120)),
                     cv::NORM_INF) < 3);
  }

  void infoForPrograms() {
    const QJsonObject right = documentOf({"--info", "v", "--json"});
    QCOMPARE(right.keys().size(), 8);
    QCOMPARE(right["layout"].toString(), QString("views"));
    QCOMPARE(right["hogels"].toArray(), (QJsonArray{240, 180}));
    QCOMPARE(right["directions"].toArray(), (QJsonArray{5, 3}));
    QCOMPARE(right["rows"].toString(), QString("bottom-up"));
    QCOMPARE(right["columns"].toString(), QString("left-right"));
    QCOMPARE(right["confidence"].toString(), QString("sure"));
    QVERIFY(right["shear"][0].toDouble() > 0.9 && right["shear"][1].toDouble() > 0.9);
    QCOMPARE(right["warnings"].toArray(), QJsonArray());
    const QJsonObject wrong =
        documentOf({"--info", "v", "--json", "--set", "lightField.rows=top-down"});
    QCOMPARE(wrong["rows"].toString(), QString("top-down"));
    QCOMPARE(wrong["confidence"].toString(), QString("unknown"));
    QVERIFY(wrong["warnings"][0].toString().contains("lightField.rows=bottom-up"));
  }

  /// The session that is made, once kept, gives the same picture; the wrong one a warning.
  void aFolderInPlaceOfASession() {
    const Outcome made = run({"--render", "--session", "v", "--output", "a", "--save-session",
                              "a/s.json", "--set", "camera.res=[60,60]"},
                             m_folder.path());
    QCOMPARE(made.status, 0);
    QVERIFY2(made.err.startsWith("hogelscope: v: rows bottom-up, columns left-right (sure), "),
             made.err.constData());
    const Outcome kept =
        run({"--render", "--session", "a/s.json", "--output", "b"}, m_folder.path());
    QCOMPARE(kept.err, QByteArray());
    const cv::Mat a = cv::imread("a/View.png");
    QVERIFY(!a.empty() && cv::norm(a, cv::imread("b/View.png"), cv::NORM_INF) == 0);
    const Outcome wrong = run({"--render", "--session", "a/s.json", "--output", "c", "--set",
                               "lightField.columns=right-left"},
                              m_folder.path());
    QCOMPARE(wrong.status, 0);
    QCOMPARE(wrong.err,
             QByteArray("hogelscope: a/s.json: warning: lightField: the order of views contradicts "
                        "their pictures, so depth is reversed along a direction; mend it with "
                        "lightField.columns=left-right (sure)\n"));
  }

  /// The reference's own views to and fro from the top, numbered as the frames of a video.
  void aTestInAnotherOrder() {
    QDir().mkpath("frames");
    for (int k = 0; k < 15; ++k) {
      const int row = k / 5;
      const int column = row % 2 == 1 ? 4 - k % 5 : k % 5;
      QVERIFY(QFile::copy(QString("v/00%1_00%2.png").arg(2 - row).arg(column),
                          QString("frames/%1.png").arg(k, 2, 10, QChar('0'))));
    }
    const auto report = [this](const QStringList& tests) {
      return run(QStringList{"--report", "--session", "v", "--output", "r", "--set",
                             "camera.res=[40,30]", "--set", "display.directions=[5,3]"} +
                     tests,
                 m_folder.path());
    };
    const QByteArray line =
        "frames: its views are read with lightField.scan=serpentine lightField.rows=top-down, "
        "because these are the views of the reference";
    const Outcome outcome = report({"--test", "frames"});
    QCOMPARE(outcome.status, 0);
    QVERIFY2(outcome.err.endsWith("\nhogelscope: " + line + "\n"), outcome.err);
    QVERIFY2(outcome.out.contains("identical views           1 of 1"), outcome.out);
    QVERIFY(contentOf("r/report.html").contains(line));
    // A document that gives an order keeps it.
    writeFile("own.json", text({.display = R"({"directions": [5, 3]})",
                                .lightField = R"({"file": "frames", "layout": "views",
                                                 "columns": "right-left"})"}));
    const Outcome own = report({"--test", "own.json", "--test", "v"});
    QCOMPARE(own.status, 0);
    QVERIFY2(
        own.err.endsWith("\nhogelscope: own.json: its views are those of the reference only with "
                         "lightField.scan=serpentine lightField.columns=left-right, which its "
                         "session does not say\n"),
        own.err);
    QVERIFY2(!own.out.contains("identical views           2 of 2"), own.out);
  }

  void mistakes() {
    QCOMPARE(run({"--info", "v", "--set", "lightField.rowz=1"}, m_folder.path()).err,
             QByteArray("hogelscope: v: lightField.rowz: is not known here; did you mean "
                        "\"rows\"?\n"));
    QCOMPARE(run({"--info", "v", "--output", "v/000_000.png"}, m_folder.path()).status, 2);
    const Outcome name =
        run({"--render", "--session", "v", "--output", "d", "--save-session", "v/000_000.png"},
            m_folder.path());
    QCOMPARE(name.status, 2);
    QVERIFY(name.err.endsWith("a session's name ends in .hogelscope or .json\n"));
  }

 private:
  QJsonObject documentOf(const QStringList& arguments) const {
    const Outcome outcome = run(arguments, m_folder.path());
    return QJsonDocument::fromJson(outcome.out).object();
  }

  QTemporaryDir m_folder;
};

QTEST_GUILESS_MAIN(TestOrder)
#include "test_order.moc"
