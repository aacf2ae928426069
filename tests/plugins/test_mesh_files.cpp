// SPDX-License-Identifier: BSD-3-Clause
// Tests what the mesh plugin reads of glTF, OBJ and PLY, and with which line it refuses the rest.
#include <QTest>
#include <cmath>

#include "mesh_reader.h"
#include "tests/plugins/mesh_scene.h"

using namespace hogelscope;
using namespace hogelscope::test;

namespace {

const std::string plyHeader =
    "element vertex 3\nproperty float x\nproperty float y\n"
    "property float z\n";
const std::string plyFace = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

Gltf oneTriangle() {
  Gltf gltf;
  gltf.triangles({0, 0, 0, 1, 0, 0, 0, 1, 0});
  return gltf;
}

bool isNear(const Vec3& a, const Vec3& b) {
  return length(a - b) < 1e-6;
}

}  // namespace

class TestMeshFiles : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nodesStandInEachOther();
  void modesAndIndices();
  void sparseAccessors();
  void buffersBesideTheFile();
  void objHasMaterials();
  void plyOfEachFormat();
  void plyHasStrips();
  void plyHasPictures_data();
  void plyHasPictures();
  void plyHasColouredFaces();
  void plyNotes_data();
  void plyNotes();
  void objFromWindows_data();
  void objFromWindows();
  void optionsOfPictures();
  void namesWhatItRead();
  void readsAgainWhatHasChanged();
  void stopsWhenAsked();
  void refuses_data();
  void refuses();
  void refusesBrokenGltf_data();
  void refusesBrokenGltf();
  void survivesDamage_data();
  void survivesDamage();
  void shapesOfTheScene();
};

void TestMeshFiles::nodesStandInEachOther() {
  Gltf gltf;
  gltf.triangles({1, 0, 0, 0, 1, 0, 0, 0, 1});
  gltf.json["nodes"][0]["translation"] = {0, 0, 5};
  const double half = std::sqrt(0.5);
  gltf.json["nodes"].push_back({{"children", {0}},
                                {"rotation", {0, 0, half, half}},  // 90° about z
                                {"scale", {2, 3, 4}},
                                {"translation", {10, 0, 0}}});
  gltf.json["scenes"][0]["nodes"] = {1};
  Scene scene;
  scene.add("a.glb", gltf.glb());
  const mesh::Mesh mesh = scene.read("a.glb");
  QVERIFY(isNear(mesh.points[0], {10, 2, 20}));
  QVERIFY(isNear(mesh.points[1], {7, 0, 20}));
  QVERIFY(isNear(mesh.points[2], {10, 0, 24}));
}

