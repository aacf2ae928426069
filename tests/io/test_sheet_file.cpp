// SPDX-License-Identifier: BSD-3-Clause
// Calibrations of lens sheets: the vendor's own, what follows from them, and what is not one.
#include "io/documents/sheet_file.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "io/json/json_parameters.h"
#include "io/plugins/display_json.h"
#include "tests/io/documents.h"

using namespace hogelscope;

namespace {

const QString realSheets = HOGELSCOPE_SOURCE_DIR "/../shared/data/real_displays/visual_";

/// A calibration of round figures, with values as newer units have them, and whole ones.
Json sheet() {
  return parseJson(R"({"configVersion": "3.0", "serial": "unit 7", "pitch": {"value": 50.0},
    "slope": {"value": -6.0}, "center": 0.25, "viewCone": {"value": 40.0}, "DPI": 254,
    "screenW": {"value": 3840.0}, "screenH": 2160, "flipImageX": {"value": 0.0}})");
}

Json cell(double green) {
  return {{"ROffsetX", -0.3}, {"ROffsetY", 0.25}, {"GOffsetX", green},
          {"GOffsetY", 0.25}, {"BOffsetX", 0},    {"BOffsetY", -0.25}};
}

}  // namespace

class TestSheetFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void readsFigures();
  void figuresFollow();
  void realUnits_data();
  void realUnits();
  void mistakes_data();
  void mistakes();
  void othersAreNoSheets();
  void flippedSubPixels();
  void unusedKeys_data();
  void unusedKeys();
  void servicesAnswers();
  void bytesAround();
  void warningsOfSessions();

 private:
  void write(const Json& document) {
    writeFile("visual.json", QByteArray::fromStdString(document.dump()));
  }
  QTemporaryDir m_folder;
};

void TestSheetFile::init() {
  QVERIFY(QDir::setCurrent(m_folder.path()));
}

void TestSheetFile::readsFigures() {
  Json document = sheet();
  write(document);
  QVERIFY(isSheetCalibration("visual.json"));
  std::vector<std::string> warnings;
  SheetCalibration read = loadSheetCalibration("visual.json", &warnings);
  QCOMPARE(read.serial, std::string("unit 7"));
  QVERIFY((read.params == SheetParams{50, -6, 0.25, 254, {3840, 2160}, 40}));
  QCOMPARE(read.cells.size(), 1U);
  QCOMPARE(read.cells[0][2][0], 2.0 / 3);
  QVERIFY(warnings.empty());

  document["subpixelCells"] = {cell(0.28), cell(0.3)};
  document["CellPatternMode"] = {{"value", 2.0}};
  document["invView"] = {{"value", 0.0}};
  write(document);
  read = loadSheetCalibration("visual.json", &warnings);
  QCOMPARE(read.cells.size(), 2U);
  QVERIFY((read.cells[1] == SubPixels{{{-0.3, 0.25}, {0.3, 0.25}, {0, -0.25}}}));
  QCOMPARE(read.pattern, 2);
  QCOMPARE(warnings.size(), 1U);
  QVERIFY(warnings[0].starts_with("invView is 0"));
}

/// A lens is 1/50 inch wide, and its section along a row is longer by the slant.
void TestSheetFile::figuresFollow() {
  const LensSheet sheet({.calibration = {.params = {50, -6, 0.25, 254, {3840, 2160}, 40}}});
  QCOMPARE(sheet.pixel(), 1e-4);
  QVERIFY(std::abs(sheet.size()[0] - 0.384) < 1e-12 && std::abs(sheet.size()[1] - 0.216) < 1e-12);
  const double across = std::abs(sheet.period() * std::cos(sheet.slant() / 180 * M_PI));
  QVERIFY(std::abs(across - 0.0254 / 50) < 1e-12);
  QVERIFY(std::abs(std::tan(sheet.slant() / 180 * M_PI) - 1.0 / 6) < 1e-12);
  QVERIFY(std::abs(sheet.lenses() - 0.384 / sheet.period()) < 1e-9);
  // A pixel at the lens's border leaves in the direction of the cone's border.
  QVERIFY(std::abs(sheet.period() / 2 / sheet.gap() - std::tan(20 * M_PI / 180)) < 1e-12);
}

void TestSheetFile::realUnits_data() {
  QTest::addColumn<QString>("unit");
  QTest::addColumn<std::size_t>("cells");
  QTest::addColumn<double>("lenses");  // pitch·W/DPI·cos(atan(1/slope)), as the vendor's shaders
  QTest::newRow("16 inch") << "LKG-J00332" << std::size_t{2} << 600.892;
  QTest::newRow("Portrait") << "LKG-P00655" << std::size_t{1} << 246.909;
  QTest::newRow("first generation") << "00112" << std::size_t{1} << 354.475;
}

