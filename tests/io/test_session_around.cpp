// SPDX-License-Identifier: BSD-3-Clause
// Tests the new session that a light field opens with.
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "io/documents/session_file.h"
#include "io/opening/session_around.h"
#include "io/plugins/display_json.h"
#include "io/scene/view_source.h"
#include "tests/io/documents.h"
#include "tests/io/images.h"

using namespace hogelscope;

class TestSessionAround : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_folder;
  QString file(const char* name) const { return m_folder.filePath(name); }

 private Q_SLOTS:
  /// A size that is given with a file of raw YUV says how many views it has.
  void rawYuvWhoseSizeIsGiven() {
    writeFile(file("nine.yuv"), QByteArray(9 * 48 * 32 * 3 / 2, '\x60'));
    const std::string nine = file("nine.yuv").toStdString();
    QVERIFY(errorOf([&] { (void)sessionAround(nine); }).contains("yuvSize: is not given"));
    const Session session = sessionAround(nine, {"lightField.yuvSize=[48,32]"});
    QVERIFY(session.lightField.layout == Layout::views);
    QVERIFY((session.lightField.yuv.size == std::array{48, 32}));
    const ViewSource scene = loadViewSource(session, {});
    QVERIFY((scene.lightField->size() == LightFieldSize{48, 32, 3, 3}));
    const QString wrong =
        errorOf([&] { (void)sessionAround(nine, {"lightField.yuvSize=[48,34]"}); });
    QVERIFY2(wrong.contains("mend lightField.yuvSize"), qPrintable(wrong));
  }

  void aFolderOfViewsIsWhole() {
    for (const char* name : {"views/000_000.png", "views/000_001.png", "views/000_002.png",
                             "views/001_000.png", "views/001_001.png", "views/001_002.png"})
      writeGrey(file(name), 40, 10);
    const Session session = sessionAround(file("views").toStdString());
    check(session);
    QVERIFY(session.lightField.layout == Layout::views);
    QVERIFY((session.display.size == std::array{0.5, 0.125}));  // as wide and high as a view
    QCOMPARE(session.cameras.size(), std::size_t(1));
    const ViewSource scene = loadViewSource(session, {});
    QVERIFY((scene.lightField->size() == LightFieldSize{40, 10, 3, 2}));
    const Image image = simulate(scene.job(session.cameras[0]));
    QVERIFY(image.seen[std::size_t(300) * 600 + 300] > 0);
  }

  void aQuiltSaysItsViews() {
    writeGrey(file("q_qs4x3a0.5.png"), 80, 90);
    const Session session = sessionAround(file("q_qs4x3a0.5.png").toStdString());
    check(session);
    QVERIFY((loadViewSource(session, {}).lightField->size() == LightFieldSize{20, 30, 12, 1}));
    QCOMPARE(session.display.size[1], 0.5);
  }

  void overridesSayHowToReadAFolder() {
    for (const char* name : {"named/cam 2 1.png", "named/camera 1 1.png"})
      writeGrey(file(name), 40, 10);
    const std::string folder = file("named").toStdString();
    QVERIFY(errorOf([&] { (void)sessionAround(folder); }).contains("give lightField.pattern"));
    const Session session = sessionAround(
        folder, {"lightField.pattern=cam* CC RR.png", "display.size=[0.3,0.1]", "camera.fov=33"});
    QVERIFY((session.display.size == std::array{0.3, 0.1}));
    QCOMPARE(session.cameras.front().camera.fov, 33.0);
    QVERIFY((loadViewSource(session, {}).lightField->size() == LightFieldSize{40, 10, 2, 1}));
  }

  void aHogelImageNeedsItsHogels() {
    writeGrey(file("hogels.png"), 80, 40);
    Session session = sessionAround(file("hogels.png").toStdString());
    QVERIFY(session.lightField.layout == Layout::hogels);
    QVERIFY((session.display.size == std::array{0.5, 0.25}));
    const QString error = errorOf([&] { (void)loadViewSource(session, {}); });
    QVERIFY2(error.contains("is 80×40 px; how many of them are hogels"), qPrintable(error));
    session.display.hogels = {8, 4};
    session.display.directions = {10, 10};
    check(session);
    (void)loadViewSource(session, {});
    session.display.directions = {10, 0};
    QVERIFY(errorOf([&] { check(session); }).startsWith("display.directions: has one number"));
  }

  void hogelsAreFoundInThePicture_data() {
    QTest::addColumn<int>("nx");
    QTest::addColumn<int>("ny");
    QTest::addColumn<int>("du");
    QTest::addColumn<int>("dv");
    QTest::addColumn<double>("depth");
    QTest::addColumn<QString>("name");
    int index = 0;
    for (const double depth : {-0.3, -0.11, 0.0, 0.12}) {
      for (const auto& [nx, ny, du, dv] : {std::array{40, 30, 24, 18},
                                           {50, 30, 21, 15},
                                           {30, 40, 8, 8},
                                           {24, 20, 16, 32},
                                           {100, 60, 5, 3},
                                           {11, 13, 40, 10}}) {
        // Half of them, so that each shape meets two depths and both formats, and each depth three
        // shapes and both formats.
        const int layer = index / 6;
        const int shape = index++ % 6;
        if ((layer + shape) % 2 == 0) continue;
        const char* name = (layer / 2 + shape / 2) % 2 == 0 ? "g.png" : "g.jpg";
        QTest::addRow("%d %d %d %d at %g, %s", nx, ny, du, dv, depth, name)
            << nx << ny << du << dv << depth << QString(name);
      }
    }
  }

  /// A wall with texture and noise, as a display would show it; JPEG at its usual quality.
  void hogelsAreFoundInThePicture() {
    QFETCH(const int, nx);
    QFETCH(const int, ny);
    QFETCH(const int, du);
    QFETCH(const int, dv);
    QFETCH(const double, depth);
    QFETCH(const QString, name);
    const auto light = [&](int px, int py, int channel) {
      const double x = (px / du + 0.5) / nx - 0.5 + depth * ((px % du + 0.5) / du - 0.5);
      const double y = (py / dv + 0.5) / ny - 0.5 - depth * ((py % dv + 0.5) / dv - 0.5);
      const double texture = std::sin(31 * x + 5 * y + channel) + std::sin(17 * y - 8 * x) +
                             0.5 * std::sin(90 * x * y + 40 * y);
      const double noise = double((px * 7919 + py * 104729 + channel * 31) % 97) / 97;
      return float(0.5 + 0.15 * texture + 0.01 * noise);
    };
    writeImageFile(file(qPrintable(name)), nx * du, ny * dv, light);
    const OrderedSession around = orderedSessionAround(file(qPrintable(name)).toStdString());
    QVERIFY((around.session.display.hogels == std::array{nx, ny}));
    QVERIFY((around.session.display.directions == std::array{du, dv}));
    QCOMPARE(around.assumed, std::to_string(nx) + "×" + std::to_string(ny) + " hogels of " +
                                 std::to_string(du) + "×" + std::to_string(dv) +
                                 " directions, found by their borders in the picture");
    (void)loadViewSource(around.session, {});
  }

  /// What is on the panel repeats four times across and three times down, as tiles of views do.
  void hogelsOfContentThatRepeats() {
    writeImageFile(file("r.png"), 960, 540, [](int px, int py, int channel) {
      const double x = (px / 24 + 0.5) / 10 + 0.4 * ((px % 24 + 0.5) / 24 - 0.5);
      const double y = (py / 18 + 0.5) / 10 - 0.4 * ((py % 18 + 0.5) / 18 - 0.5);
      const double turn = 2 * 3.14159265358979;
      const double texture = std::sin(turn * (x + y) + channel) + std::sin(turn * (2 * y - x)) +
                             0.5 * std::sin(turn * 3 * x);
      const double noise = double((px * 7919 + py * 104729 + channel * 31) % 97) / 97;
      return float(0.5 + 0.15 * texture + 0.01 * noise);
    });
    const OrderedSession around = orderedSessionAround(file("r.png").toStdString());
    QVERIFY(around.session.lightField.layout == Layout::hogels);
    QCOMPARE(around.session.display.hogels, (std::array{40, 30}));
  }

  /// Noise and a photograph's like have none, and what is said counts.
  void whereThereAreNoHogels() {
    for (int seed = 0; seed < 20; ++seed) {
      const auto noise = [seed](int x, int y, int c) {
        return float((x * 7919 + y * 104729 + x * y * 31 + c * 7 + seed * 1009) % 251) / 251;
      };
      writeImageFile(file("n.png"), 240, 180, noise);
      QCOMPARE(orderedSessionAround(file("n.png").toStdString()).assumed, std::string());
    }
    writeImageFile(file("flat.png"), 60, 40, [](int, int, int) { return 0.5F; });
    QCOMPARE(orderedSessionAround(file("flat.png").toStdString()).assumed, std::string());
    const OrderedSession said = orderedSessionAround(
        file("n.png").toStdString(), {"display.hogels=[24,18]", "display.directions=[10,10]"});
    QCOMPARE(said.assumed, std::string());
    QVERIFY((said.session.display.hogels == std::array{24, 18}));
  }

  /// The blocks of a JPEG are no hogels, at any quality, also where it was decoded and scaled.
  void blocksAreNoHogels() {
    const auto photograph = [](int x, int y, int c) {
      const double texture = std::sin(0.031 * x + 0.005 * y + c) + std::sin(0.017 * y - 0.008 * x) +
                             0.5 * std::sin(0.00009 * x * y + 0.04 * y) +
                             (std::hypot(x - 200, y - 100) < 60 ? 0.8 : 0.0);
      const double noise = double((x * 7919 + y * 104729 + c * 31) % 97) / 97;
      return float(0.5 + 0.15 * texture + 0.04 * noise);
    };
    writeImageFile(file("p.png"), 480, 320, photograph);
    const QImage picture(file("p.png"));
    for (const int quality : {5, 8, 12, 20, 35, 50, 75, 95}) {
      QVERIFY(picture.save(file("p.jpg"), nullptr, quality));
      const QImage decoded(file("p.jpg"));
      QVERIFY(decoded.save(file("decoded.png")));
      QVERIFY(decoded.scaled(960, 640).save(file("enlarged.png")));
      QVERIFY(decoded.scaled(240, 160, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                  .save(file("reduced.png")));
      for (const char* name : {"p.jpg", "decoded.png", "enlarged.png", "reduced.png"}) {
        const OrderedSession around = orderedSessionAround(file(name).toStdString());
        QVERIFY2(around.hogels == Sureness::unknown && around.assumed.empty(),
                 qPrintable(QString("%1 of quality %2: %3")
                                .arg(name)
                                .arg(quality)
                                .arg(around.assumed.c_str())));
      }
    }
  }

  void whatIsNoPictureIsTold() {
    QVERIFY(
        errorOf([&] { (void)sessionAround(file("none.png").toStdString()); }).contains("none.png"));
    QDir(m_folder.path()).mkdir("empty");
    QVERIFY(errorOf([&] { (void)sessionAround(file("empty").toStdString()); }).contains("empty"));
  }

  void onlySomeEditsNeedReading() {
    Session a;
    a.display.hogels = {8, 4};
    Session b = a;
    b.display.position = {1, 2, 3};
    b.display.size = {1, 2};
    b.display.fov = {20, 30};
    b.display.lens = HogelLensModel::equiangular;
    b.sampling.samplesPerPixel = 3;
    b.cameras.resize(4);
    QVERIFY(readTheSame(a, b));
    Session c = b;
    c.display.hogels = {8, 5};
    QVERIFY(!readTheSame(a, c));
    c = b;
    c.display.directions = {3, 3};
    QVERIFY(!readTheSame(a, c));
    c = b;
    c.lightField.incoming = true;
    QVERIFY(!readTheSame(a, c));
  }

  void aLiveSceneHasTheDisplaysRays() {
    Session a;
    a.lightField.layout = Layout::live;
    Session b = a;
    b.display.position = {1, 2, 3};
    QVERIFY(readTheSame(a, b));
    b.display.size = {1, 2};
    QVERIFY(!readTheSame(a, b));
    b = a;
    b.display.fov = {20, 30};
    QVERIFY(!readTheSame(a, b));
    b = a;
    b.display.lens = HogelLensModel::equiangular;
    QVERIFY(!readTheSame(a, b));
    a.display.lens = HogelLensModel::plugin;
    a.display.lensParams = lensParamsOf("measured-lens");
    b = a;
    QVERIFY(readTheSame(a, b));
    b.display.lensParams.set("file", std::string("lens.csv"));
    QVERIFY(!readTheSame(a, b));
    b = a;
    b.lightField.viewingDistance = 2;
    QVERIFY(!readTheSame(a, b));
  }

  /// 4 wide, 2 high, at depths 1 and 5 of the file, beside its origin. A tenth of the panel's side
  /// stands before it. The nearest point is in the middle across, so all of the scale is left that
  /// its height there allows: 1 · s = 0.1125 (1 − 0.05 / 0.559).
  void aDisplayFitsAMesh() {
    writeFile(file("a.obj"), "v 10 0 1\nv 14 0 1\nv 10 2 5\nf 1 2 3\n");
    const Session session = sessionAround(file("a.obj").toStdString());
    check(session);
    QVERIFY(session.lightField.layout == Layout::live && session.lightField.source == "mesh");
    QCOMPARE(contentName(session.lightField), file("a.obj").toStdString());
    QVERIFY((session.display.size == std::array{0.5, 0.25}));
    QVERIFY((session.display.hogels == std::array{256, 128}));
    QVERIFY((session.display.directions == std::array{100, 100}));
    const ViewSource scene = loadViewSource(session, {});
    const std::vector<float> points = scene.lightField->scene()->triangles().points;
    const auto s = float(0.1125 * (1 - 0.05 / 0.559));
    const std::vector<float> wanted{-2 * s, -s, 0.05F - 4 * s, 2 * s, -s, 0.05F - 4 * s,
                                    -2 * s, s,  0.05F};
    QCOMPARE(points.size(), wanted.size());
    for (std::size_t k = 0; k < points.size(); ++k)
      QVERIFY(std::abs(points[k] - wanted[k]) < 1e-3F);  // tenths of a millimetre
    saveSession(file("saved.json").toStdString(), session);
    QVERIFY((loadSession(file("saved.json").toStdString()).display == session.display));
  }

  /// Long towards the viewer, wide in front, wide behind, or flat: the eye sees all of it within
  /// the panel, near its edges, and most of its depth is behind.
  void allOfAMeshIsSeen() {
    const std::vector<std::pair<QByteArray, double>> meshes{
        {"v -1 -1 0\nv 1 1 0\nv 0 0 30\nf 1 2 3\n", 0.06},
        {"v 0 0 0\nv -2 -1 9\nv 2 1 9\nf 1 2 3\n", 0.895},
        {"v -1 -4 0\nv 1 4 -3\nv 0 0.5 3\nf 1 2 3\n", 0.7},
        {"v -1 0 2\nv 1 0 2\nv 0 1 2\nf 1 2 3\n", 0.895}};
    for (const auto& [mesh, least] : meshes) {
      writeFile(file("b.obj"), mesh);
      const Session session = sessionAround(file("b.obj").toStdString());
      const ViewSource scene = loadViewSource(session, {});
      const Vec3 eye = session.cameras.front().camera.eye;
      const std::vector<float> points = scene.lightField->scene()->triangles().points;
      double filled = 0;
      double back = 9;
      double front = -9;
      for (std::size_t k = 0; k < points.size(); k += 3) {
        const double share = eye.z / (eye.z - points[k + 2]);
        filled = std::max({filled, std::abs(points[k]) * share / session.display.size[0] * 2,
                           std::abs(points[k + 1]) * share / session.display.size[1] * 2});
        back = std::min(back, double(points[k + 2]));
        front = std::max(front, double(points[k + 2]));
      }
      QVERIFY2(filled > least && filled < 0.905, qPrintable(mesh + QByteArray::number(filled)));
      QVERIFY(front >= 0 && front < 0.0501 && front <= 0.3 * (front - back) + 1e-4);
      QCOMPARE(
          openLightField(session.lightField, session.display)->cutWarning(session.cameras.front()),
          std::string());
    }
  }

  /// Before the panel a card 0.6 m wide ends at its sides; behind it, nothing does.
  void cutsAreTold() {
    writeFile(file("c.obj"), "v -0.3 -0.1 0\nv 0.3 -0.1 0\nv 0.3 0.1 0\nv -0.3 0.1 0\nf 1 2 3 4\n");
    Session session = sessionAround(file("c.obj").toStdString());
    session.display.size = {0.5, 0.5};
    session.lightField.content.set("scale", std::vector<double>{1});
    const auto warning = [&](double z, double x = 0) {
      session.lightField.content.set("position", std::vector<double>{x, 0, z});
      return openLightField(session.lightField, session.display)->cutWarning(session.cameras[0]);
    };
    const std::string rest = "): move the content back, or make it smaller";
    QCOMPARE(warning(0.05), "View: the panel cuts what stands before it (left, right" + rest);
    QCOMPARE(warning(0.05, 0.2), "View: the panel cuts what stands before it (right" + rest);
    QCOMPARE(warning(-0.05), std::string());
    QCOMPARE(warning(0.001), std::string());  // less than a hogel's width
    session.display.size = {0.7, 0.18};
    QCOMPARE(warning(0.05), "View: the panel cuts what stands before it (upper, lower" + rest);
    session.cameras[0].camera.eye = {0, 0, -1};
    QCOMPARE(warning(0.05), std::string());
  }

  void kindsOfMeshesThatAreNotRead() {
    writeFile(file("a.stl"), "solid");
    QCOMPARE(errorOf([&] { (void)sessionAround(file("a.stl").toStdString()); }),
             file("a.stl") +
                 ": is a mesh of a kind that is not read: export it as .glb, .gltf, "
                 ".obj or .ply");
  }

  void aMeshThatNoDisplayFits() {
    writeFile(file("far.obj"), "v 1e5 0 0\nv 1e5 1 0\nv 100001 1 0\nf 1 2 3\n");
    const QString error = errorOf([&] { (void)sessionAround(file("far.obj").toStdString()); });
    QVERIFY2(error.contains("far.obj: is no mesh that a panel fits"), qPrintable(error));
    QVERIFY(
        errorOf([&] { (void)sessionAround(file("none.ply").toStdString()); }).contains("none.ply"));
  }

  void anotherFileKeepsTheLayout() {
    writeGrey(file("views2/000_000.png"), 4, 4);
    LightFieldParams quilt;
    quilt.layout = Layout::quilt;
    quilt.quiltColumns = 7;
    const LightFieldParams other = withFile(quilt, "other.png");
    QVERIFY(other.layout == Layout::quilt && other.quiltColumns == 7);
    const LightFieldParams folder = withFile(quilt, file("views2").toStdString());
    QVERIFY(folder.layout == Layout::views && folder.quiltColumns == 0);
    QVERIFY(withFile(folder, "other.png").layout == Layout::hogels);
    QVERIFY(withFile(folder, "a_qs2x2a1.png").layout == Layout::quilt);
  }
};

QTEST_GUILESS_MAIN(TestSessionAround)
#include "test_session_around.moc"
