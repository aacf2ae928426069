// SPDX-License-Identifier: BSD-3-Clause
// Tests --render --between and --video: with the real ffmpeg where it is, and with stand-ins.
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <opencv2/videoio.hpp>

#include "core/cameras/camera_path.h"
#include "tests/cli/program.h"
#include "tests/cli/views.h"
#include "tests/io/any_images.h"
#include "tests/io/documents.h"

using namespace hogelscope;

class TestVideo : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(QDir::setCurrent(m_folder->path()));
    QVERIFY(QDir().mkdir("bin"));
  }

  /// The states' own pictures, and those of states between them, as the reference engine has them.
  void picturesBetween() {
    const Outcome outcome = render({"--between", "2", "--states", "Fig [126]"});
    QCOMPARE(outcome.err, QByteArray());
    QCOMPARE(outcome.out, QByteArray("7 picture(s) in out\n"));
    QCOMPARE(namesIn("out").size(), 7);
    Session session = loadSession(sampleSession.toStdString(), {"camera.res=[41,30]"});
    session.cameras = {session.cameras[0], session.cameras[1], session.cameras[5]};
    session.cameras = statesAlong({PathKind::between, 2}, session, 0);
    const std::vector<Image> expected = simulated(session);
    for (std::size_t k = 0; k < 7; ++k) {
      const QString file = QString("out/frame_000%1.png").arg(k + 1);
      QVERIFY2(valuesOf<std::uint8_t>(file) == expected[k].rgb, qPrintable(file));
    }
    QVERIFY(expected[0].rgb != expected[1].rgb);
  }

  /// The path is a session of its own, which reports can be made of.
  void thePathIsKept() {
    QCOMPARE(render({"--between", "3", "--save-session", "path.json"}).status, 0);
    const Session path = loadSession("path.json");
    QCOMPARE(path.cameras.size(), std::size_t(21));
    QCOMPARE(path.cameras[20].camera.name, std::string("frame_0021"));
  }

  void video() {
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) QSKIP("no ffmpeg in PATH");
    const Outcome outcome = render({"--between", "4", "--video", "made/a.mp4", "--fps", "12"});
    QCOMPARE(outcome.err, QByteArray());
    QCOMPARE(outcome.status, 0);
    QCOMPARE(namesIn("made"), QStringList{"a.mp4"});
    cv::VideoCapture video("made/a.mp4");
    QVERIFY(video.isOpened());
    QCOMPARE(int(video.get(cv::CAP_PROP_FRAME_COUNT)), 26);
    QCOMPARE(video.get(cv::CAP_PROP_FPS), 12.0);
    QCOMPARE(int(video.get(cv::CAP_PROP_FRAME_WIDTH)), 42);  // even
    cv::Mat frame;
    for (int k = 0; k < 7; ++k) QVERIFY(video.read(frame));
    const auto expected = valuesOf<std::uint8_t>("out/frame_0007.png");
    double sum = 0;
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 41; ++x)
        for (int c = 0; c < 3; ++c)
          sum += std::abs(frame.at<cv::Vec3b>(y, x)[2 - c] -
                          expected[3 * std::size_t(41 * y + x) + std::size_t(c)]);
    QVERIFY2(sum / (3 * 41 * 30) < 12, qPrintable(QString::number(sum / (3 * 41 * 30))));
  }

  /// All pictures go to ffmpeg, and its file gets its name when it ends well.
  void picturesAreHandedOver() {
    writeFile("bin/made", videoOf(6));
    standIn("cat > \"$0.seen\"\n" + copying("made"));
    QCOMPARE(render({"--video", "a.mp4"}).status, 0);
    QByteArray expected;
    for (int k = 1; k <= 6; ++k) {
      const auto rgb = valuesOf<std::uint8_t>(QString("out/Fig %1.png").arg(k));
      expected.append(reinterpret_cast<const char*>(rgb.data()), qsizetype(rgb.size()));
    }
    QVERIFY(contentOf("bin/ffmpeg.seen") == expected);
    QVERIFY(contentOf("a.mp4") == videoOf(6));
  }

  void noVideoOfAllPictures_data() {
    QTest::addColumn<QByteArray>("made");
    QTest::addColumn<QByteArray>("why");
    const QByteArray whole = videoOf(6);
    QTest::newRow("nothing") << QByteArray() << QByteArray("a file with 0 of 6 pictures");
    QTest::newRow("too few") << videoOf(5) << QByteArray("a file with 5 of 6 pictures");
    QTest::newRow("without its end")
        << whole.first(whole.indexOf("moov") - 4) << QByteArray("a file with 0 of 6 pictures");
    QTest::newRow("cut off") << whole.chopped(1) << QByteArray("a file with 0 of 6 pictures");
    QTest::newRow("another file") << QByteArray(1000, '\0')
                                  << QByteArray("a file with 0 of 6 pictures");
  }

  /// An ffmpeg that ends with 0 all the same, as on a full disk.
  void noVideoOfAllPictures() {
    QFETCH(const QByteArray, made);
    QFETCH(const QByteArray, why);
    writeFile("bin/made", made);
    writeFile("a.mp4", "old");
    standIn("cat > /dev/null\n" + copying("made"));
    const Outcome outcome = render({"--video", "a.mp4"});
    QCOMPARE(outcome.status, 2);
    QCOMPARE(outcome.err, "hogelscope: a.mp4: cannot be written: ffmpeg made " + why + "\n");
    QCOMPARE(contentOf("a.mp4"), QByteArray("old"));
  }

  /// What ffmpeg prints of its errors is not passed over.
  void ffmpegComplains() {
    writeFile("bin/made", videoOf(6));
    standIn("cat > /dev/null\necho No space left >&2\n" + copying("made"));
    const Outcome outcome = render({"--video", "a.mp4"});
    QCOMPARE(outcome.status, 2);
    QCOMPARE(outcome.err,
             QByteArray("hogelscope: a.mp4: cannot be written: ffmpeg: No space left\n"));
    QVERIFY(!QFile::exists("a.mp4"));
  }

  /// With the real ffmpeg, on a disk of a few kB.
  void fullDisk() {
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) QSKIP("no ffmpeg in PATH");
    const QString script =
        "mkdir disk && mount -t tmpfs -o size=4k none disk && : > disk/ready && \"$@\"; s=$?; "
        "ls disk >names; exit $s";
    QProcess process;
    process.setProcessEnvironment(environment());
    process.setWorkingDirectory(m_folder->path());
    process.start("unshare", QStringList{"-rm", "sh", "-c", script, "sh", HOGELSCOPE_PROGRAM} +
                                 job({"--between", "9", "--video", "disk/a.mp4"}));
    const Outcome outcome = ended(process);
    if (contentOf("names") != "ready\n" && contentOf("names") != "a.mp4\nready\n")
      QSKIP("no file system can be mounted here");
    QCOMPARE(outcome.status, 2);
    QVERIFY2(outcome.err.startsWith("hogelscope: disk/a.mp4: cannot be written: "), outcome.err);
    QCOMPARE(contentOf("names"), QByteArray("ready\n"));
  }

  void withoutFfmpeg() {
    const Outcome outcome = render({"--video", "a.mp4"});
    QCOMPARE(outcome.status, 2);
    QCOMPARE(outcome.err, QByteArray("hogelscope: ffmpeg: cannot be started: No such file or "
                                     "directory; it makes the video: install it\n"));
    QCOMPARE(namesIn("."), QStringList{"bin"});
  }

  void ffmpegFails() {
    standIn("cat > /dev/null\necho first >&2\necho Unknown encoder >&2\nexit 1\n");
    writeFile("a.mp4", "old");
    const Outcome outcome = render({"--video", "a.mp4"});
    QCOMPARE(outcome.status, 2);
    QCOMPARE(outcome.err, QByteArray("hogelscope: a.mp4: cannot be written: ffmpeg: Unknown "
                                     "encoder\n"));
    QCOMPARE(contentOf("a.mp4"), QByteArray("old"));
  }

  /// The stand-in never ends by itself.
  void ctrlCLeavesNothing() {
    standIn("cat > /dev/null\nwhile :; do sleep 0.1; done\n");
    QProcess process;
    begin(process, {"--video", "a.mp4"});
    QVERIFY(waitUntil(process, [] { return QFile::exists("out/Fig 6.png"); }));
    send(process, SIGINT);
    waitForEnd(process);
    QCOMPARE(process.exitStatus(), QProcess::CrashExit);
    QCOMPARE(namesIn("."), (QStringList{"bin", "out"}));
  }

  /// The stand-in never reads, and has started another program.
  void ctrlCEndsAStuckProgram() {
    standIn("sleep 600 &\necho $! > \"$0.pid\"\nsleep 600\n");
    QProcess process;
    begin(process, {"--video", "a.mp4"}, "camera.res=[410,300]");
    QVERIFY(waitUntil(process, [] { return QFile::exists("out/Fig 1.png"); }));
    QVERIFY(waitUntil(process, [] { return contentOf("bin/ffmpeg.pid").endsWith('\n'); }));
    send(process, SIGINT);
    waitForEnd(process);
    QVERIFY(!QFile::exists("out/Fig 6.png"));
    QCOMPARE(namesIn("."), (QStringList{"bin", "out"}));
    const pid_t other = contentOf("bin/ffmpeg.pid").trimmed().toInt();
    QTRY_VERIFY(::kill(other, 0) != 0 || isDead(other));
  }

  void endsTooEarly() {
    standIn("kill -9 $$\n");
    QCOMPARE(render({"--video", "a.mp4"}).err,
             QByteArray("hogelscope: a.mp4: cannot be written: ffmpeg: ended too early\n"));
    QVERIFY(!QFile::exists("a.mp4"));
  }

  void refusals_data() {
    QTest::addColumn<QStringList>("more");
    QTest::addColumn<QByteArray>("line");
    QTest::newRow("speed alone") << QStringList{"--fps", "3"} << QByteArray("--fps: belongs to");
    QTest::newRow("name") << QStringList{"--video", "a.avi"} << QByteArray("a.avi: cannot be");
    QTest::newRow("shard") << QStringList{"--video", "a.mp4", "--shard", "1/2"}
                           << QByteArray("--video: is of all pictures");
    QTest::newRow("format") << QStringList{"--video", "a.mp4", "--format", "exr"}
                            << QByteArray("--video: is of all pictures");
    QTest::newRow("input") << QStringList{"--video", "s.mp4"}
                           << QByteArray("s.mp4: cannot be written: it is");
    QTest::newRow("none") << QStringList{"--between", "0"} << QByteArray("--between: \"0\" is not");
    QTest::newRow("negative") << QStringList{"--between", "-3"}
                              << QByteArray("--between: \"-3\" is not");
    QTest::newRow("no number") << QStringList{"--between", "x"}
                               << QByteArray("--between: \"x\" is not");
    for (const char* speed : {"0", "-1", "nan", "1e9"})
      QTest::addRow("speed %s", speed) << QStringList{"--video", "a.mp4", "--fps", speed}
                                       << QByteArray("--fps: \"") + speed + "\" is not";
    QTest::newRow("no folder") << QStringList{"--video", "/proc/here/a.mp4"}
                               << QByteArray("/proc/here: cannot be");
    QTest::newRow("a folder") << QStringList{"--video", "bin/sub.mp4"}
                              << QByteArray("bin/sub.mp4: cannot be");
  }
  void refusals() {
    QFETCH(QStringList, more);
    QFETCH(QByteArray, line);
    standIn("cat > /dev/null\n");
    QVERIFY(QFile::link(sampleSession, "s.mp4"));
    QVERIFY(QDir().mkdir("bin/sub.mp4"));
    const Outcome outcome = render(more);
    QCOMPARE(outcome.status, 2);
    QVERIFY2(outcome.err.startsWith("hogelscope: " + line), outcome.err);
    QCOMPARE(namesIn("."), (QStringList{"bin", "s.mp4"}));
  }

 private:
  /// Returns an MP4 of boxes alone, whose first track has so many pictures.
  static QByteArray videoOf(char pictures) {
    const auto box = [](const QByteArray& type, const QByteArray& content) {
      const auto size = char(8 + content.size());
      return QByteArray(3, '\0') + size + type + content;
    };
    const QByteArray sizes = box("stsz", QByteArray(11, '\0') + pictures);
    QByteArray track = box("stbl", box("stsd", "") + sizes);
    for (const char* type : {"minf", "mdia", "trak", "moov"})
      track = box(type, box("free", "x") + track);
    return box("ftyp", "isom") + box("mdat", "pictures") + track;
  }
  /// Returns a line of a stand-in that makes a file of bin/ its video.
  static QByteArray copying(const QByteArray& name) {
    return "for last; do :; done\ncat \"${0%/*}/" + name + "\" > \"$last\"\n";
  }
  static QStringList job(const QStringList& more, const char* size = "camera.res=[41,30]") {
    return QStringList{"--render", "--session", sampleSession, "--output", "out", "--set", size} +
           more;
  }
  /// Returns the environment, with the stand-in alone in PATH if there is one or must be none.
  [[nodiscard]] QProcessEnvironment environment() const {
    QProcessEnvironment environment = withoutDisplay();
    const QByteArray test = QTest::currentTestFunction();
    if (test != "video" && test != "fullDisk")
      environment.insert("PATH", m_folder->filePath("bin"));
    return environment;
  }
  void begin(QProcess& process, const QStringList& more, const char* size = "camera.res=[41,30]") {
    process.setProcessEnvironment(environment());
    process.setWorkingDirectory(m_folder->path());
    process.start(HOGELSCOPE_PROGRAM, job(more, size));
  }
  Outcome render(const QStringList& more) {
    QProcess process;
    begin(process, more);
    return ended(process);
  }
  /// Whether nobody has waited for a killed process yet.
  static bool isDead(pid_t process) {
    return contentOf(QString("/proc/%1/stat").arg(process)).contains(") Z ");
  }
  /// Writes an ffmpeg that is a shell script.
  void standIn(const QByteArray& script) {
    writeFile("bin/ffmpeg", "#!/bin/sh\nPATH=/usr/bin:/bin\n" + script);
    QVERIFY(QFile::setPermissions("bin/ffmpeg", QFile::ReadOwner | QFile::ExeOwner));
  }

  std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(TestVideo)
#include "test_video.moc"
