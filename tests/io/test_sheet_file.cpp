// SPDX-License-Identifier: BSD-3-Clause
// Calibrations of lens sheets: the vendor's own, what follows from them, and what is not one.
#include "io/documents/sheet_file.h"

#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "io/json/json_parameters.h"
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

QTEST_GUILESS_MAIN(TestSheetFile)
#include "test_sheet_file.moc"
