// SPDX-License-Identifier: BSD-3-Clause
// Tests camera set documents and traces: what they say, and the line for each mistake.
#include <QTemporaryDir>
#include <QTest>

#include "core/panel/display.h"
#include "io/documents/camera_set_file.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

QByteArray document(const QByteArray& rest) {
  return R"({"hogelscopeCameras": 1)" + rest + "}";
}

QByteArray twice(QByteArray element, int count) {
  QByteArray list = element;
  for (int k = 1; k < count; ++k) list += "," + element;
  return list;
}

template <class Source>
Source sourceIn(const CameraSet& set) {
  const Source* source = std::get_if<Source>(&set.source);
  return source != nullptr ? *source : Source{};
}

}  // namespace

class TestCameraSetFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { QVERIFY(QDir::setCurrent(m_folder.path())); }
  void distributionsByName();
  void settingsOfADocument();
  void overridesReachEveryPart();
  void mixture();
  void poses();
  void path();
  void traces_data();
  void traces();
  void longClocks();
  void guessesAreTold();
  void namedColumns();
  void recordings();
  void viewIndices();
  void unitsByOverrides();
  void badColumns_data();
  void badColumns();
  void badDocuments_data();
  void badDocuments();
  void badTraces_data();
  void badTraces();
  void badOverrides();

 private:
  QTemporaryDir m_folder;
};

void TestCameraSetFile::distributionsByName() {
  QCOMPARE(loadCameraSet("uniform").region.distribution, CameraSpread::uniform);
  QCOMPARE(loadCameraSet("random").region.distribution, CameraSpread::random);
  const CameraSet set = loadCameraSet(
      "normal", {"cameraSet.count=7", "cameraSet.name=a b", "cameraRegion.angle=[1,2]"});
  QCOMPARE(set.region.distribution, CameraSpread::normal);
  QCOMPARE(set.params.count, 7);
  QCOMPARE(set.params.name, std::string("a b"));
  QCOMPARE(set.region.angle, (std::array<double, 2>{1, 2}));
}

