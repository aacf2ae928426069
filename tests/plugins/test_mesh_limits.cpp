// SPDX-License-Identifier: BSD-3-Clause
// Tests meshes that were made to take all memory, to run long or to read beyond their data, and
// what is noted of those that are shown in part.
#include <QTest>

#include "tests/plugins/mesh_scene.h"

using namespace hogelscope;
using namespace hogelscope::test;

namespace {

/// A triangle whose points are zeros but for a sparse part of one entry.
std::string sparseZeros(int count) {
  Json accessor{{"componentType", 5126}, {"type", "VEC3"}, {"count", count}};
  accessor["sparse"] = {{"count", 1},
                        {"indices", {{"bufferView", 0}, {"componentType", 5125}}},
                        {"values", {{"bufferView", 0}}}};
  const Json attributes{{"POSITION", 0}, {"NORMAL", 0}, {"COLOR_0", 0}};
  return Json{{"asset", {{"version", "2.0"}}},
              {"nodes", {{{"mesh", 0}}}},
              {"meshes", {{{"primitives", {{{"attributes", attributes}}}}}}},
              {"accessors", {accessor}},
              {"bufferViews", {{{"buffer", 0}, {"byteLength", 12}}}},
              {"buffers", {{{"byteLength", 12}, {"uri", "data:;base64,AAAAAAAAAAAAAAAA"}}}}}
      .dump();
}

const std::string face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Stops after a number of questions.
struct Stopping : plugin::Progress {
  explicit Stopping(int questions) : left(questions) {}
  [[nodiscard]] bool go(double) const override { return left-- > 0; }
  mutable int left;
};

/// What a reading says that is stopped at its n-th question.
std::string stopped(const Scene& scene, const std::string& name, int n) {
  try {
    (void)mesh::readMesh(scene.path(name), memory, Stopping(n));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "was read";
}

}  // namespace

class TestMeshLimits : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void deepJson();
  void hugeAccessors();
  void pointsAndTrianglesCount();
  void texturesCountBeforeTheyAreDecoded();
  void aPictureIsReadOnce();
  void aLibraryIsReadOnce();
  void aBufferIsReadOnce();
  void theFirstColouredPoint();
  void twoElementsOfOneName();
  void asksWhileItReads();
  void notes();
};

void TestMeshLimits::deepJson() {
  const std::string line = "a.gltf: is no glTF that can be read: its JSON is nested too deeply";
  Scene scene;
  const std::string before = R"({"asset": {"version": "2.0"}, "buffers": )";
  for (const int depth : {120, 200000})
    QCOMPARE(scene.refusal("a.gltf", before + std::string(std::size_t(depth), '[') +
                                         std::string(std::size_t(depth), ']') + "}"),
             line);
  std::string objects = "1";
  for (int k = 0; k < 200; ++k) objects = "{\"a\":" + objects + "}";
  QCOMPARE(scene.refusal("a.gltf", before + objects + "}"), line);
}

void TestMeshLimits::hugeAccessors() {
  Scene scene;
  const std::string line = scene.refusal("a.gltf", sparseZeros(100000000));
  QVERIFY2(QString::fromStdString(line).contains(
               " GB of memory or more: 1 GB are allowed: use a smaller mesh or textures, or allow"),
           line.c_str());
  scene.open({{"file", (scene.add("b.gltf", sparseZeros(300)), "b.gltf")}});
}

void TestMeshLimits::pointsAndTrianglesCount() {
  Scene scene;
  Gltf gltf;
  std::string obj;
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3000\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1000\n"
      "property list uchar int vertex_indices\nend_header\n";
  std::vector<float> points;
  std::string faces;
  for (int k = 0; k < 3000; ++k) {
    const std::string place = std::to_string(k) + " 0 " + std::to_string(k % 7) + "\n";
    obj += "v " + place;
    ply += place;
    points.insert(points.end(), {float(k), 0, float(k % 7)});
    const std::string corners =
        std::to_string(k) + " " + std::to_string(k - 1) + " " + std::to_string(k - 2) + "\n";
    if (k % 3 == 2) faces += "3 " + corners;
    if (k > 2 && k % 3 == 0) obj += "f " + corners;
  }
  gltf.triangles(points);
  scene.add("a.glb", gltf.glb());
  scene.add("a.obj", obj);
  scene.add("a.ply", ply + faces);
  for (const std::string name : {"a.glb", "a.obj", "a.ply"}) {
    // The triangles alone take 200 kB.
    QVERIFY_EXCEPTION_THROWN((void)mesh::readMesh(scene.path(name), 200000, Going{}),
                             std::runtime_error);
    (void)mesh::readMesh(scene.path(name), 900000, Going{});
  }
}