void TestMeshFiles::modesAndIndices() {
  Gltf gltf;
  gltf.triangles({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  Json& primitive = gltf.json["meshes"][0]["primitives"][0];
  Scene scene;
  const auto count = [&](int mode, const std::vector<std::uint8_t>& indices) {
    primitive["mode"] = mode;
    primitive["indices"] = gltf.accessor(indices, 5121, "SCALAR", 1);
    scene.add("a.glb", gltf.glb());
    return scene.read("a.glb").triangles;
  };
  QCOMPARE(count(4, {0, 1, 2, 0, 2, 3}), (std::vector<mesh::Corners>{{0, 1, 2}, {0, 2, 3}}));
  QCOMPARE(count(5, {0, 1, 3, 2}), (std::vector<mesh::Corners>{{0, 1, 3}, {1, 3, 2}}));
  QCOMPARE(count(6, {0, 1, 2, 3}), (std::vector<mesh::Corners>{{0, 1, 2}, {0, 2, 3}}));
}

void TestMeshFiles::sparseAccessors() {
  Gltf gltf = oneTriangle();
  const int places = gltf.view(bytesOf(std::vector<std::uint8_t>{2}));
  const int values = gltf.view(bytesOf(std::vector<float>{7, 8, 9}));
  gltf.json["accessors"][0]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", places}, {"componentType", 5121}}},
      {"values", {{"bufferView", values}}}};
  Scene scene;
  scene.add("a.glb", gltf.glb());
  QVERIFY(isNear(scene.read("a.glb").points[2], {7, 8, 9}));
}

void TestMeshFiles::buffersBesideTheFile() {
  Gltf gltf = oneTriangle();
  gltf.json["buffers"] = {{{"byteLength", 36}, {"uri", "the%20points.bin"}}};
  Scene scene;
  scene.add("a.gltf", gltf.json.dump());
  scene.add("the points.bin", gltf.binary);
  const mesh::Mesh mesh = scene.read("a.gltf");
  QCOMPARE(mesh.files, (std::vector{scene.path("a.gltf"), scene.path("the points.bin")}));
  gltf.json["buffers"][0]["uri"] = "data:application/octet-stream;base64," +
                                   QByteArray::fromStdString(gltf.binary).toBase64().toStdString();
  scene.add("b.gltf", gltf.json.dump());
  QCOMPARE(scene.read("b.gltf").points, mesh.points);
}

void TestMeshFiles::objHasMaterials() {
  Scene scene;
  scene.add("a.mtl",
            "newmtl red\nKd 1 0 0\nKe 0 1 0\nnewmtl picture\nmap_Kd a.png\nmap_Ke a.png\n");
  scene.add("a.png", makePng(1, 1, {9, 8, 7}));
  scene.add("a.obj",
            "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.25 0.25\nvn 0 0 2\n"
            "usemtl red\nf 1 2 3 4\nusemtl picture\nf -4/1/1 -3/1/1 \\\n-2/1/1\n");
  const mesh::Mesh mesh = scene.read("a.obj");
  QCOMPARE(mesh.triangles, (std::vector<mesh::Corners>{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}}));
  QCOMPARE(mesh.materialOf, (std::vector<std::uint32_t>{1, 1, 2}));
  QCOMPARE(mesh.materials[1].colour, (mesh::Linear{1, 0, 0}));
  QCOMPARE(mesh.materials[1].emission, (mesh::Linear{0, 1, 0}));
  QCOMPARE(mesh.materials[2].layer.texture, 0);
  QCOMPARE(mesh.materials[2].glow.texture, 0);
  QCOMPARE(mesh.materials[2].emission, (mesh::Linear{1, 1, 1}));
  QCOMPARE(mesh.uv[4], (std::array<float, 2>{0.25F, 0.75F}));
  QCOMPARE(mesh.normals[4], (std::array<float, 3>{0, 0, 1}));
  QCOMPARE(mesh.files.size(), std::size_t(3));
}

void TestMeshFiles::plyOfEachFormat() {
  const std::string header =
      plyHeader + "property uchar red\nproperty uchar green\nproperty uchar blue\n" + plyFace;
  const std::vector<std::array<float, 3>> points{{0, 0, 0}, {1, 0.5F, 0}, {0, 1, -2}};
  std::string little;
  std::string big;
  const auto append = [&](std::string bytes) {
    little += bytes;
    std::reverse(bytes.begin(), bytes.end());
    big += bytes;
  };
  for (const auto& point : points) {
    for (const float x : point) append(bytesOf(std::vector{x}));
    for (const char code : {'\xFF', '\x80', '\0'}) append({code});
  }
  append({'\3'});
  for (const int k : {0, 1, 2}) append(bytesOf(std::vector{k}));
  Scene scene;
  scene.add("a.ply", "ply\nformat ascii 1.0\ncomment none\n" + header +
                         "0 0 0 255 128 0\n1 .5 0 255 128 0\n0 1 -2 255 128 0\n3 0 1 2\n");
  scene.add("l.ply", "ply\nformat binary_little_endian 1.0\n" + header + little);
  scene.add("b.ply", "ply\nformat binary_big_endian 1.0\n" + header + big);
  for (const char* name : {"a.ply", "l.ply", "b.ply"}) {
    const mesh::Mesh mesh = scene.read(name);
    QCOMPARE(mesh.points, (std::vector<Vec3>{{0, 0, 0}, {1, 0.5, 0}, {0, 1, -2}}));
    QCOMPARE(mesh.triangles, (std::vector<mesh::Corners>{{0, 1, 2}}));
    QCOMPARE(mesh.colours[2][0], 1.0F);
    QVERIFY(std::abs(mesh::codeOf(mesh.colours[2][1]) - 128) < 0.01F);
  }
}

/// As Stanford's own models: all strips in one list, each but the last followed by -1.
void TestMeshFiles::plyHasStrips() {
  Scene scene;
  scene.add("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
            "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
            "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n1 2 0\n"
            "12 0 1 2 3 -1 -1 4 5 -1 3 4 5\n");
  const mesh::Mesh mesh = scene.read("a.ply");
  QCOMPARE(mesh.triangles, (std::vector<mesh::Corners>{{0, 1, 2}, {1, 2, 3}, {3, 4, 5}}));
  QCOMPARE(mesh.notes.size(), std::size_t(0));
}