void TestCameraSetFile::settingsOfADocument() {
  writeFile("c.json", document(R"(,
    "cameraSet": {"count": 12, "seed": 9, "template": "Fig 4", "name": "ring", "keepTemplate": false,
      "place": 0.5},
    "cameraRegion": {"distribution": "random", "region": "arc", "centre": [1, 2, 3],
      "extent": [4, 5, 5.5], "distance": [0.5, 1], "angle": [-10, 20], "elevation": [-1, 1],
      "deviation": 0.5, "lookat": "jittered", "target": [0.1, 0.2, -0.3], "jitter": 0.25})"));
  const CameraSet set = loadCameraSet("c.json");
  QVERIFY((set.params == CameraSetParams{12, 9, "ring", "Fig 4", false, 0.5}));
  QVERIFY((set.region == CameraRegionParams{CameraSpread::random,
                                            RegionShape::arc,
                                            {1, 2, 3},
                                            {4, 5, 5.5},
                                            {0.5, 1},
                                            {-10, 20},
                                            {-1, 1},
                                            0.5,
                                            LookAt::jittered,
                                            {0.1, 0.2, -0.3},
                                            0.25}));
  QCOMPARE(set.source.index(), std::size_t(0));
}

void TestCameraSetFile::overridesReachEveryPart() {
  writeFile("c.json", document(R"(, "mixture": [{"cameraRegion": {"jitter": 1}}, {}])"));
  const CameraSet set = loadCameraSet("c.json", {"cameraRegion.jitter=2", "cameraSet.seed=3"});
  const auto found = sourceIn<Mixture>(set);
  QCOMPARE(found.parts.size(), std::size_t(2));
  for (const Mixture::Part& part : found.parts) QCOMPARE(part.region.jitter, 2.0);
  QCOMPARE(set.params.seed, 3);
}

void TestCameraSetFile::mixture() {
  writeFile("c.json", document(R"(, "cameraRegion": {"region": "arc", "jitter": 0.5},
    "mixture": [{"weight": 2.5, "cameraRegion": {"jitter": 1}}, {"weight": 0}, {}])"));
  const auto found = sourceIn<Mixture>(loadCameraSet("c.json"));
  QCOMPARE(found.parts.size(), std::size_t(3));
  QCOMPARE(found.parts[0].weight, 2.5);
  QCOMPARE(found.parts[1].weight, 0.0);
  QCOMPARE(found.parts[2].weight, 1.0);
  QCOMPARE(found.parts[0].region.jitter, 1.0);
  QCOMPARE(found.parts[2].region.jitter, 0.5);
  QVERIFY(found.parts[0].region.region == RegionShape::arc);
}

void TestCameraSetFile::poses() {
  writeFile("c.json", document(R"(, "poses": [{"eye": [1, 2, 3]},
    {"eye": [0, 0, 1], "lookat": [0.1, 0, -1], "weight": 4}])"));
  const auto found = sourceIn<PoseList>(loadCameraSet("c.json"));
  QCOMPARE(found.poses.size(), std::size_t(2));
  QVERIFY((found.poses[0].eye == Vec3{1, 2, 3}) && !found.poses[0].hasLookat());
  QVERIFY((found.poses[1].lookat == Vec3{0.1, 0, -1}));
  QCOMPARE(found.poses[1].weight, 4.0);
}

void TestCameraSetFile::path() {
  writeFile("c.json", document(R"(, "path": [{"eye": [1, 2, 3]}, {"eye": [0, 0, 1]}])"));
  QCOMPARE(sourceIn<PosePath>(loadCameraSet("c.json")).poses.size(), std::size_t(2));
}

void TestCameraSetFile::traces_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<double>("z");
  QTest::newRow("with names") << QByteArray("time,x,y,z\n0,1,2,3\n0.5,-1,-2,3\n") << 3.0;
  QTest::newRow("without") << QByteArray("0,1,2,3\n0.5,-1,-2,3") << 3.0;
  QTest::newRow("no distance") << QByteArray("time,x,y\n0,1,2\n0.5,-1,-2\n") << 0.75;
  QTest::newRow("another order, more columns")
      << QByteArray("z,y,\"who, where\",x,time\n3,2,a,1,7\n3,-2,\"b, c\",-1,7.5\n") << 3.0;
  QTest::newRow("a spreadsheet's") << QByteArray(
                                          "\xEF\xBB\xBFtime, x, y\r\n0, 1, 2\r\n\r\n"
                                          "5e-1, -1, -2\r\n\r\n")
                                   << 0.75;
  const auto row = [](const char* name, const QByteArray& text) {
    QTest::newRow(name) << text << 3.0;
  };
  row("semicolons", "time;x;y;z\n0;1;2;3\n0.5;-1;-2;3\n");
  row("semicolons and decimal commas", "Zeit;x;y;z\n0,0;1,00;2;3\n0,5;-1,0;-2,0;3,0\n");
  row("decimal commas without names", "0,0;1,00;2;3\r\n0,5;-1,0;-2,0;3,0\r\n");
  row("tabs", "time\tx\ty\tz\n0\t1\t2\t3\n0.5\t-1\t-2\t3\n");
  row("tabs and decimal commas", "time\tx\ty\tz\n0,0\t1,0\t2,0\t3\n0,5\t-1\t-2\t3,0\n");
  row("tabs, an empty last cell", "time\tx\ty\tz\tnote\n0\t1\t2\t3\ta\n0.5\t-1\t-2\t3\t\n");
  row("commas and tabs", "time,\tx,\ty,\tz\n0,\t1,\t2,\t3\n0.5,\t-1,\t-2,\t3\n");
  row("sep=,", "sep=,\ntime,x,y,z\n0,1,2,3\n0.5,-1,-2,3\n");
  row("sep=;", "\xEF\xBB\xBFSEP=;\r\ntime;x;y;z\r\n0;1;2;3\r\n0,5;-1;-2;3\r\n");
  row("sep=|", "sep=|\ntime|x|y|z\n0|1|2|3\n0.5|-1|-2|3\n");
  row("a semicolon in a name", "a;b,time,x,y,z\n7;8,0,1,2,3\n9,0.5,-1,-2,3\n");
  row("TUM",
      "# ground truth\n# timestamp tx ty tz qx qy qz qw\n"
      "1700000000.25 1 2 3 0 0 0 1\n1700000000.75 -1 -2  3 0.6 0 0 0.8\n");
  row("TUM without a comment", "0 1 2 3 0 0 0 1\n0.5 -1 -2 3 0 0 0.6 -0.8\n");
  row("comments between", "0,1,2,3\n# here, it, was, lost\n0.5,-1,-2,3\n");
  row("EuRoC",
      "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w []\n"
      "1403636579758555392,1,2,3,1\n1403636580258555392,-1,-2,3,1\n");
  row("EuRoC without names",
      "1403636579758555392,1,2,3,1,0,0,0\n"
      "1403636580258555392,-1,-2,3,0,0,0,1\n");
  row("units in names", "t (ms);x [mm];pos_y_cm;position_z [m]\n0;1000;200;3\n500;-1000;-200;3\n");
  row("words in names", "Time (s),Head X (m),Head Y (m),Head Z (m)\n0,1,2,3\n0.5,-1,-2,3\n");
  row("milliseconds since 1970", "1518516389517,1,2,3\n1518516390017,-1,-2,3\n");
}

void TestCameraSetFile::traces() {
  QFETCH(const QByteArray, text);
  QFETCH(const double, z);
  writeFile("t.csv", text);
  const auto found = sourceIn<Trace>(loadCameraSet("t.csv", {"cameraRegion.centre=[0,0,0.75]"}));
  QCOMPARE(found.points.size(), std::size_t(2));
  QCOMPARE(found.points[0].time, 0.0);
  QVERIFY((found.points[0].eye == Vec3{1, 2, z}));
  QCOMPARE(found.points[1].time, 0.5);
  QVERIFY((found.points[1].eye == Vec3{-1, -2, z}));
}

/// A clock of 19 digits has steps that a double of its numbers has not.
void TestCameraSetFile::longClocks() {
  QByteArray text = "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m]\n";
  for (int k = 0; k <= 1000; ++k)
    text += QByteArray::number(1700000000000000001LL + 1001LL * k) + ",0,0,1\n";
  writeFile("t.csv", text);
  const auto found = sourceIn<Trace>(loadCameraSet("t.csv"));
  for (std::size_t k = 0; k <= 1000; ++k)
    QVERIFY(std::abs(found.points[k].time - 1.001e-6 * double(k)) < 1e-15);
}

void TestCameraSetFile::guessesAreTold() {
  const auto notes = [](const QByteArray& text) {
    writeFile("t.txt", text);
    const std::vector<std::string> all = loadCameraSet("t.txt").notes;
    return QByteArray::fromStdString(all.empty() ? "" : all.back());
  };
  QCOMPARE(notes("time,x,y\n0,0,0\n1,0,0\n"), QByteArray());
  QCOMPARE(
      notes("0 1 2 3 0 0 0 1\n1 1 2 3 0 0 0 1\n"),
      QByteArray("is read with time, x, y, z of lines with an orientation, which is not used"));
  QCOMPARE(notes("# timestamp tx ty tz qx qy qz qw\n0 0 0 1 0 0 0 1\n1 0 0 1 0 0 0 1\n"),
           QByteArray("is read with timestamp as time, tx as x, ty as y, tz as z; its orientations "
                      "are not used"));
  QCOMPARE(notes("Zeit;x [mm];y\n0;0;0\n1;0;0\n"),
           QByteArray("is read with Zeit as time, x [mm] as x in mm"));
  QCOMPARE(notes("1518516389517,1,2,3\n1518516390017,-1,-2,3\n"),
           QByteArray("says no unit of time: \"1518516389517\" is taken for one of 0.001 s since "
                      "1970; trace.timeUnit says another"));
}

/// The form of mmspg/lightfieldvrtb: a line at each change of view; a time in ms since 1970.
constexpr const char* tracks =
    "Stimulus,Timestamp,x,y\nI10,1518516389517,0,2\nI10,1518516389717,0,3\n"
    "I10,1518516390517,8,3\nI01,1518516400000,4,4\nI01,1518516400500,4,5\n";

/// A document of those tracks, with more settings.
QByteArray tracksDocument(const QByteArray& more) {
  return document(R"(, "cameraRegion": {"centre": [0, 0, 0.5]}, "trace": {"file": "t.csv",
    "time": "Timestamp", "timeUnit": 0.001, "origin": [4, 4, 0], "scale": [-0.02, 0.01, 1])" +
                  more + "}");
}

