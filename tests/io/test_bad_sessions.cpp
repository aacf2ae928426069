// SPDX-License-Identifier: BSD-3-Clause
// Tests the line for sessions with values of a wrong type, out of range, or against each other.
#include <QTemporaryDir>

#include "tests/io/refusal.h"

namespace {

/// A row whose line is about s.json.
void refusedIn(const char* name, const QByteArray& document, const QByteArray& why) {
  refused(name, document, "s.json: " + why);
}

/// A document with one state of these fields.
QByteArray state(const QByteArray& fields) {
  return text({.cameras = R"([{"name": "a", )" + fields + "}]"});
}

/// A document with one state of this name, as JSON.
QByteArray named(const QByteArray& name) {
  return text({.cameras = R"([{"name": )" + name + "}]"});
}

}  // namespace

class TestBadSessions : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void types_data();
  void types() { checkLoading(m_folder.path()); }
  void values_data();
  void values() { checkLoading(m_folder.path()); }
  void states_data();
  void states() { checkLoading(m_folder.path()); }
  void atTheProgram_data();
  void atTheProgram() { checkProgram(m_folder.path()); }

 private:
  QTemporaryDir m_folder;
};

void TestBadSessions::types_data() {
  refusalColumns();
  refusedIn("text for a number", state(R"("fov": "60")"), "cameras[0].fov: \"60\" is not a number");
  refusedIn("true for a number", state(R"("fov": true)"), "cameras[0].fov: true is not a number");
  refusedIn("null for a number", state(R"("fov": null)"), "cameras[0].fov: null is not a number");
  refusedIn("list for a number", state(R"("fov": [60])"), "cameras[0].fov: [60] is not a number");
  refusedIn("object for a number", state(R"("fov": {"x": 60})"),
            "cameras[0].fov: {\"x\":60} is not a number");
  refusedIn("number for a list", state(R"("res": 600)"),
            "cameras[0].res: 600 is not a list of 2 numbers");
  refusedIn("text for a list", state(R"("eye": "0 0 1")"),
            "cameras[0].eye: \"0 0 1\" is not a list of 3 numbers");
  refusedIn("object for a list", state(R"("eye": {"x": 0, "y": 0, "z": 1})"),
            "cameras[0].eye: {\"x\":0,\"y\":0,\"z\":1} is not a list of 3 numbers");
  refusedIn("list too short", state(R"("eye": [0, 0])"),
            "cameras[0].eye: [0,0] is not a list of 3 numbers");
  refusedIn("list too long", state(R"("res": [600, 600, 3])"),
            "cameras[0].res: [600,600,3] is not a list of 2 numbers");
  refusedIn("empty list", state(R"("up": [])"), "cameras[0].up: [] is not a list of 3 numbers");
  refusedIn("text in a list", state(R"("eye": [0, "0", 1])"),
            "cameras[0].eye[1]: \"0\" is not a number");
  refusedIn("null in a list", state(R"("eye": [0, 0, null])"),
            "cameras[0].eye[2]: null is not a number");
  refusedIn("list in a list", state(R"("res": [[600], 600])"),
            "cameras[0].res[0]: [600] is not a number");
  refusedIn("number for a text", text({.lightField = R"({"file": 5})"}),
            "lightField.file: 5 is not a text");
  refusedIn("null for a text", text({.lightField = R"({"file": null})"}),
            "lightField.file: null is not a text");
  refusedIn("number for a flag", text({.lightField = R"({"file": "scene.png", "incoming": 1})"}),
            "lightField.incoming: 1 is neither true nor false");
  refusedIn("text for a flag", text({.lightField = R"({"file": "scene.png", "incoming": "true"})"}),
            "lightField.incoming: \"true\" is neither true nor false");
  refusedIn("number for a choice", text({.sampling = R"({"mapping": 0})"}),
            "sampling.mapping: 0 is not a text: one of exact, direct");
  refusedIn("unknown choice", text({.sampling = R"({"mapping": "inverse"})"}),
            "sampling.mapping: \"inverse\" is not one of exact, direct");
  refusedIn("choice in capitals", text({.sampling = R"({"mapping": "Exact"})"}),
            "sampling.mapping: \"Exact\" is not one of exact, direct");
  refusedIn("unknown lens", text({.display = R"({"lens": "fisheye"})"}),
            "display.lens: \"fisheye\" is not one of rectilinear, equiangular, plugin");
  refusedIn("unknown layout", text({.lightField = R"({"file": "scene.png", "layout": "tiles"})"}),
            "lightField.layout: \"tiles\" is not one of hogels, views, quilt, mosaic, lenslets, "
            "pack, live, woven");
  refusedIn("unknown border", state(R"("psf": {"border": "wrap"})"),
            "cameras[0].psf.border: \"wrap\" is not one of renormalise, clamp, black");
  refusedIn(
      "a long value",
      text(
          {.display =
               R"({"size": "01234567890123456789012345678901234567890123456789012345678901234567890123456789"})"}),
      "display.size: \"01234567890123456789012345678901234567890123456789012345678… is not a list "
      "of 2 numbers");
  refusedIn("a long value, not in ASCII",
            text({.display = R"({"size": ")" + QByteArray("é").repeated(40) + R"("})"}),
            "display.size: \"" + QByteArray("é").repeated(29) + "… is not a list of 2 numbers");
}