void TestMeshFiles::plyHasPictures_data() {
  QTest::addColumn<QString>("points");
  QTest::addColumn<QString>("faces");
  QTest::addColumn<QString>("rows");
  const char* const triangles = "property list uchar int vertex_indices\n";
  const char* const corners = "property list uchar float texcoord\n";
  const QString plain = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  for (const char* names : {"s t", "u v", "texture_u texture_v"}) {
    const QString both(names);
    QTest::newRow(names) << QString("property float %1\nproperty float %2\n")
                                .arg(both.section(' ', 0, 0), both.section(' ', 1, 1))
                         << triangles
                         << "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n3 0 1 2\n3 0 2 3\n";
  }
  QTest::newRow("corners") << "" << QString(triangles) + corners
                           << plain + "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 1 1 0 1\n";
  QTest::newRow("before the points' indices")
      << "" << QString(corners) + triangles
      << plain + "6 0 0 1 0 1 1 3 0 1 2\n6 0 0 1 1 0 1 3 0 2 3\n";
  QTest::newRow("numbered pictures")
      << "" << QString(triangles) + corners + "property int texnumber\n"
      << plain + "3 0 1 2 6 0 0 1 0 1 1 1\n3 0 2 3 6 0 0 1 1 0 1 1\n";
}

/// Four texels, seen near their middles; the lower left one is at the origin.
void TestMeshFiles::plyHasPictures() {
  QFETCH(const QString, points);
  QFETCH(const QString, faces);
  QFETCH(const QString, rows);
  const bool isSecond = faces.contains("texnumber");
  Scene scene;
  scene.add("skin.png", makePng(2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 0}));
  scene.add("grey.png", makePng(1, 1, {9, 9, 9}));
  scene.add("a.ply", "ply\nformat ascii 1.0\n" +
                         std::string(isSecond ? "comment TextureFile grey.png\n" : "") +
                         "comment TextureFile Skin.PNG\nelement vertex 4\nproperty float x\n"
                         "property float y\nproperty float z\n" +
                         points.toStdString() + "element face 2\n" + faces.toStdString() +
                         "end_header\n" + rows.toStdString());
  const mesh::Mesh mesh = scene.read("a.ply");
  QCOMPARE(mesh.notes, std::vector<std::string>());
  QCOMPARE(mesh.files.back(), scene.path("skin.png"));
  scene.open({{"file", "a.ply"}, {"shading", "unlit"}, {"scale", 0.1}});
  const auto isColour = [&](double x, double y, float r, float g, float b) {
    const plugin::Colour seen = scene.see(x, y);
    return std::abs(seen.r - r) + std::abs(seen.g - g) + std::abs(seen.b - b) < 30;
  };
  QVERIFY(isColour(0.025, 0.0751, 255, 0, 0));
  QVERIFY(isColour(0.075, 0.0751, 0, 255, 0));
  QVERIFY(isColour(0.025, 0.0249, 0, 0, 255));
  QVERIFY(isColour(0.075, 0.0249, 255, 255, 0));
}

/// A polygon's colour, on points that its neighbour has too.
void TestMeshFiles::plyHasColouredFaces() {
  Scene scene;
  scene.add("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
            "property float z\nelement face 2\nproperty list uchar int vertex_indices\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"
            "0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n"
            "4 0 1 4 3 255 0 0\n4 1 2 5 4 0 0 255\n");
  scene.open({{"file", "a.ply"}, {"shading", "unlit"}, {"scale", 0.1}});
  QCOMPARE(scene.see(0.05, 0.06).r, 255.0F);
  QCOMPARE(scene.see(0.05, 0.06).b, 0.0F);
  QCOMPARE(scene.see(0.15, 0.06).b, 255.0F);
  QCOMPARE(scene.see(0.15, 0.06).r, 0.0F);
}