/// The picture's pixels are damaged: they are not looked at where its size is too much.
void TestMeshLimits::texturesCountBeforeTheyAreDecoded() {
  std::string png = makePng(1000, 2000, std::vector<std::uint8_t>(6000000, 9));
  png = png.substr(0, png.size() / 2);
  Gltf gltf;
  gltf.card(0, 0, 1, 1, 0, gltf.textured(png));
  gltf.card(0, 0, 1, 1, 1, gltf.textured(png));
  Scene scene;
  scene.add("a.glb", gltf.glb());
  const auto read = [&](std::uint64_t allowed) {
    try {
      (void)mesh::readMesh(scene.path("a.glb"), allowed, Going{});
    } catch (const std::runtime_error& error) {
      return QString(error.what());
    }
    return QString();
  };
  QVERIFY(read(30000000).contains(": needs 44"));  // 11 bytes for each of 4 million pixels
  QVERIFY(read(60000000).contains("cannot be decoded"));
}

void TestMeshLimits::aPictureIsReadOnce() {
  Scene scene;
  QVERIFY(QDir().mkpath(QString::fromStdString(scene.path("sub"))));
  scene.add("a.png", makePng(2, 2, std::vector<std::uint8_t>(12, 200)));
  std::string materials;
  std::string name = "a.png";
  for (int k = 0; k < 300; ++k) {
    materials += "newmtl m" + std::to_string(k) + "\nmap_Kd " + name + "\n";
    name = (k % 2 == 0 ? "./" : "sub/../") + name;
  }
  scene.add("a.mtl", materials);
  scene.add("a.obj", "mtllib a.mtl\n" + face);
  const mesh::Mesh mesh = scene.read("a.obj");
  QCOMPARE(mesh.textures.size(), std::size_t(1));
  QCOMPARE(mesh.materials.size(), std::size_t(301));
  QCOMPARE(mesh.files,
           (std::vector{scene.path("a.obj"), scene.path("a.mtl"), scene.path("a.png")}));

  Gltf gltf;
  gltf.card(0, 0, 1, 1, 0, gltf.textured(makePng(2, 2, std::vector<std::uint8_t>(12, 50))));
  const Json inside = gltf.json["images"][0];
  const Json texture = gltf.json["textures"][0];
  for (int k = 1; k < 20; ++k) {
    gltf.json["images"].push_back(k % 2 == 0 ? inside
                                             : Json{{"uri", k % 4 == 1 ? "a.png" : "./a.png"}});
    gltf.json["textures"].push_back({{"source", k}});
    gltf.material(1, 1, 1);
    gltf.json["materials"].back()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", k}};
  }
  scene.add("a.glb", gltf.glb());
  QCOMPARE(scene.read("a.glb").textures.size(), std::size_t(2));
}

/// Each of 30 000 readings of 30 000 materials would take a gigabyte.
void TestMeshLimits::aLibraryIsReadOnce() {
  Scene scene;
  std::string library;
  std::string lines;
  for (int k = 0; k < 30000; ++k) {
    library += "newmtl a\nKd 1 1 1\n";
    lines += "mtllib a.mtl\n";
  }
  scene.add("a.mtl", library);
  scene.add("b.mtl", "newmtl a\nKd 0 0 0\n");
  scene.add("a.obj", lines + "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n" +
                         "mtllib b.mtl\nusemtl a\nf 1 2 3\nmtllib ./a.mtl\nusemtl a\nf 1 2 3\n");
  const mesh::Mesh mesh = scene.read("a.obj");
  QCOMPARE(mesh.materialOf, (std::vector<std::uint32_t>{1, 2, 1}));
  QCOMPARE(mesh.materials.size(), std::size_t(3));
  QCOMPARE(mesh.files.size(), std::size_t(3));
}

void TestMeshLimits::aBufferIsReadOnce() {
  Gltf gltf;
  gltf.triangles({0, 0, 0, 1, 0, 0, 0, 1, 0});
  Json& buffers = gltf.json["buffers"];
  for (int k = 0; k < 50; ++k)
    buffers.push_back({{"byteLength", 30000000}, {"uri", k % 2 == 0 ? "a.bin" : "./a.bin"}});
  Scene scene;
  scene.add("a.bin", gltf.binary + std::string(30000000, '\0'));
  scene.add("a.gltf", gltf.json.dump());
  const mesh::Mesh mesh = scene.read("a.gltf");  // 50 times are more than is allowed
  QCOMPARE(mesh.files.size(), std::size_t(2));
}