void TestBadSessions::values_data() {
  refusalColumns();
  refusedIn("intrinsics without fx", state(R"("intrinsics": {"cx": 3})"),
            "cameras[0].intrinsics.fx: is missing: intrinsics need at least fx, in pixels");
  refusedIn("fx 0", state(R"("intrinsics": {"fx": 0})"),
            "cameras[0].intrinsics.fx: 0 is out of range: 0.001 to 1e+08 px");
  refusedIn("fov 0", state(R"("fov": 0)"), "cameras[0].fov: 0 is out of range: 0.01 to 179.9 °");
  refusedIn("fov 180", state(R"("fov": 180)"),
            "cameras[0].fov: 180 is out of range: 0.01 to 179.9 °");
  refusedIn("fov below 0", state(R"("fov": -60)"),
            "cameras[0].fov: -60 is out of range: 0.01 to 179.9 °");
  refusedIn("display fov 180", text({.display = R"({"fov": [60, 180]})"}),
            "display.fov[1]: 180 is out of range: 0.01 to 179.9 °");
  refusedIn("size 0", text({.display = R"({"size": [0, 0.5]})"}),
            "display.size[0]: 0 is out of range: 1e-06 to 1e+06 m");
  refusedIn("size below 0", text({.display = R"({"size": [0.5, -0.5]})"}),
            "display.size[1]: -0.5 is out of range: 1e-06 to 1e+06 m");
  refusedIn("orientation", text({.display = R"({"orientation": [0, 0, 361]})"}),
            "display.orientation[2]: 361 is out of range: -360 to 360 °");
  refusedIn("position", text({.display = R"({"position": [1e7, 0, 0]})"}),
            "display.position[0]: 10000000.0 is out of range: -1e+06 to 1e+06 m");
  refusedIn("res 0", state(R"("res": [0, 600])"),
            "cameras[0].res[0]: 0 is out of range: 1 to 16384 px");
  refusedIn("res too large", state(R"("res": [600, 16385])"),
            "cameras[0].res[1]: 16385 is out of range: 1 to 16384 px");
  refusedIn("res below 0", state(R"("res": [-600, 600])"),
            "cameras[0].res[0]: -600 is out of range: 1 to 16384 px");
  refusedIn("res with a fraction", state(R"("res": [600.5, 600])"),
            "cameras[0].res[0]: 600.5 is not a whole number");
  refusedIn("res beyond 64 bits", state(R"("res": [99999999999999999999999, 600])"),
            "cameras[0].res[0]: 9.999999999999999e+22 is out of range: 1 to 16384 px");
  refusedIn("res of 2^32 + 600", state(R"("res": [4294967896, 600])"),
            "cameras[0].res[0]: 4294967896 is out of range: 1 to 16384 px");
  refusedIn("hogels 0", text({.display = R"({"hogels": [0, 3]})"}),
            "display.hogels[0]: 0 is out of range: 1 to 65536");
  refusedIn("hogels beyond", text({.display = R"({"hogels": [65537, 3]})"}),
            "display.hogels[0]: 65537 is out of range: 1 to 65536");
  refusedIn("directions with a fraction", text({.display = R"({"directions": [5.25, 6]})"}),
            "display.directions[0]: 5.25 is not a whole number");
  refusedIn("even windowSize", state(R"("psf": {"windowSize": 4})"),
            "cameras[0].psf.windowSize: 4 is not one of 1, 3, … 99");
  refusedIn("windowSize 0", state(R"("psf": {"windowSize": 0})"),
            "cameras[0].psf.windowSize: 0 is out of range: 1 to 99 px");
  refusedIn("windowSize too large", state(R"("psf": {"windowSize": 101})"),
            "cameras[0].psf.windowSize: 101 is out of range: 1 to 99 px");
  refusedIn("sigma below 0", state(R"("psf": {"sigma": -0.1})"),
            "cameras[0].psf.sigma: -0.1 is out of range: 0 to 20 px");
  refusedIn("sigma 0 with a window", state(R"("psf": {"sigma": 0, "windowSize": 5})"),
            "cameras[0].psf.sigma: is 0 with a windowSize of 5: give a sigma above 0, or "
            "windowSize 1 for no leakage");
  refusedIn("k1 too large", state(R"("distortion": {"k1": 11})"),
            "cameras[0].distortion.k1: 11 is out of range: -10 to 10");
  refusedIn("samplesPerPixel 0", text({.sampling = R"({"samplesPerPixel": 0})"}),
            "sampling.samplesPerPixel: 0 is out of range: 1 to 64");
  refusedIn("samplesPerPixel 65", text({.sampling = R"({"samplesPerPixel": 65})"}),
            "sampling.samplesPerPixel: 65 is out of range: 1 to 64");
  refusedIn("quilt without columns",
            text({.lightField = R"({"file": "scene.png", "layout": "quilt", "columns": 0})"}),
            "lightField.columns: 0 is out of range: 1 to 4096 views");
  refusedIn("shear", text({.lightField = R"({"file": "v", "layout": "views", "shear": [1e5, 0]})"}),
            "lightField.shear[0]: 100000.0 is out of range: -10000 to 10000 px/view");
  refusedIn("no hogels for a hogel image", text({.display = R"({"directions": [5, 6]})"}),
            "display.hogels: is missing: a hogel image does not say it");
  refusedIn("no directions for a hogel image", text({.display = R"({"hogels": [4, 3]})"}),
            "display.directions: is missing: a hogel image does not say it");
  refusedIn("no file", text({.lightField = R"({"layout": "views"})"}),
            "lightField.file: is missing: name the image or folder to show");
  refusedIn("empty file name", text({.lightField = R"({"file": ""})"}),
            "lightField.file: is missing: name the image or folder to show");
}