void TestMeshFiles::plyNotes_data() {
  QTest::addColumn<QString>("comment");
  QTest::addColumn<QString>("faces");
  QTest::addColumn<QString>("row");
  QTest::addColumn<QString>("note");
  const QString corners = "property list uchar float texcoord\n";
  QTest::newRow("no picture") << "comment TextureFile none.png\n"
                              << corners << "6 0 0 1 0 1 1"
                              << "Its picture none.png is not shown: there is no file none.png.";
  QTest::newRow("another format") << "comment TextureFile a.ply\n"
                                  << corners << "6 0 0 1 0 1 1"
                                  << "Its picture a.ply is not shown: it is neither PNG nor JPEG.";
  QTest::newRow("no places")
      << "comment TextureFile a b.png\n"
      << ""
      << ""
      << "Its picture a b.png is not shown: no texture coordinates are there.";
  QTest::newRow("places alone") << "" << corners << "6 0 0 1 0 1 1"
                                << "Its faces' properties texcoord are not shown.";
  QTest::newRow("other properties") << ""
                                    << "property uchar flags\n"
                                    << "7"
                                    << "Its faces' properties flags are not shown.";
}
/// What is not shown is told.
void TestMeshFiles::plyNotes() {
  QFETCH(const QString, comment);
  QFETCH(const QString, faces);
  QFETCH(const QString, row);
  QFETCH(const QString, note);
  Scene scene;
  scene.add("a.ply", ("ply\nformat ascii 1.0\n" + comment).toStdString() + plyHeader +
                         "element face 1\nproperty list uchar int vertex_indices\n" +
                         faces.toStdString() + "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 " +
                         row.toStdString() + "\n");
  std::vector<std::string> notes = scene.read("a.ply").notes;
  QCOMPARE(notes.size(), std::size_t(1));
  const std::string folder = scene.path("");
  if (const std::size_t at = notes[0].find(folder); at != std::string::npos)
    notes[0].erase(at, folder.size());
  QCOMPARE(QString::fromStdString(notes[0]), note);
}

void TestMeshFiles::objFromWindows_data() {
  QTest::addColumn<QString>("library");
  QTest::addColumn<QString>("picture");
  QTest::addColumn<bool>("isElsewhere");
  const auto add = [](const char* library, const char* picture, bool isElsewhere = false) {
    QTest::newRow(qPrintable(QString(library) + " " + picture))
        << library << picture << isElsewhere;
  };
  add("my scene.mtl", "textures/my wood.png");
  add(".\\my scene.mtl", "textures\\my wood.png");
  add("My Scene.MTL", "Textures\\My Wood.PNG");
  add("\"my scene.mtl\"", "\"textures\\my wood.png\"");
  add("my scene.mtl", ".\\none\\..\\..\\x\\textures\\my wood.png", true);
  add("my scene.mtl", "C:\\Users\\me\\textures\\my wood.png", true);
  add("my scene.mtl", "/home/me/textures/my wood.png", true);
  add("my scene.mtl", "-s 1 1 1 -o 0 0 -clamp off -bm 1 textures/my wood.png");
  add("other.mtl my_scene.mtl", "textures/my wood.png");
}
void TestMeshFiles::objFromWindows() {
  QFETCH(const QString, library);
  QFETCH(const QString, picture);
  QFETCH(const bool, isElsewhere);
  Scene scene;
  QVERIFY(QDir(QString::fromStdString(scene.path(""))).mkdir("textures"));
  scene.add("textures/my wood.png", makePng(1, 1, {255, 128, 64}));
  const std::string materials =
      "newmtl My Wood\r\nKd 1 1 1\r\nmap_Kd \\ \r\n " + picture.toStdString() + "\r\n";
  scene.add("my scene.mtl", materials);
  scene.add("my_scene.mtl", materials);
  scene.add("other.mtl", "newmtl other\r\n");
  scene.add("a.obj", "# written to C:\\temp\\\r\nmtllib " + library.toStdString() +
                         "\r\nv 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nvt 0 0\r\n"
                         "usemtl My Wood\r\nf -4/1 -3/1 \\\r\n -2/1 -1/1\r\n");
  const mesh::Mesh mesh = scene.read("a.obj");
  QCOMPARE(mesh.triangles.size(), std::size_t(2));
  QCOMPARE(mesh.notes.size(), std::size_t(isElsewhere));
  scene.open({{"file", "a.obj"}, {"shading", "unlit"}, {"scale", 0.1}});
  QCOMPARE(scene.see(0.05, 0.06).r, 255.0F);
  QVERIFY(std::abs(scene.see(0.05, 0.06).g - 128) < 0.5F);
}