void TestCameraSetFile::namedColumns() {
  writeFile("where/t.csv", tracks);
  writeFile("where/c.json",
            tracksDocument(R"(, "recording": "Stimulus", "only": "I10", "holds": true)"));
  const auto found = sourceIn<Trace>(loadCameraSet("where/c.json"));
  QVERIFY(found.holds);
  QCOMPARE(found.points.size(), std::size_t(3));
  const std::array<double, 3> times{0, 0.2, 1};
  const std::array<Vec3, 3> eyes{Vec3{0.08, -0.02, 0.5}, {0.08, -0.01, 0.5}, {-0.08, -0.01, 0.5}};
  for (std::size_t k = 0; k < 3; ++k) {
    QVERIFY(std::abs(found.points[k].time - times[k]) < 1e-6);
    QVERIFY(length(found.points[k].eye - eyes[k]) < 1e-15);
  }
}

/// The ten seconds between the two do not count.
void TestCameraSetFile::recordings() {
  writeFile("t.csv", tracks);
  writeFile("c.json", tracksDocument(R"(, "recording": "Stimulus")"));
  const auto found = sourceIn<Trace>(loadCameraSet("c.json"));
  QCOMPARE(found.points.size(), std::size_t(5));
  QCOMPARE(found.points[3].time, found.points[2].time);
  QVERIFY(std::abs(found.points[4].time - 1.5) < 1e-6);
  const auto all = sourceIn<Trace>(loadCameraSet("c.json", {"trace.recording="}));
  QVERIFY(std::abs(all.points[4].time - 10.983) < 1e-6);
  const auto one = sourceIn<Trace>(loadCameraSet("c.json", {"trace.only=I01"}));
  QCOMPARE(one.points.size(), std::size_t(2));
}