void TestSheetFile::realUnits() {
  QFETCH(QString, unit);
  QFETCH(std::size_t, cells);
  QFETCH(double, lenses);
  const QString file = realSheets + unit + ".json";
  if (!QFile::exists(file)) QSKIP("no ../shared/data/real_displays here");
  QVERIFY(isSheetCalibration(file.toStdString()));
  const SheetCalibration read = loadSheetCalibration(file.toStdString());
  QVERIFY(std::abs(LensSheet({.calibration = read}).lenses() - lenses) < 1e-3);
  QCOMPARE(read.cells.size(), cells);
}

void TestSheetFile::mistakes_data() {
  QTest::addColumn<QByteArray>("patch");
  QTest::addColumn<QByteArray>("line");
  const auto row = [](const char* patch, const char* line) {
    QTest::newRow(patch) << QByteArray(patch) << QByteArray("visual.json: ") + line;
  };
  row(R"({"pitch": null})", "pitch: is missing");
  row(R"({"pitch": {"value": "50"}})", "pitch: \"50\" is not a number");
  row(R"({"screenH": {"volume": 50}})", "screenH: has no \"value\"");
  row(R"({"pitch": -1})", "pitch: …");
  row(R"({"pitch": 1e400})", "…");
  row(R"({"slope": {"value": 0}})", "slope: is 0: lenses along the rows; turn the panel by 90°");
  row(R"({"viewCone": 180})", "cone: …");
  row(R"({"screenW": 3840.5})", "screenW: 3840.5 is not a whole number");
  row(R"({"screenH": 0})", "panel[1]: …");
  row(R"({"DPI": 0})", "dpi: …");
  row(R"({"flipImageX": {"value": 1.0}})",
      "flipImageX: is not 0: mirrored panels are not modelled");
  row(R"({"flipImageY": 1})", "flipImageY: is not 0: mirrored panels are not modelled");
  row(R"({"flipImageY": true})", "flipImageY: is not 0: mirrored panels are not modelled");
  row(R"({"subpixelCells": {}})", "subpixelCells: is not a list of kinds of pixels");
  row(R"({"subpixelCells": [3]})",
      "subpixelCells[0]: is not an object with ROffsetX and five others");
  row(R"({"subpixelCells": [{"ROffsetX": 0}]})", "subpixelCells[0].ROffsetY: is missing");
  row(R"({"subpixelCells": [{"ROffsetX": 7, "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0,
      "BOffsetX": 0, "BOffsetY": 0}]})",
      "cells: has a place that is not −1 … 1 px");
  row(R"({"subpixelCells": [{"ROffsetX": "0", "ROffsetY": 0, "GOffsetX": 0, "GOffsetY": 0,
      "BOffsetX": 0, "BOffsetY": 0}]})",
      "cells: has a place that is not −1 … 1 px");
}

void TestSheetFile::mistakes() {
  QFETCH(QByteArray, patch);
  QFETCH(QByteArray, line);
  if (patch.contains("1e400")) {
    QByteArray text = QByteArray::fromStdString(sheet().dump());
    writeFile("visual.json", text.replace("\"value\":50.0", "\"value\":1e400"));
  } else {
    Json document = sheet();
    document.merge_patch(Json::parse(patch.toStdString()));
    write(document);
  }
  const QString error = errorOf([] { (void)loadSheetCalibration("visual.json"); });
  compareLine(error.toUtf8(), line);
}

void TestSheetFile::othersAreNoSheets() {
  for (const char* text : {"", "[1, 2]", "{", "{}", R"({"hogelscope": 1, "cameras": []})",
                           R"({"pitch": 1, "slope": 2, "center": 3})"}) {
    writeFile("other.json", text);
    QVERIFY2(!isSheetCalibration("other.json"), text);
  }
  QVERIFY(!isSheetCalibration("."));
  QVERIFY(!isSheetCalibration("none.json"));
  write(sheet());
  writeFile("large.json", contentOf("visual.json") + QByteArray(2 << 20, ' '));
  QVERIFY(!isSheetCalibration("large.json"));
  compareLine(errorOf([] { (void)loadSheetCalibration("large.json"); }).toUtf8(),
              "large.json: is larger than 1 MiB: not a lens sheet's calibration");
}

/// Colour i is at the place of sub-pixel 2 − i, whatever the cells are.
void TestSheetFile::flippedSubPixels() {
  Json document = sheet();
  document["subpixelCells"] = {cell(0.28), cell(0.3)};
  document["CellPatternMode"] = 2;
  for (const bool hasCells : {false, true}) {
    if (!hasCells) document.erase("subpixelCells");
    document["flipSubp"] = {{"value", 0.0}};
    write(document);
    const SheetCalibration straight = loadSheetCalibration("visual.json");
    for (const Json& flip : {Json{{"value", 1.0}}, Json(1), Json(true)}) {
      document["flipSubp"] = flip;
      write(document);
      std::vector<std::string> warnings;
      const SheetCalibration flipped = loadSheetCalibration("visual.json", &warnings);
      QCOMPARE(flipped.cells.size(), straight.cells.size());
      QCOMPARE(flipped.pattern, straight.pattern);
      for (std::size_t kind = 0; kind < straight.cells.size(); ++kind)
        for (const std::size_t channel : {0, 1, 2})
          QVERIFY(flipped.cells[kind][channel] == straight.cells[kind][2 - channel]);
      // A session that names the file reads the same.
      SheetCalibration named;
      readParts(sheetObject("visual.json"), "", named);
      QVERIFY(named == flipped);
    }
    document["subpixelCells"] = {cell(0.28), cell(0.3)};
  }
}