/// -s and -o scale and shift coordinates, whose v points up; others are refused by name.
void TestMeshFiles::optionsOfPictures() {
  Scene scene;
  scene.add("a.png", makePng(1, 1, {9, 8, 7}));
  const std::string triangle = "mtllib a.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto with = [&](const std::string& options) {
    scene.add("a.mtl", "newmtl a\nmap_Kd " + options + " a.png\n");
    return scene.refusal("a.obj", triangle);
  };
  QCOMPARE(with("-s 2 3 -o 0.25 0.5 -clamp on"), std::string());
  const mesh::Layer layer = scene.read("a.obj").materials[1].layer;
  QCOMPARE(layer.wrap[1], mesh::Wrap::clamp);
  const double u = 0.4, v = 0.3;  // of the file
  const Vec2 at = layer.place({float(u), float(1 - v)});
  QVERIFY(std::abs(at.x - (2 * u + 0.25)) < 1e-6);
  QVERIFY(std::abs(at.y - (1 - (3 * v + 0.5))) < 1e-6);
  QCOMPARE(with("-bm 2"), std::string("a.mtl: line 2: option -bm of map_Kd is not supported"));
  QCOMPARE(with("-t 1 0 0"), std::string("a.mtl: line 2: option -t of a picture is not supported"));
}

void TestMeshFiles::namesWhatItRead() {
  Scene scene;
  scene.open(oneTriangle());
  QCOMPARE(scene.source.files(), std::vector{scene.path("scene.glb")});
}

void TestMeshFiles::readsAgainWhatHasChanged() {
  Scene scene;
  scene.open(oneTriangle());
  Gltf other = oneTriangle();
  other.triangles({0, 0, 3, 1, 0, 3, 0, 1, 3});
  scene.open(other, {{"position", {0, 0, 1}}});
  double back = 0;
  double front = 0;
  scene.source.depths(back, front);
  QCOMPARE(back, 1.0);
  QCOMPARE(front, 4.0);
  QVERIFY(!scene.refusal("scene.glb", "damaged").empty());
  QCOMPARE(scene.depth(Scene::down(0.2, 0.2)), 1.0);  // what was shown before
}

void TestMeshFiles::stopsWhenAsked() {
  struct Stopping : plugin::Progress {
    [[nodiscard]] bool go(double done) const override { return done < 0.2; }
  };
  Scene scene;
  std::string points;
  for (int k = 0; k < 200000; ++k) points += "v 0 0 0\n";
  scene.add("a.obj", points + "f 1 2 4000000000\n");
  QVERIFY_EXCEPTION_THROWN(mesh::readMesh(scene.path("a.obj"), memory, Stopping{}),
                           std::runtime_error);
  try {
    (void)mesh::readMesh(scene.path("a.obj"), memory, Stopping{});
  } catch (const std::runtime_error& error) {
    QCOMPARE(QString(error.what()), QString("stopped"));  // not the wrong face at its end
  }
}