/// An eye at the place of view (u, v) has the direction (u, v) at every point of the panel.
void TestCameraSetFile::viewIndices() {
  PanelParams params;
  params.hogels = {50, 40};
  params.directions = {9, 7};
  params.fov = {40, 30};
  params.viewingDistance = 0.8;
  const Display display(params);
  const auto step = [&](std::size_t axis) {  // docs/formulas.md, Viewers' traces.
    return 2 * 0.8 * std::tan(radians(params.fov[axis]) / 2) / params.directions[axis];
  };
  writeFile("t.csv", "time,x,y\n0,0,0\n1,8,0\n2,3,5\n3,4,3\n");
  const auto found = sourceIn<Trace>(loadCameraSet(
      "t.csv",
      {"cameraRegion.centre=[0,0,0.8]", "trace.origin=[4,3,0]",
       "trace.scale=[" + std::to_string(step(0)) + "," + std::to_string(-step(1)) + ",1]"}));
  const std::array<Vec2, 4> views{Vec2{0, 0}, {8, 0}, {3, 5}, {4, 3}};
  for (std::size_t k = 0; k < views.size(); ++k) {
    for (const Vec3& place : {Vec3{0, 0, 0}, Vec3{0.2, -0.24, 0}}) {
      const Vec3& eye = found.points[k].eye;
      const std::optional<Hit> hit = display.hit(eye, place - eye);
      QVERIFY(hit.has_value());
      QVERIFY(std::abs(hit->u - (views[k].x + 0.5)) < 1e-3);
      QVERIFY(std::abs(hit->v - (views[k].y + 0.5)) < 1e-3);
    }
  }
}