void TestSheetFile::unusedKeys_data() {
  QTest::addColumn<QByteArray>("patch");
  QTest::addColumn<QByteArray>("line");
  const auto row = [](const char* patch, const char* line) {
    QTest::newRow(patch) << QByteArray(patch) << QByteArray(line);
  };
  row(R"({"fringe": 0, "verticalAngle": {"value": 0.0}, "name": "", "list": [], "a": false})", "");
  row(R"({"fringe": {"value": 0.02}})", "fringe is 0.02, which is not used");
  row(R"({"verticalAngle": -1.5, "shift": [1, 2]})",
      "verticalAngle is -1.5, shift is [1,2], which are not used");
  row(R"({"CellPatternMode": 2})", "CellPatternMode is 2, which is not used");
  row(R"({"a": 1, "b": 1, "c": 1, "d": 1, "e": 1, "f": 1, "g": 1, "h": 1, "i": 1})",
      "a is 1, b is 1, c is 1, d is 1, e is 1, f is 1, g is 1, h is 1 and 1 more keys, which are "
      "not used");
}

void TestSheetFile::unusedKeys() {
  QFETCH(QByteArray, patch);
  QFETCH(QByteArray, line);
  Json document = sheet();
  document.update(Json::parse(patch.toStdString()));
  write(document);
  std::vector<std::string> warnings;
  (void)loadSheetCalibration("visual.json", &warnings);
  QCOMPARE(QByteArray::fromStdString(warnings.empty() ? "" : warnings[0]), line);
  QVERIFY(warnings.size() < 2);
}

/// The vendor's services have calibrations as objects and as texts.
void TestSheetFile::servicesAnswers() {
  Json second = sheet();
  second["serial"] = "unit 8";
  second["pitch"] = 51;
  for (const bool isText : {false, true}) {
    const auto calibration = [&](const Json& one) { return isText ? Json(one.dump()) : one; };
    Json devices = Json::array();
    devices.push_back({{"hwid", "monitor"}, {"calibration", isText ? Json("") : Json::object()}});
    devices.push_back({{"hwid", "a"}, {"calibration", calibration(sheet())}});
    write({{"error", 0}, {"devices", devices}});
    QVERIFY(isSheetCalibration("visual.json"));
    std::vector<std::string> warnings;
    QVERIFY(loadSheetCalibration("visual.json", &warnings).serial == "unit 7");
    QVERIFY(warnings.empty());
    devices.push_back({{"hwid", "b"}, {"calibration", calibration(second)}});
    write({{"error", 0}, {"devices", devices}});
    QCOMPARE(loadSheetCalibration("visual.json", &warnings).params.pitch, 50.0);
    QCOMPARE(warnings.size(), 1U);
    QCOMPARE(QByteArray::fromStdString(warnings[0]),
             QByteArray("has the calibrations of 2 units: that at devices[1].calibration (unit 7) "
                        "is read, not devices[2].calibration (unit 8)"));
  }
}

/// A unit's memory ends in zero bytes, and editors begin files with a byte order mark.
void TestSheetFile::bytesAround() {
  const QByteArray text = QByteArray::fromStdString(sheet().dump());
  writeFile("visual.json", text);
  const SheetCalibration plain = loadSheetCalibration("visual.json");
  for (const QByteArray& other : {text + QByteArray(300, '\0'), "\xEF\xBB\xBF" + text + "\r\n",
                                  "\xEF\xBB\xBF" + text + QByteArray(1, '\0')}) {
    writeFile("visual.json", other);
    QVERIFY(isSheetCalibration("visual.json"));
    QVERIFY(loadSheetCalibration("visual.json") == plain);
  }
}

void TestSheetFile::warningsOfSessions() {
  Json document = sheet();
  document["invView"] = 0;
  document["fringe"] = 0.5;
  write(document);
  Session session;
  QVERIFY(sheetWarnings(session).empty());
  session.display.sheet.emplace();
  session.display.sheet->calibration = loadSheetCalibration("visual.json");
  session.lightField.calibration = session.display.sheet->calibration;
  session.lightField.calibrationFile = "visual.json";
  const std::string order = "invView is 0, which is ignored: views go from left to right";
  QVERIFY((sheetWarnings(session) ==
           std::vector<std::string>{"display.calibration: " + order,
                                    "lightField.calibration: fringe is 0.5, which is not used",
                                    "lightField.calibration: " + order}));
}

QTEST_GUILESS_MAIN(TestSheetFile)
#include "test_sheet_file.moc"
