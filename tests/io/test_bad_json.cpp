// SPDX-License-Identifier: BSD-3-Clause
// Tests the line for documents that are no JSON, or have not the shape of a session.
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

}  // namespace

class TestBadJson : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void atTheProgram_data();
  void atTheProgram() { checkProgram(m_folder.path()); }
  void notJson_data();
  void notJson() { checkLoading(m_folder.path()); }
  void structure_data();
  void structure() { checkLoading(m_folder.path()); }
  void deepNesting_data();
  void deepNesting();

 private:
  QTemporaryDir m_folder;
};

void TestBadJson::atTheProgram_data() {
  refusalColumns();
  refusedIn("empty file", "", "is empty: not a session document");
  refusedIn("truncated", R"({"hogelscope": 1, "display": {"fov": [60,)",
            "is not JSON: line 1, column 42: …");
  refusedIn("trailing comma", R"({"hogelscope": 1,})", "is not JSON: line 1, column 18: …");
  refusedIn("comment", R"({"hogelscope": 1 /* first */})", "is not JSON: line 1, column 18: …");
  refusedIn("NaN", R"({"hogelscope": 1, "display": {"fov": [NaN, 60]}})",
            "is not JSON: line 1, column 39: …");
  refusedIn("1e999", R"({"hogelscope": 1, "display": {"fov": [1e999, 60]}})",
            "is not JSON: line 1, column 43: …");
  refusedIn("a picture", QByteArray("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16),
            "is not JSON: line 1, column 1: …");
  refusedIn("no UTF-8", "{\"hogelscope\": 1, \"x\": \"\xff\"}",
            "is not JSON: line 1, column 25: …");
  // TODO wording: which of the cameras?
  refusedIn(
      "twice the same key, deeper",
      R"({"hogelscope": 1, "cameras": [{"psf": {"sigma": 1}}, {"psf": {"sigma": 1, "sigma": 2}}]})",
      "cameras.psf.sigma: stands twice in one object");
}

void TestBadJson::notJson_data() {
  refusalColumns();
  refusedIn("only a line break", R"(
)",
            "is empty: not a session document");
  refusedIn("truncated on line 3", R"({
  "hogelscope": 1,
  "disp)",
            "is not JSON: line 3, column 8: …");
  refusedIn("trailing comma in a list", R"({"hogelscope": 1, "cameras": [{"name": "a"},]})",
            "is not JSON: line 1, column 45: …");
  refusedIn("single quotes", "{'hogelscope': 1}", "is not JSON: line 1, column 2: …");
  refusedIn("two documents", R"({"hogelscope": 1} {"hogelscope": 1})",
            "is not JSON: line 1, column 19: …");
  refusedIn("Infinity", R"({"hogelscope": 1, "display": {"fov": [-Infinity, 60]}})",
            "is not JSON: line 1, column 40: …");
  refusedIn("hexadecimal", R"({"hogelscope": 0x1})", "is not JSON: line 1, column 17: …");
  refusedIn("leading plus", R"({"hogelscope": +1})", "is not JSON: line 1, column 16: …");
  refusedIn("True", R"({"hogelscope": 1, "lightField": {"incoming": True}})",
            "is not JSON: line 1, column 46: …");
  refusedIn("line break in a text", R"({"hogelscope": 1, "x": "a
b"})",
            "is not JSON: line 1, column 26: …");
  refusedIn("zeros", QByteArray(64, '\0'), "is not JSON: line 1, column 1: …");
  refusedIn("UTF-16", QByteArray("\xff\xfe{\0}\0", 6), "is not JSON: line 1, column 1: …");
  refusedIn("a CSV file", R"(state,test,mse
)",
            "is not JSON: line 1, column 1: …");
  refusedIn("twice the same key", R"({"hogelscope": 1, "hogelscope": 1})",
            "hogelscope: stands twice in one object");
}