void TestCameraSetFile::unitsByOverrides() {
  writeFile("t.csv", "100,5,6,700\n350,-5,6,700\n");  // ms and mm
  const auto found = sourceIn<Trace>(
      loadCameraSet("t.csv", {"trace.timeUnit=0.001", "trace.scale=[0.001,0.001,0.001]"}));
  QCOMPARE(found.points[1].time, 0.25);
  QVERIFY(length(found.points[1].eye - Vec3{-0.005, 0.006, 0.7}) < 1e-15);
}

void TestCameraSetFile::badColumns_data() {
  QTest::addColumn<QByteArray>("more");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* name, const QByteArray& more, const char* line) {
    QTest::newRow(name) << more << QString(line);
  };
  const char* names = ": \"Stimulus,Timestamp,x,y\"";
  row("no such column", R"(, "x": "view")",
      (QByteArray("t.csv: line 1: has no column \"view\", which is the trace's x") + names));
  row("no such depth", R"(, "z": "depth")",
      (QByteArray("t.csv: line 1: has no column \"depth\", which is the trace's z") + names));
  row("no such recordings", R"(, "recording": "trial")",
      (QByteArray("t.csv: line 1: has no column \"trial\", which is the trace's recording") +
       names));
  row("no such recording", R"(, "recording": "Stimulus", "only": "I3")",
      "t.csv: has no line whose Stimulus is \"I3\"");
  row("of what", R"(, "only": "I10")",
      "c.json: trace.only: needs trace.recording, the column that says which one it is");
  row("alone", R"(, "recording": "Timestamp")",
      "t.csv: has no two lines of one recording: no time passes");
  row("unknown", R"(, "column": "x")",
      "c.json: trace.column: is not known here; known are file, time, x, y, z, recording, only, "
      "timeUnit, origin, scale, holds");
  row("far", R"(, "y": "Timestamp")",
      "t.csv: line 2: y \"1518516389517\" is not a number from -1e12 to 1e12");
  row("two sources", R"(}, "path": {)",
      "c.json: trace: is the second source of states: give one of mixture, poses, path, trace");
}

void TestCameraSetFile::badColumns() {
  QFETCH(const QByteArray, more);
  QFETCH(const QString, line);
  writeFile("t.csv", tracks);
  writeFile("c.json", tracksDocument(more));
  QCOMPARE(errorOf([] { (void)loadCameraSet("c.json"); }), line);
}