void TestMeshFiles::refuses_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QByteArray>("bytes");
  QTest::addColumn<QString>("line");
  const auto add = [](const char* name, const std::string& bytes, const char* line) {
    QTest::newRow(qPrintable(QString(name) + " " + line))
        << name << QByteArray::fromStdString(bytes) << line;
  };
  add("a.stl", "solid", "a.stl: is no known kind of mesh: use .gltf, .glb, .obj or .ply");
  add("a.glb", "", "a.glb: is not glTF: its JSON is damaged");
  add("a.glb", oneTriangle().glb().substr(0, 200),
      "a.glb: is damaged: it ends before its last chunk");
  add("a.glb", std::string(500, 'x'), "a.glb: is not glTF: its JSON is damaged");
  add("a.gltf", "[]", "a.gltf: is not glTF: its JSON is no object");
  add("a.gltf", "{\"asset\": {\"version\": \"1.0\"}}", "a.gltf: asset.version: must be \"2.0\"");
  add("a.obj", "v 0 0 0\nv 1 0 0\n",
      "a.obj: has no faces: a surface of triangles is needed, not points or lines alone");
  add("a.obj", "v 0 0 0\nf 1 2 3\n", "a.obj: line 2: a face names entry 2 of 1");
  add("a.obj", "v 0 0 0\nf 1 1\n", "a.obj: line 2: a face needs three corners");
  add("a.obj", "v 0 zero 0\n", "a.obj: line 1: v needs three numbers");
  add("a.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj: point 0: is NaN or infinite");
  add("a.obj", "usemtl red\n", "a.obj: line 1: no .mtl file has the material red");
  add("a.obj", "mtllib b.mtl\n", "a.obj: line 1: there is no file b.mtl");
  add("a.obj", "mtllib a.obj\nnewmtl a\nmap_Kd b.png\n", "a.obj: line 3: there is no file b.png");
  add("a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n0\n",
      "a.ply: is no PLY that can be read: its points have no x, y, z");
  add("a.ply", "ply\nformat ascii 1.0\n" + plyHeader + "end_header\n0 0 0\n1 0 0\n0 1 0\n",
      "a.ply: has no faces: a surface of triangles is needed, not points or lines alone");
  add("a.ply", "ply\nformat ascii 1.0\n" + plyHeader + plyFace + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
      "a.ply: a face names point 3: there are 3, counted from 0");
  add("a.ply", "ply\nformat binary_little_endian 1.0\n" + plyHeader + plyFace + "0123",
      "a.ply: is damaged: it ends before its last entry");
  add("a.ply", "ply\nformat ascii 1.0\n" + plyHeader + plyFace + "0 0 0\n1 0 0\n0 1 0\n3 0 1\n",
      "a.ply: is damaged: it ends before its last entry");
  add("a.ply", "ply\nend_header",
      "a.ply: is no PLY that can be read: its header has no end_header");
}

void TestMeshFiles::refuses() {
  QFETCH(const QString, name);
  QFETCH(const QByteArray, bytes);
  QFETCH(const QString, line);
  Scene scene;
  QCOMPARE(QString::fromStdString(scene.refusal(name.toStdString(), bytes.toStdString())), line);
}

void TestMeshFiles::refusesBrokenGltf_data() {
  QTest::addColumn<QString>("patch");
  QTest::addColumn<QString>("line");
  const auto add = [](const char* patch, const char* line) {
    QTest::newRow(line) << patch << line;
  };
  add(R"([{"op": "add", "path": "/extensionsRequired", "value": ["EXT_x"]}])",
      "a.glb: needs the extension EXT_x: export it without that extension");
  add(R"([{"op": "add", "path": "/extensionsRequired", "value": ["KHR_draco_mesh_compression"]}])",
      "a.glb: needs the extension KHR_draco_mesh_compression: export it without Draco compression");
  add(R"([{"op": "remove", "path": "/accessors/0/bufferView"}])",
      "a.glb: accessors[0]: has no bufferView; Draco compression is not supported");
  add(R"([{"op": "replace", "path": "/accessors/0/count", "value": 4}])",
      "a.glb: accessors[0]: reaches beyond its bufferView of 36 bytes");
  add(R"([{"op": "replace", "path": "/accessors/0/bufferView", "value": 7}])",
      "a.glb: bufferViews: there is no entry 7");
  add(R"([{"op": "replace", "path": "/bufferViews/0/byteLength", "value": 1e9}])",
      "a.glb: bufferViews[0]: reaches beyond its buffer of 36 bytes");
  add(R"([{"op": "add", "path": "/buffers", "value": [{"byteLength": 99}]}])",
      "a.glb: buffers[0]: has 36 bytes, not the byteLength it states");
  add(R"([{"op": "add", "path": "/buffers", "value": [{"byteLength": 36, "uri": "b.bin"}]}])",
      "a.glb: buffers[0]: there is no file b.bin");
  add(R"([{"op": "replace", "path": "/scenes/0/nodes", "value": []}])",
      "a.glb: has no faces: a surface of triangles is needed, not points or lines alone");
  add(R"([{"op": "replace", "path": "/scenes/0/nodes", "value": [3]}])",
      "a.glb: nodes: there is no entry 3");
  add(R"([{"op": "add", "path": "/nodes/0/children", "value": [0]}])",
      "a.glb: nodes[0]: stands in the tree twice");
  add(R"([{"op": "add", "path": "/meshes/0/primitives/0/mode", "value": 0}])",
      "a.glb: has no faces: a surface of triangles is needed, not points or lines alone");
  add(R"([{"op": "add", "path": "/meshes/0/primitives/0/material", "value": 0}])",
      "a.glb: a primitive: names a material that is not there");
  add(R"([{"op": "add", "path": "/materials/0", "value":
          {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}}])",
      "a.glb: textures: there is no entry 0");
  add(R"([{"op": "add", "path": "/images", "value": [{"uri": "b.png"}]},
          {"op": "add", "path": "/textures", "value": [{"source": 0}]},
          {"op": "add", "path": "/materials/0", "value":
          {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}}])",
      "a.glb: images[0]: there is no file b.png");
  add(R"([{"op": "add", "path": "/images", "value": [{"bufferView": 0}]},
          {"op": "add", "path": "/textures", "value": [{"source": 0}]},
          {"op": "add", "path": "/materials/0", "value":
          {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}}])",
      "a.glb: images[0] cannot be decoded: it is neither PNG nor JPEG");
  add(R"([{"op": "add", "path": "/nodes/0/scale", "value": [1e200, 1e200, 1e200]},
          {"op": "add", "path": "/nodes/0/translation", "value": [1e308, 0, 0]}])",
      "a.glb: reaches farther than 1000 km from the panel: make its scale smaller");
}