void TestBadSessions::states_data() {
  refusalColumns();
  refusedIn("eye is lookat", state(R"("eye": [1, 2, 3], "lookat": [1, 2, 3])"),
            "cameras[0].lookat: is the eye itself: the camera looks nowhere");
  refusedIn("up along the view", state(R"("up": [0, 0, 2])"),
            "cameras[0].up: is parallel to the line from eye to lookat");
  refusedIn("up against the view", state(R"("eye": [0, 1, 0], "up": [0, 1, 0])"),
            "cameras[0].up: is parallel to the line from eye to lookat");
  refusedIn("up 0", state(R"("up": [0, 0, 0])"),
            "cameras[0].up: is zero: give the direction that is up in the picture");
  refusedIn("state without a name", text({.cameras = R"([{"fov": 60}])"}),
            "cameras[0].name: is missing: every state has a name of its own");
  refusedIn("empty name", named(R"("")"),
            "cameras[0].name: is missing: every state has a name of its own");
  refusedIn("number as name", named("7"), "cameras[0].name: 7 is not a text");
  refusedIn("slash in a name", named(R"("a/b")"),
            "cameras[0].name: \"a/b\" has a slash; it names the picture's file");
  refusedIn("backslash in a name", named(R"("a\\b")"),
            "cameras[0].name: \"a\\b\" has a slash; it names the picture's file");
  refusedIn("line break in a name", named(R"("a\nb")"),
            "cameras[0].name: \"a\\nb\" has a control character");
  refusedIn("name with a leading dot", named(R"(".a")"),
            "cameras[0].name: \".a\" begins with a dot; it names the picture's file");
  refusedIn("two dots", named(R"("..")"),
            "cameras[0].name: \"..\" begins with a dot; it names the picture's file");
  refusedIn("name of a mask", named(R"("a.mask")"),
            "cameras[0].name: \"a.mask\" ends with .mask, which names the masks");
  refusedIn("name too long", named('"' + QByteArray(201, 'x') + '"'),
            "cameras[0].name: is longer than 200 bytes");
  refusedIn("same name twice",
            text({.cameras = R"([{"name": "a"}, {"name": "b"}, {"name": "a"}])"}),
            "cameras[2].name: \"a\" is also cameras[0]; every state has a name of its own");
}

/// Some of them again, as a user gives them.
void TestBadSessions::atTheProgram_data() {
  refusalColumns();
  refusedIn(
      "a long value",
      text(
          {.display =
               R"({"size": "01234567890123456789012345678901234567890123456789012345678901234567890123456789"})"}),
      "display.size: \"01234567890123456789012345678901234567890123456789012345678… is not a list "
      "of 2 numbers");
  refusedIn("size 0", text({.display = R"({"size": [0, 0.5]})"}),
            "display.size[0]: 0 is out of range: 1e-06 to 1e+06 m");
  refusedIn("res with a fraction", state(R"("res": [600.5, 600])"),
            "cameras[0].res[0]: 600.5 is not a whole number");
  refusedIn("even windowSize", state(R"("psf": {"windowSize": 4})"),
            "cameras[0].psf.windowSize: 4 is not one of 1, 3, … 99");
  refusedIn("eye is lookat", state(R"("eye": [1, 2, 3], "lookat": [1, 2, 3])"),
            "cameras[0].lookat: is the eye itself: the camera looks nowhere");
  refusedIn("same name twice",
            text({.cameras = R"([{"name": "a"}, {"name": "b"}, {"name": "a"}])"}),
            "cameras[2].name: \"a\" is also cameras[0]; every state has a name of its own");
}

QTEST_GUILESS_MAIN(TestBadSessions)
#include "test_bad_sessions.moc"