void TestCameraSetFile::badDocuments_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* name, const QByteArray& text, const char* line) {
    QTest::newRow(name) << text << QString("c.json: ") + line;
  };
  const QByteArray pose = R"({"eye": [0, 0, 1]})";
  row("empty", " \n", "is empty: not a camera set");
  row("truncated", R"({"hogelscopeCameras": 1, "poses": [{"eye": [0, )",
      "is not JSON: line 1, column 48: …");
  row("a list", "[1]", "[1] is not an object: { \"name\": value, … }");
  row("a session", text(),
      "hogelscopeCameras: is missing: a camera set says \"hogelscopeCameras\": 1");
  row("a later version", R"({"hogelscopeCameras": 2})",
      "hogelscopeCameras: 2 is not a version that this program reads: 1");
  row("unknown key", document(R"(, "pose": [])"),
      "pose: is not known here; did you mean \"poses\"?");
  row("unknown setting", document(R"(, "cameraSet": {"cuont": 3})"),
      "cameraSet.cuont: is not known here; did you mean \"count\"?");
  row("no states", document(R"(, "cameraSet": {"count": 0})"),
      "cameraSet.count: 0 is out of range: 1 to 1e+05");
  row("huge count", document(R"(, "cameraSet": {"count": 1e300})"),
      "cameraSet.count: 1e+300 is out of range: 1 to 1e+05");
  row("half a state", document(R"(, "cameraSet": {"count": 1.5})"),
      "cameraSet.count: 1.5 is not a whole number");
  row("not a number", document(R"(, "cameraRegion": {"jitter": "NaN"})"),
      "cameraRegion.jitter: \"NaN\" is not a number");
  row("distribution", document(R"(, "cameraRegion": {"distribution": "gauss"})"),
      "cameraRegion.distribution: \"gauss\" is not one of uniform, random, normal");
  row("behind the panel", document(R"(, "cameraRegion": {"centre": [0, 0, -1]})"),
      "cameraRegion.centre: brings the region to the panel or behind it: its z must be above 0, "
      "and above half the depth of a box");
  row("reversed", document(R"(, "cameraRegion": {"distance": [2, 1]})"),
      "cameraRegion.distance: ends before it begins: give [least, most]");
  row("two sources", document(R"(, "poses": [)" + pose + R"(], "path": [)" + pose + "]"),
      "path: is the second source of states: give one of mixture, poses, path, trace");
  row("no trace's file", document(R"(, "trace": {"time": "t"})"),
      "trace.file: is missing: the CSV file's name");
  row("trace of a document", document(R"(, "trace": {"file": "c.json"})"),
      "trace.file: \"c.json\" is a document, not a CSV file");
  row("no list", document(R"(, "poses": {})"), "poses: is not a list: [ { … }, … ]");
  row("no poses", document(R"(, "poses": [])"), "poses: has 0 elements; allowed are 1 to 100000");
  row("too many poses", document(R"(, "poses": [)" + twice("0", 100001) + "]"),
      "poses: has 100001 elements; allowed are 1 to 100000");
  row("one key pose", document(R"(, "path": [)" + pose + "]"),
      "path: has 1 elements; allowed are 2 to 100000");
  row("no eye", document(R"(, "poses": [{}])"), "poses[0].eye: is missing: [x, y, z] in metres");
  row("eye in the panel", document(R"(, "poses": [{"eye": [0, 0, 0]}])"),
      "poses[0].eye[2]: is not in front of the panel: z is above 0");
  row("weight below 0", document(R"(, "poses": [{"eye": [0, 0, 1], "weight": -1}])"),
      "poses[0].weight: -1 is out of range: 0 to 1e+06");
  row("look-at sometimes",
      document(R"(, "path": [)" + pose + R"(, {"eye": [1, 0, 1], "lookat": [0, 0, 0]}])"),
      "path[1].lookat: is given, but path[0] has none; either all key poses have it or none");
  row("look-at not always",
      document(R"(, "path": [{"eye": [1, 0, 1], "lookat": [0, 0, 0]}, )" + pose + "]"),
      "path[1].lookat: is missing: path[0] has one; either all key poses have it or none");
  row("no weight at all", document(R"(, "mixture": [{"weight": 0}])"),
      "mixture: has no part with a weight above 0");
  row("part's weight", document(R"(, "mixture": [{}, {"weight": "a"}])"),
      "mixture[1].weight: \"a\" is not a number");
  row("part's region", document(R"(, "mixture": [{"cameraRegion": {"angle": [3, 2]}}])"),
      "mixture[0].cameraRegion.angle: ends before it begins: give [least, most]");
  row("part's count", document(R"(, "mixture": [{"count": 3}])"),
      "mixture[0].count: is not known here; known are weight, cameraRegion");
}

void TestCameraSetFile::badDocuments() {
  QFETCH(const QByteArray, text);
  QFETCH(const QString, line);
  writeFile("c.json", text);
  compareLine(errorOf([] { (void)loadCameraSet("c.json"); }).toUtf8(), line.toUtf8());
}