void TestBadJson::structure_data() {
  refusalColumns();
  QByteArray keys;
  for (int k = 0; k < 300000; ++k) keys += "\"" + QByteArray::number(k) + "\": 1, ";
  refusedIn("more keys than can be searched one by one", "{" + keys + "\"a\": 1}",
            "has more than 1000 keys in one object");
  refusedIn("a list", "[]", "[] is not an object: { \"name\": value, … }");
  refusedIn("a number", "1", "1 is not an object: { \"name\": value, … }");
  refusedIn("null", "null", "null is not an object: { \"name\": value, … }");
  refusedIn("a text", R"("session")", "\"session\" is not an object: { \"name\": value, … }");
  refusedIn("no version", R"({"display": {}})",
            "hogelscope: is missing: a session says \"hogelscope\": 1");
  refusedIn("later version", R"({"hogelscope": 2})",
            "hogelscope: 2 is not a version that this program reads: \"hogelscope\": 1");
  refusedIn("version as a text", R"({"hogelscope": "1"})",
            "hogelscope: \"1\" is not a version that this program reads: \"hogelscope\": 1");
  refusedIn("version null", R"({"hogelscope": null})",
            "hogelscope: null is not a version that this program reads: \"hogelscope\": 1");
  refusedIn("version true", R"({"hogelscope": true})",
            "hogelscope: true is not a version that this program reads: \"hogelscope\": 1");
  refusedIn("nothing but a version", R"({"hogelscope": 1})",
            "lightField.file: is missing: name the image or folder to show");
  refusedIn("unknown section", R"({"hogelscope": 1, "dispaly": {}})",
            "dispaly: is not known here; did you mean \"display\"?");
  refusedIn(
      "unknown section, nothing near", R"({"hogelscope": 1, "metadata": {}})",
      "metadata: is not known here; known are hogelscope, display, twin, lightField, sampling, "
      "depth, optimise, metrics, cameras");
  refusedIn("camera for cameras", R"({"hogelscope": 1, "camera": []})",
            "camera: is not known here; did you mean \"cameras\"?");
  refusedIn("unknown display field", text({.display = R"({"hogel": [4, 3]})"}),
            "display.hogel: is not known here; did you mean \"hogels\"?");
  refusedIn(
      "unknown display field, nothing near", text({.display = R"({"thickness": 0.1})"}),
      "display.thickness: is not known here; known are kind, position, orientation, size, hogels, "
      "directions, fov, lens");
  refusedIn("unknown lightField field", text({.lightField = R"({"filename": "scene.png"})"}),
            "lightField.filename: is not known here; did you mean \"file\"?");
  refusedIn("a field of another layout",
            text({.lightField = R"({"file": "scene.png", "shear": [1, 1]})"}),
            "lightField.shear: is not known here; known are file, layout, incoming, "
            "viewingDistance, fps, "
            "frames");
  refusedIn("unknown sampling field", text({.sampling = R"({"samples_per_pixel": 1})"}),
            "sampling.samples_per_pixel: is not known here; did you mean \"samplesPerPixel\"?");
  refusedIn("unknown state field", state(R"("lookAt": [0, 0, 0])"),
            "cameras[0].lookAt: is not known here; did you mean \"lookat\"?");
  refusedIn("unknown distortion field", state(R"("distortion": {"k7": 0})"),
            "cameras[0].distortion.k7: is not known here; did you mean \"k1\"?");
  refusedIn("unknown psf field", state(R"("psf": {"window": 3})"),
            "cameras[0].psf.window: is not known here; known are sigma, windowSize, border, light");
  refusedIn(
      "a line break in a key", text({.display = R"({"a\nb": 1})"}),
      "display.a\\x0ab: is not known here; known are kind, position, orientation, size, hogels, "
      "directions, fov, lens");
  refusedIn(
      "an escape code in a key", text({.display = R"({"\u001b[31m": 1})"}),
      "display.\\x1b[31m: is not known here; known are kind, position, orientation, size, hogels, "
      "directions, fov, lens");
  refusedIn("display null", text({.display = "null"}),
            "display: null is not an object: { \"name\": value, … }");
  refusedIn("display a list", text({.display = "[]"}),
            "display: [] is not an object: { \"name\": value, … }");
  refusedIn("lightField a text", text({.lightField = R"("scene.png")"}),
            "lightField: \"scene.png\" is not an object: { \"name\": value, … }");
  refusedIn("sampling a number", text({.sampling = "3"}),
            "sampling: 3 is not an object: { \"name\": value, … }");
  refusedIn("cameras an object", text({.cameras = R"({"name": "a"})"}),
            "cameras: is not a list of camera states: [ { … }, … ]");
  refusedIn("cameras null", text({.cameras = "null"}),
            "cameras: is not a list of camera states: [ { … }, … ]");
  refusedIn("no cameras", text({.cameras = "[]"}),
            "cameras: is empty: give at least one camera state");
  refusedIn("a state null", text({.cameras = R"([{"name": "a"}, null])"}),
            "cameras[1]: null is not an object: { \"name\": value, … }");
  refusedIn("a state as a name", text({.cameras = R"(["a"])"}),
            "cameras[0]: \"a\" is not an object: { \"name\": value, … }");
  refusedIn("psf a number", state(R"("psf": 0.67)"),
            "cameras[0].psf: 0.67 is not an object: { \"name\": value, … }");
  refusedIn("distortion a list", state(R"("distortion": [0.6, 0.4, 0, 0, 0.3])"),
            "cameras[0].distortion: [0.6,0.4,0,0,0.3] is not an object: { \"name\": value, … }");
}

/// Documents of many brackets; the line need not show them all.
void TestBadJson::deepNesting_data() {
  QTest::addColumn<QByteArray>("document");
  const QByteArray open(100000, '[');
  const QByteArray closed = open + QByteArray(100000, ']');
  QTest::newRow("never closed") << open;
  QTest::newRow("as the document") << closed;
  QTest::newRow("as a value") << text({.display = R"({"hogels": )" + closed + "}"});
  QTest::newRow("as the version") << QByteArray(R"({"hogelscope": )" + closed + "}");
  QTest::newRow("as an unknown field") << text({.display = R"({"hogel": )" + closed + "}"});
  QTest::newRow("objects") << QByteArray(R"({"a": )").repeated(100000) + "1" +
                                  QByteArray(100000, '}');
}

void TestBadJson::deepNesting() {
  QFETCH(QByteArray, document);
  writeFile(m_folder.filePath("s.json"), document);
  const Outcome outcome =
      run({"--render", "--session", "s.json", "--output", "out"}, m_folder.path());
  QCOMPARE(outcome.status, 2);
  QVERIFY(outcome.err.startsWith("hogelscope: s.json: "));
  QCOMPARE(outcome.err.count('\n'), 1);
  QVERIFY(outcome.err.size() < 400);
}

QTEST_GUILESS_MAIN(TestBadJson)
#include "test_bad_json.moc"