void TestMeshFiles::refusesBrokenGltf() {
  QFETCH(const QString, patch);
  QFETCH(const QString, line);
  Gltf gltf = oneTriangle();
  gltf.json = gltf.json.patch(Json::parse(patch.toStdString()));
  Scene scene;
  QCOMPARE(QString::fromStdString(scene.refusal("a.glb", gltf.glb())), line);
}

void TestMeshFiles::survivesDamage_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QByteArray>("bytes");
  Gltf gltf = oneTriangle();
  gltf.card(0, 0, 1, 1, 2, gltf.textured(makePng(4, 4, std::vector<std::uint8_t>(48, 9))));
  gltf.light({{"type", "spot"}, {"intensity", 3}}, {{"translation", {0, 0, 3}}});
  QTest::newRow("glb") << "a.glb" << QByteArray::fromStdString(gltf.glb());
  QTest::newRow("ply") << "a.ply"
                       << QByteArray::fromStdString("ply\nformat ascii 1.0\n" + plyHeader +
                                                    plyFace + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  QTest::newRow("obj") << "a.obj"
                       << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nf 1/1 2/1 3/1\n");
}

/// Bytes changed, cut off or repeated: a mesh or one line, never more.
void TestMeshFiles::survivesDamage() {
  QFETCH(const QString, name);
  QFETCH(const QByteArray, bytes);
  Scene scene;
  std::uint32_t state = 1;
  const auto random = [&](std::size_t n) {
    state = state * 1664525U + 1013904223U;
    return std::size_t(state >> 8U) % n;
  };
  int refused = 0;
  for (int k = 0; k < 1500; ++k) {
    std::string damaged = bytes.toStdString();
    for (std::size_t changes = 1 + random(3); changes > 0; --changes) {
      const std::size_t at = random(damaged.size());
      if (random(3) == 0)
        damaged[at] = char(random(256));
      else if (random(2) == 0)
        damaged[at] = "0123456789-e.,[{\"\n"[random(18)];
      else
        damaged.insert(at, damaged.substr(random(damaged.size()), random(9)));
    }
    if (k % 5 == 0) damaged.resize(random(damaged.size()) + 1);
    const std::string line = scene.refusal(name.toStdString(), damaged);
    if (line.empty()) {
      (void)scene.see(0.2, 0.2);
      continue;
    }
    ++refused;
    QVERIFY2(line.find('\n') == std::string::npos && line.find(": ") != std::string::npos,
             line.c_str());
  }
  QVERIFY(refused > 100);
}

void TestMeshFiles::shapesOfTheScene() {
  Gltf gltf;
  gltf.card(0, 0, 1, 1, 0, gltf.material(1, 0, 0));
  Scene scene;
  scene.open(gltf, {{"position", {0, 0, 2}}, {"scale", 3}});
  const plugin::Triangles shown = scene.source.triangles();
  QCOMPARE(shown.points.size(), std::size_t(18));
  QCOMPARE(shown.corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  QCOMPARE(shown.points[3], 3.0F);
  QCOMPARE(shown.points[5], 2.0F);
  for (std::size_t k = 0; k < shown.colours.size(); ++k)
    QCOMPARE(int(shown.colours[k]), k % 3 == 0 ? 255 : 0);
}

QTEST_GUILESS_MAIN(TestMeshFiles)
#include "test_mesh_files.moc"