void TestCameraSetFile::badTraces_data() {
  QTest::addColumn<QByteArray>("text");
  QTest::addColumn<QString>("line");
  const auto row = [](const char* name, const QByteArray& text, const char* line) {
    QTest::newRow(name) << text << QString("t.csv: ") + line;
  };
  const char* few = " point(s): a trace has two at least, lines of time, x, y[, z]";
  row("empty", "", (QByteArray("has 0") + few).constData());
  row("names only", "time,x,y\n", (QByteArray("has 0") + few).constData());
  row("one point", "0,0,0\n", (QByteArray("has 1") + few).constData());
  const auto notATrace = [](const char* shown) {
    return QByteArray("line 1: \"") + shown +
           "\" is not time, x, y or time, x, y, z; \"trace\" in a camera set names other columns";
  };
  row("other names", "u,x,y\n", notATrace("u,x,y"));
  row("two columns", "0,1\n", notATrace("0,1"));
  row("other names between semicolons", "u;x;y\n",
      "line 1: \"u;x;y\", separated by semicolons, is not time, x, y or time, x, y, z; \"trace\" "
      "in "
      "a camera set names other columns");
  row("no orientation", "0 1 2 3 0 0 0 2\n",
      "line 1: \"0 1 2 3 0 0 0 2\", separated by spaces, is not time, x, y or time, x, y, z; "
      "\"trace\" in a camera set names other columns");
  row("an unknown unit", "time [h],x,y\n", notATrace("time [h],x,y"));
  row("two commas", "0;1;2\n1;1,000,2;2\n",
      "line 2: x \"1,000,2\" is not a number from -1e12 to 1e12");
  row("a long clock that stands", "1403636579758555392,0,0\n1403636579758555392,0,0\n",
      "line 2: time \"1403636579758555392\" is not after that of the line before");
  row("five columns", "0,0,0,1,7\n", notATrace("0,0,0,1,7"));
  row("truncated", "time,x,y,z\n0,0,0,1\n1,0,0", "line 3: has 3 cells, the first line has 4");
  row("no number", "time,x,y\n0,0,a\n", "line 2: y \"a\" is not a number from -1e12 to 1e12");
  row("NaN", "0,0,0\nnan,0,0\n", "line 2: time \"nan\" is not a number from -1e20 to 1e20");
  row("infinite", "0,0,0\n1,-inf,0\n", "line 2: x \"-inf\" is not a number from -1e12 to 1e12");
  row("empty cell", "0,0,0\n1,,0\n", "line 2: x \"\" is not a number from -1e12 to 1e12");
  row("far", "0,0,0\n1,0,10001\n", "line 2: y \"10001\" is farther than 10000 m");
  row("behind", "0,0,0,1\n1,0,0,-0.5\n",
      "line 2: z \"-0.5\" is not above 0, in front of the panel");
  row("back in time", "1,0,0\n\n0.5,0,0\n",
      "line 3: time \"0.5\" is not after that of the line before");
  row("the same time", "1,0,0\n1,0,0\n", "line 2: time \"1\" is not after that of the line before");
  row("binary", QByteArray("\x89PNG\r\n\x1a\n\0\0", 10), notATrace("?PNG"));
}

void TestCameraSetFile::badTraces() {
  QFETCH(const QByteArray, text);
  QFETCH(const QString, line);
  writeFile("t.csv", text);
  QCOMPARE(errorOf([] { (void)loadCameraSet("t.csv"); }), line);
}

void TestCameraSetFile::badOverrides() {
  const auto refusal = [](const char* what, const char* override) {
    return errorOf([&] { (void)loadCameraSet(what, {override}); });
  };
  QCOMPARE(refusal("uniform", "cameraSet.count=lots"),
           QString("camera set: cameraSet.count: \"lots\" is not a number"));
  QCOMPARE(refusal("uniform", "psf.sigma=1"),
           QString("camera set: override psf.sigma=1: there is no section \"psf\" in a camera "
                   "set: cameraSet, cameraRegion, trace"));
  QCOMPARE(refusal("grid", "cameraSet.count=1"),
           QString("camera set: \"grid\" is not one of uniform, random, normal, nor a file"));
  QVERIFY(refusal("none.json", "cameraSet.count=1").startsWith("none.json: cannot be read: "));
  QVERIFY(refusal("none.csv", "cameraSet.count=1").startsWith("none.csv: cannot be read: "));
}

QTEST_APPLESS_MAIN(TestCameraSetFile)
#include "test_camera_set_file.moc"