void TestMeshLimits::theFirstColouredPoint() {
  Scene scene;
  scene.add("a.obj", "v -1 -1 0 1 0 0\nv 1 -1 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n");
  scene.open({{"file", "a.obj"}, {"shading", "unlit"}});
  for (const auto& [x, y] : {std::pair{-0.9, -0.95}, {0.9, -0.95}, {0.0, 0.9}, {0.0, 0.0}}) {
    const plugin::Colour colour = scene.see(x, y);
    QVERIFY(colour.r == 255 && colour.g == 0 && colour.b == 0);
  }
  scene.add("b.obj", "v -1 -1 0\nv 1 -1 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
  QCOMPARE(scene.read("b.obj").colours,
           (std::vector<mesh::Linear>{{1, 1, 1}, {0, 1, 0}, {0, 0, 1}}));
}

/// The second one would say what the first one's points have.
void TestMeshLimits::twoElementsOfOneName() {
  const std::string places = "property float x\nproperty float y\nproperty float z\n";
  const std::string colours = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  Scene scene;
  QCOMPARE(scene.refusal("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n" + places +
                                      "element vertex 1\n" + places + colours +
                                      "element face 1\nproperty list uchar int vertex_indices\n"
                                      "end_header\n-1 -1 0\n1 -1 0\n0 1 0\n0 0 0 255 0 0\n"
                                      "3 0 1 2\n"),
           std::string("a.ply: is no PLY that can be read: its header has two elements vertex"));
}

/// At any question "stopped" is the answer, and there are some in each long part.
void TestMeshLimits::asksWhileItReads() {
  Scene scene;
  Gltf gltf;
  const std::string png = makePng(200, 1000, std::vector<std::uint8_t>(600000, 7));
  gltf.card(0, 0, 1, 1, 0, gltf.textured(png));
  scene.add("picture.glb", gltf.glb());
  Gltf many;
  for (int k = 0; k < 40; ++k) many.triangles({0, 0, float(k), 1, 0, 0, 0, 1, 0});
  scene.add("nodes.glb", many.glb());
  Gltf values;
  values.triangles({0, 0, 0, 1, 0, 0, 0, 1, 0});
  for (int k = 0; k < 700000; ++k) values.json["extras"].push_back(k);
  scene.add("json.glb", values.glb());
  std::string library;
  for (int k = 0; k < 700000; ++k) library += "#\n";
  scene.add("a.mtl", library);
  scene.add("library.obj", "mtllib a.mtl\n" + face);
  scene.add(
      "face.obj", face + "f" + [] {
        std::string corners;
        for (int k = 0; k < 700000; ++k) corners += " 1";
        return corners;
      }());
  scene.add(
      "list.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nelement face 1\n"
      "property list uint int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
      "700000" +
          [] {
            std::string corners;
            for (int k = 0; k < 700000; ++k) corners += " 1";
            return corners;
          }());
  scene.add("large.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
            "property float y\nproperty float z\nelement face 1\n"
            "property list uint int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
            "3 0 1 2\n" +
                std::string(50000000, ' '));
  // The questions that each has at least: one for some rows, nodes, values or lines.
  for (const auto& [name, least] : {std::pair{"picture.glb", 32},
                                    {"nodes.glb", 40},
                                    {"json.glb", 9},
                                    {"library.obj", 9},
                                    {"face.obj", 9},
                                    {"list.ply", 9},
                                    {"large.ply", 4}}) {
    for (const int n : {0, 1, least})
      QVERIFY2(stopped(scene, name, n) == "stopped",
               qPrintable(QString("%1 of %2").arg(n).arg(name)));
    QCOMPARE(stopped(scene, name, 1000), std::string("was read"));
  }
}

void TestMeshLimits::notes() {
  Scene scene;
  Gltf gltf;
  gltf.card(0, 0, 1, 1, 0, gltf.material(1, 1, 1));
  scene.open(gltf);
  QVERIFY(scene.source.notes().empty());
  Json& material = gltf.json["materials"][0];
  material["normalTexture"] = {{"index", 7}};
  material["alphaMode"] = "BLEND";
  gltf.json["animations"] = Json::array({Json::object()});
  gltf.json["skins"] = Json::array({Json::object(), Json::object()});
  gltf.json["extensionsUsed"] = {"KHR_texture_transform", "EXT_new"};
  gltf.json["scenes"].push_back(Json::object());
  Json line = gltf.json["meshes"][0]["primitives"][0];
  line["mode"] = 1;
  line["targets"] = Json::array();
  gltf.json["meshes"][0]["primitives"].push_back(line);
  scene.open(gltf);
  QCOMPARE(scene.source.notes(),
           (std::vector<std::string>{
               "Its materials' alphaMode, normalTexture are not shown.",
               "Its animation stays at rest; mesh.animation is a name or a number of one.",
               "Its morph targets are not applied.", "Its points and lines are not shown.",
               "Of its 2 scenes one is shown.", "Its extensions EXT_new are not shown."}));

  scene.add("a.mtl",
            "newmtl a\nKs 0 0 0\n"
            "d 1\nmap_Bump b.png\n"
            "d 0.5\n");
  scene.add("a.obj", "mtllib a.mtl\ng group\n" + face + "l 1 2\nl 2 3\np 1\n");
  QCOMPARE(scene.read("a.obj").notes,
           (std::vector<std::string>{"Its materials' d, map_Bump are not shown.",
                                     "Its lines l, p are not shown."}));

  scene.add("a.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
            "property float y\nproperty float z\nproperty float quality\n"
            "element face 1\nproperty list uchar int vertex_indices\n"
            "element edge 1\nproperty int vertex1\nend_header\n"
            "0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n0\n");
  QCOMPARE(scene.read("a.ply").notes,
           (std::vector<std::string>{"Its elements edge are not shown.",
                                     "Its points' properties quality are not shown."}));
}

QTEST_GUILESS_MAIN(TestMeshLimits)
#include "test_mesh_limits.moc"
